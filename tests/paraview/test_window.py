# SPDX-License-Identifier: BSD-3-Clause
"""The ParaView window itself, with the plugin: a session in it is drawn, traced, and its trace runs in pvpython as it stands.

Leaves window.png, a picture of the whole screen, in the folder KALOS_PICTURES.
"""
import os
import shutil
import subprocess
import time
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
PLUGIN = os.environ["KALOS_PLUGIN"]
PICTURES = Path(os.environ["KALOS_PICTURES"])
PATIENCE = 120  # s, on a busy machine

# What a user does: load the plugin, open a scene, add a plane and an illuminance, apply, colour by lux.
SESSION = """
import os
import paraview.simple as pv
from paraview import smtrace
smtrace.start_trace()
pv.LoadPlugin({plugin!r}, remote=False, ns=pv.__dict__)
scene = pv.OpenDataFile({scene!r})
plane = pv.KalosCalculationPlane(registrationName="plane", Origin=[0, 0, 0.75], U=[5, 0, 0], V=[0, 5, 0], Resolution=[24, 24])
lux = pv.KalosIlluminance(registrationName="lux", Receivers=plane, Surfaces=pv.OutputPort(scene, 0),
                          Luminaires=pv.OutputPort(scene, 1), Trajectories=320, Seed=7, Method="Compensated")
view = pv.GetActiveViewOrCreate("RenderView")
display = pv.Show(lux, view)
pv.ColorBy(display, ("CELLS", "Illuminance"))
display.SetScalarBarVisibility(view, True)
pv.ResetCamera(view)
pv.SetActiveSource(lux)
trace = smtrace.stop_trace()
pv.Render(view)
low, high = lux.CellData["Illuminance"].GetRange()
with open({out!r} + ".part", "w") as file:
    file.write(f"{{low}} {{high}}\\n{{trace}}")
os.rename({out!r} + ".part", {out!r})
"""
CHECK = """
lux = FindSource("lux")
UpdatePipeline(proxy=lux)
print("range", *lux.CellData["Illuminance"].GetRange())
"""


def screenshot(least):
    """The screen as soon as it shows that many colours, or as it is when patience ends."""
    from PIL import ImageGrab

    end = time.monotonic() + PATIENCE
    while True:
        picture = ImageGrab.grab(xdisplay=os.environ["DISPLAY"])
        colours = len(np.unique(np.asarray(picture)[..., :3].reshape(-1, 3), axis=0))
        if colours >= least or time.monotonic() > end:
            return picture, colours
        time.sleep(1)


@pytest.mark.skipif("DISPLAY" not in os.environ, reason="no screen here")
@pytest.mark.skipif(not shutil.which("paraview"), reason="no ParaView window here")
def test_session_in_the_window(tmp_path):
    script, out = tmp_path / "session.py", tmp_path / "said.txt"
    script.write_text(SESSION.format(plugin=PLUGIN, scene=str(ROOT / "data" / "cornell" / "cornell-empty.json"), out=str(out)))
    home = {**os.environ, "HOME": str(tmp_path), "XDG_CONFIG_HOME": str(tmp_path), "XDG_RUNTIME_DIR": str(tmp_path)}
    with (tmp_path / "log.txt").open("w") as log, subprocess.Popen(["paraview", f"--script={script}"], stdout=log, stderr=log,
                                                                   env=home) as window:
        try:
            end = time.monotonic() + PATIENCE
            while not out.exists() and window.poll() is None and time.monotonic() < end:
                time.sleep(0.5)
            assert out.exists(), (tmp_path / "log.txt").read_text()
            picture, colours = screenshot(150)
        finally:
            window.kill()
    PICTURES.mkdir(parents=True, exist_ok=True)
    picture.save(PICTURES / "window.png")
    assert colours >= 150, "the plane has not been drawn"

    said, trace = out.read_text().split("\n", 1)
    assert "KalosIlluminance(" in trace and "LoadPlugin(" in trace
    replay = tmp_path / "trace.py"
    replay.write_text(trace + CHECK)
    done = subprocess.run(["pvpython", replay], capture_output=True, text=True, timeout=PATIENCE, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines()[-1] == f"range {said}"
