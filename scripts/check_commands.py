#!/usr/bin/env python3
"""Fails if README.md or a page of docs/guide shows a command that no check runs.

    scripts/check_commands.py

A block that is indented by four spaces holds commands; everything else is in a fenced block. Targets of make and calls of pip in
backticks are commands, too. Lines that run a program of build/bin are for scripts/check_examples.py. All others must be in
scripts/release_check.sh, which runs them in a bare system.
"""
import re
import sys

from check_examples import EXAMPLE
from tracked_files import ROOT, report, tracked

# Commands that release_check.sh can't run, by their beginning, and why.
NOT_RUN = {
    "make release-check": "it would run itself",
    "snakemake -s examples/cohort/Snakefile --profile examples/cohort/slurm": "needs Slurm: tests/cohort/check_slurm.sh runs it",
}

FENCE = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
INDENTED = re.compile(r"^    (\S.*)$|^ {6}(\S.*)$", re.MULTILINE)
INLINE = re.compile(r"`((?:\w+=\S+ )*(?:make|\S*pip)(?: [^`]*)?)`")


def commands(text):
    """The commands of a page that check_examples.py does not run. A comment is no part of a command, nor is a final backslash."""
    text = FENCE.sub("", text)
    shown = [line or more for line, more in INDENTED.findall(EXAMPLE.sub("", text))]
    return [re.sub(r"\s+(#.*|\\)$", "", command) for command in shown + INLINE.findall(text)]


def is_run(command, script):
    return any(command.startswith(beginning) for beginning in NOT_RUN) or re.search(rf"(?<![^\s/]){re.escape(command)}(?!\S)", script)


def main():
    script = re.sub(r"\\(.)", r"\1", (ROOT / "scripts/release_check.sh").read_text())
    pages = tracked("README.md", "docs/guide/*.md")
    return report(pages, [f"{page.relative_to(ROOT)}: scripts/release_check.sh does not run: {command}"
                          for page in pages for command in commands(page.read_text()) if not is_run(command, script)])


if __name__ == "__main__":
    sys.exit(main())
