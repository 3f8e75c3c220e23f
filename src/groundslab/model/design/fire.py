"""Classes of resistance to fire, and where a fire is."""

from __future__ import annotations

from typing import Literal

#: Carrying (R), and separating besides (E and I), for so many minutes.
FireClass = Literal[
    "R 30", "R 60", "R 90", "R 120", "R 180", "R 240",
    "REI 30", "REI 60", "REI 90", "REI 120", "REI 180", "REI 240",
]  # fmt: skip
FireFrom = Literal["above", "below", "both"]
