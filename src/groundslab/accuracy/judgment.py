"""The largest discretization error of the values that are judged: extremes of fields and beams, forces of supports.

Errors are judged against what governs: the largest displacement, principal moment, shear force, pressure and support
force of the slab, moment and shear force of beams, over all combinations. Of what is nothing beside these nothing is
asked. Where moments and shear forces have no limit as the mesh is refined, their means are judged (`singular_places`);
where other values have none, they are not (`singularities`).
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass, field, fields, replace
from operator import attrgetter
from typing import TYPE_CHECKING

import numpy as np

from groundslab.accuracy.values import add_errors, error_of_contact_share, estimate_error, line_of_lift_off
from groundslab.arrays import Array, Flags, made_once_by
from groundslab.results.fields import PLATE_FIELDS, extreme_node, place_of
from groundslab.results.records import BeamResult, LargestValues

if TYPE_CHECKING:
    from groundslab.results.results import CombinationResult

#: Fields whose largest and smallest values are judged, or their largest size, and against what.
BOTH_SIGNS = {"settlement": "displacement", "pressure": "pressure", "moment_x": "moment", "moment_y": "moment"}
SIZES = {"gap": "displacement", "moment_xy": "moment", "shear_x": "shear", "shear_y": "shear"}
AGAINST = BOTH_SIGNS | SIZES
#: Forces of beams are judged against this share of those of a strip of slab as wide as it is thick, if that is more: in
#: a ring under a round tank nothing is left of the shear force but noise.
OF_STRIP = 0.1
#: Values from this share of the largest on may be the largest on the next mesh, as elements become smaller around it.
NEXT = 0.9
#: Errors of values on a coarse mesh, as a share of the largest, where nothing tells them.
USUAL = 0.1
#: The name of the largest shear force of a beam, and of the share of the plate's area that touches the ground.
BEAM_SHEAR, CONTACT = "shear force of beams", "area in contact"


@dataclass(frozen=True, slots=True)
class JudgedValue:
    """An error as a share of what governs, the value [SI], its name and place [m], and the error itself [SI].

    Around are the places (p, 2) of all nodal values that may exceed it by at least half as much, none of other values.
    Coarse are these and, of fields, those that come next: nearly as large, and at least half as far off. The sign is -1
    of a smallest value.
    """

    share: float
    value: float
    label: str
    place: tuple[float, float] | None
    around: Array = field(default_factory=lambda: np.zeros((0, 2)), compare=False, repr=False)
    sign: int = 1
    error: float = 0.0
    coarse: Array = field(default_factory=lambda: np.zeros((0, 2)), compare=False, repr=False)


def judge(results: CombinationResult) -> list[JudgedValue]:
    """Return the judged values with their errors, the largest first; none without a coarser mesh to compare."""
    if results.comparison is None:
        return []
    judged_before = _judged_once(results)
    largest = results.largest or find_largest([results])
    values = ((getattr(largest, against), value) for against, value in judged_before)
    judged = (replace(value, share=value.share / size, error=value.share) for size, value in values if size > 0)
    return sorted(judged, key=lambda value: -value.share)


def guess(results: CombinationResult) -> list[JudgedValue]:
    """Return the values that are judged, on a mesh with no coarser one to compare, with errors of a usual size."""
    return [replace(value, share=0.0, error=value.share) for _, value in judged_values(results)]


@made_once_by(lambda results: (results.comparison,))
def _judged_once(results: CombinationResult) -> list[tuple[str, JudgedValue]]:
    """Return the judged values with their errors, which are asked for more than once."""
    return [*judged_values(results)]


def find_largest(combinations: Collection[CombinationResult]) -> LargestValues | None:
    """Return the largest values over some combinations, None of none."""
    largest = [_largest_of(results) for results in combinations]
    if not largest:
        return None
    return LargestValues(
        **{item.name: max(getattr(values, item.name) for values in largest) for item in fields(LargestValues)}
    )


def judge_together(combinations: Mapping[str, CombinationResult]) -> dict[str, CombinationResult]:
    """Return results of combinations whose errors are judged against the largest values over all of these."""
    largest = find_largest(combinations.values())
    return {name: replace(results, largest=largest) for name, results in combinations.items()}


@made_once_by(attrgetter("plate", "supports"))
def _largest_of(results: CombinationResult) -> LargestValues:
    """Return the largest values of one combination."""
    from groundslab.accuracy.singularities import find_limits

    plate = results.plate
    limits = find_limits(results.solved_model, plate)
    mean = (plate.moment_x + plate.moment_y) / 2
    deviator = np.hypot((plate.moment_x - plate.moment_y) / 2, plate.moment_xy)
    moment = float((np.abs(mean) + deviator).max())
    shear = float(np.hypot(plate.shear_x, plate.shear_y)[limits.shear_forces].max(initial=0.0))
    strip = OF_STRIP * max(plate.thickness for plate in results.model.every_plate)
    moments = (float(np.abs(beam.between_ends(0.0).moment).max()) for beam in results.beams)
    return LargestValues(
        displacement=float(max(np.abs(plate.settlement).max(), plate.gap.max())),
        moment=moment,
        shear=shear,
        pressure=float(np.abs(plate.pressure[limits.pressures]).max(initial=0.0)),
        support=max((abs(support.total) for support in results.supports), default=0.0),
        beam_moment=max(strip * moment, *moments, 0.0),
        beam_shear=max(strip * shear, *(_shear_of(beam, results) for beam in results.beams), 0.0),
    )


def _judged_part(beam: BeamResult, results: CombinationResult) -> BeamResult:
    """Return a beam at the places where its shear force is judged.

    They are a plate's thickness away from its ends, and from forces and supports without an extent, at which the plate
    hands its share over to the beam the more the smaller the elements are; all of one that has no such places.
    """
    from groundslab.model.remarks.singular_places import near_singular

    model = results.solved_model
    away = max(plate.thickness for plate in model.every_plate)
    part = beam.between_ends(away)
    far = ~near_singular(model, part.nodes, np.full(len(part.nodes), away))
    return part.at(part.way[far]) if far.any() else part


def _shear_of(beam: BeamResult, results: CombinationResult) -> float:
    """Return the largest shear force of a beam [N] where it is judged."""
    return float(np.abs(_judged_part(beam, results).shear).max())


def judged_values(results: CombinationResult) -> Iterator[tuple[str, JudgedValue]]:
    """Yield each judged value of results, with its error [SI] as the share, and against what.

    The smallest pressure is judged only where it decides on contact: where it may be below zero.

    The places of extremes are those where they may lie if nodal values have their errors, see `error_of_largest`.
    Without a coarser mesh these are USUAL.
    """
    from groundslab.accuracy.singularities import find_limits

    plate, coarser, comparison = results.plate, results.coarser, results.comparison
    limits = find_limits(results.solved_model, plate)
    judged_at = {"pressure": limits.pressures, "shear_x": limits.shear_forces, "shear_y": limits.shear_forces}
    for name, against in AGAINST.items():
        nodes = judged_at.get(name, np.ones(len(plate.nodes), dtype=bool))
        for sign in (1, -1) if name in BOTH_SIGNS else (1,):
            if not nodes.any():
                continue
            extreme = _extreme(name, sign, nodes, results, coarser)
            if name != "pressure" or sign > 0 or extreme.value < extreme.error:
                yield against, extreme
    error, around = error_of_contact_share(results) or 0.0, plate.nodes[line_of_lift_off(plate)]
    yield "share", JudgedValue(error, plate.contact_share, CONTACT, None, around)
    for number, support in enumerate(results.supports):
        error = USUAL * abs(support.total)
        if coarser is not None and comparison is not None:
            error = estimate_error(support.total, coarser.supports[number].total, comparison)
        middle = place_of(support.nodes.mean(axis=0)[None], 0) if len(support.nodes) else None
        yield "support", JudgedValue(error, support.total, "force of supports", middle)
    yield from _of_beams(results, coarser)


def _of_beams(results: CombinationResult, coarser: CombinationResult | None) -> Iterator[tuple[str, JudgedValue]]:
    """Yield the judged values of beams, as `judged_values`: extreme moments, and the largest shear force.

    coarser are the results on the coarser mesh, if there is one.
    """
    figures: dict[str, tuple[int, Callable[[BeamResult], float]]] = {
        "moment of beams": (1, lambda beam: float(beam.between_ends(0.0).moment.max())),
        "least moment of beams": (-1, lambda beam: float(beam.between_ends(0.0).moment.min())),
    }
    for number, beam in enumerate(results.beams):
        middle = place_of(beam.nodes[len(beam.nodes) // 2][None], 0)
        for label, (sign, figure) in figures.items():
            value = figure(beam)
            error = USUAL * abs(value)
            if coarser is not None and results.comparison is not None:
                error = estimate_error(value, figure(coarser.beams[number]), results.comparison)
            yield "beam_moment", JudgedValue(error, value, label, middle, sign=sign)
        yield "beam_shear", _largest_shear(beam, None if coarser is None else coarser.beams[number], results)


def _largest_shear(beam: BeamResult, coarser: BeamResult | None, results: CombinationResult) -> JudgedValue:
    """Return the largest shear force of a beam, with the places along it where it may lie."""
    part = _judged_part(beam, results)
    values = np.abs(part.shear)
    most = values + USUAL * values.max()
    if coarser is not None and results.comparison is not None:
        of_one = estimate_error(1.0, 0.0, results.comparison)
        most = values + of_one * np.abs(part.shear - coarser.at(part.way).shear)
    value, node = float(values.max()), int(np.argmax(most))
    error = float(most[node]) - value
    around = part.nodes[most >= value + error / 2]
    return JudgedValue(error, value, BEAM_SHEAR, place_of(part.nodes, node), around)


def _extreme(
    name: str, sign: int, judged: Flags, results: CombinationResult, coarser: CombinationResult | None
) -> JudgedValue:
    """Return the largest (sign 1) or smallest value of a field at judged nodes (n,), or the largest of its sizes.

    coarser are the results on the coarser mesh, if there is one.
    """

    def of(mesh: CombinationResult) -> Array:
        judged_values: Array = getattr(mesh.plate, name)[judged]
        return np.abs(judged_values) if name in SIZES else sign * judged_values

    nodes, values = results.plate.nodes[judged], of(results)
    if coarser is None:
        most = values + USUAL * np.abs(values).max()
    else:
        most = add_errors(results, name, values, of(coarser), judged)
    node = extreme_node(nodes, most, 1)
    value = float(values.max())
    error = float(most[node]) - value
    may_be = most >= value + error / 2
    next_largest = (most - values >= error / 2) & (most >= NEXT * value)
    place = place_of(nodes, node)
    return JudgedValue(
        error, sign * value, PLATE_FIELDS[name].label, place, nodes[may_be], sign, coarse=nodes[may_be | next_largest]
    )
