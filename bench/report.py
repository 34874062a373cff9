#!/usr/bin/env python3
"""Makes tables, charts and report.html of what the bench programs left in a folder.

    bench/report.py DIRECTORY [--command TEXT]

Reads DIRECTORY/*.json (Google Benchmark's) and DIRECTORY/run.tsv (a program's name, command and seconds a line, if
script/bench wrote it), writes a .csv beside each .json, charts as .svg and .png, and report.html with all of it inside.
Exit code 1 where a claim of the project does not hold (claims.py), with a line for each.
"""

import argparse
import html
import os
import platform
import re
import subprocess
import sys
from pathlib import Path

import charts
import step_tables
import tables
import work_precision
from claims import broken
from html_table import table
from results import read_results, write_csv

PAGE = """<!DOCTYPE html>
<html lang="en"><meta charset="utf-8"><title>Ease: bench</title>
<style>
body {{ font: 15px/1.45 'DejaVu Sans', sans-serif; max-width: 1100px; margin: 2em auto; padding: 0 1em; color: #222 }}
figure {{ margin: 1.5em 0 }} figure svg {{ max-width: 100%; height: auto }} figcaption {{ color: #555 }}
table {{ border-collapse: collapse; margin: 1em 0 }} td, th {{ padding: .15em .7em; text-align: right }}
th {{ border-bottom: 1px solid #888 }} td:first-child, th:first-child {{ text-align: left }}
pre {{ background: #f4f4f4; padding: .6em; overflow-x: auto }} .bad {{ background: #f7c6b0 }}
</style>
<h1>Ease: bench</h1>
{body}
</html>
"""


def output_of(*command):
    try:
        run = subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError:
        return "unknown"
    return run.stdout.strip() if run.returncode == 0 and run.stdout.strip() else "unknown"


def machine(contexts):
    """Rows of what the figures were measured with: what all programs say, and what each loaded."""
    model = "unknown"
    try:
        for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                model = line.partition(":")[2].strip()
                break
    except OSError:
        pass
    first = next(iter(contexts.values()))
    caches = ", ".join(f"L{c['level']} {c['type'].lower()} {c['size'] // 1024} KiB" for c in first.get("caches", []))
    return [
        ("processor", f"{model}, {first.get('num_cpus', '?')} logical cores, {first.get('mhz_per_cpu', '?')} MHz"),
        ("caches", caches or "unknown"),
        ("memory", f"{os.sysconf('SC_PAGE_SIZE') * os.sysconf('SC_PHYS_PAGES') / 1e9:.0f} GB"),
        ("threads", "all cores, but for what says otherwise"),
        ("system", f"{platform.system()} {platform.release()}"),
        ("Ease", ", ".join(sorted({commit_of(context) for context in contexts.values()}))),
        ("compiler", said_by(contexts, "compiler")),
        ("build type", said_by(contexts, "build_type")),
        ("flags", said_by(contexts, "flags")),
        ("Eigen", said_by(contexts, "eigen")),
        ("libraries, as loaded", ", ".join(sorted({name for context in contexts.values()
                                                   for name in context.get("libraries", "").split()}))),
        ("gnuplot, Python", f"{output_of('gnuplot', '--version')}, Python {platform.python_version()}"),
    ]


def said_by(contexts, key):
    said = dict.fromkeys(context[key].strip() for context in contexts.values() if key in context)
    return "; ".join(said) or "unknown"


def commit_of(context):
    """What `git describe --always --dirty` said when the program was run."""
    commit = context.get("commit", "unknown")
    if commit == "unknown":
        return "commit unknown"
    clean = not commit.endswith("-dirty")
    return f"commit {commit.removesuffix('-dirty')}, {'nothing' if clean else 'something'} changed since"


def programs(contexts, directory):
    """A row for each program that ran: its command, when it began, how long it took, how busy the machine was then."""
    commands, seconds = {}, {}
    run = directory / "run.tsv"
    if run.exists():
        for line in run.read_text(encoding="utf-8").splitlines():
            program, commands[program], seconds[program] = line.split("\t")
    names = dict.fromkeys([*commands, *contexts])
    return [(name, commands.get(name, contexts.get(name, {}).get("executable", "")), seconds.get(name, "–"),
             contexts.get(name, {}).get("date", "–"),
             ", ".join(f"{v:.2f}" for v in contexts.get(name, {}).get("load_avg", [])) or "–") for name in names]


def figure(stem, caption):
    svg = stem.with_suffix(".svg").read_text(encoding="utf-8")
    svg = re.sub(r"^.*?(?=<svg)", "", svg, flags=re.DOTALL)
    # gnuplot's symbols have the same names in every drawing.
    svg = re.sub(r"(id='|#)gp", rf"\1{stem.name}_gp", svg)
    return f"<figure>{svg}<figcaption>{html.escape(caption)}</figcaption></figure>\n"


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("directory", type=Path)
    arguments.add_argument("--command", default="script/bench", help="what the report says it was made with")
    chosen = arguments.parse_args()
    files = sorted(chosen.directory.glob("*.json"))
    if not files:
        raise SystemExit(f"bench: {chosen.directory}: no .json of a bench program")

    contexts, everything = {}, {}
    for file in files:
        contexts[file.stem], cases = read_results(file)
        write_csv(cases, file.with_suffix(".csv"))
        everything[file.stem] = cases
    body = "<h2>Measured with</h2>\n" + table(["what", ""], machine(contexts))
    body += f"<pre>{html.escape(chosen.command)}</pre>\n"
    body += table(["program", "command", "wall time, s", "began", "load average then (1, 5, 15 minutes)"],
                  programs(contexts, chosen.directory))
    body += ("<p>Figures are medians of the runs, spreads their quartiles, unless it says otherwise. Every figure is "
             "in the .csv files beside this report, every repetition in the .json files.</p>\n")
    wrong = broken(everything)
    body += "<p>Claims that this run refutes: "
    body += "</p>\n" + table(["case"], [[line] for line in wrong]) if wrong else "none.</p>\n"
    for heading, program, draw_charts, make_tables in SECTIONS:
        cases = everything.get(program)
        if not cases:
            continue
        body += f"<h2>{heading}</h2>\n"
        body += "".join(make(cases) for make in make_tables)
        for draw in draw_charts:
            body += "".join(figure(stem, caption) for stem, caption in draw(chosen.directory, cases))
    (chosen.directory / "report.html").write_text(PAGE.format(body=body), encoding="utf-8")
    print(f"bench: report in {chosen.directory / 'report.html'}")
    for line in wrong:
        print(f"bench: does not hold: {line}", file=sys.stderr)
    sys.exit(1 if wrong else 0)


SECTIONS = [
    ("Speed against accuracy", "speed_accuracy", [work_precision.draw_step, work_precision.draw_trajectory],
     [step_tables.iso_error, step_tables.trajectories, step_tables.other_errors, step_tables.set_up]),
    ("The rest shape against time", "rest_shape", [charts.draw_rest_shape], [tables.rest_shape]),
    ("Seams that are found", "cuts", [charts.draw_cuts], [tables.cuts]),
    ("The scene drape-2pin", "drape_2pin", [charts.draw_drape, work_precision.draw_step], [tables.drape]),
    ("Time steps per second against vertices", "fps", [charts.draw_fps], [tables.fps]),
    ("Where the time goes", "phases", [charts.draw_phases], [tables.phases]),
    ("Where methods fail", "stability", [charts.draw_stability], [tables.stability]),
    ("Where methods let cloth through", "contact_stability", [charts.draw_contact_stability],
     [tables.contact_stability]),
    ("Damaged inputs", "fuzz", [], [tables.fuzz]),
]

main()
