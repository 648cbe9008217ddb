#!/bin/sh
# Installs the missing ones of the Debian or Ubuntu packages that a task needs.
#
#   scripts/install-deps.sh GROUP...             the groups: build test python scripts site cohort web bench pictures fuzz lint
#                                                package release ci
#   scripts/install-deps.sh --missing GROUP...   only prints the packages that are missing
#
# Does nothing, and needs no permission, if all of them are installed.
set -eu

# For programs that may not come from the distribution, whose package would then conflict.
unless_found() { command -v "$1" >/dev/null 2>&1 || echo "$2"; }

packages_of() {
  case "$1" in
    build) echo g++ cmake make ninja-build libeigen3-dev libopenmesh-dev libcgal-dev libtbb-dev nlohmann-json3-dev \
                libfmt-dev libcli11-dev libtomlplusplus-dev libpugixml-dev zlib1g-dev \
                $(unless_found node nodejs) $(unless_found npm npm) ;;
    test)  echo catch2 python3-jsonschema python3-numpy ;;
    python) echo python3 python3-numpy python3-setuptools python3-wheel python3-pip python3-venv \
                 mypy python3-mypy ;;
    scripts) echo $(unless_found python3 python3) ;;
    site)  echo mkdocs mkdocs-material doxygen ;;
    bench) echo valgrind $(packages_of scripts) ;;
    pictures) echo $(unless_found chromium chromium) ;;
    fuzz)  echo clang libclang-rt-14-dev ;;
    lint)  echo git clang-format clang-tidy clang-tools universal-ctags $(unless_found python3 python3) ;;
    package) echo dpkg-dev file gzip help2man ;;
    release) echo debootstrap git lintian pkg-config $(packages_of package) ;;
    ci)    echo git clang clang-format libclang-rt-14-dev ccache valgrind chromium firefox-esr xvfb libgl1-mesa-dri libcgal-demo universal-ctags python3-meshio python3-networkx python3-nibabel python3-vtk9 python3-tqdm lintian pkg-config zsh fish python3-yaml python3-jinja2 $(unless_found python3 python3) ;;
    cohort) echo snakemake python3-numpy $(packages_of python) ;;
    web)   echo cmake make ninja-build emscripten libeigen3-dev libfmt-dev nlohmann-json3-dev librange-v3-dev libfast-float-dev \
                $(unless_found node nodejs) $(unless_found npm npm) ;;
    *)     echo "install-deps.sh: no group '$1' (one of: build test python scripts site cohort web bench pictures fuzz lint package release ci)" >&2; exit 2 ;;
  esac
}

only_print=""
if [ "${1:-}" = --missing ]; then
  only_print=yes
  shift
fi

wanted=""
for group in "$@"; do
  wanted="$wanted $(packages_of "$group")"
done

# Without Debian's package manager, missing packages can't be determined.
if ! command -v dpkg-query >/dev/null 2>&1 || ! command -v apt-get >/dev/null 2>&1; then
  [ -z "$only_print" ] || exit 0
  echo "install-deps.sh: no Debian or Ubuntu; taking for granted what these packages hold:$wanted" >&2
  exit 0
fi

missing=""
for package in $wanted; do
  state=$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null || true)
  [ "$state" = "install ok installed" ] || missing="$missing $package"
done
if [ -n "$only_print" ]; then
  echo "${missing# }"
  exit 0
fi
[ -n "$missing" ] || exit 0

if [ "$(id -u)" -eq 0 ]; then
  as_root=""
elif command -v sudo >/dev/null 2>&1 && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
  as_root="sudo"
else
  echo "install-deps.sh: these packages are missing, and installing them needs root:$missing" >&2
  echo "install-deps.sh: run as root:  apt-get update && apt-get install$missing" >&2
  exit 1
fi

# Another program may be installing packages: apt waits for dpkg's lock, but not for that of the lists of packages.
lock_timeout=600
exec 3>&2
refresh_lists() {
  waited=0
  until errors=$($as_root apt-get -q -o Acquire::Retries=3 update 2>&1 >&3); do
    case "$errors" in
      *"Could not get lock"*) [ "$waited" -lt "$lock_timeout" ] || break ;;
      *) break ;;
    esac
    [ "$waited" -gt 0 ] || echo "install-deps.sh: waiting for another program that fetches lists of packages" >&2
    sleep 2
    waited=$((waited + 2))
  done
  [ -z "$errors" ] || echo "$errors" >&2
}

echo "Installing:$missing" >&2
echo "If another program is installing packages, this waits for it, for at most $((lock_timeout / 60)) minutes." >&2
# A mirror may fail temporarily: three attempts, each with a fresh list of packages.
for try in 1 2 3; do
  refresh_lists
  if $as_root env DEBIAN_FRONTEND=noninteractive \
       apt-get -q -y -o Acquire::Retries=3 -o DPkg::Lock::Timeout="$lock_timeout" \
       install --no-install-recommends $missing </dev/null >&2; then
    exit 0
  fi
  echo "install-deps.sh: try $try of 3 failed" >&2
  sleep $((try * 5))
done
echo "install-deps.sh: could not install:$missing" >&2
exit 1
