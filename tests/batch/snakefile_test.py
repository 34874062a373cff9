"""Runs batch/Snakefile on a tiny table: snakefile_test.py EASE.  Ends with 77, skipped, where there is no Snakemake."""

import csv
import shutil
import subprocess
import sys
import unittest

from batch_case import ROOT, BatchCase

EASE = sys.argv.pop() if len(sys.argv) > 1 else "ease"
HANGING_CLOTH = """[garment]
mesh = "{here}/cloth.obj"
[[garment.pin]]
vertices = [2, 3]
[solver]
steps = {steps:4}
"""


class Snakefile(BatchCase):
    def setUp(self):
        super().setUp()
        self.write("cloth.obj", "v 0 1 0\nv 1 1 0\nv 0 2 0\nv 1 2 0\nf 1 2 4\nf 1 4 3\n")
        self.write("hang.toml", HANGING_CLOTH)

    def batch(self, *rows):
        """(exit code, {person: row of summary.csv}, what Snakemake said)."""
        self.write("people.csv", "\n".join(("person,scene,steps,pattern", *rows)) + "\n")
        command = ["snakemake", "-s", ROOT / "batch/Snakefile", "--profile", ROOT / "batch/local", "--cores", "2",
                   "--restart-times", "0", "--config", "table=people.csv", "out=out", f"ease={EASE}"]
        ended = subprocess.run(command, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        summary = self.folder / "out/summary.csv"
        rows = csv.DictReader(summary.read_text().splitlines()) if summary.exists() else []
        return ended.returncode, {row["person"]: row for row in rows}, ended.stdout

    def test_a_row_that_fails_does_not_stop_the_others_and_finished_rows_stay(self):
        code, rows, said = self.batch("anna,hang.toml,,no", "bert,hang.toml,-1,no")
        self.assertEqual(code, 0, said)
        self.assertEqual((rows["anna"]["result"], rows["bert"]["result"]), ("simulated", "failed"), said)
        self.assertIn("steps = -1", rows["bert"]["why"])

        report = self.folder / "out/anna/hang/report.json"
        time = report.stat().st_mtime_ns
        code, rows, said = self.batch("anna,hang.toml,,no", "bert,hang.toml,5,no", "carl,hang.toml,6,no")
        self.assertEqual((code, [row["result"] for row in rows.values()]), (0, ["simulated"] * 3), said)
        self.assertEqual(report.stat().st_mtime_ns, time, "anna's row had not changed")

    def test_a_job_that_leaves_no_outcome_is_shown_as_not_finished(self):
        (self.folder / "out").mkdir()
        self.write("out/anna/hang.run.json/file", "in the way")
        code, rows, said = self.batch("anna,hang.toml,,no", "bert,hang.toml,,no")
        self.assertNotEqual(code, 0)
        self.assertEqual((rows["anna"]["result"], rows["bert"]["result"]), ("not finished", "simulated"), said)

    def test_a_wrong_table_starts_nothing(self):
        code, _, said = self.batch("anna,hang.toml,,perhaps")
        self.assertNotEqual(code, 0)
        self.assertIn("people.csv: row 2, column pattern: 'perhaps'", said)
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    if not shutil.which("snakemake"):
        sys.exit(77)
    unittest.main()
