#!/usr/bin/python3
"""Whether sources mean the same built together as each by itself (docs/decisions/0025):

    tests/architecture/built_together.py build/release [talus_app …]

compiles every unit of a release build that holds several sources, and these sources one by one, without optimisation,
and compares what each function of ours calls and reads and which numbers and texts it holds. Tells what differs and
exits with 1. Takes g++ and ninja, and some minutes a processor."""
import collections
import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import sys

PLAIN = ["-S", "-O0", "-w", "-fno-asynchronous-unwind-tables"]
NOTHING = collections.Counter()
OURS = re.compile(r"_ZNK?5talus")
DESTRUCTOR = re.compile(r"D[0-2]Ev$")


def compiled(entry, source):
    """The assembler text of a source, compiled as the entry of the build is, but without optimisation."""
    words, kept = iter(shlex.split(entry["command"])), []
    for word in words:
        if word in ("-MF", "-MT", "-o", "-c", "-include"):
            next(words)
        elif word != "-MD" and not word.startswith(("-O", "-W", "-fexpensive")):
            kept.append(word)
    done = subprocess.run(kept + PLAIN + ["-o", "-", source], cwd=entry["directory"], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{source} does not compile:\n{done.stderr}")
    return done.stdout


def functions_of(text):
    """What each of our functions calls or reads, and its constants, counted; a string or number in place of its label."""
    constants = {label: re.sub(r"\s+", " ", data) for label, data in
                 re.findall(r"^(\.LC\d+):\n((?:\t\.(?:long|quad|string|ascii|value|byte|octa).*\n)+)", text, re.M)}
    functions = {}
    for name, body in re.findall(r"^(_Z\w+):\n\.LF[BE]\d+:\n(.*?)^\t\.size", text, re.M | re.S):
        if OURS.match(name):
            instructions = re.sub(r"^\t\..*\n", "", body, flags=re.M)
            used = re.findall(r"(?<![%\w.])(?:\.LC\d+|_Z[\w.]+|\$-?\d+)", instructions)
            # destructors apart: fewer where the compiler sees that nothing throws
            functions[name] = collections.Counter(constants.get(word, word) for word in used if not DESTRUCTOR.search(word))
    return functions


def differences(entry):
    """Of one unit of the build: its number of functions, and (source, function, only apart, only together)."""
    sources = re.findall(r'#include "(.+?)"', open(os.path.join(entry["directory"], entry["file"])).read())
    together = functions_of(compiled(entry, entry["file"]))
    found, count = [], 0
    for source in sources:
        apart = functions_of(compiled(entry, source))
        count += len(apart)
        found += [(source, name, uses - together.get(name, NOTHING), together.get(name, NOTHING) - uses)
                  for name, uses in apart.items() if uses != together.get(name)]
    return count, found


def main(build, targets):
    commands = json.loads(subprocess.run(["ninja", "-C", build, "-t", "compdb"], capture_output=True, check=True).stdout)
    wanted = [entry for entry in commands if re.search(r"/(\w+)\.dir/Unity/.*\.o$", entry["output"])
              and (not targets or re.search(r"/(\w+)\.dir/", entry["output"])[1] in targets)]
    wrong = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for entry, (count, found) in zip(wanted, pool.map(differences, wanted)):
            print(f"{entry['output']}: {count} functions, {len(found)} differ", flush=True)
            for source, name, apart, together in found:
                print(f"  {source}: {name}\n    apart: {dict(apart)}\n    together: {dict(together)}")
            wrong += len(found)
    return 1 if wrong or not wanted else 0


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2:]))
