#!/usr/bin/env bash
# Looks at the Debian packages that `make package` made, and runs them where nothing else is.
#
#   check_packages.sh BUILD_FOLDER [STEP...]     the steps are the functions below; without a STEP all of them
#
# A clean root holds the package and exactly the packages that its Depends name, by apt's own choice, but no package that Debian
# takes for granted. So a command that needs anything else does not start there. The development packages are not installed: their
# closure has 900 MB. Instead each file that a build with them reads must belong to a package of that closure.
# Needs Debian or Ubuntu, lintian, network, and root or user namespaces.
set -euo pipefail
export LC_ALL=C.UTF-8
build=$(realpath "$1")
triplet=$(dpkg-architecture -qDEB_HOST_MULTIARCH)
source=$(realpath "$(dirname "$0")/../..")
work=$build/packages-test
packages=$build/packages
mesh=$source/data/torus.ply

fail() { echo "check_packages: $*" >&2; exit 1; }

# apt that believes no package is installed, and keeps what it downloads.
clean_apt() {
  apt-get -q -y --no-install-recommends -o Debug::NoLocking=1 -o Dir::State::status="$work/no-packages" \
    -o Dir::State::extended_states="$work/extended-states" -o Dir::Cache="$work/apt" -o APT::Sandbox::User=root "$@"
}

# closure_of OPTION PACKAGE...: the packages that apt installs for them, as NAME VERSION. With --download-only it fetches them.
closure_of() {
  clean_apt --verbose-versions "$1" install "${@:2}" 2>"$work/apt.log" > "$work/apt.out" || { cat "$work/apt.log" >&2; return 1; }
  sed -n '/^The following NEW packages/,/^[^ ]* upgraded/s/^   \([^ ]*\) (\([^ )]*\).*/\1 \2/p' "$work/apt.out"
}

# make_root FOLDER PACKAGE.deb...: the packages and their closure, unpacked, without any script run.
make_root() {
  local folder=$1 package own="" name version
  shift
  rm -rf "$folder"
  mkdir -p "$folder"
  for package in "$@"; do
    dpkg-deb -x "$package" "$folder"
    own="$own $(dpkg-deb -f "$package" Package) "
  done
  closure_of --download-only "$@" > "$work/closure"
  while read -r name version; do
    [[ $own == *" $name "* ]] || dpkg-deb -x "$work/apt/archives/${name}_${version//:/%3a}"_*.deb "$folder"
  done < "$work/closure"
  cp "$mesh" "$folder/mesh.ply"
}

# run_in FOLDER WORD... No script has made the links to NumPy's libblas and liblapack, so their folders are named.
run_in() {
  local folder=$1 as_root=()
  shift
  [ "$(id -u)" -eq 0 ] || as_root=(unshare --map-root-user)
  env -i PATH=/usr/bin:/usr/sbin LD_LIBRARY_PATH="/usr/lib/$triplet/blas:/usr/lib/$triplet/lapack" \
    "${as_root[@]}" chroot "$folder" "$@"
}

check_lintian() {
  lintian --fail-on error,warning "$packages"/*.deb
  for page in $(dpkg-deb -c "$packages"/gvd_*.deb | grep -o '[^/]*\.1\.gz'); do
    man=$(dpkg-deb --fsys-tarfile "$packages"/gvd_*.deb | tar -xO "./usr/share/man/man1/$page" | gzip -d | sed 's/\\-/-/g')
    for option in $("$build/bin/${page%.1.gz}" --help | grep -o -e '^  \(-[a-z], \)\?--[a-z-]*' | grep -o -e '--.*'); do
      grep -q -F -e "$option" <<< "$man" || fail "$page does not tell of $option"
    done
  done
}

# Each command writes in the clean root what it writes here.
check_commands() {
  local command words only_there
  make_root "$work/root" "$packages"/gvd_*.deb
  [ "$(cd "$work/root/usr/bin" && find gvd gvd-* -type f)" = gvd ] || fail "the commands are more than one binary"
  run_in "$work/root" gvd --help | diff - <("$build/bin/gvd" --help)
  for command in $(cd "$work/root/usr/bin" && ls gvd-*); do
    words=(-n 20 -o "$command.obj" --diagram "$command.json") only_there=(--verify --view "$command.html")
    if [ "$command" = gvd-distance ]; then
      words=(--from 0,7 --isolines 0.1 -o "$command.obj" -o "$command.json") only_there=(--view "$command.html")
    fi
    run_in "$work/root" "$command" -q mesh.ply "${words[@]}" "${only_there[@]}"
    (cd "$work" && "$build/bin/$command" -q "$mesh" "${words[@]}")
    cmp "$work/$command.obj" "$work/root/$command.obj"
    cmp "$work/$command.json" "$work/root/$command.json"
    [ -s "$work/root/$command.html" ] || fail "$command wrote no page"
  done
}

# The same without one library: no command may start, or this test could not find a missing dependency. The libraries of the
# compiler are left out, because the other ones depend on them.
check_that_it_fails() {
  local poor=$work/poor library
  rm -rf "$poor"
  dpkg-deb -R "$packages"/gvd_*.deb "$poor"
  cp "$poor/DEBIAN/control" "$work/control"
  for library in $(sed -n 's/^Depends: //p' "$work/control" | tr ',' '\n' | sed 's/^ *//; s/ .*//'); do
    [[ $library =~ ^lib(c6|gcc|stdc) ]] && continue
    sed "/^Depends:/s/ $library [^,]*,\?//; /^Depends:/s/, *\$//" "$work/control" > "$poor/DEBIAN/control"
    dpkg-deb -Znone -b "$poor" "$poor.deb" >/dev/null
    make_root "$work/poor-root" "$poor.deb"
    if run_in "$work/poor-root" gvd-remesh --version 2>/dev/null; then fail "the commands run without $library"; fi
    echo "without $library no command starts, as it should be"
  done
}

# Builds a project with the development packages, and looks for the owner of each file that the compiler and the linker read.
check_development() {
  local root=$work/dev-root own=("$packages"/libgvd-*.deb) package strangers
  rm -rf "$root" "$work/consumer"
  mkdir -p "$root"
  for package in "${own[@]}"; do dpkg-deb -x "$package" "$root"; done
  cmake -S "$source/tests/consumer" -B "$work/consumer" -G "Unix Makefiles" -DCMAKE_PREFIX_PATH="$root/usr" \
    -DPARTS=segment,lloyd,remesh"$([ ! -e "$packages"/libgvd-verify-dev_*.deb ] || echo ,verify)" -DCMAKE_CXX_COMPILER=g++ \
    -DCMAKE_EXE_LINKER_FLAGS=-Wl,--trace >/dev/null
  cmake --build "$work/consumer" > "$work/consumer/log"
  "$work/consumer/consumer" >/dev/null
  # Debian moves files from / to /usr, but packages still name the old place: paths are compared without /usr.
  { find "$work/consumer" -name '*.o.d' -exec cat {} + | tr ' \\' '\n'
    cat "$work/consumer/log"
    sed -n 's/.*_DIR:PATH=\(.*cmake.*\)/\1/p' "$work/consumer/CMakeCache.txt"; } |
    grep '^/' | xargs realpath -s | grep -v -e "^$build" -e "^$source" | sed 's|^/usr/|/|' | sort -u > "$work/read"
  { cat "$work/read"; sed 's|^|/usr|' "$work/read"; } | { xargs dpkg -S 2>/dev/null || true; } | sed 's|: /usr/|: /|' > "$work/owned"
  [ -s "$work/owned" ] || fail "no file belongs to a package"
  strangers=$(comm -23 "$work/read" <(sed 's/.*: //' "$work/owned" | sort -u))
  [ -z "$strangers" ] || fail "no package has $strangers"
  closure_of --simulate "${own[@]}" g++ cmake | cut -d ' ' -f 1 | sort > "$work/closure"
  sed 's/:.*//' "$work/owned" | sort -u > "$work/owners"
  strangers=$(comm -23 "$work/owners" "$work/closure" | tr '\n' ' ')
  [ -z "$strangers" ] || fail "the development packages do not depend on $strangers"
  echo "a build with the development packages reads $(wc -l < "$work/read") files of $(wc -l < "$work/owners") packages"
}

# The installed example, built by gvd_c.pc of the unpacked packages, runs with the C library's package alone. That of the headers
# depends on it: it has the link that programs are linked by.
check_c_library() {
  local flags program=$work/c-root/path_of_a_mesh name
  name=$(dpkg-deb -f "$packages"/libgvd-c*.deb Package)
  dpkg-deb -f "$packages"/libgvd-dev_*.deb Depends | grep -q -F "$name (= " || fail "libgvd-dev does not depend on $name"
  flags=$(PKG_CONFIG_PATH=$work/dev-root/usr/lib/$triplet/pkgconfig pkg-config --cflags --libs gvd_c)
  make_root "$work/c-root" "$packages"/libgvd-c*.deb
  # shellcheck disable=SC2086 # flags are words
  cc -o "$program" "$work/dev-root/usr/share/doc/gvd/examples/path_of_a_mesh.c" $flags
  run_in "$work/c-root" /path_of_a_mesh mesh.ply 0 5 > "$work/path"
  grep -q '^length [0-9.]*$' "$work/path" || fail "the example in C printed no length"
}

# The Python package imports its own files and Debian's NumPy, and writes there what gvd-segment writes. Without NumPy it does not.
check_python() {
  local use="import gvd; gvd.read('mesh.ply').segment(20).to_file('python.obj'); print(gvd.__file__)" root=$work/python-root
  if ! grep -q '^GVD_BUILD_PYTHON:BOOL=ON' "$build/CMakeCache.txt"; then
    echo "no Python package is built (GVD_BUILD_PYTHON=OFF)"
    return
  fi
  make_root "$root" "$packages"/python3-gvd_*.deb "$packages"/libgvd-c*.deb
  run_in "$root" python3 -B -c "$use" | grep -q -x /usr/lib/python3/dist-packages/gvd/__init__.py || fail "python3 finds no gvd"
  diff <(grep -v mtllib "$work/gvd-segment.obj") <(grep -v mtllib "$root/python.obj") || fail "gvd.segment differs from gvd-segment"
  rm -r "$root/usr/lib/python3/dist-packages/numpy"
  if run_in "$root" python3 -B -c "$use" 2>/dev/null; then fail "the Python package runs without NumPy"; fi
}

mkdir -p "$work/apt/archives/partial"
: > "$work/no-packages"
# The lists of packages may be missing or old.
closure_of --download-only libc6 >/dev/null 2>&1 || apt-get -q update
steps=("${@:2}")
[ ${#steps[@]} -gt 0 ] || steps=(check_lintian check_commands check_that_it_fails check_development check_c_library check_python)
for step in "${steps[@]}"; do
  started=$(date +%s%N)
  $step
  echo "$step: $((($(date +%s%N) - started) / 1000000)) ms"
done
