"""Tests of batch/batch_summary.py."""

import csv
import os
import time
import unittest

from batch_case import BatchCase
from batch_summary import COLUMNS, summarise

REPORT = {
    "sigma_1": {"limit": 1.1, "run": {"max": 1.3}, "before": {"max": 1.25, "share_over_limit": 0.2},
                "after": {"max": 1.099, "share_over_limit": 0.0005}},
    "adaption": {"target": 0.001},
    "rest_growth": {"max": 1.3, "area_ratio": 1.05},
    "warnings": ["loose <here>"],
    "pattern": {"pieces": [{}, {}], "warnings": ["one more seam"]},
}


class BatchSummary(BatchCase):
    def row(self, report=REPORT, run=None, pattern=None, wants_pattern=False, log=None):
        """(row of summary.csv, text of summary.html) of one garment."""
        if run is not None:
            self.write("anna/shirt.run.json", {"exit_code": run, "reason": "why" if run else "", "wall_s": 1.26})
            self.write("anna/shirt/report.json", report)
        if pattern is not None:
            self.write("anna/shirt.pattern.json", {"exit_code": pattern, "reason": "no seam", "wall_s": 2.0})
        if log is not None:
            self.write("anna/shirt.log", log)
        summarise([{"person": "anna", "garment": "shirt", "pattern": wants_pattern, "files": []}], self.folder)
        with open(self.folder / "summary.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual((len(rows), tuple(rows[0])), (1, COLUMNS))
        return rows[0], (self.folder / "summary.html").read_text()

    def test_a_garment_that_fits_has_its_figures_before_and_after(self):
        row, page = self.row(run=0, pattern=0, wants_pattern=True)
        self.assertEqual([row[name] for name in COLUMNS],
                         ["anna", "shirt", "fits", "", "1.100", "1.250", "1.099", "20.00", "0.05", "5.00", "1.300", "2",
                          "loose <here> | one more seam", "1.3", "2.0"])
        self.assertIn("1 garment of 1 person: 1 fits.", page)
        self.assertIn("1.250 → 1.099", page)
        self.assertIn("loose &lt;here&gt;", page)

    def test_a_garment_over_the_target_is_too_tight(self):
        sigma = REPORT["sigma_1"] | {"after": {"max": 1.2, "share_over_limit": 0.002}}
        adaption = {"target": 0.001, "reason": "all 2 passes were made"}
        row, _ = self.row(REPORT | {"sigma_1": sigma, "adaption": adaption}, run=0)
        self.assertEqual((row["result"], row["why"]), ("too tight", "all 2 passes were made"))

    def test_a_run_without_a_limit_is_simulated(self):
        report = {"sigma_1": {"run": {"max": 1.3}}, "rest_growth": {"max": 1.0, "area_ratio": 1.0}}
        row, _ = self.row(report, run=0)
        self.assertEqual((row["result"], row["stretch_after"], row["stretch_limit"]), ("simulated", "1.300", ""))

    def test_what_was_computed_before_an_input_changed_is_not_finished(self):
        self.row(run=0, pattern=0, wants_pattern=True, log="ease: error: earlier\n")
        late = time.time() + 5.0
        os.utime(self.folder / "anna/shirt.run.json", (late, late))  # run again, but no pattern since
        row, _ = self.row(wants_pattern=True)
        self.assertEqual((row["result"], row["why"], row["pieces"]), ("not finished", "pattern: not begun", ""))
        os.utime(self.write("anna/shirt.toml", ""), (late + 5.0, late + 5.0))
        row, _ = self.row(wants_pattern=True)
        self.assertEqual((row["result"], row["why"], row["stretch_after"]), ("not finished", "not begun", ""))

    def test_a_failed_row_says_why(self):
        row, page = self.row(run=1)
        self.assertEqual((row["result"], row["why"], row["stretch_after"]), ("failed", "why", ""))
        self.assertIn('class="result bad">failed', page)

    def test_a_doubtful_row_says_why(self):
        row, _ = self.row(run=3)
        self.assertEqual((row["result"], row["why"]), ("doubtful", "why"))

    def test_a_row_without_its_pattern_says_why(self):
        row, _ = self.row(run=0, pattern=1, wants_pattern=True)
        self.assertEqual((row["result"], row["why"]), ("no pattern", "no seam"))

    def test_a_row_that_was_stopped_is_not_finished_and_shows_its_last_words(self):
        self.assertEqual(self.row()[0]["why"], "not begun")
        row, _ = self.row(log=f"begin\nease: interrupted: what was written until then is in {self.folder}/anna/shirt\n")
        self.assertEqual((row["result"], row["why"]),
                         ("not finished", "interrupted: what was written until then is in anna/shirt"))

    def test_a_row_whose_pattern_is_missing_is_not_finished(self):
        row, _ = self.row(run=0, wants_pattern=True)
        self.assertEqual((row["result"], row["why"]), ("not finished", "pattern: not begun"))

    def test_pages_and_pictures_are_linked_where_they_are(self):
        _, page = self.row(run=0)
        self.assertNotIn("fit.html", page)
        self.write("anna/shirt/fit.html", "page")
        self.write("anna/shirt/stretch.png", "picture")
        _, page = self.row(run=0)
        self.assertIn('<a href="anna/shirt/fit.html">anna</a>', page)
        self.assertIn('<a href="anna/shirt/stretch.png"><img src="anna/shirt/stretch.png"', page)

    def test_messages_lose_the_folder_of_this_batch(self):
        report = REPORT | {"warnings": [f"{self.folder}/anna/shirt.toml: [body] too fast"]}
        self.assertEqual(self.row(report, run=0)[0]["warnings"], "[body] too fast")


unittest.main()
