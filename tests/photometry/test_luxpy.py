# SPDX-License-Identifier: BSD-3-Clause
"""The sample files of luxpy (PyPI), read by luxpy and by Kalos.

luxpy may live in an environment of its own: KALOS_LUXPY_PYTHON names its interpreter.
"""
import json
import os
import subprocess
import sys

import pytest
from files import read

SCRIPT = """
import json, os
from luxpy.toolboxes import iolidfiles
folder = os.path.join(os.path.dirname(iolidfiles.__file__), "data")
found = []
for name in sorted(os.listdir(folder)):
    if name.endswith((".ies", ".ldt")):
        path = os.path.join(folder, name)
        data = iolidfiles.read_lamp_data(path, normalize=None)
        found.append([path, float(data["lumens_per_lamp"]), data["theta"].tolist(), data["phi"].tolist(), data["values"].tolist()])
print(json.dumps(found))
"""


@pytest.fixture(scope="module")
def samples():
    interpreter = os.environ.get("KALOS_LUXPY_PYTHON", sys.executable)
    ran = subprocess.run([interpreter, "-c", SCRIPT], capture_output=True, text=True, env={**os.environ, "PYTHONPATH": ""})
    if ran.returncode:
        pytest.skip(f"luxpy cannot be imported by {interpreter}, so its reading is not compared; pip install luxpy "
                    "matplotlib pandas 'numpy<2.2' in an environment and set KALOS_LUXPY_PYTHON to its python")
    return json.loads(ran.stdout.splitlines()[-1])


def test_same_tables(samples):
    assert {os.path.splitext(path)[1] for path, *_ in samples} == {".ies", ".ldt"}
    for path, lumens, angles, planes, values in samples:
        reader = read(path)
        assert reader.GetLampFlux() == lumens
        # luxpy leaves EULUMDAT in cd per 1000 lm.
        factor = lumens / 1000 if path.endswith(".ldt") else 1
        compared = 0
        for plane, row in zip(planes, values):
            for angle, value in zip(angles, row):
                assert reader.GetIntensity(plane, angle) == pytest.approx(factor * value, rel=1e-6, abs=1e-9), (path, plane, angle)
                compared += 1
        assert compared > 100
