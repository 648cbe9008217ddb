#!/bin/sh
# Configures a build tree from a preset, with Ninja and ccache where they are installed.
#
#   scripts/configure.sh PRESET FOLDER [CMAKE FLAGS...]
set -eu
preset=$1
folder=$2
shift 2
# CMake keeps an existing tree's generator whatever this says.
if [ -z "${CMAKE_GENERATOR:-}" ] && command -v ninja >/dev/null 2>&1; then
  export CMAKE_GENERATOR=Ninja
fi
if command -v ccache >/dev/null 2>&1; then
  # Without these two, ccache refuses sources that use a precompiled header.
  sloppiness=$(ccache --get-config sloppiness | tr -d ' '),pch_defines,time_macros
  # The precompiled header has its path in the build tree: take it relative to that, so that other trees hit the cache.
  base=$(ccache --get-config base_dir)
  case "$folder" in /*) tree=$folder ;; *) tree=$PWD/$folder ;; esac
  set -- "-DCMAKE_CXX_COMPILER_LAUNCHER=cmake;-E;env;CCACHE_SLOPPINESS=${sloppiness#,};CCACHE_BASEDIR=${base:-$tree};ccache" "$@"
fi
exec cmake --preset "$preset" -B "$folder" "$@"
