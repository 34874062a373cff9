#!/usr/bin/env python3
"""Compares two results of the bench: time of B over time of A, run by run.

    bench/compare.py A B      two .json files of a bench program, or two folders of them

A repetition does the same work in both, so that each is compared with its like: the ratio of a case is the median over
its repetitions, its spread their quartiles.  A case is slower, or less accurate, beyond the noise where its lower
quartile is over 1.1 (time) or its median error over 1.5 times what it was; likewise, a case that fails and did not.
Exit codes: 0 no regression, 1 regressions, 2 nothing to compare.
"""

import json
import math
import statistics
import sys
from pathlib import Path

from results import Case, read_results

SLOWER = 1.1
LESS_ACCURATE = 1.5
ROUND_OFF = 1e-7  # errors below this are not compared


def fail(message):
    print(f"bench: {message}", file=sys.stderr)
    sys.exit(2)


def read(path):
    path = Path(path)
    files = sorted(path.glob("*.json")) if path.is_dir() else [path]
    cases = {}
    for file in files:
        try:
            cases.update({name: case for name, case in read_results(file)[1].items() if case.kind != "fuzz"})
        except (OSError, json.JSONDecodeError, KeyError, TypeError) as error:
            fail(f"{file}: not a result of Google Benchmark: {error}")
    if not cases:
        fail(f"{path}: no results")
    return cases


def compare(before: Case, after: Case):
    """Ratio of times with quartiles, and what has become worse ("" if nothing)."""
    if after.error and not before.error:
        return None, f"fails now: {after.error}"
    pairs = list(zip(before.values("ms"), after.values("ms")))
    if not pairs or before.error:
        return None, ""
    ratios = [b / a for a, b in pairs]
    lower, upper = (min(ratios), max(ratios)) if len(ratios) < 4 else statistics.quantiles(ratios, n=4)[::2]
    worse = "slower" if lower > SLOWER else ""
    if before.values("error") and after.values("error"):
        was, now = abs(before.median("error")), abs(after.median("error"))
        if now > LESS_ACCURATE * max(was, ROUND_OFF):
            worse = f"{worse}, less accurate ({was:.2g} to {now:.2g})".lstrip(", ")
    return (statistics.median(ratios), lower, upper), worse


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    before, after = read(sys.argv[1]), read(sys.argv[2])
    common = [name for name in before if name in after]
    if not common:
        fail("the two results have no case in common")
    ratios, regressions = [], 0
    print(f"{'B/A':>6}  {'quartiles':>13}  case")
    for name in common:
        ratio, worse = compare(before[name], after[name])
        regressions += bool(worse)
        if ratio:
            ratios.append(ratio[0])
        numbers = f"{ratio[0]:6.3f}  {ratio[1]:6.3f} {ratio[2]:6.3f}" if ratio else " " * 21
        print(f"{numbers}  {name}{'   <-- ' + worse if worse else ''}")
    for name in sorted(set(before) ^ set(after)):
        print(f"{'':21}  {name}   only in {'A' if name in before else 'B'}")
    if ratios:
        print(f"B/A, geometric mean of {len(ratios)} cases: {math.exp(statistics.fmean(map(math.log, ratios))):.3f}")
    print(f"{regressions} regression{'' if regressions == 1 else 's'} beyond the noise in {len(common)} cases")
    sys.exit(1 if regressions else 0)


main()
