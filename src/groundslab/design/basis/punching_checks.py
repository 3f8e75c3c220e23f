"""What checks of punching of all codes share: those that end without a verdict, and those that are one-way shear."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Protocol, TypeVar

from groundslab.design.basis.check import DesignCheck, not_judged
from groundslab.design.basis.unjudged import MOST_NAMED, NO_PERIMETER, SUPPORT_INSIDE


class Supported(Protocol):
    """A demand inside whose perimeter another support may stand."""

    @property
    def name(self) -> str:
        """Return what punches."""

    @property
    def supported(self) -> bool:
        """Return whether another support inside takes off a part, which is not counted."""


Demand = TypeVar("Demand", bound=Supported)


def judged(demands: Iterable[Demand], used: Callable[[Demand], float]) -> tuple[list[Demand], dict[str, float]]:
    """Return the demands that are judged, and how much the others use, the most by name.

    One that holds without what a support inside takes off holds with it, too; of another nobody knows.
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
        Of those that hold only with what supports inside take off: demand over resistance without that, by name.
    missing : mapping of str to str
        Why others have no perimeter, by name.
    """
    many, none, cut = called
    cuts, bare = ([each for each, why in sorted(missing.items()) if (why == cut) == is_cut] for is_cut in (True, False))
    one_way = (
        f"perimeters of {many} {_named(cuts)} cut the slab from edge to edge, which one-way shear judges"
        if cuts
        else ""
    )
    if check is not None:
        yield replace(check, words=f"{check.words}; {one_way}") if one_way else check
    elif one_way or not (supported or bare):
        yield DesignCheck(name, "no failure found", one_way or none)
    if supported:
        worst = max(supported, key=supported.__getitem__)
        words = (
            f"{many} {_named(sorted(supported))} have another support inside their perimeters; without what it takes "
            f"off {worst} uses {supported[worst]:.3g} times what resists"
        )
        yield not_judged(f"{name} beside supports", SUPPORT_INSIDE, words, of=worst)
    if bare:
        words = f"{many} {_named(bare)} have no perimeter; {bare[0]}: {missing[bare[0]]}"
        yield not_judged(f"{name} without a perimeter", NO_PERIMETER, words, of=bare[0])


def _named(names: list[str]) -> str:
    """Return the first of some names."""
    return ", ".join(names[:MOST_NAMED]) + (" ..." if len(names) > MOST_NAMED else "")
