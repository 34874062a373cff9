"""The charts of time against accuracy, of a step and of a trajectory: each function draws what the cases have and
returns (stem, caption) pairs."""

from gnuplot import Panel, draw

FLOOR = 1e-10  # an error below this is drawn there
TOO_SLOW_MS = 3e3  # stands for the top edge until the range of a chart is known
MARKED = "failed (right), too slow (top)"
DEFINITION = ("error = |x - x_ref|_M / min(|x_ref - x_n|_M, 4 |x_ref - x_n - h v_n|_M), norm of the masses; "
              "x_ref: Newton to round-off")
BENCH_ONLY = "pd-anderson, pd-chebyshev: of the bench alone, for cloth that touches nothing"
LEFT = "at the left edge: 1e-10 or less"
BETTER = "or a better minimum than the reference's"
SWINGING = "the sheet wrinkles as it swings: positions of two good solvers may differ there"
WRINKLED = "wrinkled cloth: a step may have several minima; positions of two good solvers differ there"
TICS = "set xtics 1e-9,1000; unset mxtics"
FOR_README = ("taut", 4096, "error")  # a small picture of the middle stiffness
RUNS = "ms a step (median, quartiles)"
# Measures of a step: counter, error beyond which it failed, label, whether it is drawn for the hanging sheet.
MEASURES = (
    ("error", 1.0, "relative error of a step", False),
    ("largest_mm", 1e2, "largest error of a vertex, mm", False),
    ("sigma_1_max_error", 1.0, "error of the largest principal stretch", False),
    ("sigma_1_p99_error", 1.0, "error of the 99th percentile of principal stretch", False),
    ("energy_gap", 1.0, "energy gap (E - E_ref)/(E(x_n + h v_n) - E_ref)", True),
    ("residual_m_s2", 1e4, "residual: largest |dE/dx_i|/m_i, m/s²", True),
)


def distinct(cases, key):
    return sorted({case.fields[key] for case in cases if key in case.fields})


def have(cases, key):
    """True if every case that has runs has this measure, too."""
    return any(c.runs for c in cases) and all(c.values(key) for c in cases if c.runs)


def by_method(cases):
    methods = {}
    for case in cases:
        methods.setdefault(case.fields["method"], []).append(case)
    return methods


def error_of(case, key):
    """Its median; of an energy gap below 0, where a step found a better minimum than the reference, 0."""
    error = case.median(key)
    return max(error, 0.0) if key == "energy_gap" else abs(error)


def work_precision(cases, error_key, worst):
    """Curves and marks of failure: (error, ms, quartiles) of each setting, joined from loose to tight.  Errors beyond
    `worst` are failures."""
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
            error = error_of(case, error_key)
            if case.failed or not error < worst:
                failures.append((worst, case.median("ms")))
                continue
            last_error = max(error, FLOOR)
            points.append((last_error, case.median("ms"), *case.quartiles("ms")))
        curves[method] = points
        marks[method] = list(dict.fromkeys(failures))
    return curves, marks


def front(points):
    """The Pareto front: points that no other point beats in both error and time."""
    best, kept = float("inf"), []
    for point in sorted(points):
        if point[1] < best:
            kept.append(point)
            best = point[1]
    return kept


def panels_of(rows):
    return [panel for row in rows for panel in row if panel]


def time_range(rows):
    panels = panels_of(rows)
    times = [v for panel in panels for points in panel.curves.values() for p in points if p for v in p[2:4]]
    times += [p[1] for panel in panels for points in panel.marks.values() for p in points if p[1] < TOO_SLOW_MS]
    low, high = min(times) / 1.5, max(times) * 2.5
    for panel in panels:
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
            else:
                row.append(None)
        rows.append(row)
    return rows


def draw_step(directory, cases):
    """Work-precision of one step: positions and stretches of taut sheets, energy and residual of the wrinkled one."""
    drawn = []
    steps = [c for c in cases.values() if c.kind == "step"]
    for sheet in distinct(steps, "sheet"):
        for n in distinct(steps, "n"):
            chosen = [c for c in steps if c.fields["sheet"] == sheet and c.fields["n"] == n]
            if not chosen:
                continue
            for key, worst, label, wrinkled in MEASURES:
                if wrinkled != (sheet == "hanging") or not have(chosen, key):
                    continue
                rows = grid(chosen, key, worst)
                note = [WRINKLED] if wrinkled else [DEFINITION] if key == "error" else ["x_ref: Newton to round-off"]
                if sheet == "drape-2pin":
                    note.append(SWINGING)
                if any(m.startswith(("pd-a", "pd-c")) for m in by_method(chosen)):
                    note.append(BENCH_ONLY)
                stem = directory / f"step_{sheet}_{n:g}_{key}".replace("-", "_")
                title = f"One implicit step, {sheet} sheet of {n:g} vertices: time against accuracy"
                looks = {"y_range": time_range(rows), "x_range": f"{FLOOR:g}:{1.6 * worst:g}", "marked": MARKED,
                         "note": "\n".join([*note, f"{LEFT}, {BETTER}" if key == "energy_gap" else LEFT]), "tics": TICS}
                draw(stem, title, label, RUNS, rows, **looks)
                if (sheet, n, key) == FOR_README:
                    draw(stem, title, label, RUNS, rows[len(rows) // 2:][:1], large=False, small=True, **looks)
                drawn.append((stem, f"One step of the {sheet} sheet, {n:g} vertices: {label}. Crosses at the right: "
                                    "worse than no step at all, or stopped; at the top: settings that take too long."))
    return drawn


def draw_trajectory(directory, cases):
    """Against the exact trajectory, a panel for each stiffness with all time steps; and against Newton's of the same
    time step, a panel for each."""
    drawn = []
    runs = [c for c in cases.values() if c.kind == "trajectory"]
    for n in distinct(runs, "n"):
        of_size = [c for c in runs if c.fields["n"] == n]
        row = []
        for k in distinct(of_size, "k"):
            panel = Panel(f"k = {k:g} N/m", {}, {})
            for h in distinct(of_size, "h"):
                chosen = [c for c in of_size if c.fields["k"] == k and c.fields["h"] == h]
                curves, marks = work_precision(chosen, "error", 1.0)
                for method in curves:
                    panel.curves.setdefault(method, []).extend(curves[method])
                    panel.marks.setdefault(method, []).extend(marks[method])
            panel.curves = {method: front(points) for method, points in panel.curves.items()}
            panel.marks = {method: [(x, y) for x, y in points if x >= 1.0] for method, points in panel.marks.items()}
            row.append(panel)
        lowest = min(p[0] for panel in row for points in panel.curves.values() for p in points)
        steps = ", ".join(f"1/{round(1 / h)}" for h in reversed(distinct(of_size, "h")))
        stem = directory / f"trajectory_{n:g}"
        title = f"A trajectory of 0.3 s, taut sheet of {n:g} vertices: time against accuracy"
        draw(stem, title, "relative error of positions, against Newton at 1/16 and 1/8 of the least h, extrapolated "
             "to h = 0", "ms the trajectory", [row], y_range=time_range([row]), x_range=f"{lowest / 2:.3g}:1.6", marked=MARKED,
             note=f"h = {steps} s: of each method, the settings that no other of its own beats in error and time")
        drawn.append((stem, f"A whole trajectory of the taut sheet, {n:g} vertices, time step and setting both chosen. "
                            "Most of the error is that of backward Euler with this time step."))
        if have(of_size, "method_error"):
            rows = grid(of_size, "method_error", 1.0)
            stem = directory / f"trajectory_{n:g}_method_error"
            draw(stem, title, "relative error of positions, against Newton to round-off with the same time step",
                 "ms the trajectory (median, quartiles)", rows, y_range=time_range(rows), x_range=f"{FLOOR:g}:1.6",
                 tics=TICS, marked=MARKED,
                 note="the method's own error; what the time step itself is off by: the chart before")
            drawn.append((stem, f"The same without the time step's own error, {n:g} vertices."))
    return drawn
