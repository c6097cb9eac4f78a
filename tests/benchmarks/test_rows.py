# SPDX-License-Identifier: BSD-3-Clause
"""The rows of error against time, on two of them and hardly any effort: that they run, and what table and picture say."""
import csv
import sys

import pytest
from matplotlib.image import imread

import rows


def test_two_rows_one_after_the_other(tmp_path, monkeypatch, capsys):
    for name in ("sobolev", "furnace"):
        monkeypatch.setattr(sys, "argv", ["rows.py", str(tmp_path), "--rows", name, "--budget", "0.2", "--peers", "none"])
        rows.main()
    said = (tmp_path / "rows.txt").read_text()
    assert said in capsys.readouterr().out
    assert said.index("furnace  gathered") < said.index("sobolev  gathered") < said.index("bias of gathered")
    table = list(csv.DictReader((tmp_path / "rows.csv").open()))
    assert len(table) == 2 * 2 * 5 and {row["rms_error"] for row in table} == {"5 %", "2 %", "1 %", "0.5 %", "0.3 %"}
    assert imread(tmp_path / "rows.png").std() > 0.05


def test_ratio_to_the_best_peer():
    """Errors that fall as the root of time: 2 % in a second by the method, in four by one peer, in nine by another."""
    steps = [{"contender": name, "cpu_seconds": at * t, "rms_of_value": 0.02 / t**0.5}
             for name, at in (("gathered", 1), ("mitsuba", 4), ("radiance", 9)) for t in (0.5, 1, 2)]
    result = {"steps": steps, "contenders": [{"name": name, "peer": name != "gathered"} for name in ("gathered", "mitsuba", "radiance")]}
    found = rows.times(result, "value")
    seconds, how, ratio = found["gathered"][rows.NAMES.index("2 %")]
    assert (seconds, how, ratio) == (pytest.approx(1), "interpolated", pytest.approx(4))
    assert found["radiance"][rows.NAMES.index("2 %")][2] == pytest.approx(4 / 9)


@pytest.mark.parametrize("arguments", [["--rows", "moon"], ["--peers", "povray"], ["--rows", "none"]])
def test_what_is_not_known(arguments, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(sys, "argv", ["rows.py", str(tmp_path), *arguments])
    with pytest.raises(SystemExit) as stop:
        rows.main()
    assert stop.value.code == 2
    assert ("holds no row yet" if arguments[1] == "none" else f"{arguments[1]!r} is not known") in capsys.readouterr().err
