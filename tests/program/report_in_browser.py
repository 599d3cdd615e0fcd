#!/usr/bin/python3
"""The report of the verification suite in a browser: its table, filters and plots work, it is quiet, and it asks the
network for nothing. Pictures of it are left in report_in_browser/, in the folder that the test runs in."""
import copy
import json
import pathlib
import re
import sys
import unittest

import browser
from talus_process import InFolder

EMBEDDED = re.compile(r'(<script type="application/json" id="results">)(.*?)(</script>)', re.DOTALL)
ROWS = "document.querySelectorAll('#all-rows tbody tr').length"
SKIPPED = 77  # as tests/CMakeLists.txt tells ctest


def row(subject, measure, found, verdict, **members):
    return {"subject": subject, "measure": measure, "unit": "m", "found": found, "verdict": verdict,
            "allowed": {"low": 1.85}, "uncertainty": {"low": 1.9, "high": 2.1}, "because": "lumped mass: 2",
            "cost": {"seconds": 0.25, "steps": 100, "particle_steps": 8.1e6}, **members}


def plotted(kernel, k):
    spacings = [1 / 16, 1 / 32, 1 / 64, 1 / 128]
    return {"name": f"{kernel}, apic", "x": spacings, "y": [(k + 1) * h ** 2 for h in spacings], "guide": False}


def worked(kernel, many, cells):
    return {"problem": "vortex", "error_name": "u", "kernel": kernel, "transfer": "apic", "per_direction": many,
            "cells": cells, "error": (3 if kernel == "linear" else 1) / cells ** 1.5,
            "cost": {"seconds": 1e-6 * many * cells ** 3, "steps": 10, "particle_steps": many * cells ** 2 * 10}}


def invented_case():
    """All that a case can have: every verdict, text that is markup, values that are no numbers, plots, work points."""
    kernels = ("linear", "quadratic", "cubic")
    rows = [row(f"{kernel}, apic", f"order of {name}", 1 + 0.1 * k, "pass") for k, kernel in enumerate(kernels)
            for name in "uvw"]
    rows += [row("<b>bold</b>", "</script><script>alert(1)</script>", None, "fail", found_status="nan", because="a|b"),
             row("quadratic, flip", "order of u", 0.4, "floored"), row("cubic, pic", "error of u", 1e-5, "noted"),
             row("linear, apic", "all", None, "omitted", found_status="nan"),
             row("the case", "ends", None, "error", found_status="nan", because="killed by signal 6")]
    guide = {"name": "order 2", "x": [1 / 16, 1 / 128], "y": [1 / 256, 1 / 16384], "guide": True}
    plot = {"title": "Vortex: u", "x_label": "h [m]", "y_label": "error of u [m]", "log_x": True, "log_y": True,
            "curves": [guide, *(plotted(kernel, k) for k, kernel in enumerate(kernels))]}
    history = {"title": "History", "x_label": "t [s]", "y_label": "stress [Pa]", "log_x": False, "log_y": False,
               "curves": [{"name": "gap", "x": [0, 1, 2, 3], "y": [-1e5, None, 2e5, 0], "guide": False}]}
    work = [worked(kernel, many, cells) for kernel in kernels for many in (2, 3) for cells in (16, 32, 64, 128)]
    return {"id": "invented/all", "title": "All that there can be", "truth": "what was invented", "tier": 2,
            "source": "Nobody (2015), doi:10.1000/xyz-123.", "seconds": 75.2, "processor_seconds": 74.1,
            "peak_memory": 5_000_000, "green": False, "rows": rows, "plots": [plot, history], "work": work}


def with_invented_case(results):
    results = copy.deepcopy(results)
    case = invented_case()
    results["cases"].append(case)
    results["green"] = False
    for one in case["rows"]:
        results["totals"][one["verdict"]] += 1
    changes = [{"case": "invented/all", "subject": one["subject"], "measure": one["measure"], "unit": "m",
                "found": one["found"], "earlier": 1.0, "verdict": one["verdict"], "earlier_verdict": "pass",
                "text": "+1.00 %"} for one in case["rows"]]
    gone = {"case": "invented/all", "subject": "cubic", "measure": "gone", "unit": "1", "found": None, "earlier": 2.0,
            "earlier_verdict": "pass", "text": "gone"}
    results["against"] = {"folder": "before", "version": "0.0.9", "start": "2024-05-31T12:00:00Z",
                          "not_run": ["other/case"], "changes": [*changes, gone]}
    return results


class ReportInBrowser(InFolder):
    @classmethod
    def setUpClass(cls):
        cls.browser = browser.Browser()
        cls.addClassCleanup(cls.browser.close)
        cls.pictures = pathlib.Path.cwd() / "report_in_browser"
        cls.pictures.mkdir(exist_ok=True)

    def setUp(self):
        super().setUp()
        cases = json.loads(self.talus("verify", "--list", "--json").stdout)
        smallest = min(cases, key=lambda case: (case["tier"], case["budget"]))
        self.talus("verify", smallest["id"], "-q", "-o", "out")
        self.results = self.read("out", "results.json")
        self.path = self.folder / "out" / "report.html"

    def open_invented(self):
        self.results = with_invented_case(self.results)
        text = json.dumps(self.results).replace("<", "\\u003c")
        page = EMBEDDED.sub(lambda found: found[1] + text + found[3], self.path.read_text(encoding="utf-8"))
        self.path.write_text(page, encoding="utf-8")
        self.browser.open(self.path)

    def tearDown(self):
        ask = self.browser.ask
        said = [event for event in self.browser.events if event["method"] in
                ("Runtime.exceptionThrown", "Runtime.consoleAPICalled", "Log.entryAdded")]
        self.assertEqual(said, [])
        asked = [request["request"]["url"] for request in self.browser.told("Network.requestWillBeSent")]
        self.assertEqual([url for url in asked if not url.startswith(("data:", self.path.as_uri()))], [])
        self.assertEqual(self.browser.told("Page.javascriptDialogOpening"), [])
        self.assertEqual(ask("performance.getEntriesByType('resource').length"), 0)

    def column(self, number):
        return self.browser.ask(
            f"[...document.querySelectorAll('#all-rows tbody tr')].map(r => r.children[{number}].textContent)")

    def count_rows(self):
        return sum(len(case["rows"]) for case in self.results["cases"])

    def test_a_real_report_shows_every_row_and_plot(self):
        self.browser.open(self.path)
        self.assertEqual(self.browser.ask(ROWS), self.count_rows())
        self.assertEqual(self.browser.ask("document.querySelectorAll('.case figure svg[role=img]').length"),
                         sum(len(case["plots"]) for case in self.results["cases"]))
        (self.pictures / "real.png").write_bytes(self.browser.look(1280, 900))

    def test_rows_are_filtered_and_sorted(self):
        self.open_invented()
        ask = self.browser.ask
        self.assertEqual(ask(ROWS), self.count_rows())
        ask("{const f = document.querySelector('#filter'); f.value = 'cubic ORDER'; f.dispatchEvent(new Event('input'));}")
        self.assertTrue(0 < ask(ROWS) < self.count_rows())
        self.assertTrue(all("cubic" in subject for subject in self.column(1)))
        ask("{const f = document.querySelector('#filter'); f.value = ''; f.dispatchEvent(new Event('input'));}")
        ask("document.querySelector('.tile.floored').click()")
        self.assertEqual(set(self.column(6)), {"FLOORED"})
        for select, value in ((0, "not green"), (0, ""), (2, "invented/all")):
            ask(f"{{const s = document.querySelectorAll('.filters select')[{select}]; s.value = '{value}';"
                "s.dispatchEvent(new Event('change'));}")
            if value == "not green":
                self.assertTrue({"FAIL", "FLOORED", "ERROR"} >= set(self.column(6)))
        self.assertEqual(set(self.column(0)), {"invented/all"})
        before = self.column(3)
        ask("document.querySelectorAll('#all-rows th button')[3].click()")
        rising = self.column(3)
        ask("document.querySelectorAll('#all-rows th button')[3].click()")
        falling = self.column(3)
        self.assertNotEqual(before, rising)
        self.assertNotEqual(rising, falling)
        numbers = [float(text.split()[0]) for text in rising if text and text != "–"]
        self.assertEqual(numbers, sorted(numbers))

    def test_plots_are_drawn_and_curves_hidden(self):
        self.open_invented()
        ask = self.browser.ask
        figure = "document.querySelector('#case-invented-all figure')"
        self.assertEqual(ask(f"{figure}.querySelectorAll('g.curve').length"), 4)
        self.assertEqual(ask(f"{figure}.querySelectorAll('g.curve .point').length"), 12)
        self.assertNotIn("NaN", ask(f"{figure}.innerHTML"))
        box = ask(f"(b => [b.width, b.height])({figure}.querySelector('g.curve .line').getBoundingClientRect())")
        self.assertTrue(box[0] > 100 and box[1] > 50, box)
        ask(f"{figure}.querySelectorAll('.legend button')[1].click()")
        self.assertEqual(ask(f"getComputedStyle({figure}.querySelectorAll('g.curve')[1]).display"), "none")
        ask(f"{figure}.scrollIntoView()")
        x, y = ask(f"(b => [b.x + b.width / 2, b.y + b.height / 2])({figure}.querySelectorAll('g.curve')[2]"
                   ".querySelectorAll('.point')[1].getBoundingClientRect())")
        self.browser.send("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)
        self.assertIn("quadratic, apic", ask(f"{figure}.querySelector('.note').textContent"))
        self.assertEqual(ask("document.querySelectorAll('.cheapest tbody tr').length"), 5)
        self.assertEqual(ask("document.querySelectorAll('#work g.front').length"), 1)

    def test_text_stays_text_and_a_doi_is_a_link(self):
        self.open_invented()
        ask = self.browser.ask
        self.assertEqual(ask("document.querySelectorAll('main b').length"),
                         ask("document.querySelectorAll('.tile b, .note b, li b').length"))
        self.assertIn("</script><script>", ask("document.querySelector('#all-rows').textContent"))
        self.assertEqual(ask("document.querySelector('#case-invented-all a').href"), "https://doi.org/10.1000/xyz-123")
        self.assertIn("other/case", ask("document.querySelector('#against').textContent"))

    def test_pictures_of_it_in_light_dark_and_narrow(self):
        self.open_invented()
        for name, width, dark in (("light", 1280, False), ("dark", 1280, True), ("narrow", 420, False)):
            (self.pictures / f"{name}.png").write_bytes(self.browser.look(width, 1000, dark, whole=True))
            self.assertLessEqual(self.browser.ask("document.documentElement.scrollWidth"), width)
            colour = self.browser.ask("getComputedStyle(document.body).backgroundColor")
            self.assertEqual(colour == "rgb(255, 255, 255)", not dark)


if __name__ == "__main__":
    if browser.program() is None:
        print("skipped: there is no chromium; './talus setup develop' installs it")
        sys.exit(SKIPPED)
    unittest.main()
