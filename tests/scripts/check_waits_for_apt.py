#!/usr/bin/env python3
"""install-deps.sh waits while another program fetches lists or installs packages, says so, and then installs.

    check_waits_for_apt.py INSTALL_DEPS WORK_FOLDER
"""
import os
import pathlib
import shutil
import subprocess
import sys

# No package is installed, root runs the script, nothing takes time, and the lists are locked at the first two attempts.
PROGRAMS = {
    "dpkg-query": "exit 1",
    "id": "echo 0",
    "sleep": "exit 0",
    "apt-get": """echo "apt-get $*" >> "$CALLS"
case "$*" in *update*) ;; *) exit 0 ;; esac
[ "$(grep -c update "$CALLS")" -gt 2 ] || { echo "E: Could not get lock /var/lib/apt/lists/lock." >&2; exit 100; }""",
}


def main():
    script, work = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    for name, lines in PROGRAMS.items():
        (work / name).write_text(f"#!/bin/sh\n{lines}\n")
        (work / name).chmod(0o755)
    ran = subprocess.run([script, "fuzz"], text=True, stderr=subprocess.PIPE, check=False,
                         env={**os.environ, "PATH": f"{work}:{os.environ['PATH']}", "CALLS": str(work / "calls")})
    calls = (work / "calls").read_text().splitlines()
    assert ran.returncode == 0, ran.stderr
    assert ["update" in call for call in calls] == [True, True, True, False], calls
    assert "-o DPkg::Lock::Timeout=600" in calls[-1], calls[-1]
    assert ran.stderr.count("waiting for another program that fetches lists of packages") == 1, ran.stderr
    assert "If another program is installing packages, this waits for it, for at most 10 minutes." in ran.stderr, ran.stderr


if __name__ == "__main__":
    main()
