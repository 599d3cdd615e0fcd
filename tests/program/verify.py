#!/usr/bin/python3
"""The verification suite as a user meets it: what it lists, what it refuses, what it leaves in a folder. Cases that
throw, crash or hang: tests/verification/runner.cpp."""
import csv
import json
import os
import re
import unittest
import xml.etree.ElementTree

from talus_process import SOURCE, InFolder

FILES = {"junit.xml", "report.html", "report.md", "results.csv", "results.json"}


class Verify(InFolder):
    def cases(self, *arguments):
        return json.loads(self.talus("verify", "--list", "--json", *arguments).stdout)

    def smallest(self):
        return min(self.cases(), key=lambda case: (case["tier"], case["budget"]))["id"]

    def verify(self, *arguments, code=0, **environment):
        return self.talus("verify", self.smallest(), *arguments, code=code, **environment)

    def test_help_has_an_example_and_the_program_tells_of_it(self):
        self.assertIn("Example:\n  talus verify", self.talus("verify", "--help").stdout)
        self.assertRegex(self.talus("--help").stdout, r"\bverify\b")

    def test_every_case_is_listed_with_its_facts_and_lies_where_it_is_said_to(self):
        cases = self.cases()
        self.assertEqual(len({case["id"] for case in cases}), len(cases))
        text = self.talus("verify", "--list").stdout
        for case in cases:
            with self.subTest(case["id"]):
                self.assertTrue((SOURCE / "verification/cases" / f"{case['id']}.cpp").is_file())
                self.assertIn(case["tier"], (0, 1, 2))
                self.assertGreater(case["budget"], 0)
                self.assertTrue(case["title"] and case["truth"] and case["source"])
                self.assertIn(case["id"], text)

    def test_cases_are_chosen_by_id_folder_pattern_and_tier(self):
        cases = self.cases()
        ids = [case["id"] for case in cases]
        self.assertEqual([case["id"] for case in self.cases(ids[-1])], ids[-1:])
        self.assertEqual([case["id"] for case in self.cases("*")], ids)
        for folder in {case.split("/")[0] for case in ids if "/" in case}:
            self.assertEqual([case["id"] for case in self.cases(folder)], [i for i in ids if i.startswith(folder + "/")])
        for tier in {case["tier"] for case in cases}:
            self.assertEqual([case["id"] for case in self.cases("--tier", tier)],
                             [case["id"] for case in cases if case["tier"] <= tier])
        if late := next((case["id"] for case in cases if case["tier"] > 0), None):
            self.assertIn("no such case", self.talus("verify", late, "--tier", "0", code=2).stderr)

    def test_wrong_usage_is_told_apart(self):
        name = self.smallest()
        process = self.talus("verify", name[:-1] + "~", code=2)
        self.assertEqual(process.stdout, "")
        self.assertIn(f"did you mean '{name}'?", process.stderr)
        for arguments in (("--nonsense",), ("--tier", "3"), ("-j", "0")):
            with self.subTest(arguments):
                self.talus("verify", *arguments, code=2)

    def test_a_folder_gets_every_form_of_the_results(self):
        self.verify("-o", "out", "--markdown", "verification.md")
        self.assertEqual({path.name for path in (self.folder / "out").iterdir()}, FILES)
        results = self.read("out", "results.json")
        self.assertEqual(results["schema"], "talus/verification/1")
        rows = [row for case in results["cases"] for row in case["rows"]]
        self.assertEqual(sum(results["totals"].values()), len(rows))
        self.assertTrue(rows and results["green"])
        with open(self.folder / "out/results.csv", newline="", encoding="utf-8") as file:
            lines = list(csv.DictReader(file))
        self.assertEqual([(line["subject"], line["measure"], line["verdict"]) for line in lines],
                         [(row["subject"], row["measure"], row["verdict"]) for row in rows])
        tests = xml.etree.ElementTree.parse(self.folder / "out/junit.xml").getroot()
        self.assertEqual(len(tests.findall("testsuite/testcase")), len(rows))
        self.assertEqual(int(tests.get("tests")), len(rows))
        self.assertEqual(len(tests.findall("testsuite/testcase/skipped")), results["totals"]["omitted"])
        page = (self.folder / "out/report.html").read_text(encoding="utf-8")
        self.assertIn("default-src 'none'", page)
        self.assertIsNone(re.search(r"""(src|href)\s*=\s*["'](?!data:|#)""", page))
        markdown = (self.folder / "verification.md").read_text(encoding="utf-8")
        self.assertEqual(markdown, (self.folder / "out/report.md").read_text(encoding="utf-8"))
        self.assertIn(f"## {self.smallest()}", markdown)

    def test_earlier_results_are_not_overwritten_unless_forced(self):
        self.verify("-o", "out")
        self.assertIn("holds results already", self.verify("-o", "out", code=7).stderr)
        self.verify("-o", "out", "--force")

    def test_results_go_to_standard_output_and_talk_elsewhere(self):
        process = self.verify()
        self.assertRegex(process.stdout, rf"(?m)^{re.escape(self.smallest())} +PASS +\d+/\d+ ")
        self.assertRegex(process.stdout.splitlines()[-1], r"^PASS +\d+ rows?: ")
        self.assertIn("[1/1]", process.stderr)
        self.assertNotIn("\033", process.stdout + process.stderr)
        self.assertEqual(self.verify("-q").stderr, "")
        document, every = json.loads(self.verify("--json", "-q").stdout), self.verify("-v", "-q").stdout
        for row in document["cases"][0]["rows"]:
            self.assertIn(f"{row['subject']}: {row['measure']}", every)

    def test_an_earlier_run_is_compared_row_by_row(self):
        self.verify("-q", "-o", "before")
        results = self.read("before", "results.json")
        rows = results["cases"][0]["rows"]
        lost = {**rows[0], "measure": "a measure that is gone"}
        asked = next(row for row in rows if row["verdict"] == "pass")
        asked["verdict"] = "fail"
        rows.append(lost)
        results["cases"].append({**results["cases"][0], "id": "some/other"})
        self.save(results, "before/results.json")
        text = self.verify("-q", "--against", "before", "-o", "now").stdout
        self.assertIn(f"fail -> pass  {self.smallest()}  {asked['subject']}: {asked['measure']}", text)
        self.assertRegex(text, "gone  .*a measure that is gone")
        self.assertIn("not run now  some/other", text)
        changes = self.read("now", "results.json")["against"]["changes"]
        self.assertEqual(len(changes), len(rows))
        self.assertIn("a measure that is gone: gone", (self.folder / "now/report.md").read_text(encoding="utf-8"))

    def test_a_folder_that_cannot_be_compared_is_told_before_the_work(self):
        self.verify("--against", "nowhere", code=7)
        (self.folder / "other").mkdir()
        self.save({"schema": "talus/bench/1"}, "other/results.json")
        self.assertIn("talus/verification/1", self.verify("--against", "other", code=3).stderr)
        self.save("{", "other/results.json")
        self.assertIn("is no JSON", self.verify("--against", "other", code=3).stderr)

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_a_folder_that_cannot_be_written_is_told(self):
        (self.folder / "shut").mkdir(mode=0o500)
        self.verify("-o", "shut/out", code=7)


if __name__ == "__main__":
    unittest.main()
