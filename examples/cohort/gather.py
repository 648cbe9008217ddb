"""One table and one page of the steps of all meshes: what step.py left in MESH/STEP, a row of the table for each."""
import base64
import csv
import html
import json
import os
import pathlib
import urllib.parse

STYLE = """:root { color-scheme: light dark; font: 15px system-ui, sans-serif }
body { margin: 2rem auto; max-width: 72rem; padding: 0 1rem }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(30rem, 1fr)); gap: 1rem }
article { border: 1px solid #8886; border-radius: 8px; padding: .75rem }
h2 { font-size: 1rem; margin: 0; overflow-wrap: anywhere }
.steps { display: grid; grid-template-columns: repeat(3, 1fr); gap: .5rem }
figure { margin: .5rem 0 0; min-width: 0 } img { width: 100% } figcaption, p { font-size: .85rem; margin: .25rem 0; overflow-wrap: anywhere }
.error { color: #d33 }"""


def flatten(value, name):
    """Numbers, texts and truth values of a part of a report, as gvd-segment --summary names them."""
    if isinstance(value, dict):
        return {key: figure for member in value for key, figure in flatten(value[member], f"{name}.{member}").items()}
    return {} if value is None or isinstance(value, list) else {name: json.dumps(value) if isinstance(value, bool) else value}


def read_step(mesh, step):
    """The row of a step."""
    folder = pathlib.Path(mesh, step)
    row = {"mesh": mesh, "step": step, "exit_code": 0, "error": ""}
    if (folder / "error.json").exists():
        return row | json.loads((folder / "error.json").read_text())
    report = json.loads((folder / "report.json").read_text())
    for part in ("input", "diagram", "results"):
        row |= flatten(report[part], part)
    return row | {"peak_memory_bytes": report["peak_memory_bytes"], "milliseconds": sum(report["timings_ms"].values())}


def format_step(row):
    """The picture of a step, which opens its page, or its error."""
    if row["error"]:
        return f'<p class="error"><b>{row["step"]}</b>: {html.escape(row["error"])}</p>'
    folder = pathlib.Path(row["mesh"], row["step"])
    picture = base64.b64encode((folder / "thumbnail.png").read_bytes()).decode()
    size = f'{row["results.output.vertices"]} vertices' if row["step"] == "remesh" else f'{row["diagram.cells"]} cells'
    return (f'<figure><a href="{urllib.parse.quote(str(folder / "page.html"))}"><img alt="{html.escape(row["mesh"])}: {row["step"]}" '
            f'src="data:image/png;base64,{picture}"></a><figcaption>{row["step"]}: {size}</figcaption></figure>')


def format_page(rows, steps):
    meshes = [rows[i:i + len(steps)] for i in range(0, len(rows), len(steps))]
    failed = sum(any(row["error"] for row in mesh) for mesh in meshes)
    articles = []
    for mesh in meshes:
        faces = next((f'{row["input.faces"]} faces' for row in mesh if "input.faces" in row), "")
        articles.append(f'<article><h2>{html.escape(mesh[0]["mesh"])}</h2><p>{faces}</p>'
                        f'<div class="steps">{"".join(map(format_step, mesh))}</div></article>')
    return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{len(meshes)} meshes</title>'
            f'<meta name="viewport" content="width=device-width"><link rel="icon" href="data:,"><style>{STYLE}</style></head>\n<body><h1>{len(meshes)} meshes</h1>'
            f'<p>{len(meshes) - failed} done, {failed} with errors. A picture opens the page of its result.</p>\n<main>\n'
            + "\n".join(articles) + "\n</main></body></html>\n")


def replace_file(path, text):
    """Writes a file beside its target and renames it, so that no half one is ever there."""
    pathlib.Path(f"{path}.partial").write_text(text, encoding="utf-8", errors="replace")
    os.replace(f"{path}.partial", path)


def gather(meshes, steps, table, page):
    rows = [read_step(mesh, step) for mesh in meshes for step in steps]
    columns = list(dict.fromkeys(column for row in rows for column in row))
    last = ["peak_memory_bytes", "milliseconds"]  # the columns that differ between equal runs
    columns = [column for column in columns if column not in last] + last
    with open(f"{table}.partial", "w", newline="", encoding="utf-8", errors="replace") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    os.replace(f"{table}.partial", table)
    replace_file(page, format_page(rows, steps))
