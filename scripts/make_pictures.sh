#!/bin/sh
# Makes the pictures of the documents: runs the commands on meshes of data/, opens their pages in a headless browser and
# takes the pictures that web/pictures/pictures.mjs lists.
#
#   scripts/make_pictures.sh BIN_FOLDER WORK_FOLDER PICTURE_FOLDER
#
# Needs npm (for playwright-core, pinned by web/test/package-lock.json) and Chromium; CHROMIUM names a browser other than
# /usr/bin/chromium. The pages and the packages go to WORK_FOLDER.
set -eu
bin=$1
work=$2
pictures=$3
web=$(cd "$(dirname "$0")/../web" && pwd)
mkdir -p "$work" "$pictures"
work=$(cd "$work" && pwd)
pictures=$(cd "$pictures" && pwd)

run() {
  command=$1
  shift
  echo "\$ $command $*"
  "$bin/$command" -q "$@"
}

# The pictures of the README: its first commands.
run gvd-segment data/figure.obj -n 24 --view "$work/segments.html"
run gvd-lloyd   data/figure.obj -n 300 -o "$work/samples.json" --view "$work/samples.html"
run gvd-remesh  data/figure.obj -n 300 --view "$work/coarse.html"

# The pages of the tasks.
python3 data/make_cortex.py "$work"
run gvd-lloyd    "$work/cortex.surf.gii" -n 200 -o "$work/parcels.csv"
run gvd-segment  "$work/cortex.surf.gii" --generators "$work/parcels.csv" --up z --view "$work/task_parcels.html"
run gvd-lloyd    data/half_sphere.off -n 200 --view "$work/task_samples.html"
run gvd-remesh   data/figure.obj --target-edge 0.2 --view "$work/task_simulation.html"
run gvd-distance data/figure.obj --from 1867 --to 1874 --paths --isolines 0.25 --view "$work/task_measure.html"
if command -v blender > /dev/null; then
  run gvd-segment data/figure.obj -n 24 --no-curves -o "$work/regions.obj"
  blender --background --factory-startup --python-exit-code 1 --python "$web/pictures/render_regions.py" -- \
    "$work/regions.obj" "$pictures/task_blender.webp" > /dev/null
fi

# Samplings, and a relaxation of random generators.
run gvd-segment data/figure.obj -n 100 --view "$work/farthest.html"
run gvd-segment data/figure.obj -n 100 --sampling poisson --view "$work/poisson.html"
run gvd-lloyd   data/figure.obj -n 100 --sampling random --view "$work/relaxed.html"

# The energies of that relaxation, by each kind of step.
for steps in lbfgs none; do
  run gvd-lloyd data/figure.obj -n 100 --sampling random --accelerate $steps --relocate off -o "$work/$steps.txt" \
    --report "$work/$steps.json"
done
"$(dirname "$0")"/plot_energies.py "$pictures/energies.svg" "$work/lbfgs.json" "$work/none.json"
"$(dirname "$0")"/draw_how_it_works.py "$pictures"

# A mesh that is cut along its bisectors.
run gvd-segment data/figure.obj -n 24 --cut --view "$work/cut.html"

# An open surface.
run gvd-segment data/half_sphere.off -n 12 --view "$work/open.html"
run gvd-remesh  data/half_sphere.off -n 60 --view "$work/open_coarse.html"

# Distances from two points.
run gvd-distance data/figure.obj --from 17,2000 --isolines 0.1 --view "$work/isolines.html"

# What the gallery shows beside these.
run gvd-segment  data/figure.obj -n 24 --balance area --view "$work/gallery_equal.html"
run gvd-segment  data/figure.obj --levels 6,60 --view "$work/gallery_levels.html"
run gvd-segment  data/figure.obj -n 6 --disc --view "$work/gallery_discs.html"
run gvd-distance data/figure.obj --from 17 --isolines 0.4 -o "$work/bands.json"
run gvd-segment  data/figure.obj --curves "$work/bands.json" --view "$work/gallery_bands.html"
run gvd-segment  data/torus.ply -n 12 --view "$work/gallery_torus.html"
run gvd-lloyd    data/torus.ply -n 200 --view "$work/gallery_torus_samples.html"
run gvd-remesh   data/plate.stl -n 8 --features 40 --view "$work/gallery_box.html"
run gvd-remesh   data/figure.obj -n 300 --density curvature --view "$work/gallery_curvature.html"

cp -p "$web"/test/package.json "$web"/test/package-lock.json "$web"/test/.npmrc "$web"/pictures/*.mjs "$work"
cd "$work"
if [ ! -e node_modules/.package-lock.json ] || [ package-lock.json -nt node_modules/.package-lock.json ]; then
  npm ci --loglevel=error --no-update-notifier
fi
node make_pictures.mjs . "$pictures"
