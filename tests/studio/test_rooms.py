# SPDX-License-Identifier: BSD-3-Clause
"""The rooms of Edge Studio include only rooms before them in these lists, so that each can be read without the later ones."""
import re
from pathlib import Path

import pytest

STUDIO = Path(__file__).resolve().parents[2] / "apps" / "edge-studio"
ROOMS = {"model": ("base", "scene", "results", "run", "probe", "study", "session"),
         "ui": ("common", "charts", "view", "panels", "window")}
INCLUDE = re.compile(r'^#include "(\w+)/\w+\.h"', re.MULTILINE)


def allowed(part, room):
    lower = ROOMS[part][:ROOMS[part].index(room) + 1]
    return set(lower) if part == "model" else set(ROOMS["model"]).union(lower)


def upward(part, room, text):
    return [other for other in INCLUDE.findall(text) if other not in allowed(part, room)]


@pytest.mark.parametrize("part", ROOMS)
def test_every_file_has_a_room(part):
    assert {path.parent.relative_to(STUDIO / part).as_posix() for path in (STUDIO / part).rglob("*.*")} == set(ROOMS[part])


@pytest.mark.parametrize("part, room", [(part, room) for part in ROOMS for room in ROOMS[part]])
def test_includes_point_to_rooms_below(part, room):
    breaches = {path.name: found for path in (STUDIO / part / room).iterdir() if (found := upward(part, room, path.read_text()))}
    assert not breaches


def test_an_include_of_a_later_room_is_found():
    assert upward("model", "scene", '#include "run/Run.h"\n#include "base/Problem.h"\n') == ["run"]
