"""Shared parts of the scripts that check the repository: which files they examine, and how they end."""
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent


def tracked(*patterns):
    """Files that git tracks or could add, so that a new page is checked too."""
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", "--", *patterns],
                            cwd=ROOT, check=True, capture_output=True, text=True).stdout
    return sorted(ROOT / name for name in set(listed.split("\0")) if name and (ROOT / name).is_file())


def report(files, findings, kind="pages"):
    """Prints the findings and their number. Returns the exit code."""
    findings = list(findings)
    for finding in findings:
        print(finding)
    print(f"{len(files)} {kind}, {len(findings)} findings")
    return 1 if findings else 0
