"""The tables of a bench run but those of steps and trajectories, as HTML."""

import math
import statistics

from html_table import table
from step_tables import iso_error


def exponent(points):
    """Slope of log y over log x, least squares."""
    xs, ys = [math.log(x) for x, _ in points], [math.log(y) for _, y in points]
    return statistics.linear_regression(xs, ys).slope


def fps(cases):
    rows, growth = [], []
    for body in dict.fromkeys(c.fields["body"] for c in cases.values()):
        for method in dict.fromkeys(c.fields["method"] for c in cases.values()):
            chosen = [c for c in cases.values() if c.fields["body"] == body and c.fields["method"] == method]
            good = [c for c in chosen if c.runs]
            for c in chosen:
                values = [c.error] + 12 * [""]
                if c.runs:
                    low, high = c.quartiles("fps_full")
                    values = ["", len(c.runs), f"{c.median('steps'):g}", f"{c.median('fps_simulation'):.3g}",
                              f"{c.median('fps_full'):.3g}", f"{low:.3g}–{high:.3g}" if len(c.runs) > 1 else ""]
                    values += [f"{c.median('ms_' + key):.3g}" for key in ("step", "level_set", "adaption", "output")]
                    values += [f"{c.median('setup_s'):.2g}", f"{c.median('first_step_s'):.2g}",
                               f"{c.median('peak_memory_MB'):.0f}"]
                rows.append([f"{body} n={c.fields['n']:g} {method}", *values[1:], values[0]])
            if len(good) > 2:
                growth.append([f"{body} {method}"] + [
                    f"{-exponent([(c.median('vertices'), c.median(key)) for c in good]):.2f}"
                    for key in ("fps_simulation", "fps_full")])
    head = ["run", "runs", "steps", "fps simulation", "fps full", "quartiles", "step, ms", "level set, ms",
            "adaption, ms", "output, ms", "set-up, s", "first step, s", "peak memory, MB", "failure"]
    return ("<p>Time steps a second, and milliseconds of one: medians of the runs, each in a process of its own.</p>\n"
            + table(head, rows)
            + ("<p>Time of a step grows as vertices to the power of:</p>\n"
               + table(["run", "simulation", "full"], growth) if growth else ""))


def phases(cases):
    rows = []
    for c in cases.values():
        name = f"{c.fields['phase']} n={c.fields['n']:g}"
        if not c.runs:
            rows.append([name, "failed", "", "", "", ""])
            continue
        ms, low, high, rate = c.median("ms"), *c.quartiles("ms"), ""
        bound = f"{c.median('bound_ms'):.3g}" if c.values("bound_ms") else ""
        share = f"{100 * c.median('bound_ms') / ms:.0f} %" if bound else ""
        if c.values("triangles"):
            rate = f"{1e6 * ms / c.median('triangles'):.1f} ns a triangle"
        elif c.values("factor_MB"):
            rate = f"{2 * c.median('factor_MB') / ms:.3g} GB/s"
        elif c.values("Mflop"):
            rate = f"{c.median('Mflop') / ms:.3g} Gflop/s"
        elif c.values("voxels"):
            rate = f"{1e-3 * c.median('voxels') / ms:.3g} million voxels/s"
        rows.append([name, f"{ms:.3g}", f"{low:.3g}–{high:.3g}", bound, share, rate])
    runs = sorted({len(c.runs) for c in cases.values() if c.runs})
    return (f"<p>Median and quartiles of {' or '.join(map(str, runs))} runs. The bound is the memory that a phase must "
            "read, over the bandwidth at which as much is read again and again (as much of it from caches), or its "
            "floating-point operations over the peak of one thread. Near a size of a cache (L3, see above) both depend "
            "on what else runs: a share may come out over 100 % there.</p>\n"
            + table(["phase", "ms", "quartiles", "bound, ms", "of the bound", "rate"], rows))


# Rest state and times of drape-2pin by other codes, one thread of another machine: ms a step of 1/60 s.
OTHERS = [
    ("PositionBasedDynamics, XPBD 100x1", "15.6", "67.7", "280"),
    ("admm-elastic, 10 iterations", "6.3", "27.6", "70.5"),
    ("DiffCloth, projective dynamics to 1e-7", "43.6", "147", "335"),
    ("public code of Wolff et al. 2022, one Newton step", "19.5", "98", "308"),
    ("ARCSim 0.3.1, one Newton step", "18.2", "155", "723"),
]


def drape(cases):
    rests = []
    for c in cases.values():
        if c.kind != "rest":
            continue
        if not c.runs:
            rests.append([f"n={c.fields['n']:g} {c.fields['method']}", c.error, "", "", "", ""])
            continue
        rests.append([f"n={c.fields['n']:g} {c.fields['method']}", f"{c.median('ms'):.3g}",
                      f"{c.median('mean_sigma_1'):.5f}",
                      f"{c.median('others_sigma_1_low'):.5f} to {c.median('others_sigma_1_high'):.5f}",
                      f"{c.median('centre_sag_m'):.4f}",
                      f"{c.median('others_sag_low_m'):.4f} to {c.median('others_sag_high_m'):.4f}",
                      "yes" if c.median("agrees") else "no"])
    return ("<p>At rest, against four independent implicit codes; ms: mean of the 120 steps of the swing, one run, "
            "default settings.</p>\n"
            + table(["run", "ms a step", "mean sigma_1", "others", "centre sag, m", "others", "agrees"], rests,
                    marked_last=lambda text: text == "no")
            + "<p>Other codes, each at its defaults, one thread, on another machine; ms a step:</p>\n"
            + table(["code", "32²", "64²", "100²"], OTHERS) + iso_error(cases))


def rest_shape(cases):
    rows = []
    for c in cases.values():
        where = f"{c.fields['garment']} {c.fields['method']} {c.fields['tolerance']:g} {1e3 * c.fields['h']:g} ms"
        values = ["", "", "", c.error]
        if c.runs:
            values = [f"{1e-3 * c.median('ms'):.2f}", f"{100 * c.median('error'):.2f}",
                      f"{100 * c.median('share_over_limit'):.2f}", ""]
        rows.append([where, f"{c.fields['pass']:g}", *values])
    return table(["fit", "passes", "s", "error, %", "over the limit, %", "no result"], rows)


def cuts(cases):
    rows = []
    for c in cases.values():
        f = c.fields
        where = f"{f['garment']}{' symmetric' if f['symmetric'] == 'yes' else ''}, {f['distortion']:g}, {f['stage']}"
        values = [""] * 7
        if c.runs:
            values = [f"{c.median('pieces'):g}", f"{c.median('seams_m'):.2f}",
                      *(f"{100 * c.median(key):.2f}" for key in ("thread_mean", "thread_p99", "rigid_mean", "rigid_p99")),
                      f"{1e-3 * c.median('ms'):.1f}"]
        rows.append([where, *values])
    return table(["garment, weight, needless seams removed", "pieces", "m to sew", "threads, mean %", "p99 %",
                  "principal, mean %", "p99 %", "s"], rows)


def contact_stability(cases):
    rows = []
    for key in ("speed", "thickness"):
        for method in dict.fromkeys(c.fields["method"] for c in cases.values()):
            chosen = [c for c in cases.values() if c.fields["map"] == key and c.fields["method"] == method]
            grades = [int(c.median("grade")) for c in chosen]
            depths = [c.median("depth_mm") for c in chosen if c.values("depth_mm")]
            rows.append([f"{key} {method}", *(grades.count(g) for g in (2, 1, 0)), f"{max(depths, default=0):.2g}"])
    return table(["map", "converged", "degraded", "failed", "deepest, mm"], rows)


def stability(cases):
    rows = []
    for sheet in dict.fromkeys(c.fields["sheet"] for c in cases.values()):
        for method in dict.fromkeys(c.fields["method"] for c in cases.values()):
            chosen = [c for c in cases.values() if c.fields["sheet"] == sheet and c.fields["method"] == method]
            grades = [int(c.median("grade")) if c.runs else None for c in chosen]
            largest = [max((c.median(key) for c in chosen if c.values(key)), default=math.nan)
                       for key in ("error", "worst")]
            rows.append([f"{sheet} {method}", *(grades.count(g) for g in (2, 1, 0, None)),
                         *(f"{value:.2g}" for value in largest)])
    return ("<p>Places of the map by their grade, which is that of the mean error of a place's steps. No contact: the "
            "sheets are held by pins, or thrown.</p>\n"
            + table(["map", "converged", "degraded", "failed", "no reference", "largest mean error",
                     "largest of a single step"], rows))


def fuzz(cases):
    """How commands ended on damaged inputs; the last column marked where one did not end in order."""
    counts = ("tried", "done", "refused", "failed", "doubtful", "crashes", "hangs", "unclear", "silent")
    rows = [[c.name.partition("input:")[2].replace("_", " "),
             *(f"{c.median(key):g}" if c.runs else c.error for key in counts)] for c in cases.values()]
    sums = [sum(c.median(key) for c in cases.values() if c.runs) for key in counts]
    rows.append(["all", *(f"{total:g}" for total in sums)])
    for row in rows:
        row.append("no" if any(cell != "0" for cell in row[-4:]) else "yes")
    return ("<p>Inputs damaged at random, each read by a command in a process of its own: exit codes 0, 1 and 2; ended "
            "by a signal; not at all; without one clear line, or with files left half written.</p>\n"
            + table(["input", "tried", "0", "1", "2", "3", "crashes", "hangs", "unclear", "silent", "in order"], rows,
                    marked_last=lambda text: text == "no"))
