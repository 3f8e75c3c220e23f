"""Both limits of walls that stiffen the plate: none of their stiffness, and all of it, on the same mesh."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from groundslab.model.model import Model
from groundslab.results.records import WallLimit
from groundslab.results.results import Results

#: This share of a wall's stiffness is none. The mesh follows the wall all the same.
NONE = 1e-6
#: Fields of the plate that limits are told of.
TOLD = ("settlement", "moment_x", "moment_y", "pressure")


def with_limits(results: Results, model: Model, analyze: Callable[[Model], Results]) -> Results:
    """Return results of a model with the extremes of the plate for both limits of its walls' stiffness.

    `analyze` solves a model on the mesh of the results. A combination that one of the limits refuses has none of it.
    """
    limits: dict[str, list[WallLimit]] = {name: [] for name in results.results}
    for share in (0.0, 1.0):
        walls = tuple(wall if wall.height is None else wall.replace(stiffness=share or NONE) for wall in model.walls)
        results_of_limit = analyze(model.model_copy(update={"walls": walls}))
        for name in limits.keys() & results_of_limit.results.keys():
            limits[name].append((share, tuple(_extremes(results_of_limit, name))))
    told = {name: replace(result, wall_limits=tuple(limits[name])) for name, result in results.results.items()}
    return replace(results, results=told)


def _extremes(results: Results, name: str) -> Iterator[tuple[str, float, float]]:
    """Yield fields of the plate with their least and greatest values in a combination."""
    plate = results.results[name].plate
    for field in TOLD:
        values = getattr(plate, field)
        yield field, float(values.min()), float(values.max())
