"""Runs the program as a user does: as a process, on documents in folders of its own. Imported by the tests beside it."""
import copy
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("TALUS_SOURCE_DIR", pathlib.Path(__file__).resolve().parents[2]))
PROGRAM = pathlib.Path(os.environ.get("TALUS_PROGRAM", SOURCE / "build/release/bin/talus"))
STUDIES = SOURCE / "verification/studies"


def talus(*arguments, folder=None, **environment):
    """The finished process, its output as text."""
    return subprocess.run([PROGRAM, *map(str, arguments)], cwd=folder, env={**os.environ, **environment},
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60)


def study(name):
    """One of our documents, as an object of its own."""
    return json.loads((STUDIES / f"{name}.json").read_text(encoding="utf-8"))


def coarse_dam(**members):
    """The dam break of 420 particles and 0.1 s, which expects nothing; further members replace those of the case."""
    case = study("dam_break_22")
    case["grid"]["spacing"] = 0.02
    case["time"]["end"] = 0.1
    case["output"] = {"frames_every": 0.02, "series_every": 0.002, "checkpoints_every": 0.02}
    case["expect"] = []
    case.update(copy.deepcopy(members))
    return case


def dam_with_a_station(**members):
    """The dam break with a station in its way, so that there are profiles."""
    case = coarse_dam(**members)
    case["output"]["stations"] = [{"name": "toe", "min": [0.15, 0.0], "max": [0.3, 0.2]}]
    case["output"]["profiles_every"] = 0.007
    return case


def changed(pointer, value, case=None):
    """The case, coarse_dam() if none is given, with the member at the pointer replaced or added."""
    case = coarse_dam() if case is None else case
    target, last = place_of(pointer, case)
    target[last] = value
    return case


def without(pointer):
    """coarse_dam() without the member at the pointer."""
    case = coarse_dam()
    target, last = place_of(pointer, case)
    del target[last]
    return case


def place_of(pointer, target):
    """Object or list in which the member at a pointer lies, and its name or index there."""
    *parents, last = [int(part) if part.isdigit() else part for part in pointer.strip("/").split("/")]
    for part in parents:
        target = target[part]
    return target, last


class InFolder(unittest.TestCase):
    """Gives each test an empty folder, removed after it."""

    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="talus_")
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def save(self, document, name="case.json"):
        """Writes an object as JSON, text as UTF-8, bytes as they are."""
        path = self.folder / name
        if isinstance(document, bytes):
            path.write_bytes(document)
        else:
            path.write_text(document if isinstance(document, str) else json.dumps(document, indent=2), encoding="utf-8")
        return path

    def talus(self, *arguments, code=0, **environment):
        """Runs the program in the folder and demands its exit code."""
        process = talus(*arguments, folder=self.folder, **environment)
        self.assertEqual(process.returncode, code,
                         f"talus {' '.join(map(str, arguments))}\n{process.stdout}{process.stderr}")
        return process

    def run_quietly(self, path, folder, *arguments, code=0, threads=1):
        return self.talus("run", path, "-o", folder, "-q", "--no-pictures", "-t", threads, *arguments, code=code)

    def read(self, *parts):
        return json.loads(self.folder.joinpath(*parts).read_text(encoding="utf-8"))

    def hash_of(self, folder):
        """The state at the end of a run that has come to its end."""
        summary = self.read(folder, "summary.json")
        self.assertTrue(summary["finished"])
        self.assertEqual(self.read(folder, "status.json")["status"], "done")
        return summary["state_hash"]

    def same_files(self, one, other):
        """Two runs wrote the same series, frames, profiles and last checkpoint."""
        for name in ("series.csv", "frames.pvd"):
            self.assertEqual((self.folder / one / name).read_bytes(), (self.folder / other / name).read_bytes(), name)
        for below in ("frames", "profiles"):
            files = sorted(p.name for p in (self.folder / one / below).iterdir())
            self.assertNotEqual(files, [])
            self.assertEqual(files, sorted(p.name for p in (self.folder / other / below).iterdir()))
            for name in files:
                self.assertEqual((self.folder / one / below / name).read_bytes(),
                                 (self.folder / other / below / name).read_bytes(), name)
        last, other_last = (max((self.folder / run / "checkpoints").iterdir()) for run in (one, other))
        self.assertEqual(last.name, other_last.name)
        self.assertEqual(last.read_bytes(), other_last.read_bytes(), last.name)
