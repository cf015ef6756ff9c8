#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the build tree $1 under $2, builds the outside project of this folder against it with compiler $3, runs it.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$2"
cmake --install "$1" --prefix "$2/prefix" >/dev/null
cmake -S "$here" -B "$2/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$3" \
  -DCMAKE_PREFIX_PATH="$2/prefix" -DCMAKE_EXE_LINKER_FLAGS="${4:-}" >/dev/null
cmake --build "$2/build" >/dev/null
"$2/build/outside"
