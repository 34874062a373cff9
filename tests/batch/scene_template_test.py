"""Tests of batch/scene_template.py."""

import pathlib
import unittest

from batch_case import BatchCase
from scene_template import TemplateError, fill, names_in, parse, read_template

PATH = pathlib.Path("/somewhere/shirt.toml")


class SceneTemplate(BatchCase):
    def test_names_in_braces_are_filled_from_the_row(self):
        self.assertEqual(fill(PATH, "chest = {chest}\n", {"chest": "0.9"}), "chest = 0.9\n")

    def test_an_empty_cell_and_a_missing_column_take_the_default(self):
        self.assertEqual(fill(PATH, "limit = {limit:0.1}", {"limit": ""}), "limit = 0.1")
        self.assertEqual(fill(PATH, "limit = {limit:0.1}", {}), "limit = 0.1")
        self.assertEqual(fill(PATH, "limit = {limit:0.1}", {"limit": "0.2"}), "limit = 0.2")

    def test_inline_tables_of_toml_stay_as_they_are(self):
        text = "damping = { stretch = 20, shear = 2 }\nplane = {point=[0, 1, 0]}\n"
        self.assertEqual(fill(PATH, text, {}), text)
        self.assertEqual(names_in(text), set())

    def test_here_is_the_folder_of_the_template(self):
        self.assertEqual(fill(PATH, 'mesh = "{here}/shirt.obj"', {}), 'mesh = "/somewhere/shirt.obj"')

    def test_an_empty_cell_without_default_names_its_column(self):
        with self.assertRaises(TemplateError) as caught:
            fill(PATH, "chest = {chest}", {"chest": ""})
        self.assertEqual(caught.exception.column, "chest")

    def test_a_name_that_no_column_has_is_told_with_its_line_and_the_nearest_column(self):
        self.refused(TemplateError, lambda: fill(PATH, "[body]\nchest = {chst}", {"chest": "0.9"}),
                     "shirt.toml:2", "{chst}", "did you mean {chest}?")

    def test_a_cell_that_makes_no_toml_is_told_with_its_column(self):
        text = "[body]\nchest = {chest}\n"
        with self.assertRaises(TemplateError) as caught:
            parse(PATH, text, fill(PATH, text, {"chest": "wide"}))
        self.assertEqual(caught.exception.column, "chest")

    def test_a_relative_mesh_or_scan_is_refused_with_the_remedy(self):
        for scene in ('[garment]\nmesh = "shirt.obj"\n', '[body]\nposes = ["shirt.obj"]\n'):
            self.refused(TemplateError, lambda: parse(PATH, scene, scene), "'{here}/shirt.obj'")

    def test_poses_of_a_built_in_body_are_no_files(self):
        scene = '[body]\nbuiltin = "mannequin"\nposes = ["t"]\n'
        self.assertEqual(parse(PATH, scene, scene)["body"]["poses"], ["t"])

    def test_a_template_that_cannot_be_read_is_told(self):
        self.refused(TemplateError, lambda: read_template(self.folder / "none.toml"), "none.toml", "cannot be read")


unittest.main()
