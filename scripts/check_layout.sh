#!/usr/bin/env bash
# Fails where a C++ source is not laid out as .clang-format says; `make format` lays it out.
#
#   scripts/check_layout.sh
#
# Versions of clang-format differ in details: the sources follow 14, which is Debian 12's. CLANG_FORMAT names another program.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

git ls-files -z '*.cpp' '*.hpp' | xargs -0 "${CLANG_FORMAT:-clang-format}" --dry-run --Werror
echo "$(git ls-files '*.cpp' '*.hpp' | wc -l) sources, layout as .clang-format says"
