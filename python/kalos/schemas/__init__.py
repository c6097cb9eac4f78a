# SPDX-License-Identifier: BSD-3-Clause
"""JSON Schemas of the files that Kalos reads and writes."""
from pathlib import Path

KINDS = ("scene", "summary")


def schema(kind: str = "scene") -> str:
    """The JSON Schema of scene files or of summary.json, as text."""
    return (Path(__file__).resolve().parent / f"{kind}.schema.json").read_text(encoding="utf-8")
