#!/usr/bin/python3
"""`talus point` as a user meets it: the shipped points, their folders, exit codes, wrong documents."""
import copy
import json
import unittest

from talus_process import SOURCE, InFolder, changed

POINTS = SOURCE / "verification/points"
SHEAR = {
    "schema": "talus/point/1", "title": "shear", "kinematics": {"type": "plane_strain_reduced"},
    "law": {"type": "hencky", "young_modulus": 2.6, "poisson_ratio": 0.3},
    "path": [{"name": "shear", "duration": 1, "steps": 10, "xy": {"type": "strain", "by": 1e-3}}],
    "expect": [{"measure": "stress_xy", "time": 1, "value": 1e-3, "relative": 1e-5, "because": "G = 1"}],
}


class Point(InFolder):
    def point(self, document, *arguments, code=0):
        return self.talus("point", self.save(document), "-o", "out", "--force", *arguments, code=code)

    def test_what_is_shipped_meets_its_expectations(self):
        for path in sorted(POINTS.glob("*.json")):
            with self.subTest(path.stem):
                self.assertIn("valid", self.talus("check", path).stdout)
                self.talus("point", path, "-o", path.stem, "-q", "--no-pictures")
                for case in self.read(path.stem, "results.json")["cases"]:
                    self.assertNotIn("failure", case)

    def test_the_folder_has_series_pictures_and_results(self):
        self.point(changed("/axes", [{"path": "/path/0/xy/by", "values": [1e-3, 2e-3]}],
                           {**copy.deepcopy(SHEAR), "expect": [], "ends": [{"x": "strain_xy", "y": "stress_xy"}]}))
        header, *rows = (self.folder / "out/cases/case_001/series.csv").read_text().splitlines()
        last = dict(zip(header.split(","), map(float, rows[-1].split(","))))
        self.assertEqual(len(rows), 11)
        self.assertAlmostEqual(last["stress_xy [Pa]"], 2e-3, delta=1e-8)
        results = self.read("out", "results.json")
        self.assertEqual([case["at"] for case in results["cases"]], [[1e-3], [2e-3]])
        self.assertIn("command_line", self.read("out", "provenance.json"))
        for name in ("stress_xy_over_strain_xy", "end_stress_xy_over_strain_xy"):
            for extension in ("png", "svg"):
                self.assertGreater((self.folder / f"out/plots/{name}.{extension}").stat().st_size, 2000)

    def test_a_law_on_an_axis_needs_the_columns_that_are_drawn(self):
        law = {"type": "von_mises_duvaut_lions", "young_modulus": 2.6, "poisson_ratio": 0.3}
        document = {**copy.deepcopy(SHEAR), "law": law, "expect": [], "pictures": [{"x": "time", "y": "shear_rate"}],
                    "axes": [{"path": "/law/type", "values": ["von_mises_duvaut_lions", "hencky"]}]}
        told = self.point(document, code=3).stderr
        self.assertIn("type=hencky", told)
        self.assertIn("/pictures/0/y: found 'shear_rate'", told)

    def test_an_expectation_that_is_missed_ends_with_its_code(self):
        table = self.point(SHEAR, "--no-pictures").stdout
        self.assertIn("1 of 1 expectations met", table)
        self.assertIn("FAIL", self.point(changed("/expect/0/value", 2e-3, copy.deepcopy(SHEAR)), code=5).stdout)

    def test_a_path_that_the_law_cannot_follow_fails_and_keeps_the_series(self):
        law = {"type": "cam_clay", "young_modulus": 1e6, "poisson_ratio": 0.3, "M": 0.4, "beta": 0}
        document = {**copy.deepcopy(SHEAR), "law": law, "expect": []}
        document["path"].append({"name": "pull", "duration": 1, "steps": 10, "yy": {"type": "stress", "to": 50}})
        told = self.point(document, "--no-pictures", code=4).stderr
        self.assertIn("segment 'pull'", told)
        rows = len((self.folder / "out/cases/case_000/series.csv").read_text().splitlines()) - 1
        self.assertTrue(11 <= rows < 21, rows)  # the first segment, and of the second what the law could carry
        self.assertIn("failure", self.read("out", "results.json")["cases"][0])

    def test_a_quantity_beyond_all_numbers_ends_the_point_before_it_is_written(self):
        document = {**changed("/path/0/xy/by", 1e99, copy.deepcopy(SHEAR)), "expect": []}
        document["law"]["type"] = "neo_hookean"
        self.assertRegex(self.point(document, "--no-pictures", code=4).stderr, r"segment 'shear': at t = .* not finite")
        for file in ("cases/case_000/series.csv", "results.json"):
            self.assertNotRegex((self.folder / "out" / file).read_text(), r"\b(inf|nan|null)")

    def test_wrong_documents_are_refused_at_their_place(self):
        for pointer, value, words in (
                ("/path/0/zz", {"type": "rate", "value": 1}, "/path/0/zz: found 'rate'; expected: nothing"),
                ("/path/0/xy", {"type": "stres", "to": 1}, "did you mean \"stress\""),
                ("/path/0/steps", 0, "/path/0/steps"),
                ("/path/0/duration", -1, "/path/0/duration"),
                ("/path", [], "/path"),
                ("/law/type", "cam_cley", "cam_clay"),
                ("/pictures", [{"x": "strain", "y": "stress_xy"}], "/pictures/0/x: found 'strain'"),
                ("/expect/0/measure", "stress", "/expect/0/measure"),
                ("/expect/0/at", [1], "/expect/0/at: found 1 values; expected: one for each of the 0 axes"),
                ("/axes", [{"path": "/law/nothing", "values": [1]}], "leads nowhere"),
                ("/axes", [{"path": "law/xi", "values": [1]}], "/axes/0/path: 'law/xi' is no JSON pointer"),
                ("/axes", [{"path": "", "values": [1]}], "/axes/0/path: '' leads nowhere")):
            with self.subTest(pointer):
                document = changed(pointer, value, copy.deepcopy(SHEAR))
                if pointer == "/axes":
                    del document["expect"]
                self.assertIn(words, self.point(document, code=3).stderr)
                self.assertFalse((self.folder / "out").exists())

    def test_a_file_in_place_of_the_folder_is_told(self):
        self.save("", "out")
        self.assertIn("out", self.point(SHEAR, code=7).stderr)

    def test_points_and_cases_are_told_apart(self):
        path = self.save(SHEAR)
        self.assertIn("talus point", self.talus("run", path, code=3).stderr)
        self.assertIn("talus point", self.talus("explain", path, code=3).stderr)
        self.talus("point", SOURCE / "verification/studies/dam_break_22.json", code=3)
        self.assertTrue(any("Hencky" in source for source in
                            json.loads(self.talus("cite", path, "--json").stdout)))


if __name__ == "__main__":
    unittest.main()
