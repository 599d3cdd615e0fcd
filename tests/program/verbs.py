#!/usr/bin/python3
"""Every verb as a user meets it: exit codes, help, output for people and for machines, a computation that fails."""
import json
import unittest

from talus_process import STUDIES, InFolder, changed, coarse_dam

VERBS = ("run", "resume", "point", "plot", "check", "explain", "schema", "list", "describe", "cite")
DAM = STUDIES / "dam_break_22.json"


def failing():
    """An elastic block thrown at the base so fast that its strain overflows within a few steps."""
    case = coarse_dam()
    case["materials"][0]["law"] = {"type": "hencky", "young_modulus": 1e6, "poisson_ratio": 0.3}
    case["bodies"][0]["velocity"] = {"type": "uniform", "velocity": [0, -1e99]}
    case["time"]["safety"] = 2
    return case


class Verbs(InFolder):
    def document(self, *arguments):
        return json.loads(self.talus(*arguments, "--json").stdout)

    def test_wrong_usage_is_told_apart(self):
        for arguments in ((), ("run",), ("frobnicate",), ("run", DAM, "--nonsense"), ("run", DAM, "-t", "-1")):
            with self.subTest(arguments):
                self.assertEqual(self.talus(*arguments, code=2).stdout, "")

    def test_every_verb_has_help_with_an_example(self):
        for verb in VERBS:
            self.assertIn(f"Example:\n  talus {verb}", self.talus(verb, "--help").stdout)

    def test_a_verb_of_a_program_that_is_not_built_is_told(self):
        told = self.talus("compare", code=8)
        self.assertIn("not in this build", told.stderr)

    def test_files_that_are_not_there_are_told(self):
        self.assertIn("nowhere.json", self.talus("run", "nowhere.json", code=7).stderr)
        self.talus("plot", "nowhere", code=7)

    def test_every_policy_that_is_listed_can_be_described(self):
        for kind, policies in self.document("list").items():
            self.assertEqual([p["name"] for p in policies], [p["name"] for p in self.document("list", kind)[kind]])
            for policy in policies:
                self.assertIn(policy["title"], self.talus("describe", policy["name"]).stdout)
        self.assertIn("laws", self.talus("list", "nonsense", code=3).stderr)
        self.assertIn("cam_clay", self.talus("describe", "cam_cla", code=3).stderr)

    def test_what_to_cite_is_told(self):
        sources = self.document("cite", DAM)
        for what in ("10.1017/jfm.2024.643", "[aflip]", "[quadratic]"):
            self.assertTrue(any(what in source for source in sources), what)

    def test_an_explanation_tells_what_is_stored(self):
        def explained(case):
            told = self.document("explain", self.save(case))
            return told["bytes_per_particle"], {field["name"] for field in told["fields"]}, told
        size, fields, told = explained(coarse_dam())
        self.assertLessEqual(size, 120)
        self.assertIn("affine_velocity", fields)
        self.assertEqual(told["particles"], 420)
        elastic = changed("/materials/0/law", {"type": "hencky"}, changed("/transfer", {"type": "flip"}))
        size, fields, _ = explained(elastic)
        self.assertLessEqual(size, 80)
        self.assertEqual(fields, {"position", "velocity", "mass", "elastic_strain", "id"})
        space = self.document("explain", STUDIES / "column_3d.json", "--set", "/grid/spacing=0.008")
        self.assertEqual(space["dimension"], 3)
        self.assertLessEqual(space["bytes_per_particle"], 220)

    def test_an_earlier_run_is_replaced_only_by_force(self):
        case = self.save(coarse_dam())
        self.run_quietly(case, "run", "--set", "/time/end=0.01")
        before = (self.folder / "run/summary.json").read_bytes()
        self.assertIn("--force", self.run_quietly(case, "run", code=7).stderr)
        self.assertEqual((self.folder / "run/summary.json").read_bytes(), before)
        self.run_quietly(case, "run", "--set", "/time/end=0.01", "--force")

    def test_a_missed_expectation_has_its_own_exit_code(self):
        expected = {"measure": "volume_ratio", "time": 0.005, "value": 2, "relative": 0.01, "because": "it is wrong"}
        case = self.save(changed("/time/end", 0.01, coarse_dam(expect=[expected])))
        self.assertIn("FAIL", self.run_quietly(case, "run", code=5).stdout)

    def test_json_is_the_summary_and_nothing_else(self):
        case = self.save(changed("/time/end", 0.01))
        told = self.run_quietly(case, "run", "--json").stdout
        self.assertEqual(json.loads(told), self.read("run", "summary.json"))
        self.assertEqual([line["kind"] for line in self.document("check", case)], ["valid"])
        json.loads(self.talus("schema").stdout)

    def test_talk_has_no_escape_codes_where_there_is_no_terminal(self):
        case = self.save(changed("/time/end", 0.01))
        told = self.talus("run", case, "-o", "run", "--no-pictures", "-t", "1", NO_COLOR="1")
        self.assertNotIn("\x1b", told.stdout + told.stderr)
        self.assertNotEqual(told.stderr, "")

    def test_pictures_are_drawn_again(self):
        self.run_quietly(self.save(changed("/time/end", 0.04)), "run")
        self.assertEqual(list((self.folder / "run/plots").glob("*.svg")), [])
        self.talus("plot", "run")
        self.assertNotEqual(list((self.folder / "run/plots").glob("*.svg")), [])

    def test_a_computation_that_fails_says_where_and_why_and_keeps_its_state(self):
        told = self.run_quietly(self.save(failing()), "run", code=4).stderr
        print(told)
        for word in ("particle", "glass_beads", "cause", "checkpoints"):
            self.assertIn(word, told)
        self.assertEqual(self.read("run", "status.json")["status"], "failed")
        self.assertEqual(self.read("run", "summary.json")["exit_code"], 4)
        self.assertNotEqual(list((self.folder / "run/checkpoints").glob("*.h5")), [])
        self.talus("resume", "run", "-q", "--no-pictures", "-t", "1", code=4)


if __name__ == "__main__":
    unittest.main()
