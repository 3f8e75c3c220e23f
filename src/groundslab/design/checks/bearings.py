"""What bears the slab without being known: point supports without a size, and edges of the plate that are held.

Punching over a support without a diameter cannot be checked. Supported edges have no limit, and the analysis keeps no
force of theirs: what they carry is the rest of the loads, and along them the plate's shear force. Where that pulls the
plate down, in all or in part, or the loads' resultant does not lie over the plate, no check sees what holds it.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.arrays import Array
from groundslab.design.checks.equilibrium import lies_under
from groundslab.design.demands.loads.column_loads import acting_inside, factored_sums
from groundslab.design.demands.perimeters import outline
from groundslab.design.demands.support_forces import NOTHING, pull_in_part, thirds
from groundslab.design.rules.check import HELD_EDGE, DesignCheck, not_judged, some
from groundslab.design.rules.combinations import solved_results
from groundslab.fem.mesh import sides_on_boundary
from groundslab.geometry.plan import FLAT
from groundslab.messages import Message, Name
from groundslab.model.loads.acting import LineForce, PointForce
from groundslab.model.loads.load_cases import SERVICEABILITY
from groundslab.model.model import Model
from groundslab.model.plate import Edges
from groundslab.model.supports import LineSupport
from groundslab.results.results import CombinationResult, Results

#: Loads within this share of the plate's largest side of an edge stand on it.
ON_EDGE = 1e-6
PUNCHING, HELD = "punching over supports", "edges that hold down"


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield which supports have no size, that supported edges are not checked, and how much they hold down."""
    model = combined.model
    bare = [
        support.name or Message("support {number}", number=number)
        for number, support in enumerate(model.supports, start=1)
        if not isinstance(support, LineSupport) and support.diameter is None
    ]
    if bare and model.reinforcement is not None:
        words = Message("punching over {names} is not checked, as they have no diameter", names=some(bare))
        yield DesignCheck(PUNCHING, "not checked", words)
    if not _has_held_edges(model):
        return
    results = [result for result in solved_results(combined) if result.limit_state not in SERVICEABILITY]
    pulls = [(-_carried_by_edges(result), result) for result in results]
    parts = list(_pulls_in_part(results))
    pull, worst = max(pulls, key=lambda pulling: pulling[0], default=(0.0, None))
    if worst is not None and pull > NOTHING * abs(worst.certificate.load):
        words = Message(
            'supported edges hold the plate down with {pull:.4g kN} in "{combination}"',
            pull=pull / 1e3,
            combination=Name(worst.combination),
        )
        yield not_judged(HELD, HELD_EDGE, words, combination=worst.combination)
    elif parts and max(parts)[0] > 0:
        pull, name = max(parts)
        words = Message(
            'supported edges hold the plate down in part, with {pull:.4g kN} in "{name}"',
            pull=pull / 1e3,
            name=Name(name),
        )
        yield not_judged(HELD, HELD_EDGE, words, combination=name)
    elif tilting := [result.combination for result in results if _tilts_without_edges(result)]:
        words = Message("without its supported edges the plate tilts in {names}", names=some(tilting))
        yield not_judged(HELD, HELD_EDGE, words, combination=tilting[0])
    else:
        yield DesignCheck(HELD, "not checked", "what supported edges of the plate carry is not checked")


def _has_held_edges(model: Model) -> bool:
    """Return whether any edge of the plate is supported."""
    return model.plate.support != "free" or model.plate.edges != Edges()


def _carried_by_edges(results: CombinationResult) -> float:
    """Return what the plate's edges push up [N]: what neither ground nor supports carry of the loads."""
    ground = float(results.plate.contact_force.sum())
    return results.certificate.load - ground - sum(support.total for support in results.supports)


def _pulls_in_part(results: list[CombinationResult]) -> Iterator[tuple[float, str]]:
    """Yield the force [N] by which parts of supported edges hold the plate down, in each combination."""
    if not results:
        return
    parts = thirds(_held_lines(results[0].model))
    has_local_loads = any(isinstance(shape, LineForce | PointForce) for _, shape in results[0].solved_model.acting)
    on_parts = [_loads_on(results[0], part) if has_local_loads else {} for part in parts]
    for result in results:
        plate = result.plate
        sides = plate.nodes[sides_on_boundary(plate.elements)]
        at_once = np.array([factored_sums(result, sums)[0] for sums in on_parts])
        yield pull_in_part(parts, sides[:, 2], _pushed_up(result, parts, sides), at_once), result.combination


def _loads_on(results: CombinationResult, part: Array) -> dict[str, Array]:
    """Return force and first moments (3,) of the loads that stand on a part (2, 2) [m] of an edge, by load case."""
    from shapely import LineString

    width = ON_EDGE * max(results.model.plate.sides)
    return acting_inside(results, LineString(part).buffer(width, cap_style="flat"), ())


def _held_lines(model: Model) -> Array:
    """Return the straight pieces (l, 2, 2) [m] of the plate's supported edges, arcs as chords."""
    plate = model.plate
    (x0, x1, y0, y1), edges = plate.bounds, plate.edges
    ring = np.array(plate.ring().polygon(FLAT * max(plate.sides)).exterior.coords)
    lines = np.stack([ring[:-1], ring[1:]], axis=1)
    if plate.support != "free":
        return lines
    near = FLAT * max(plate.sides)
    held = np.zeros(len(lines), dtype=bool)
    for axis, at, support in ((0, x0, edges.left), (0, x1, edges.right), (1, y0, edges.bottom), (1, y1, edges.top)):
        held |= (np.abs(lines[:, :, axis] - at) <= near).all(axis=1) & (support != "free")
    return lines[held]


def _pushed_up(results: CombinationResult, lines: Array, sides: Array) -> Array:
    """Return what supported edges push up (s,) [N] along the sides (s, 3, 2) [m] of elements on them, 0 elsewhere.

    That is the shear force into the plate, by Simpson's rule.
    """
    from shapely import distance, linestrings, points, union_all

    plate = results.plate
    on_line = distance(points(sides[:, 2]), union_all(linestrings(lines))) <= FLAT * max(results.model.plate.sides)
    along = sides[:, 1] - sides[:, 0]
    nodes = sides_on_boundary(plate.elements)
    q = np.stack([plate.shear_x[nodes], plate.shear_y[nodes]], axis=2)
    # the normal to the right of a side, which elements have to its left
    across = q[:, :, 0] * along[:, None, 1] - q[:, :, 1] * along[:, None, 0]
    return np.where(on_line, -(across @ np.array([1.0, 1.0, 4.0])) / 6, 0.0)


def _tilts_without_edges(results: CombinationResult) -> bool:
    """Return whether the loads' resultant does not lie over the plate, so that pressure under it cannot balance it."""
    under = outline(results.plate).convex_hull
    sums = factored_sums(results, acting_inside(results, under, ()))
    return not lies_under(under, sums, abs(results.certificate.load))
