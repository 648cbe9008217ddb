#!/usr/bin/env bash
# What `make release-check` runs before a release: the Debian packages in bare roots, and every command of README and guide alone,
# on a system that has nothing but what README asks for.
#
#   scripts/release_check.sh FOLDER [--keep] [--ccache] [CHECK...]    the checks are listed below; without a CHECK all of them
#
# FOLDER/system is a Debian system with make and git, made once by debootstrap. Each check gets a copy of it, with a clone of HEAD in
# /gvd, so what is not committed is not checked. A check passes if its commands succeed and its files are there; whether it passes or
# not, the others go on. --keep leaves the copies in FOLDER/roots. --ccache saves hours: the system has ccache, too, and the checks share
# what they compile. Mirrors, proxies and certificates are those of this machine.
# Needs Debian or Ubuntu, network, and root or sudo. scripts/check_commands.py fails on a command of a document that is not here.
set -euo pipefail
export LC_ALL=C.UTF-8
checks="packages demo no-viewer python venv web site tasks cohort package package-mit python3-gvd install bench test"
[ "$(id -u)" -eq 0 ] || exec sudo -E "$0" "$@"

source=$(realpath "$(dirname "$0")/..")
mkdir -p "$1/logs" "$1/roots" "$1/archives/partial" "$1/ccache"
folder=$(realpath "$1")
shift
keep="" cached="" system=$folder/system
while [[ ${1:-} == --* ]]; do
  case "$1" in
    --keep) keep=yes ;;
    --ccache) cached=yes system=$folder/system-ccache ;;
    *) echo "release_check.sh: no option '$1' (--keep or --ccache)" >&2; exit 2 ;;
  esac
  shift
done
wanted=" ${*:-$checks} "
for name in $wanted; do
  [[ " $checks " == *" $name "* ]] || { echo "release_check.sh: no check '$name' (one of: $checks)" >&2; exit 2; }
done
summary=()
failures=0

# The mirror that apt takes the distribution's own packages from.
mirror() {
  # shellcheck disable=SC2016 # apt replaces these
  apt-get indextargets --format '$(REPO_URI) $(CODENAME) $(COMPONENT)' "Created-By: Packages" |
    awk -v codename="$1" '$2 == codename && $3 == "main" { print $1; exit }'
}

# How this machine reaches the network: names, apt's sources and keys, proxies, and certificates of its own.
copy_network_settings() {
  local root=$1 name
  cp -L /etc/resolv.conf /etc/hosts "$root/etc/"
  rm -f "$root/etc/apt/sources.list"
  for name in sources.list sources.list.d keyrings trusted.gpg.d preferences.d; do
    if [ -e "/etc/apt/$name" ]; then cp -aL "/etc/apt/$name" "$root/etc/apt/"; fi
  done
  { apt-config dump | grep -i '^Acquire::.*\(Proxy\|Check\)' || true
    echo 'APT::Get::Assume-Yes "true";'; } > "$root/etc/apt/apt.conf.d/90release-check"
  echo force-unsafe-io > "$root/etc/dpkg/dpkg.cfg.d/release-check"  # the root is for one check only
  if [ -d /usr/local/share/ca-certificates ]; then cp -aL /usr/local/share/ca-certificates "$root/usr/local/share/"; fi
  chroot "$root" update-ca-certificates >/dev/null 2>&1
}

make_system() {
  [ ! -e "$system.complete" ] || return 0
  local codename
  codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
  echo "making a bare system of $codename in $system"
  rm -rf "$system"
  debootstrap --variant=minbase --include="make,git,ca-certificates${cached:+,ccache}" "$codename" "$system" "$(mirror "$codename")" \
    > "$folder/logs/debootstrap.log" 2>&1 || { tail "$folder/logs/debootstrap.log" >&2; exit 1; }
  copy_network_settings "$system"
  mkdir -p "$system/root/.cache/ccache"
  touch "$system.complete"
}

# run_in ROOT SCRIPT: a login of root in /gvd, without this machine's environment but for its proxies. Mounts end with the process.
run_in() {
  local root=$1 script=$2 settings=() name
  for name in http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY; do
    if [ -n "${!name:-}" ]; then settings+=("$name=${!name}"); fi
  done
  # Node.js brings its own list of certificates.
  settings+=(NODE_EXTRA_CA_CERTS=/etc/ssl/certs/ca-certificates.crt)
  if command -v npm >/dev/null; then settings+=("npm_config_registry=$(npm config get registry)"); fi
  # shellcheck disable=SC2016 # the inner shell's words
  unshare --mount --pid --fork sh -eu -c '
    root=$1
    mount --make-rprivate /
    mount --rbind /dev "$root/dev"
    mount -t proc proc "$root/proc"
    mount --bind "$2" "$root/var/cache/apt/archives"
    mount --bind "$3" "$root/root/.cache/ccache"
    shift 3
    exec chroot "$root" env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 "$@"
  ' sh "$root" "$folder/archives" "$folder/ccache" "${settings[@]}" bash -euo pipefail -c "cd /gvd; sudo() { \"\$@\"; }; $script" </dev/null
}

# Each line of a check that is indented by four spaces stands so in a document; the others are this script's.
check_that_documents_say() {
  local line
  while IFS= read -r line; do
    [[ $line == "    "* ]] || continue
    line=${line#    }
    grep -rqF -e "$line" "$source/README.md" "$source/docs/guide" || { echo "no document says: $line" >&2; return 1; }
  done <<< "$1"
}

in_bare_root() {
  local name=$1 script=$2 root file
  shift 2
  root=$folder/roots/$name
  check_that_documents_say "$script" || return 1
  rm -rf "$root"
  cp -a --reflink=auto "$system" "$root" || return 1
  git -c safe.directory='*' clone -q "$source" "$root/gvd" || return 1  # a clone of another user, where sudo runs this
  run_in "$root" "$script" || return 1
  for file in "$@"; do
    [ -s "$root/gvd/$file" ] || { echo "$file is missing" >&2; return 1; }
  done
}

# packages FOLDER: all steps of the test of the packages, of which .ci/run takes two.
packages() {
  make --no-print-directory -C "$source" package BUILD="$folder/build" </dev/null && "$source/tests/packages/check_packages.sh" "$folder/build"
}

# check NAME COMMAND WORD...: runs the command, with its output in a log, unless other checks are wanted.
check() {
  local name=$1 log=$folder/logs/$1.log started=$SECONDS result=passed
  shift
  [[ $wanted == *" $name "* ]] || return 0
  echo "==> $name (log: $log)"
  "$@" > "$log" 2>&1 || result=FAILED
  if [ "$result" = FAILED ]; then
    failures=$((failures + 1))
    tail -n 30 "$log" | sed 's/^/    /'
  fi
  if [ -z "$keep" ]; then rm -rf "$folder/roots/$name"; fi
  summary+=("$(printf '%-12s %s %5d s' "$name" "$result" $((SECONDS - started)))")
}

bare() { check "$1" in_bare_root "$@"; }

python_lines="sed -n '/^\`\`\`python/,/^\`\`\`/{//!p}' README.md > /tmp/lines.py"
make_system

check packages packages

bare demo "
    make demo
    build/bin/gvd-segment data/figure.obj -n 24 -o regions.ply --view regions.html
    build/bin/gvd-lloyd   data/figure.obj -n 300 -o samples.json --view samples.html
    build/bin/gvd-remesh  data/figure.obj --generators samples.json -o coarse.obj --view coarse.html
" demo-output/{segments.ply,coarse.obj,segments.html,relaxed.html,coarse.html,distances.html} regions.{ply,html} samples.html coarse.html

bare no-viewer "
    make
    make demo CMAKE_FLAGS=-DGVD_WITH_VIEWER=OFF
" demo-output/{segments.ply,coarse.obj,distances.npy}

# The module that `make python` has built serves an environment, too.
bare python "
    make python && export PYTHONPATH=\$PWD/build/python
$python_lines
/usr/bin/python3 /tmp/lines.py
mv regions.html built.html && unset PYTHONPATH
    /usr/bin/python3 -m venv --system-site-packages venv
    GVD_BUILD=build venv/bin/pip install .
venv/bin/python /tmp/lines.py
" built.html regions.html

bare venv "
    scripts/install-deps.sh build python && /usr/bin/python3 -m venv --system-site-packages venv && venv/bin/pip install .
$python_lines
venv/bin/python /tmp/lines.py
" regions.html

bare web "
    make web
    npm install --prefix my-project \$PWD/build/web/gvd-*.tgz
{ echo \"import { readFileSync } from 'node:fs'; const bytes = readFileSync('data/figure.obj');\"
  sed -n '/^\`\`\`js/,/^\`\`\`/{//!p}' docs/guide/javascript.md
  echo \"if (!coarse.certificate.ok || file.length < 1000) process.exit(1);\"; } > my-project/lines.mjs
node my-project/lines.mjs
" build/web/index.html

bare site "
    make site
" build/site/index.html

bare tasks "
    make build && make python
    export PATH=\$PWD/build/bin:\$PATH PYTHONPATH=\$PWD/build/python
gvd-segment --version && /usr/bin/python3 -c 'import gvd'
apt-get install --no-install-recommends blender  # for its page; where it is missing, the block is left out
scripts/check_examples.py build/bin docs/guide/tasks/*.md
"

# The folders have the names that the guide gives them.
bare cohort "
    scripts/install-deps.sh cohort
    make build python
    export PYTHONPATH=\$PWD/build/python
mkdir -p /FOLDER/OF/MESHES && cp data/torus.ply data/plate.stl data/half_sphere.off /FOLDER/OF/MESHES
    snakemake -s examples/cohort/Snakefile --profile examples/cohort/local -d RESULTS \\
      --config meshes=/FOLDER/OF/MESHES bin=\$PWD/build/bin
    snakemake -s examples/cohort/Snakefile --profile examples/cohort/local -d RESULTS --unlock \\
      --config meshes=/FOLDER/OF/MESHES bin=\$PWD/build/bin
    examples/cohort/measure.py run build/bin WORK data/figure.obj data/half_sphere.off@3 > costs.tsv
    examples/cohort/measure.py fit costs.tsv
" RESULTS/cohort.csv RESULTS/cohort.html RESULTS/torus.ply/remesh/{mesh.ply,page.html,thumbnail.png} costs.tsv

bare package "
    make package
    sudo apt-get install ./build/packages/gvd_*.deb
gvd-segment data/figure.obj -n 24 -o regions.ply --view regions.html
    sudo apt-get install ./build/packages/libgvd-c0.2_*.deb ./build/packages/libgvd-dev_*.deb
apt-get install pkg-config
    g++ -o diagram_of_a_mesh /usr/share/doc/gvd/examples/diagram_of_a_mesh.cpp \$(pkg-config --cflags --libs gvd)
    cc -o path_of_a_mesh /usr/share/doc/gvd/examples/path_of_a_mesh.c \$(pkg-config --cflags --libs gvd_c)
./diagram_of_a_mesh data/figure.obj
./path_of_a_mesh data/figure.obj 0 100
cp /usr/share/doc/gvd/examples/path_of_a_mesh.c path.c
    cc path.c \$(pkg-config --cflags --libs gvd_c)
./a.out data/figure.obj 0 100
apt-get install python3
sed -n '/^\`\`\`py$/,/^\`\`\`/{//!p}' docs/guide/c.md docs/developer/bindings.md > /tmp/lines.py
python3 /tmp/lines.py
" regions.ply regions.html

bare package-mit "
    make package CMAKE_FLAGS=-DGVD_WITH_CGAL_GPL=OFF
    sudo apt-get install ./build/packages/gvd_*.deb
if ls build/packages/libgvd-verify-dev_*.deb; then exit 1; fi
if gvd-segment data/figure.obj -n 24 --verify; then exit 1; fi
    sudo apt-get install ./build/packages/libgvd-c0.2_*.deb ./build/packages/libgvd-dev_*.deb
"

# First the groups that the guide names for python3-gvd.
bare python3-gvd "
scripts/install-deps.sh python
    make package
    sudo apt-get install ./build/packages/libgvd-c0.2_*.deb ./build/packages/python3-gvd_*.deb
$python_lines
/usr/bin/python3 /tmp/lines.py
" regions.html

# README's lines of C++, built as the guide tells, and the C interface below a prefix of its own.
bare install "
    make install PREFIX=\$HOME/gvd
{ grep '^#include' README.md
  echo 'int main() {'
  sed -n '/^\`\`\`cpp/,/^\`\`\`/{//!p}' README.md | grep -v '^#include'
  echo '}'; } > /tmp/user.cpp
{ echo 'cmake_minimum_required(VERSION 3.21)'
  echo 'project(user CXX)'
  echo 'add_executable(your_program user.cpp)'
  sed -n '/^\`\`\`cmake/,/^\`\`\`/{//!p}' docs/guide/install.md; } > /tmp/CMakeLists.txt
cmake -S /tmp -B /tmp/user -DCMAKE_PREFIX_PATH=\$HOME/gvd
cmake --build /tmp/user
/tmp/user/your_program
apt-get install pkg-config
export PKG_CONFIG_PATH=\$HOME/gvd/lib/pkgconfig LD_LIBRARY_PATH=\$HOME/gvd/lib
cc -o path_of_a_mesh examples/path_of_a_mesh.c \$(pkg-config --cflags --libs gvd_c)
./path_of_a_mesh data/figure.obj 0 100
cmake --install build --prefix /opt/gvd
touch installed && ls \$HOME/gvd/bin/gvd-segment /opt/gvd/bin/gvd-segment > installed
" installed

# All of them ask for the packages of one group; the last one asks for python3, too.
bare bench "
    make bench
    make bench BENCH_FLAGS=\"-m 5,30 --runs 3 --method exact --peers data/figure.obj\"
    make why-exact
    make bench-remesh
    make paper
" build/paper/paper.md

bare test "
    make test
"

printf '\n'
printf '%s\n' "${summary[@]}"
[ "$failures" -eq 0 ]
