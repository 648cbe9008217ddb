#!/usr/bin/env python3
"""scripts/changed_sources.py finds the sources that commits changed, and those whose own header they changed, wherever it lies.

    check_changed_sources.py SCRIPT WORK_FOLDER
"""
import os
import pathlib
import shutil
import subprocess
import sys

script, work = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
# Commits need a name, and nothing else of the user's own settings.
ENVIRONMENT = {**os.environ, "GIT_CONFIG_GLOBAL": os.devnull, "GIT_CONFIG_SYSTEM": os.devnull}
for role in ("AUTHOR", "COMMITTER"):
    ENVIRONMENT |= {f"GIT_{role}_NAME": "test", f"GIT_{role}_EMAIL": "test@localhost"}


def git(*arguments):
    subprocess.run(["git", *arguments], cwd=work, env=ENVIRONMENT, check=True, stdout=subprocess.DEVNULL)


def commit(files):
    for name, text in files.items():
        (work / name).parent.mkdir(parents=True, exist_ok=True)
        (work / name).write_text(text)
    git("add", "--all")
    git("commit", "--quiet", "--message", "change")


def changed(*numbers):
    return subprocess.run([sys.executable, script, *map(str, numbers)], cwd=work, env=ENVIRONMENT, check=True, text=True,
                          capture_output=True).stdout.split()


shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)
git("init", "--quiet")
commit({"include/gvd/mesh.hpp": "struct Mesh;\n",
        "src/mesh/mesh.cpp": '// The mesh.\n#include "gvd/mesh.hpp"\n',
        "src/other.cpp": '#include "gvd/mesh.hpp"\n',               # has another name
        "python/src/mesh.cpp": '#include "bindings.hpp"\n',         # includes another header
        "web/mesh.cpp": '#include "own/gvd/mesh.hpp"\n',            # one of the same name that lies elsewhere
        "src/steps.hpp": "int f();\n",
        "src/steps.cpp": '#include "steps.hpp"\n',
        "src/gone.hpp": "int g();\n"})
commit({"include/gvd/mesh.hpp": "struct Mesh {};\n"})
assert changed(1) == ["src/mesh/mesh.cpp"], changed(1)
commit({"src/steps.hpp": "int f(int);\n", "README.md": "words\n"})
assert changed(1) == ["src/steps.cpp"], changed(1)
assert changed(2) == ["src/steps.cpp", "src/mesh/mesh.cpp"], changed(2)
assert changed(2, 1) == ["src/steps.cpp"], changed(2, 1)
commit({"src/other.cpp": "int h();\n"})
(work / "src/gone.hpp").unlink()
(work / "python/src/mesh.cpp").unlink()
commit({})
assert changed(2) == ["src/other.cpp"], changed(2)
assert sorted(changed(99)) == ["src/mesh/mesh.cpp", "src/other.cpp", "src/steps.cpp", "web/mesh.cpp"], changed(99)
