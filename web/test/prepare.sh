# For the scripts beside it: puts the tests and their packages into a folder, and goes there: prepare FOLDER, after `here` is set.
#
# Exits with 77 and a message where npm is missing, and with 1 where it can't fetch the packages: a network is expected where it is.
prepare() {
  command -v npm >/dev/null || { echo "skipped: no npm (scripts/install-deps.sh build)"; exit 77; }
  mkdir -p "$1"
  cp -p "$here/package.json" "$here/package-lock.json" "$here/.npmrc" "$here"/*.mjs "$1"
  cd "$1"
  if [ ! -e node_modules/.package-lock.json ] || [ package-lock.json -nt node_modules/.package-lock.json ]; then
    npm ci --loglevel=error --no-update-notifier || {
      echo "npm could not fetch the packages of web/test/package-lock.json, for the reason above. Try again with a network, or with" >&2
      echo "another registry (npm config set registry ADDRESS); without one, leave these tests out: ctest -LE browser" >&2
      exit 1
    }
  fi
}
