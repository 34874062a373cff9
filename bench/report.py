#!/usr/bin/env python3
"""Makes tables, charts and report.html of what the bench programs left in a folder.

    bench/report.py DIRECTORY [--command TEXT]

Reads DIRECTORY/*.json (Google Benchmark's), writes a .csv beside each, charts as .svg and .png, and report.html with
all of it inside.
"""

import argparse
import html
import platform
import re
import subprocess
from pathlib import Path

import charts
import tables
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


def machine(context):
    """Rows of what the figures were measured with."""
    model = "unknown"
    try:
        for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                model = line.partition(":")[2].strip()
                break
    except OSError:
        pass
    root = Path(__file__).parent.parent
    caches = ", ".join(f"L{c['level']} {c['type'].lower()} {c['size'] // 1024} KiB" for c in context.get("caches", []))
    return [
        ("processor", f"{model}, {context.get('num_cpus', '?')} logical cores"),
        ("caches", caches or "unknown"),
        ("system", f"{platform.system()} {platform.release()}"),
        ("compiler", output_of("c++", "--version").splitlines()[0]),
        ("Ease", output_of("git", "-C", str(root), "describe", "--always", "--dirty")),
        ("gnuplot, Python", f"{output_of('gnuplot', '--version')}, Python {platform.python_version()}"),
        ("measured", context.get("date", "unknown")),
        ("load average at the start", ", ".join(f"{v:.2f}" for v in context.get("load_avg", []))),
    ]


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

    context, everything = {}, {}
    for file in files:
        context, cases = read_results(file)
        write_csv(cases, file.with_suffix(".csv"))
        everything[file.stem] = cases
    body = "<h2>Measured with</h2>\n" + tables.table(["what", ""], machine(context))
    body += f"<pre>{html.escape(chosen.command)}</pre>\n"
    body += "<p>Every figure is in the .csv files beside this report, every repetition in the .json files.</p>\n"
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


SECTIONS = [
    ("Speed against accuracy", "speed_accuracy", [charts.draw_step, charts.draw_trajectory], [tables.iso_error]),
    ("The scene drape-2pin", "drape_2pin", [charts.draw_drape, charts.draw_step], [tables.drape]),
    ("Time steps per second against vertices", "fps", [charts.draw_fps], [tables.fps]),
    ("Where the time goes", "phases", [charts.draw_phases], [tables.phases]),
    ("Where methods fail", "stability", [charts.draw_stability], [tables.stability]),
    ("Damaged inputs", "fuzz", [], [tables.fuzz]),
]

main()
