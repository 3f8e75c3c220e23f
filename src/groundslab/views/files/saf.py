"""Cases and results as files in the Structural Analysis Format."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.exchange.saf.writing.forces import EdgeForces
from groundslab.exchange.saf.writing.writer import write_model
from groundslab.geometry.plan import Segment
from groundslab.model.model import Model
from groundslab.model.shapes import Circle
from groundslab.results.plate_result import PlateResult
from groundslab.results.results import CombinationResult, Results, results_of

#: Stiffnesses that differ by less than this between combinations are one.
ALIKE = 1e-3
#: Nodes no farther off an edge than this share of the plate's size lie on it: arcs are curves of second order there.
ON_EDGE = 1e-4
#: The plate's fields and what the format calls them, and those of elements, which are there with eccentric beams.
_FIELDS = {"mx": "moment_x", "my": "moment_y", "mxy": "moment_xy", "vx": "shear_x", "vy": "shear_y"}
_ELEMENT_FIELDS = {"nx": "membrane_x", "ny": "membrane_y", "nxy": "membrane_xy"}


def write_saf(case: Model | CombinationResult | Results, path: str | Path) -> tuple[str, ...]:
    """Write a case to a new file in the Structural Analysis Format (SAF), version 2.2.

    Parameters
    ----------
    case : Model, Results or CombinationResult
        The case, or its results: these give section forces along the plate's edges, and soil of Vlasov's kind its k0
        and k1, the means over their combinations.
    path : str or pathlib.Path
        The file to write, a workbook (XLSX); there must be none of that name.

    Returns
    -------
    tuple of str
        What the file does not say, or in another way than the case does.

    Raises
    ------
    InputError
        If there is such a file, or it cannot be written.
    """
    if isinstance(case, Model):
        return write_model(case, path)
    results = results_of(case)
    forces = [along for solved in results.values() for along in _edge_forces(solved)]
    pairs = [
        (solved.constants.k0[0], solved.constants.k1[0])
        for solved in results.results.values()
        if results.model.ground.kind == "vlasov" and len(solved.constants.k0) == 1
    ]
    if not pairs:
        return (*write_model(results.model, path, None, forces), *_no_reactions(results))
    k0, k1 = (sum(values) / len(pairs) for values in zip(*pairs, strict=True))
    left = (*write_model(results.model, path, (k0, k1), forces), *_no_reactions(results))
    ranges = [(min(values), max(values)) for values in zip(*pairs, strict=True)]
    if all(most - least <= ALIKE * most for least, most in ranges):
        return left
    (k0_least, k0_most), (k1_least, k1_most) = ranges
    return (
        *left,
        f"ground: k0 and k1 are means over {len(pairs)} combinations, in which they are {k0_least / 1e6:.4g} to "
        f"{k0_most / 1e6:.4g} MN/m3 and {k1_least / 1e6:.4g} to {k1_most / 1e6:.4g} MN/m",
    )


def _no_reactions(results: Results) -> tuple[str, ...]:
    """Return what is said of the forces of supports, which the format has no place for."""
    return ("supports: the format has no place for their forces",) if results.model.supports else ()


def _edge_forces(result: CombinationResult) -> Iterator[EdgeForces]:
    """Yield the forces along each edge of the only plate, at the corners of the elements that lie there."""
    model, plate = result.solved_model, result.plate
    if len(model.every_plate) > 1:
        return
    values = {name: getattr(plate, field) for name, field in _FIELDS.items()}
    values |= {name: _at_nodes(result, getattr(result.elements, field)) for name, field in _ELEMENT_FIELDS.items()}
    corners = np.unique(plate.elements[:, :4])
    corners = corners[plate.edge_length[corners] > 0]
    edges = model.plate.ring().segments()
    # a circle is one edge of the file, and four arcs here
    groups = [edges] if isinstance(model.plate.outline, Circle) else [(edge,) for edge in edges]
    for number, group in enumerate(groups, start=1):
        nodes, s = _along(group, plate, corners, ON_EDGE * max(model.plate.sides))
        along = {name: field[nodes].tolist() for name, field in values.items()}
        yield EdgeForces(result.combination, number, s.tolist(), along)


def _along(edges: Sequence[Segment], plate: PlateResult, nodes: Integers, near: float) -> tuple[Integers, Array]:
    """Return those of some nodes that lie on edges in their order, and how far along [m].

    Where forces jump two nodes share a place: first comes the one whose elements come first.
    """
    centers = plate.nodes[plate.elements[:, 8]]
    elements = {int(node): row for row, four in enumerate(plate.elements[:, :4]) for node in four}
    rows, low = list[tuple[float, float, int]](), 0.0
    for edge in edges:
        for node in nodes[edge.distance(plate.nodes[nodes]) <= near]:
            x, y = plate.nodes[node]
            part = min(edge.part((float(x), float(y))), 1.0)
            ahead = centers[elements[int(node)]] - (x, y)
            angle = edge.direction(part)
            rows.append((round(low + part * edge.length, 9), float(ahead @ (np.cos(angle), np.sin(angle))), int(node)))
        low += edge.length
    order = sorted(rows)
    return np.array([node for *_, node in order]), np.array([s for s, *_ in order])


def _at_nodes(result: CombinationResult, values: Array | None) -> Array:
    """Return values of elements as means at the nodes, 0 if there are none."""
    total, count = np.zeros(len(result.plate.nodes)), np.zeros(len(result.plate.nodes))
    if values is not None:
        np.add.at(total, result.plate.elements, values[:, None])
        np.add.at(count, result.plate.elements, 1.0)
    return total / np.maximum(count, 1.0)
