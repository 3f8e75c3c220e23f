"""How a code lets bars end and lap: the lengths that develop them, and what else their layout must keep to."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from groundslab.arrays import Array
from groundslab.design.rules.calculation import Step
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results


@dataclass(frozen=True, slots=True)
class EndingBar:
    """A straight bar in tension where it ends in a slab.

    Attributes
    ----------
    diameter : float
        [m].
    axis : float
        Distance of its axis from the nearest face [m].
    spacing : float
        From its axis to that of the next bar [m].
    below, above : float
        Concrete under its axis and over it [m]: bond is poorer of bars with much fresh concrete below.
    """

    diameter: float
    axis: float
    spacing: float
    below: float
    above: float


@dataclass(frozen=True, slots=True)
class BendRule:
    """How bars and links are bent.

    Attributes
    ----------
    mandrel, link_mandrel : callable
        Of a diameter [m]: the least diameter of the mandrel [m] around which bars, and links, are bent.
    hook : callable
        Of a link's diameter [m] and the angle of its bend [deg], at most 90 or more: the least straight length beyond
        the bend [m].
    clauses : str
        Where the code rules them.
    """

    mandrel: Callable[[float], float]
    link_mandrel: Callable[[float], float]
    hook: Callable[[float, float], float]
    clauses: str

    def hook_side(self, diameter: float, angle: float) -> float:
        """Return the length of a link's hook [m], from the outer tangent of its bend to its end."""
        return self.hook(diameter, angle) + self.link_mandrel(diameter) / 2 + diameter


@dataclass(frozen=True, slots=True)
class DetailingRule:
    """How bars end and lap.

    Attributes
    ----------
    anchorage, lap : callable
        Of materials and a bar: the length [m] that develops its design strength, and that of a lap of all bars in one
        section.
    shift : callable
        Of effective depths (n,) and a diameter [m]: how far along the bars moments count (n,) [m].
    least_cover : callable
        Of materials, a layer and a diameter [m]: the cover that it must have [m]; None where the code has none.
    least_clear : callable
        Of materials and a diameter [m]: the clear distance of parallel bars [m].
    spacing : callable
        Of materials and the thickness [m]: the largest spacing [m].
    edge_leg : float
        Legs of bars around free edges over the thickness, at least.
    crack_area : callable or None
        Of all combinations, materials, a layer, a diameter and a spacing [m]: the areas (n,) [m2/m] that such bars need
        at the plate's nodes so that cracks keep their limit, 0 where there is none; inf where no area does.
    crack_spacing : callable or None
        Of materials and a cover [m]: the largest distance of bars for cracks [m], whatever bends the slab.
    anchorage_steps : callable
        Of materials, a bar, and a number n that ends the symbols: the calculation of its anchorage length l_b,n.
    bends : BendRule
        How bars and links are bent.
    clauses : dict
        Where the code rules anchorage, laps, the shift of moments and edges, by these names.
    """

    anchorage: Callable[[Reinforcement, EndingBar], float]
    lap: Callable[[Reinforcement, EndingBar], float]
    shift: Callable[[Array, float], Array]
    least_cover: Callable[[Reinforcement, str, float], float | None]
    least_clear: Callable[[Reinforcement, float], float]
    spacing: Callable[[Reinforcement, float], float]
    edge_leg: float
    crack_area: Callable[[Results, Reinforcement, str, float, float], Array] | None
    crack_spacing: Callable[[Reinforcement, float], float] | None
    anchorage_steps: Callable[[Reinforcement, EndingBar, int], Iterator[Step]]
    bends: BendRule
    clauses: dict[str, str]
