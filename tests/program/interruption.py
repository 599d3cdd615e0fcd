#!/usr/bin/python3
"""What stands in the way of a run or of going on with it: damaged and foreign checkpoints, a full disk, a folder that may
not be written to. The message says what and what to do, and nothing that was complete is lost."""
import hashlib
import os
import resource
import shutil
import subprocess
import unittest

from talus_process import PROGRAM, InFolder, changed, dam_with_a_station

QUIET = ("-q", "--no-pictures", "-t", "1")


def with_header(contents):
    """The file of a checkpoint with these contents and a true checksum."""
    text = (f"talus checkpoint, format 4\nHDF5 from byte 512 on\nbytes {len(contents)}\n"
            f"sha256 {hashlib.sha256(contents).hexdigest()}\n")
    return text.encode().ljust(512, b"\n") + contents


def everything_in(folder):
    return {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


class Interruption(InFolder):
    def setUp(self):
        super().setUp()
        self.case = self.save(dam_with_a_station())

    def half_a_run(self, folder="run", *arguments):
        """A run stopped half way. Returns its folder and its newest checkpoint."""
        self.run_quietly(self.case, folder, "--until", "0.05", *arguments)
        return self.folder / folder, max((self.folder / folder / "checkpoints").iterdir())

    def refused(self, run, *words):
        """Nobody can go on with the run; its folder stays as it was, and the message holds the words."""
        before = everything_in(run)
        told = self.talus("resume", run.name, *QUIET, code=6).stderr
        print(told.rstrip())
        for word in words:
            self.assertIn(word, told)
        self.assertEqual(everything_in(run), before)
        return told

    def test_a_damaged_checkpoint_is_refused_and_the_one_before_goes_on(self):
        self.run_quietly(self.case, "whole")
        run, newest = self.half_a_run()
        good = newest.read_bytes()
        for bad, why in ((b"", "it is empty"), (good[:200], "it is cut short"),
                         (good[:len(good) // 2], "it is cut short"), (b"nonsense", "not a checkpoint of Talus"),
                         (good[512:], "it is an HDF5 file, but not a checkpoint"),
                         (good.replace(b"format 4", b"format 9", 1), "it has format 9, this program reads format 4"),
                         (good[:-900] + bytes([good[-900] ^ 1]) + good[-899:], "do not agree with its checksum")):
            with self.subTest(why):
                newest.write_bytes(bad)
                told = self.refused(run, newest.name, why)
        before = sorted(run.glob("checkpoints/*.h5"))[-2]
        self.assertIn(f"to go on from {before.name}, move", told)
        newest.unlink()
        self.talus("resume", "run", *QUIET)
        self.assertEqual(self.hash_of("run"), self.hash_of("whole"))
        self.same_files("whole", "run")

    def test_a_run_without_a_checkpoint_begins_anew(self):
        self.run_quietly(self.case, "whole")
        run, _ = self.half_a_run()
        for path in sorted(run.glob("checkpoints/*.h5"), reverse=True):
            path.write_bytes(b"")
            self.refused(run)
            path.unlink()
        self.talus("resume", "run", *QUIET)
        self.assertEqual(self.hash_of("run"), self.hash_of("whole"))
        self.same_files("whole", "run")

    def test_a_run_that_ended_measures_the_same_when_it_is_resumed(self):
        self.run_quietly(self.case, "whole")
        measured = self.read("whole/summary.json")["measures"]
        self.assertGreater(measured["dt"], 0)
        self.talus("resume", "whole", *QUIET)
        self.assertEqual(self.read("whole/summary.json")["measures"], measured)

    def test_the_checkpoint_of_another_case_is_refused(self):
        run, newest = self.half_a_run()
        for pointer, value in (("/grid/spacing", 0.025), ("/kernel", {"type": "cubic"}),
                               ("/kinematics", {"type": "plane_strain"}), ("/transfer", {"type": "apic"})):
            with self.subTest(pointer):
                self.case = self.save(changed(pointer, value, dam_with_a_station()), "other.json")
                _, foreign = self.half_a_run("other", "--force")
                shutil.copy(foreign, newest)
                self.refused(run, newest.name, "it is of another case", pointer)

    def test_a_series_that_was_cut_is_told_apart(self):
        run, newest = self.half_a_run()
        series = (run / "series.csv").read_text().splitlines(keepends=True)
        (run / "series.csv").write_text("".join(series[:4]))
        self.refused(run, newest.name, "has 3 rows")
        (run / "series.csv").write_text("".join(["hour [h]\n", *series[1:]]))
        self.refused(run, "has other columns")

    def test_a_checkpoint_of_another_build_is_told(self):
        _, newest = self.half_a_run()
        contents = newest.read_bytes()[512:]
        self.assertNotIn("another build", self.talus("resume", "run", "--no-pictures", "--until", "0.06").stderr)
        for path in (self.folder / "run/checkpoints").iterdir():
            path.unlink()
        self.assertEqual(contents.count(b"talus 0.1.0 ("), 1)
        newest.write_bytes(with_header(contents.replace(b"talus 0.1.0 (", b"talus 0.0.9 (")))
        self.assertIn("written by another build, talus 0.0.9",
                      self.talus("resume", "run", "--no-pictures", "--until", "0.06").stderr)

    def limited(self, limit, *arguments):
        """The program, which may not let a file grow beyond so many bytes: a full disk, as far as it sees one."""
        return subprocess.run([PROGRAM, *map(str, arguments), *QUIET], cwd=self.folder, capture_output=True, text=True,
                              timeout=60, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))

    def test_a_full_disk_keeps_the_last_good_state(self):
        case = dam_with_a_station()
        case["output"]["stations"] += [{"name": f"s{k}", "min": [0, 0], "max": [0.1 * k, 0.2]} for k in (1, 2, 3)]
        case["output"]["series_every"] = 1e-9  # a row each step: the series outgrows a frame
        case = self.save(case)
        self.run_quietly(case, "whole")
        frame, series = ((self.folder / "whole" / name).stat().st_size for name in ("frames/f_000000.vtu", "series.csv"))
        self.assertLess(frame, series // 2)
        for limit, what, whence in ((frame - 1, ".vtu", "beginning"), (series // 2, "series.csv", "last checkpoint")):
            with self.subTest(what):
                told = self.limited(limit, "run", case, "-o", what)
                print(told.stderr.rstrip())
                self.assertEqual(told.returncode, 7, told.stderr)
                self.assertRegex(told.stderr, f"cannot write .*{what}.*: File too large")
                self.assertIn(f"'talus resume {what}' goes on from the {whence}", told.stderr)
                self.assertEqual(list((self.folder / what).rglob("*.tmp")), [])
                self.talus("resume", what, *QUIET)
                self.assertEqual(self.hash_of(what), self.hash_of("whole"))
                self.same_files("whole", what)

    def test_a_file_system_without_room_keeps_the_last_good_state(self):
        self.run_quietly(self.case, "whole")
        size = sum(map(len, everything_in(self.folder / "whole").values()))
        (self.folder / "disk").mkdir()
        own_mounts = ("unshare", "--map-root-user", "--mount", "sh", "-c")
        if subprocess.run([*own_mounts, "mount -t tmpfs none disk"], cwd=self.folder, capture_output=True).returncode != 0:
            self.skipTest("a file system of memory may not be mounted here")
        told = subprocess.run([*own_mounts, f"""
            mount -t tmpfs -o size={size // 2} none disk
            "$0" run "$1" -o disk/run "$2" "$3" "$4" "$5"
            code=$?
            mount -o remount,size={8 * size} none disk
            "$0" resume disk/run "$2" "$3" "$4" "$5" && cp -r disk/run run
            exit $code""", PROGRAM, self.case, *QUIET], cwd=self.folder, capture_output=True, text=True, timeout=60)
        print(told.stderr.rstrip())
        self.assertEqual(told.returncode, 7, told.stderr)
        self.assertRegex(told.stderr, "cannot write disk/run/.*: No space left on device")
        self.assertIn("'talus resume disk/run' goes on from the last checkpoint", told.stderr)
        self.assertEqual(self.hash_of("run"), self.hash_of("whole"))
        self.same_files("whole", "run")

    def without_privilege(self, *arguments):
        """The program as a user to whom the permissions of files apply."""
        ordinary = ("setpriv", "--bounding-set", "-dac_override,-dac_read_search") if os.getuid() == 0 else ()
        return subprocess.run([*ordinary, PROGRAM, *map(str, arguments), *QUIET], cwd=self.folder, capture_output=True,
                              text=True, timeout=60)

    def test_a_folder_that_may_not_be_written_to_is_told(self):
        run, _ = self.half_a_run()
        whole = everything_in(run)
        for path in (run, *run.rglob("*")):
            path.chmod(0o555 if path.is_dir() else 0o444)
        for command in (("resume", "run"), ("run", self.case, "-o", "run", "--force"),
                        ("run", self.case, "-o", "run/below")):
            with self.subTest(command):
                told = self.without_privilege(*command)
                print(told.stderr.rstrip())
                self.assertEqual(told.returncode, 7, told.stderr)
                self.assertIn("Permission denied", told.stderr)
                self.assertEqual(everything_in(run), whole)
        for path in (run, *run.rglob("*")):
            path.chmod(0o755)


if __name__ == "__main__":
    unittest.main()
