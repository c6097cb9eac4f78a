# SPDX-License-Identifier: BSD-3-Clause
"""Damaged photometric files: a message, or a repair that a warning tells of; never a crash, never a silent zero."""
import random
import re
import time

import pytest
from files import codes, read
from kalos.errors import KalosError
from mutations import IES, LDT, corpus

CASES = list(corpus())
FORM = re.compile(r"\A[^\n]*: line \d+: [^\n:]+: [^\n]*\Z")


def test_enough():
    assert len(CASES) >= 60 and len({name for name, *_ in CASES}) == len(CASES)


@pytest.mark.parametrize("name, content, expected", CASES, ids=[name for name, *_ in CASES])
def test_damaged(tmp_path, capfd, name, content, expected):
    path = tmp_path / name
    path.write_bytes(content)
    if isinstance(expected, str):
        with pytest.raises(KalosError) as error:
            read(path)
        message = str(error.value)
        assert expected in message and message.startswith(f"{path}: line ") and FORM.match(message)
        return
    reader = read(path)
    assert set(codes(reader)) == expected
    assert reader.GetTableFlux() > 0 and reader.GetLargestIntensity() > 0
    assert capfd.readouterr().err.count("kalos: warning: ") == len(expected)


def sound(path):
    """Reads a file; whatever comes of it is a message of the form, or light."""
    try:
        reader = read(path)
    except KalosError as error:
        assert FORM.match(str(error)), error
        return "error"
    assert reader.GetTableFlux() > 0
    return "read"


def test_random_damage(tmp_path, capfd):
    """500 files, seed 5: bytes changed, cut out, doubled."""
    generator, outcomes = random.Random(5), set()
    for text in (IES, LDT):
        for _ in range(250):
            data = bytearray(text.encode())
            for _ in range(generator.choice((1, 1, 2, 5))):
                at = generator.randrange(len(data))
                kind = generator.randrange(4)
                if kind == 0:
                    data[at] = generator.randrange(256)
                elif kind == 1:
                    del data[at:at + generator.randrange(1, 30)]
                elif kind == 2:
                    data[at:at] = data[at:at + generator.randrange(1, 30)]
                else:
                    data[at:at] = generator.choice((b"-", b"e9", b"nan", b" ", b"\n", b"\xff", b",", b"."))
                data = data or bytearray(b" ")
            path = tmp_path / "file.ies"
            path.write_bytes(data)
            outcomes.add(sound(path))
    assert outcomes == {"error", "read"}


def test_hundred_megabytes_of_spaces(tmp_path):
    path = tmp_path / "spaces.ies"
    with path.open("wb") as file:
        for _ in range(100):
            file.write(b" " * 1000000)
    started = time.perf_counter()
    with pytest.raises(KalosError, match="line 1: file: larger than 16 MiB; expected a photometric file"):
        read(path)
    path.write_bytes(IES.encode() + b" " * 16000000)
    assert codes(read(path)) == []
    path.write_bytes(b" " * 16000000)
    with pytest.raises(KalosError, match="line 1: file: nothing but blanks"):
        read(path)
    assert time.perf_counter() - started < 10
