"""The tables of steps and trajectories: time at equal error, what is left of other errors then, setting up."""

from html_table import table

TARGETS = (1e-1, 1e-2, 1e-3, 1e-6)  # relative errors of a step
TRAJECTORY_TARGETS = (0.3, 0.1, 0.03, 0.01)
SLOW = 1.3  # times the fastest method: marked
BENCH_ONLY = ("pd-anderson", "pd-chebyshev")
AMORTISED = 100  # steps


def fastest(cases, method, target):
    """The method's setting of least median time whose median error is at most `target`; None if it has none."""
    good = [case for case in cases if case.fields["method"] == method and case.runs and not case.failed
            and abs(case.median("error")) <= target]
    return min(good, key=lambda case: case.median("ms"), default=None)


def scenes_of(cases, keys=("sheet", "n", "k", "h")):
    """Groups the cases by scene: those of a group differ in method and setting only."""
    groups = {}
    for case in cases:
        groups.setdefault(tuple((k, case.fields[k]) for k in keys), []).append(case)
    return groups


def name_of(key):
    fields = dict(key)
    step = f" h=1/{1 / fields['h']:.0f}" if "h" in fields else ""
    return f"{fields['sheet']} n={fields['n']:g} k={fields['k']:g}{step}"


def comparable_steps(cases):
    """Steps whose positions can be compared: not those of the sheet that wrinkles."""
    return [c for c in cases.values() if c.kind == "step" and c.fields["sheet"] != "hanging"]


def is_slow(text):
    return text == "–" or float(text) > SLOW


def equal_error_row(group, methods, target):
    """Newton's ms, every method's time over it, and auto's over the fastest that a scene can ask for."""
    cases = {method: fastest(group, method, target) for method in methods}
    times = {method: case.median("ms") if case else None for method, case in cases.items()}
    newton = times.get("newton")
    best = min((t for method, t in times.items() if t and method not in BENCH_ONLY), default=None)
    cells = [f"{times[m] / newton:.2f}" if times[m] and newton else "–" for m in methods]
    auto = f"{times['auto'] / best:.2f}" if best and times.get("auto") else "–"
    return [f"{newton:.3g}" if newton else "–", *cells, auto]


def iso_error(cases):
    """Time of each method at equal error, over Newton's."""
    steps = comparable_steps(cases)
    methods = list(dict.fromkeys(c.fields["method"] for c in steps))
    rows, ratios = [], {}
    for key, group in scenes_of(steps).items():
        for target in TARGETS:
            row = equal_error_row(group, methods, target)
            rows.append([name_of(key), f"{target:g}", *row])
            ratios.setdefault(target, []).append(row[-1])
    runs = sorted({len(c.runs) for c in steps if c.runs})
    return (f"<p>Time of the fastest setting of each method whose median error of a step is at most the target, median "
            f"of {'–'.join(str(r) for r in dict.fromkeys((runs[0], runs[-1])))} runs, over Newton's; last column: "
            f"<code>auto</code> over the fastest method that a scene can ask for (marked beyond {SLOW:g}). –: not "
            "reached within the limits. A median leaves out the few steps on which a method factors; means are in the "
            ".csv.</p>\n"
            + table(["scene", "error", "newton, ms", *methods, "auto/best"], rows, marked_last=is_slow)
            + table(["error", "settings", f"auto within {SLOW:g} of the fastest", "not reached", "worst"],
                    [summary(target, texts) for target, texts in ratios.items()]))


def summary(target, texts):
    reached = [float(text) for text in texts if text != "–"]
    return [f"{target:g}", len(texts), sum(ratio <= SLOW for ratio in reached), len(texts) - len(reached),
            f"{max(reached):.2f}" if reached else "–"]


def other_errors(cases):
    """What is left of errors in other measures, where `auto` has that of positions."""
    rows = []
    for key, group in scenes_of(comparable_steps(cases)).items():
        for target in TARGETS[:3]:
            case = fastest(group, "auto", target)
            if not case or not case.values("largest_mm"):
                continue
            rows.append([name_of(key), f"{target:g}", f"{case.fields[case.knob()[0]]:g}"] + [
                f"{case.median(measure):.2g}" for measure in ("error", "largest_mm", "sigma_1_max_error",
                                                              "sigma_1_p99_error", "energy_gap", "residual_m_s2")])
    if not rows:
        return ""
    return ("<p>Errors of <code>auto</code> in every measure, at its fastest setting for an error of positions: "
            "medians of the same runs. sigma_1: larger principal stretch of a triangle, dimensionless.</p>\n"
            + table(["scene", "at most", "tolerance", "error", "largest, mm", "of largest sigma_1",
                     "of its 99th percentile", "energy gap", "residual, m/s²"], rows))


def set_up(cases):
    """Setting up, apart and shared among the steps that follow, at an error of a hundredth."""
    steps = [c for c in comparable_steps(cases) if c.values("setup_ms")]
    rows = []
    for key, group in scenes_of(steps).items():
        for method in dict.fromkeys(c.fields["method"] for c in group):
            case = fastest(group, method, 1e-2) or fastest(group, method, 1.0)
            if not case:
                continue
            ms, first = case.median("ms"), case.median("setup_ms")
            with_set_up = (first + (AMORTISED - 1) * ms) / AMORTISED
            rows.append([f"{name_of(key)} {method}", f"{case.median('error'):.1g}", f"{first:.3g}", f"{ms:.3g}",
                         f"{with_set_up:.3g}", f"{with_set_up / ms:.2f}"])
    if not rows:
        return ""
    return (f"<p>Setting up: analysis, first factors and first step, apart (once a run), and shared among {AMORTISED} "
            "steps. Setting of each method: its fastest with a median error of at most 0.01, or where it has none its "
            "fastest; pd-chebyshev measures its rate of convergence at first.</p>\n"
            + table(["scene", "error", "set-up and first step, ms", "a later step, ms (median)",
                     f"a step of {AMORTISED}, ms", "ratio"], rows))


def trajectories(cases):
    """Time of each method for a whole trajectory at equal error, whatever its time step."""
    runs = [c for c in cases.values() if c.kind == "trajectory"]
    if not runs:
        return ""
    methods = list(dict.fromkeys(c.fields["method"] for c in runs))
    rows = []
    for key, group in scenes_of(runs, ("sheet", "n", "k")).items():
        counts = [len(c.runs) for c in group if c.runs]
        for target in TRAJECTORY_TARGETS:
            fastest_cases = {method: fastest(group, method, target) for method in methods}
            cells = [f"{c.median('ms'):.3g} (1/{1 / c.fields['h']:.0f})" if c else "–" for c in fastest_cases.values()]
            rows.append([name_of(key), f"{target:g}", *cells, f"{min(counts)} to {max(counts)}"])
    return ("<p>A whole trajectory of 0.3 s: ms of each method's fastest setting and time step (in brackets, s) with "
            "at most this error against the exact trajectory, median of the runs. –: the time steps that were tried are "
            "too long for it.</p>\n"
            + table(["scene", "error", *methods, "runs"], rows))
