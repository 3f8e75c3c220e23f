"""The table of reinforcement: what each layer of bars needs over all ultimate combinations, and where."""

from __future__ import annotations

import numpy as np

from groundslab.design import DesignMoments, wood_armer
from groundslab.envelope import Envelope, envelope
from groundslab.model import Model, Reinforcement
from groundslab.reinforcement import Axes, Concrete, SlabReinforcement, Steel, minimum, slab
from groundslab.results import Combined, PlateResult, Results
from groundslab.shape import Array, Flags
from groundslab.tables.quantities import LAYERS, extreme, place, solved
from groundslab.tables.table import Cell, Table, table_of
from groundslab.tables.thickness import of_nodes

#: From m2/m to cm2/m.
CM2 = 1e4


def ultimate(combined: Combined) -> list[Results]:
    """Return the results of the ultimate combinations."""
    return [results for results in solved(combined) if results.limit_state == "ultimate"]


def needs(model: Model, steel: Reinforcement, results: list[Results]) -> dict[str, SlabReinforcement]:
    """Return what the plate's nodes need in each combination, by its name."""
    if not results:
        return {}
    t = of_nodes(model, results[0].plate)
    axes = Axes(*steel.bottom, *steel.top)
    concrete, bars = materials(steel)
    return {each.combination: slab(_design(each.plate), t, axes, concrete, bars) for each in results}


def materials(steel: Reinforcement) -> tuple[Concrete, Steel]:
    """Return concrete and steel; InputError where EN 1992-1-1 is not made for them."""
    return Concrete(steel.f_ck, steel.gamma_c, steel.alpha_cc), Steel(steel.f_yk, steel.gamma_s)


def most(found: dict[str, SlabReinforcement], layer: str) -> tuple[Array, Envelope]:
    """Return the largest area (n,) [m2/m] of a layer over the combinations, inf where it fails, and its envelope.

    The envelope is that of areas with a number larger than any in place of inf.
    """
    areas = {name: getattr(each, layer) for name, each in found.items()}
    finite = {name: np.where(np.isinf(area), np.finfo(float).max, area) for name, area in areas.items()}
    return np.max(list(areas.values()), axis=0), envelope(finite)


def links(found: dict[str, SlabReinforcement]) -> Flags:
    """Return where bars in compression are counted in any combination (n,), which links must hold."""
    counted: Flags = np.any([each.links for each in found.values()], axis=0)
    return counted


def reinforcement(combined: Combined, steel: Reinforcement) -> Table:
    """Return the largest required area of each layer of bars over all ultimate combinations."""
    heads = [
        ("layer", ""), ("required area", "cm2/m"), ("x", "m"), ("y", "m"), ("combination", ""),
        ("design moment", "kNm/m"), ("thickness", "m"), ("minimum area", "cm2/m"),
        ("part of the plate that fails", "%"), ("part of the plate that needs links", "%"),
    ]  # fmt: skip
    results = ultimate(combined)
    found = needs(combined.model, steel, results)
    rows = [_layer(combined, steel, found, layer) for layer in LAYERS] if found else []
    notes = [
        "By EN 1992-1-1 for Wood's design moments of each node in each ultimate combination, not of averages. The "
        "required area is not less than the minimum of 9.2.1.1(1) where there is a moment.",
        "inf: the concrete is too weak in bending for any reinforcement. Links must hold bars in compression "
        "(9.2.1.2(3)) where these are counted on.",
        "Minimum area of tension bars by 9.2.1.1(1) at the place named. Crack widths, shear and punching are not in "
        "it.",
    ]
    if not found:
        notes.insert(0, "No ultimate combination has a result.")
    return table_of("reinforcement", "Reinforcement", heads, rows, notes)


def _layer(combined: Combined, steel: Reinforcement, found: dict[str, SlabReinforcement], layer: str) -> list[Cell]:
    """Return the row of one layer of bars."""
    plate = combined.results[next(iter(found))].plate
    area, by = most(found, layer)
    node = extreme(plate.nodes, area, 1)
    name = by.names[by.greatest_by[node]]
    t = float(of_nodes(combined.model, plate)[node])
    concrete, bars = materials(steel)
    face, axis = layer.split("_")
    d = t - getattr(steel, face)["xy".index(axis)]
    moment = float(getattr(_design(combined.results[name].plate), layer)[node]) / 1e3
    least = float(minimum(np.array(d), concrete, bars)) * CM2
    shares = [_share(plate, flags) for flags in (np.isinf(area), links(found))]
    governed: list[Cell] = [*place(plate.nodes, node), name, moment] if area[node] > 0 else [None] * 4
    return [layer.replace("_", " "), float(area[node]) * CM2, *governed, t, least, *shares]


def _design(plate: PlateResult) -> DesignMoments:
    """Return Wood's design moments at the plate's nodes."""
    return wood_armer(plate.moment_x, plate.moment_y, plate.moment_xy)


def _share(plate: PlateResult, flags: Flags) -> float:
    """Return the share of the plate's area that flagged nodes have [%]."""
    return float(plate.area[flags].sum() / plate.area.sum() * 100)
