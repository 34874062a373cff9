"""Tests of batch/ease_job.py, with small shell scripts in the place of Ease."""

import json
import pathlib
import signal
import subprocess
import sys
import time
import unittest

from batch_case import ROOT, BatchCase


class EaseJob(BatchCase):
    def command(self, script, command="run"):
        program = self.write("ease", f"#!/bin/sh\n{script}\n")
        program.chmod(0o755)
        arguments = {"ease": program, "scene": "shirt.toml", "results": self.folder / "shirt", "threads": 1,
                     "log": self.folder / "shirt.log", "outcome": self.folder / f"shirt.{command}.json"}
        return [sys.executable, ROOT / "batch/ease_job.py", command,
                *(str(part) for name, value in arguments.items() for part in (f"--{name}", value))]

    def job(self, script, command="run"):
        """(exit code, outcome or None)."""
        code = subprocess.run(self.command(script, command), stderr=subprocess.DEVNULL).returncode
        return code, self.outcome(command)

    def outcome(self, command="run"):
        file = pathlib.Path(self.folder, f"shirt.{command}.json")
        return json.loads(file.read_text()) if file.exists() else None

    def test_ease_is_called_with_scene_results_and_threads(self):
        code, outcome = self.job('echo "$@"')
        self.assertEqual((code, outcome["exit_code"], outcome["reason"]), (0, 0, ""))
        self.assertEqual((self.folder / "shirt.log").read_text(),
                         f"run shirt.toml -o {self.folder}/shirt --threads 1\n")

    def test_what_ease_refuses_is_an_outcome_with_its_reason(self):
        code, outcome = self.job('echo "ease: error: chest = 9: too much" >&2; echo more; exit 1')
        self.assertEqual((code, outcome["exit_code"], outcome["reason"]), (0, 1, "chest = 9: too much"))

    def test_a_doubtful_run_is_an_outcome_with_its_doubt(self):
        code, outcome = self.job('echo "stretch not to be trusted: the garment left the body"; echo done; exit 3')
        self.assertEqual((code, outcome["exit_code"]), (0, 3))
        self.assertEqual(outcome["reason"], "stretch not to be trusted: the garment left the body")

    def test_a_killed_job_leaves_no_outcome_so_that_it_is_tried_again(self):
        code, outcome = self.job("kill -9 $$")
        self.assertEqual((code, outcome), (137, None))
        self.assertIn("ended by signal 9", (self.folder / "shirt.log").read_text())

    def test_a_job_whose_results_another_run_holds_is_tried_again(self):
        code, outcome = self.job('echo "ease: error: x: another run writes into this directory: wait"; exit 1')
        self.assertEqual((code, outcome), (1, None))

    def test_a_signal_is_handed_on_and_ease_ends_in_order(self):
        begun = self.folder / "begun"
        script = (f"trap 'echo \"ease: interrupted: nothing was written\"; exit 130' TERM\n"
                  f"touch {begun}; sleep 20 & wait $!")
        process = subprocess.Popen(self.command(script), stderr=subprocess.DEVNULL)
        while not begun.exists():
            time.sleep(0.01)
        process.send_signal(signal.SIGTERM)
        self.assertEqual((process.wait(10), self.outcome()), (130, None))
        self.assertIn("interrupted", (self.folder / "shirt.log").read_text())

    def test_no_pattern_is_made_of_a_failed_or_doubtful_run(self):
        for exit_code, why in ((1, "the run failed"), (3, "the fit is doubtful")):
            self.write("shirt.run.json", {"exit_code": exit_code})
            code, outcome = self.job("exit 2", "pattern")
            self.assertEqual((code, outcome["exit_code"], outcome["reason"]), (0, None, f"no pattern: {why}"))

    def test_a_pattern_is_made_of_a_finished_run(self):
        self.write("shirt.run.json", {"exit_code": 0})
        self.assertEqual(self.job("exit 0", "pattern")[1]["exit_code"], 0)
        self.assertTrue((self.folder / "shirt.log").read_text() == "")

    def test_a_program_that_is_not_there_is_told(self):
        command = self.command("exit 0")
        command[command.index("--ease") + 1] = "/nowhere/ease"
        ended = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual(ended.returncode, 1)
        self.assertIn("/nowhere/ease: No such file or directory", ended.stderr)


unittest.main()
