#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes the Debian packages, installs them in a clean Debian (a chroot made for it), tries them there and removes them again.
#   deb.sh [FOLDER]   FOLDER has the packages already; otherwise cmake --workflow --preset package makes them
# Needs root, mmdebstrap or debootstrap, and a mirror (MIRROR); says so and exits with 77 where one of them is missing.
set -euo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
mirror=${MIRROR:-http://deb.debian.org/debian}
suite=${SUITE:-bookworm}

skip() { echo "deb.sh: not tried: $1" >&2 && exit 77; }
[ "$(id -u)" -eq 0 ] || skip "a chroot takes root"
command -v dpkg-shlibdeps >/dev/null || skip "dpkg-dev is not installed"
command -v mmdebstrap >/dev/null || command -v debootstrap >/dev/null || skip "neither mmdebstrap nor debootstrap is installed"

folder=${1:-}
if [ -z "$folder" ]; then
  (cd "$source" && cmake --workflow --preset package)
  folder=$source/build/release
fi
packages=("$folder"/leonhard_*.deb "$folder"/libleonhard*.deb)
for package in "${packages[@]}"; do
  [ -f "$package" ] || { echo "deb.sh: no $package" >&2; exit 1; }
  echo "== $(basename "$package")"
  dpkg-deb -f "$package" Package Version Installed-Size Depends Suggests
done

root=$(mktemp -d)
trap 'umount "$root/proc" 2>/dev/null || true; rm -rf "$root"' EXIT
chmod 755 "$root"
if command -v mmdebstrap >/dev/null; then
  mmdebstrap --quiet --variant=minbase "$suite" "$root" "$mirror" >&2 || skip "$mirror cannot be reached"
else
  debootstrap --variant=minbase "$suite" "$root" "$mirror" >/dev/null || skip "$mirror cannot be reached"
fi
[ -s "$root/etc/resolv.conf" ] || cp /etc/resolv.conf "$root/etc/resolv.conf"
mount -t proc proc "$root/proc" 2>/dev/null || true
mkdir -p "$root/trial/jobs"
cp "${packages[@]}" "$root/trial"
cp "$source"/tests/install/jobs/{check.hpp,quality_mesh.cpp,tetrahedra.cpp} "$root/trial/jobs"
cat >"$root/trial/CMakeLists.txt" <<'EOF'
cmake_minimum_required(VERSION 3.25)
project(trial LANGUAGES CXX)
find_package(leonhard 0.1 CONFIG REQUIRED COMPONENTS delaunay)
add_executable(quality_mesh jobs/quality_mesh.cpp)
target_link_libraries(quality_mesh PRIVATE leonhard::delaunay)
EOF
cat >"$root/trial/run" <<'EOF'
set -euo pipefail
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
cd /trial
apt() { apt-get -qq -o Dpkg::Use-Pty=0 "$@" >/dev/null; }
apt update
echo "== the program alone"
apt install -y --no-install-recommends man-db
apt install -y --no-install-recommends ./leonhard_*.deb $(ls ./libleonhard[0-9]*.deb 2>/dev/null)
leonhard --version
leonhard --help >/dev/null
for page in leonhard leonhard-mesh leonhard-solve; do man -w $page; done
man leonhard-mesh | grep -q -- --min-angle
cp -r /usr/share/doc/leonhard/examples/wedge .
leonhard mesh wedge/wedge.poly --size 0.1 -o wedge.su2 --quiet >/dev/null
leonhard check wedge.su2 | tail -n 1
leonhard draw wedge.su2 -o wedge.png --quiet >/dev/null
test -s wedge.png
leonhard partition wedge.su2 -k 4 --quiet >/dev/null
bash -c '. /usr/share/bash-completion/completions/leonhard
  COMP_WORDS=(leonhard mesh --min) COMP_CWORD=2; _leonhard; test "${COMPREPLY[*]}" = --min-angle'
echo "== the library"
apt install -y --no-install-recommends g++ cmake make pkg-config ./libleonhard-dev_*.deb
cmake -S . -B build >/dev/null
cmake --build build >/dev/null
build/quality_mesh
c++ -std=c++20 jobs/tetrahedra.cpp $(pkg-config --cflags --libs leonhard-delaunay) -o tetrahedra
./tetrahedra
echo "== gone again"
apt purge -y leonhard 'libleonhard*'
left=$(find /usr /etc /var/lib/dpkg/info -name '*leonhard*')
if [ -n "$left" ]; then echo "left behind: $left" && exit 1; fi
EOF
chroot "$root" bash /trial/run
echo "deb.sh: installed, tried and removed"
