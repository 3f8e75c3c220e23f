"""Columns, piles, zones and walls that pull at the plate are taken as tied to its far face, which is not checked."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.demands.perimeter_loads import punching_columns, punching_piles, rounding
from groundslab.design.demands.zones.thicker_zones import zone_forces
from groundslab.design.rules.check import DesignCheck, some
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.wall_ends import forces_at_ends
from groundslab.messages import Message
from groundslab.results.results import Results


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield which columns, piles, zones and ends of walls pull in any ultimate combination."""
    results, model = ultimate_results(combined), combined.model
    of_kinds = (
        (punching_columns(model), "columns"),
        (punching_piles(model), "piles"),
        (zone_forces(combined), "thicker zones"),
    )
    for forces, many in of_kinds:
        least = rounding(forces, results)
        yield from _tied(
            many, [force.name for force in forces if any(force.acting(result)[0] < -least for result in results)]
        )
    pulled = [name for (_, name), force in forces_at_ends(model, results).items() if force < 0]
    yield from _tied("wall ends", list(dict.fromkeys(pulled)))


def _tied(many: str, names: list[str]) -> Iterator[DesignCheck]:
    """Yield that some are taken as tied, if there are any."""
    if names:
        words = Message(
            "{many} that pull ({names}) are taken as tied to the far face of the slab, which is not checked",
            many=many,
            names=some(names),
        )
        yield DesignCheck(Message("ties of {many}", many=many), "not checked", words)
