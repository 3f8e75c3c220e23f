"""How many rows of a sheet hold something, counted in its XML before anything is read of it, which takes far longer."""

from __future__ import annotations

import re
from typing import Any

#: Where a row begins, and where a cell has a value, a text of its own, or a formula.
_TAG = re.compile(rb"<(?:\w+:)?(?:(row)|v|is|f)[\s/>]")
_PIECE, _LONGEST_TAG = 1 << 20, 64


def has_more_rows(book: Any, sheet: Any, most: int) -> bool:
    """Return whether more rows than `most` of a sheet hold something; the workbook is open for reading only."""
    with book._archive.open(sheet._worksheet_path) as part:
        count, filled, before = 0, False, b""
        while piece := part.read(_PIECE):
            text = before + piece
            for tag in _TAG.finditer(text):
                if tag.end() <= len(before):
                    continue  # was seen in the last piece
                if tag[1]:
                    count, filled = count + filled, False
                    if count > most:
                        return True
                else:
                    filled = True
            before = text[-_LONGEST_TAG:]
        return count + filled > most
