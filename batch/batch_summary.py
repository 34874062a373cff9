"""The summary of a batch: summary.csv for programs, summary.html for people, a row for each person and garment.

    python3 batch_summary.py OUT    of the plan in that folder
"""

import csv
import html
import io
import json
import os
import pathlib
import sys

from ease_job import last_words

FITS = "fits"
TIMES = ("run_s", "pattern_s")  # the only columns that differ when a batch is computed again
COLUMNS = ("person", "garment", "result", "why", "stretch_limit", "stretch_before", "stretch_after",
           "over_limit_before_percent", "over_limit_after_percent", "area_growth_percent", "largest_growth", "pieces",
           "warnings", *TIMES)


def summarise(plan, folder):
    """Writes summary.csv and summary.html of the rows of a plan, of whatever has been computed, into a folder."""
    folder = pathlib.Path(folder)
    rows = [row_of(entry, folder) for entry in plan]
    write_whole(folder / "summary.csv", csv_of(rows))
    write_whole(folder / "summary.html", html_of(rows, folder))
    return rows


def row_of(entry, folder):
    """One row, by the names in COLUMNS; cells that nothing is known of are empty."""
    results = folder / entry["person"] / entry["garment"]
    inputs = [results.with_name(results.name + ".toml"), *map(pathlib.Path, entry["files"])]
    row = dict.fromkeys(COLUMNS, "") | {"person": entry["person"], "garment": entry["garment"]}
    run = outcome(results, "run", inputs)
    if run is None:
        log = results.with_name(results.name + ".log")
        return row | {"result": "not finished", "why": shorten(why_stopped(log, inputs), results)}
    row |= {"run_s": f"{run['wall_s']:.1f}", "why": shorten(run["reason"], results)}
    if run["exit_code"] not in (0, 3):
        return row | {"result": "failed"}
    report = read_json(results / "report.json")
    row |= figures(report, doubtful=run["exit_code"] == 3)
    warnings = [shorten(text, results) for text in report.get("warnings", [])]
    if entry["pattern"]:
        inputs.append(results.with_name(results.name + ".run.json"))
        pattern = outcome(results, "pattern", inputs)
        if pattern is None:
            log = results.with_name(results.name + ".pattern.log")
            row |= {"result": "not finished", "why": "pattern: " + shorten(why_stopped(log, inputs), results)}
        elif pattern["exit_code"] == 0:
            made = report.get("pattern", {})
            row |= {"pattern_s": f"{pattern['wall_s']:.1f}", "pieces": str(len(made.get("pieces", [])))}
            warnings += [shorten(text, results) for text in made.get("warnings", [])]
        elif run["exit_code"] == 0:
            row |= {"result": "no pattern", "why": shorten(pattern["reason"], results)}
    return row | {"warnings": " | ".join(warnings)}


def figures(report, doubtful):
    """The figures of a finished run's report.json."""
    sigma = report["sigma_1"]
    after, before = sigma.get("after", sigma["run"]), sigma.get("before", {})
    target = report.get("adaption", {}).get("target", 0.0)
    if doubtful:
        result = "doubtful"
    elif "after" not in sigma:
        result = "not verified" if "limit" in sigma else "simulated"
    else:
        result = FITS if after["share_over_limit"] <= target else "too tight"
    row = {"result": result, "stretch_before": number(before.get("max")), "stretch_after": number(after["max"])}
    if result == "too tight":
        row["why"] = report["adaption"].get("reason", "")
    if "limit" in sigma:
        row |= {"stretch_limit": number(sigma["limit"]),
                "over_limit_before_percent": number(before.get("share_over_limit"), 100.0, 2),
                "over_limit_after_percent": number(after["share_over_limit"], 100.0, 2),
                "area_growth_percent": number(report["rest_growth"]["area_ratio"] - 1.0, 100.0, 2),
                "largest_growth": number(report["rest_growth"]["max"])}
    return row


def number(value, factor=1.0, digits=3):
    return "" if value is None else f"{factor * value:.{digits}f}"


def outcome(results, command, inputs):
    """What ease_job.py kept of a command; None where it has not ended since its inputs were written last."""
    file = results.with_name(f"{results.name}.{command}.json")
    return read_json(file) if is_newer(file, inputs) else None


def is_newer(file, inputs):
    """Whether a file is there, and no input was written after it."""
    if not file.is_file():
        return False
    written = file.stat().st_mtime_ns
    return all(not other.exists() or other.stat().st_mtime_ns <= written for other in inputs)


def read_json(file):
    return json.loads(file.read_text(encoding="utf-8"))


def why_stopped(log, inputs):
    """The last words of a job that left no outcome."""
    if not is_newer(log, inputs):
        return "not begun"
    return last_words(log) or "stopped before its first word"


def shorten(text, results):
    """A message without the paths of this batch, which the row says anyway."""
    scene = results.with_name(results.name + ".toml")
    for path in (scene.resolve(), scene):
        text = text.replace(f"{path}: ", "")
    return text.replace(f"{results.parent.parent.resolve()}/", "").replace(f"{results.parent.parent}/", "")


def write_whole(file, text):
    partial = file.with_name(file.name + ".partial")
    partial.write_text(text, encoding="utf-8")
    os.replace(partial, file)


def csv_of(rows):
    text = io.StringIO()
    writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()


STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; color: #222; background: #fbfbf9; margin: 0 auto; padding: 0 16px 48px;
  max-width: 1400px; }
.counts { font-size: 19px; } input { font: inherit; padding: 4px 8px; width: 280px; max-width: 90%; }
.wide { overflow-x: auto; } table { border-collapse: collapse; margin-top: 12px; }
th { text-align: left; font-weight: 600; border-bottom: 2px solid #888; cursor: pointer; vertical-align: bottom; }
th, td { padding: 4px 10px; } td { border-bottom: 1px solid #ddd; vertical-align: top; }
.n { text-align: right; white-space: nowrap; } 
.why { max-width: 340px; min-width: 180px; font-size: 13px; color: #555; }
img { width: 150px; height: auto; display: block; } .result { white-space: nowrap; border-left: 6px solid #d98a1f; }
.good { border-color: #2b6ca3; } .bad { border-color: #a32b2b; }
@media print { input { display: none; } tr { break-inside: avoid; } body { background: #fff; font-size: 11px; }
  img { width: 90px; } }
"""

SCRIPT = """
const body = document.querySelector("tbody");
document.querySelector("input").addEventListener("input", (typed) => {
  const word = typed.target.value.toLowerCase();
  for (const row of body.rows) row.hidden = !row.textContent.toLowerCase().includes(word);
});
document.querySelectorAll("th").forEach((head, column) => head.addEventListener("click", () => {
  const sign = head.dataset.sign = head.dataset.sign === "1" ? -1 : 1;
  const key = (row) => row.cells[column].textContent;
  const rows = Array.from(body.rows).sort((a, b) => sign * key(a).localeCompare(key(b), undefined, { numeric: true }));
  body.append(...rows);
}));
"""

HEADS = ("person", "garment", "result", "pictures", "largest stretch before → after",
         "over the limit before → after", "cloth added", "most let out", "pieces", "why, warnings", "time")


def html_of(rows, folder):
    """The page: counts in words, then a table that can be searched and sorted."""
    counts = {}
    for row in rows:
        counts[row["result"]] = counts.get(row["result"], 0) + 1
    people = len({row["person"] for row in rows})
    by_result = sorted(counts.items(), key=lambda count: (count[0] != FITS, count[0]))
    words = ", ".join(f"{count} {result}" for result, count in by_result)
    heads = "".join(f"<th>{head}</th>" for head in HEADS)
    lines = "".join(line_of(row, folder) for row in rows)
    return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>Summary</title>\n'
            f'<meta name="viewport" content="width=device-width, initial-scale=1"><style>{STYLE}</style></head><body>\n'
            f'<h1>Summary</h1>\n<p class="counts">{plural(len(rows), "garment", "garments")} of '
            f'{plural(people, "person", "people")}: {words}.</p>\n<p><input type="search" placeholder="show rows with '
            f'this word" aria-label="show rows with this word"> A click on a column sorts by it.</p>\n<div class="wide">'
            f'<table><thead><tr>{heads}</tr></thead><tbody>\n{lines}</tbody></table></div>\n<script>{SCRIPT}</script>\n'
            f'</body></html>\n')


def line_of(row, folder):
    name = f"{row['person']}/{row['garment']}"
    kind = {FITS: "good", "failed": "bad", "doubtful": "bad", "not finished": "bad"}.get(row["result"], "fair")

    def link(file, words):
        return f'<a href="{html.escape(file)}">{words}</a>' if (folder / file).is_file() else words

    pictures = [link(f"{name}/{file}", f'<img src="{html.escape(name)}/{file}" alt="{words}" loading="lazy">')
                for file, words in (("stretch.png", "stretch on the last pose"), ("pattern.png", "pattern"))
                if row["result"] not in ("failed", "not finished") and (folder / name / file).is_file()]
    warnings = [html.escape(part) for part in row["warnings"].split(" | ") if part]
    text = html.escape(row["why"])
    if warnings:
        text += (f'<details><summary>{plural(len(warnings), "warning", "warnings")}</summary>'
                 f'{"<br>".join(warnings)}</details>')
    cells = [("", link(f"{name}/fit.html", html.escape(row["person"]))), ("", html.escape(row["garment"])),
             (f"result {kind}", row["result"]), ("", "".join(pictures)),
             ("n", arrow(row["stretch_before"], row["stretch_after"])),
             ("n", arrow(percent(row["over_limit_before_percent"]), percent(row["over_limit_after_percent"]))),
             ("n", percent(row["area_growth_percent"])), ("n", row["largest_growth"] and "× " + row["largest_growth"]),
             ("n", row["pieces"] and link(f"{name}/pattern_a4.pdf", row["pieces"])), ("why", text),
             ("n time", " + ".join(row[time] + " s" for time in TIMES if row[time]))]
    return "<tr>" + "".join(f'<td class="{kind}">{cell}</td>' for kind, cell in cells) + "</tr>\n"


def arrow(before, after):
    return f"{before} → {after}" if before else after


def percent(text):
    return text and text + " %"


def plural(count, one, many):
    return f"{count} {one if count == 1 else many}"


if __name__ == "__main__":
    summarise(read_json(pathlib.Path(sys.argv[1], "plan.json")), sys.argv[1])
