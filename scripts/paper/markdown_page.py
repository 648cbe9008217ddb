"""The sections as Markdown."""
from paper.gallery import picture


def to_markdown(sections, introduction):
    lines = ["# Section 5 of the paper, measured", "", introduction, ""]
    for section in sections:
        lines += [f"## {section.title}", ""]
        for kind, content in section.blocks:
            if kind == "text":
                lines += [content, ""]
            elif kind == "table":
                head, rows = content
                lines += ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
                lines += ["| " + " | ".join(row) + " |" for row in rows] + [""]
            elif kind == "pictures":
                lines += [picture(name) for name in content] + [""]
            elif kind == "row":
                captions, names = zip(*content)
                lines += ["| " + " | ".join(captions) + " |", "|" + "---|" * len(captions),
                          "| " + " | ".join(picture(name) for name in names) + " |", ""]
    return "\n".join(lines)
