#!/usr/bin/python3
"""`talus check` finds what `talus run` would refuse, all of it at once. What is wrong and how it is told, one by one:
hostile_inputs.py."""
import unittest

from talus_process import InFolder, changed, coarse_dam, study, without

DAM = coarse_dam()


# what is wrong with the dam break: its pointer, and words that the message must hold
MISTAKES = {
    "/grid/spacing": (changed("/grid/spacing", "0.02"), "quotes"),
    "/materials/0/density": (without("/materials/0/density"), "kg/m^3"),
    "/walls/1/name": (changed("/walls/1/name", "base"), "twice"),
}


class WrongDocuments(InFolder):
    def test_check_and_run_say_the_same_and_leave_nothing_behind(self):
        for pointer, (document, words) in MISTAKES.items():
            with self.subTest(pointer):
                path = self.save(document)
                message = self.talus("check", path.name, code=3).stdout
                print(message.rstrip())
                for word in (path.name, pointer, words):
                    self.assertIn(word, message)
                run = self.talus("run", path.name, "-o", "it", code=3)
                self.assertIn(message.removeprefix("mistake: ").splitlines()[0], run.stderr)
                self.assertEqual([p.name for p in self.folder.iterdir()], [path.name])

    def test_every_mistake_is_told_at_once(self):
        case = changed("/grid/spacing", 0, changed("/gravity/slope_deg", 1e3, changed("/walls/0/contact/type", "glue")))
        told = self.talus("check", self.save(case), code=3).stdout
        for pointer in ("/grid/spacing", "/gravity/slope_deg", "/walls/0/contact/type"):
            self.assertIn(pointer, told)

    def test_a_study_of_too_many_cases_is_refused_at_once(self):
        wrong = study("dam_break_comparison")
        wrong["axes"] = [{"path": "/gravity/slope_deg", "values": list(range(100))}] * 40
        wrong["expect"] = []
        for verb in ("check", "run"):
            process = self.talus(verb, self.save(wrong), code=3)
            self.assertIn("at most 10000 are allowed", process.stdout + process.stderr)

    def test_a_value_of_an_axis_is_judged_like_that_of_a_case(self):
        wrong = changed("/axes/1/values", [0.0, 7.0], study("dam_break_comparison"))
        self.assertIn("beta", self.talus("check", self.save(wrong), code=3).stdout)

    def test_our_own_documents_are_valid(self):
        for name in ("dam_break_22", "dam_break_comparison", "column_3d", "bagnold_column"):
            self.talus("check", self.save(study(name)))


if __name__ == "__main__":
    unittest.main()
