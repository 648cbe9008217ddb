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


def read_result(folder):
    """What a step has left, as columns of its row."""
    if (folder / "error.json").exists():
        return json.loads((folder / "error.json").read_text())
    row = {"exit_code": 0}
    report = json.loads((folder / "report.json").read_text())
    for part in ("input", "diagram", "results"):
        row |= flatten(report[part], part)
    if (folder / "picture_error.txt").exists():
        row["error"] = (folder / "picture_error.txt").read_text().strip()
    return row | {"peak_memory_bytes": report["peak_memory_bytes"], "milliseconds": sum(report["timings_ms"].values())}


def read_step(mesh, step):
    """The row of a step. One that left nothing, or half a report, says so: its last try failed, or its job was killed."""
    row = {"mesh": mesh, "step": step, "exit_code": None, "error": ""}
    folder = pathlib.Path(mesh, step)
    try:
        return row | read_result(folder)
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        row["error"] = f"no result ({type(error).__name__}): the job failed; its log tells more"
    try:
        return row | json.loads(folder.with_name(folder.name + ".failed.json").read_text())
    except (OSError, ValueError):
        return row


def format_step(row):
    """The picture of a step, which opens its page, or its error. Without a picture, words open the page."""
    error = f'<p class="error"><b>{row["step"]}</b>: {html.escape(row["error"])}</p>' if row["error"] else ""
    if row["exit_code"] != 0:
        return error
    folder = pathlib.Path(row["mesh"], row["step"])
    link = urllib.parse.quote(str(folder / "page.html"))
    size = f'{row["results.output.vertices"]} vertices' if row["step"] == "remesh" else f'{row["diagram.cells"]} cells'
    try:
        picture = base64.b64encode((folder / "thumbnail.png").read_bytes()).decode()
    except OSError:
        return f'<figure><a href="{link}">{row["step"]}: {size}</a>{error}</figure>'
    return (f'<figure><a href="{link}"><img alt="{html.escape(row["mesh"])}: {row["step"]}" '
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


def gather(meshes, steps, table, page, left_out=None):
    """Writes the table and the page. `left_out`: meshes that no step was given, and why."""
    why = left_out or {}
    rows = [{"mesh": mesh, "step": step, "exit_code": None, "error": why[mesh]} if mesh in why else read_step(mesh, step)
            for mesh in sorted({*meshes, *why}) for step in steps]
    columns = list(dict.fromkeys(column for row in rows for column in row))
    last = ["peak_memory_bytes", "milliseconds"]  # the columns that differ between equal runs
    columns = [column for column in columns if column not in last] + last
    with open(f"{table}.partial", "w", newline="", encoding="utf-8", errors="replace") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    os.replace(f"{table}.partial", table)
    replace_file(page, format_page(rows, steps))
