#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# headers.sh BUILD FOLDER COMPILER...: every header that the build tree installs for users to include compiles alone, with warnings
# as errors, and all of them together, by each compiler.
set -euo pipefail
build=$1 folder=$2
shift 2
rm -rf "$folder"
cmake --install "$build" --prefix "$folder" --component development >/dev/null
cd "$folder/include"
export warnings="-std=c++20 -fsyntax-only -I. -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Werror"

# What lies at the root of a room; mesh/io and mesh/draw are such roots.
public=$(find leonhard -mindepth 2 -maxdepth 2 -name '*.hpp'; find leonhard/mesh/io leonhard/mesh/draw -maxdepth 1 -name '*.hpp' 2>/dev/null || true)
for compiler in "$@"; do
  export compiler
  # shellcheck disable=SC2016
  printf '%s\n' $public | xargs -P "${JOBS:-2}" -I{} sh -c \
    'echo "#include <{}>" | $compiler $warnings -x c++ - || { echo "{} does not compile alone"; exit 1; }'
  # shellcheck disable=SC2086
  printf '#include <%s>\n' $public | $compiler $warnings -x c++ - || { echo "the headers do not go together"; exit 1; }
  echo "$compiler: $(printf '%s\n' $public | wc -l) headers"
done
