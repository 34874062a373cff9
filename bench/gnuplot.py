"""Draws grids of log-log panels with gnuplot, as SVG and PNG, one legend under them all."""

import subprocess

# Okabe and Ito's colours, told apart by those who see few; a point type each, for print.
STYLES = {
    "bw1": ("#D55E00", 9),
    "newton": ("#000000", 5),
    "pd": ("#56B4E9", 13),
    "pd-lbfgs": ("#0072B2", 7),
    "auto": ("#009E73", 11),
    "converged": ("#009E73", 5),
    "degraded": ("#E69F00", 8),
    "failed": ("#D55E00", 2),
}
OTHER_STYLES = [("#CC79A7", 4), ("#E69F00", 5), ("#56B4E9", 6), ("#0072B2", 7), ("#D55E00", 8), ("#000000", 9),
                ("#009E73", 12), ("#999999", 13)]


def style_of(name, others={}):
    if name in STYLES:
        return STYLES[name]
    return others.setdefault(name, OTHER_STYLES[len(others) % len(OTHER_STYLES)])


class Panel:
    """One pair of axes.  `curves`: name -> points (x, y, y low, y high), None between two lines; `marks`: name ->
    points (x, y) where a method failed."""

    def __init__(self, title, curves, marks=None):
        self.title, self.curves, self.marks = title, curves, marks or {}


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


def draw(stem, title, x_label, y_label, rows, x_range="", y_range="", marked="", lines=True, extra="", note="",
         panel_size=(310, 250), axes="set logscale xy", tics=""):
    """Writes stem.svg and stem.png.  `rows`: lists of panels."""
    columns = max(len(row) for row in rows)
    width, height = max(900, 70 + panel_size[0] * columns), 92 + panel_size[1] * len(rows)
    names = list(dict.fromkeys(name for row in rows for panel in row for name in [*panel.curves, *panel.marks]))
    names.sort(key=lambda name: list(STYLES).index(name) if name in STYLES else len(STYLES))
    body, index = "", 0
    left, right, bottom, top = 62 / width, 1 - 12 / width, 84 / height, 1 - 40 / height
    cell = (right - left) / columns, (top - bottom) / len(rows)
    for r, row in enumerate(rows):
        for c, panel in enumerate(row):
            blocks, plot = plot_panel(index, panel, lines)
            x0, y0 = left + c * cell[0], top - (r + 1) * cell[1]
            body += blocks
            sides = (("l", x0 + 6 / width), ("r", x0 + cell[0] - 14 / width), ("b", y0 + 22 / height),
                     ("t", y0 + cell[1] - 20 / height))
            body += "".join(f"set {side}margin at screen {where:.4f}\n" for side, where in sides)
            body += f"set title \"{panel.title}\" offset 0,-0.7\n"
            body += "set format y '10^{%L}'\n" if c == 0 and "logscale" in axes else "set format y ''\n" if c else ""
            body += plot
            body += "unset label\n" if index == 0 else ""
            index += 1
    script = f"""
set encoding utf8
{axes}
set xrange [{x_range}]
set yrange [{y_range}]
set grid xtics ytics lc rgb '#dddddd' lw 0.6
set tics font ',9'
{tics}
set border lc rgb '#555555' lw 0.8
set format x '10^{{%L}}'
{extra}
set multiplot
set label "{title}" at screen 0.5, screen {1 - 14 / height:.4f} center font ',12' noenhanced
set label "{x_label}" at screen 0.5, screen {60 / height:.4f} center noenhanced
set label "{note}" at screen 0.5, screen {40 / height:.4f} center font ',9' noenhanced
set label "{y_label}" at screen {16 / width:.4f}, screen {0.5 * (bottom + top):.4f} center rotate by 90 noenhanced
{legend(names, marked, (width, height))}
{body}
unset multiplot
"""
    name = stem.name.replace("-", "_")
    svg = f"svg size {width},{height} name '{name}' font 'DejaVu Sans,10' background '#ffffff'"
    png = (f"pngcairo size {2 * width},{2 * height} fontscale 2 linewidth 2 pointscale 2 font 'DejaVu Sans,10' "
           "background '#ffffff'")
    for terminal, suffix in ((svg, "svg"), (png, "png")):
        command = f"set terminal {terminal}\nset output '{stem}.{suffix}'\n{script}"
        run = subprocess.run(["gnuplot", "-"], input=command, text=True, capture_output=True, check=False)
        if run.returncode != 0 or "error" in run.stderr.lower():
            raise SystemExit(f"bench: gnuplot could not draw {stem}.{suffix}: {run.stderr.strip()}")
