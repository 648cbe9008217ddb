#!/bin/sh
# Runs the three commands on a mesh of data/ and names the files that they wrote.
#
#   scripts/demo.sh BIN_FOLDER OUTPUT_FOLDER
set -eu
bin=$1
out=$2
mesh=data/figure.obj
mkdir -p "$out"

run() {
  echo
  echo "\$ $*"
  "$@"
}

# 24 regions; the same number of samples, relaxed; a coarse mesh.
run "$bin/gvd-segment" "$mesh" -n 24 \
  -o "$out/segments.ply" --diagram "$out/segments.json" --report "$out/segments-report.json" --view "$out/segments.html"
run "$bin/gvd-lloyd" "$mesh" -n 24 \
  -o "$out/relaxed.json" --report "$out/relaxed-report.json" --view "$out/relaxed.html"
run "$bin/gvd-remesh" "$mesh" -n 300 \
  -o "$out/coarse.obj" --report "$out/coarse-report.json" --view "$out/coarse.html"

echo
echo "Written:"
for file in segments.ply segments.json relaxed.json coarse.obj \
            segments-report.json relaxed-report.json coarse-report.json; do
  echo "  $out/$file"
done
echo "Pictures, to open in a browser:"
for file in segments.html relaxed.html coarse.html; do
  echo "  $out/$file"
done
