"""Plate and ground as VTU files (for ParaView): nine-node cells, array names that carry their units."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from groundslab.design.demands.design_moments import derive_field, fields_of
from groundslab.errors import GroundslabError
from groundslab.fem.mesh import in_space
from groundslab.results.fields import ELEMENT_FIELDS, PLATE_FIELDS, POINT_FIELDS, RANGED_FIELDS

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    import meshio

    from groundslab.arrays import Array, Integers
    from groundslab.results.results import CombinationResult, Results


def plate_mesh(results: CombinationResult) -> meshio.Mesh:
    """Return the plate with its fields at nodes and elements in units of display, and flags (1 or 0) of the nodes."""
    plate = results.plate
    fields, shown = fields_of(plate), RANGED_FIELDS | POINT_FIELDS
    data = {about.name: derive_field(fields, name) * about.scale for name, about in shown.items()} | plate.point_data()
    cells = {
        f"{about.name} (centre, {about.averaged})": getattr(results.elements, name) * about.scale
        for name, about in ELEMENT_FIELDS.items()
        if getattr(results.elements, name) is not None
    }
    return _mesh(plate.nodes, plate.elements, data, cells | {"section": results.elements.section})


def ground_mesh(results: CombinationResult) -> meshio.Mesh:
    """Return the ground with the settlement of each surface, 0 being the top one, and of the plate above.

    Where no plate is, "under the plate" is 0 and "settlement of the plate" is filled with 0.
    """
    ground, plate = results.ground, results.plate
    unit = PLATE_FIELDS["settlement"]
    data = {f"settlement w_{n} [{unit.unit}]": w * unit.scale for n, w in enumerate(ground.settlement)}
    below = match(plate.nodes, ground.nodes)
    data[f"settlement of the plate [{unit.unit}]"] = settlement = np.zeros(len(ground.nodes))
    settlement[below] = plate.settlement * unit.scale
    data["under the plate"] = under = np.zeros(len(ground.nodes), dtype=np.int8)
    under[below] = 1
    return _mesh(ground.nodes, ground.elements, data, {})


def write_plate(results: CombinationResult, path: Path) -> None:
    """Write the plate as a VTU file."""
    plate_mesh(results).write(path, file_format="vtu")


def write_ground(results: CombinationResult, path: Path) -> None:
    """Write the ground as a VTU file."""
    ground_mesh(results).write(path, file_format="vtu")


def write_envelope(combined: Results, path: Path) -> None:
    """Write the envelopes over all combinations at the plate's nodes; where no area of steel is enough it is NaN."""
    from groundslab.design.tables.envelopes import fields_of_envelope

    plate = next(iter(combined.results.values())).plate
    fields = {
        name: np.where(np.isfinite(values), values, np.nan) for name, values in fields_of_envelope(combined).items()
    }
    _mesh(plate.nodes, plate.elements, fields, {}).write(path, file_format="vtu")


def match(some: Array, among: Array) -> Integers:
    """Return for each place in ``some`` (k, 2) its index in ``among`` (n, 2), rounding aside."""
    if np.array_equal(some, among):
        return np.arange(len(some))
    from scipy.spatial import KDTree

    distance, nearest = KDTree(among).query(some)
    if distance.max(initial=0.0) > 1e-9 * np.ptp(among, axis=0).max():
        raise GroundslabError("the plate has nodes that the ground below it lacks")
    return np.asarray(nearest, dtype=np.int64)


def _mesh(
    nodes: Array, elements: Integers, data: dict[str, Array], cells: Mapping[str, Array | Integers]
) -> meshio.Mesh:
    """Return a mesh of VTK's biquadratic quadrilaterals at z = 0, whose order of nodes is ours, with data."""
    import meshio

    by_cell = {name: [values] for name, values in cells.items()}
    return meshio.Mesh(in_space(nodes), [("quad9", elements)], point_data=data, cell_data=by_cell)
