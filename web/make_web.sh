#!/bin/sh
# Packs the npm package, and bundles the playground into one file: make_web.sh MODULE_BUILD_TREE OUTPUT
set -eu
here=$(cd "$(dirname "$0")" && pwd)
package=$(realpath "$1/package")
work=$1/playground
output=$(realpath "$2")

mkdir -p "$work"
cp -rp "$here/package.json" "$here/package-lock.json" "$here/.npmrc" "$here/src" "$here/bundle.mjs" "$here/build_playground.mjs" "$work"
rm -f "$output"/gvd-*.tgz
cd "$work"
if [ ! -e node_modules/.package-lock.json ] || [ package-lock.json -nt node_modules/.package-lock.json ]; then
  npm ci --loglevel=error --no-update-notifier
fi
# The guide is the package's README, in which links to other pages of the guide would lead nowhere.
sed -E 's/\[([^]]+)\]\([^):]*\)/\1/g' "$here/../docs/guide/javascript.md" > "$package/README.md"
npm pack --silent --pack-destination "$output" "$package" >/dev/null
data=$(realpath "$here/../data")
node build_playground.mjs "$package" "$output/index.html" "$data/figure.obj" "$data/torus.ply" "$data/half_sphere.off"
