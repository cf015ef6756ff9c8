#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# embedded.sh FOLDER COMPILER: builds, in FOLDER, a project that includes these sources and links their kernel.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$1"
log=$(cmake -S "$here/embedded" -B "$1" -G Ninja -DCMAKE_CXX_COMPILER="$2" -DLEONHARD_SOURCE="$(cd "$here/../.." && pwd)" \
  -DCMAKE_CXX_COMPILER_LAUNCHER="${LAUNCHER:-}" 2>&1) &&
  log=$(cmake --build "$1" -j "${JOBS:-2}" 2>&1) || { printf '%s\n' "$log"; exit 1; }
if [ -e "$1/_deps/leonhard-build/mesh/libleonhard_mesh.a" ]; then echo "more was built than is linked" && exit 1; fi
if cmake --install "$1" --prefix "$1/prefix" >/dev/null && [ -e "$1/prefix/include" ]; then
  echo "a subproject installs its headers" && exit 1
fi
"$1/embedded"
