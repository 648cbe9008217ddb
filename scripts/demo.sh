#!/bin/sh
# Runs the commands on a mesh of data/ and lists the files that they write.
#
#   scripts/demo.sh BIN_FOLDER OUTPUT_FOLDER
#   scripts/demo.sh --announce BUILD_FOLDER OUTPUT_FOLDER MISSING_PACKAGES    announces what `make demo` will do
set -eu
mesh=data/figure.obj

announce() {
  echo "make demo"
  if [ -n "$3" ]; then
    echo "  1. installs these Debian packages, with sudo where you are not root: $3"
  else
    echo "  1. installs no package: none is missing, or NO_INSTALL is set, or this is no Debian or Ubuntu"
  fi
  echo "  2. builds the library and the commands under $1/: 2 to 5 minutes on two cores, packages included."
  echo "     It fetches three.js and esbuild from npm into $1/. The next build takes only what has changed"
  echo "  3. runs the commands on $mesh and writes to $2/, in a few seconds. Pages to open in a browser:"
  echo "     $2/segments.html, $2/relaxed.html, $2/coarse.html, $2/distances.html"
}

if [ "$1" = --announce ]; then
  shift
  announce "$@"
  exit 0
fi

bin=$1
out=$2
mkdir -p "$out"

run() {
  echo
  echo "\$ $*"
  "$@"
}

# A build without the viewer (GVD_WITH_VIEWER=OFF) makes no pages.
pages=yes
"$bin/gvd-segment" -q "$mesh" -n 2 --view "$out/segments.html" 2>/dev/null || pages=""

# 24 regions; 300 relaxed samples; a coarse mesh with these samples as vertices; distances from the nose, and the path to a hind foot.
run "$bin/gvd-segment" "$mesh" -n 24 \
  -o "$out/segments.ply" --diagram "$out/segments.json" --report "$out/segments-report.json" ${pages:+--view "$out/segments.html"}
run "$bin/gvd-lloyd" "$mesh" -n 300 \
  -o "$out/relaxed.json" --report "$out/relaxed-report.json" ${pages:+--view "$out/relaxed.html"}
run "$bin/gvd-remesh" "$mesh" --generators "$out/relaxed.json" \
  -o "$out/coarse.obj" --report "$out/coarse-report.json" ${pages:+--view "$out/coarse.html"}
run "$bin/gvd-distance" "$mesh" --from 1867 --to 520 --paths --isolines 0.1 \
  -o "$out/distances.npy" --report "$out/distances-report.json" ${pages:+--view "$out/distances.html"}

echo
echo "Written:"
for file in segments.ply segments.json relaxed.json coarse.obj distances.npy \
            segments-report.json relaxed-report.json coarse-report.json distances-report.json; do
  echo "  $out/$file"
done
[ -n "$pages" ] || exit 0
echo "Pages, to open in a browser:"
for file in segments.html relaxed.html coarse.html distances.html; do
  echo "  $out/$file"
done
