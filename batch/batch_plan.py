"""The plan of a batch: what its table asks for, as scene files and OUT/plan.json."""

import json
import pathlib

import people_table
from batch_summary import write_whole
from job_size import memory_mb


def make(table, out):
    """Reads the table, writes its scenes and the plan into the folder `out`, and returns the plan.  Files whose text is
    there already are left alone, so that only what has changed is computed again.  Throws TableError."""
    plan = []
    for row in people_table.read_table(table):
        write_changed(pathlib.Path(out, row.person, row.garment + ".toml"), row.scene)
        plan.append({"person": row.person, "garment": row.garment, "pattern": row.pattern, "files": row.files,
                     "memory_mb": memory_mb(row.parsed, row.files)})
    write_changed(plan_file(out), json.dumps(plan, indent=1, ensure_ascii=False) + "\n")
    return plan


def read(out):
    """The plan that make() wrote."""
    return json.loads(plan_file(out).read_text(encoding="utf-8"))


def plan_file(out):
    return pathlib.Path(out, "plan.json")


def write_changed(file, text):
    if file.is_file() and file.read_text(encoding="utf-8") == text:
        return
    file.parent.mkdir(parents=True, exist_ok=True)
    write_whole(file, text)
