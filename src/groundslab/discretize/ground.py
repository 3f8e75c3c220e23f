"""The described ground as the kernels know it: columns of constants, or soil whose constants follow from gamma.

A table holds what describes the layers of a column, (L, 2): k0 and k1, or (L, 5): thickness, c0, c1, c2 and nu. Where
the ground varies over the plan, (c, L, ...) are the tables of the c columns that differ. Between boreholes each element
has the column at its center; of zones it has the mean of their constants by the share of its area in each, which is one
of them where the mesh follows their borders. Under a pit, whose border it follows, columns begin at its underside: what
of the layers lies above is cut off.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Collection, Mapping
from dataclasses import replace

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.discretize.interpolation import interpolate_linearly
from groundslab.errors import InputError, Issue
from groundslab.fem.continuum.media import BondedLayers, Medium, StressedLayers, elastic_length
from groundslab.fem.continuum.transfer import ElasticLayer
from groundslab.fem.foundation import Column, Layer, Parts, consistent_stack, interface_stack, single
from groundslab.fem.mesh import Mesh
from groundslab.fem.plate import bending_rigidity
from groundslab.fem.shape_functions import areas
from groundslab.fem.vlasov import Soil
from groundslab.geometry.area_shares import shares
from groundslab.model.combinations import list_combinations
from groundslab.model.ground import (
    AnyGround,
    ContinuousGround,
    Continuum,
    InterfaceLayer,
    Layered,
    Pasternak,
    SoilLayer,
    Vlasov,
    Winkler,
)
from groundslab.model.model import Model
from groundslab.model.plates.pits import chord_of, pits_of
from groundslab.model.varying_ground import Borehole

#: What a constant of the ground is multiplied with at places x and y (p,) [m], by the constant's name in the file, such
#: as "ground.k0" or "ground.layers[1].E" (layers count from 1).
Factors = Mapping[str, Callable[[Array, Array], Array]]
#: Homogeneous parts of a layer of a continuum whose modulus varies.
GRADED_PARTS = 16
#: A layer of no thickness is so thin, of its column's depth: a settlement between its surfaces needs some.
PINCHED = 1e-8
#: A Poisson's ratio this close to zero is zero but for the rounding of its interpolation.
ROUNDING = 1e-12


def layer_of(layer: SoilLayer) -> Layer:
    """Return the kernel's layer of a described one."""
    bottom = layer.E if layer.E_bottom is None else layer.E_bottom
    change = bottom - layer.E
    moduli = (layer.E, change, 0.0) if layer.variation == "linear" else (layer.E, 0.0, change)
    return Layer(layer.thickness, moduli, layer.nu)


def ground_of(model: Model) -> Soil | Column:
    """Return the ground as [ground] says it, the same everywhere."""
    return _make_ground(model.ground, _table(model.ground, model))


def grounds_of(model: Model) -> list[Soil | Column]:
    """Return every ground that is described for some place, each as if it were the same everywhere."""
    return [_make_ground(model.ground, table) for table in _tables(model)]


def varies(model: Model) -> bool:
    """Return whether the ground differs from place to place."""
    return bool(model.soil_zones or model.boreholes) or has_cut_layers(model)


def ground_under(
    model: Model, mesh: Mesh, plate_elements: Integers, factors: Factors | None, followed_zones: Collection[int] = ()
) -> tuple[Soil | Column, tuple[Array, Array]]:
    """Return the ground under a mesh, by element where it varies, and k0 [Pa/m] and k1 [Pa m] of its layers, (L,) each.

    followed_zones are numbers, from 0, of those whose borders the mesh follows along arcs, see `area_shares`.
    The latter are means over the plate's area; of soil, whose constants hang on gamma, there are none. Of a consistent
    stack they are Ec / h and G h of each sublayer, for the mean of its E.
    """
    none = np.zeros(0), np.zeros(0)
    if isinstance(model.ground, ContinuousGround):
        return single(0.0, 0.0), none  # cells bear the plate, no column
    if not varies(model) and not factors:
        tables, parts = _table(model.ground, model)[None], None
    else:
        tables, parts = _columns_under(model, mesh, factors or {}, followed_zones)
    if parts is None or len(tables) == 1:
        only = _make_ground(model.ground, tables[0])
        return only, none if isinstance(only, Soil) else _constants(model.ground, tables[0])
    soil, share = _make_ground(model.ground, tables), _share(parts, mesh, plate_elements)
    if isinstance(soil, Soil):
        many = soil.gamma is None and not factors and len(list_combinations(model)) > 1
        return replace(soil, parts=parts, area_fraction=share, table={} if many else None), none
    k0, k1 = _constants(model.ground, tables)
    return soil.mix(parts), (share @ k0, share @ k1)


def medium_of(
    ground: ContinuousGround, layers: tuple[SoilLayer, ...], depth: float = math.inf, above: float = 0.0
) -> Medium:
    """Return layers as the ground says that they settle, down to a depth [m]; one that varies as GRADED_PARTS parts.

    Of layers that are not bonded what lies above a level [m] is cut off, from which the depth counts then.
    """
    parts = []
    for layer in map(layer_of, layers):
        parts += layer.split(1 if layer.moduli[1:] == (0.0, 0.0) else GRADED_PARTS)
    if isinstance(ground, Continuum):
        bonded = [ElasticLayer(float(part.mean), float(part.nu), float(part.thickness)) for part in parts]
        if ground.half_space is not None:
            bonded.append(ElasticLayer(ground.half_space.E, ground.half_space.nu, math.inf))
        return BondedLayers(tuple(bonded))
    bottoms = np.clip(np.cumsum([part.thickness for part in parts]) - above, 0.0, depth)
    thickness = np.diff(bottoms, prepend=0.0)
    moduli = [float(part.oedometric_ratio * part.mean) for part in parts]
    return StressedLayers(*zip(*((M, float(h)) for M, h in zip(moduli, thickness, strict=True) if h > 0), strict=True))


def subgrade_modulus(ground: ContinuousGround, model: Model) -> float:
    """Return k [Pa/m] that a continuum has for the wave length 2 pi l of a load that plate and ground resist alike.

    With l = (D / k)^(1/4), the elastic length, and 1 / k = T(1 / l), the settlement by a pressure of that wave length:
    a measure for sizes of elements, not of settlements.
    """
    D = float(bending_rigidity(model.plate.E, model.plate.nu, model.plate.thickness)[0, 0])
    return D / elastic_length(medium_of(ground, ground.layers), D) ** 4


def surfaces_of(ground: Soil | Column) -> int:
    """Return the number of surfaces of the ground that can settle."""
    if isinstance(ground, Column):
        return ground.surfaces
    return len(ground.layers) if ground.way == "interface" else 1


def carries_shear(ground: Soil | Column) -> bool:
    """Return whether the top surface of the ground carries shear anywhere."""
    return not isinstance(ground, Column) or bool(ground.A1[..., 0, :].any())


def _table(ground: AnyGround, model: Model) -> Array:
    """Return the table of a described ground."""
    if isinstance(ground, Winkler):
        return np.array([[ground.modulus(max(model.plate.sides)), 0.0]])
    if isinstance(ground, Pasternak):
        return np.array([[ground.k0, ground.k1]])
    if isinstance(ground, ContinuousGround):
        return np.array([[subgrade_modulus(ground, model), 0.0]])
    rows = [[layer.k0, layer.k1] for layer in ground.layers if isinstance(layer, InterfaceLayer)]
    return np.array(rows) if rows else _table_of_soil(ground.layers)


def _table_of_soil(layers: tuple[SoilLayer | InterfaceLayer, ...]) -> Array:
    soil = [layer_of(layer) for layer in layers if isinstance(layer, SoilLayer)]
    return np.array([[layer.thickness, *layer.moduli, layer.nu] for layer in soil])


def _tables(model: Model) -> list[Array]:
    """Return the tables of the boreholes, or of the ground and then of its zones."""
    if isinstance(model.ground, ContinuousGround):
        return [_table(model.ground, model)]
    if model.boreholes:
        return [_table_of_soil(hole.layers) for hole in model.boreholes]
    return [_table(ground, model) for ground in (model.ground, *(zone.ground for zone in model.soil_zones))]


def _make_ground(ground: AnyGround, table: Array) -> Soil | Column:
    """Return the ground of a table, or of those of many columns, by the rules of the described one."""
    if table.shape[-1] == 2:
        return interface_stack(table[..., 0], table[..., 1])
    layers = tuple(_layers(table))
    assert isinstance(ground, Vlasov | Layered)
    if isinstance(ground, Layered) and ground.coupling == "consistent":
        return consistent_stack(sublayers(ground, layers))
    printed = ground.formulas == "as printed"
    gamma = None if ground.gamma == "iterate" else float(ground.gamma)
    if isinstance(ground, Layered):
        return Soil(layers, "interface", printed, gamma)
    by_profile = ground.mode == "profile" or (ground.mode == "auto" and len(layers) > 1)
    return Soil(layers, "profile" if by_profile else "sinh", printed, gamma)


def _layers(table: Array) -> list[Layer]:
    """Return the layers of a table (..., L, 5); one that pinches out keeps PINCHED of its column's depth."""
    thickness = table[..., 0]
    thickness = np.maximum(thickness, PINCHED * thickness.sum(axis=-1, keepdims=True))
    values = zip(np.moveaxis(thickness, -1, 0), np.moveaxis(table[..., 1:], (-2, -1), (0, 1)), strict=True)
    return [Layer(h, (c0, c1, c2), nu) for h, (c0, c1, c2, nu) in values]


def sublayers(ground: Layered, layers: tuple[Layer, ...]) -> list[Layer]:
    """Return the layers of a consistent stack, each split into the sublayers that the described ground wants."""
    soil = [layer for layer in ground.layers if isinstance(layer, SoilLayer)]
    return [part for layer, consistent in zip(soil, layers, strict=True) for part in consistent.split(layer.sublayers)]


def _constants(ground: AnyGround, table: Array) -> tuple[Array, Array]:
    """Return k0 and k1 (..., L) of a table whose ground has constants without gamma."""
    if table.shape[-1] == 2:
        return table[..., 0], table[..., 1]
    assert isinstance(ground, Layered)
    k0, k1 = zip(*(part.stiffnesses for part in sublayers(ground, tuple(_layers(table)))), strict=True)
    return np.stack(k0, axis=-1), np.stack(k1, axis=-1)


def _columns_under(model: Model, mesh: Mesh, factors: Factors, followed_zones: Collection[int]) -> tuple[Array, Parts]:
    """Return the tables (c, L, ...) that differ under a mesh, and which part of each element's area has which."""
    tables = np.stack(_tables(model))
    centres = mesh.nodes[mesh.elements[:, 8]]
    coordinates = (centres + model.origin).T
    if model.boreholes:
        element, part = np.arange(len(centres)), np.ones(len(centres))
        listed = _between_boreholes(model.boreholes, tables, centres)
    else:
        share = shares(mesh.xy, model.zone_rings, followed_zones, max(model.sides))
        element, zone = np.nonzero(share)
        part, listed = share[element, zone], tables[zone]
    if has_cut_layers(model):
        listed = cut_off(listed, deeper_at(model, centres)[element])
    for name, factor in factors.items():
        layer, columns = _place_of(name, model)
        listed[:, layer, columns] *= np.broadcast_to(factor(*coordinates), len(centres))[element, None]
    rows, of = np.unique(listed.reshape(len(listed), -1), axis=0, return_inverse=True)
    return rows.reshape(-1, *tables.shape[1:]), Parts(element, of.ravel(), part)


def has_cut_layers(model: Model) -> bool:
    """Return whether pits cut off what lies above them of layers with a thickness."""
    soil = all(isinstance(layer, SoilLayer) for layer in getattr(model.ground, "layers", (None,)))
    return soil and not isinstance(model.ground, ContinuousGround) and any(map(pits_of, model.every_plate))


def deeper_at(model: Model, places: Array) -> Array:
    """Return how much deeper the underside of pits lies than that of the slab at places (p, 2) (p,) [m]."""
    from shapely import contains_xy

    deeper = np.zeros(len(places))
    for plate in model.every_plate:
        for pit in pits_of(plate):
            deeper[contains_xy(pit.area(chord_of(plate)), *places.T)] = pit.deeper
    return deeper


def cut_off(tables: Array, depth: Array) -> Array:
    """Return tables of soil layers (e, L, 5) without what of them lies above depths (e,) [m].

    E = c0 + c1 s + c2 s^2 over a layer is, from the share a of it on, with s = a + (1 - a) r,
    (c0 + c1 a + c2 a^2) + (c1 + 2 c2 a) (1 - a) r + c2 (1 - a)^2 r^2.
    """
    h, c0, c1, c2, nu = np.moveaxis(tables, -1, 0)
    off = np.clip(depth[:, None] - (np.cumsum(h, axis=1) - h), 0.0, h)
    a = np.divide(off, h, out=np.zeros_like(h), where=h > 0)
    return np.stack([h - off, c0 + a * (c1 + a * c2), (c1 + 2 * c2 * a) * (1 - a), c2 * (1 - a) ** 2, nu], axis=-1)


def _place_of(name: str, model: Model) -> tuple[int, slice]:
    """Return which layer, and which columns of its row in a table, a constant of the ground stands in."""
    ground, layer = model.ground, re.fullmatch(r"ground\.layers\[(\d+)\]\.(E|k0|k1)", name)
    columns = {"k": slice(0, 1), "k0": slice(0, 1), "k1": slice(1, 2), "E": slice(1, 4)}
    if layer and isinstance(ground, Vlasov | Layered) and 1 <= int(layer[1]) <= len(ground.layers):
        soil = isinstance(ground.layers[int(layer[1]) - 1], SoilLayer)
        if soil == (layer[2] == "E"):
            return int(layer[1]) - 1, columns[layer[2]]
    elif (isinstance(ground, Winkler), name) == (True, "ground.k") or (
        isinstance(ground, Pasternak) and name in ("ground.k0", "ground.k1")
    ):
        return 0, columns[name.removeprefix("ground.")]
    expected = "a constant that the ground of the case has: ground.k, ground.k0, ground.k1, ground.layers[1].E, ..."
    raise InputError([Issue(name, f"a ground of kind {ground.kind}", expected)])


def _share(parts: Parts, mesh: Mesh, plate_elements: Integers) -> Array:
    """Return the part of the plate's area on each column (c,)."""
    area = np.zeros(len(mesh.elements))
    area[plate_elements] = areas(mesh.xy[plate_elements])
    on_each: Array = np.bincount(parts.column, weights=area[parts.element] * parts.area_fraction) / area.sum()
    return on_each


def _between_boreholes(holes: tuple[Borehole, ...], tables: Array, places: Array) -> Array:
    """Return the tables (p, L, 5) at places (p, 2), interpolated between those of the boreholes (h, L, 5)."""
    at_holes = np.array([(hole.x, hole.y) for hole in holes])
    # the moduli at top and bottom stay within what is known, as no value leaves its range; their difference would not
    # keep the modulus at the bottom positive. One of both changes is zero, as all boreholes have the same variation.
    curved = (tables[..., 3] != 0).any(axis=0)
    ends = tables.copy()
    ends[..., 2], ends[..., 3] = tables[..., 1:4].sum(axis=-1), 0.0
    table = interpolate_linearly(at_holes, ends.reshape(len(holes), -1), places).reshape(len(places), *tables.shape[1:])
    change = table[..., 2] - table[..., 1]
    table[..., 2], table[..., 3] = np.where(curved, 0.0, change), np.where(curved, change, 0.0)
    table[..., 4] = np.where(np.abs(table[..., 4]) < ROUNDING, 0.0, table[..., 4])
    return table
