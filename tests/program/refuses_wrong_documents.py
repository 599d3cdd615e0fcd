#!/usr/bin/python3
"""Wrong documents are refused before anything is computed, with words that say where, what was found, what is allowed."""
import json
import unittest

from talus_process import InFolder, changed, coarse_dam, study, without

DAM = coarse_dam()


def text_with(old, new):
    """The dam break as text, with something in it replaced."""
    text = json.dumps(DAM, indent=2)
    assert old in text, old
    return text.replace(old, new, 1)


def polygon_in_space():
    shape = {"type": "polygon", "points": [[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, 0.1, 0.0]]}
    return changed("/bodies/0/shape", shape, study("column_3d"))


def station(**members):
    """The dam break with a station, of which members are replaced; another one is called toe."""
    toe = {"name": "toe", "min": [0.0, 0.0], "max": [0.1, 0.1]}
    return changed("/output/stations", [toe, {**toe, "name": "gate", **members}])


def mirror(shape, **members):
    """The dam break with a base that mirrors, of another shape."""
    shape = {"type": "half_space", "point": [0.0, 0.0], "normal": [0.0, 1.0], **shape}
    return changed("/walls/0", {"name": "base", "shape": shape, "contact": {"type": "mirrored_stick"}, **members})


# name of the file: document, words that the message must hold (where, what was found, what is allowed)
VALUES = {
    "unknown_key": (changed("/gravity/slope", 22), "/gravity/slope", "slope_deg"),
    "unknown_key_in_law": (changed("/materials/0/law/young", 1e6), "/materials/0/law/young", "young_modulus"),
    "wrong_type": (changed("/grid/spacing", "0.02"), "/grid/spacing", "0.02", "number", "quotes"),
    "null": (changed("/kernel", None), "/kernel", "null", "quadratic"),
    "out_of_range": (changed("/materials/0/law/poisson_ratio", 0.5), "/materials/0/law/poisson_ratio", "0.5", "-1 <"),
    "negative_spacing": (changed("/grid/spacing", -0.02), "/grid/spacing", "-0.02", "> 0"),
    "missing": (without("/materials/0/density"), "/materials/0/density", "nothing", "kg/m^3"),
    "missing_part": (without("/transfer"), "/transfer", "nothing", "aflip"),
    "not_an_integer": (changed("/bodies/0/seeding/seed", 1.5), "/bodies/0/seeding/seed", "1.5", "integer"),
    "too_short": (changed("/bodies/0/shape/min", [0.0]), "/bodies/0/shape/min", "1", "2"),
    "too_long": (changed("/walls/0/shape/normal", [0.0, 1.0, 0.0]), "/walls/0/shape/normal", "3", "2"),
    "empty_list": (changed("/bodies", []), "/bodies", "empty"),
    "unknown_policy": (changed("/transfer/type", "aflipp"), "/transfer/type", "aflipp", 'did you mean "aflip"'),
    "policy_as_text": (changed("/kernel", "cubic"), "/kernel", '{"type": "cubic"}'),
    "wrong_schema": (changed("/schema", "talus/case/9"), "/schema", "talus/case/9", "talus/case/1"),
    "not_an_object": ([1, 2, 3], "list", "object"),
    "unknown_material": (changed("/bodies/0/material", "sand"), "/bodies/0/material", "sand", "glass_beads"),
    "same_name_twice": (changed("/walls/1/name", "base"), "/walls/1/name", "base", "twice"),
    "polygon_in_space": (polygon_in_space(), "/bodies/0/shape", "polygon", "3"),
    "affine_with_linear": (changed("/kernel", {"type": "linear"}), "/transfer/type", "aflip", "linear", "pic or flip"),
    "unknown_measure": (changed("/expect", [{"measure": "centre_of_mas_x", "time": 0.05, "value": 0.1,
                                             "relative": 0.1, "because": "a typing error"}]),
                        "/expect/0/measure", "centre_of_mas_x", "centre_of_mass_x"),
    "mirror_that_leans": (mirror({"normal": [0.1, 1.0]}), "/walls/0/shape", "base", "across an axis"),
    "mirror_between_nodes": (mirror({"point": [0.0, 1e-3]}), "/walls/0/shape", "row of nodes", "multiple of the spacing"),
    "mirror_that_comes_nearer": (mirror({}, motion={"type": "translation", "velocity": [0.0, 0.1]}), "/walls/0/shape",
                                 "along itself"),
    "mirror_across_a_period": (changed("/grid/periods", [0, 0.8], mirror({})), "/walls/0/contact", "repeats"),
    "mirror_that_is_bent": (changed("/walls/0", {"name": "base", "contact": {"type": "mirrored_slip"}, "shape": {
        "type": "box", "min": [0.0, -1.0], "max": [1.0, 0.0]}}), "/walls/0/contact", "half_space", "box"),
    "station_turned_over": (station(max=[0.1, -0.1]), "/output/stations/1/max/1", "-0.1", "0.0"),
    "station_named_twice": (station(name="toe"), "/output/stations/1/name", "toe", "twice"),
    "station_named_as_a_path": (station(name="../toe"), "/output/stations/1/name", "../toe", "letter"),
    "station_across_the_plane": (station(depth={"type": "z"}), "/output/stations/1/depth", "plane"),
    "station_flows_upwards": (station(flow={"type": "y"}), "/output/stations/1/depth", "another"),
    "station_without_bins": (station(bins=0), "/output/stations/1/bins", "0", "1 <= x"),
    "station_longer_than_the_period": (changed("/grid/periods", [0.08, 0], station()), "/output/stations/1/max/0",
                                       "0.1", "0.08"),
    "end_of_time": (changed("/time/end", -1), "/time/end", "-1", ">= 0"),
}

# name: text, line:column of the fault, words
SYNTAX = {
    "duplicate_key": (text_with('"spacing": 0.02', '"spacing": 0.02, "spacing": 0.03'), None, "/grid/spacing", "twice"),
    "trailing_comma": ('{\n  "schema": "talus/case/1",\n}\n', "3:1", "comma"),
    "not_a_number": (text_with("0.02", "NaN"), None, "finite"),
    "too_large": (text_with("0.02", "1e400"), None, "too large"),
    "comment": ('{\n  // a dam\n  "schema": "talus/case/1"}', "2:3", "comment"),
    "cut_off": ('{"schema": "talus/case/1"', "1:26", "ends too early"),
    "single_quotes": ("{'schema': 1}", "1:2", "double quotes"),
    "deep": ("[" * 5000 + "]" * 5000, None, "nested"),
    "not_utf8": (b'{"schema": "\xff"}', None, "UTF-8"),
    "two_documents": ("{}\n{}", "2:1", "after the end"),
    "empty": ("", "", "empty"),
    "blanks": (" \n\t\n", "", "empty"),
}


class WrongDocuments(InFolder):
    def refused(self, document, name, words):
        """What the program says to the document, which must hold the words, name the file, and leave nothing behind."""
        for old in self.folder.iterdir():
            old.unlink()
        path = self.save(document, f"{name}.json")
        message = self.talus("check", path.name, code=3).stdout
        print(message.rstrip())
        for word in (f"{name}.json", *words):
            self.assertIn(word, message)
        run = self.talus("run", path.name, "-o", "it", code=3)
        self.assertIn(message.removeprefix("mistake: ").splitlines()[0], run.stderr)
        self.assertEqual([p.name for p in self.folder.iterdir()], [path.name], "a refused run left something behind")

    def test_wrong_values_are_refused_at_their_pointer(self):
        for name, (document, *words) in VALUES.items():
            with self.subTest(name):
                self.refused(document, name, words)

    def test_wrong_syntax_is_refused_at_its_line_and_column(self):
        for name, (text, place, *words) in SYNTAX.items():
            with self.subTest(name):
                if place:
                    words.append(f"{name}.json:{place}:")
                self.refused(text, name, words)

    def test_every_mistake_is_told_at_once(self):
        case = changed("/grid/spacing", 0, changed("/gravity/slope_deg", 1e3, changed("/walls/0/contact/type", "glue")))
        told = self.talus("check", self.save(case), code=3).stdout
        for pointer in ("/grid/spacing", "/gravity/slope_deg", "/walls/0/contact/type"):
            self.assertIn(pointer, told)

    def test_mistakes_are_found_in_the_base_of_a_study(self):
        wrong = changed("/base/materials/0/law/M", 1, study("dam_break_comparison"))
        self.assertIn("/base/materials/0/law/M", self.talus("check", self.save(wrong), code=3).stdout)

    def test_an_axis_of_a_study_must_lead_somewhere(self):
        wrong = changed("/axes/0/path", "/gravity/slope", study("dam_break_comparison"))
        told = self.talus("check", self.save(wrong), code=3).stdout
        self.assertIn("/gravity/slope", told)

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

    def test_what_is_set_on_the_command_line_is_judged_too(self):
        told = self.talus("run", self.save(DAM), "--set", "/grid/spacing=-1", code=3)
        self.assertIn("/grid/spacing", told.stderr)
        self.talus("run", self.save(DAM), "--set", "/grid/spaces=0.02", code=3)
        self.talus("run", self.save(DAM), "--set", "nonsense", code=3)

    def test_one_wrong_document_among_good_ones_is_found(self):
        good, wrong = self.save(DAM, "good.json"), self.save("{}", "wrong.json")
        told = self.talus("check", good, wrong, code=3).stdout
        self.assertIn("valid: " + str(good), told)
        self.assertNotIn("valid: " + str(wrong), told)

    def test_a_byte_order_mark_is_no_mistake(self):
        self.talus("check", self.save("\ufeff" + text_with("0.02", "0.02")))

    def test_our_own_documents_are_valid(self):
        for name in ("dam_break_22", "dam_break_comparison", "column_3d", "bagnold_column"):
            self.talus("check", self.save(study(name)))


if __name__ == "__main__":
    unittest.main()
