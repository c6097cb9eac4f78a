#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Build and test against a plain VTK >= 9.1 without ParaView: tests/plain_vtk.sh FOLDER [ctest arguments]
#
# Debian's libvtk9-dev conflicts with python3-paraview, so its packages are unpacked into FOLDER/vtk and VTK_DIR points
# there. Takes several minutes on two cores; a second run only what has changed.
set -eu
if [ $# -lt 1 ]; then
  echo "usage: plain_vtk.sh FOLDER [ctest arguments]" >&2
  exit 2
fi
source=$(cd "$(dirname "$0")/.." && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
shift

if [ ! -d "$folder/vtk" ]; then
  mkdir -p "$folder/packages" "$folder/unpacking"
  (cd "$folder/packages" && apt-get download libvtk9-dev libvtk9.1 libvtk9-qt-dev libvtk9.1-qt python3-vtk9 vtk9)
  for package in "$folder"/packages/*.deb; do
    dpkg-deb -x "$package" "$folder/unpacking"
  done
  mv "$folder/unpacking" "$folder/vtk"
fi

libraries=$(dirname "$(find "$folder/vtk" -name 'libvtkCommonCore-9.1.so' | head -n 1)")
export LD_LIBRARY_PATH="$libraries${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
export PYTHONPATH="$folder/vtk/usr/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH}"

cmake -G Ninja -S "$source" -B "$folder/build" -DCMAKE_BUILD_TYPE=Release -DPython3_EXECUTABLE=/usr/bin/python3 \
  -DCMAKE_DISABLE_FIND_PACKAGE_ParaView=ON -DVTK_DIR="$libraries/cmake/vtk-9.1"
cmake --build "$folder/build"
exec ctest --test-dir "$folder/build" --output-on-failure "$@"
