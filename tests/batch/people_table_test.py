"""Tests of batch/people_table.py."""

import unittest

from batch_case import BatchCase
from people_table import TableError, read_table

TEMPLATE = """[body]
builtin = "mannequin"
poses = ["t"]
chest = {chest}
[adaption]
limit = {limit:0.1}
"""


class PeopleTable(BatchCase):
    def setUp(self):
        super().setUp()
        self.write("shirt.toml", TEMPLATE)
        self.write("dress.toml", TEMPLATE)

    def read(self, text, name="people.csv"):
        return read_table(self.write(name, text))

    def refuses(self, text, *words):
        self.refused(TableError, lambda: self.read(text), "people.csv: ", *words)

    def test_a_row_becomes_a_scene(self):
        anna, bert = self.read("person,scene,chest,limit\nanna,shirt.toml,0.9,\nbert,shirt.toml,1.0,0.2\n")
        self.assertEqual((anna.person, anna.garment, anna.number, anna.pattern), ("anna", "shirt", 2, True))
        self.assertEqual((anna.parsed["body"]["chest"], anna.parsed["adaption"]["limit"]), (0.9, 0.1))
        self.assertEqual((bert.parsed["body"]["chest"], bert.parsed["adaption"]["limit"]), (1.0, 0.2))

    def test_tabs_semicolons_and_a_byte_order_mark_are_read(self):
        for name, delimiter in (("people.tsv", "\t"), ("people.csv", ";")):
            text = "\ufeffperson,scene,chest\n\nanna,shirt.toml,0.9\n".replace(",", delimiter)
            self.assertEqual(self.read(text, name)[0].number, 3)

    def test_several_templates_in_a_row_make_several_garments(self):
        rows = self.read("person,scene,chest\nanna,shirt.toml;dress.toml,0.9\n")
        self.assertEqual([(row.person, row.garment) for row in rows], [("anna", "shirt"), ("anna", "dress")])

    def test_notes_need_no_template_and_may_hold_anything(self):
        self.assertEqual(len(self.read('person,scene,chest,#note\nanna,shirt.toml,0.9,"says ""wide"""\n')), 1)

    def test_a_folder_is_relative_to_the_table_and_its_files_are_known(self):
        self.write("scans/a.ply", "ply")
        self.write("scan.toml", '[body]\nposes = "{folder}"\n')
        row, = self.read("person,scene,folder\nanna,scan.toml,scans\n")
        self.assertEqual(row.parsed["body"]["poses"], f"{self.folder}/scans")
        self.assertEqual(row.files, [f"{self.folder}/scans/a.ply"])

    def test_what_is_wrong_with_a_cell_is_told_with_row_and_column(self):
        self.refuses("person,scene,chest\nanna,shirt.toml,\n", "row 2, column chest", "empty")
        self.refuses("person,scene,chest\n\nanna,shirt.toml,wide\n", "row 3, column chest", "no TOML")
        self.refuses('person,scene,chest\nanna,shirt.toml,"0,9"\n', "row 2, column chest", "0.9")
        self.refuses('person,scene,chest\nanna,shirt.toml,"""0.9"\n', "row 2, column chest", "quotation marks")
        self.refuses("person,scene,chest\nanna,skirt.toml,0.9\n", "row 2, column scene", "skirt.toml")
        self.refuses("person,scene,chest\nanna b,shirt.toml,0.9\n", "row 2, column person", "anna b")
        self.refuses("person,scene,chest\n../anna,shirt.toml,0.9\n", "row 2, column person", "../anna")
        self.refuses("person,scene,chest,pattern\nanna,shirt.toml,0.9,maybe\n", "row 2, column pattern", "maybe")
        self.refuses("person,scene,chest,folder\nanna,shirt.toml,0.9,nowhere\n", "row 2, column folder", "no such file")
        self.refuses("person,scene,chest\nanna,shirt.toml,0.9\nanna,shirt.toml,1.0\n", "row 3, column person", "row 2")

    def test_what_is_wrong_with_a_row_or_the_header_is_told(self):
        self.refuses("person,scene,chest\nanna,shirt.toml\n", "row 2", "2 cells")
        self.refuses('person,scene,chest\nanna,shirt.toml,"0.9\n', "row 2", "end on its own line")
        self.refuses("person,chest\nanna,0.9\n", "row 1", "no column 'scene'")
        self.refuses("person,scene,chest,chest\nanna,shirt.toml,0.9,1.0\n", "row 1, column chest", "two columns")
        self.refuses("person,scene,chest,a b\nanna,shirt.toml,0.9,1\n", "row 1, column 4", "a b")
        self.refuses("person,scene,chest,limt\nanna,shirt.toml,0.9,1\n", "row 1, column limt", "did you mean 'limit'?")
        self.refuses("person,scene,chest,city\nanna,shirt.toml,0.9,Oslo\n", "row 1, column city", "'#city'")
        self.refuses("", "row 1")
        self.refuses("person,scene,chest\n", "no row")

    def test_a_table_that_is_no_text_is_told(self):
        (self.folder / "people.csv").write_bytes(b"person,scene\n\xff\xfe\n")
        self.refused(TableError, lambda: read_table(self.folder / "people.csv"), "people.csv: cannot be read")


unittest.main()
