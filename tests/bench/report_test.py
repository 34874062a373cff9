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
COUNTERS = ("largest_mm", "sigma_1_max_error", "sigma_1_p99_error", "energy_gap", "residual_m_s2", "setup_ms")
TRAJECTORY = "trajectory/sheet:taut/n:1024/k:500/h:0.01667/method:"
SCENE = "step/sheet:taut/n:1024/k:500/h:0.01667/method:"


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.directory = Path(cls.scratch.name)
        cases = {
            SCENE + "newton/residual:0.01": ([8.0, 10.0, 15.0], {"error": 1e-4}),
            SCENE + "auto/tolerance:0.05": ([1.0, 2.0, 6.0], {"error": 0.05, **dict.fromkeys(COUNTERS, 0.125),
                                                              "setup_ms": 22.0}),
            SCENE + "auto/tolerance:0.001": ([4.0, 4.0, 4.0], {"error": 1e-3}),
            SCENE + "pd/iterations:10": ([4.0, 4.0, 4.0], {"error": 0.05}),
            SCENE + "pd/iterations:100": "the projective system is not positive definite",
            SCENE + "pd-anderson/iterations:5": ([1.0, 1.0, 1.0], {"error": 0.05}),
            TRAJECTORY + "auto/tolerance:0.05": ([30.0, 50.0, "not repeated: 2 runs took long enough"],
                                                 {"error": 0.05, "method_error": 1e-3}),
        }
        (cls.directory / "run.tsv").write_text("speed_accuracy\tspeed_accuracy --quick\t77\n", encoding="utf-8")
        (cls.directory / "speed_accuracy.json").write_text(json.dumps(results_of(cases)), encoding="utf-8")
        cls.run_ = subprocess.run([sys.executable, str(REPORT), str(cls.directory)], capture_output=True, text=True,
                                  check=False)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_it_ends_well(self):
        self.assertEqual(self.run_.returncode, 0, self.run_.stderr)

    def test_a_claim_that_does_not_hold_is_told_and_ends_it_with_1(self):
        place = "stability/sheet:taut/n:256/k:100/h:0.2/method:auto"
        for grade, code in ((2, 0), (1, 1)):
            with tempfile.TemporaryDirectory() as directory:
                cases = {place: ([1.0], {"grade": grade, "error": 0.2, "worst": 0.3})}
                (Path(directory) / "stability.json").write_text(json.dumps(results_of(cases)), encoding="utf-8")
                run = subprocess.run([sys.executable, str(REPORT), directory], capture_output=True, text=True,
                                     check=False)
                self.assertEqual(run.returncode, code, run.stderr)
                self.assertEqual(place in run.stderr, code == 1)
                self.assertIn(place if code else "refutes: none", (Path(directory) / "report.html").read_text())

    def test_the_csv_has_medians_and_settings(self):
        with open(self.directory / "speed_accuracy.csv", newline="", encoding="utf-8") as stream:
            rows = {row["name"]: row for row in csv.DictReader(stream)}
        row = rows[SCENE + "auto/tolerance:0.05"]
        self.assertEqual(float(row["ms_median"]), 2.0)
        self.assertEqual(float(row["ms_mean"]), 3.0)
        self.assertEqual((int(row["runs"]), float(row["error_upper_quartile"])), (3, 0.05))
        self.assertEqual((row["method"], float(row["n"]), float(row["tolerance"])), ("auto", 1024.0, 0.05))
        self.assertEqual(float(rows[SCENE + "newton/residual:0.01"]["ms_mean"]), 11.0)
        self.assertEqual(rows[TRAJECTORY + "auto/tolerance:0.05"]["runs"], "2")
        self.assertEqual(rows[TRAJECTORY + "auto/tolerance:0.05"]["error_message"], "")
        self.assertEqual(float(rows[SCENE + "pd/iterations:10"]["iterations"]), 10.0)
        self.assertIn("not positive definite", rows[SCENE + "pd/iterations:100"]["error_message"])

    def test_the_page_holds_the_chart_and_times_at_equal_error(self):
        page = (self.directory / "report.html").read_text(encoding="utf-8")
        self.assertIn("<svg", page)
        self.assertNotIn("<img", page)
        # Medians at .1: newton 10 ms; auto 2 ms, .2 of it; pd 4 ms; pd-anderson 1 ms.  auto is the fastest but for the
        # last, which no scene can ask for.
        self.assertIn("<td>0.1</td><td>10</td><td>1.00</td><td>0.20</td><td>0.40</td><td>0.10</td><td>1.00</td>", page)

    def test_the_page_holds_other_errors_setting_up_and_trajectories(self):
        page = (self.directory / "report.html").read_text(encoding="utf-8")
        self.assertIn("<td>0.1</td><td>0.05</td><td>0.05</td><td>0.12</td><td>0.12</td><td>0.12</td>", page)
        # (22 ms + 99 steps of 2 ms) / 100
        self.assertIn("<td>22</td><td>2</td><td>2.2</td><td>1.10</td>", page)
        self.assertIn("<td>0.1</td><td>40 (1/60)</td><td>2 to 2</td>", page)

    def test_the_page_says_what_it_was_measured_with(self):
        page = (self.directory / "report.html").read_text(encoding="utf-8")
        self.assertIn("<td>speed_accuracy</td><td>speed_accuracy --quick</td><td>77</td><td>today</td><td>0.50</td>",
                      page)
        self.assertIn("commit abc123, something changed since", page)
        self.assertIn("libcholmod.so.3.0.14, libtbb.so.12.8", page)

    def test_the_chart_is_there_as_svg_and_png_with_a_mark_for_what_failed(self):
        svg = (self.directory / "step_taut_1024_error.svg").read_text(encoding="utf-8")
        self.assertIn("failed", svg)
        self.assertTrue((self.directory / "step_taut_1024_error.png").read_bytes().startswith(b"\x89PNG"))


if __name__ == "__main__":
    if not shutil.which("gnuplot"):
        print("skipped: there is no gnuplot")
        sys.exit(77)
    unittest.main()
