"""Validation of results that were read from a file: types, shapes, ranges, and whether all of it fits together."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import fields, replace
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

if TYPE_CHECKING:
    from groundslab.fem.continuum.pressed_cells import PressedCells
    from groundslab.results.plate_result import ElementResult, GroundResult, PlateResult
    from groundslab.results.records import BaseResult, BeamResult, JointResult, SupportResult
    from groundslab.results.results import CombinationResult, Comparison, Increment

    Named: TypeAlias = SupportResult | JointResult | BeamResult | BaseResult
    State: TypeAlias = CombinationResult | Comparison | Increment

#: NumPy's type by the annotation of a field.
_TYPES = {"Array": np.float64, "Array | None": np.float64, "Integers": np.int64, "Flags": np.bool_}
#: What a case as solved has in another form than the case as written.
PLACED = frozenset({"loads", "cases", "patterns", "moves", "combinations", "combine"})
#: No quantity of a slab is larger in SI units; squares and products of such numbers are finite.
LARGEST = 1e60


def require_sound(results: CombinationResult) -> None:
    """Raise ValueError, which says what is wrong first, if something cannot come from an analysis."""
    for issue in _faults(results):
        raise ValueError(issue)


def _faults(results: CombinationResult) -> Iterator[str]:
    """Yield what is wrong; what comes later relies on what came before."""
    described = {name for name in type(results.model).model_fields if name not in PLACED}
    if any(getattr(results.model, name) != getattr(results.solved_model, name) for name in described):
        yield "a case as solved that is another one"
    regions = {"zones": len(results.model.soil_zones), "voids": len(results.model.contact.voids)}
    for name, count in regions.items():
        if not set(getattr(results.mesh_plan, f"followed_{name}")) <= set(range(count)):
            yield f"mesh_plan.followed_{name} of other {name} than there are"
    yield from _of_constants(results)
    # the settlement of a continuum's surface is all that is kept of it on the mesh
    layers = len(results.constants.k0) or 1
    yield from _of_state("", results, layers)
    yield from _within_plate(results)
    yield from _of_named("", results)
    for increment in results.increments:
        yield from _of_state(f"increment {increment.share:g}: ", increment, layers)
        if not 0 < increment.share <= 1:
            yield f"an increment of {increment.share:g} of the load"
    if (results.elements.discretization_error is None) != (results.comparison is None):
        yield "elements.discretization_error without a comparison, or a comparison without it"
    if (other := results.comparison) is not None:
        if len(other.constants.k0) != len(results.constants.k0) or len(other.constants.k1) != len(other.constants.k0):
            yield "constants of a comparison with another number of layers"
        yield from _of_state("coarser: ", other, layers)
        yield from _of_named("coarser: ", other)
        if not (0 <= other.energy_error <= 1 and 0 <= other.reduction <= LARGEST):
            yield "errors of a comparison that are none"
        for name in ("moment_reduction", "shear_reduction"):
            field = getattr(other, name)
            if field is not None and not (field.shape == (len(other.plate.nodes),) and np.all(field >= 0)):
                yield f"{name} of a comparison that is none"
    if not results.steps:
        yield "no step of the iteration"


def _states(results: CombinationResult) -> list[State]:
    """Return all states that results hold."""
    return [results, *results.increments, *([] if results.comparison is None else [results.comparison])]


def _of_state(name: str, state: State, layers: int) -> Iterator[str]:
    """Yield what is wrong with plate, elements and ground of so many layers."""
    plate, elements, ground = state.plate, state.elements, state.ground
    yield from _of_mesh(f"{name}plate", plate)
    n, m = len(plate.nodes), len(plate.elements)
    yield from _of_arrays(f"{name}plate", plate, (n,), {"nodes": (n, 2), "elements": (m, 9)})
    if not plate.area.sum() > 0:
        yield f"{name}plate.area without any area"
    yield from _of_arrays(f"{name}elements", elements, (m,))
    if not np.all(elements.thickness > 0):
        yield f"{name}elements.thickness that is not positive"
    if not np.all(elements.section >= 0):
        yield f"{name}elements.section below 0"
    if elements.discretization_error is not None and not np.all(elements.discretization_error >= 0):
        yield f"{name}elements.discretization_error below 0"
    if elements.stiffness_ratio is not None and not np.all(elements.stiffness_ratio > 0):
        yield f"{name}elements.stiffness_ratio that is not positive"
    yield from _of_mesh(f"{name}ground", ground)
    n, m = len(ground.nodes), len(ground.elements)
    surfaces = np.shape(ground.settlement)[:1]
    if surfaces != (layers,):
        yield f"{name}ground.settlement of {surfaces} surfaces on {layers} layers"
    shapes = {"nodes": (n, 2), "elements": (m, 9), "settlement": (*surfaces, n)}
    yield from _of_arrays(f"{name}ground", ground, (n,), shapes)
    if ground.cells is not None:
        yield from _of_cells(f"{name}ground.cells", ground.cells)


def _of_cells(name: str, cells: PressedCells) -> Iterator[str]:
    """Yield what is wrong with the cells on an elastic continuum, and with its layers."""
    c, layers = np.shape(cells.force)[:1], np.shape(cells.layers)[:1]
    if not (c and c[0] and layers):
        yield f"{name} without cells or layers"
    shapes = {"center": (*c, 2), "size": (2,), "layers": (*layers, 3), "beside": (len(cells.beside), 3)}
    yield from _of_arrays(name, replace(cells, layers=np.where(np.isinf(cells.layers), 1.0, cells.layers)), c, shapes)
    E, nu, thickness = cells.layers.T
    if not (np.all(cells.size > 0) and np.all(E > 0) and np.all((nu >= 0) & (nu < 0.5)) and np.all(thickness > 0)):
        yield f"{name}.size or .layers that none can have"
    if not (np.all(np.isfinite(cells.layers[:, :2])) and np.all(np.isfinite(thickness[:-1]))):
        yield f"{name}.layers with numbers that are not finite"


def _of_mesh(name: str, mesh: PlateResult | GroundResult) -> Iterator[str]:
    """Yield what is wrong with nodes and elements by themselves."""
    for part, columns in (("nodes", 2), ("elements", 9)):
        shape = np.shape(getattr(mesh, part))
        if len(shape) != 2 or shape[0] < 1 or shape[1] != columns:
            yield f"{name}.{part} of shape {shape} in place of (some, {columns})"
    yield from _of_arrays(name, mesh, None)
    elements, nodes = mesh.elements, mesh.nodes
    if elements.min() < 0 or elements.max() >= len(nodes):
        yield f"{name}.elements with nodes that are not there"
    if np.bincount(elements.ravel(), minlength=len(nodes)).min() == 0:
        yield f"{name}.nodes of no element"
    if len(np.unique(elements[:, 8])) < len(elements):
        yield f"{name}.elements that are there twice"
    around = nodes[elements[:, [0, 4, 1, 5, 2, 6, 3, 7]]]
    x, y = np.moveaxis(around - around[:, :1], 2, 0)
    twice = (x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1)).sum(axis=1)
    if not np.all(twice > 0):
        yield f"{name}.elements of no area"


def _of_arrays(
    name: str,
    part: PlateResult | ElementResult | GroundResult | PressedCells | Named,
    usual: tuple[int, ...] | None,
    shapes: Mapping[str, tuple[int, ...]] | None = None,
) -> Iterator[str]:
    """Yield which arrays are not of their type, of their shape (the usual one if none is named) or finite."""
    for item in fields(part):
        kind = _TYPES.get(str(item.type))
        if kind is None or (usual is None and item.name not in ("nodes", "elements")):
            continue
        values: Any = getattr(part, item.name)
        if values is None:
            continue
        if values.dtype != kind:
            yield f"{name}.{item.name} of type {values.dtype} in place of {np.dtype(kind)}"
        shape = None if usual is None else (shapes or {}).get(item.name, usual)
        if shape is not None and values.shape != shape:
            yield f"{name}.{item.name} of shape {values.shape} in place of {shape}"
        if kind is np.float64 and not np.all(np.abs(values) <= LARGEST):
            yield f"{name}.{item.name} with numbers that are not finite, or larger than any result"


def _within_plate(results: CombinationResult) -> Iterator[str]:
    """Yield if the mesh is not that of the described plate, or the ground is not below all of it."""
    x0, x1, y0, y1 = results.model.bounds
    sides = np.array([x1 - x0, y1 - y0])
    near = 1e-6 * sides.max()
    low, high = results.plate.nodes.min(axis=0), results.plate.nodes.max(axis=0)
    beyond = np.any(low < [x0 - near, y0 - near]) or np.any(high > [x1 + near, y1 + near])
    # an arc may bulge between its nodes
    if beyond or np.any(high - low < 0.5 * sides):
        yield "plate.nodes that are not those of the described plate"
    if np.any(results.ground.nodes.min(axis=0) > low + near) or np.any(results.ground.nodes.max(axis=0) < high - near):
        yield "ground.nodes that do not reach below all of the plate"


def _of_constants(results: CombinationResult) -> Iterator[str]:
    """Yield what is wrong with single numbers; their types are known to be right."""
    from groundslab.model.ground import ContinuousGround

    constants, certificate = results.constants, results.certificate
    continuous = isinstance(results.model.ground, ContinuousGround)
    if bool(constants.k0) == continuous or len(constants.k0) != len(constants.k1):
        yield "constants.k0 and constants.k1 of different lengths"
    if any((state.ground.cells is None) == continuous for state in _states(results)):
        yield "cells of an elastic continuum on other ground, or none on it"
    if not all(k0 > 0 for k0 in constants.k0) or not all(k1 >= 0 for k1 in constants.k1):
        yield "constants of the ground that are not positive"
    numbers = [*constants.k0, *constants.k1, constants.gamma, constants.decay, constants.limit_depth]
    numbers += [getattr(certificate, item.name) for item in fields(certificate)]
    numbers += [step.gamma for step in results.steps] + [factor for _, factor in results.factors]
    if not all(number is None or abs(number) <= LARGEST for number in numbers):
        yield "numbers that are not finite, or larger than any result"
    if not all(figure >= 0 for figure in certificate.must_vanish().values()):
        yield "figures of the certificate below 0"
    counts = [results.unknowns, constants.gamma_iterations]
    for step in results.steps:
        counts += [step.unknowns, step.increment, step.iteration, step.in_contact, step.changed]
    if not all(0 <= count < 2**53 for count in counts):
        yield "counts below 0, or larger than any result's"


def _of_named(name: str, state: CombinationResult | Comparison) -> Iterator[str]:
    """Yield what is wrong with supports, joints, beams and bases."""
    for what in ("support", "joint", "beam", "base"):
        for number, part in enumerate(getattr(state, f"{what}s"), 1):
            # none where another support has them all
            k = len(part.nodes) if np.ndim(part.nodes) else 0
            shapes = {"nodes": (k, 2)} | (
                {"by_storeys": (k, *np.shape(part.by_storeys)[1:2])} if what == "base" else {}
            )
            yield from _of_arrays(f"{name}{what} {number}", part, (k,), shapes)
