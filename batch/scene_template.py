"""Templates: scene files in which names in braces are filled from a table.

    chest = {chest}            the cell of the column `chest`
    limit = {limit:0.1}        0.1 where the cell is empty or the table has no such column
    mesh = "{here}/shirt.obj"  {here} is the folder of the template

TOML's own braces, as in `{ stretch = 20 }`, are no names and stay as they are.
"""

import difflib
import pathlib
import re
import tomllib

NAME = r"[A-Za-z_][A-Za-z0-9_]*"
BRACES = re.compile(r"\{(" + NAME + r")(?::([^{}\n]*))?\}")


class TemplateError(Exception):
    """What is wrong with a template or a scene made from it; one line.  `column`: the table's column it comes from."""

    def __init__(self, text, column=None):
        super().__init__(text)
        self.column = column


def read_template(path):
    """The text of a template.  Throws TemplateError."""
    try:
        return pathlib.Path(path).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise TemplateError(f"{path}: cannot be read: {getattr(error, 'strerror', None) or error}") from None


def names_in(text):
    """The names in braces of a template, without `here`."""
    return {match[1] for match in BRACES.finditer(text)} - {"here"}


def fill(path, text, values):
    """The scene that a template and `values` (column: cell) make.  Throws TemplateError."""

    def value_of(match):
        name, default = match.groups()
        if name == "here":
            return path.parent.resolve().as_posix()
        if values.get(name):
            return values[name]
        if default is not None:
            return default
        if name in values:
            raise TemplateError(f"empty, but {path.name} needs it: fill it in, or give a default there: "
                                f"{{{name}:DEFAULT}}", name)
        line = text.count("\n", 0, match.start()) + 1
        near = difflib.get_close_matches(name, values, 1)
        raise TemplateError(f"{path}:{line}: the table has no column for {{{name}}}"
                            + (f"; did you mean {{{near[0]}}}?" if near else ": add it, or a default: "
                               f"{{{name}:DEFAULT}}"))

    return BRACES.sub(value_of, text)


def parse(path, text, scene):
    """The scene as a dictionary.  Throws TemplateError where it is no TOML or names files relative to nothing."""
    try:
        parsed = tomllib.loads(scene)
    except tomllib.TOMLDecodeError as error:
        at = re.search(r"at line (\d+)", str(error))
        lines = text.splitlines()
        line = lines[int(at[1]) - 1] if at and int(at[1]) <= len(lines) else ""
        columns = [match[1] for match in BRACES.finditer(line) if match[1] != "here"]
        raise TemplateError(f"{path.name}, filled, is no TOML: {error}", columns[0] if columns else None) from None
    for key, names in (("[garment] mesh", of(parsed, "garment", "mesh")), ("[body] poses", pose_files(parsed))):
        for name in [names] if isinstance(names, str) else names or []:
            if isinstance(name, str) and not pathlib.PurePath(name).is_absolute():
                raise TemplateError(f"{path}: {key} = '{name}': scenes are written elsewhere: write '{{here}}/{name}'")
    return parsed


def of(parsed, table, key):
    """A value of a parsed scene; None where it has none."""
    part = parsed.get(table)
    return part.get(key) if isinstance(part, dict) else None


def pose_files(parsed):
    """The files, wildcard or folder that a parsed scene gives as poses; None with a built-in body."""
    return None if of(parsed, "body", "builtin") else of(parsed, "body", "poses")
