#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs a build tree and uses it as outsiders do: the programs of jobs/ and the documentation's examples, through find_package
# with warnings as errors, and again through pkg-config.
#   run.sh BUILD FOLDER COMPILER [LINK_FLAGS]   installs BUILD under FOLDER and uses it with COMPILER
#   run.sh --all FOLDER                         builds the library four times, by gcc and clang, static and shared, and once from
#                                               C++20, Boost and GMP alone, with each public header alone; takes long.
#                                               LAUNCHER=ccache and JOBS are heeded.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
source=$(cd "$here/../.." && pwd)

# check_installed PREFIX FOLDER COMPILER LINK_FLAGS
check_installed() {
  local prefix=$1 folder=$2 compiler=$3 link_flags=$4 component missing="" log libraries
  local flags="-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Werror"
  libraries=$(dirname "$(find "$prefix" -path '*/cmake/leonhard/leonhardConfig.cmake')")/../..
  for component in draw solver graph_metis graph_scotch; do
    [ -f "$libraries/cmake/leonhard/leonhard-$component.cmake" ] || missing="$missing;$component"
  done
  rm -rf "$folder"
  # PETSc, MPI and their plug-ins keep what they allocate when they start.
  case $link_flags in *-fsanitize*) export ASAN_OPTIONS=detect_leaks=0 ;; esac
  "$here/examples.sh" "$folder/examples" "$source/README.md" "$source"/docs/*.md
  log=$(cmake -S "$here" -B "$folder" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="$flags" \
    -DCMAKE_NO_SYSTEM_FROM_IMPORTED=ON -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_EXE_LINKER_FLAGS="$link_flags" \
    -DCMAKE_CXX_COMPILER_LAUNCHER="${LAUNCHER:-}" -DEXAMPLES="$folder/examples" -DMISSING_COMPONENTS="$missing" 2>&1) &&
    log=$(cmake --build "$folder" -j "${JOBS:-2}" 2>&1) &&
    log=$(ctest --test-dir "$folder" --output-on-failure 2>&1) || { printf '%s\n' "$log"; return 1; }

  # The same objects, linked as pkg-config says.
  local name object modules=0
  export PKG_CONFIG_PATH="$libraries/pkgconfig" LD_LIBRARY_PATH="$libraries"
  while read -r name component object; do
    # shellcheck disable=SC2046,SC2086
    "$compiler" "$folder/$object" $(pkg-config --libs "leonhard-$component") $link_flags -o "$folder/$name-pkg-config"
    "$folder/$name-pkg-config"
    pkg-config --cflags "leonhard-$component" | grep -q -- "-I$(cd "$prefix" && pwd)/"
    modules=$((modules + 1))
  done < <(sort -u -k2,2 "$folder/jobs")
  unset PKG_CONFIG_PATH LD_LIBRARY_PATH
  echo "$folder: $(ctest --test-dir "$folder" -N | grep -c 'Test *#') programs run, $modules of them linked by pkg-config too"
}

# The headers that users get are those at the rooms' roots and what these need.
check_headers() {
  local folder
  for folder in app bench fuzz tests; do
    if [ -e "$1/leonhard/$folder" ]; then echo "$1/leonhard/$folder was installed" && return 1; fi
  done
}

mkdir -p "$2"
folder=$(cd "$2" && pwd)
if [ "$1" != --all ]; then
  rm -rf "$folder/prefix"
  cmake --install "$1" --prefix "$folder/prefix" >/dev/null
  check_headers "$folder/prefix/include"
  check_installed "$folder/prefix" "$folder/build" "$3" "${4:-}"
  exit
fi

# build_library FOLDER COMPILER OPTION...
build_library() {
  local folder=$1 compiler=$2
  shift 2
  echo "building $folder with $compiler $*"
  cmake -S "$source" -B "$folder/library" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DCMAKE_CXX_COMPILER_LAUNCHER="${LAUNCHER:-}" -DLEONHARD_TESTS=OFF -DLEONHARD_APP=OFF "$@" >/dev/null
  cmake --build "$folder/library" -j "${JOBS:-2}" >/dev/null
  cmake --install "$folder/library" --prefix "$folder/prefix" >/dev/null
}

all=$folder
peers=()
if [ -f /usr/include/metis.h ]; then peers+=(-DLEONHARD_METIS=ON); fi
if [ -f /usr/include/scotch/scotch.h ]; then peers+=(-DLEONHARD_SCOTCH=ON); fi
build_library "$all/minimal" g++ -DLEONHARD_SOLVER=OFF -DLEONHARD_DRAW=OFF -DLEONHARD_THREADS=OFF -DLEONHARD_COMPRESSION=OFF
check_installed "$all/minimal/prefix" "$all/minimal/programs" g++ ""
for compiler in g++ clang++; do
  for shared in OFF ON; do
    folder=$all/$compiler-shared-$shared
    build_library "$folder" "$compiler" -DBUILD_SHARED_LIBS=$shared "${peers[@]}"
    check_installed "$folder/prefix" "$folder/programs" "$compiler" ""
    "$here/headers.sh" "$folder/library" "$folder/headers" "$compiler"
    rm -rf "$folder"
  done
done
