# SPDX-License-Identifier: BSD-3-Clause
"""`kalos validate` prints a line per case and method, and fails when one of them fails."""
from kalos.validation import truths, validate
from kalos.validation.cases import Case


def test_passes(command):
    status, out, _ = command("validate", "--method", "local")
    lines = out.splitlines()
    assert lines[0].startswith("seed 1; chance that a sound method fails a case: 0.0001")
    assert "as an error is estimated from 8 replicates in most methods (Student's t" in lines[2]
    for case in filter(lambda one: one.takes("local"), validate.CASES):
        assert any(line.startswith(case.name) and " local " in line for line in lines)
    assert status == 0 and "FAIL" not in out, out


def test_fails_when_too_noisy(command):
    status, out, _ = command("validate", "--method", "local", "--trajectories", 64)
    assert status == 1 and "FAIL" in out


def test_fails_when_the_truth_is_another(command, monkeypatch):
    wrong = Case("wrong", "cie171/5-2.json", lambda p, n: 1.001 * truths.cie171_point(p), 1000, 1e-3)
    monkeypatch.setattr(validate, "CASES", [*validate.CASES[:0], *[wrong] * 5])
    status, out, _ = command("validate", "--method", "local")
    assert status == 1 and "FAIL" in out


def test_missing_data(command, tmp_path):
    status, _, error = command("validate", "--data", tmp_path)
    assert status == 2 and error.startswith(f"kalos: error: {tmp_path}/")
