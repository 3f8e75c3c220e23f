"""The demand of punching on one perimeter of a plate, for a column's force that is given (EN 1992-1-1 6.4.4(2))."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.en1992_2004.perimeters import openings
from groundslab.design.demands.cuts.line_traversal import interpolation, pieces
from groundslab.design.demands.cuts.section_cuts import rotate_to_cut
from groundslab.design.demands.loads.edge_lengths import edge_inside
from groundslab.design.demands.perimeters import Footprint, Perimeter, RectangularColumn, RoundColumn, perimeter
from groundslab.errors import InputError, Issue
from groundslab.fem import load_vectors
from groundslab.fem.mesh import Mesh
from groundslab.results.plate_result import PlateResult

__all__ = ["Punching", "RectangularColumn", "RoundColumn", "demand"]


@dataclass(frozen=True, slots=True)
class Punching:
    """The demand of punching on a control perimeter, all of it positive where the column pushes down."""

    V_Ed: float  # column's force + other loads inside - contact pressure inside [N]
    u: float  # length of the perimeter that counts [m]
    v_Ed: float  # V_Ed / (u d) [Pa]
    pressure_inside: float  # contact pressure integrated over the part inside the perimeter [N]
    edge_inside: float  # line force along the plate's edge integrated inside the perimeter [N]
    area: float  # of that part [m2]
    shear: float  # the field of shear forces integrated along the whole perimeter [N]; see demand
    largest: float  # the largest shear force per length on the perimeter [N/m]; grows at free edges, see demand
    perimeter: Perimeter


def demand(
    plate: PlateResult,
    column: Footprint,
    d: float,
    force: float,
    distributed: float = 0.0,
    distance: float | None = None,
    *,
    line_force_relieves: bool = False,
) -> Punching:
    """Return the demand of punching by a column's force [N] at a distance [m] from it, 2 d unless given.

    V_Ed is the reduced force of (6.4.4(2)): the loads inside less the ground's pressure inside. The line force along
    the plate's edge is no pressure: it is taken off only if it is said to relieve, and added where it pulls. `shear`
    holds it in any case. Where a perimeter ends at a free edge, the twisting moment that must vanish there gives large
    shear forces over about the plate's thickness; the largest one grows as the mesh is refined.

    d is the effective depth [m], `distributed` the other loads on the slab inside [Pa], its self-weight for example.
    InputError if d or the distance is none, or the column or its perimeter does not lie on the plate.
    """
    line = _perimeter(plate, column, d, 2 * d if distance is None else distance)
    mesh = Mesh(plate.nodes, plate.elements)
    shares = load_vectors.integrate_over_polygon(mesh, np.arange(len(mesh.elements)), line.inside)
    pressure = float((shares * plate.pressure[mesh.elements]).sum())
    nodes, length = edge_inside(plate, line.inside)
    edge = float(length @ plate.line_force[nodes])
    taken_off = edge if line_force_relieves or edge < 0 else 0.0
    V_Ed = force + distributed * line.inside.area - pressure - taken_off
    shear, largest = _shear(plate, line.whole)
    return Punching(
        V_Ed=V_Ed,
        u=line.u,
        v_Ed=V_Ed / (line.u * d),
        pressure_inside=pressure,
        edge_inside=edge,
        area=float(line.inside.area),
        shear=shear,
        largest=largest,
        perimeter=line,
    )


def _perimeter(plate: PlateResult, column: Footprint, d: float, distance: float) -> Perimeter:
    """Return the perimeter at a distance [m], if it and the effective depth d [m] are such."""
    issues = []
    if not d > 0:
        issues.append(Issue("d", f"{d:g} m", "an effective depth greater than zero"))
    if not distance >= 0:
        issues.append(Issue("distance", f"{distance:g} m", "a distance that is not negative"))
    if issues:
        raise InputError(issues)
    return perimeter(plate, column, distance, openings(d))


def _shear(plate: PlateResult, legs: Array) -> tuple[float, float]:
    """Return - int q_n ds [N] along legs (l, 2, 2), n outwards, and the largest - q_n [N/m] on them."""
    mesh = Mesh(plate.nodes, plate.elements)
    crossed = pieces(mesh, legs)
    piece, s, ds = crossed.gauss()
    nodes, N = interpolation(mesh, crossed, piece, s)
    q_x, q_y = (np.einsum("pa,pa->p", N, field[nodes]) for field in (plate.shear_x, plate.shear_y))
    none = np.zeros_like(q_x)
    q_n = rotate_to_cut(none, none, none, q_x, q_y, crossed.along[crossed.leg[piece]])[3]
    return float(-(ds @ q_n)), float(-q_n.min())
