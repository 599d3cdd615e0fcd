#!/usr/bin/env python3
"""Plants defects in a scratch copy of this checkout and tells which case of the suite catches each.

Every file NN_*.patch beside this script plants one defect behind a switch; 00 is the switch, the variable TALUS_DEFECT of
the environment. All are applied to one copy, which is built once, without the cases that are not run. With no defect switched on, every case that is to
catch one must be green: what is caught is the defect and not the patch. Then each defect is switched on and the case
that its patch names is run: it must fail. The suite's tier 0 is run, too, and what else fails is told.

    verification/defects/run.py [--scratch FOLDER] [--reuse] [--report FILE] [NUMBER...]

Exit code: 0 where all is as it should be, 5 where a defect survives or a valid variant is caught.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent


class Defect:
    def __init__(self, patch):
        head = patch.read_text().split("diff --git")[0]
        self.number = int(patch.name[:2])
        self.subject = re.search("^Subject: (.*)$", head, re.M).group(1)
        caught_by = re.search("^Caught-by: (.*)$", head, re.M)
        self.caught_by = caught_by.group(1) if caught_by else "nothing"


def copy_of_checkout(scratch):
    if scratch.exists():
        shutil.rmtree(scratch)
    scratch.mkdir(parents=True)
    files = subprocess.run(["git", "-C", ROOT, "ls-files", "-z"], check=True, capture_output=True).stdout
    for name in files.decode().split("\0")[:-1]:
        if (ROOT / name).is_file():
            (scratch / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, scratch / name)


def leave_out_cases(scratch, named):
    """Takes out of the copy the cases that will not be run: those neither of tier 0 nor named."""
    cases = scratch / "verification/cases"
    for source in cases.rglob("*.cpp"):
        tier = re.search(r",\s*(\d),\s*[\d.]+,\s*run\}", source.read_text()).group(1)
        if tier != "0" and str(source.relative_to(cases).with_suffix("")) not in named:
            source.unlink()


def build(scratch, patches):
    subprocess.run(["git", "init", "-q", scratch], check=True)
    for patch in patches:
        subprocess.run(["git", "-C", scratch, "apply", "-C0", patch], check=True)
    subprocess.run(["cmake", "--preset", "release", "-D", "TALUS_BUILD_VERIFICATION=ON",
                    "-D", "CMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG", *generator()], cwd=scratch,
                   check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", "build/release", "--target", "talus_verify", "--parallel", str(os.cpu_count())],
                   cwd=scratch, check=True, stdout=sys.stderr)


def generator():
    return ["-G", "Ninja"] if shutil.which("ninja") else []


def rows_missed(program, number, what):
    """The rows that are not green with this defect, as (case, row)."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out"
        run = subprocess.run([program, *what, "-o", out], env=os.environ | {"TALUS_DEFECT": str(number)},
                             capture_output=True, text=True)
        if run.returncode not in (0, 5):
            sys.exit(f"talus-verify ended with {run.returncode}:\n{run.stderr}")
        missed = []
        for case in json.loads((out / "results.json").read_text())["cases"]:
            for row in case["rows"]:
                if row["verdict"] in ("fail", "floored", "error"):
                    missed.append((case["id"], f'{row["subject"]}: {row["measure"]}'))
        return missed


def told(defect, own, others):
    first = own[0][1] if own else ""
    more = f" and {len(own) - 1} more rows" if len(own) > 1 else ""
    also = ", ".join(sorted({case for case, _ in others} - {defect.caught_by}))
    right = not own and not others if defect.caught_by == "nothing" else bool(own)
    verdict = "not caught, as it should be" if right and defect.caught_by == "nothing" else "caught" if right else \
        "CAUGHT BY MISTAKE" if defect.caught_by == "nothing" else "SURVIVES"
    return right, f"| {defect.number} | {defect.subject} | {defect.caught_by} | {verdict} | {first}{more} | {also} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scratch", type=pathlib.Path, default=pathlib.Path(tempfile.gettempdir()) / "talus_defects")
    parser.add_argument("--reuse", action="store_true", help="run what an earlier call has built in the scratch folder")
    parser.add_argument("--report", type=pathlib.Path, help="write the table there, in Markdown")
    parser.add_argument("numbers", nargs="*", type=int)
    arguments = parser.parse_args()
    patches = sorted(HERE.glob("[0-9][0-9]_*.patch"))
    defects = [d for d in map(Defect, patches[1:]) if not arguments.numbers or d.number in arguments.numbers]
    begun = time.time()
    named = sorted({d.caught_by for d in defects} - {"nothing"})
    program = arguments.scratch / "build/release/bin/talus-verify"
    if not arguments.reuse:
        copy_of_checkout(arguments.scratch)
        leave_out_cases(arguments.scratch, named)
        build(arguments.scratch, patches)
    if spoilt := rows_missed(program, 0, named):
        sys.exit(f"without any defect these rows are missed, so that nothing can be said: {spoilt}")
    lines = ["# Planted defects\n", "Made by `verification/defects/run.py`: every defect is switched on in a copy of the sources, and the case",
             "that is to catch it is run, and tier 0. Number 13 is none: a valid variant that must pass.\n",
             "| | planted | to be caught by | verdict | first row that tells | other cases of tier 0 that tell |",
             "|---|---|---|---|---|---|"]
    well = True
    for defect in defects:
        own = rows_missed(program, defect.number, [defect.caught_by]) if defect.caught_by != "nothing" else []
        right, line = told(defect, own, rows_missed(program, defect.number, ["--tier", "0"]))
        well = well and right
        lines.append(line)
        print(line, flush=True)
    lines.append(f"\n{'Run' if arguments.reuse else 'Built and run'} in {(time.time() - begun) / 60:.0f} minutes.")
    if arguments.report:
        arguments.report.write_text("\n".join(lines) + "\n")
    return 0 if well else 5


if __name__ == "__main__":
    sys.exit(main())
