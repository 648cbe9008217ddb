#!/bin/bash
# Run by conda-build. Without CGAL, whose shortest paths would bind the package to the GPL.
set -euo pipefail
cmake -S . -B build-conda -G Ninja ${CMAKE_ARGS:-} -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$PREFIX" \
  -DCMAKE_INSTALL_LIBDIR=lib -DGVD_BUILD_TESTS=OFF -DGVD_WITH_CGAL_GPL=OFF
cmake --build build-conda -j "${CPU_COUNT:-2}"
cmake --install build-conda
