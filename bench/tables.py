"""The tables of a bench run, as HTML."""

import html

TARGETS = (1e-1, 1e-2, 1e-3, 1e-6)  # relative errors of a step


def table(head, rows, bad=lambda value: False):
    """`bad`: of a cell's text, whether it is marked."""
    text = "<table><tr>" + "".join(f"<th>{html.escape(str(cell))}</th>" for cell in head) + "</tr>\n"
    for row in rows:
        text += "<tr>" + "".join(f"<td{' class=bad' if bad(cell) else ''}>{html.escape(str(cell))}</td>" for cell in row)
        text += "</tr>\n"
    return text + "</table>\n"


def fastest(cases, method, target):
    """Least mean time, ms, of the method's settings whose median error is at most `target`; None: it has none."""
    times = [case.mean("ms") for case in cases
             if case.fields["method"] == method and case.runs and not case.failed
             and abs(case.median("error")) <= target]
    return min(times) if times else None


def scenes_of(cases):
    """Cases grouped by all that is not a method's."""
    groups = {}
    for case in cases:
        key = tuple((k, case.fields[k]) for k in ("sheet", "n", "k", "h"))
        groups.setdefault(key, []).append(case)
    return groups


def iso_error(cases):
    """Time of each method at equal error, over Newton's."""
    steps = [c for c in cases.values() if c.kind == "step" and c.fields["sheet"] != "hanging"]
    methods = list(dict.fromkeys(c.fields["method"] for c in steps))
    rows = []
    for key, group in scenes_of(steps).items():
        fields = dict(key)
        for target in TARGETS:
            times = {method: fastest(group, method, target) for method in methods}
            newton, best = times.get("newton"), min((t for t in times.values() if t), default=None)
            cells = [f"{times[m] / newton:.2f}" if times[m] and newton else "–" for m in methods]
            auto = f"{times['auto'] / best:.2f}" if best and times.get("auto") else "–"
            rows.append([f"{fields['sheet']} n={fields['n']:g} k={fields['k']:g} h=1/{1 / fields['h']:.0f}",
                         f"{target:g}", f"{newton:.3g}" if newton else "–", *cells, auto])
    return ("<p>Time of the soonest setting of each method whose median error of a step is at most the target, mean of "
            "all runs (factorisations amortised), over Newton's; last column: <code>auto</code> over the soonest "
            "method of all (marked beyond 1.3). –: not reached within the limits.</p>\n"
            + table(["scene", "error", "newton, ms", *methods, "auto/best"], rows).replace("<td>–", "<td class=bad>–"))
