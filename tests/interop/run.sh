#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Meshes that Gmsh, TetGen, meshio, VTK and METIS write are read by the program, and its meshes by them: equal counts,
# areas and volumes, groups and names.
#   tests/interop/run.sh [--skip-missing] [PROGRAM]
# Installs what it needs with apt, and says loudly what it cannot get; with --skip-missing it installs nothing.
# PROGRAM is leonhard (default: the release build's, which is built). One minute.
# Exit code: 0 if all is equal, 1 otherwise, also where nothing could be compared unless --skip-missing was given.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."
. cmake/packages.sh

skip_missing=""
if [ "${1:-}" = --skip-missing ]; then skip_missing=yes; shift; fi
if [ $# -gt 0 ]; then
  program=$(readlink -f "$1")
else
  build_preset release leonhard_program
  program=$PWD/build/release/app/leonhard
fi

# tool, Debian package, whether it is there. Debian's Python, since its modules are Debian's.
python=/usr/bin/python3
tools=(gmsh tetgen meshio vtk metis)
package_of() { case $1 in meshio) echo python3-meshio ;; vtk) echo python3-vtk9 ;; *) echo "$1" ;; esac; }
is_there() {
  case $1 in
    meshio | vtk) [ -x $python ] && $python -c "import numpy, $1" 2>/dev/null ;;
    metis) command -v gpmetis >/dev/null ;;
    *) command -v "$1" >/dev/null ;;
  esac
}

there=() missing=()
for tool in "${tools[@]}"; do
  if ! is_there "$tool" && [ -z "$skip_missing" ]; then ensure_packages "$(package_of "$tool")" || true; fi
  if is_there "$tool"; then there+=("$tool"); else missing+=("$(package_of "$tool")"); fi
done
if [ ${#missing[@]} -gt 0 ]; then
  printf '\nNOT COMPARED WITH: %s (not installed)\n\n' "${missing[*]}"
fi
if ! $python -c "import numpy" 2>/dev/null; then
  echo "NOT COMPARED AT ALL: no $python with numpy (apt-get install python3-numpy)"
  [ -n "$skip_missing" ]
  exit
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
$python -B -W ignore tests/interop/interop.py "$program" "$scratch" "${there[@]}"
