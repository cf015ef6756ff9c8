# SPDX-License-Identifier: MIT
# What Leonhard needs from Debian 12, and how to install what is missing. Sourced by ./leonhard, tests/run,
# fuzz/run and .ci/run; changes nothing by itself.

packages_release="g++ cmake ninja-build pkg-config libboost-dev libgmp-dev libtbb-dev libpetsc-real-dev \
libeigen3-dev libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libfmt-dev libcairo2-dev zlib1g-dev fonts-dejavu-core"
packages_tests="$packages_release doctest-dev"
packages_fuzz="g++ cmake ninja-build pkg-config libboost-dev libgmp-dev libtbb-dev zlib1g-dev libeigen3-dev clang libclang-rt-14-dev"
packages_kernel_tests="g++ cmake ninja-build pkg-config libboost-dev libgmp-dev doctest-dev"
packages_bench="$packages_release libbenchmark-dev"
packages_compare="g++ cmake ninja-build pkg-config libboost-dev libgmp-dev libtbb-dev zlib1g-dev libeigen3-dev libfmt-dev \
libcgal-dev libtet1.5-dev libmpfr-dev libmetis-dev"

# missing_packages NAME...: those that are not installed.
missing_packages() {
  local name
  for name in "$@"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null)" = installed ] || printf '%s ' "$name"
  done
}

# ensure_packages NAME...: install what is missing with apt, as root or through sudo, saying so on stderr.
ensure_packages() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    command -v cmake >/dev/null && command -v ninja >/dev/null && return 0
    echo "leonhard: this system has no apt. Install the equivalents of these Debian packages and run again:" >&2
    echo "  $*" >&2
    return 1
  fi
  local missing as_root=""
  missing=$(missing_packages "$@")
  [ -z "$missing" ] && return 0
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "leonhard: these packages are missing, and there is neither root nor sudo to install them:" >&2
      echo "  apt-get install $missing" >&2
      return 1
    fi
    as_root=sudo
  fi
  echo "leonhard: installing with ${as_root:+$as_root }apt-get: $missing" >&2
  $as_root apt-get update -qq >&2 &&
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null || {
    echo "leonhard: apt-get could not install: $missing" >&2
    return 1
  }
}

# build_preset PRESET [TARGET...]: configure once, then build; silent unless something is built or fails.
build_preset() {
  local preset=$1 log
  shift
  if [ ! -f "build/$preset/build.ninja" ]; then
    echo "leonhard: configuring build/$preset" >&2
    log=$(cmake --preset "$preset" 2>&1) || { printf '%s\n' "$log" >&2; return 1; }
  fi
  # Only speak when there is work: "no work to do" is the usual answer.
  if ninja -C "build/$preset" -n "$@" 2>/dev/null | grep -q 'no work to do'; then return 0; fi
  if [ -t 2 ]; then
    echo "leonhard: building build/$preset (a few minutes the first time)" >&2
    ninja -C "build/$preset" "$@" >&2
  else
    echo "leonhard: building build/$preset" >&2
    log=$(ninja -C "build/$preset" "$@" 2>&1) || { printf '%s\n' "$log" | tail -n 60 >&2; return 1; }
  fi
}
