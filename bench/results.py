"""Reads what a bench program wrote: JSON as Google Benchmark writes it, a repetition an entry."""

import csv
import json
import re
import statistics

# What Google Benchmark itself appends to a name.
APPENDED = re.compile(r"(/min_time:[\d.]+)?(/iterations:\d+)?(/repeats:\d+)?(/process_time)?(/(real|manual)_time)?$")


class Case:
    """One benchmark: its name's fields ("method:newton" -> fields["method"] == "newton"), and its repetitions."""

    def __init__(self, name):
        self.name = name
        self.kind = name.split("/")[0]
        self.fields = {}
        for part in name.split("/")[1:]:
            key, separator, value = part.partition(":")
            if separator:
                self.fields[key] = as_number(value)
        self.runs = []  # dictionaries: milliseconds "ms", and the counters
        self.error = ""  # why it failed, or was not tried

    @property
    def failed(self):
        return bool(self.error) and not self.untried

    @property
    def untried(self):
        """Not tried, since a looser setting took too long already."""
        return self.error.startswith("not tried")

    def values(self, key):
        return [run[key] for run in self.runs if key in run]

    def median(self, key):
        return statistics.median(self.values(key))

    def mean(self, key):
        return statistics.fmean(self.values(key))

    def quartiles(self, key):
        """Lower quartile and upper quartile."""
        values = sorted(self.values(key))
        if len(values) < 2:
            return values[0], values[0]
        cuts = statistics.quantiles(values, n=4, method="inclusive")
        return cuts[0], cuts[2]

    def knob(self):
        """The setting that is turned: its key and value; ("none", 1) where there is none."""
        after = list(self.fields.items())[list(self.fields).index("method") + 1:]
        return after[0] if after else ("none", 1.0)


SPREAD = ("error", "fps_simulation", "fps_full")  # counters whose quartiles a .csv has, beside those of the time


def as_number(text):
    try:
        return float(text)
    except ValueError:
        return text


def read_results(file):
    """The machine and settings that Google Benchmark noted, and all cases by name, in their order."""
    with open(file, encoding="utf-8") as stream:
        data = json.load(stream)
    cases = {}
    known = ("real_time", "cpu_time", "iterations", "repetitions", "repetition_index", "threads", "family_index",
             "per_family_instance_index")
    to_ms = {"ns": 1e-6, "us": 1e-3, "ms": 1.0, "s": 1e3}
    for entry in data["benchmarks"]:
        if entry.get("run_type") == "aggregate":
            continue
        name = APPENDED.sub("", entry.get("run_name", entry["name"]), count=1)
        case = cases.setdefault(name, Case(name))
        if entry.get("error_occurred") or entry.get("no_result"):
            why = entry.get("error_message") or entry["label"]
            if not why.startswith("not repeated"):  # since the runs before took long enough
                case.error = why
            continue
        run = {"ms": entry["real_time"] * to_ms[entry["time_unit"]]}
        run.update({key: value for key, value in entry.items()
                    if isinstance(value, (int, float)) and key not in known})
        case.runs.append(run)
    return data["context"], cases


def write_csv(cases, file):
    """A line a case: runs, fields, median, quartiles and mean of the time, median of each counter and quartiles of
    some, what went wrong."""
    fields, counters = {}, {}
    for case in cases.values():
        fields.update(dict.fromkeys(case.fields))
        for run in case.runs:
            counters.update(dict.fromkeys(key for key in run if key != "ms"))
    spread = [key for key in SPREAD if key in counters]
    with open(file, "w", newline="", encoding="utf-8") as stream:
        out = csv.writer(stream)
        out.writerow(["name", "runs", *fields, "ms_median", "ms_lower_quartile", "ms_upper_quartile", "ms_mean",
                      *counters, *(f"{key}_{which}_quartile" for key in spread for which in ("lower", "upper")),
                      "error_message"])
        for case in cases.values():
            numbers = ["", "", "", ""]
            if case.runs:
                numbers = [case.median("ms"), *case.quartiles("ms"), case.mean("ms")]
            numbers += [case.median(key) if case.values(key) else "" for key in counters]
            for key in spread:
                numbers += case.quartiles(key) if case.values(key) else ("", "")
            out.writerow([case.name, len(case.runs), *(case.fields.get(key, "") for key in fields),
                          *(f"{v:.6g}" if v != "" else "" for v in numbers), case.error])
