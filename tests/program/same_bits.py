#!/usr/bin/python3
"""The results do not depend, bit for bit, on the number of threads, nor on where a run was stopped and resumed."""
import signal
import subprocess
import time
import unittest

from talus_process import PROGRAM, InFolder, dam_with_a_station


class Bits(InFolder):
    def test_they_do_not_depend_on_the_number_of_threads(self):
        case = self.save(dam_with_a_station())
        for threads in (1, 2, 3, 8):
            self.run_quietly(case, f"t{threads}", threads=threads)
        for threads in (2, 3, 8):
            with self.subTest(threads=threads):
                self.assertEqual(self.hash_of(f"t{threads}"), self.hash_of("t1"))
                self.same_files("t1", f"t{threads}")

    def test_a_different_case_gives_a_different_hash(self):
        case = self.save(dam_with_a_station())
        self.run_quietly(case, "a")
        self.run_quietly(case, "b", "--set", "/bodies/0/seeding/seed=43")
        self.assertNotEqual(self.hash_of("a"), self.hash_of("b"))

    def test_a_run_stopped_half_way_goes_on_as_if_it_had_not_been(self):
        case = self.save(dam_with_a_station())
        self.run_quietly(case, "whole")
        self.run_quietly(case, "halves", "--until", "0.05")
        self.assertFalse(self.read("halves", "summary.json")["finished"])
        self.assertEqual(self.read("halves", "status.json")["status"], "stopped")
        self.assertNotEqual((self.folder / "halves/series.csv").read_bytes(),
                            (self.folder / "whole/series.csv").read_bytes())
        self.talus("resume", "halves", "-q", "--no-pictures", "-t", "2", "--until", "0.07777")
        self.talus("resume", "halves", "-q", "--no-pictures", "-t", "1")
        self.assertEqual(self.hash_of("halves"), self.hash_of("whole"))
        self.same_files("whole", "halves")

    def test_a_run_stopped_by_a_signal_keeps_its_state_and_goes_on(self):
        case = dam_with_a_station()
        case["grid"]["spacing"] = 0.01
        case = self.save(case)
        self.run_quietly(case, "whole")
        for number in (signal.SIGTERM, signal.SIGINT):
            with self.subTest(number=number):
                folder = number.name
                process = subprocess.Popen([PROGRAM, "run", case, "-o", folder, "-q", "--no-pictures", "-t", "1"],
                                           cwd=self.folder, stdout=subprocess.DEVNULL)
                while not (self.folder / folder / "frames/f_000002.vtu").exists():
                    self.assertIsNone(process.poll(), "it was over too soon")
                    time.sleep(0.002)
                process.send_signal(number)
                self.assertEqual(process.wait(timeout=60), 75)
                self.assertEqual(self.read(folder, "status.json")["status"], "stopped")
                self.assertLess(self.read(folder, "summary.json")["time"], 0.1)
                self.talus("resume", folder, "-q", "--no-pictures", "-t", "1")
                self.assertEqual(self.hash_of(folder), self.hash_of("whole"))
                self.same_files("whole", folder)

    def test_what_is_no_run_cannot_be_resumed(self):
        (self.folder / "empty").mkdir()
        self.talus("resume", "empty", code=7)
        self.talus("resume", "nowhere", code=7)


if __name__ == "__main__":
    unittest.main()
