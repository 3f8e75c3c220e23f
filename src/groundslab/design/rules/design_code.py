"""What a design code consists of: the rules by which a case's slab is designed, each a function or a few of them.

A code is a folder with these rules and one line in `codes.CODES`. Bending is needed; of what else a code has no rule,
the checks say so.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from groundslab.arrays import Array, Flags
from groundslab.design.demands.perimeter_loads import Reach
from groundslab.design.demands.perimeters import SketchedPerimeter
from groundslab.design.rules.bending import BendingRule
from groundslab.design.rules.bending_steps import BarsNeeded
from groundslab.design.rules.calculation import Step, Support
from groundslab.design.rules.check import NO_RULE, DesignCheck, not_judged
from groundslab.design.rules.detailing_rule import DetailingRule
from groundslab.design.rules.punching import Aspect, Demands, Heads, without_beams
from groundslab.design.rules.punching_links.demand import LinkDemand
from groundslab.design.rules.shear_demand import ShearDemand
from groundslab.design.rules.webs import Flange, Web, WebNeed
from groundslab.design.rules.wide_beam import Cut
from groundslab.messages import Message, Name
from groundslab.model.design.laid_bars import LaidBars
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import CombinationResult, Results


class Calculation(NamedTuple):
    """The steps of a check: what it is of, its combination, and the perimeter and the place, if it has them."""

    of: str
    combination: str
    steps: tuple[Step, ...]
    perimeter: SketchedPerimeter | None = None
    place: tuple[float, float] | None = None  # [m]


@dataclass(frozen=True, slots=True)
class Clauses:
    """Where a code rules what the checks of every code cite."""

    bars: str  # of bars that bending needs, the least ones among them
    least_bars: str
    held_bars: str  # of links that hold bars in compression


class ShearWords(NamedTuple):
    """What checks of one-way shear call the force and what needs no links, and where the code rules what."""

    force: str
    without_links: str
    clause: str  # of what needs no links
    links: str
    struts: str
    cited: str  # by the check
    at_support: str = ""  # of struts up to what presses there
    thin: str = ""  # of the least thickness of slabs with links
    link_distance: str = ""  # of how far legs of links may be from each other


@dataclass(frozen=True, slots=True)
class ShearRule:
    """One-way shear.

    Attributes
    ----------
    words : ShearWords
        Symbols and clauses.
    resistance : callable
        Of materials, a limit state, depths d (n,) [m] and ratios of bars (n,): what needs no links (n,) [N/m].
    links : callable
        Of materials and a demand: links per area of the plan, at least the least ones [m2/m2]; inf where struts fail.
    steps : callable
        Of materials and a demand: its calculation.
    most_ratio : float
        The largest ratio of bars that counts.
    least_share : float
        Bars that lie in each layer in any case, over the thickness.
    least_thickness : float
        Of slabs with links [m].
    struts_at_faces : bool
        Whether struts are checked up to what presses there, too.
    reach : callable or None
        Of all combinations: how far from the face of columns and piles punching is checked instead [m]; 2 d where it
        does not say.
    beyond_links : float
        So far beyond the outer links against punching that is checked instead, over d.
    cuts : callable or None
        Of a combination's results and materials: cuts beside columns over which means are checked, too.
    link_distance : callable or None
        Of materials and a demand: how far legs of links may be from each other [m], as the last step to it, by the
        thickness h and the depth d; None where the code's rule is not known here.
    """

    words: ShearWords
    resistance: Callable[[Reinforcement, str, Array, Array], Array]
    links: Callable[[Reinforcement, ShearDemand], float]
    steps: Callable[[Reinforcement, ShearDemand], Iterator[Step]]
    most_ratio: float
    least_share: float = 0.0
    least_thickness: float = 0.0
    struts_at_faces: bool = False
    reach: Callable[[Results], Reach] | None = None
    beyond_links: float = 1.5
    cuts: Callable[[CombinationResult, Reinforcement], Iterator[Cut]] | None = None
    link_distance: Callable[[Reinforcement, ShearDemand], Step] | None = None


class TensionBars(NamedTuple):
    """Bars in tension that a column or pile needs along both axes."""

    name: str  # of the column or pile
    face: str  # "bottom" or "top"
    area: float  # [m2/m]
    reach: float  # from its faces [m]


@dataclass(frozen=True, slots=True)
class PunchingRule:
    """Punching, or two-way shear, at columns, over piles, around thicker zones, and at ends and corners of walls.

    Attributes
    ----------
    demands : mapping of str to callable
        Of all combinations: what punches in each of these ways.
    used : callable
        Of a demand and materials: its share of what resists it without links.
    aspects : callable
        Of the way, what punches so, and materials: what is judged.
    steps : callable
        Of a demand, materials and the way: its calculation.
    heads, cells, notes : callable
        What tables have of it: of the way, the columns; of a demand, materials and the way, its cells; of the way and
        materials, what a reader must know.
    cut : str
        Why those have no perimeter that one-way shear judges.
    extremes : tuple
        Those columns of a table whose extremes are wanted.
    with_errors : tuple of str
        Those whose values have discretization errors, besides what acts inside a perimeter.
    links : callable or None
        Of all combinations, materials, the way and what punches so: what needs links, with their perimeters, or why
        links do not help.
    bars_for_links : callable or None
        Of materials, the way and what punches so: the bars in tension with which links suffice where they do not yet.
    depth : str
        The symbol of the effective depth.
    beyond_faces : float
        How far from a face, over d, the nearest perimeter is that a beam under a column must have room for.
    """

    demands: Mapping[Support, Callable[[Results], Demands[Any]]]
    used: Callable[[Any, Reinforcement], float]
    aspects: Callable[[Support, Demands[Any], Reinforcement], Iterable[Aspect]]
    steps: Callable[[Any, Reinforcement, Support], Iterable[Step]]
    heads: Callable[[Support], Heads]
    cells: Callable[[Any, Reinforcement, Support], list[float | None]]
    notes: Callable[[Support, Reinforcement], tuple[str, ...]] = lambda *_: ()
    cut: str = ""
    extremes: Heads = ()
    with_errors: tuple[str, ...] = ()
    links: Callable[[Results, Reinforcement, Support, Demands[Any]], Iterator[LinkDemand]] | None = None
    bars_for_links: Callable[[Reinforcement, Support, Demands[Any]], Iterator[TensionBars]] | None = None
    depth: str = "d"
    beyond_faces: float = 1.0

    def demands_of(self, combined: Results, support: Support) -> Demands[Any]:
        """Return what punches in one way, but for what stands on strips that are beams."""
        return without_beams(combined, self.demands[support](combined), self.beyond_faces, support)


class TensionZone(NamedTuple):
    """What of the sections (k,) of a beam is in tension before it cracks, one face of it."""

    d: Array  # (k,): effective depth [m]
    modulus: Array  # (k,): section modulus of the whole section for that face [m3]
    mean_width: Array  # (k,): of the web alone where the flange is compressed [m]
    web: float  # width of the web [m]
    face: float  # width of the face in tension, of a flange or the web [m]
    h: Array  # (k,): height of the section [m]
    depth: Array  # (k,): of the zone [m]
    flange: Array  # (k,): thickness of the flange [m]; infinite without one
    diameter: float  # of the bars [m]

    def at(self, place: int) -> TensionZone:
        """Return it at one place alone."""
        one_place = slice(place, place + 1)
        cut = {name: getattr(self, name)[one_place] for name in ("d", "modulus", "mean_width", "h", "depth", "flange")}
        return self._replace(**cut)


@dataclass(frozen=True, slots=True)
class FlangeRule:
    """The shear between a web and its flange.

    Attributes
    ----------
    bars : callable
        Of materials, a limit state, shear stresses (n,) [Pa] and where the flange is compressed (n,): bars across the
        web over the flange's thickness (n,) [m2/m per m]; inf where none help.
    limit : callable
        Of materials and a limit state: the largest stress that bars help against [Pa].
    clauses : str
        Where the code rules it.
    steps : callable
        Of materials, a limit state and the flange at one place: the calculation from the stress to the bars.
    """

    bars: Callable[[Reinforcement, str, Array, Flags], Array]
    limit: Callable[[Reinforcement, str], float]
    clauses: str
    steps: Callable[[Reinforcement, str, Flange], Iterator[Step]]


@dataclass(frozen=True, slots=True)
class BeamRule:
    """Beams and ribs, beyond what they share with slabs.

    Attributes
    ----------
    minimum : callable
        Of materials, a limit state and a zone in tension: the least bars in it (k,) [m2].
    bars_by_steps, minimum_by_steps : callable
        Of materials, what bars need per meter of a width and a limit state: the steps from the moment to the area; of
        materials, a limit state and a zone in tension at one place: those to its least bars.
    web : callable
        Of materials, a limit state and webs (k,): the links and the bars along them that shear and torsion need.
    web_steps : callable
        Likewise of one web: the calculation of these.
    clauses : str
        Where the code rules bars and their least area.
    web_clauses : str
        Where it rules links and torsion.
    struts_at_faces : bool
        Whether struts bear the shear force at a support's face, where links are those at d from it.
    flange : FlangeRule
        The shear between web and flange.
    cracks : callable
        Of materials: what of the cracks of beams is not designed here; empty where nothing is asked of them.
    link_distances : callable or None
        Of materials, a limit state, webs (k,) and the share used of what their struts bear: how far links, and legs of
        a link, may be from each other (k,) [m]; None where the code's rule is not known here.
    distance_clauses : str
        Where it rules these.
    distance_steps : callable or None
        Of materials, a limit state, one web and the same under the forces that its struts bear: the calculation of how
        far links may be from each other, and legs of a link.
    """

    minimum: Callable[[Reinforcement, str, TensionZone], Array]
    bars_by_steps: Callable[[Reinforcement, BarsNeeded, str], Iterator[Step]]
    minimum_by_steps: Callable[[Reinforcement, str, TensionZone], Iterator[Step]]
    web: Callable[[Reinforcement, str, Web], WebNeed]
    web_steps: Callable[[Reinforcement, str, Web], Iterator[Step]]
    clauses: str
    web_clauses: str
    struts_at_faces: bool
    flange: FlangeRule
    cracks: Callable[[Reinforcement], str]
    link_distances: Callable[[Reinforcement, str, Web, Array], tuple[Array, Array]] | None = None
    distance_clauses: str = ""
    distance_steps: Callable[[Reinforcement, str, Web, Web], tuple[Sequence[Step], Sequence[Step]]] | None = None


@dataclass(frozen=True, slots=True)
class WallRule:
    """Walls with a height.

    Attributes
    ----------
    least : callable or None
        Of a thickness [m]: the least bars upright and level, both faces together [m2/m].
    most : callable
        Of materials, a limit state, a thickness and a height [m]: the largest shear force that struts bear [N].
    steps : callable
        Of the same: the calculation of this force, V_max, from the thickness t and the height h.
    clauses : str
        Where the code rules these.
    """

    least: Callable[[float], tuple[float, float]] | None
    most: Callable[[Reinforcement, str, float, float], float]
    steps: Callable[[Reinforcement, str, float, float], Iterator[Step]]
    clauses: str


@dataclass(frozen=True, slots=True)
class DesignCode:
    """The rules of a code.

    Attributes
    ----------
    name : str
        What checks and tables call it, with its edition if that matters.
    clauses : Clauses
        What they cite.
    bending : callable
        Of the case's materials and a limit state: how sections find their bars.
    shear : ShearRule or None
        One-way shear.
    punching : PunchingRule or None
        Columns, piles, thicker zones and ends of walls that punch the plate.
    bars_by_steps : callable or None
        Of materials, what a layer of bars needs, and a limit state: the calculation of it.
    beams : BeamRule or None
        Beams and ribs.
    walls : WallRule or None
        Walls with a height.
    bars : callable or None
        Of all combinations, materials and laid bars by layer: the checks of these bars besides their area.
    detailing : DetailingRule or None
        How bars end and lap, and what else a proposal of bars keeps to.
    fire : callable or None
        Of results and materials: the checks of the case's class of resistance to fire, none without one.
    remarks : callable or None
        Of all combinations and materials: what puts a verdict by the code in doubt.
    """

    name: str
    clauses: Clauses
    bending: Callable[[Reinforcement, str], BendingRule]
    bars_by_steps: Callable[[Reinforcement, BarsNeeded, str], Iterator[Step]] | None = None
    shear: ShearRule | None = None
    punching: PunchingRule | None = None
    beams: BeamRule | None = None
    walls: WallRule | None = None
    bars: Callable[[Results, Reinforcement, dict[str, LaidBars]], Iterator[DesignCheck]] | None = None
    detailing: DetailingRule | None = None
    fire: Callable[[CombinationResult, Reinforcement], Iterator[DesignCheck]] | None = None
    remarks: Callable[[Results, Reinforcement], Iterator[DesignCheck]] | None = None


def no_rule(code: DesignCode, what: str) -> DesignCheck:
    """Return the check of what a code has no rule for here: it is open."""
    return not_judged(what, NO_RULE, Message("{name} has no rule for it here", name=Name(code.name)))
