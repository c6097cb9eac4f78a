#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Build the kernels against Embree 4 and run their tests: tests/embree4.sh FOLDER [arguments of KernelTests]
#
# Debian 12 has Embree 3 only. Headers and CMake package come from Debian 13's libembree-dev, unpacked into FOLDER/embree; the
# library of Debian 13 wants a newer C library, so that of the PyPI package embreex takes its place.
set -eu
if [ $# -lt 1 ]; then
  echo "usage: embree4.sh FOLDER [arguments of KernelTests]" >&2
  exit 2
fi
source=$(cd "$(dirname "$0")/.." && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
shift

if [ ! -d "$folder/embree" ]; then
  apt=$folder/apt
  mkdir -p "$apt/lists/partial" "$apt/cache/archives/partial" "$folder/packages" "$folder/unpacking"
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian trixie main" \
    >"$apt/sources.list"
  set_apt="-o Dir::Etc::sourcelist=$apt/sources.list -o Dir::Etc::sourceparts=- -o Dir::State::lists=$apt/lists -o Dir::Cache=$apt/cache"
  # shellcheck disable=SC2086  # options, meant to be split
  (cd "$folder/packages" && apt-get $set_apt -q update && apt-get $set_apt -q download libembree-dev)
  python3 -m pip download -q --no-deps --only-binary :all: --python-version 3.11 -d "$folder/packages" embreex==4.4.0.post1
  dpkg-deb -x "$folder"/packages/libembree-dev_*.deb "$folder/unpacking"
  libraries=$(dirname "$(find "$folder/unpacking" -name libembree4.so)")
  python3 -m zipfile -e "$folder"/packages/embreex-*.whl "$folder/unpacking/wheel"
  cp "$folder"/unpacking/wheel/embreex.libs/* "$libraries"
  ln -s "$(basename "$libraries"/libembree4-*.so.4)" "$libraries/libembree4.so.4"
  mv "$folder/unpacking" "$folder/embree"
fi

package=$(dirname "$(find "$folder/embree" -name embree-config.cmake)")
cmake -G Ninja -S "$source" -B "$folder/build" -DCMAKE_BUILD_TYPE=Release -Dembree_DIR="$package" \
  -DCMAKE_BUILD_RPATH="$(dirname "$(find "$folder/embree" -name libembree4.so.4)")"
cmake --build "$folder/build" --target KernelTests
ldd "$folder/build/bin/KernelTests" | grep libembree4
exec "$folder/build/bin/KernelTests" "$@"
