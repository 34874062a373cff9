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

    def test_faster_is_none(self):
        self.assertEqual(self.compare({NAME: (TIMES, {})}, {NAME: ([0.5 * t for t in TIMES], {})}).returncode, 0)

    def test_less_accurate_is_one(self):
        run = self.compare({NAME: (TIMES, {"error": 0.01})}, {NAME: (TIMES, {"error": 0.03})})
        self.assertEqual(run.returncode, 1)
        self.assertIn("less accurate (0.01 to 0.03)", run.stdout)

    def test_errors_within_round_off_are_not_compared(self):
        for was, now, code in ((1e-13, 9e-7, 0), (1e-13, 3e-6, 1), (0.01, 0.019, 0)):
            run = self.compare({NAME: (TIMES, {"error": was})}, {NAME: (TIMES, {"error": now})})
            self.assertEqual(run.returncode, code, run.stdout)

    def test_of_the_hanging_sheet_the_energy_counts_and_positions_do_not(self):
        name = "step/sheet:hanging/n:1024/method:auto/tolerance:0.05"
        before = {name: (TIMES, {"error": 0.01, "energy_gap": 0.001})}
        self.assertEqual(self.compare(before, {name: (TIMES, {"error": 0.5, "energy_gap": 0.002})}).returncode, 0)
        self.assertEqual(self.compare(before, {name: (TIMES, {"error": 0.5, "energy_gap": -0.1})}).returncode, 0)
        run = self.compare(before, {name: (TIMES, {"error": 0.01, "energy_gap": 0.02})})
        self.assertEqual(run.returncode, 1)
        self.assertIn("less accurate (0.001 to 0.02)", run.stdout)

    def test_a_single_run_has_noise(self):
        name = "fps/body:mannequin/n:100000/method:auto"
        self.assertEqual(self.compare({name: ([10.0], {})}, {name: ([13.0], {})}).returncode, 0)
        run = self.compare({name: ([10.0], {})}, {name: ([14.0], {})})
        self.assertEqual(run.returncode, 1)
        self.assertIn("1.400   1.120  1.750", run.stdout)

    def test_of_three_runs_all_must_be_slower(self):
        name = "fps/body:mannequin/n:1000/method:auto"
        before = {name: ([10.0, 10.0, 10.0], {})}
        self.assertEqual(self.compare(before, {name: ([13.0, 10.5, 14.0], {})}).returncode, 0)
        self.assertEqual(self.compare(before, {name: ([13.0, 12.0, 14.0], {})}).returncode, 1)

    def test_of_the_stability_map_grades_are_compared_and_times_are_not(self):
        name = "stability/sheet:taut/n:256/k:100/h:0.01/method:pd"
        self.assertEqual(self.compare({name: ([1e-3], {"grade": 1})}, {name: ([5e-3], {"grade": 2})}).returncode, 0)
        run = self.compare({name: ([1e-3], {"grade": 2})}, {name: ([1e-3], {"grade": 1})})
        self.assertEqual(run.returncode, 1)
        self.assertIn("converged before, degraded now", run.stdout)

    def test_of_damaged_inputs_more_crashes_are_one_and_longer_times_are_none(self):
        def tried(ms, crashes):
            return {"fuzz/input:run_OBJ": ([ms], {"crashes": crashes, "hangs": 0, "unclear": 1})}

        self.assertEqual(self.compare(tried(1.0, 1), tried(9.0, 1)).returncode, 0)
        run = self.compare(tried(1.0, 1), tried(1.0, 2))
        self.assertEqual(run.returncode, 1)
        self.assertIn("more crashes", run.stdout)

    def test_a_rest_state_that_agrees_no_more_is_one(self):
        name = "rest/sheet:drape-2pin/n:1024/method:auto/tolerance:0.05"
        run = self.compare({name: ([1.0], {"agrees": 1.0})}, {name: ([1.0], {"agrees": 0.0})})
        self.assertEqual(run.returncode, 1)
        self.assertIn("agrees no more", run.stdout)

    def test_what_is_not_tried_is_neither_failed_nor_compared(self):
        untried = {NAME: "not tried: a looser setting takes more than 0.1 s a step"}
        for before, after, where in (({NAME: (TIMES, {})}, untried, "B"), (untried, {NAME: (TIMES, {})}, "A"),
                                     (untried, {NAME: "not positive definite"}, "A")):
            run = self.compare(before, after)
            self.assertEqual(run.returncode, 0, run.stdout)
            self.assertIn(f"not tried in {where}", run.stdout)

    def test_runs_left_out_since_others_took_long_enough_do_not_count(self):
        enough = "not repeated: 3 runs took long enough"
        run = self.compare({NAME: ([1.0, 1.0, 1.0, enough], {})}, {NAME: ([1.0, 1.0, enough, enough], {})})
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertIn("1.000   1.000  1.000", run.stdout)

    def test_a_case_one_of_whose_runs_fails_now_is_one(self):
        run = self.compare({NAME: (TIMES, {})}, {NAME: ([*TIMES[1:], "a position is not finite"], {})})
        self.assertEqual(run.returncode, 1)
        self.assertIn("fails now: a position is not finite", run.stdout)

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
