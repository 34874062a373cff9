#!/usr/bin/env python3
"""bench/compare.py: what counts as a regression, and what doesn't."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from results_of import results_of

COMPARE = Path(__file__).parent.parent.parent / "bench" / "compare.py"
NAME = "step/sheet:taut/n:1024/method:auto/tolerance:0.05"
TIMES = [1.0, 4.0, 2.0, 8.0, 1.5, 1.2]  # of unequal steps


class Compare(unittest.TestCase):
    def compare(self, before, after, folders=True):
        with tempfile.TemporaryDirectory() as directory:
            given = []
            for name, cases in (("a", before), ("b", after)):
                file = Path(directory) / f"{name}.json"
                if folders:
                    file = Path(directory) / name / "bench.json"
                    file.parent.mkdir()
                file.write_text(json.dumps(results_of(cases)), encoding="utf-8")
                given.append(str(file.parent if folders else file))
            return subprocess.run([sys.executable, str(COMPARE), *given], capture_output=True, text=True, check=False)

    def test_the_same_times_are_no_regression(self):
        run = self.compare({NAME: (TIMES, {"error": 0.01})}, {NAME: (TIMES, {"error": 0.01})})
        self.assertEqual(run.returncode, 0)
        self.assertIn("0 regressions beyond the noise in 1 cases", run.stdout)

    def test_two_files_may_have_any_names(self):
        run = self.compare({NAME: (TIMES, {})}, {NAME: (TIMES, {})}, folders=False)
        self.assertEqual(run.returncode, 0, run.stderr)

    def test_a_third_slower_in_every_run_is_one(self):
        run = self.compare({NAME: (TIMES, {})}, {NAME: ([1.33 * t for t in TIMES], {})})
        self.assertEqual(run.returncode, 1)
        self.assertIn("1.330", run.stdout)
        self.assertIn("slower", run.stdout)

    def test_one_run_that_was_disturbed_is_none(self):
        run = self.compare({NAME: (TIMES, {})}, {NAME: ([10.0 * TIMES[0], *TIMES[1:]], {})})
        self.assertEqual(run.returncode, 0)

    def test_sooner_is_none(self):
        self.assertEqual(self.compare({NAME: (TIMES, {})}, {NAME: ([0.5 * t for t in TIMES], {})}).returncode, 0)

    def test_less_accurate_is_one(self):
        run = self.compare({NAME: (TIMES, {"error": 0.01})}, {NAME: (TIMES, {"error": 0.02})})
        self.assertEqual(run.returncode, 1)
        self.assertIn("less accurate (0.01 to 0.02)", run.stdout)

    def test_a_case_that_fails_now_is_one(self):
        run = self.compare({NAME: (TIMES, {})}, {NAME: "not positive definite"})
        self.assertEqual(run.returncode, 1)
        self.assertIn("fails now: not positive definite", run.stdout)

    def test_nothing_in_common_is_an_error(self):
        run = self.compare({NAME: (TIMES, {})}, {NAME + "1": (TIMES, {})})
        self.assertEqual(run.returncode, 2)
        self.assertIn("no case in common", run.stderr)


if __name__ == "__main__":
    unittest.main()
