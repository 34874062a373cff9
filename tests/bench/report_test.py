#!/usr/bin/env python3
"""bench/report.py: charts, tables and one page that needs nothing else."""

import csv
import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from results_of import results_of

REPORT = Path(__file__).parent.parent.parent / "bench" / "report.py"
SCENE = "step/sheet:taut/n:1024/k:500/h:0.01667/method:"


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.directory = Path(cls.scratch.name)
        cases = {
            SCENE + "newton/residual:0.01": ([8.0, 8.0, 14.0], {"error": 1e-4}),
            SCENE + "auto/tolerance:0.05": ([1.0, 2.0, 3.0], {"error": 0.05}),
            SCENE + "auto/tolerance:0.001": ([4.0, 4.0, 4.0], {"error": 1e-3}),
            SCENE + "pd/iterations:10": ([4.0, 4.0, 4.0], {"error": 0.05}),
            SCENE + "pd/iterations:100": "the projective system is not positive definite",
        }
        (cls.directory / "speed_accuracy.json").write_text(json.dumps(results_of(cases)), encoding="utf-8")
        cls.run_ = subprocess.run([sys.executable, str(REPORT), str(cls.directory)], capture_output=True, text=True,
                                  check=False)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_it_ends_well(self):
        self.assertEqual(self.run_.returncode, 0, self.run_.stderr)

    def test_the_csv_has_medians_and_settings(self):
        with open(self.directory / "speed_accuracy.csv", newline="", encoding="utf-8") as stream:
            rows = {row["name"]: row for row in csv.DictReader(stream)}
        row = rows[SCENE + "auto/tolerance:0.05"]
        self.assertEqual(float(row["ms_median"]), 2.0)
        self.assertEqual(float(row["ms_mean"]), 2.0)
        self.assertEqual((row["method"], float(row["n"]), float(row["tolerance"])), ("auto", 1024.0, 0.05))
        self.assertEqual(float(rows[SCENE + "newton/residual:0.01"]["ms_mean"]), 10.0)
        self.assertEqual(float(rows[SCENE + "pd/iterations:10"]["iterations"]), 10.0)
        self.assertIn("not positive definite", rows[SCENE + "pd/iterations:100"]["error_message"])

    def test_the_page_holds_the_chart_and_times_at_equal_error(self):
        page = (self.directory / "report.html").read_text(encoding="utf-8")
        self.assertIn("<svg", page)
        self.assertNotIn("<img", page)
        # At .1: newton 10 ms; pd 4 ms, .4 of it; auto 2 ms, .2 of it, which is the soonest.
        self.assertIn("<td>0.1</td><td>10</td><td>1.00</td><td>0.20</td><td>0.40</td><td>1.00</td>", page)

    def test_the_chart_is_there_as_svg_and_png_with_a_mark_for_what_failed(self):
        svg = (self.directory / "step_taut_1024_error.svg").read_text(encoding="utf-8")
        self.assertIn("failed", svg)
        self.assertTrue((self.directory / "step_taut_1024_error.png").read_bytes().startswith(b"\x89PNG"))


if __name__ == "__main__":
    if not shutil.which("gnuplot"):
        print("skipped: there is no gnuplot")
        sys.exit(77)
    unittest.main()
