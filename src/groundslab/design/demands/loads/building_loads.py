"""What the building above adds to loads, as load cases of its own: unit forces and couples on its bases."""

from __future__ import annotations

from collections.abc import Sequence

from groundslab.geometry.plan import Ring
from groundslab.model.loads.acting import AreaPressure, PointForce
from groundslab.model.model import Model
from groundslab.model.structure.building import Base, bases
from groundslab.results.results import CombinationResult

#: What the names of these cases begin with, as none of a case file can.
BUILDING = "\0"
#: Components of what acts on a base, and the part of its results that says how much of each.
COMPONENTS = ("force", "moment_x", "moment_y")
#: Chords of arcs of footprints are at most this share of the plate off.
CHORD = 1e-4


def case_of(name: str, component: str) -> str:
    """Return the case of a unit force or couple on a base, which no case of a file can be called."""
    return f"{BUILDING}{component} of {name}"


def unit_loads(model: Model) -> dict[str, tuple[tuple[str, AreaPressure], ...]]:
    """Return the unit force and couples on each base by its name, in the order of COMPONENTS, each with its case."""
    if model.building is None:
        return {}
    every = bases(model.building, model.columns, model.walls, model.every_plate, CHORD * max(model.sides))
    return {base.name: _on(base) for base in every}


def _on(base: Base) -> tuple[tuple[str, AreaPressure], ...]:
    """Return the unit force and couples on a base as pressures on its footprint."""
    part = base.footprint
    rings = tuple(_ring(line.coords[:-1]) for line in (part.exterior, *part.interiors))
    units = (1.0, (0.0, 0.0)), (0.0, (1.0, 0.0)), (0.0, (0.0, 1.0))
    return tuple(
        (case_of(base.name, component), AreaPressure(rings, PointForce(base.place, P, M).pressure(part)))
        for component, (P, M) in zip(COMPONENTS, units, strict=True)
    )


def _ring(places: Sequence[tuple[float, ...]]) -> Ring:
    """Return the curve around straight edges between places."""
    return Ring(tuple((x, y) for x, y in places), (0.0,) * len(places))


def building_factors(results: CombinationResult) -> dict[str, float]:
    """Return the factors of these cases in a combination: what its bases take."""
    return {
        case_of(base.name, component): float(getattr(base, component).sum())
        for base in results.bases
        for component in COMPONENTS
    }
