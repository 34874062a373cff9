"""Results as Google Benchmark writes them, made up for tests."""


def results_of(cases):
    """`cases`: name -> (milliseconds of each repetition, counters), or a string: why it failed."""
    benchmarks = []
    for name, what in cases.items():
        entry = {"name": f"{name}/iterations:1/repeats:3/manual_time", "run_type": "iteration"}
        entry["run_name"] = entry["name"]
        if isinstance(what, str):
            benchmarks.append({**entry, "error_occurred": True, "error_message": what})
            continue
        times, counters = what
        for ms in times:
            benchmarks.append({**entry, "real_time": ms, "cpu_time": ms, "time_unit": "ms", **counters})
        benchmarks.append({**entry, "run_type": "aggregate", "aggregate_name": "median", "real_time": 1e9,
                           "time_unit": "ms"})
    return {"context": {"date": "today", "num_cpus": 2, "caches": [], "load_avg": [0.0]}, "benchmarks": benchmarks}
