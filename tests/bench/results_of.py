"""Results as Google Benchmark writes them, made up for tests."""


def results_of(cases):
    """`cases`: name -> (milliseconds of each repetition, counters), or a string: why it failed.  Of the milliseconds a
    string is why that repetition has no result."""
    benchmarks = []
    for name, what in cases.items():
        entry = {"name": f"{name}/iterations:1/repeats:3/manual_time", "run_type": "iteration"}
        entry["run_name"] = entry["name"]
        if isinstance(what, str):
            benchmarks.append({**entry, "error_occurred": True, "error_message": what})
            continue
        times, counters = what
        for ms in times:
            if isinstance(ms, str):
                benchmarks.append({**entry, "real_time": 0.0, "time_unit": "ms", "no_result": 1.0, "label": ms})
                continue
            benchmarks.append({**entry, "real_time": ms, "cpu_time": ms, "time_unit": "ms", **counters})
        benchmarks.append({**entry, "run_type": "aggregate", "aggregate_name": "median", "real_time": 1e9,
                           "time_unit": "ms"})
    context = {"date": "today", "num_cpus": 2, "caches": [], "load_avg": [0.5], "commit": "abc123-dirty",
               "libraries": "libtbb.so.12.8 libcholmod.so.3.0.14"}
    return {"context": context, "benchmarks": benchmarks}
