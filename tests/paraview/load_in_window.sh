#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Start the ParaView window, load the plugin from a script and leave: load_in_window.sh Kalos.so WORK_FOLDER
set -eu
plugin=$1
folder=$2
rm -f "$folder/window.txt"
cat > "$folder/window.py" <<EOF
import os
import paraview.simple as pv
pv.LoadPlugin("$plugin", remote=False, ns=pv.__dict__)
plane = pv.KalosCalculationPlane(Resolution=[2, 3])
plane.UpdatePipeline()
with open("$folder/window.txt", "w") as file:
    file.write(str(plane.GetDataInformation().GetNumberOfCells()))
os._exit(0)
EOF
timeout 120 paraview --script="$folder/window.py"
test "$(cat "$folder/window.txt")" = 6
