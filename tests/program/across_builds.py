#!/usr/bin/python3
"""Holds two builds of the program against each other: a smooth elastic motion of 200 steps ends in the same state.

    tests/program/across_builds.py build/release/bin/talus build/other/bin/talus

Compilers and build types round differently: bits are promised for one program only, across programs 1e-12 of the largest
value of each field.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

from talus_process import study

STEPS, BAR = 200, 1e-12


def block():
    """An elastic block that is stretched and turned at first, free of walls."""
    case = study("sliding_box")["base"]
    case["walls"] = []
    case["gravity"] = {"magnitude": 0}
    case["transfer"] = {"type": "apic"}
    case["time"]["end"] = 0.05
    case["bodies"][0]["velocity"] = {"type": "linear", "gradient": [[2.0, 1.0], [-3.0, -1.0]]}
    case["output"] = {}
    return case


def end_of(program, case, folder):
    """Fields of the last checkpoint, by name."""
    import h5py

    folder.mkdir()
    path = folder / "case.json"
    path.write_text(json.dumps(case), encoding="utf-8")
    subprocess.run([program, "run", path, "-o", folder / "run", "-q", "--no-pictures", "-t", "1"], check=True,
                   stdout=subprocess.DEVNULL)
    with h5py.File(max((folder / "run/checkpoints").glob("*.h5"))) as file:
        steps = int(json.loads((folder / "run/summary.json").read_text(encoding="utf-8"))["steps"])
        order = file["particles/id"][...].argsort(axis=None)
        return steps, {name: data[...][order] for name, data in file["particles"].items()}


class Builds(unittest.TestCase):
    programs = ()

    def test_they_end_in_the_same_state(self):
        with tempfile.TemporaryDirectory(prefix="talus_") as holder:
            ends = [end_of(program, block(), pathlib.Path(holder) / str(k)) for k, program in enumerate(self.programs)]
        (steps, one), (other_steps, other) = ends
        self.assertEqual(steps, other_steps)
        self.assertGreaterEqual(steps, STEPS)
        self.assertEqual(one.keys(), other.keys())
        for name, values in one.items():
            size = abs(values).max()
            off = abs(values - other[name]).max() / size if size > 0 else abs(other[name]).max()
            print(f"{name:30} {off:.2e}")
            self.assertLessEqual(off, BAR, name)


if __name__ == "__main__":
    Builds.programs = [pathlib.Path(name).resolve() for name in sys.argv[1:3]]
    unittest.main(argv=sys.argv[:1])
