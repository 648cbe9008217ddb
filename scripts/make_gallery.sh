#!/bin/sh
# Makes figures 1, 9, 10 and 11 of the paper as pages, and pictures of the pages: diagrams of gvd-segment --method gbgvd, and
# of gvd-compare for the comparators.
#
#   scripts/make_gallery.sh BIN_FOLDER FOLDER [MODEL_FOLDER...]
#
# Writes FOLDER/pages, and also FOLDER/pictures if npm and Chromium are installed (CHROMIUM names a browser other than
# /usr/bin/chromium). Missing models are skipped; data/figure.obj is always available.
set -eu
here=$(cd "$(dirname "$0")/.." && pwd)
bin=$1
folder=$2
shift 2
mkdir -p "$folder/pages"
folder=$(cd "$folder" && pwd)

# gallery NAME GENERATORS FILE...: a page of the first file that a folder has. The numbers of generators are those of table 4
# if the paper names one.
gallery() {
  name=$1
  count=$2
  shift 2
  for file in "$@"; do
    if [ -e "$file" ]; then
      "$bin/gvd-segment" -q "$file" -n "$count" --sampling vertices --method gbgvd --view "$folder/pages/$name.html"
      return
    fi
  done
}

# compare NAME GENERATORS METHODS FILE...: a page of the first file that exists, with a scene for each method.
compare() {
  name=$1
  count=$2
  methods=$3
  shift 3
  for file in "$@"; do
    if [ -e "$file" ]; then
      "$bin/gvd-compare" "$file" -m "$count" --methods "$methods" --view "$folder/pages/$name.html" >/dev/null
      return
    fi
  done
}

# in_folders FILE...: the files in every model folder, one per line.
in_folders() {
  for file in "$@"; do
    for models in $folders; do echo "$models/$file"; done
  done
}

folders=$*
# shellcheck disable=SC2046
{
  gallery lucy 43 $(in_folders lucy.obj)
  gallery kitten 50 $(in_folders kitten_16k.obj kitten_106k.obj)
  gallery bunny 47 $(in_folders bunny_28k.obj)
  gallery bear 21 $(in_folders bear.m20.obj)
  gallery spot 30 $(in_folders spot.m30.obj)
  gallery elephant 30 $(in_folders elephant.m20.obj)
  gallery fandisk 35 $(in_folders fandisk.obj)
  gallery rocker_arm 24 $(in_folders rocker_arm.obj)
  compare figure_10 30 "diffusion [8],gbgvd planar,gbgvd circle" $(in_folders spot.m30.obj) "$here/data/figure.obj"
  compare figure_11 30 "RVD [29],LRVD [28],gbgvd planar,exact" $(in_folders elephant.m20.obj)
}
compare plate 12 "RVD [29],LRVD [28],gbgvd planar,exact" "$here/data/plate.stl"
gallery figure 24 "$here/data/figure.obj"

if ! command -v npm >/dev/null || [ ! -e "${CHROMIUM:-/usr/bin/chromium}" ]; then
  echo "no pictures of the gallery: npm or Chromium is missing"
  exit 0
fi
work=$folder/pages
cp -p "$here"/web/test/package.json "$here"/web/test/package-lock.json "$here"/web/test/.npmrc "$here"/web/pictures/*.mjs "$work"
cd "$work"
[ -e node_modules/.package-lock.json ] || npm ci --loglevel=error --no-update-notifier
node make_pictures.mjs . "$folder/pictures" gallery.mjs
