"""Sections of pictures made by scripts/make_gallery.sh, as far as the folder has them."""
from paper.section import CIRCLE, EXACT, PLANAR, Section

GALLERY = ["lucy", "kitten", "bunny", "bear", "spot", "elephant", "fandisk", "rocker_arm", "figure"]

# Figures 10 and 11 by scripts/make_gallery.sh: lines of pictures with captions.
ZIGZAG = [[("diffusion [8]", "figure_10_diffusion" + end), (PLANAR, "figure_10_planar" + end), (CIRCLE, "figure_10_circle" + end)]
          for end in ("", "_close")]
STRAIGHT = [[("RVD [29]", f"{page}_rvd"), ("LRVD [28]", f"{page}_lrvd"), (PLANAR, f"{page}_planar"), (EXACT, f"{page}_exact")]
            for page in ("figure_11", "plate")]

FIGURE_10 = ("Spot with 30 generators, seed 0, and its head and neck: the diffusion diagram follows the triangles, growth does not."
             " data/figure.obj replaces a missing model.")
FIGURE_11 = ("Elephant with 30 generators, if available, and a thin plate with 12, seed 0; each cell has the same colour in a row of pictures."
             " RVD's cells come through from the other side; each such piece is an island without its generator. LRVD divides them"
             " among the surrounding cells, by straight distances too.")


def compare_pictures(section, lines, folder, text):
    """Adds those rows whose pictures are all in the folder."""
    found = [line for line in lines if all((folder / "pictures" / f"{name}.webp").exists() for _, name in line)]
    if found:
        section.say(text)
    for line in found:
        section.compare(line)


def gallery(folder):
    """Figures 1 and 9, by the pictures of scripts/make_gallery.sh in the folder; nothing without them."""
    names = [name for name in GALLERY if (folder / "pictures" / f"{name}.webp").exists()]
    if not names:
        return []
    section = Section("Figures 1 and 9: Lucy and a gallery")
    section.show(names)
    section.say("These diagrams are from gvd-segment --method gbgvd with generators at random vertices. This repository makes the mesh of"
                " the figure.")
    return [section]


def picture(name):
    return f'<img src="pictures/{name}.webp" width="250" alt="{name.replace("_", " ")} with its cells and bisectors">'


def page_of(name):
    """The page of a picture: pictures of several scenes of one page are named after it."""
    return next((page for page in ("figure_10", "figure_11", "plate") if name.startswith(page)), name)
