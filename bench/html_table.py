"""A table as HTML."""

import html


def table(head, rows, marked_last=lambda text: False):
    """`marked_last`: whether the last cell of a row, of this text, is marked."""
    text = "<table><tr>" + "".join(f"<th>{html.escape(str(cell))}</th>" for cell in head) + "</tr>\n"
    for row in rows:
        marks = [""] * (len(row) - 1) + [" class=bad" if marked_last(row[-1]) else ""]
        cells = "".join(f"<td{mark}>{html.escape(str(cell))}</td>" for mark, cell in zip(marks, row))
        text += f"<tr>{cells}</tr>\n"
    return text + "</table>\n"
