"""The charts of a bench run but those of time against accuracy: each function draws what the cases have and returns
(stem, caption) pairs."""

from gnuplot import Panel, draw
from step_tables import TARGETS, fastest
from work_precision import DEFINITION, by_method, distinct, time_range

# Wolff et al. 2022, table 1: vertices and frames per second of the simulation alone.
PAPER = [(1103, 8.3), (3032, 4.0), (4270, 1.8)]
PAPER_NAME = "paper's table 1, on another machine of 12 cores"
# The same work's public code, all included, on the shirts on scans with arms going up, one thread of another machine;
# without a test that never fires, which takes up to four fifths of its time.
PUBLIC_CODE = [(1100, 19.0), (3031, 8.1), (4271, 5.6), (10000, 2.3), (20007, 1.2)]
PUBLIC_CODE_NAME = "its public code, one thread of another machine"
# Sharp and Crane's public code on the shirt of 4,271 vertices, measured once: metres of seam, and principal stretch of
# its cuts flattened as rigidly as possible, %, for weights of distortion 3, 10, 30 and 100.
PUBLISHED_CUTS = [(2.63, 2.29), (2.88, 1.84), (3.43, 1.60), (4.81, 1.05)]
# The stretch of threads on its cuts for weight 10, flattened for woven cloth; parafashion's own on a mirrored shirt.
PUBLISHED_THREADS = {"published code": [(2.88, 0.72)], "parafashion, shear 37°": [(2.47, 0.58)]}


def fps_rows(cases, bodies, published):
    """A row of panels for each body; `published` adds the figures of others."""
    garments = {"mannequin": "built-in T-shirt", "pass": "built-in T-shirt, a pass", "scan": "T-shirts on scans"}
    rows = []
    for body in bodies:
        row = []
        for key, what in (("fps_simulation", "simulation alone"), ("fps_full", "with level sets, adaption, output")):
            curves, marks = {}, {}
            for method, chosen in by_method([c for c in cases.values() if c.fields["body"] == body]).items():
                good = [c for c in chosen if c.runs]
                curves[method] = [(c.median("vertices"), c.median(key), *c.quartiles(key)) for c in good]
                marks[method] = [(c.fields["n"], 0.1) for c in chosen if not c.runs]
            if published and key == "fps_simulation":
                curves[PAPER_NAME] = [(n, fps, fps, fps) for n, fps in PAPER]
            elif published and body == "scan":
                curves[PUBLIC_CODE_NAME] = [(n, fps, fps, fps) for n, fps in PUBLIC_CODE]
            row.append(Panel(f"{garments[body]}: {what}", curves, marks))
        rows.append(row)
    return rows


def draw_fps(directory, cases):
    bodies = distinct(cases.values(), "body")
    ranges = {"y_range": "0.005:1000", "x_range": "600:150000", "marked": "failed", "small": True}
    stem, of_pass = directory / "fps", directory / "fps_pass"
    draw(stem, "Time steps per second against vertices: the main job", "vertices of the garment",
         "time steps of 0.0025 s per second", fps_rows(cases, [b for b in bodies if b != "pass"], True),
         note="median and quartiles, one run from 30,000 vertices on; pd: ten iterations a step, most of contact's "
              "error left", **ranges)
    drawn = [(stem, "The main job: moving body, contact, adaption every 8th step. Setting up is not counted.")]
    if "pass" in bodies:
        draw(of_pass, "Time steps per second against vertices: a pass of a fit", "vertices of the garment",
             "time steps of 0.0125 s per second", fps_rows(cases, ["pass"], False),
             note="median and quartiles, one run from 30,000 vertices on", **ranges)
        drawn.append((of_pass, "The first pass of a fit with the settings of scenes/t-shirt.toml: longer steps, folds "
                               "that are damped, cloth that gives way to compression."))
    return drawn


def draw_rest_shape(directory, cases):
    """Two panels for each garment: error of the rest shape, and share over the limit, against time."""
    rows = []
    for garment in dict.fromkeys(c.fields["garment"] for c in cases.values()):
        row = []
        for key, label, factor, least in (("error", "error of the rest edges, RMS, %", 100, 1e-3),
                                          ("share_over_limit", "triangles over the limit in one replay, %", 100, 1e-2)):
            curves = {}
            for case in cases.values():
                if case.runs and case.fields["garment"] == garment:
                    name = "{method} {tolerance:g}, {ms:g} ms".format(ms=1e3 * case.fields["h"], **case.fields)
                    y = max(factor * case.median(key), least)
                    if key == "error" and y == least:
                        continue  # the reference itself
                    curves.setdefault(name, []).append((1e-3 * case.median("ms"), y, y, y))
            row.append(Panel(f"{garment}: {label}", curves, y_label="%", y_range="0.008:100"))
        rows.append(row)
    stem = directory / "rest_shape"
    draw(stem, "Error of the rest shape against wall time", "s, of the passes until then", "", rows,
         panel_size=(430, 300), small=True,
         note="a point a pass; method, tolerance, time step; error against the last rest shape of auto 0.01, 2.5 ms")
    return [(stem, "A fit lets the rest shape out after every pass. Each point is the rest shape after so many passes; "
                   "0.01 % over the limit means none.")]


def draw_cuts(directory, cases):
    """Two panels for each garment: stretch of threads and principal stretch against metres to sew, over the weights."""
    rows = []
    for garment in dict.fromkeys(c.fields["garment"] for c in cases.values()):
        row = []
        for key, label in (("thread_mean", "threads, mean"), ("rigid_mean", "principal stretch, mean")):
            curves = {}
            for case in cases.values():
                if case.runs and case.fields["garment"] == garment:
                    name = ("symmetric" if case.fields["symmetric"] == "yes" else "free") + {
                        "before": ", as the flow ends", "after": ""}[case.fields["stage"]]
                    y = 100 * case.median(key)
                    curves.setdefault(name, []).append((case.median("seams_m"), y, y, y))
            published = {}
            if garment == "shirt_4270":
                published = PUBLISHED_THREADS if key == "thread_mean" else {"published code": PUBLISHED_CUTS}
            curves.update({name: [(x, y, y, y) for x, y in points] for name, points in published.items()})
            row.append(Panel(f"{garment.replace('_', ' ')}: {label}", {k: sorted(v) for k, v in curves.items()}, y_label="%",
                             y_range="0.3:5"))
        rows.append(row)
    stem = directory / "cuts"
    stretch = "set ytics (0.3, 0.5, 1, 2, 4); set format y '%g'"
    draw(stem, "Seams that are found: stretch against sewing", "metres to sew, without darts", "", rows,
         x_range="1.5:6", panel_size=(430, 270), small=True, tics="set xtics (1.5, 2, 3, 4, 5, 6); set format x '%g'; " + stretch, bare_tics="set xtics ('' 1); " + stretch,
         note="a point a weight of distortion, 1 to 100; published: shirt_4270, shirt_3032, measured once, not by this run")
    return [(stem, "Weights of distortion from 1 to 100, length 5. Principal stretch is that of pieces flattened as "
                   "rigidly as possible, which is how the published code's cuts were measured.")]


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
    panels = [Panel("once", taken, y_label="ms (median, quartiles)", y_range="0.01:5000"),
              Panel("beside the machine's bound", share, y_label="share of the bound, %", y_range="0.3:200")]
    draw(stem, "Phases of a step", "vertices", "", [panels], x_range="700:150000", panel_size=(430, 300))
    return [(stem, "What each phase takes once, and how near it comes to the machine's bandwidth or peak.")]


GRADES = ("failed", "degraded", "converged")
NO_REFERENCE = "no reference"


def draw_stability(directory, cases):
    """A map for each method and sheet: time step across, stiffness up."""
    methods = list(by_method(list(cases.values())))
    rows = []
    for sheet in dict.fromkeys(c.fields["sheet"] for c in cases.values()):
        row = []
        for method in methods:
            panel = Panel(f"{method}, {sheet}", {grade: [] for grade in (*reversed(GRADES), NO_REFERENCE)})
            for case in cases.values():
                if case.fields["sheet"] == sheet and case.fields["method"] == method:
                    k, grade = case.fields["k"], GRADES[int(case.median("grade"))] if case.runs else NO_REFERENCE
                    panel.curves[grade].append((case.fields["h"], k, k, k))
            row.append(panel)
        rows.append(row)
    stem = directory / "stability"
    draw(stem, "Where methods fail: time step against stiffness", "time step, s", "stiffness, N/m", rows,
         x_range="0.0007:0.3", y_range="3:3e6", lines=False, panel_size=(165, 170), small=True,
         tics="set xtics ('1/960' 1/960., '1/120' 1/120., '1/20' 1/20., '1/5' 1/5.) font ',8'",
         bare_tics="set xtics ('' 1/960., '' 1/120., '' 1/20., '' 1/5.)",
         note="converged: mean error of the steps at most 10 %; failed: stopped, exploded, or no better than no step; "
              "no contact\nerror: relative, as a scene's tolerance means it; hanging: or the root of the energy gap, "
              "where that is less")
    return [(stem, "The first steps from the start of each sheet, every method with its defaults; the sheets touch "
                   "nothing.")]


def draw_contact_stability(directory, cases):
    """A map for each method: time step across, speed of the plate or its thickness up."""
    rows = []
    for key, unit in (("speed", "m/s"), ("thickness", "m")):
        row = []
        for method, chosen in by_method([c for c in cases.values() if c.fields["map"] == key]).items():
            panel = Panel(f"{method}, {key}, {unit}", {grade: [] for grade in reversed(GRADES)},
                          y_range="0.05:20" if key == "speed" else "0.0003:0.1")
            for case in chosen:
                value = case.fields[key]
                panel.curves[GRADES[int(case.median("grade"))]].append((case.fields["h"], value, value, value))
            row.append(panel)
        rows.append(row)
    stem = directory / "contact_stability"
    draw(stem, "Where methods let cloth through: a plate pushes a free sheet", "time step, s",
         "speed of the plate; its thickness", rows, x_range="0.0007:0.05", lines=False, panel_size=(165, 190),
         small=True, tics="set xtics ('1/960' 1/960., '1/240' 1/240., '1/60' 1/60.) font ',8'",
         bare_tics="set xtics ('' 1/960., '' 1/240., '' 1/60.)",
         note="converged: at most 0.1 mm deep, no vertex faster than 3 times the plate; failed: stopped, or cloth "
              "behind the plate's front")
    return [(stem, "The plate is 20 mm thick in the upper row and moves at 1 m/s in the lower; voxels of 10 mm.")]


def draw_drape(directory, cases):
    """Time of a step of drape-2pin at equal error, against the number of vertices."""
    row = []
    steps = [c for c in cases.values() if c.kind == "step"]
    for target in TARGETS:
        curves = {}
        for n in distinct(steps, "n"):
            for method in by_method(steps):
                case = fastest([c for c in steps if c.fields["n"] == n], method, target)
                if case:
                    curves.setdefault(method, []).append((n, case.median("ms"), *case.quartiles("ms")))
        row.append(Panel(f"error at most {target:g}", curves))
    stem = directory / "drape_2pin"
    draw(stem, "drape-2pin, k = 1000 N/m: a step of 1/60 s", "vertices", "ms a step (median, quartiles)", [row],
         x_range="700:15000", y_range=time_range([row]), panel_size=(220, 250), note=DEFINITION)
    return [(stem, "Where a method is missing, it does not reach that error within the limits.")]
