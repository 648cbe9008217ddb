#!/usr/bin/env bash
# Fails if the layout of a C++ source differs from .clang-format; `make format` corrects it.
#
#   scripts/check_layout.sh
#
# Versions of clang-format differ in details; the sources follow version 14 of Debian 12. CLANG_FORMAT names another program.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

git ls-files -z '*.cpp' '*.hpp' | xargs -0 "${CLANG_FORMAT:-clang-format}" --dry-run --Werror
echo "$(git ls-files '*.cpp' '*.hpp' | wc -l) sources, layout as .clang-format says"
