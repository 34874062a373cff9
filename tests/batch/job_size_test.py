"""Tests of batch/job_size.py."""

import unittest

from batch_case import BatchCase
from job_size import memory_mb


class JobSize(BatchCase):
    def test_a_finer_garment_needs_more_memory(self):
        coarse, fine = ({"garment": {"builtin": "dress", "vertices": n}} for n in (1000, 50000))
        self.assertEqual(memory_mb(fine, []) - memory_mb(coarse, []), 980)

    def test_a_larger_mesh_or_scan_needs_more_memory(self):
        mesh = self.write("shirt.obj", " " * 350_000)
        self.assertEqual(memory_mb({"garment": {"mesh": str(mesh)}}, []), 900)
        self.assertEqual(memory_mb({"garment": {"mesh": str(mesh)}}, [str(mesh)] * 10), 935)

    def test_a_scene_that_ease_will_refuse_has_a_size_too(self):
        for scene in ({}, {"garment": 3}, {"garment": {"vertices": "many"}}, {"garment": {"mesh": "/nowhere.obj"}}):
            self.assertEqual(memory_mb(scene, []), 760)


unittest.main()
