#!/usr/bin/python3
"""`talus resume` on the folder of a study: cases that ended stay as they are, one that was stopped goes on from its
checkpoint, one that is not there or is another study's is run. The results are those of the undisturbed study."""
import copy
import fcntl
import json
import os
import shutil
import unittest

from talus_process import SOURCE, InFolder, coarse_dam

NAMES = ("case_000", "case_001", "case_002")


def slopes(*degrees):
    """A study of slopes; each case expects something itself, and the study of its last one."""
    end = {"measure": "centre_of_mass_x", "time": 0.1, "value": 0.114, "because": "it starts there and hardly moves"}
    base = coarse_dam(expect=[{**end, "relative": 0.2}])
    return {"schema": "talus/study/1", "title": "Slopes", "base": base,
            "axes": [{"path": "/gravity/slope_deg", "values": list(degrees)}],
            "expect": [{**copy.deepcopy(end), "at": [degrees[-1]], "relative": 1e-9}]}


class ResumedStudy(InFolder):
    def setUp(self):
        super().setUp()
        self.study = self.save(slopes(0, 10, 20))
        self.table = self.run_quietly(self.study, "whole", code=5).stdout

    def resumed(self, code=5):
        told = self.talus("resume", "part", "-q", "--no-pictures", "-t", "1", code=code)
        self.assertEqual(told.stdout.replace("results in part", "results in whole"), self.table)
        for name in NAMES:
            self.assertEqual(self.hash_of(f"part/cases/{name}"), self.hash_of(f"whole/cases/{name}"))
        whole, part = (self.read(folder, "results.json") for folder in ("whole", "part"))
        self.assertEqual(part["expectations"], whole["expectations"])
        self.assertEqual([case["measures"] for case in part["cases"]], [case["measures"] for case in whole["cases"]])
        self.assertEqual(len((self.folder / "part/results.csv").read_text().splitlines()), 4)

    def test_cases_that_were_stopped_go_on(self):
        self.run_quietly(self.study, "part", "--until", "0.05")
        before = self.read("part/cases/case_001/summary.json")
        self.assertFalse(before["finished"])
        self.resumed()
        provenance = self.read("part/cases/case_001/provenance.json")
        self.assertIn("resume", provenance["command_line"])

    def test_cases_that_ended_are_not_run_again(self):
        shutil.copytree(self.folder / "whole", self.folder / "part")
        shutil.rmtree(self.folder / "part/cases/case_002")
        (self.folder / "part/results.json").unlink()
        files = [self.folder / "part/cases" / name / "summary.json" for name in NAMES[:2]]
        before = [(file.read_bytes(), file.stat().st_mtime_ns) for file in files]
        self.resumed()
        self.assertEqual([(file.read_bytes(), file.stat().st_mtime_ns) for file in files], before)

    def test_what_is_not_whole_of_a_case_that_ended_is_made_again(self):
        shutil.copytree(self.folder / "whole", self.folder / "part")
        case = self.folder / "part/cases/case_001"
        for name in ("summary.json", "status.json", "case.json"):
            for text in ("", "{}", "[]", "3", '{"exit_code": "x"}', '{"exit_code": 0, "expectations": [3]}',
                         '{"exit_code": 0, "expectations": [], "finished": true}'):
                with self.subTest(f"{name}: {text}"):
                    (case / name).write_text(text, encoding="utf-8")
                    self.resumed()
        for text in ("", (case / "series.csv").read_text(encoding="utf-8")[:1000]):
            (case / "series.csv").write_text(text, encoding="utf-8")
            self.assertIn("series.csv", self.talus("resume", "part", "-q", code=6).stderr)
            self.assertTrue((self.folder / "part/results.json").exists())

    def test_forced_it_begins_anew(self):
        shutil.copytree(self.folder / "whole", self.folder / "part")
        for name in NAMES:
            file = self.folder / "part/cases" / name / "summary.json"
            summary = json.loads(file.read_text(encoding="utf-8"))
            summary["measures"]["centre_of_mass_x"] = -777
            file.write_text(json.dumps(summary), encoding="utf-8")
        (self.folder / "part/cases/case_001/letter.txt").write_text("Dear", encoding="utf-8")
        self.run_quietly(self.study, "part", "--force", "--until", "0")
        self.resumed()
        self.assertEqual((self.folder / "part/cases/case_001/letter.txt").read_text(encoding="utf-8"), "Dear")

    def test_one_process_at_a_time(self):
        shutil.copytree(self.folder / "whole", self.folder / "part")
        holder = os.open(self.folder / "part", os.O_RDONLY)
        self.addCleanup(os.close, holder)
        fcntl.flock(holder, fcntl.LOCK_EX)
        for arguments in (("resume", "part"), ("run", self.study, "-o", "part", "--force")):
            self.assertIn("another process", self.talus(*arguments, code=7).stderr)
        fcntl.flock(holder, fcntl.LOCK_UN)
        in_a_case = os.open(self.folder / "part/cases/case_002", os.O_RDONLY)
        self.addCleanup(os.close, in_a_case)
        fcntl.flock(in_a_case, fcntl.LOCK_EX)
        self.assertIn("another process", self.talus("run", self.study, "-o", "part", "--force", code=7).stderr)
        self.assertTrue((self.folder / "part/cases/case_000/summary.json").exists())
        self.assertTrue((self.folder / "part/results.json").exists())

    def test_a_run_and_a_study_do_not_share_a_folder(self):
        self.run_quietly(self.save(coarse_dam(), "one.json"), "one", "--until", "0.01")
        told = self.talus("run", self.study, "-o", "one", "--force", code=7).stderr
        self.assertIn("not the folder of a study", told)
        told = self.talus("run", "one.json", "-o", "whole", "--force", code=7).stderr
        self.assertIn("not the folder of a run", told)
        self.assertTrue((self.folder / "whole/results.json").exists())

    def test_files_and_folders_of_others_stay(self):
        mine = self.folder / "mine"
        (mine / "cases/case_001").mkdir(parents=True)
        for name in ("results.csv", "results.json", "study.json", "cases/case_001/series.csv"):
            (mine / name).write_text("Dear", encoding="utf-8")
        self.assertIn("not the folder of a study", self.talus("run", self.study, "-o", "mine", "--force", code=7).stderr)
        self.assertEqual([path.read_text(encoding="utf-8") for path in mine.rglob("*.*")], ["Dear"] * 4)
        shutil.copytree(self.folder / "whole", self.folder / "part")
        for link in ("cases/case_001", "cases"):
            shutil.move(self.folder / "part" / link, self.folder / "elsewhere")
            (self.folder / "part" / link).symlink_to(self.folder / "elsewhere")
            self.assertIn("is a link", self.talus("run", self.study, "-o", "part", "--force", code=7).stderr)
            (self.folder / "part" / link).unlink()
            shutil.move(self.folder / "elsewhere", self.folder / "part" / link)
        self.resumed()

    def test_points_and_studies_replace_each_other(self):
        point = SOURCE / "verification/points/oedometer.json"
        self.talus("point", point, "-o", "part", "-q", "--no-pictures")
        self.assertIn("run its document again with --force", self.talus("resume", "part", code=6).stderr)
        self.run_quietly(self.study, "part", "--force", code=5)
        self.resumed()
        self.talus("point", point, "-o", "part", "-q", "--no-pictures", "--force")
        self.talus("resume", "part", code=6)

    def test_cases_of_an_earlier_study_in_the_folder_are_run_anew(self):
        self.run_quietly(self.save(slopes(0, 5, 15), "other.json"), "part", code=5)
        for name in ("study.json", "resolved_study.json"):
            shutil.copy(self.folder / "whole" / name, self.folder / "part" / name)
        self.resumed()

    def test_changes_of_the_command_line_are_kept(self):
        self.run_quietly(self.study, "set", "--until", "0.05", "--set", "/title=Gentle")
        self.assertEqual(self.read("set", "results.json")["expectations"], [])
        self.talus("resume", "set", "-q", "--no-pictures", code=5)
        self.assertEqual(self.read("set", "results.json")["title"], "Gentle")

    def test_an_error_in_a_case_stays_one(self):
        broken = slopes(0, 10)
        broken["base"]["bodies"][0]["velocity"] = {"type": "uniform", "velocity": [1e99, 0]}
        del broken["expect"]
        self.run_quietly(self.save(broken, "broken.json"), "failed", code=4)
        self.talus("resume", "failed", "-q", "--no-pictures", code=4)
        self.assertEqual([case["exit_code"] for case in self.read("failed", "results.json")["cases"]], [4, 4])


if __name__ == "__main__":
    unittest.main()
