#!/usr/bin/env bash
# tests/batch/slurm_test.sh: a batch of 24 garments on a real Slurm of two nodes, set up on this machine, with faults:
# one row is broken, one node is drained and comes back, one job is cancelled, and the command itself is killed.  After
# that the summary must equal the one of a batch without these faults, byte for byte but times.
#
# Needs root and, from Debian's packages, snakemake, slurm-wlm and munge.  Takes some minutes.  EASE names the program
# (default build/release/apps/ease), WORK a folder to keep the results in; by default they are removed.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=${WORK:-$(mktemp -d)}
ease=${EASE:-$root/build/release/apps/ease}
mkdir -p "$work"
export SLURM_CONF=$work/slurm.conf
daemons=()

finish() {
  for process in "${daemons[@]}"; do kill "$process" 2>/dev/null || true; done
  wait
  [ -n "${WORK:-}" ] || rm -rf "$work"
}
trap finish EXIT

say() { echo "$(date +%T) $*"; }

start_slurm() {
  local host cores
  host=$(hostname -s)
  cores=$(($(nproc) / 2 > 0 ? $(nproc) / 2 : 1))
  cat >"$SLURM_CONF" <<CONF
ClusterName=ease
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmctldPort=16917
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool-%n
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd-%n.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd-%n.log
AuthInfo=socket=$work/munge/socket
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
ReturnToService=2
SlurmdParameters=config_overrides
NodeName=east NodeHostname=$host NodeAddr=127.0.0.1 Port=16921 CPUs=$cores RealMemory=2500
NodeName=west NodeHostname=$host NodeAddr=127.0.0.1 Port=16922 CPUs=$cores RealMemory=2500
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
  mkdir -p "$work/state" "$work/spool-east" "$work/spool-west" "$work/munge"
  head -c 128 /dev/urandom >"$work/munge/key"
  chmod 0600 "$work/munge/key"
  chmod 0755 "$work" "$work/munge"
  chown -R munge: "$work/munge"
  runuser -u munge -- \
    munged --foreground --socket="$work/munge/socket" --key-file="$work/munge/key" \
    --pid-file="$work/munge/pid" --seed-file="$work/munge/seed" --log-file="$work/munge/log" \
    >"$work/munged.out" 2>&1 &
  daemons+=($!)
  sleep 1
  slurmctld -D >"$work/slurmctld.out" 2>&1 &
  daemons+=($!)
  for node in east west; do
    slurmd -D -N "$node" >"$work/slurmd-$node.out" 2>&1 &
    daemons+=($!)
  done
  for _ in $(seq 30); do
    [ "$(sinfo --noheader --format=%T)" = idle ] && break
    sleep 1
  done
  sinfo --Node --long
}

# 12 people of different height and measures, each with a T-shirt and a dress: 24 garments, one of them impossible.
write_table() {
  for garment in t-shirt dress; do
    cat >"$work/$garment.toml" <<SCENE
name = "$garment of {person}"

[body]
builtin = "mannequin"
poses = ["t", "a"]
height = {height}
chest = {chest:0.9}
steps = 8

[garment]
builtin = "$garment"
vertices = 300

[[garment.pin]]
loop = "neck"

[collision]
offset = {offset:0.005}
voxel = 0.02

[adaption]
limit = {limit:0.08}
passes = 3
SCENE
  done
  {
    echo "person,scene,height,chest,limit,pattern"
    for k in $(seq 12); do
      chest=0.$((84 + k))
      [ "$k" != 7 ] || chest=3
      limit=$([ $((k % 3)) != 0 ] || echo 0.06)
      pattern=$([ $((k % 4)) = 0 ] && echo yes || echo no)
      echo "person_$k,t-shirt.toml;dress.toml,1.$((60 + 2 * k)),$chest,$limit,$pattern"
    done
  } >"$work/people.csv"
}

batch() {
  (cd "$work" && exec snakemake -s "$root/batch/Snakefile" --profile "$root/batch/slurm" --latency-wait 10 \
    --config table=people.csv out="$1" ease="$ease") >>"$work/$1.log" 2>&1
}

finished() { find "$work/$1" 2>/dev/null -name '*.run.json' -o -name '*.pattern.json' | wc -l || true; }

wait_for() {  # wait_for FOLDER COUNT: until so many jobs have ended
  for _ in $(seq 600); do
    [ "$(finished "$1")" -lt "$2" ] || return 0
    sleep 0.5
  done
  echo "slurm_test: $1: fewer than $2 jobs ended in 5 minutes; see $work/$1.log" >&2
  exit 1
}

without_times() {
  python3 - "$1/summary.csv" "$1/summary.html" <<'PYTHON'
import csv, re, sys
for row in csv.reader(open(sys.argv[1])):
    print(row[:-2])
print(re.sub(r'<td class="n time">[^<]*</td>', "", open(sys.argv[2]).read()))
PYTHON
}

start_slurm
write_table

say "without faults"
begin=$SECONDS
batch calm
say "without faults: $(finished calm) jobs in $((SECONDS - begin)) s"

say "with faults"
batch stormy 2>/dev/null &
command=$!
wait_for stormy 4
scontrol update nodename=west state=drain reason=test
say "drained west: $(sinfo --noheader --Node --format='%N is %T' | tr '\n' ' ')"
victim=$(squeue --noheader --states=running --format=%i | head -n1)
scancel "$victim"
say "cancelled job $victim"
wait_for stormy 10
say "killed the command after $(finished stormy) jobs"
pkill -9 -P "$command"  # Snakemake itself: $command is the shell around it
wait "$command" 2>/dev/null || true
scontrol update nodename=west state=resume
say "returned west: $(sinfo --noheader --Node --format='%N is %T' | tr '\n' ' ')"
before=$(finished stormy)
(cd "$work" && snakemake -s "$root/batch/Snakefile" --profile "$root/batch/slurm" --unlock \
  --config table=people.csv out=stormy >>"$work/stormy.log" 2>&1)
find "$work/stormy" -name '*.json' -path '*person*' ! -name report.json ! -path '*/t-shirt/*' ! -path '*/dress/*' \
  -exec stat -c '%n %Y' {} + | sort >"$work/before.txt"
batch stormy
say "the same command again: $before jobs had ended, now $(finished stormy)"
grep -q 'Resuming incomplete job' "$work/stormy.log" ||
  { echo "slurm_test: no job that ran on was waited for" >&2; exit 1; }

while read -r file time; do
  [ "$(stat -c %Y "$file")" = "$time" ] || { echo "slurm_test: $file was computed again" >&2; exit 1; }
done <"$work/before.txt"
diff <(without_times "$work/calm" | sed 's/calm/OUT/g') <(without_times "$work/stormy" | sed 's/stormy/OUT/g')
rows=$(($(wc -l <"$work/stormy/summary.csv") - 1))
failed=$(grep -c ',failed,' "$work/stormy/summary.csv")
unfinished=$(grep -c 'not finished' "$work/stormy/summary.csv" || true)
if [ "$rows $failed $unfinished" != "24 2 0" ]; then
  echo "slurm_test: expected 24 rows, 2 failed, 0 not finished; found $rows, $failed, $unfinished" >&2
  exit 1
fi
grep ',failed,' "$work/stormy/summary.csv"
say "both summaries are the same but for times: $rows rows, $failed failed, none unfinished"
