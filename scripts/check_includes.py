#!/usr/bin/env python3
"""Fails on an include that goes upwards: each folder has a floor, and includes only from its own folder and floors below.

    scripts/check_includes.py             checks includes, and that docs/developer/floors.svg shows the current floors
    scripts/check_includes.py --svg       prints that drawing
    scripts/check_includes.py --list      prints which folder includes which, and how often

Also fails if a source includes no header of its own folder, which would declare what it defines.
"""
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# From the ground up. Folders on one floor do not include each other.
FLOORS = [
    ["libgvd/src/base"],
    ["libgvd/src/options", "libgvd/src/mesh"],
    ["libgvd/src/mesh/reading"],
    ["libgvd/src/mesh/repair"],
    ["libgvd/src/geodesic"],
    ["libgvd/src/geodesic/marching"],
    ["libgvd/src/geodesic/sampling"],
    ["libgvd/src/geodesic/windows"],
    ["libgvd/src/geodesic/windows/propagation"],
    ["libgvd/src/diagram/graph"],
    ["libgvd/src/diagram/assembly"],
    ["libgvd/src/diagram/envelope", "libgvd/src/diagram/growth"],
    ["libgvd/src/diagram"],
    ["libgvd/src/io/writers"],
    ["libgvd/src/io"],
    ["libgvd/src/io/view"],
    ["libgvd/segment", "libgvd/lloyd", "libgvd/verify"],
    ["libgvd/remesh/src/dual"],
    ["libgvd/remesh/src/repair"],
    ["libgvd/remesh"],
    ["libgvd/operations"],
    ["libgvd/c"],
    ["apps/common/options"],
    ["apps/common"],
    ["apps/segment", "apps/lloyd", "apps/remesh", "apps/distance"],
    ["apps/gvd"],
]
FLOOR = {folder: floor for floor, folders in enumerate(FLOORS) for folder in folders}

# For users, all public headers are in one folder. This is the folder to which each one belongs.
PUBLIC = {
    "libgvd/src/base": "vec ids error names placeholders text text_encoding progress diagram_steps version",
    "libgvd/src/options": "given_values option_list option_text",
    "libgvd/src/mesh": "mesh surface_point creases generator_curve closest_point distance_samples quality openmesh",
    "libgvd/src/mesh/reading": "appearance mesh_property polygon_soup",
    "libgvd/src/mesh/repair": "drop_small_components soup",
    "libgvd/src/geodesic": "front geodesic_tracing",
    "libgvd/src/geodesic/sampling": "sampling",
    "libgvd/src/geodesic/windows": "exact_field",
    "libgvd/src/diagram": "diagram diagram_options check diagram_editor error_measure trace_diagram",
    "libgvd/src/io": "curve_list generator_list read_soup read_values referred_files io/format io/mesh_writer",
    "libgvd/src/io/writers": "io/diagram_json io/distance_writer io/label_color io/labelled_mesh io/point_writer io/write_file",
    "libgvd/src/io/view": "io/view gvd",
    "libgvd/segment": "charts face_regions region_statistics segment segment_options",
    "libgvd/lloyd": "balance cell_moments coarse_copy constrained_start density lloyd lloyd_options relaxation_start",
    "libgvd/remesh/src/dual": "dual remesh_certificate surface_distance",
    "libgvd/remesh": "carry_properties disc_cells find_fewest placement remesh remesh_map remesh_options remesh_scenes remesh_surface",
    "libgvd/operations": "barriers diagram_operation diagram_parts distances_operation edit_operation generator_options program_operations given_regions lloyd_operation mesh_objects object "
                         "observer operation operation_json parted_mesh relaxation_parts remesh_operation scene_operation segment_operation",
    "libgvd/verify": "verify",
}
PUBLIC_FOLDER = {f"gvd/{name}.hpp": folder for folder, names in PUBLIC.items() for name in names.split()}
PUBLIC_FOLDER["gvd/gvd.h"] = "libgvd/c"

DRAWING = "docs/developer/floors.svg"

INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)


def sources():
    return sorted(p for top in ("libgvd", "apps") for p in (ROOT / top).rglob("*.[ch]pp"))


def folder_of(path):
    """The folder of FLOORS that a source belongs to, or None."""
    relative = path.relative_to(ROOT)
    if "include" in relative.parts:
        return PUBLIC_FOLDER.get(str(relative).split("include/", 1)[1])
    for parent in relative.parents:
        if str(parent) in FLOOR:
            return str(parent)
    return None


def find_header(name, source):
    """The file that an include names."""
    top = ROOT.joinpath(*source.relative_to(ROOT).parts[:2])
    for base in (source.parent, top / "src", ROOT / "libgvd/src", ROOT / "apps"):
        if (base / name).exists():
            return base / name
    public = [p for p in ROOT.glob(f"libgvd/**/include/{name}")]
    return public[0] if public else None


def check_file(path, edges):
    """Returns the findings in one file, and adds its includes to `edges`."""
    findings = []
    name = path.relative_to(ROOT)
    own = folder_of(path)
    if own is None:
        return [f"{name}: its folder has no floor; add it to FLOORS or PUBLIC in scripts/check_includes.py"]
    for included in INCLUDE.findall(path.read_text()):
        header = find_header(included, path)
        other = folder_of(header) if header else None
        if other is None:
            findings.append(f"{name}: includes {included}, which has no floor")
        elif other != own:
            edges[own, other].append((path.name, header.name))
            if FLOOR[other] >= FLOOR[own]:
                findings.append(f"{name}: includes {included} of {other}, which is not below {own}")
    return findings


def check_own_headers():
    """Sources without an include of their own folder's headers, the private ones or the public ones that belong to it."""
    findings = []
    for path in sources():
        if path.suffix != ".cpp" or path.name == "main.cpp":
            continue
        headers = [find_header(name, path) for name in INCLUDE.findall(path.read_text())]
        if all(header is None or folder_of(header) != folder_of(path) for header in headers):
            findings.append(f"{path.relative_to(ROOT)}: includes no header of its folder, which would declare what it defines")
    return findings


def draw_floors():
    """The table of floors as an SVG drawing, with the ground floor at the bottom."""
    width, height, gap, margin = 860, 34, 8, 12
    total = len(FLOORS) * (height + gap) + 2 * margin - gap
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{total}" viewBox="0 0 {width} {total}" '
           'font-family="sans-serif" font-size="14">', f'<rect width="{width}" height="{total}" fill="#ffffff"/>']
    for floor, folders in enumerate(FLOORS):
        y = total - margin - (floor + 1) * height - floor * gap
        room = (width - 2 * margin - (len(folders) - 1) * gap) / len(folders)
        for i, folder in enumerate(folders):
            x = margin + i * (room + gap)
            # A colour for each subject: base and mesh, geodesic, diagram, io, the parts beside libgvd, the commands.
            words = folder.split("/")
            subject = words[2] if folder.startswith("libgvd/src") else words[0]
            colour = {"base": "#e3e3e3", "options": "#e3e3e3", "mesh": "#d9e8f5", "geodesic": "#d8efdc", "diagram": "#fbe6c8",
                      "io": "#ecdff2", "libgvd": "#f7d9d9", "apps": "#fff4b8"}[subject]
            out.append(f'<rect x="{x:.1f}" y="{y}" width="{room:.1f}" height="{height}" rx="4" fill="{colour}" '
                       'stroke="#777777"/>')
            out.append(f'<text x="{x + room / 2:.1f}" y="{y + 22}" text-anchor="middle">'
                       f'{folder.removeprefix("libgvd/src/")}</text>')
    return "\n".join(out + ["</svg>"]) + "\n"


def check_drawing():
    path = ROOT / DRAWING
    if path.exists() and path.read_text() == draw_floors():
        return []
    return [f"{DRAWING}: is not what scripts/check_includes.py --svg prints; write it anew"]


def main():
    if "--svg" in sys.argv[1:]:
        print(draw_floors(), end="")
        return 0
    edges = collections.defaultdict(list)
    findings = [finding for path in sources() for finding in check_file(path, edges)] + check_own_headers() + check_drawing()
    if "--list" in sys.argv[1:]:
        for (own, other), names in sorted(edges.items()):
            print(f"{own} -> {other}: {len(names)}")
        return 0
    for finding in findings:
        print(finding)
    print(f"{len(sources())} files, {len(findings)} findings")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
