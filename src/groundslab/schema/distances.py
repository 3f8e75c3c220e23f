"""Type of fields that hold distances one after the other, as people write them: `3 x 6 m, 4.5 m`."""

from __future__ import annotations

import itertools
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from groundslab import units
from groundslab.schema.fields import FieldType, Quantity
from groundslab.schema.issues import FieldError, field_error
from groundslab.schema.ranges import Range
from groundslab.schema.wording import quote

#: Distances in one list, at most.
MOST = 200
#: Each distance, and how often it is repeated.
_REPEATED = re.compile(r"\s*([0-9]{1,3})\s*[x×*]\s*(.+)", re.DOTALL)
_EACH = Quantity("length", "a", "", Range(above=0))


@dataclass(frozen=True)
class Distances(FieldType):
    """Distances one after the other, kept as a tuple [m]; text in files, text or numbers in SI units in Python."""

    EXPECTED: ClassVar = 'distances such as "3 x 6 m, 4.5 m"'
    TYPE: ClassVar = 'distances (`"3 x 6 m, 4.5 m"`)'
    SCHEMA: ClassVar = {"type": "string", "maxLength": 40 * MOST, "examples": ["3 x 6 m, 4.5 m"]}

    symbol: str
    meaning: str

    def read(self, value: Any, from_file: bool) -> tuple[float, ...]:
        """Return the distances; raises FieldError."""
        if isinstance(value, str):
            distances = tuple(distance for part in re.split("[,;]", value) for distance in self._repeated(part, value))
        elif isinstance(value, list | tuple) and not from_file:
            distances = tuple(float(_EACH.read(item, from_file=False)) for item in value)
        else:
            raise field_error(value, self.expected())
        if not 0 < len(distances) <= MOST:
            raise field_error(value, f"{self.expected()}, at most {MOST}")
        return distances

    def _repeated(self, part: str, whole: str) -> tuple[float, ...]:
        """Return the distances that one part of a text stands for."""
        repeated = _REPEATED.fullmatch(part)
        count, text = (int(repeated[1]), repeated[2]) if repeated else (1, part)
        try:
            return (float(_EACH.read(text.strip(), from_file=True)),) * count
        except FieldError:
            hint = "write each with its unit, and a comma between them"
            raise field_error(whole, self.expected(), hint) from None

    def write(self, value: Sequence[float]) -> str:
        """Return the distances as text, equal ones in a row once."""
        runs = ((distance, len(list(same))) for distance, same in itertools.groupby(value))
        parts = (f"{count} x {_written(distance)}" if count > 1 else _written(distance) for distance, count in runs)
        return quote(", ".join(parts))

    def range_text(self) -> str:
        """Return the range of each."""
        return _EACH.range_text()


def _written(distance: float) -> str:
    return units.write(distance, "length")
