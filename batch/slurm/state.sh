#!/bin/sh
# state.sh JOB: what Snakemake wants to know of a job of Slurm: running, success or failed.  Slurm forgets a job some
# minutes after its end; its accounting, where there is one, knows it still.
state=$(scontrol --oneliner show job "$1" 2>/dev/null | grep -o 'JobState=[A-Z_]*' | cut -d= -f2)
[ -n "$state" ] || state=$(sacct --noheader --parsable2 --allocations --format=State --jobs="$1" 2>/dev/null | head -n1)
case "$state" in
  COMPLETED*) echo success ;;
  BOOT_FAIL* | CANCELLED* | DEADLINE* | FAILED* | NODE_FAIL* | OUT_OF_MEMORY* | PREEMPTED* | TIMEOUT*) echo failed ;;
  "") if scontrol ping 2>/dev/null | grep -q ' is UP'; then echo failed; else echo running; fi ;;
  *) echo running ;;
esac
