"""Runs one command within limits, and checks how it ends."""
import os
import resource
import subprocess
import tempfile
import threading

from surface import require

# Exit codes of the contract. The options are right and the folder can be written, so that 2 and 6 would be wrong. Unreadable are
# files of a corpus only.
DONE, UNREADABLE, PRECONDITION, NO_VALID_RESULT = 0, 3, 4, 5

# CPU time. A run on a few hundred faces takes 0.02 s. One on 20,000 ordinary faces takes 1 s: 0.05 ms a face for each generator
# that reaches it. The limit is a hundred times as much a face, for hostile faces. What does not depend on their number, such as
# rounds of gvd-remesh, has 10 s.
FIXED_SECONDS, SECONDS_A_FACE = 10.0, 0.005
# Elapsed time: a busy machine may give a run a tenth of a core.
ELAPSED_FOR_CPU = 10.0
# Resident memory. A mesh has 100 bytes a face (mesh.hpp), its windows and envelopes some kilobytes a face. The process itself
# takes 10 MB.
FIXED_BYTES, BYTES_A_FACE = 200e6, 50e3
# Address space ends a run that explodes. Threads reserve more than they use: 64 MB each for their heaps.
ADDRESS_SPACE = 4e9


class Ending:
    def __init__(self, code, seconds, peak):
        self.code, self.seconds, self.peak, self.message = code, seconds, peak, ""


def set_limits(seconds):
    resource.setrlimit(resource.RLIMIT_CPU, (int(seconds) + 1, int(seconds) + 2))
    resource.setrlimit(resource.RLIMIT_AS, (int(ADDRESS_SPACE), int(ADDRESS_SPACE)))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(arguments, folder, faces):
    """Runs a command in a folder. Raises a Finding where it ends in a way that is none of the contract's, or needs too much."""
    seconds = FIXED_SECONDS + SECONDS_A_FACE * faces
    before = set(os.listdir(folder))
    with tempfile.TemporaryFile() as errors, tempfile.TemporaryFile() as output:
        process = subprocess.Popen(arguments, cwd=folder, stdin=subprocess.DEVNULL, stdout=output, stderr=errors,
                                   preexec_fn=lambda: set_limits(seconds))
        ending = wait(process, seconds)
        errors.seek(0)
        output.seek(0)
        ending.message = errors.read().decode(errors="replace")
        require(not output.read(1), "something on standard output")
    require(ending.seconds <= seconds, f"{ending.seconds:.1f} s of CPU time; {seconds:.1f} s are allowed for {faces} faces")
    require(ending.code in (DONE, UNREADABLE, PRECONDITION, NO_VALID_RESULT), f"exit code {ending.code}: {ending.message.strip()[-300:]}")
    allowed = FIXED_BYTES + BYTES_A_FACE * faces
    require(ending.peak <= allowed, f"{ending.peak / 1e6:.0f} MB; {allowed / 1e6:.0f} MB are allowed for {faces} faces")
    if ending.code != DONE:
        check_refusal(ending, set(os.listdir(folder)) - before)
    return ending


def wait(process, seconds):
    """The ending of a process, which is killed after ELAPSED_FOR_CPU times its CPU time."""
    clock = threading.Timer(ELAPSED_FOR_CPU * seconds, process.kill)
    clock.start()
    _, status, usage = os.wait4(process.pid, 0)
    clock.cancel()
    process.returncode = os.waitstatus_to_exitcode(status)
    return Ending(process.returncode, usage.ru_utime + usage.ru_stime, 1024 * usage.ru_maxrss)


def check_refusal(ending, new_files):
    """One line that says why, and no file."""
    lines = ending.message.strip().splitlines()
    require(len(lines) == 1, f"exit code {ending.code} with {len(lines)} lines: {ending.message.strip()[:300]}")
    require(20 <= len(lines[0]) <= 600, f"a message of {len(lines[0])} characters: {lines[0][:100]}")
    require("out of memory" not in lines[0], lines[0])
    require(not new_files, f"exit code {ending.code}, and files are left: {sorted(new_files)}")
