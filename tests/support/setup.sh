# shellcheck shell=bash disable=SC2034  # the lists are for scripts that source this
# Functions shared by experiments/demo and tests/all: packages, build, and a message for each step. To be sourced, not run;
# it only defines names. The output of every step is written to build/log. A step that fails shows the end of its log, says
# where the rest is, and ends the script.

top=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
logs=$top/build/log

# The systems on which all of this is tested. README.md and `rocking doctor` name the same.
supported_systems=("Debian 12" "Debian 13" "Ubuntu 24.04")

# Packages of the system whose names are the same on all of these systems. Boost differs: see boost_packages.
build_packages=(
  g++ cmake make pkg-config git
  nlohmann-json3-dev libfmt-dev libcli11-dev librandom123-dev libssl-dev libsqlite3-dev libpugixml-dev libzip-dev libeigen3-dev
  libgtest-dev libgmock-dev
  gnuplot-nox  # draws the figures
  weasyprint  # makes PDF of sheets
  python3  # writes reports/jeong_yang_2012 from its results
  libjs-dygraphs  # charts of report.html
)
# The packages of Boost in order of preference; the first one that the system offers in a sufficient version is installed.
# Debian 12 has 1.74 as libboost-dev and 1.81 beside it, with which the published intervals were computed. Later systems
# have 1.83 or newer as libboost-dev.
boost_packages=(libboost1.81-dev libboost-dev)
oldest_boost=107400  # 1.74, as BOOST_VERSION writes it
# For the Python module, which scripts of experiments/ use.
python_packages=(pybind11-dev python3-dev python3-numpy)
# For `tests/all`. Tests that need a package which the system does not offer are skipped with a message.
test_packages=(
  clang libclang-rt-14-dev clang-format libvalijson-dev
  "${python_packages[@]}"
  libopenmpi-dev openmpi-bin  # for rocking-mpi
  python3-matplotlib jq sqlite3  # for tutorials
  mypy  # to check the types of the Python module
)
# For `tests/all --release`, too.
release_packages=(
  libbenchmark-dev
  valgrind  # for a profile
  libsundials-dev  # for one test and a benchmark; installs PETSc and a Fortran compiler too
  python3-pip python3-setuptools python3-wheel  # to install it with pip
  doxygen python3-sphinx python3-myst-parser python3-breathe  # for the site of documents
  dpkg-dev file groff-base  # for the package of the system, and to check the manual pages
  python3-pandas r-base-core octave  # to load results as in lib/docs/loading.md
  iproute2  # for the test of rocking-mpi between two hosts
  slurm-wlm munge  # for a cluster of one machine
  clang-19 lld-19 wasi-libc libc++-19-dev-wasm32 libclang-rt-19-dev-wasm32  # for live.html
  g++-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user  # to compare bits with those of another processor
)

say() { printf '%s\n' "$*"; }

fail() {
  printf '%s: %s\n' "$0" "$*" >&2
  exit 1
}

# start_in_clone: changes to the root of the clone and determines the user for the work there. Root (or sudo) works as the
# owner of the clone if possible, so that no file of root is left in a user's clone.
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

# note_step WORDS BEGAN: adds a row to build/log/steps, from which tests/support/record_of_tests makes a table.
note_step() { say "| $1 | $((SECONDS - $2)) | done |" | as_owner tee -a "$logs/steps" >/dev/null; }

# step NAME WORDS COMMAND...: writes the output of the command to build/log/NAME.log.
step() {
  local name=$1 words=$2 began=$SECONDS
  shift 2
  printf -- '-- %s ... ' "$words"
  as_owner touch "$logs/$name.log"
  if "$@" >"$logs/$name.log" 2>&1; then
    say "done in $((SECONDS - began)) s"
    note_step "$words" "$began"
    return
  fi
  say "failed after $((SECONDS - began)) s; the end of what it said:"
  tail -n 30 "$logs/$name.log" >&2
  fail "step '$words' failed; its whole output is in $logs/$name.log"
}

# boost_version_below FOLDER: prints BOOST_VERSION of the headers there, if they suffice (1.74 or later, with Boost.Math).
boost_version_below() {
  local version
  [[ -r $1/boost/version.hpp && -r $1/boost/math/distributions/beta.hpp ]] || return 1
  version=$(sed -n 's/^#define BOOST_VERSION \([0-9]*\).*/\1/p' "$1/boost/version.hpp")
  [[ -n $version ]] && ((version >= oldest_boost)) && printf '%s\n' "$version"
}

# has_boost FOLDER...: whether one of the folders has a sufficient Boost. The Boost packages of Debian conflict with each
# other; therefore none is installed if there is one.
has_boost() {
  local folder
  for folder in "$@"; do
    if boost_version_below "$folder" >/dev/null; then return; fi
  done
  return 1
}

# candidate_of PACKAGE: prints the version that apt-get would install; fails if the system does not offer the package.
candidate_of() {
  local version
  version=$(LC_ALL=C apt-cache policy "$1" 2>/dev/null | sed -n 's/^  Candidate: //p')
  [[ -n $version && $version != '(none)' ]] && printf '%s\n' "$version"
}

# boost_package: prints the package to install for Boost; fails if the system offers no sufficient one.
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

# offered PACKAGE...: prints the packages that the system offers.
offered() {
  local package
  for package in "$@"; do
    if candidate_of "$package" >/dev/null; then printf '%s\n' "$package"; fi
  done
}

# missing_of PACKAGE...: prints the packages that are not installed.
missing_of() {
  local package
  for package in "$@"; do
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || printf '%s\n' "$package"
  done
}

# missing_browser: prints the packages that the browser tests of report.html lack. It looks for the programs, since node and
# npm are often installed from other sources, with which those of Debian conflict.
missing_browser() {
  if ! command -v node >/dev/null || ! command -v npm >/dev/null; then printf '%s\n' nodejs npm; fi
  command -v chromium >/dev/null || printf '%s\n' chromium
}

# choose_packages: writes to the array `missing` the packages to be installed of `required`, `optional` and, if `boost` is
# not empty, of Boost. Prints which optional ones the system does not offer.
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

# list_of_systems: prints the supported systems as part of a sentence.
list_of_systems() {
  local list
  list=$(printf '%s, ' "${supported_systems[@]}")
  printf '%s\n' "${list%, }"
}

# install_missing REQUIRED... [-- OPTIONAL...]: installs those of these packages and of Boost that are missing. Optional
# packages that the system does not offer are omitted. Does nothing if nothing is missing.
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
  # --no-remove: fail rather than remove a package from the machine.
  step packages "installing ${missing[*]}" "${apt[@]}" install -y --no-install-recommends --no-remove "${missing[@]}"
}

# architecture: the instruction set to build for. An older processor gives the same results, more slowly.
architecture() {
  if [[ $(uname -m) == x86_64 ]] && ! grep -qw avx2 /proc/cpuinfo; then say x86-64; else say x86-64-v3; fi
}

# compiler_launcher: ccache, if it is installed and can write its cache.
compiler_launcher() {
  local cache
  if cache=$(as_owner ccache --get-config cache_dir 2>/dev/null) && as_owner mkdir -p "$cache" 2>/dev/null &&
    as_owner test -w "$cache"; then
    say ccache
  fi
}

# build FOLDER PRESET TARGET [CMAKE OPTION...]: configures and builds in build/FOLDER. Warnings are errors. If the folder is
# already configured, its compiler is kept: naming another one makes CMake forget the preset, including the optimisation.
build() {
  local folder=$1 preset=$2 target=$3
  shift 3
  step "configure-$folder" "configuring build/$folder" as_owner env CXX=g++ cmake --preset "$preset" -B "build/$folder" \
    -DCMAKE_COMPILE_WARNING_AS_ERROR=ON "-DROCKING_ARCHITECTURE=$(architecture)" \
    "-DCMAKE_CXX_COMPILER_LAUNCHER=$(compiler_launcher)" "$@"
  step "build-$folder" "building build/$folder on $(nproc) cores" \
    as_owner cmake --build "build/$folder" --target "$target" -j "$(nproc)"
}

# check_format: names the sources that clang-format would change. Other versions than that of Debian 12 format differently.
check_format() {
  if ! clang-format --version 2>/dev/null | grep -q 'version 14\.'; then
    say "skipped: clang-format 14 was not found (Debian 12: clang-format)"
    return
  fi
  git ls-files '*.cpp' '*.hpp' | xargs clang-format --dry-run --Werror
}
