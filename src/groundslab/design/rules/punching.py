"""What codes share about punching: demands, in which way they punch, which are judged, what is said of the rest."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Generic, NamedTuple, Protocol, TypeVar

from groundslab.design.demands.perimeter_loads import PunchingForce, Reach, punching_columns, punching_piles
from groundslab.design.demands.perimeters import SketchedPerimeter
from groundslab.design.demands.zones.thicker_zones import zone_forces
from groundslab.design.rules.calculation import Support
from groundslab.design.rules.check import MOST_NAMED, NO_PERIMETER, SUPPORT_INSIDE, DesignCheck, not_judged
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.wall_ends import loaded_ends
from groundslab.messages import Message, Name, joined
from groundslab.results.results import Results

Heads = tuple[tuple[str, str], ...]
#: A force below this [N] is none.
LEAST_FORCE = 1.0

#: What acts inside a perimeter.
INSIDE: Heads = (
    ("pressure inside", "kN"), ("pressure inside / load", "%"), ("edge line force inside", "kN"),
    ("other loads inside", "kN"),
)  # fmt: skip

#: What of a column's load and of a pile's force punches.
RELIEF = {
    "column": "load + other loads inside - pressure inside",
    "pile": "force + pressure inside + edge line force inside - other loads inside",
    "zone": "load + other loads inside - pressure inside",
}
#: What checks and calculations are called.
PUNCHING: Mapping[Support, str] = {
    "column": "punching",
    "pile": "punching over piles",
    "zone": "punching around thicker zones",
    "wall end": "punching at walls' ends",
}
#: What checks call it, and what they say where nothing pushes.
CALLED: Mapping[Support, tuple[str, str]] = {
    "column": ("columns", "no column pushes or pulls"),
    "pile": ("piles", "no pile pushes or pulls"),
    "zone": ("thicker zones", "no thicker zone pushes or pulls"),
    "wall end": ("wall ends", "no wall pushes or pulls at an end or corner with slab beyond it"),
}
#: Why those on strips that are beams have no perimeter.
ON_BEAM = "it stands on a strip that is a beam"
#: What is said of the worst one if it pulls, or only turns the slab.
PULLS = "; it pulls and is taken as tied to the far face"
TURNS = "; it turns the slab without a force"


class Demand(Protocol):
    """What punches at a column, a pile, a thicker zone or the end of a wall in one combination."""

    @property
    def name(self) -> str:
        """Return what punches."""

    @property
    def combination(self) -> str:
        """Return the combination."""

    @property
    def force(self) -> float:
        """Return its force [N]."""

    @property
    def pulls(self) -> bool:
        """Return whether a column or zone pulls up, or a pile down."""

    @property
    def sketch(self) -> SketchedPerimeter | None:
        """Return the perimeter that governs, if it is drawn."""


AnyDemand = TypeVar("AnyDemand", bound=Demand)


@dataclass(frozen=True, slots=True)
class Demands(Generic[AnyDemand]):
    """The demands of all that punches in one way by combination and name, and why some have none, by name."""

    found: Mapping[tuple[str, str], AnyDemand] = field(default_factory=dict)
    missing: Mapping[str, str] = field(default_factory=dict)
    reach: Reach = field(
        default_factory=dict
    )  # how far from the face punching is checked, the rest is one-way shear [m]


class Aspect(NamedTuple):
    """What is judged about demands: with what name, what stands for each, and the check of those that are judged."""

    name: str
    demands: Iterable[Any]
    used: Callable[[Any], float]
    worst: Callable[[list[Any]], DesignCheck]
    says_missing: bool = True  # whether it says what has no perimeter


def punching_supports(combined: Results) -> Iterator[Support]:
    """Yield what of a case may punch the plate."""
    if combined.model.columns:
        yield "column"
    if punching_piles(combined.model):
        yield "pile"
    if zone_forces(combined):
        yield "zone"
    if loaded_ends(combined.model):
        yield "wall end"


def without_beams(
    combined: Results, demands: Demands[AnyDemand], beyond: float, support: Support
) -> Demands[AnyDemand]:
    """Return the demands of all that punches in one way but for columns and piles whose shear is that of beams.

    These are strips no wider than so many d beyond the face of what stands on them.
    """
    on = _on_beams(combined, beyond, support) if support in ("column", "pile") else set()
    if not on:
        return demands
    off_beams = {key: demand for key, demand in demands.found.items() if key[1] not in on}
    return replace(demands, found=off_beams, missing={**demands.missing, **dict.fromkeys(sorted(on), ON_BEAM)})


def _on_beams(combined: Results, beyond: float, support: Support) -> set[str]:
    """Return the names of columns or piles on strips that are beams no wider than so many d beyond their faces.

    No perimeter so far from the face goes around them: it leaves the beam on both sides, and is shear across it at d.
    """
    steel, strips = combined.model.reinforcement, combined.model.output.beams
    results = ultimate_results(combined)
    names = set[str]()
    if steel is None or not strips or not results:
        return names
    for force in forces_that_punch(combined, support):
        footprint = force.footprint.footprint()
        on = [strip for strip in strips if strip.area().intersects(footprint)]
        if on and all(strip.beyond(footprint) < beyond * force.depth(results[0], steel) for strip in on):
            names.add(force.name)
    return names


def punched_names(combined: Results, demands_of: Callable[[Results, Support], Demands[Any]]) -> set[str]:
    """Return the names of what punches and is judged, by the demands in each way to do so."""
    names = set[str]()
    for support in punching_supports(combined):
        demands = demands_of(combined, support)
        names |= {name for _, name in demands.found} - set(demands.missing)
    return names


def forces_that_punch(combined: Results, support: Support) -> tuple[PunchingForce, ...]:
    """Return the columns, piles or thicker zones that may punch the plate."""
    if support == "zone":
        return zone_forces(combined)
    return punching_piles(combined.model) if support == "pile" else punching_columns(combined.solved_model)


def effective_note(about_center: str) -> str:
    """Return the note on openings, with the properties of the perimeter about its center."""
    return Message(
        "The part between the tangents to an opening does not count; center, moments and {about_center} "
        "are those of the remaining part.",
        about_center=about_center,
    )


def with_way(check: DesignCheck, demands: Mapping[tuple[str, str], Demand]) -> DesignCheck:
    """Return a check that says whether what it is about pulls, or turns without a force, by the demands found."""
    demand = demands[check.combination, check.of]
    way = TURNS if abs(demand.force) < LEAST_FORCE else PULLS if demand.pulls else ""
    return replace(check, words=check.words + way)


def cells_inside(force: float, pressure: float, edge: float, others: float) -> list[float | None]:
    """Return the forces inside [N], in the order of INSIDE; of moments alone there is no share."""
    share = 100 * pressure / force if abs(force) >= LEAST_FORCE else None
    return [pressure / 1e3, share, edge / 1e3, others / 1e3]


class Supported(Protocol):
    """A demand inside whose perimeter another support may stand."""

    @property
    def name(self) -> str:
        """Return what punches."""

    @property
    def supported(self) -> bool:
        """Return whether another support acts inside, of which what it adds is counted, not what it takes off."""


Judged = TypeVar("Judged", bound=Supported)


def judged(demands: Iterable[Judged], used: Callable[[Judged], float]) -> tuple[list[Judged], dict[str, float]]:
    """Return the demands that are judged, and how much the others use, the most by name.

    One that holds with what supports inside add, and without what they take off, holds in any case; of another nobody
    knows, as it is no section of this column or pile alone.
    """
    those: list[Judged] = []
    others: dict[str, float] = {}
    for demand in demands:
        share = used(demand)
        if demand.supported and share > 1:
            others[demand.name] = max(share, others.get(demand.name, 0.0))
        else:
            those.append(demand)
    return those, others


def with_the_rest(
    check: DesignCheck | None,
    name: str,
    called: tuple[str, str, str],
    supported: Mapping[str, float],
    missing: Mapping[str, str],
) -> Iterator[DesignCheck]:
    """Yield a check of those that are judged, and what becomes of the rest.

    Parameters
    ----------
    check : DesignCheck or None
        The check of those that are judged, None if there are none.
    name : str
        What it is called.
    called : tuple of str
        What it is about, such as "columns"; what is said if nothing pushes; and why those have no perimeter whose
        perimeters cut the slab from edge to edge.
    supported : mapping of str to float
        Of those that do not hold so, because of supports inside: demand over resistance, by name.
    missing : mapping of str to str
        Why others have no perimeter, by name.
    """
    many, none, cut = called
    elsewhere, bare = _without_perimeter(many, cut, missing)
    if check is not None:
        yield replace(check, words=joined((check.words, elsewhere), "; ")) if elsewhere else check
    elif elsewhere or not (supported or bare):
        yield DesignCheck(name, "no failure found", elsewhere or none)
    if supported:
        worst = max(supported, key=supported.__getitem__)
        words = Message(
            "{many} ({named}) have another support inside their perimeters; with what it adds and without "
            "what it takes off {worst} uses {supported:.3g} times what resists",
            many=many,
            named=_named(sorted(supported)),
            worst=worst,
            supported=supported[worst],
        )
        yield not_judged(Message("{name} beside supports", name=name), SUPPORT_INSIDE, words, of=worst)
    if bare:
        words = Message(
            "{many} ({named}) have no perimeter; {bare}: {missing}",
            many=many,
            named=_named(bare),
            bare=bare[0],
            missing=missing[bare[0]],
        )
        yield not_judged(Message("{name} without a perimeter", name=name), NO_PERIMETER, words, of=bare[0])


def _without_perimeter(many: str, cut: str, missing: Mapping[str, str]) -> tuple[str, list[str]]:
    """Return what is said of those whose shear is judged elsewhere, and the names of the others without a perimeter."""
    kinds = {why: why if why in (cut, ON_BEAM) else "" for why in missing.values()}
    cuts, on_beams, bare = (
        [name for name, why in sorted(missing.items()) if kinds[why] == kind] for kind in (cut, ON_BEAM, "")
    )
    words = list[str]()
    if cuts:
        template = "perimeters of {many} ({named}) cut the slab from edge to edge, which one-way shear judges"
        words.append(Message(template, many=many, named=_named(cuts)))
    if on_beams:
        template = "{many} ({named}) stand on strips whose shear as beams is judged"
        words.append(Message(template, many=many, named=_named(on_beams)))
    return joined(words, "; ") if words else "", bare


def _named(names: list[str]) -> str:
    """Return the first of some names."""
    return Name(", ".join(names[:MOST_NAMED]) + (" ..." if len(names) > MOST_NAMED else ""))
