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
        return bool(self.error) and not self.error.startswith("not tried")

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
        if entry.get("error_occurred"):
            case.error = entry["error_message"]
            continue
        run = {"ms": entry["real_time"] * to_ms[entry["time_unit"]]}
        run.update({key: value for key, value in entry.items()
                    if isinstance(value, (int, float)) and key not in known})
        case.runs.append(run)
    return data["context"], cases


def write_csv(cases, file):
    """A line a case: fields, median, quartiles and mean of the time, median of each counter, what went wrong."""
    fields, counters = {}, {}
    for case in cases.values():
        fields.update(dict.fromkeys(case.fields))
        for run in case.runs:
            counters.update(dict.fromkeys(key for key in run if key != "ms"))
    with open(file, "w", newline="", encoding="utf-8") as stream:
        out = csv.writer(stream)
        out.writerow(["name", "runs", *fields, "ms_median", "ms_lower_quartile", "ms_upper_quartile", "ms_mean",
                      *counters, "error_message"])
        for case in cases.values():
            times = ["", "", "", ""]
            if case.runs:
                times = [case.median("ms"), *case.quartiles("ms"), case.mean("ms")]
            medians = [case.median(key) if case.values(key) else "" for key in counters]
            out.writerow([case.name, len(case.runs), *(case.fields.get(key, "") for key in fields),
                          *(f"{t:.6g}" if t != "" else "" for t in times),
                          *(f"{m:.6g}" if m != "" else "" for m in medians), case.error])
