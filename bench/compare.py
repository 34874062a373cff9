#!/usr/bin/env python3
"""Compares two results of the bench: time of B over time of A, run by run.

    bench/compare.py A B      two .json files of a bench program, or two folders of them

A repetition does the same work in both, so that each is compared with its like: the ratio of a case is the median over
its repetitions, its spread their quartiles; of three or fewer repetitions, the least and the largest ratio; of a single
one, 1.25 to either side.  Worse beyond the noise is a case

    whose lower end of that spread is over 1.1: slower;
    whose median error is over twice what it was, and over 1e-6; of the hanging sheet, where positions of two good
    solvers differ, whose energy gap is over ten times what it was, and over 1e-4;
    whose grade of stability has fallen (times of that map are not compared: its steps take microseconds), or whose
    rest state agrees no more;
    of damaged inputs, of which more crash, hang or end unclearly (their times are not compared);
    that fails, and did not.

Settings that either did not try, since looser ones took too long, are not compared.
Exit codes: 0 no regression, 1 regressions, 2 nothing to compare.
"""

import json
import math
import statistics
import sys
from pathlib import Path

from results import Case, read_results

SLOWER = 1.1
SINGLE_RUN = 1.25  # noise of a case that ran once
# An error has grown if it is this many times as large as before; errors below the second number do not count.
ERROR = (2.0, 1e-6)
ENERGY_GAP = (10.0, 1e-4)
GRADES = ("failed", "degraded", "converged")
DISORDERS = ("crashes", "hangs", "unclear")  # of damaged inputs, whose times are not compared


def fail(message):
    print(f"bench: {message}", file=sys.stderr)
    sys.exit(2)


def read(path):
    path = Path(path)
    files = sorted(path.glob("*.json")) if path.is_dir() else [path]
    cases = {}
    for file in files:
        try:
            cases.update(read_results(file)[1])
        except (OSError, json.JSONDecodeError, KeyError, TypeError) as error:
            fail(f"{file}: not a result of Google Benchmark: {error}")
    if not cases:
        fail(f"{path}: no results")
    return cases


def ratio_of_times(before, after):
    """Median of the ratios and its spread; None: there is nothing to compare."""
    ratios = [b / a for a, b in zip(before.values("ms"), after.values("ms")) if a > 0.0]
    if not ratios:
        return None
    middle = statistics.median(ratios)
    if len(ratios) == 1:
        return middle, middle / SINGLE_RUN, middle * SINGLE_RUN
    if len(ratios) < 4:
        return middle, min(ratios), max(ratios)
    return middle, *statistics.quantiles(ratios, n=4)[::2]


def less_accurate(before, after):
    """What to say where errors have grown beyond the noise, or ""."""
    key, (factor, least) = ("energy_gap", ENERGY_GAP) if before.fields.get("sheet") == "hanging" else ("error", ERROR)
    if not before.values(key) or not after.values(key):
        return ""
    was, now = max(before.median(key), 0.0), max(after.median(key), 0.0)  # a gap below 0 is a better minimum
    return f"less accurate ({was:.2g} to {now:.2g})" if now > max(factor * was, least) else ""


def compare(before: Case, after: Case):
    """Ratio of times with its spread, and what has become worse ("" if nothing)."""
    if after.failed and before.runs and not before.error:
        return None, f"fails now: {after.error}"
    if not before.runs or not after.runs or before.error or after.error:
        return None, ""
    if before.values("grade") and after.values("grade"):
        was, now = int(before.median("grade")), int(after.median("grade"))
        return None, f"{GRADES[was]} before, {GRADES[now]} now" if now < was else ""
    if before.kind == "fuzz":
        more = [what for what in DISORDERS if after.median(what) > before.median(what)]
        return None, f"more {', '.join(more)}" if more else ""
    ratio = ratio_of_times(before, after)
    worse = ["slower"] if ratio and ratio[1] > SLOWER else []
    worse += filter(None, [less_accurate(before, after)])
    if before.values("agrees") and before.median("agrees") > after.median("agrees"):
        worse.append("the rest state agrees no more")
    return ratio, ", ".join(worse)


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    before, after = read(sys.argv[1]), read(sys.argv[2])
    common = [name for name in before if name in after]
    if not common:
        fail("the two results have no case in common")
    ratios, regressions = [], 0
    print(f"{'B/A':>6}  {'spread':>13}  case")
    for name in common:
        ratio, worse = compare(before[name], after[name])
        regressions += bool(worse)
        if ratio:
            ratios.append(ratio[0])
        numbers = f"{ratio[0]:6.3f}  {ratio[1]:6.3f} {ratio[2]:6.3f}" if ratio else " " * 21
        if before[name].untried or after[name].untried:
            worse = "not tried in " + " and ".join(which for which, cases in (("A", before), ("B", after))
                                                   if cases[name].untried)
        print(f"{numbers}  {name}{'   <-- ' + worse if worse else ''}")
    for name in sorted(set(before) ^ set(after)):
        print(f"{'':21}  {name}   only in {'A' if name in before else 'B'}")
    if ratios:
        print(f"B/A, geometric mean of {len(ratios)} cases: {math.exp(statistics.fmean(map(math.log, ratios))):.3f}")
    print(f"{regressions} regression{'' if regressions == 1 else 's'} beyond the noise in {len(common)} cases")
    sys.exit(1 if regressions else 0)


main()
