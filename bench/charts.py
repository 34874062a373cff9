"""The charts of a bench run: each function draws what the cases have and returns (stem, caption) pairs."""

from gnuplot import Panel, draw
from tables import TARGETS, fastest

FLOOR = 1e-10  # an error below this is drawn there
TOO_SLOW_MS = 3e3  # stands for the top edge until the range of a chart is known
MARKED = "failed (right), too slow (top)"
DEFINITION = ("error = |x - x_ref|_M / min(|x_ref - x_n|_M, 4 |x_ref - x_n - h v_n|_M), norm of the masses; "
              "x_ref: Newton to round-off")


def distinct(cases, key):
    return sorted({case.fields[key] for case in cases if key in case.fields})


def by_method(cases):
    methods = {}
    for case in cases:
        methods.setdefault(case.fields["method"], []).append(case)
    return methods


def work_precision(cases, error_key, worst):
    """Curves and marks of failure: (error, ms, quartiles) of each setting.  Errors beyond `worst` are failures."""
    curves, marks = {}, {}
    for method, settings in by_method(cases).items():
        points, failures = [], []
        last_error = worst
        for case in settings:
            if not case.runs:
                if case.failed:
                    failures.append((worst, TOO_SLOW_MS))
                elif points:  # not tried, since a looser setting was too slow already
                    failures.append((last_error, TOO_SLOW_MS))
                continue
            error = abs(case.median(error_key))
            if case.failed or not error < worst:
                failures.append((worst, case.median("ms")))
                continue
            last_error = max(error, FLOOR)
            points.append((last_error, case.median("ms"), *case.quartiles("ms")))
        curves[method] = sorted(points)
        marks[method] = list(dict.fromkeys(failures))
    return curves, marks


def time_range(panels):
    times = [v for row in panels for panel in row for points in panel.curves.values() for p in points
             if p for v in p[2:4]]
    times += [p[1] for row in panels for panel in row for points in panel.marks.values() for p in points
              if p[1] < TOO_SLOW_MS]
    low, high = min(times) / 1.5, max(times) * 2.5
    for row in panels:
        for panel in row:
            panel.marks = {m: [(x, min(y, high / 1.25)) for x, y in points] for m, points in panel.marks.items()}
    return f"{low:.3g}:{high:.3g}"


def grid(cases, error_key, worst):
    """Panels: stiffness down, time step across."""
    rows = []
    for k in distinct(cases, "k"):
        row = []
        for h in distinct(cases, "h"):
            chosen = [c for c in cases if c.fields["k"] == k and c.fields["h"] == h]
            if chosen:
                curves, marks = work_precision(chosen, error_key, worst)
                row.append(Panel(f"k = {k:g} N/m, h = 1/{round(1 / h):g} s", curves, marks))
        if row:
            rows.append(row)
    return rows


def draw_step(directory, cases):
    """Work-precision of one step: positions of the taut sheet, energy and residual of the wrinkled one."""
    drawn = []
    steps = [c for c in cases.values() if c.kind == "step"]
    for sheet in distinct(steps, "sheet"):
        for n in distinct(steps, "n"):
            chosen = [c for c in steps if c.fields["sheet"] == sheet and c.fields["n"] == n]
            if not chosen:
                continue
            for key, worst, label, note in (
                    ("error", 1.0, "relative error of a step", DEFINITION),
                    ("energy_gap", 1.0, "energy gap (E - E_ref)/(E(x_n + h v_n) - E_ref)",
                     "wrinkled cloth: a step may have several minima; positions of two good solvers differ there"),
                    ("residual_m_s2", 1e4, "residual: largest |dE/dx_i|/m_i, m/s²",
                     "wrinkled cloth: a step may have several minima; positions of two good solvers differ there")):
                if (key == "error") == (sheet == "hanging"):
                    continue
                rows = grid(chosen, key, worst)
                stem = directory / f"step_{sheet}_{n:g}_{key}".replace("-", "_")
                draw(stem, f"One implicit step, {sheet} sheet of {n:g} vertices: time against accuracy", label,
                     "ms a step (median, quartiles)", rows, y_range=time_range(rows), note=note,
                     x_range=f"{FLOOR:g}:{1.6 * worst:g}", tics="set xtics 100", marked=MARKED)
                drawn.append((stem, f"One step of the {sheet} sheet, {n:g} vertices: {label}. Crosses at the right: "
                                    "worse than no step at all, or stopped; at the top: settings that take too long."))
    return drawn


def draw_trajectory(directory, cases):
    """A panel for each stiffness; the settings of one method and time step are joined by a line."""
    drawn = []
    runs = [c for c in cases.values() if c.kind == "trajectory"]
    for n in distinct(runs, "n"):
        row = []
        for k in distinct(runs, "k"):
            panel = Panel(f"k = {k:g} N/m", {}, {})
            for h in distinct(runs, "h"):
                chosen = [c for c in runs if all(c.fields[key] == v for key, v in (("n", n), ("k", k), ("h", h)))]
                curves, marks = work_precision(chosen, "error", 1.0)
                for method in curves:
                    panel.curves.setdefault(method, []).extend([*curves[method], None])
                    panel.marks.setdefault(method, []).extend(marks[method])
            row.append(panel)
        lowest = min(p[0] for panel in row for points in panel.curves.values() for p in points if p)
        steps = ", ".join(f"1/{round(1 / h)}" for h in reversed(distinct(runs, "h")))
        stem = directory / f"trajectory_{n:g}"
        draw(stem, f"A trajectory of 0.3 s, taut sheet of {n:g} vertices: time against accuracy",
             "relative error of positions, against Newton at h/16 and h/8 extrapolated to h = 0",
             "ms the trajectory", [row], y_range=time_range([row]), x_range=f"{lowest / 2:.3g}:1.6",
             marked=MARKED, note=f"h = {steps} s, a line each, from right to left; upright: backward Euler's own error")
        drawn.append((stem, f"A whole trajectory of the taut sheet, {n:g} vertices."))
    return drawn


# Wolff et al. 2022, table 1: vertices and frames per second of the simulation alone.
PAPER = [(1103, 8.3), (3032, 4.0), (4270, 1.8)]
PAPER_NAME = "paper's table 1, on another machine of 12 cores"


def draw_fps(directory, cases):
    rows = []
    for body in distinct(cases.values(), "body"):
        row = []
        for key, what in (("fps_simulation", "simulation alone"), ("fps_full", "with level sets, adaption, output")):
            curves, marks = {}, {}
            for method, chosen in by_method([c for c in cases.values() if c.fields["body"] == body]).items():
                good = [c for c in chosen if c.runs]
                curves[method] = [(c.median("vertices"), c.median(key), *c.quartiles(key)) for c in good]
                marks[method] = [(c.fields["n"], 0.1) for c in chosen if not c.runs]
            if key == "fps_simulation":
                curves[PAPER_NAME] = [(n, fps, fps, fps) for n, fps in PAPER]
            garment = "built-in T-shirt" if body == "mannequin" else "T-shirts on scans"
            row.append(Panel(f"{garment}: {what}", curves, marks))
        rows.append(row)
    stem = directory / "fps"
    draw(stem, "Time steps per second against vertices: the main job", "vertices of the garment",
         "time steps of 0.0025 s per second", rows, y_range="0.01:400", x_range="600:150000", marked="failed")
    return [(stem, "The main job: moving body, contact, adaption every 8th step. Setting up is not counted.")]


def draw_phases(directory, cases):
    """Two panels: what a step's parts take, and what share of the bound they reach."""
    taken, share = {}, {}
    for case in cases.values():
        phase, n = case.fields["phase"], case.fields["n"]
        if not case.runs:
            continue
        taken.setdefault(phase, []).append((n, case.median("ms"), *case.quartiles("ms")))
        if case.values("bound_ms"):
            reached = 100.0 * case.median("bound_ms") / case.median("ms")
            share.setdefault(phase, []).append((n, reached, reached, reached))
    stem = directory / "phases"
    panels = [Panel("time, ms", taken), Panel("share of the bound, %", share)]
    draw(stem, "Phases of a step", "vertices", "ms; %", [panels],
         y_range="0.01:5000", x_range="700:150000", panel_size=(430, 300))
    return [(stem, "What each phase takes once, and how near it comes to the machine's bandwidth or peak.")]


GRADES = ("failed", "degraded", "converged")


def draw_stability(directory, cases):
    """A map for each method and sheet: time step across, stiffness up."""
    methods = list(by_method(list(cases.values())))
    rows = []
    for sheet in dict.fromkeys(c.fields["sheet"] for c in cases.values()):
        row = []
        for method in methods:
            panel = Panel(f"{method}, {sheet}", {grade: [] for grade in reversed(GRADES)})
            for case in cases.values():
                if case.fields["sheet"] == sheet and case.fields["method"] == method and case.runs:
                    k = case.fields["k"]
                    panel.curves[GRADES[int(case.median("grade"))]].append((case.fields["h"], k, k, k))
            row.append(panel)
        rows.append(row)
    stem = directory / "stability"
    draw(stem, "Where methods fail: time step against stiffness", "time step, s", "stiffness, N/m", rows,
         x_range="0.0007:0.3", y_range="3:3e6", lines=False, panel_size=(165, 170),
         tics="set xtics ('1/960' 1/960., '1/120' 1/120., '1/20' 1/20., '1/5' 1/5.) font ',8'",
         note="converged: mean error of the steps at most 10 %; failed: stopped, exploded, or no better than no step")
    return [(stem, "The first steps from the start of each sheet, every method with its defaults.")]


def draw_drape(directory, cases):
    """Time of a step of drape-2pin at equal error, against the number of vertices."""
    row = []
    steps = [c for c in cases.values() if c.kind == "step"]
    for target in TARGETS:
        curves = {}
        for n in distinct(steps, "n"):
            for method in by_method(steps):
                ms = fastest([c for c in steps if c.fields["n"] == n], method, target)
                if ms:
                    curves.setdefault(method, []).append((n, ms, ms, ms))
        row.append(Panel(f"error at most {target:g}", curves))
    stem = directory / "drape_2pin"
    draw(stem, "drape-2pin, k = 1000 N/m: a step of 1/60 s", "vertices", "ms a step, mean", [row], x_range="700:15000",
         y_range=time_range([row]), panel_size=(190, 250), note=DEFINITION)
    return [(stem, "Where a method is missing, it does not reach that error within the limits.")]
