"""Columns, piles and zones that pull at the plate are taken as tied to its far face, which no check looks at."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.basis.check import DesignCheck, some
from groundslab.design.basis.combinations import ultimate_results
from groundslab.design.demands.perimeter_loads import punching_columns, punching_piles, rounding
from groundslab.design.demands.zones.thicker_zones import zone_forces
from groundslab.results.results import Results


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield which columns, piles and zones pull in any ultimate combination."""
    results, model = ultimate_results(combined), combined.solved_model
    of_kinds = (
        (punching_columns(model), "columns"),
        (punching_piles(model), "piles"),
        (zone_forces(combined), "thicker zones"),
    )
    for forces, many in of_kinds:
        least = rounding(forces, results)
        names = [force.name for force in forces if any(force.acting(result)[0] < -least for result in results)]
        if names:
            words = (
                f"{many} that pull ({some(names)}) are taken as tied to the far face of the slab, which is not checked"
            )
            yield DesignCheck(f"ties of {many}", "not checked", words)
