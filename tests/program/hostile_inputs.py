#!/usr/bin/python3
"""Hostile inputs, a table of them in hostile/*.json: the program ends in time, not by a signal, with the right exit code,
says what was wrong, and writes no number that is not finite.

With --page FILE the table of what happened is written there:
python3 tests/program/hostile_inputs.py --page docs/hostile.md
With numbers or patterns of rows, only those are done.
"""
import argparse
import json
import pathlib
import sys
import tempfile
import unittest

import hostile_rows
from output_files import not_finite
from talus_process import SOURCE, talus

PATIENCE = 10  # seconds that a row may take
REFUSED = (2, 3, 8)  # exit codes of what is refused before anything is written


def faults(row, folder):
    """What is wrong with what the program did to the row, and what it did."""
    if "test" in row:
        passed, said = hostile_rows.unit_test(row["test"])
        return ([] if passed else [said]), "passed"
    hostile_rows.prepare(row, folder)
    before = not_finite(folder)
    outcome = hostile_rows.run(row, folder, PATIENCE)
    wrong = []
    if outcome.code is None:
        wrong.append(f"not ended after {PATIENCE} s")
    elif outcome.code < 0:
        wrong.append(f"killed by signal {-outcome.code}")
    elif outcome.code != row.get("exit", 0):
        wrong.append(f"exit code {outcome.code}, expected {row.get('exit', 0)}")
    wrong += [f"does not say {text!r}" for text in row.get("says", ()) if text not in outcome.said]
    wrong += [f"says {text[:40]!r}" for text in row.get("hides", ()) if text in outcome.said]
    wrong += [f"not finite: {place}" for place in not_finite(folder) if place not in before]
    wrong += folder_faults(row, folder)
    wrong += bound_faults(row, folder)
    if "then" in row:
        after = talus(*row["then"], folder=folder)
        if after.returncode != 0:
            wrong.append(f"then: talus {' '.join(row['then'])}: exit code {after.returncode}: {after.stderr}")
    return ([*wrong[:10], outcome.said[-2000:]] if wrong else []), happened(row, outcome)


def folder_faults(row, folder):
    """A row that was refused leaves no new folder; one that failed says so in its folder and keeps its last state."""
    out = folder / "out"
    if row.get("exit", 0) in REFUSED and "before" not in row and out.exists():
        return ["a refused run left a folder"]
    if row.get("exit", 0) != 4 or "point" == row.get("document"):
        return []
    if "memory" in row.get("limits", ()) and not out.exists():
        return []  # it ended before anything was begun
    status = json.loads((out / "status.json").read_text(encoding="utf-8"))["status"] if out.exists() else "missing"
    return ([] if status == "failed" else [f"status {status}"]) + (
        [] if list(out.glob("checkpoints/*.h5")) else ["no checkpoint was kept"])


def bound_faults(row, folder):
    if "bounds" not in row:
        return []
    if not (folder / "out/summary.json").exists():
        return ["there is no summary"]
    summary = json.loads((folder / "out/summary.json").read_text(encoding="utf-8"))
    found = {**summary, **summary.get("measures", {})}
    return [f"{name} = {found.get(name)}, allowed {low} to {high}" for name, (low, high) in row["bounds"].items()
            if name not in found or not low <= found[name] <= high]


def happened(row, outcome):
    """In a line: the exit code and, of what was said, the line with the first text that was asked for."""
    asked = row.get("says", [""])[0]
    line = next((line for line in outcome.said.splitlines() if asked and asked in line), "")
    return f"exit {outcome.code}" + (f": {shortened(line.strip())}" if line else "")


def shortened(line, most=160):
    return line if len(line) <= most else line[:most - 4].rsplit(" ", 1)[0] + " ..."


def expected(row):
    """What the row asks for, in words."""
    if "test" in row:
        return f"the test `{row['test']}` passes"
    kinds = {0: "survives", 2: "refused as wrong usage", 3: "refused", 4: "stops, keeps its state", 5: "runs, misses",
             6: "checkpoint refused", 7: "told by the file system", 8: "not in this build", 75: "stopped, can be resumed"}
    parts = [f"{kinds[row.get('exit', 0)]} ({row.get('exit', 0)})"]
    if row.get("says"):
        parts.append("says " + ", ".join(f"`{text}`" for text in row["says"]))
    parts += [f"{low:g} ≤ {name} ≤ {high:g}" for name, (low, high) in row.get("bounds", {}).items()]
    if "then" in row:
        parts.append(f"then `talus {' '.join(row['then'])}` ends with 0")
    return "; ".join(parts)


def cell(text):
    return text.replace("|", "\\|").replace("<", "&lt;")


def table(results):
    """The page: rows of (row, what happened)."""
    text = ["# Hostile inputs", "",
            "Made by `python3 tests/program/hostile_inputs.py --page docs/hostile.md` from what the program did to each row of "
            "`tests/program/hostile/`; do not edit.", "",
            f"{len(results)} rows. Each ended within {PATIENCE} s, none by a signal it was not sent, with the exit code in "
            "brackets; no number in any file that they left (JSON, CSV, VTU, HDF5) is not finite. "
            "Exit codes: `docs/conventions.md`."]
    for group in hostile_rows.GROUPS:
        text += ["", f"## {group}", "", "| row | input | expected | what happened |", "|---|---|---|---|"]
        text += [f"| {row['row']} | {cell(row['input'])} | {cell(expected(row))} | {cell(what)} |"
                 for row, what in results if row["group"] == group]
    return "\n".join(text) + "\n"


def did(row):
    with tempfile.TemporaryDirectory(prefix="talus_") as name:
        folder = pathlib.Path(name)
        folder.chmod(0o777)
        return faults(row, folder)


class HostileInputs(unittest.TestCase):
    def test_every_row_is_met_as_the_table_says(self):
        for row in hostile_rows.rows():
            with self.subTest(row=row["row"], input=row["input"]):
                wrong, _ = did(row)
                self.assertEqual(wrong, [])

    def test_the_page_has_these_rows(self):
        page = (SOURCE / "docs/hostile.md").read_text(encoding="utf-8")
        for row in hostile_rows.rows():
            self.assertIn(f"| {row['row']} | {cell(row['input'])} | {cell(expected(row))} |", page)

    def test_the_table_is_whole(self):
        numbers = [str(row["row"]) for row in hostile_rows.rows()]
        self.assertEqual(len(set(numbers)), len(numbers), "a number is used twice")
        self.assertGreaterEqual(len(numbers), 200)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--page", type=pathlib.Path)
    parser.add_argument("rows", nargs="*")
    arguments = parser.parse_args()
    results, bad = [], 0
    for row in hostile_rows.matching(hostile_rows.rows(), arguments.rows):
        wrong, what = did(row)
        bad += bool(wrong)
        results.append((row, what))
        if wrong or arguments.rows:
            print(f"{'FAIL' if wrong else 'ok'} {row['row']} {row['input']}: {what}", *wrong, sep="\n    ", flush=True)
    if arguments.page and not bad:
        arguments.page.write_text(table(results), encoding="utf-8")
    print(f"{len(results)} rows, {bad} not as expected")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main() if len(sys.argv) > 1 else unittest.main())
