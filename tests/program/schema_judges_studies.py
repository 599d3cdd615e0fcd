#!/usr/bin/python3
"""A judge that is not ours (python3-jsonschema) reads the schema of `talus schema` as we do: our documents are valid, and
wrong ones are refused at the right place, inside laws, policies and the base of a study too."""
import json
import unittest

import jsonschema

from talus_process import STUDIES, changed, study, talus, without

# what is wrong, where the judge must point, the rule that is broken
WRONG = [
    (changed("/gravity/slope", 22), "/gravity", "additionalProperties"),
    (changed("/colour", "red"), "", "additionalProperties"),
    (changed("/materials/0/law/young", 1e6), "/materials/0/law", "additionalProperties"),
    (changed("/bodies/0/seeding/spacing", 1), "/bodies/0/seeding", "additionalProperties"),
    (changed("/walls/0/contact/friction", 0.3), "/walls/0/contact", "additionalProperties"),
    (changed("/kernel/order", 3), "/kernel", "additionalProperties"),
    (changed("/base/materials/0/law/young", 1e6, study("dam_break_comparison")), "/base/materials/0/law",
     "additionalProperties"),
    (changed("/base/colour", "red", study("dam_break_comparison")), "/base", "additionalProperties"),
    (changed("/axes/0/step", 1, study("dam_break_comparison")), "/axes/0", "additionalProperties"),
    (changed("/axes/0/values", [], study("dam_break_comparison")), "/axes/0/values", "minItems"),
    (changed("/grid/spacing", "0.02"), "/grid/spacing", "type"),
    (changed("/grid/spacing", 0), "/grid/spacing", "exclusiveMinimum"),
    (changed("/materials/0/law/poisson_ratio", 0.5), "/materials/0/law/poisson_ratio", "exclusiveMaximum"),
    (changed("/gravity/slope_deg", 181), "/gravity/slope_deg", "maximum"),
    (changed("/gravity/magnitude", -1), "/gravity/magnitude", "minimum"),
    (changed("/bodies/0/seeding/seed", 1.5), "/bodies/0/seeding/seed", "type"),
    (changed("/bodies/0/shape/min", ["0", 0]), "/bodies/0/shape/min/0", "type"),
    (changed("/bodies/0/shape/min", [0.0]), "/bodies/0/shape/min", "minItems"),
    (changed("/bodies", []), "/bodies", "minItems"),
    (changed("/transfer/type", "aflipp"), "/transfer/type", "enum"),
    (changed("/transfer", "aflip"), "/transfer", "type"),
    (changed("/kernel", None), "/kernel", "type"),
    (changed("/schema", "talus/case/9"), "/schema", "enum"),
    (without("/materials/0/density"), "/materials/0", "required"),
    (without("/transfer"), "", "required"),
    (without("/transfer/type"), "/transfer", "required"),
    ({}, "", "required"),
    ([], "", "type"),
]


def pointer(error):
    return "".join(f"/{part}" for part in error.absolute_path)


class Schema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.schema = json.loads(talus("schema").stdout)
        cls.judge = jsonschema.Draft7Validator(cls.schema)

    def test_it_is_a_schema_of_draft_7(self):
        self.assertEqual(self.schema["$schema"], "http://json-schema.org/draft-07/schema#")
        jsonschema.Draft7Validator.check_schema(self.schema)

    def test_all_our_documents_are_valid(self):
        files = sorted(STUDIES.glob("*.json"))
        self.assertGreater(len(files), 3)
        for file in files:
            with self.subTest(file.name):
                self.assertEqual([e.message for e in self.judge.iter_errors(json.loads(file.read_text()))], [])

    def test_wrong_documents_are_refused_where_they_are_wrong(self):
        for document, where, rule in WRONG:
            found = [(pointer(e), e.validator, e.message[:200]) for e in self.judge.iter_errors(document)]
            with self.subTest(where=where, rule=rule):
                self.assertIn((where, rule), [f[:2] for f in found], found)

    def test_a_document_with_one_mistake_gets_one_complaint(self):
        for document, where, rule in WRONG:
            if rule in ("additionalProperties", "exclusiveMinimum", "exclusiveMaximum", "maximum", "minimum"):
                with self.subTest(where=where, rule=rule):
                    self.assertEqual(len(list(self.judge.iter_errors(document))), 1)

    def test_every_policy_that_is_listed_is_in_the_schema(self):
        text = json.dumps(self.schema)
        for kind, policies in json.loads(talus("list", "--json").stdout).items():
            for policy in policies:
                with self.subTest(kind=kind, policy=policy["name"]):
                    self.assertIn(json.dumps(policy["name"]), text)


if __name__ == "__main__":
    unittest.main()
