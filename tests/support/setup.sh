# shellcheck shell=bash disable=SC2034  # the lists are for those who source this
# What experiments/demo and tests/all share: the packages, the build, and plain words about each step.
# Sourced, never run; defines names only. Every step's output goes to build/log; a step that fails shows the end of its
# log, says where the rest is, and ends the script.

top=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
logs=$top/build/log

# The systems that all of this is tested on. README.md and `rocking doctor` name the same.
supported_systems=("Debian 12" "Debian 13" "Ubuntu 24.04")

# Everything that comes from the system, by names that are the same on all of these. Boost differs: see boost_packages.
build_packages=(
  g++ cmake make pkg-config git
  nlohmann-json3-dev libfmt-dev libcli11-dev librandom123-dev libvalijson-dev libssl-dev libsqlite3-dev
  libgtest-dev libgmock-dev
  gnuplot-nox  # draws the figures
  python3  # writes reports/jeong_yang_2012 from its results
  libjs-dygraphs  # charts of report.html
)
# The packages of Boost by preference; the first that the system offers in a version that will do is installed. Debian 12
# has 1.74 as libboost-dev, and 1.81 beside it, which the published intervals were computed with. Later systems have 1.83 or
# newer as libboost-dev.
boost_packages=(libboost1.81-dev libboost-dev)
oldest_boost=107400  # 1.74, as BOOST_VERSION writes it
# For `tests/all --full`. What needs one that the system does not offer is skipped by name.
full_packages=(
  clang libbenchmark-dev
  valgrind  # for a profile
  libsundials-dev  # for one test and a benchmark; brings MPI, PETSc and a Fortran compiler
  python3-pandas r-base-core octave  # to load results as lib/docs/loading.md says
  libopenmpi-dev openmpi-bin iproute2  # for rocking-mpi, and its test between two hosts
  slurm-wlm munge  # for a cluster of one machine
  g++-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user  # to compare bits with another processor's
)

say() { printf '%s\n' "$*"; }

fail() {
  printf '%s: %s\n' "$0" "$*" >&2
  exit 1
}

# start_in_clone: goes to the clone's root and finds out as whom to work there. Root (or sudo) works as the clone's owner
# where it can, so that no file of root's is left in a user's clone.
start_in_clone() {
  cd -- "$top" || exit
  drop_root=()
  local uid gid home
  uid=$(stat -c %u .) gid=$(stat -c %g .)
  if ((EUID == 0 && uid != 0)); then
    home=$(getent passwd "$uid" | cut -d: -f6) || true
    drop_root=(setpriv --reuid "$uid" --regid "$gid" --clear-groups env "HOME=${home:-/tmp}")
    if ! "${drop_root[@]}" test -w "$top" 2>/dev/null; then
      say "   (the clone's owner, user $uid, cannot work in $top: going on as root)"
      drop_root=()
    fi
  fi
  if ! as_owner mkdir -p "$logs" || ! as_owner test -w build || ! as_owner test -w "$logs"; then
    fail "cannot write in $top/build; give it to the clone's owner, or remove it"
  fi
}

# as_owner COMMAND...
as_owner() { ${drop_root[@]+"${drop_root[@]}"} "$@"; }

# step NAME WORDS COMMAND...: the command's output goes to build/log/NAME.log.
step() {
  local name=$1 words=$2 began=$SECONDS
  shift 2
  printf -- '-- %s ... ' "$words"
  as_owner touch "$logs/$name.log"
  if "$@" >"$logs/$name.log" 2>&1; then
    say "done in $((SECONDS - began)) s"
    return
  fi
  say "failed after $((SECONDS - began)) s; the end of what it said:"
  tail -n 30 "$logs/$name.log" >&2
  fail "step '$words' failed; its whole output is in $logs/$name.log"
}

# boost_version_below FOLDER: prints BOOST_VERSION of the headers there, if they will do (1.74 or later, with Boost.Math).
boost_version_below() {
  local version
  [[ -r $1/boost/version.hpp && -r $1/boost/math/distributions/beta.hpp ]] || return 1
  version=$(sed -n 's/^#define BOOST_VERSION \([0-9]*\).*/\1/p' "$1/boost/version.hpp")
  [[ -n $version ]] && ((version >= oldest_boost)) && printf '%s\n' "$version"
}

# has_boost FOLDER...: whether one of the folders holds a Boost that will do. Debian's Boost packages exclude each other, so
# none is ever installed beside one that is there.
has_boost() {
  local folder
  for folder in "$@"; do
    if boost_version_below "$folder" >/dev/null; then return; fi
  done
  return 1
}

# candidate_of PACKAGE: prints the version that apt-get would install; fails where the system does not offer the package.
candidate_of() {
  local version
  version=$(LC_ALL=C apt-cache policy "$1" 2>/dev/null | sed -n 's/^  Candidate: //p')
  [[ -n $version && $version != '(none)' ]] && printf '%s\n' "$version"
}

# boost_package: prints the package to install for Boost; fails where the system offers none that will do.
boost_package() {
  local package version
  for package in "${boost_packages[@]}"; do
    version=$(candidate_of "$package") || continue
    [[ $version =~ ^([0-9]+)\.([0-9]+) ]] || continue
    if ((BASH_REMATCH[1] * 100000 + BASH_REMATCH[2] * 100 >= oldest_boost)); then
      printf '%s\n' "$package"
      return
    fi
  done
  return 1
}

# offered PACKAGE...: prints those that the system offers.
offered() {
  local package
  for package in "$@"; do
    if candidate_of "$package" >/dev/null; then printf '%s\n' "$package"; fi
  done
}

# missing_of PACKAGE...: prints those that are not installed.
missing_of() {
  local package
  for package in "$@"; do
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || printf '%s\n' "$package"
  done
}

# missing_browser: prints what the tests of report.html in a browser lack. Looks for the programs, since node and npm often
# come from elsewhere, and Debian's exclude those.
missing_browser() {
  if ! command -v node >/dev/null || ! command -v npm >/dev/null; then printf '%s\n' nodejs npm; fi
  command -v chromium >/dev/null || printf '%s\n' chromium
}

# choose_packages: writes to the array `missing` what is to be installed of `required`, `optional` and, if `boost` is not
# empty, of Boost's packages; says which optional ones the system does not offer.
choose_packages() {
  local package
  mapfile -t missing < <(missing_of "${optional[@]}")
  mapfile -t optional < <(offered "${missing[@]}")
  for package in "${missing[@]}"; do
    [[ " ${optional[*]} " == *" $package "* ]] || say "-- $package: not offered here; the tests that need it are skipped by name"
  done
  mapfile -t missing < <(missing_of "${required[@]}")
  missing+=("${optional[@]}")
  if [[ $boost ]]; then
    package=$(boost_package) ||
      fail "this system offers no Boost 1.74 or later (looked for: ${boost_packages[*]}). Supported: $(list_of_systems)"
    missing+=("$package")
  fi
}

# list_of_systems: prints the supported systems as a sentence has them.
list_of_systems() {
  local list
  list=$(printf '%s, ' "${supported_systems[@]}")
  printf '%s\n' "${list%, }"
}

# install_missing REQUIRED... [-- OPTIONAL...]: installs what is not there of these packages and of Boost. Optional packages
# that the system does not offer are left out. Touches nothing where all is there.
install_missing() {
  local required=() optional=() missing=() boost=
  while (($#)) && [[ $1 != -- ]]; do required+=("$1"); shift; done
  optional=("${@:2}")
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    say "-- no apt-get here: going on with what is installed. Needed, by Debian's names: ${required[*]} ${optional[*]} libboost-dev"
    return
  fi
  has_boost /usr/local/include /usr/include || boost=missing
  mapfile -t missing < <(missing_of "${required[@]}" "${optional[@]}")
  if ((${#missing[@]} == 0)) && [[ ! $boost ]]; then
    say "-- packages: all there"
    return
  fi
  local as_root=()
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      choose_packages
      ((${#missing[@]} == 0)) ||
        fail "not installed: ${missing[*]}. As root: apt-get install --no-install-recommends ${missing[*]}"
      return
    fi
    as_root=(sudo)
    say "-- sudo is asked to install packages; it may want your password"
  fi
  local apt=(${as_root[@]+"${as_root[@]}"} env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300)
  step package-lists "reading the package lists" "${apt[@]}" update
  choose_packages
  if ((${#missing[@]} == 0)); then return; fi
  # --no-remove: rather fail than take something away from the machine.
  step packages "installing ${missing[*]}" "${apt[@]}" install -y --no-install-recommends --no-remove "${missing[@]}"
}

# architecture: the instruction set to build for. An older processor gets the same results, slower.
architecture() {
  if [[ $(uname -m) == x86_64 ]] && ! grep -qw avx2 /proc/cpuinfo; then say x86-64; else say x86-64-v3; fi
}

# compiler_launcher: ccache, where it is there and can write its cache.
compiler_launcher() {
  local cache
  if cache=$(as_owner ccache --get-config cache_dir 2>/dev/null) && as_owner mkdir -p "$cache" 2>/dev/null &&
    as_owner test -w "$cache"; then
    say ccache
  fi
}

# build FOLDER PRESET TARGET [CMAKE OPTION...]: configures and builds in build/FOLDER. Warnings are errors. The compiler of a
# folder that is configured already stays: to name another makes CMake forget the preset, optimisation and all.
build() {
  local folder=$1 preset=$2 target=$3
  shift 3
  step "configure-$folder" "configuring build/$folder" as_owner env CXX=g++ cmake --preset "$preset" -B "build/$folder" \
    -DCMAKE_COMPILE_WARNING_AS_ERROR=ON "-DROCKING_ARCHITECTURE=$(architecture)" \
    "-DCMAKE_CXX_COMPILER_LAUNCHER=$(compiler_launcher)" "$@"
  step "build-$folder" "building build/$folder on $(nproc) cores" \
    as_owner cmake --build "build/$folder" --target "$target" -j "$(nproc)"
}
