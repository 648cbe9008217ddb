#!/usr/bin/env python3
"""Fails if a Markdown file links to a file or heading of the repository that does not exist, or if a source names such a page.

    scripts/check_links.py

Links to other sites are not followed.
"""
import re
import sys

from tracked_files import ROOT, report, tracked

FENCE = re.compile(r"^(```|~~~).*?^\1", re.MULTILINE | re.DOTALL)
INLINE_CODE = re.compile(r"`[^`\n]*`")
LINK = re.compile(r"\]\(\s*<?([^)\s>]+)>?[^)]*\)|(?:src|srcset|href)=\"([^\"]+)\"|^\[[^\]]+\]:\s+(\S+)", re.MULTILINE)
HEADING = re.compile(r"^#+ +(.*?) *#*$", re.MULTILINE)
PAGE_IN_SOURCE = re.compile(r"\b(?:docs|bench|data|web)/[\w/-]*[\w-]+\.md\b")
SOURCES = ("*.cpp", "*.hpp", "*.js", "*.mjs", "*.sh", "*.py", "*.cmake", "*.txt", "Makefile", "*.md")


def anchors(page):
    """The anchors of a page's headings, as GitHub makes them."""
    found = set()
    for heading in HEADING.findall(FENCE.sub("", page.read_text())):
        text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
        anchor = re.sub(r"[^\w\- ]", "", text).replace(" ", "-")
        repeats = sum(known == anchor or re.fullmatch(re.escape(anchor) + r"-\d+", known) is not None for known in found)
        found.add(f"{anchor}-{repeats}" if repeats else anchor)
    return found


def check_link(page, link):
    """The error in a link of a page, or None."""
    if re.match(r"[a-z][a-z0-9+.-]*:|//", link):
        return None
    path, _, anchor = link.partition("#")
    target = (page.parent / path).resolve() if path else page
    if not target.exists():
        return f"links to {link}, which is not there"
    if ROOT != target and ROOT not in target.parents:
        return f"links to {link}, which is outside the repository"
    if anchor and target.suffix == ".md" and anchor not in anchors(target):
        return f"links to {link}, a heading that {target.name} does not have"
    return None


def check_page(page):
    """The findings in the links of a Markdown file."""
    text = INLINE_CODE.sub("", FENCE.sub("", page.read_text()))
    links = [next(filter(None, groups)) for groups in LINK.findall(text)]
    return [finding for finding in (check_link(page, link) for link in links) if finding]


def check_names(source):
    """The findings in the paths of pages that a source or the text of a page names."""
    names = set(PAGE_IN_SOURCE.findall(source.read_text()))
    return [f"names {name}, which is not there" for name in sorted(names) if not (ROOT / name).exists()]


def main():
    pages = tracked("*.md")
    findings = [f"{page.relative_to(ROOT)}: {finding}" for page in pages for finding in check_page(page)]
    sources = tracked(*SOURCES)
    findings += [f"{source.relative_to(ROOT)}: {finding}" for source in sources for finding in check_names(source)]
    return report(pages, findings)


if __name__ == "__main__":
    sys.exit(main())
