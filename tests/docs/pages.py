# SPDX-License-Identifier: BSD-3-Clause
"""The pages of the manual, and the blocks of code in them."""
import re
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
README = ROOT / "README.md"
PAGES = [README, *sorted(DOCS.rglob("*.md"))]
BLOCK = re.compile(r"^(?:<!-- not run: (?P<reason>[^\n]+) -->\n)?```(?P<language>\w+)\n(?P<text>.*?)^```$", re.MULTILINE | re.DOTALL)


@dataclass(frozen=True)
class Block:
    """A fenced block; `reason` says why it is not run."""

    page: Path
    language: str
    text: str
    reason: str


def blocks(language):
    """The blocks of a language, page by page."""
    return [Block(page, found["language"], found["text"], found["reason"])
            for page in PAGES for found in BLOCK.finditer(page.read_text(encoding="utf-8")) if found["language"] == language]


def name(page):
    return str(page.relative_to(ROOT))
