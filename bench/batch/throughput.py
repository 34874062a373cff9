#!/usr/bin/env python3
"""What makes more garments an hour: as many jobs side by side as there are cores, each with one thread, or one job
after the other with all threads?  Measures both in turn, since the machine may have other work, and prints medians.

    bench/batch/throughput.py EASE SCENE [--repeat 5]
"""

import argparse
import json
import os
import pathlib
import resource
import statistics
import subprocess
import tempfile
import time


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ease")
    parser.add_argument("scene")
    parser.add_argument("--repeat", type=int, default=5)
    options = parser.parse_args()
    cores = len(os.sched_getaffinity(0))
    ratios = []
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(options.repeat):
            side, side_cpu = measured(lambda: run(options, folder, range(cores), 1))
            turn, turn_cpu = measured(lambda: [run(options, folder, [k], cores) for k in range(cores)])
            ratios.append(turn / side)
            print(f"{cores} jobs: side by side {side:.1f} s ({side_cpu:.1f} s of processor), one after the other "
                  f"{turn:.1f} s ({turn_cpu:.1f} s): side by side {turn / side:.2f} times as many an hour", flush=True)
        results = pathlib.Path(folder, "0")
        size = sum(file.stat().st_size for file in results.iterdir()) / 1e6
        memory = json.loads((results / "report.json").read_text(encoding="utf-8"))["peak_memory_MB"]
    print(f"side by side {statistics.median(ratios):.2f} times as many an hour (median of {len(ratios)}, "
          f"{min(ratios):.2f} to {max(ratios):.2f}); a job takes {memory:.0f} MB of memory and {size:.1f} MB of disk")


def run(options, folder, jobs, threads):
    """Runs jobs at the same time; ends when all have ended."""
    processes = []
    for job in jobs:
        command = [options.ease, "run", options.scene, "-o", f"{folder}/{job}", "--threads", str(threads)]
        processes.append(subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))
    for process in processes:
        if process.wait() not in (0, 3):
            raise SystemExit(f"throughput: {' '.join(process.args)}: ended with {process.returncode}")


def measured(work):
    """Seconds by the clock and of processor time that some work takes."""
    def processor():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime

    begin, cpu = time.monotonic(), processor()
    work()
    return time.monotonic() - begin, processor() - cpu


main()
