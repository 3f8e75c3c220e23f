"""What calculations of bars have in common: the moment, the block, the area, the least area."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from groundslab.design.demands.support_moments import MomentOrigin
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
    origin: MomentOrigin | None = None  # what the moment follows from
    laid: float | None = None  # area of the bars that are laid there [m2/m]

    @property
    def d(self) -> float:
        """Return the effective depth [m]."""
        return self.thickness - self.axis


def depth(need: BarsNeeded) -> Iterator[Step]:
    """Yield the design moment, the thickness, the distance of the bars' axis from the face, and the depth."""
    yield from _moment(need)
    yield Step("thickness", "h", need.thickness, "m")
    yield Step("distance of the bars' axis from the face", "a_1", need.axis, "m")
    yield Step("effective depth", "d", need.d, "m", "h - a_1")


def _moment(need: BarsNeeded) -> Iterator[Step]:
    """Yield the design moment: by its mean over a width, or by the plate's moments at the place."""
    m, origin = abs(need.moment) / MEGA, need.origin
    if origin is None:
        yield Step("design moment per width, by Wood", "m", m, "MNm/m")
        return
    if origin.width is not None:
        yield Step("length of the line", "b", origin.width, "m")
        yield Step("design moments by Wood along a line across the bars, their mean", "m", m, "MNm/m")
        return
    yield from _by_wood(need, origin)


def _by_wood(need: BarsNeeded, origin: MomentOrigin) -> Iterator[Step]:
    """Yield the design moment by the plate's moments: strips across the bars take a part of the twist, or need no bars.

    Signs are those of tension at the bottom; at the top all are turned (Wood 1968, Armer 1968).
    """
    m_a, m_b, m_xy = origin.along / MEGA, origin.across / MEGA, origin.twisting / MEGA
    yield Step("moment of strips along the bars, positive with tension at the bottom", "m_a", m_a, "MNm/m")
    yield Step("moment of strips across the bars", "m_b", m_b, "MNm/m")
    yield Step("twisting moment", "m_xy", m_xy, "MNm/m")
    sign, of_across = (1.0, "m_b + abs(m_xy)") if need.moment >= 0 else (-1.0, "abs(m_xy) - m_b")
    m_c, words = sign * m_b + abs(m_xy), "moment of strips across with the twist; negative, they need no bars there"
    yield Step(words, "m_c", m_c, "MNm/m", of_across)
    share, formula = (abs(m_xy), "abs(m_xy)") if m_c >= 0 else (m_xy**2 / abs(m_b), "m_xy^2 / abs(m_b)")
    yield Step("what the twist adds along the bars", "m_t", share, "MNm/m", formula)
    formula = "m_t + m_a" if sign > 0 else "m_t - m_a"
    yield Step("design moment per width, by Wood", "m", abs(need.moment) / MEGA, "MNm/m", formula)


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
    if need.laid:
        yield Step("area of the bars that are laid", "A_l", need.laid * CM2, "cm2/m")
        yield Step("share used", "eta_A", need.area / need.laid, "", "A_req / A_l")
