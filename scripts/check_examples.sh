#!/bin/sh
# Runs the example commands of README.md and docs/guide as written, in a temporary folder: all lines that are indented by
# four spaces and begin with build/bin/. Fails if an example fails, unless it has the comment "# fails"; then it must fail.
#
#   scripts/check_examples.sh BIN_FOLDER
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
bin=$(cd "$1" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
trap 'exit 130' INT TERM
mkdir "$folder/build"
ln -s "$bin" "$folder/build/bin"
ln -s "$root/data" "$folder/data"
cd "$folder"

checked=0
failed=0
for page in "$root"/README.md "$root"/docs/guide/*.md; do
  sed -n 's#^    \(build/bin/.*\)#\1#p' "$page" > examples
  while IFS= read -r example; do
    checked=$((checked + 1))
    case "$example" in *"# fails"*) expected=1 ;; *) expected=0 ;; esac
    status=0
    sh -c "$example" > messages 2>&1 < /dev/null || status=1
    [ "$status" -eq "$expected" ] && continue
    grep -q "not part of this build" messages && continue  # an optional part: the viewer or CGAL
    failed=$((failed + 1))
    echo "${page#"$root"/}: $example"
    sed 's/^/    /' messages
  done < examples
done
echo "$checked examples of the documents, $failed that do not do what they say"
[ "$failed" -eq 0 ]
