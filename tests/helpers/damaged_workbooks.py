"""Workbooks and tables that are damaged at random: cells, rows and parts that no program would write so."""

from __future__ import annotations

import random
import re
import time
import zipfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

#: No file may take longer to be read [s], nor more memory [bytes].
SECONDS, MEMORY = 10.0, 1_000_000_000

#: What a cell's XML may be by mistake or malice: no numbers, formulas, dates, links, errors, long texts.
CELLS = (
    "<v></v>", "<v>NaN</v>", "<v>-INF</v>", "<v>1e999</v>", "<v>-1</v>", "<v>0</v>", "<v>1e14</v>", "<v>4294967296</v>",
    "<f>1+1</f>", "<f>[1]other!A1*2</f><v>7</v>", '<f t="shared" ref="A1:XFD1048576" si="0">A1</f><v>3</v>',
    '<f>HYPERLINK("http://x.invalid")</f><v>1</v>', f"<v>{'9' * 400}</v>", "<is><t>2026-02-30</t></is>", "<v>#REF!</v>",
    f"<is><t>{'x' * 40_000}</t></is>", "<v>&#x202e;1</v>", "<v>1,5</v>", "<v>-</v>", "<v>2026-01-01T00:00:00</v>",
)  # fmt: skip
#: Types of cells: an index of a shared text, an error, a boolean, a date, a text, one that there is not.
TYPES = ("s", "e", "b", "d", "inlineStr", "str", "n", "odd")


def change_sheet(text: str, chance: random.Random) -> str:
    """Return the XML of a sheet with one thing changed: a cell, its type or style, a row, the extent, joined cells."""
    changes: tuple[Callable[[], str], ...] = (
        lambda: _replace(text, r"<v>[^<]*</v>|<is>.*?</is>", chance.choice(CELLS), chance),
        lambda: _replace(text, r' t="\w+"', f' t="{chance.choice(TYPES)}"', chance),
        lambda: _replace(text, r'<c r="[A-Z]+\d+"', f'<c s="{chance.randint(0, 99)}" r="XFD1048576"', chance),
        lambda: _replace(text, r'<c r="[A-Z]+\d+"', '<c r="?0"', chance),
        lambda: _replace(text, r'<row r="\d+"', f'<row r="{chance.choice([0, -1, 1048576, 10**12])}"', chance),
        lambda: _replace(text, r"<row .*?</row>", "", chance),
        lambda: _replace(text, r"<dimension [^>]*>", '<dimension ref="A1:XFD1048576"/>', chance),
        lambda: text.replace(
            "</sheetData>", '</sheetData><mergeCells count="1"><mergeCell ref="A1:XFD9"/></mergeCells>'
        ),
        lambda: text.replace("</sheetData>", "<row/>" * 1000 + "</sheetData>"),
    )
    return chance.choice(changes)()


def _replace(text: str, pattern: str, new: str, chance: random.Random) -> str:
    """Return a text with one match of a pattern, chosen at random, in other words."""
    matches = list(re.finditer(pattern, text, re.DOTALL))
    if not matches:
        return text
    match = chance.choice(matches)
    return text[: match.start()] + new + text[match.end() :]


def change_workbook(whole: Path, path: Path, seed: int) -> Path:
    """Write a workbook with some cells, rows or bytes of its parts changed, and return its path."""
    chance = random.Random(seed)
    with zipfile.ZipFile(whole) as parts:
        texts = {name: parts.read(name) for name in parts.namelist()}
    for _ in range(chance.randint(1, 5)):
        name = chance.choice(sorted(texts))
        if "worksheets/sheet" in name:
            texts[name] = change_sheet(texts[name].decode(errors="replace"), chance).encode()
        elif chance.random() < 0.3:
            part = bytearray(texts[name])
            part[chance.randrange(len(part))] = chance.choice(b'<>"/&=a1 \x00\xff')
            texts[name] = bytes(part)
    with zipfile.ZipFile(path, "w") as parts:
        for name, text in texts.items():
            parts.writestr(name, text)
    return path


def change_text(text: str, seed: int) -> str:
    """Return the text of a table with some characters, cells or lines changed."""
    chance = random.Random(seed)
    lines = text.splitlines()
    for _ in range(chance.randint(1, 5)):
        number = chance.randrange(len(lines))
        what = chance.random()
        if what < 0.1:
            lines.insert(number, chance.choice(lines))
        elif what < 0.2 and len(lines) > 1:
            del lines[number]
        elif what < 0.7:
            cells = re.split(r"([,;\t])", lines[number])
            cells[chance.randrange(len(cells))] = chance.choice(
                ["", "NaN", "1e999", "=1+1", "-", "1,5", "1.812,4", "1,812", '"', "x" * 300, "2026-02-30", "\u202e",
                 "A", "G", "kN", "kip", "Fz", "Case", "9" * 30, ";", "\t", "\x00"]
            )  # fmt: skip
            lines[number] = "".join(cells)
        else:
            at = chance.randrange(len(lines[number]) + 1)
            lines[number] = lines[number][:at] + chance.choice(',;\t"\n.-0 é') + lines[number][at + 1 :]
    return "\n".join(lines) + "\n"


@contextmanager
def within_limits() -> Iterator[None]:
    """Expect that no more than some time and memory is taken."""
    start, before = time.monotonic(), _largest_memory()
    yield
    assert time.monotonic() - start < SECONDS
    assert _largest_memory() - before < MEMORY


def _largest_memory() -> int:
    """Return the largest memory of this process so far [bytes]; 0 where it cannot be told."""
    try:
        import resource
    except ImportError:
        return 0
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
