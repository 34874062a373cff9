"""One job of a batch: runs a command of Ease and keeps what became of it.

    python3 ease_job.py run|pattern --ease EASE --scene SCENE --results DIR --threads N --log FILE --outcome FILE.json

The outcome is written where Ease has said its last word: done, or refused, failed and doubtful, which another try would
not change.  Then this ends with 0, so that the batch goes on.  A job that was stopped from outside (interrupted,
killed, out of memory, its results held by another run) leaves no outcome and ends with another code: it is to be tried again.
"""

import argparse
import json
import os
import pathlib
import signal
import subprocess
import sys
import time

FINAL = (0, 1, 2, 3)  # exit codes of Ease: done, wrong input, the computation failed, doubtful
PASSING = ("another run writes into this directory", "out of memory", "No space left on device")  # not Ease's last word


def main():
    job = arguments()
    log = pathlib.Path(job.log)
    log.parent.mkdir(parents=True, exist_ok=True)
    if job.command == "pattern":
        reason = why_no_pattern(pathlib.Path(job.outcome).with_name(pathlib.Path(job.results).name + ".run.json"))
        if reason:
            log.write_text(reason + "\n", encoding="utf-8")
            return keep(job.outcome, None, reason, 0.0)
    begin = time.monotonic()
    code = run([job.ease, job.command, job.scene, "-o", job.results, "--threads", job.threads], log)
    wall_s = time.monotonic() - begin
    reason = "" if code == 0 else last_words(log)
    if code < 0:
        reason = f"ended by signal {-code} ({signal.strsignal(-code)})"
        with open(log, "a", encoding="utf-8") as file:
            file.write(f"ease: {reason}\n")
    if code not in FINAL or any(words in reason for words in PASSING):
        print(f"ease {job.command} {job.scene}: {reason}", file=sys.stderr)
        return code if code > 0 else 128 - code
    return keep(job.outcome, code, reason, wall_s)


def arguments():
    parser = argparse.ArgumentParser(prog="ease_job.py", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", choices=("run", "pattern"))
    for name in ("ease", "scene", "results", "threads", "log", "outcome"):
        parser.add_argument("--" + name, required=True)
    return parser.parse_args()


def run(command, log):
    """Runs a command whose words go into a log, and hands on the signals that ask to end.  Returns its exit code."""
    with open(log, "wb") as output:
        try:
            process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT)
        except OSError as error:
            sys.exit(f"{command[0]}: {error.strerror}: build Ease, or name the program: --config ease=PATH")
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, lambda received, _: process.send_signal(received))
        return process.wait()


def why_no_pattern(outcome):
    """Why there is nothing to make a pattern of; empty if there is."""
    code = json.loads(outcome.read_text(encoding="utf-8"))["exit_code"]
    return "" if code == 0 else "no pattern: " + ("the fit is doubtful" if code == 3 else "the run failed")


def last_words(log):
    """The last line of a log in which Ease says what was wrong; its last line where it does not."""
    lines = log.read_text(encoding="utf-8", errors="replace").strip().splitlines() or [""]
    said = [line for line in lines if line.startswith(("ease: error: ", "ease: interrupted: "))]
    doubts = [line for line in lines if line.startswith("stretch not to be trusted: ")]
    return (said or doubts or lines)[-1].removeprefix("ease: ").removeprefix("error: ")


def keep(outcome, code, reason, wall_s):
    """Writes the outcome whole or not at all."""
    partial = outcome + ".partial"
    pathlib.Path(partial).write_text(
        json.dumps({"exit_code": code, "reason": reason, "wall_s": round(wall_s, 2),
                    "ended": time.strftime("%FT%T%z")}) + "\n", encoding="utf-8")
    os.replace(partial, outcome)
    return 0


if __name__ == "__main__":
    sys.exit(main())
