# SPDX-License-Identifier: BSD-3-Clause
"""The table of techniques, on few trajectories: that it runs, and that shadow rays in an empty room show up in it."""
import json

import techniques

from kalos.core.options import TECHNIQUES


def test_table(tmp_path, capsys):
    scene = techniques.office()
    scene["surfaces"] = [one for one in scene["surfaces"] if "quad" in one]
    scene["receivers"][0]["plane"]["resolution"] = [12, 9]
    path = tmp_path / "hall.json"
    path.write_text(json.dumps(scene), encoding="utf-8")
    factors = techniques.table([("hall", path, "desk")], "compensated", 640)["hall"]
    assert len(factors) == len(TECHNIQUES) and all(factor > 0 for factor in factors)
    assert factors[TECHNIQUES.index("convex")] > 1.3 and factors[TECHNIQUES.index("exact-direct")] > 1.3
    assert "hall" in capsys.readouterr().out
