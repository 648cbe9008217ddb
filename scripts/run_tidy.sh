#!/usr/bin/env bash
# Runs clang-tidy (see .clang-tidy) on C++ sources, each compiled alone, so that a missing include is an error.
#
#   scripts/run_tidy.sh                   all sources
#   scripts/run_tidy.sh --last N [MOST]   those that the last N commits changed, or whose own header they changed, the latest MOST
#                                         of them (changed_sources.py)
#
# JOBS processes run at a time (default: all cores). BUILD_LINT names the build tree, which is configured and not built.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
tree=${BUILD_LINT:-build-lint}

list_sources() {
  if [ "${1:-}" = --last ]; then
    scripts/changed_sources.py "${@:2}"
  else
    git ls-files '*.cpp'
  fi
}

scripts/configure.sh development "$tree" -DGVD_UNITY=OFF > /dev/null
# Sources that another configuration compiles (a build without XML, the web module) are not in the list of commands.
sed -n 's/^ *"file": "\(.*\)",\{0,1\}$/\1/p' "$tree/compile_commands.json" | sort -u > "$tree/compiled"
list_sources "$@" | sed "s|^|$PWD/|" | sort | comm -12 - "$tree/compiled" > "$tree/sources"
echo "clang-tidy: $(wc -l < "$tree/sources") sources"
# Sources in order of their size, the largest first: no long one runs alone at the end.
xargs -r ls -S < "$tree/sources" | xargs -r -P "${JOBS:-$(nproc)}" -n 1 bash -c '
  set -o pipefail
  clang-tidy -quiet -p "$0" "$1" 2>&1 | { grep -v "warnings\? generated\.$" || true; }' "$tree"
