#!/bin/bash
# Runs examples/cohort over Slurm, on a cluster of one node that it starts and stops: the workflow is killed in the middle, and a job
# of the next run is cancelled. Compares the results with those of a run on this machine.
# By hand, as root: needs Debian's slurmctld, slurmd, slurm-client, munge and snakemake, and the Python package gvd (PYTHONPATH).
#
#   tests/cohort/check_slurm.sh BIN_FOLDER WORK_FOLDER
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
bin=$(realpath "$1")
mkdir -p "$2/slurm" "$2/meshes"
work=$(realpath "$2")
cp "$root"/data/*.{ply,obj,stl,off} "$work/meshes"
echo "no mesh" > "$work/meshes/bad.off"

cat > "$work/slurm.conf" <<CONF
ClusterName=cohort
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmUser=root
AuthInfo=socket=$work/slurm/munge.socket
SlurmctldPort=16817
SlurmdPort=16818
StateSaveLocation=$work/slurm
SlurmdSpoolDir=$work/slurm/spool
SlurmctldPidFile=$work/slurm/slurmctld.pid
SlurmdPidFile=$work/slurm/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
JobAcctGatherType=jobacct_gather/linux
JobAcctGatherFrequency=1
JobAcctGatherParams=OverMemoryKill
ReturnToService=2
MailProg=/bin/true
NodeName=$(hostname) NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=$(($(free -m | awk '/Mem/ {print $2}') / 2))
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$work/slurm.conf

head -c 1024 /dev/urandom > "$work/slurm/munge.key"
chmod 600 "$work/slurm/munge.key"
munged --foreground --force --socket="$work/slurm/munge.socket" --key-file="$work/slurm/munge.key" --seed-file="$work/slurm/munge.seed" \
  --pid-file="$work/slurm/munge.pid" --log-file="$work/slurm/munge.log" &
daemons=($!)
slurmctld -D -c > "$work/slurm/slurmctld.log" 2>&1 &
daemons+=($!)
slurmd -D > "$work/slurm/slurmd.log" 2>&1 &
daemons+=($!)
trap 'kill "${daemons[@]}"; wait' EXIT
for try in $(seq 30); do
  [ "$(sinfo --noheader --format=%t 2>/dev/null)" = idle ] && break
  sleep 1
done
sinfo

run() {
  profile=$1
  shift
  snakemake -s "$root/examples/cohort/Snakefile" --profile "$root/examples/cohort/$profile" -q "$@" \
    --config meshes="$work/meshes" bin="$bin" regions=9 generators=60 threads=1
}
run local -d "$work/local"
# The workflow is killed in the middle, and its jobs are cancelled.
run slurm -d "$work/cluster" > "$work/killed.log" 2>&1 &
killed=$!
until ls "$work"/cluster/*/*/thumbnail.png > "$work/first.log" 2>&1; do sleep .1; done
kill -9 $killed $(pgrep -f "[s]nakemake .*-d $work/cluster")
scancel --user=root
until [ -z "$(squeue --noheader)" ]; do sleep .1; done
[ ! -e "$work/cluster/cohort.csv" ]
run slurm -d "$work/cluster" --unlock
# A running job is cancelled from outside, as a node that fails would end it; another try makes up for it.
(until job=$(squeue --noheader --states=RUNNING --format=%i | head -1) && [ -n "$job" ]; do sleep .1; done; scancel "$job") &
cancel=$!
run slurm -d "$work/cluster"
wait $cancel
scontrol --oneliner show job | grep -o "JobState=[A-Z]*" | sort | uniq -c
"$root/tests/cohort/compare.py" "$work/local" "$work/cluster"
