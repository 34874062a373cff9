"""The table of a batch: a row for each person and garment.

Columns: `person` and `scene` (a template, scene_template.py; several are separated by ';') must be there.  `garment`
names the results (default: the template's name), `pattern` is yes or no (default yes).  `folder`, `poses` and `mesh`
are paths, relative to the table.  All other columns fill names in braces; those that begin with '#' are notes.
"""

import csv
import dataclasses
import difflib
import glob
import pathlib
import re

import scene_template
from scene_template import TemplateError

PATHS = ("folder", "poses", "mesh")  # columns whose cells are paths
OURS = ("person", "scene", "garment", "pattern")
RESERVED = ("plan.json", "summary.csv", "summary.html")  # beside the folders of the people
PLAIN = re.compile(r"\w[\w.-]*")  # what may name a folder: letters of any language, digits, - _ .


class TableError(Exception):
    """What is wrong with a table; one line with file, row and column."""


@dataclasses.dataclass
class Row:
    number: int  # line of the file
    person: str
    garment: str
    scene: str  # text of the scene file
    parsed: dict  # the same, parsed
    pattern: bool  # whether a sewing pattern is made
    files: list  # scans and meshes that the row's paths name


def read_table(path):
    """The rows of a table, CSV or TSV, each scene filled.  Throws TableError."""
    path = pathlib.Path(path)
    cells = read_cells(path)
    header = [name.strip() for name in cells[0][1]] if cells else []
    check_header(path, header)
    used, rows, first_of = set(), [], {}  # first_of: line of (person, garment)
    for number, line in cells[1:]:
        if len(line) != len(header):
            raise TableError(f"{path}: row {number}: {len(line)} cells, but the first row names {len(header)} columns")
        values = dict(zip(header, (cell.strip() for cell in line)))
        for row, names in rows_of(path, number, values):
            used |= names
            if (row.person, row.garment) in first_of:
                raise TableError(f"{path}: row {number}, column person: '{row.person}' with garment '{row.garment}' is "
                                 f"in row {first_of[row.person, row.garment]} already: name the garments apart in the "
                                 "column 'garment'")
            first_of[row.person, row.garment] = number
            rows.append(row)
    if not rows:
        raise TableError(f"{path}: no row: expected a first row with the columns' names and a row for each person")
    for name in header:
        if name not in used and name not in OURS and not name.startswith("#"):
            near = difflib.get_close_matches(name, used - set(header), 1)
            raise TableError(f"{path}: row 1, column {name}: no template has {{{name}}}"
                             + (f"; did you mean '{near[0]}'?" if near else f": name it '#{name}' if it is a note"))
    return rows


def read_cells(path):
    """[(line number, [cell])] of the lines that are not empty."""
    try:
        text = path.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise TableError(f"{path}: cannot be read: {getattr(error, 'strerror', None) or error}") from None
    first = text.partition("\n")[0]
    delimiter = "\t" if path.suffix.lower() in (".tsv", ".tab") else ";" if ";" in first and "," not in first else ","
    cells = []
    for number, line in enumerate(text.splitlines(), 1):
        try:
            row = next(csv.reader([line], delimiter=delimiter, strict=True), [])
        except csv.Error as error:
            raise TableError(f"{path}: row {number}: {error}: a cell must end on its own line") from None
        if any(cell.strip() for cell in row):
            cells.append((number, row))
    return cells


def check_header(path, header):
    for name in ("person", "scene"):
        if name not in header:
            raise TableError(f"{path}: row 1: no column '{name}'; there are: {', '.join(header) or 'none'}")
    for k, name in enumerate(header):
        if header.index(name) != k:
            raise TableError(f"{path}: row 1, column {name}: there are two columns of this name")
        if not name.startswith("#") and not re.fullmatch(scene_template.NAME, name):
            raise TableError(f"{path}: row 1, column {k + 1}: '{name}': expected letters, digits and _, or '#' in "
                             "front of a note")


def rows_of(path, number, values):
    """[(row, names that its template has)] of one line of the table: one for each of its templates."""

    def refuse(column, text):
        raise TableError(f"{path}: row {number}, column {column}: {text}")

    for column, cell in values.items():
        if column.startswith("#"):
            continue
        if re.search(r'["\\\x00-\x1f]', cell):
            refuse(column, f"{cell!r}: quotation marks, backslashes and control characters cannot stand in a scene")
        if re.fullmatch(r"-?\d+,\d+", cell):
            refuse(column, f"'{cell}': write it with a point: {cell.replace(',', '.')}")
    if values.get("pattern", "") not in ("", "yes", "no"):
        refuse("pattern", f"'{values['pattern']}': expected yes or no")
    files = []
    for column in PATHS:
        if values.get(column):
            values[column], found = resolved(path.parent, values[column])
            files += found or refuse(column, f"'{values[column]}': no such file or folder")
    rows = []
    for name in [part.strip() for part in values["scene"].split(";")]:
        template = path.parent / name
        if not name or not template.is_file():
            refuse("scene", f"'{name}': no such file: expected a template, relative to the table")
        garment = values.get("garment") or template.stem
        for column, word in (("person", values["person"]), ("garment", garment)):
            if not PLAIN.fullmatch(word):
                refuse(column, f"'{word}': names a folder: expected letters, digits, - _ . only")
        if values["person"] in RESERVED:
            refuse("person", f"'{values['person']}': the batch writes a file of this name: choose another")
        filled = {**values, "garment": garment}
        try:
            text = scene_template.read_template(template)
            scene = scene_template.fill(template, text, filled)
            parsed = scene_template.parse(template, text, scene)
        except TemplateError as error:
            if error.column:
                refuse(error.column, error)
            raise TableError(f"{path}: row {number}: {error}") from None
        wants_pattern = values.get("pattern") != "no"
        rows.append((Row(number, values["person"], garment, scene, parsed, wants_pattern, files),
                     scene_template.names_in(text)))
    return rows


def resolved(folder, cell):
    """The absolute path of a cell and the files it stands for: itself, a folder's, or those that a wildcard matches."""
    path = (folder / cell).resolve()
    if path.is_dir():
        found = [file for file in sorted(path.iterdir()) if file.is_file()]
    else:
        found = [pathlib.Path(name) for name in sorted(glob.glob(path.as_posix()))]
    return path.as_posix(), [file.as_posix() for file in found]
