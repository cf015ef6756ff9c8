# SPDX-License-Identifier: MIT
# What Leonhard needs from Debian 12, and how to install what is missing and to build. Sourced by ./leonhard, tests/run,
# fuzz/run and .ci/run; changes nothing by itself. All it says goes to stderr.

packages_release="g++ cmake ninja-build pkg-config libboost-dev libgmp-dev libtbb-dev libpetsc-real-dev \
libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libfmt-dev libmuparser-dev libcairo2-dev zlib1g-dev liblz4-dev liblzma-dev fonts-dejavu-core"
packages_tests="$packages_release doctest-dev"
packages_fuzz="g++ cmake ninja-build pkg-config libboost-dev libgmp-dev libtbb-dev zlib1g-dev liblz4-dev liblzma-dev clang libclang-rt-14-dev"
packages_kernel_tests="g++ cmake ninja-build pkg-config libboost-dev libgmp-dev doctest-dev"
packages_bench="$packages_release libbenchmark-dev"
packages_compare="g++ cmake ninja-build pkg-config libboost-dev libgmp-dev libtbb-dev zlib1g-dev libfmt-dev \
libcgal-dev libtet1.5-dev libmpfr-dev libmetis-dev libscotch-dev"

# missing_packages NAME...: those that are not installed.
missing_packages() {
  local name
  for name in "$@"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null)" = installed ] || printf '%s ' "$name"
  done
}

# in_words SECONDS: "40 s", "3 min 20 s".
in_words() {
  if [ "$1" -lt 60 ]; then printf '%d s' "$1"; else printf '%d min %02d s' $(($1 / 60)) $(($1 % 60)); fi
}

# show_progress WORDS [LOG]: reads the output of apt-get or ninja (with NINJA_STATUS='[%f %t] ') and says within ten
# seconds, on a terminal every second in the same place, how far it is, also while nothing comes. Where there is a log the
# lines go there; of others those of a step that failed are shown.
show_progress() {
  local words=$1 log=${2:-} start=$SECONDS told=$SECONDS every=9 clear="" width=0
  local line="" part state="" finished=0 total=0 due=0 failed="" said
  if [ -t 2 ]; then every=1 clear=$'\r\033[K' width=$(tput cols 2>/dev/null || echo 80); fi
  while :; do
    if IFS= read -r -t 1 part; then
      line+=$part
      if [[ $line =~ ^\[([0-9]+)\ ([0-9]+)\]\  ]]; then  # ninja's: finished, total
        finished=${BASH_REMATCH[1]} total=${BASH_REMATCH[2]} failed=""
        if [ "$finished" -gt 0 ]; then due=$((SECONDS + (SECONDS - start) * (total - finished) / finished)); fi
      elif [ -n "$log" ]; then
        printf '%s\n' "$line" >>"$log"
        case $line in Get:* | Unpacking* | "Setting up"*) state=${line%% (*} ;; esac
      else
        if [[ $line =~ ^(FAILED:|ninja:\ error|ninja:\ build|CMake\ Error) ]]; then failed=1; fi
        if [ -n "$failed" ]; then printf '%s%s\n' "$clear" "$line" >&2; fi
      fi
      line=""
    elif [ $? -gt 128 ]; then  # nothing more came for a second
      line+=$part
    else
      break
    fi
    [ $((SECONDS - told)) -ge $every ] || continue
    told=$SECONDS
    if [ "$finished" -gt 0 ]; then
      state="$finished of $total files, about $(in_words $((due > SECONDS ? due - SECONDS : 1))) left"
    fi
    said="leonhard: $words: ${state:-$(in_words $((SECONDS - start))) so far}"
    if [ -n "$clear" ]; then printf '%s%s' "$clear" "${said:0:width-1}" >&2; else printf '%s\n' "$said" >&2; fi
  done
  printf '%s' "$clear" >&2
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
  echo "leonhard: installing what is missing with ${as_root:+$as_root }apt-get (once; one to three minutes): $missing" >&2
  local log status=0
  log=$(mktemp)
  {
    $as_root apt-get update -q &&
      $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing
  } 2>&1 | show_progress apt-get "$log" || true
  [ -n "$(missing_packages $missing)" ] && status=1
  if [ $status -ne 0 ]; then
    tail -n 20 "$log" >&2
    echo "leonhard: apt-get could not install: $(missing_packages $missing)" >&2
  fi
  rm -f "$log"
  return $status
}

# How long all of a preset takes to compile, in seconds of one core; nothing where it is not known.
core_seconds_of() {
  case $1 in
    release) echo 690 ;;
    dev) echo 1100 ;;
    asan) echo 2000 ;;
  esac
}

# build_preset PRESET [TARGET...]: configure once, then build; silent unless something is built or fails.
build_preset() {
  local preset=$1 log seconds
  shift
  if [ ! -f "build/$preset/build.ninja" ]; then
    seconds=$(core_seconds_of "$preset")
    echo "leonhard: the first time in this folder: configuring and compiling into build/$preset${seconds:+, about $(in_words $((seconds / $(nproc)))) on $(nproc) cores}" >&2
    log=$(mktemp)
    (set -o pipefail; cmake --preset "$preset" 2>&1 | show_progress "configuring build/$preset" "$log") ||
      { cat "$log" >&2; rm -f "$log"; return 1; }
    rm -f "$log"
  fi
  # Only speak when there is work: "no work to do" is the usual answer.
  if ninja -C "build/$preset" -n "$@" 2>/dev/null | grep -q 'no work to do'; then return 0; fi
  (
    set -o pipefail
    NINJA_STATUS='[%f %t] ' ninja -C "build/$preset" "$@" 2>&1 | show_progress "building build/$preset"
  )
}
