#!/usr/bin/env python3
"""Tells Snakemake the state of a Slurm job: running, success or failed. Without it, a job that Slurm kills seems to run forever."""
import subprocess
import sys

WAITING = {"PENDING", "CONFIGURING", "RUNNING", "COMPLETING", "SUSPENDED", "RESIZING", "REQUEUED", "REQUEUE_HOLD", "REQUEUE_FED", "SIGNALING", "STAGE_OUT", "STOPPED"}

shown = subprocess.run(["scontrol", "--oneliner", "show", "job", sys.argv[1].split(";")[0]], capture_output=True, text=True)
fields = dict(word.split("=", 1) for word in shown.stdout.split() if "=" in word)
state = fields.get("JobState")
if state is None:
    # The controller does not answer, or has forgotten a job that ended long ago.
    print("failed" if "Invalid job id" in shown.stderr else "running")
else:
    print("success" if state == "COMPLETED" else "running" if state in WAITING else "failed")
