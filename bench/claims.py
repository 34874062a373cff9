"""What the project claims of itself and a bench run can refute."""


def broken(results):
    """A line for each claim that does not hold; `results`: program -> cases by name."""
    lines = []
    for case in results.get("stability", {}).values():
        if case.fields["method"] == "auto" and not (case.runs and case.median("grade") == 2):
            lines.append(f"{case.name}: not converged" + (f": {case.error}" if case.error else ""))
    for case in results.get("drape_2pin", {}).values():
        if case.kind == "rest" and not (case.runs and case.median("agrees")):
            lines.append(f"{case.name}: another state at rest than that of other codes")
    for case in results.get("fps", {}).values():
        if case.failed:
            lines.append(f"{case.name}: {case.error}")
    for case in results.get("fuzz", {}).values():
        if not case.runs:
            lines.append(f"{case.name}: {case.error}")
            continue
        for what in ("crashes", "hangs", "unclear", "silent"):
            if case.median(what) > 0:
                lines.append(f"{case.name}: {what}: {case.median(what):g}")
    return lines
