"""What calculations of bars have in common: the moment, the block, the area, the least area."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from groundslab.design.rules.bending import FORMULAS
from groundslab.design.rules.calculation import MEGA, Step

#: From m2/m to cm2/m.
CM2 = 1e4


@dataclass(frozen=True, slots=True)
class BarsNeeded:
    """What a layer of bars needs, and the moment that governs it."""

    moment: float  # [N m/m], of either sign
    thickness: float  # [m]
    axis: float  # of the bars from the face that they lie at [m]
    area: float  # [m2/m]
    minimum: float  # [m2/m]

    @property
    def d(self) -> float:
        """Return the effective depth [m]."""
        return self.thickness - self.axis


def depth(need: BarsNeeded) -> Iterator[Step]:
    """Yield the design moment, the thickness, the distance of the bars' axis from the face, and the depth."""
    yield Step("design moment per width, by Wood", "m", abs(need.moment) / MEGA, "MNm/m")
    yield Step("thickness", "h", need.thickness, "m")
    yield Step("distance of the bars' axis from the face", "a_1", need.axis, "m")
    yield Step("effective depth", "d", need.d, "m", "h - a_1")


def area(need: BarsNeeded, block: tuple[float, float], clause: str) -> Iterator[Step]:
    """Yield the steps from the moment to the bars, block being the stresses [Pa] of concrete and steel."""
    f_c, f_y = block
    mu = abs(need.moment) / (f_c * need.d**2)
    omega = 2 * mu / (1 + (1 - 2 * mu) ** 0.5)
    yield Step("moment over that of the block", "mu", mu, "", FORMULAS["mu"], clause)
    yield Step("depth of the block over d", "omega", omega, "", FORMULAS["omega"], clause)
    area = omega * f_c * need.d / f_y * CM2
    yield Step("bars that the moment needs", "A_s", area, "cm2/m", FORMULAS["A_s"], clause)


def required(need: BarsNeeded, minimum: Iterable[Step]) -> Iterator[Step]:
    """Yield the steps to the least area, and the area that is required, which is not less."""
    *before, last = minimum
    yield from before
    yield Step(last.words, last.symbol, need.minimum * CM2, "cm2/m", last.formula, last.clause)
    yield Step("required area", "A_req", need.area * CM2, "cm2/m", "max(A_s, A_min)")
