#!/usr/bin/env python3
"""Fails if docs/guide/faq.md quotes a message that no program writes any more.

    scripts/check_questions.py

The messages are in backticks, in the first column of the tables headed "message". What "..." parts must be in string literals of the
libraries, the commands or the Python package.
"""
import re
import sys

from tracked_files import ROOT, report, tracked

PAGE = ROOT / "docs/guide/faq.md"
# Messages of Python and pip.
FOREIGN = {"No module named 'gvd'", "externally-managed-environment", "assignment destination is read-only"}

BETWEEN_LITERALS = re.compile(r'"\s*\n\s*f?"')
LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')


def messages():
    """The messages that the page quotes."""
    inside = False
    for line in PAGE.read_text().split("\n"):
        inside = line.startswith("|") and (inside or line.startswith("| message |"))
        if inside:
            yield from re.findall(r"`([^`]+)`", line.split("|")[1])


def main():
    sources = tracked("libgvd/*.cpp", "libgvd/*.hpp", "apps/*.cpp", "apps/*.hpp", "python/gvd/*.py")
    literals = "\n".join(literal for source in sources for literal in LITERAL.findall(BETWEEN_LITERALS.sub("", source.read_text())))
    quoted = [message for message in messages() if message not in FOREIGN]
    return report(quoted, (f"docs/guide/faq.md: no program writes: {part}" for message in quoted
                           for part in map(str.strip, message.split("...")) if part not in literals), "messages")


if __name__ == "__main__":
    sys.exit(main())
