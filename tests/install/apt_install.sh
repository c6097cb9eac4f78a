#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The Debian package on a machine with only ParaView: tests/install/apt_install.sh FOLDER [BUILD]
#
# Makes a minimal Debian 12 with paraview and python3-paraview in FOLDER (debootstrap, as root, 3 GB, some minutes; kept for
# the next time), puts the package of BUILD (build/) in by apt, uses what it brought, and takes it off again.
set -eu
if [ $# -lt 1 ]; then
  echo "usage: apt_install.sh FOLDER [BUILD]" >&2
  exit 2
fi
source=$(cd "$(dirname "$0")/../.." && pwd)
build=$(cd "${2:-$source/build}" && pwd)
mkdir -p "$1"
root=$(cd "$1" && pwd)
export DEBIAN_FRONTEND=noninteractive LC_ALL=C

inside() {
  chroot "$root" "$@"
}

[ -e "$root/etc/debian_version" ] || debootstrap --variant=minbase bookworm "$root"
trap 'umount "$root/proc"' EXIT
mount -t proc proc "$root/proc"
if [ ! -e "$root/usr/bin/paraview" ]; then
  inside apt-get -q update
  inside apt-get -q install -y --no-install-recommends paraview python3-paraview
fi
inside apt-get -q -y purge kalos 2>/dev/null || true

rm -rf "$root/opt/kalos"
mkdir -p "$root/opt/kalos"
cpack --config "$build/CPackConfig.cmake" -B "$root/opt/kalos" >/dev/null
cp -r "$source/data/cornell" "$root/opt/kalos"
inside sh -c 'apt-get -q install -y --no-install-recommends /opt/kalos/kalos_*.deb'

echo "== command"
inside kalos solve /opt/kalos/cornell/cornell-empty.json --out /opt/kalos/out --trajectories 64 | tail -n 5
test -s "$root/opt/kalos/out/front.exr"
echo "== package"
inside python3 -c 'import kalos; print(kalos.__file__, kalos.vtkKalosIlluminance().GetClassName())'
echo "== plugin"
inside env PV_PLUGIN_PATH=/usr/lib/paraview-5.11/plugins pvpython -c \
  'import paraview.simple as pv; p = pv.KalosCalculationPlane(); p.UpdatePipeline(); print(p.GetXMLName(), p.GetDataInformation().GetNumberOfCells())'
echo "== Edge Studio"
inside env QT_QPA_PLATFORM=offscreen sh -c 'ldd /usr/bin/edge-studio | grep "not found" && exit 1; echo "all libraries are there"'
echo "== off again"
inside apt-get -q -y purge kalos >/dev/null
test ! -e "$root/usr/bin/kalos" && test ! -e "$root/usr/lib/python3/dist-packages/kalos"
echo "apt_install.sh: passed"
