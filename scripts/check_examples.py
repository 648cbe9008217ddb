#!/usr/bin/env python3
"""Runs the examples of README.md and docs/guide as written, each page in a temporary folder, its home too. Fails if one fails.

    scripts/check_examples.py BIN_FOLDER [PAGE...]

These are examples:

- a line that is indented by four spaces and runs a command of build/bin/; with the comment "# fails" it must fail;
- a ```sh block, with BIN_FOLDER on the PATH; one that calls a program that is not installed is named and left out;
- all ```python blocks of a page as one script, with the package gvd of BIN_FOLDER/../python; without it they are left out.
  A warning is an error.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
EXAMPLE = re.compile(r"^    (?P<line>(?:[^\n]*[ (])?build/bin/[^\n]*)$|^```sh\n(?P<sh>.*?)^```$", re.MULTILINE | re.DOTALL)
PYTHON = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
# Programs that not every machine has, and which are too large for the groups of install-deps.sh.
OPTIONAL = ("blender",)


class Page:
    """A page whose examples run in a folder."""

    def __init__(self, path, bin_folder, folder):
        self.name, self.text = os.path.relpath(path, ROOT), path.read_text()
        self.folder, self.package = folder, bin_folder.parent / "python"
        (folder / "build").mkdir()
        (folder / "build/bin").symlink_to(bin_folder)
        (folder / "data").symlink_to(ROOT / "data")
        self.environment = {**os.environ, "PATH": f"{bin_folder}:{os.environ['PATH']}", "PYTHONPATH": str(self.package),
                            "HOME": str(folder)}

    def run(self, example, command, expected=True):
        """Runs one example. Returns whether it did what it says, and prints it if it did not."""
        ran = subprocess.run([*command, example], cwd=self.folder, env=self.environment, stdin=subprocess.DEVNULL, text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, errors="replace")
        if (ran.returncode == 0) == expected or "not part of this build" in ran.stdout:  # an optional part: the viewer or CGAL
            return True
        print(f"{self.name}: {example}\n    " + ran.stdout.replace("\n", "\n    "))
        return False

    def run_all(self):
        """Returns for each example whether it did what it says."""
        results = []
        for example in EXAMPLE.finditer(self.text):
            if example["line"]:
                results.append(self.run(example["line"], ["bash", "-c"], "# fails" not in example["line"]))
                continue
            missing = [name for name in OPTIONAL if re.search(rf"^{name} ", example["sh"], re.MULTILINE) and not shutil.which(name)]
            if missing:
                print(f"{self.name}: a block is left out, because {missing[0]} is not installed")
            else:
                results.append(self.run(example["sh"], ["sh", "-e", "-c"]))
        script = "\n".join(PYTHON.findall(self.text))
        if script and not (self.package / "gvd").is_dir():
            print(f"{self.name}: the Python lines are left out, because there is no package in {self.package}")
        elif script:
            results.append(self.run(script, [os.environ.get("GVD_PYTHON", "/usr/bin/python3"), "-W", "error::UserWarning", "-c"]))
        return results


def main():
    bin_folder = pathlib.Path(sys.argv[1]).resolve()
    pages = [pathlib.Path(name).resolve() for name in sys.argv[2:]] or [ROOT / "README.md", *sorted((ROOT / "docs/guide").rglob("*.md"))]
    results = []
    for path in pages:
        with tempfile.TemporaryDirectory() as folder:
            results += Page(path, bin_folder, pathlib.Path(folder)).run_all()
    print(f"{len(results)} examples of the documents, {results.count(False)} that do not do what they say")
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
