#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# headers.sh [--rest] BUILD FOLDER COMPILER...: every header that the build tree installs for users to include compiles alone, with
# warnings as errors, and all of them together, by each compiler. --rest leaves out those that some source of the project includes
# before all else, for strict builds have compiled them alone already, with the same warnings.
set -euo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
rest=""
if [ "$1" = --rest ]; then rest=1 && shift; fi
build=$1
mkdir -p "$2"
folder=$(cd "$2" && pwd)
shift 2
rm -rf "$folder"
cmake --install "$build" --prefix "$folder" --component development >/dev/null
cd "$folder/include"
export warnings="-std=c++20 -fsyntax-only -I. -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Werror"

# What lies at the root of a room; mesh/io and mesh/draw are such roots.
public=$(find leonhard -mindepth 2 -maxdepth 2 -name '*.hpp'; find leonhard/mesh/io leonhard/mesh/draw -maxdepth 1 -name '*.hpp' 2>/dev/null || true)
alone=$public
if [ -n "$rest" ]; then
  firsts=$(cd "$source" && find kernel mesh delaunay graph solver -name '*.cpp' -exec awk '/^#include/ { print $2; nextfile }' {} + | tr -d '"<>')
  alone=$(comm -23 <(printf '%s\n' $public | sort) <(printf '%s\n' "$firsts" | sort -u))
fi
for compiler in "$@"; do
  export compiler
  # shellcheck disable=SC2016
  printf '%s\n' $alone | xargs -P "${JOBS:-2}" -I{} sh -c \
    'echo "#include <{}>" | $compiler $warnings -x c++ - || { echo "{} does not compile alone"; exit 1; }'
  # shellcheck disable=SC2086
  printf '#include <%s>\n' $public | $compiler $warnings -x c++ - || { echo "the headers do not go together"; exit 1; }
  echo "$compiler: $(printf '%s\n' $alone | wc -l) headers alone, $(printf '%s\n' $public | wc -l) together"
done
