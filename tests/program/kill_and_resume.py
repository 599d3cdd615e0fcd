#!/usr/bin/python3
"""Kills runs at random moments, resumes them, and demands the files of a run that nobody disturbed, bit for bit.

    tests/program/kill_and_resume.py [--kills 100] [--seed 1]

Of six disturbances four are SIGKILL, which are counted, one is SIGTERM and one SIGINT. What is resumed may be disturbed
again. TALUS_PROGRAM names the program, build/release/bin/talus if it is not set.
"""
import argparse
import collections
import random
import signal
import subprocess
import sys
import time
import unittest

from talus_process import PROGRAM, InFolder, dam_with_a_station

OPTIONS = argparse.Namespace(kills=10, seed=1)
QUIET = ("-q", "--no-pictures", "-t", "1")


class Killed(InFolder):
    def start(self, *arguments):
        return subprocess.Popen([PROGRAM, *arguments, *QUIET], cwd=self.folder, stdout=subprocess.DEVNULL,
                                stderr=subprocess.DEVNULL)

    def half_written(self, folder):
        """The frames that a kill left half written; the next run that gets to listen removes them."""
        return set((self.folder / folder).glob("frames/*.vtu.tmp"))

    def disturbed(self, command, folder, delay):
        """Lets a process live for `delay` seconds. Returns the signal that ended it, None if it was faster."""
        left = self.half_written(folder)
        process = self.start(*command)
        number = self.random.choice([signal.SIGKILL] * 4 + [signal.SIGTERM, signal.SIGINT])
        time.sleep(delay)
        process.send_signal(number)
        code = process.wait(timeout=60)
        if code == 0:
            return None
        if code == 75:
            self.assertNotEqual(number, signal.SIGKILL)
            self.assertEqual(self.read(folder, "status.json")["status"], "stopped")
        else:
            self.assertEqual(code, -number)
            if number != signal.SIGKILL:  # it came before the run could listen: nothing was computed
                self.assertLessEqual(self.half_written(folder), left)
        return number

    def way_on(self, folder, case):
        """The command with which a user goes on, and what the folder holds."""
        if not (self.folder / folder / "status.json").exists():
            return ("run", case, "-o", folder), "nothing"
        if not (self.folder / folder / "resolved.json").exists():
            self.talus("resume", folder, *QUIET, code=6)
            return ("run", case, "-o", folder, "--force"), "no case"
        checkpoints = list((self.folder / folder).glob("checkpoints/*.h5"))
        return ("resume", folder), f"{len(checkpoints)} checkpoints"

    def test_a_run_that_was_killed_goes_on_to_the_same_bits(self):
        self.random = random.Random(OPTIONS.seed)
        document = dam_with_a_station()
        document["grid"]["spacing"] = 0.01
        document["output"].update(frames_every=0.01, checkpoints_every=0.01)
        case = self.save(document)
        begun = time.monotonic()
        self.run_quietly(case, "whole")
        duration = time.monotonic() - begun
        ends, left, runs = collections.Counter(), collections.Counter(), 0
        while ends["SIGKILL"] < OPTIONS.kills:
            folder, command = f"run_{runs}", ("run", case, "-o", f"run_{runs}")
            while number := self.disturbed(command, folder, self.random.uniform(0, 1.1 * duration)):
                ends[number.name] += 1
                command, found = self.way_on(folder, case)
                left[found] += 1
            with self.subTest(run=runs):
                self.assertEqual(self.hash_of(folder), self.hash_of("whole"))
                self.same_files("whole", folder)
                self.assertEqual(self.names(folder), self.names("whole"))
            runs += 1
        print(f"{runs} runs of {duration:.2f} s, ended by {dict(ends)}; the folder held {dict(left)}: all went on to the "
              "same bits")

    def names(self, folder):
        """Every file of a run but its checkpoints, of which a signal leaves one more."""
        root = self.folder / folder
        return sorted(str(p.relative_to(root)) for p in root.rglob("*") if p.is_file() and p.suffix != ".h5")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kills", type=int, default=OPTIONS.kills)
    parser.add_argument("--seed", type=int, default=OPTIONS.seed)
    OPTIONS = parser.parse_args()
    unittest.main(argv=sys.argv[:1])
