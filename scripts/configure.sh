#!/bin/sh
# Configures a build tree from a preset, with Ninja and ccache if they are installed.
#
#   scripts/configure.sh PRESET FOLDER [CMAKE FLAGS...]
set -eu
preset=$1
folder=$2
shift 2
# CMake keeps the generator of an existing build tree.
if [ -z "${CMAKE_GENERATOR:-}" ] && command -v ninja >/dev/null 2>&1; then
  export CMAKE_GENERATOR=Ninja
fi
if command -v ccache >/dev/null 2>&1; then
  set -- -DCMAKE_CXX_COMPILER_LAUNCHER=ccache "$@"
fi
exec cmake --preset "$preset" -B "$folder" "$@"
