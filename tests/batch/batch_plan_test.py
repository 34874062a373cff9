"""Tests of batch/batch_plan.py."""

import os
import unittest

from batch_case import BatchCase
import batch_plan
from people_table import TableError


class BatchPlan(BatchCase):
    def setUp(self):
        super().setUp()
        self.write("shirt.toml", "chest = {chest}\n")
        self.out = self.folder / "out"

    def make(self, *rows):
        table = self.write("people.csv", "\n".join(("person,scene,chest", *rows)) + "\n")
        return batch_plan.make(table, self.out)

    def test_the_plan_that_is_read_is_the_one_that_was_made(self):
        plan = self.make("anna,shirt.toml,0.9")
        self.assertEqual([row["person"] for row in plan], ["anna"])
        self.assertEqual(batch_plan.read(self.out), plan)
        self.assertEqual((self.out / "anna/shirt.toml").read_text(), "chest = 0.9\n")

    def test_only_scenes_that_changed_are_written_again(self):
        self.make("anna,shirt.toml,0.9", "bert,shirt.toml,1.0")
        scenes = [self.out / name / "shirt.toml" for name in ("anna", "bert")]
        for scene in scenes:
            os.utime(scene, (1, 1))
        self.make("anna,shirt.toml,0.9", "bert,shirt.toml,1.1", "carl,shirt.toml,1.0")
        self.assertEqual([scene.stat().st_mtime == 1 for scene in scenes], [True, False])

    def test_a_wrong_table_writes_nothing(self):
        self.refused(TableError, lambda: self.make("anna,shirt.toml,0.9", "bert,shirt.toml,"), "row 3, column chest")
        self.assertFalse(self.out.exists())


unittest.main()
