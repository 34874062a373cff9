"""Draws grids of log-log panels with gnuplot, as SVG and PNG, one legend under them all."""

import subprocess

# Okabe and Ito's colours, told apart by those who see few; a point type each, for print.
STYLES = {
    "bw1": ("#D55E00", 9),
    "newton": ("#000000", 5),
    "pd": ("#56B4E9", 13),
    "pd-lbfgs": ("#0072B2", 7),
    "auto": ("#009E73", 11),
    "pd-anderson": ("#CC79A7", 4),
    "pd-chebyshev": ("#E69F00", 6),
    "converged": ("#009E73", 5),
    "degraded": ("#E69F00", 8),
    "failed": ("#D55E00", 2),
}
OTHER_STYLES = [("#CC79A7", 4), ("#E69F00", 5), ("#56B4E9", 6), ("#0072B2", 7), ("#D55E00", 8), ("#000000", 9),
                ("#009E73", 12), ("#999999", 13)]
PNG_SCALE = 2  # pixels of the .png to one of the .svg, for print
SMALL_SCALE = 1  # of a second .png for pages that should load fast


def style_of(name, others={}):
    if name in STYLES:
        return STYLES[name]
    return others.setdefault(name, OTHER_STYLES[len(others) % len(OTHER_STYLES)])


class Panel:
    """One pair of axes.  `curves`: name -> points (x, y, y low, y high), None between two lines; `marks`: name ->
    points (x, y) where a method failed.  With `y_label`: an axis of its own, of `y_range`."""

    def __init__(self, title, curves, marks=None, y_label="", y_range=""):
        self.title, self.curves, self.marks = title, curves, marks or {}
        self.y_label, self.y_range = y_label, y_range


def block(name, rows):
    """A gnuplot data block; a row None breaks the line."""
    return f"${name} << EOD\n" + "".join(" ".join(f"{v:.6g}" for v in row or ()) + "\n" for row in rows) + "EOD\n"


def plot_panel(index, panel, lines):
    """Data blocks and the plot command of a panel; without `lines` larger points."""
    blocks, plots = "", []
    point_size = 0.55 if lines else 0.9
    for number, (name, points) in enumerate(panel.curves.items()):
        colour, point = style_of(name)
        data = f"c{index}_{number}"
        blocks += block(data, points)
        if lines:
            plots.append(f"${data} using 1:2 with lines lc rgb '{colour}' lw 1.3 notitle")
        plots.append(f"${data} using 1:2:3:4 with yerrorbars lc rgb '{colour}' pt {point} ps {point_size} lw 0.8 "
                     "notitle")
    for number, (name, points) in enumerate(panel.marks.items()):
        if not points:
            continue
        data = f"m{index}_{number}"
        blocks += block(data, points)
        plots.append(f"${data} using 1:2 with points lc rgb '{style_of(name)[0]}' pt 2 ps 1.1 lw 2 notitle")
    return blocks, "plot " + ", \\\n  ".join(plots or ["1e-30 notitle"]) + "\n"


def legend(names, marked, size):
    """Labels in the strip under the panels, in two rows where one is too short."""
    entries = [(name, *style_of(name)) for name in names]
    if marked:
        entries.append((marked, "#444444", 2))
    widths = [(7.2 * len(name) + 34) / size[0] for name, _, _ in entries]
    if sum(widths) <= 1.0:
        rows = [(18, range(len(entries)))]
    else:
        half = next(k for k in range(len(entries)) if sum(widths[:k + 1]) > 0.5 * sum(widths))
        rows = [(26, range(half)), (9, range(half, len(entries)))]
    text = ""
    for height, row in rows:
        at = 0.5 - 0.5 * sum(widths[k] for k in row)
        for k in row:
            name, colour, point = entries[k]
            text += (f"set label \"{name}\" at screen {at + 10 / size[0]:.4f}, screen {height / size[1]:.4f} left "
                     f"noenhanced point pt {point} ps 0.8 lw 1.5 lc rgb '{colour}' offset 0.9,0 front\n")
            at += widths[k]
    return text


def panel_commands(rows, r, c, area, size, y_range, tics):
    """Margins, axes and tick labels of the panel in row r, column c.  Axes that panels share are labelled where there
    is no panel to the left, or below.  `tics`: commands for tick labels, and for ticks without."""
    panel, (left, bottom, cell_width, cell_height) = rows[r][c], area
    x0, y0 = left + c * cell_width, bottom + (len(rows) - 1 - r) * cell_height
    own = 58 if panel.y_label and c > 0 else 6
    sides = (("l", x0 + own / size[0]), ("r", x0 + cell_width - 14 / size[0]), ("b", y0 + 8 / size[1]),
             ("t", y0 + cell_height - 22 / size[1]))
    text = "".join(f"set {side}margin at screen {where:.4f}\n" for side, where in sides)
    text += f"set title \"{panel.title}\" offset 0,-0.7\n"
    first = c == 0 or rows[r][c - 1] is None or bool(panel.y_label)
    last = r + 1 == len(rows) or c >= len(rows[r + 1]) or rows[r + 1][c] is None
    text += f"set format y '{'10^{%L}' if first else ''}'\nset format x '{'10^{%L}' if last else ''}'\n"
    text += f"{tics[0] if last else tics[1]}\n"
    text += f"set yrange [{panel.y_range or y_range}]\n"
    if panel.y_label:
        at = x0 + (own - 50) / size[0] if c > 0 else 16 / size[0]
        text += (f"set label 99 \"{panel.y_label}\" at screen {at:.4f}, screen {y0 + 0.5 * cell_height:.4f} center "
                 "rotate by 90 noenhanced\n")
    return text


def draw(stem, title, x_label, y_label, rows, x_range="", y_range="", marked="", lines=True, note="",
         panel_size=(310, 250), tics="", bare_tics=None, small=False, large=True):
    """Writes stem.svg and stem.png (`large`), and stem_small.png (`small`).  `rows`: lists of panels; None: left free.
    `bare_tics`: where ticks have no label, if that needs another command than `tics`."""
    columns = max(len(row) for row in rows)
    lines_of_note = note.split("\n")
    under = 84 + 14 * len(lines_of_note)
    width, height = max(900, 70 + panel_size[0] * columns), 54 + under + panel_size[1] * len(rows)
    panels = [panel for row in rows for panel in row if panel]
    if not any(points for panel in panels for points in panel.marks.values()):
        marked = ""
    names = list(dict.fromkeys(name for panel in panels for name in [*panel.curves, *panel.marks]))
    names.sort(key=lambda name: list(STYLES).index(name) if name in STYLES else len(STYLES))
    left, right, bottom, top = 62 / width, 1 - 12 / width, (under + 14) / height, 1 - 40 / height
    area = (left, bottom, (right - left) / columns, (top - bottom) / len(rows))
    tics = (tics, tics if bare_tics is None else bare_tics)
    notes = "\n".join(f"set label \"{line}\" at screen 0.5, screen {(under - 52 - 14 * i) / height:.4f} center "
                      "font ',9' noenhanced" for i, line in enumerate(lines_of_note))
    body, index = "", 0
    for r, row in enumerate(rows):
        for c, panel in enumerate(row):
            if not panel:
                continue
            blocks, plot = plot_panel(index, panel, lines)
            body += blocks + panel_commands(rows, r, c, area, (width, height), y_range, tics) + plot
            body += "unset label\n"
            index += 1
    script = f"""
set encoding utf8
set logscale xy
set xrange [{x_range}]
set grid xtics ytics lc rgb '#dddddd' lw 0.6
set tics font ',9'
set border lc rgb '#555555' lw 0.8
set multiplot
set label "{title}" at screen 0.5, screen {1 - 14 / height:.4f} center font ',12' noenhanced
set label "{x_label}" at screen 0.5, screen {(under - 32) / height:.4f} center noenhanced
{notes}
set label "{y_label}" at screen {16 / width:.4f}, screen {0.5 * (bottom + top):.4f} center rotate by 90 noenhanced
{legend(names, marked, (width, height))}
{body}
unset multiplot
"""
    name = stem.name.replace("-", "_")
    pictures = []
    if large:
        run_gnuplot(stem.with_suffix(".svg"),
                    f"svg size {width},{height} name '{name}' font 'DejaVu Sans,10' background '#ffffff'", script)
        pictures.append((stem.with_suffix(".png"), PNG_SCALE))
    if small:
        pictures.append((stem.with_name(stem.name + "_small.png"), SMALL_SCALE))
    for file, scale in pictures:
        run_gnuplot(file, f"pngcairo size {scale * width},{scale * height} fontscale {scale} linewidth {scale} "
                          f"pointscale {scale} font 'DejaVu Sans,10' background '#ffffff'", script)


def run_gnuplot(file, terminal, script):
    command = f"set terminal {terminal}\nset output '{file}'\n{script}"
    run = subprocess.run(["gnuplot", "-"], input=command, text=True, capture_output=True, check=False)
    if run.returncode != 0 or "error" in run.stderr.lower():
        raise SystemExit(f"bench: gnuplot could not draw {file}: {run.stderr.strip()}")
