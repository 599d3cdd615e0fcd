"""The rows of the table of hostile inputs, and how each is done to the program. Imported by hostile_inputs.py.

A row of tests/program/hostile/*.json is an object of these members; all but `row` and `input` may be left out:

  row, input    its number, a letter behind it where there are several of a kind; what is hostile, in words
  document      which of hostile/documents it changes (block)
  change        JSON pointer -> value that is put there; remove: list of pointers that are taken out
  replace       [old, new] in the text of the changed document
  text, bytes   the document itself: text, or a list of [text, times] pieces; bytes in hexadecimal
  before        what is done first, in order: {"folder": name}, {"file": name, "text": ...}, {"link": name, "to": name},
                {"talus": arguments}, {"cut": pattern, "at": share}, {"flip": pattern},
                {"replace": pattern, "by": pattern}, {"drop": pattern}, {"mode": octal, "of": name},
                {"save": name, "document": name}
  arguments     of the program (run case.json -o out --no-pictures -t 1); with: further ones behind them
  output, talk  what takes the place of standard output or standard error: a file, or "closed pipe"
  limits        {"file": bytes, "memory": bytes, "files": number}
  nobody        true: without root's rights
  signal        {"name": SIGINT, "when": pattern of a file that must be there} sent to the program, so many seconds
                "after" and so many "times" if that is said
  then          arguments of a second command, which must end with 0
  exit          code that it must end with (0)
  says          texts that it must say, on either stream
  hides         texts that it must not say
  bounds        member or measure of summary.json -> [least, largest]
  test          folder/suite/case of a unit test that stands for the row
"""
import copy
import fnmatch
import json
import os
import pathlib
import re
import resource
import signal
import subprocess
import time

from talus_process import PROGRAM, SOURCE, place_of

FOLDER = pathlib.Path(__file__).resolve().parent / "hostile"
GROUPS = ("json", "parameters", "geometry", "physics", "files", "signals")
PLAIN = ["run", "case.json", "-o", "out", "--no-pictures", "-t", "1"]
NOBODY = 65534


def rows():
    """All rows, each with its group."""
    return [{**row, "group": group} for group in GROUPS
            for row in json.loads((FOLDER / f"{group}.json").read_text(encoding="utf-8"))]


def document(row):
    """The text of the row's document, as bytes."""
    if "bytes" in row:
        return bytes.fromhex(row["bytes"])
    if "text" in row:
        text = row["text"]
        return (text if isinstance(text, str) else "".join(part * times for part, times in text)).encode()
    case = read_document(row.get("document", "block"))
    for pointer in row.get("remove", ()):
        target, last = place_of(pointer, case)
        del target[last]
    for pointer, value in row.get("change", {}).items():
        put(case, pointer, value)
    text = json.dumps(case, indent=2, ensure_ascii=False)
    old, new = row.get("replace", ("", ""))
    if old not in text:
        raise ValueError(f"row {row['row']}: there is no {old!r} to replace")
    return text.replace(old, new, 1).encode() if old else text.encode()


def read_document(name):
    if name == "study":
        return {"schema": "talus/study/1", "title": "Two slopes", "base": read_document("block"),
                "axes": [{"path": "/gravity/slope_deg", "values": [0, 10]}]}
    return json.loads((FOLDER / "documents" / f"{name}.json").read_text(encoding="utf-8"))


def put(case, pointer, value):
    """Puts a value at a pointer; objects that are missing on the way are made, and a list's end may be named as -."""
    *way, last = pointer.strip("/").split("/")
    target = case
    for part in way:
        target = target[int(part)] if isinstance(target, list) else target.setdefault(part, {})
    if isinstance(target, list):
        target[len(target):] = [None] if last == "-" else []
        target[-1 if last == "-" else int(last)] = copy.deepcopy(value)
    else:
        target[last] = copy.deepcopy(value)


def prepare(row, folder):
    """Writes the document and does what comes before."""
    (folder / "case.json").write_bytes(document(row))
    for step in row.get("before", ()):
        Preparation(folder, step)()


class Preparation:
    """One of the steps before; its first member names it."""

    def __init__(self, folder, step):
        self.folder, self.step, self.kind = folder, step, next(iter(step))

    def __call__(self):
        getattr(self, f"_{self.kind}")(self.step[self.kind])

    def _one(self, pattern):
        return sorted(self.folder.glob(pattern))[-1]

    def _folder(self, name):
        (self.folder / name).mkdir(parents=True)

    def _file(self, name):
        (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
        (self.folder / name).write_text(self.step.get("text", ""), encoding="utf-8")

    def _link(self, name):
        (self.folder / name).symlink_to(self.step["to"])

    def _replace(self, pattern):
        self._one(pattern).write_bytes(self._one(self.step["by"]).read_bytes())

    def _cut(self, pattern):
        path = self._one(pattern)
        data = path.read_bytes()
        path.write_bytes(data[:int(self.step["at"] * len(data))])

    def _flip(self, pattern):
        path = self._one(pattern)
        data = bytearray(path.read_bytes())
        data[len(data) // 2] ^= 1
        path.write_bytes(data)

    def _drop(self, pattern):
        for path in self.folder.glob(pattern):
            path.unlink()

    def _mode(self, mode):
        (self.folder / self.step["of"]).chmod(int(mode, 8))

    def _save(self, name):
        (self.folder / name).write_bytes(document(self.step))

    def _talus(self, arguments):
        done = subprocess.run([PROGRAM, *arguments], cwd=self.folder, stdin=subprocess.DEVNULL, capture_output=True,
                              text=True, timeout=30)
        if done.returncode != self.step.get("exit", 0):
            raise RuntimeError(f"before: talus {' '.join(arguments)}: {done.stdout}{done.stderr}")


class Outcome:
    """What the program did: code (negative: killed by that signal; None: not ended in time), said, seconds."""

    def __init__(self, code, said, seconds):
        self.code, self.said, self.seconds = code, said, seconds


def run(row, folder, patience):
    """Does the row to the program in its folder."""
    arguments = [*row.get("arguments", PLAIN), *row.get("with", ())]
    begin = time.monotonic()
    with opened(row.get("output"), folder / "said.txt") as out, opened(row.get("talk"), folder / "talk.txt") as talk:
        process = subprocess.Popen(
            [PROGRAM, *arguments], cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=talk,
            env={**os.environ, "OMP_NUM_THREADS": "1"}, preexec_fn=_limits(row),
            **({"user": NOBODY, "group": NOBODY} if row.get("nobody") and os.geteuid() == 0 else {}))
        try:
            if "signal" in row:
                _send(process, row["signal"], folder)
            code = process.wait(timeout=patience)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            code = None
    said = b"".join((folder / name).read_bytes() for name in ("talk.txt", "said.txt") if (folder / name).exists())
    return Outcome(code, said.decode("utf-8", "replace"), time.monotonic() - begin)


def opened(place, usual):
    """A stream of the program: the usual file, another one, or a pipe whose reader has gone."""
    if place != "closed pipe":
        return open(place or usual, "wb")
    reader, writer = os.pipe()
    os.close(reader)
    return os.fdopen(writer, "wb")


def _limits(row):
    kinds = {"file": resource.RLIMIT_FSIZE, "memory": resource.RLIMIT_AS, "files": resource.RLIMIT_NOFILE}

    def limit():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        for kind, most in row.get("limits", {}).items():
            resource.setrlimit(kinds[kind], (most, most))
    return limit


def _send(process, order, folder):
    """Waits for the file, as long as the program lives, and sends the signal."""
    while not list(folder.glob(order["when"])) and process.poll() is None:
        time.sleep(0.002)
    time.sleep(order.get("after", 0))
    for _ in range(order.get("times", 1)):
        if process.poll() is None:
            process.send_signal(getattr(signal, order["name"]))


def unit_test(name):
    """Runs the unit test folder/suite/case; whether it ran and passed, and what it said."""
    folder, case = name.split("/", 1)
    done = subprocess.run([PROGRAM.parents[1] / "tests" / f"tests_{folder}", f"--run_test={case}", "--report_level=short"],
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60,
                          env={**os.environ, "TALUS_SOURCE_DIR": str(SOURCE), "TALUS_PROGRAM": str(PROGRAM)})
    said = done.stdout + done.stderr
    return done.returncode == 0 and re.search(r"\n  [1-9]\d* test cases? out of \d+ passed", said) is not None, said


def matching(names, chosen):
    """The rows whose numbers are chosen, by patterns; all where there are none."""
    return [row for row in names if not chosen or any(fnmatch.fnmatch(str(row["row"]), c) for c in chosen)]
