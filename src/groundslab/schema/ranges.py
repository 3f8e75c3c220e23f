"""Ranges of numbers: the limits of a field, and the magnitudes that make physical sense for its dimension."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

from groundslab import units

#: Numbers nearer to zero than this, in SI units, are zero or a mistake: their powers and quotients leave what a float
#: can hold.
NEAREST_TO_ZERO = 1e-30
#: Largest size of a pure number without limits of its own.
LARGEST_NUMBER = 1e12

Write = Callable[[float], str]


def short(value: float) -> str:
    """Return a limit with few characters, such as 1e-6."""
    return re.sub(r"e\+?(-?)0*([0-9])", r"e\1\2", f"{value:g}")


def limit_text(value: float, dimension: str) -> str:
    """Return a limit of a quantity [SI] with its unit, 0 without one."""
    if value == 0:
        return "0"
    quantity = units.DIMENSIONS[dimension]
    if quantity.smallest < abs(value) < quantity.largest and abs(value) >= 1e-3:
        return units.show(value, dimension)
    return f"{short(100 * value if quantity.si == '%' else value)} {quantity.si}"


@dataclass(frozen=True, slots=True)
class Range:
    """The numbers that a field may hold."""

    above: float | None = None
    at_least: float | None = None
    below: float | None = None
    at_most: float | None = None
    smallest: float = NEAREST_TO_ZERO  # the least size of a number that is not zero

    def holds(self, value: float) -> bool:
        """Whether a number lies in the range."""
        return (
            (self.above is None or value > self.above)
            and (self.at_least is None or value >= self.at_least)
            and (self.below is None or value < self.below)
            and (self.at_most is None or value <= self.at_most)
            and (value == 0 or abs(value) >= self.smallest)
        )

    def words(self, write: Write = short) -> str:
        """Return the range in words, empty if there is none."""
        return " and ".join(f"{name} {write(limit)}" for name, limit in self._limits())

    def wanted(self, value: float, write: Write = short) -> str:
        """Return in words what a number outside the range should be: of its limits those that it does not keep."""
        if self.above is not None and value <= self.above:
            return f"above {write(self.above)}"
        if self.at_least is not None and value < self.at_least:
            return f"at least {write(self.at_least)}"
        if self.below is not None and value >= self.below:
            return f"below {write(self.below)}"
        if self.at_most is not None and value > self.at_most:
            return f"at most {write(self.at_most)}"
        return f"that is 0 or has a size of at least {write(self.smallest)}"

    def signs(self, scale: float = 1) -> str:
        """Return the range in signs, in a unit of which `scale` are one in SI; empty if there is none."""
        if self.at_least is not None and self.at_most is not None:
            return f"{short(scale * self.at_least)} to {short(scale * self.at_most)}"
        signs = {"above": ">", "at least": ">=", "below": "<", "at most": "<="}
        return ", ".join(f"{signs[name]} {short(scale * limit)}" for name, limit in self._limits())

    def schema(self) -> dict[str, Any]:
        """Return the range as JSON schema says it."""
        names = {"above": "exclusiveMinimum", "at least": "minimum", "below": "exclusiveMaximum", "at most": "maximum"}
        return {names[name]: limit for name, limit in self._limits()}

    def _limits(self) -> Iterator[tuple[str, float]]:
        """Yield the names of the limits and the limits, without such as follow from another one."""
        if self.above is not None and (self.at_least is None or self.at_least <= self.above):
            yield "above", self.above
        elif self.at_least is not None:
            yield "at least", self.at_least
        if self.below is not None:
            yield "below", self.below
        elif self.at_most is not None:
            yield "at most", self.at_most


#: Any number that its dimension allows.
ANY = Range()


@lru_cache
def quantity_range(limits: Range, dimension: str) -> Range:
    """Return the range of a quantity: its own, and within it the sizes that make sense for its dimension.

    What must be positive has a smallest size; what may be zero or negative has a largest one only.
    """
    quantity = units.DIMENSIONS[dimension]
    lowest = limits.at_least
    if lowest is None:
        lowest = -quantity.largest if limits.above is None else quantity.smallest if limits.above == 0 else None
    highest = quantity.largest if limits.below is None and limits.at_most is None else limits.at_most
    return replace(limits, at_least=lowest, at_most=highest)


@lru_cache
def number_range(limits: Range) -> Range:
    """Return the range of a pure number: its own, and a largest size where it has no limits."""
    lowest = -LARGEST_NUMBER if limits.above is None and limits.at_least is None else limits.at_least
    highest = LARGEST_NUMBER if limits.below is None and limits.at_most is None else limits.at_most
    return replace(limits, at_least=lowest, at_most=highest)
