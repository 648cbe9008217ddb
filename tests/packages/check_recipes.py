#!/usr/bin/env python3
"""Fails where a recipe of packaging/ or a workflow can't be parsed, or has fallen behind the build.

    check_recipes.py SOURCE_FOLDER

Each recipe names the version of the project, every library that the build asks for, and only options that the build has. Exits
with 77 if PyYAML or Jinja2 is missing. Ruby checks the formula if it is installed.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys

try:
    import jinja2
    import yaml
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

# What find_package and find_path ask for, and the names of conda-forge, vcpkg and Homebrew. CGAL is an option.
NAMES = {"Eigen3": ("eigen", "eigen3", "eigen"), "OpenMesh": ("openmesh", "openmesh", "open-mesh"),
         "nlohmann_json": ("nlohmann_json", "nlohmann-json", "nlohmann-json"), "fmt": ("fmt", "fmt", "fmt"),
         "TBB": ("tbb-devel", "tbb", "tbb"),
         "pugixml": ("pugixml", "pugixml", "pugixml"), "ZLIB": ("zlib", "zlib", "zlib"),
         "GVD_TOMLPLUSPLUS_INCLUDE": ("tomlplusplus", "tomlplusplus", "tomlplusplus"), "CGAL": (None, "cgal", None)}


def read_build(source):
    """The version, the packages that are required, and the options of the build."""
    texts = [path.read_text() for path in [source / "CMakeLists.txt", *source.glob("*/CMakeLists.txt"), *source.glob("cmake/*.cmake")]
             if path.parent.name not in ("tests", "examples", "bench")]
    text = "\n".join(texts)
    version = re.search(r"project\(gvd VERSION (\S+)", text)[1]
    packages = set(re.findall(r"find_package\((\w+)[^)]*REQUIRED", text)) | set(re.findall(r"find_path\((\w+)", text)) | {"CGAL"}
    return version, packages - {"gvd"}, set(re.findall(r"option\((GVD_\w+)", text)) | set(re.findall(r"set\((GVD_\w+)", text))


def read_conda(text):
    helpers = {"compiler": lambda language: language, "stdlib": lambda language: language}
    recipe = yaml.safe_load(jinja2.Environment(undefined=jinja2.StrictUndefined).from_string(text).render(helpers))
    return str(recipe["package"]["version"]), {entry.split()[0] for entry in recipe["requirements"]["host"]}


def read_vcpkg(text):
    port = json.loads(text)
    lists = [port["dependencies"], *(feature["dependencies"] for feature in port["features"].values())]
    return port["version"], {entry if isinstance(entry, str) else entry["name"] for entries in lists for entry in entries}


def check(source):
    version, packages, options = read_build(source)
    if unknown := packages - NAMES.keys():
        yield f"the build asks for {unknown}: add it to the recipes, and its names to NAMES"
    conda = source / "packaging/conda/meta.yaml"
    port = source / "packaging/vcpkg/gvd/vcpkg.json"
    formula = source / "packaging/homebrew/gvd.rb"
    recipes = [(conda, *read_conda(conda.read_text())), (port, *read_vcpkg(port.read_text())),
               (formula, version, set(re.findall(r'depends_on "([^"]+)"', formula.read_text())))]
    for column, (path, named, dependencies) in enumerate(recipes):
        if named != version:
            yield f"{path}: version {named}; the project has {version}"
        yield from (f"{path}: {NAMES[p][column]} is missing, for {p}" for p in sorted(packages & NAMES.keys())
                    if NAMES[p][column] and NAMES[p][column] not in dependencies)
    for path in sorted((source / "packaging").rglob("*")):
        if path.is_file():
            used = set(re.findall(r"GVD_[A-Z_]+", path.read_text())) if path.suffix not in (".in",) else set()
            yield from (f"{path}: the build has no option {option}" for option in sorted(used - options))
    for path in (source / ".github/workflows").glob("*.yml"):
        workflow = yaml.safe_load(path.read_text())
        if not all(job["steps"] and job["runs-on"] for job in workflow["jobs"].values()):
            yield f"{path}: a job without steps"
    if shutil.which("ruby") and subprocess.run(["ruby", "-c", formula], stdout=subprocess.DEVNULL).returncode:
        yield f"{formula}: ruby can't parse it"


def main():
    findings = list(check(pathlib.Path(sys.argv[1])))
    print("\n".join([*findings, f"{len(findings)} findings"]))
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
