"""What codes share about punching: checks of what is not judged by it, the columns and notes of its tables."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Protocol, TypeVar

from groundslab.design.rules.check import MOST_NAMED, NO_PERIMETER, SUPPORT_INSIDE, DesignCheck, not_judged
from groundslab.messages import Message, Name, joined
from groundslab.model.design.reinforcement import Reinforcement

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
#: What is said of the worst one if it pulls, or only turns the slab.
PULLS = "; it pulls and is taken as tied to the far face"
TURNS = "; it turns the slab without a force"
#: What becomes of it, then.
PULLED = (
    "Where a column or zone pulls up, or a pile down, it punches the other way: what acts inside has the opposite "
    "sign, and d is less the mean distance of the bars' axes at the other face. It is taken as tied to the far face."
)
#: What beams do to it.
BEAMS = "Other loads inside include the shear forces of beams across the perimeter, upwards negative."
#: What counts of a perimeter that leaves a thicker zone.
THINNER = "Where the slab is thinner than that, a length of a perimeter counts by the share that it resists there."
#: The effective depth of columns, of piles and around thicker zones.
DEPTH = {
    "column": "d is the least thickness under the column less the mean distance of the bottom bars' axes.",
    "pile": "d is the least thickness over the pile less the mean distance of the top bars' axes.",
    "zone": "d is the largest thickness at the border of the zone less the mean distance of the bottom bars' axes.",
}
#: What is around a zone.
AROUND = "Perimeters run around the zone, or around its hull if it has reentrant corners, by their distance from it."
_ONE_EDGE = (
    "The line force of the ground along the plate's edge inside is not a pressure: it does not relieve punching, "
    "unless the case sets line_force_relieves; where it pulls, it is added."
)
_RELIEVES = (
    "The line force of the ground along the plate's edge inside is subtracted like the pressure inside, as the case "
    "sets line_force_relieves."
)
_OVER_EDGE = (
    "The line force of the ground along the plate's edge inside adds to the punching force, as the pressure does."
)


@dataclass(frozen=True, slots=True)
class PunchingColumns:
    """The columns that a table has of punching, their cells by combination and name, and what a reader must know."""

    heads: Heads
    cells: Callable[[str, str], list[float | None]]
    notes: tuple[str, ...]


#: Where nothing is known of punching.
NO_COLUMNS = PunchingColumns((), lambda _, __: [], ())


def effective_note(about_center: str) -> str:
    """Return the note on openings, with the properties of the perimeter about its center."""
    return Message(
        "The part between the tangents to an opening does not count; center, moments and {about_center} "
        "are those of the remaining part.",
        about_center=about_center,
    )


def edge_note(steel: Reinforcement, support: str) -> str:
    """Return the effect of the line force along the plate's edge in words, at a "column", "pile" or "zone"."""
    if support == "pile":
        return _OVER_EDGE
    return _RELIEVES if steel.line_force_relieves else _ONE_EDGE


def with_way(check: DesignCheck, found: Mapping[tuple[str, str], Pulling]) -> DesignCheck:
    """Return a check that says whether what it is about pulls, or turns without a force, by the demands found."""
    demand = found[check.combination, check.of]
    way = TURNS if abs(demand.force) < LEAST_FORCE else PULLS if demand.pulls else ""
    return replace(check, words=check.words + way)


def pulled_notes(demands: Iterable[Pulling]) -> tuple[str, ...]:
    """Return what becomes of columns, piles or zones that pull as a note, if any does."""
    return (PULLED,) if any(demand.pulls for demand in demands) else ()


def missing_notes(missing: Mapping[str, str], support: str) -> tuple[str, ...]:
    """Return why some have no perimeter, by their names, as notes."""
    if support == "zone":
        return tuple(
            Message("no punching around {name}: {why}", name=Name(name), why=why) for name, why in missing.items()
        )
    return tuple(
        Message("no punching of {support} {name}: {why}", support=support, name=Name(name), why=why)
        for name, why in missing.items()
    )


def cells_inside(force: float, pressure: float, edge: float, others: float) -> list[float | None]:
    """Return the forces inside [N], in the order of INSIDE; of moments alone there is no share."""
    share = 100 * pressure / force if abs(force) >= LEAST_FORCE else None
    return [pressure / 1e3, share, edge / 1e3, others / 1e3]


class Pulling(Protocol):
    """A demand of what may pull."""

    @property
    def force(self) -> float:
        """Return its force [N]."""

    @property
    def pulls(self) -> bool:
        """Return whether a column or zone pulls up, or a pile down."""


class Supported(Protocol):
    """A demand inside whose perimeter another support may stand."""

    @property
    def name(self) -> str:
        """Return what punches."""

    @property
    def supported(self) -> bool:
        """Return whether another support acts inside, of which what it adds is counted, not what it takes off."""


Demand = TypeVar("Demand", bound=Supported)


def judged(demands: Iterable[Demand], used: Callable[[Demand], float]) -> tuple[list[Demand], dict[str, float]]:
    """Return the demands that are judged, and how much the others use, the most by name.

    One that holds with what supports inside add, and without what they take off, holds in any case; of another nobody
    knows, as it is no section of this column or pile alone.
    """
    those: list[Demand] = []
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
    cuts, bare = ([each for each, why in sorted(missing.items()) if (why == cut) == is_cut] for is_cut in (True, False))
    one_way = (
        Message(
            "perimeters of {many} ({named}) cut the slab from edge to edge, which one-way shear judges",
            many=many,
            named=_named(cuts),
        )
        if cuts
        else ""
    )
    if check is not None:
        yield replace(check, words=joined((check.words, one_way), "; ")) if one_way else check
    elif one_way or not (supported or bare):
        yield DesignCheck(name, "no failure found", one_way or none)
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


def _named(names: list[str]) -> str:
    """Return the first of some names."""
    return Name(", ".join(names[:MOST_NAMED]) + (" ..." if len(names) > MOST_NAMED else ""))
