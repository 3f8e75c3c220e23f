"""Tilt and differential settlement: the plane that fits the settlement best, slopes between pairs of points."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.design.demands.by_plate import results_by_plate
from groundslab.errors import InputError, Issue
from groundslab.fem.mesh import Mesh, boxes_of, locate
from groundslab.fem.shape_functions import q9_values
from groundslab.geometry.plan import format_place
from groundslab.results.plate_result import PlateResult
from groundslab.results.results import CombinationResult

#: Points of the line between two columns at which the settlement is looked at.
CHORD_POINTS = 41
#: A point this near to a circle, by its squared diameter, lies on it.
ON_CIRCLE = 1e-9


@dataclass(frozen=True, slots=True)
class Tilt:
    """The plane w = settlement + tilt_x (x - x_c) + tilt_y (y - y_c) that fits best, and how far the plate is off it.

    The plate goes down towards `direction`. Deflections are w less the plane's: positive where the plate is lower.
    """

    center: tuple[float, float]  # (x_c, y_c), the area's centroid [m]
    settlement: float  # of the plane at the center: the mean settlement [m]
    tilt_x: float
    tilt_y: float
    deflection: float  # the deflection of the largest size [m]
    place: tuple[float, float]  # the node where it is [m]

    @property
    def tilt(self) -> float:
        """Return the plane's largest slope, >= 0."""
        return float(np.hypot(self.tilt_x, self.tilt_y))

    @property
    def slope(self) -> tuple[float, float]:
        """Return the plane's slopes along x and y."""
        return self.tilt_x, self.tilt_y

    @property
    def direction(self) -> float:
        """Return the direction in which the plane goes down [rad], counter-clockwise from x."""
        return float(np.arctan2(self.tilt_y, self.tilt_x))


@dataclass(frozen=True, slots=True)
class AreaMeans:
    """Means over the area of a plate that its best plane follows from: S (slope) = s.

    Attributes
    ----------
    center : Array
        The area's centroid (2,) [m].
    settlement : float
        The mean settlement [m].
    S : Array
        Of products of places from the center (2, 2) [m2].
    s : Array
        Of settlements times places from the center (2,) [m2].
    """

    center: Array
    settlement: float
    S: Array
    s: Array


@dataclass(frozen=True, slots=True)
class Sag:
    """Between two points the place that is farthest from the straight line between both.

    Attributes
    ----------
    names : tuple of str
        Of the points.
    length : float
        Between both [m].
    along : float
        The place on the way from the first to the second point, 0 to 1.
    settlements : tuple of float
        At the points, and at the place [m].
    """

    names: tuple[str, str]
    length: float
    along: float
    settlements: tuple[float, float, float]

    @property
    def ratio(self) -> float:
        """Return the deflection ratio: the distance from the straight line over the length."""
        first, second, between = self.settlements
        return abs(between - (1 - self.along) * first - self.along * second) / self.length


@dataclass(frozen=True, slots=True)
class Differences:
    """Settlement differences of all pairs of named points, in the order of the names.

    `distortion` is the angular distortion |difference| / distance. `relative` is the same for the settlements less
    the plane's of `tilt`: a plate that tilts as a rigid body has none (EN 1997-1 Annex H: relative rotation).
    """

    names: tuple[str, ...]
    settlement: Array  # (n,): at the points [m]
    first: Integers  # (r,): index into names
    second: Integers  # (r,)
    distance: Array  # (r,) [m]
    difference: Array  # (r,): settlement of the second less that of the first [m]
    distortion: Array  # (r,)
    relative: Array  # (r,)

    @property
    def worst(self) -> tuple[str, str]:
        """Return the names of the pair with the largest distortion."""
        pair = int(np.argmax(self.distortion))
        return self.names[self.first[pair]], self.names[self.second[pair]]


def largest_tilt(results: CombinationResult) -> Tilt:
    """Return the tilt of the plate that tilts most."""
    return max(map(tilt, results_by_plate(results).values()), key=lambda plate_tilt: plate_tilt.tilt)


def area_means(plate: PlateResult) -> AreaMeans:
    """Return the means that the plane follows from which fits best, each node weighed by its share of the area."""
    area = plate.area / plate.area.sum()
    # places from one of the nodes, and settlements from their mean: the sums keep their digits far from x = y = 0
    near = plate.nodes - plate.nodes[0]
    middle = area @ near
    arm = near - middle
    mean = float(area @ plate.settlement)
    return AreaMeans(
        plate.nodes[0] + middle, mean, arm.T @ (area[:, None] * arm), arm.T @ (area * (plate.settlement - mean))
    )


def tilt(plate: PlateResult) -> Tilt:
    """Return the plane that fits the settlement best: least squares, each node weighed by its share of the area."""
    means = area_means(plate)
    slope = np.linalg.solve(means.S, means.s)
    off = plate.settlement - means.settlement - (plate.nodes - means.center) @ slope
    most = int(np.argmax(np.abs(off)))
    x, y = plate.nodes[most]
    return Tilt(
        center=(float(means.center[0]), float(means.center[1])),
        settlement=means.settlement,
        tilt_x=float(slope[0]),
        tilt_y=float(slope[1]),
        deflection=float(off[most]),
        place=(float(x), float(y)),
    )


def deflections_between(plate: PlateResult, points: Mapping[str, tuple[float, float]]) -> list[Sag]:
    """Return the sag between pairs of neighboring points (x, y) [m] of the plate, such as columns.

    Its ratio is the largest distance of the settlement from the straight line between both, over their distance
    (EN 1997-1 Annex H: relative deflection), at places that lie on the plate. Neighbors are pairs with no third point
    in the circle over the line between them (Gabriel and Sokal 1969); the diagonals of rectangles count.
    """
    names = tuple(points)
    places = np.array(list(points.values()), dtype=float)
    along = np.linspace(0, 1, CHORD_POINTS)[:, None]
    mesh = Mesh(plate.nodes, plate.elements)
    sags = []
    for i, j in combinations(range(len(names)), 2):
        a, b = places[i], places[j]
        squared = float(((b - a) ** 2).sum())
        if (((places - a) * (places - b)).sum(axis=1) < -ON_CIRCLE * squared).any():
            continue
        element, local = locate(mesh, (1 - along) * a + along * b, boxes=boxes_of(mesh))
        w = np.einsum("pa,pa->p", q9_values(local), plate.settlement[mesh.elements[element]])
        off = np.abs(w - (1 - along[:, 0]) * w[0] - along[:, 0] * w[-1])
        most = int(np.argmax(np.where(element >= 0, off, -1.0)))
        settlements = float(w[0]), float(w[-1]), float(w[most])
        sags.append(Sag((names[i], names[j]), float(np.sqrt(squared)), float(along[most, 0]), settlements))
    return sags


def settlement_differences(plate: PlateResult, points: Mapping[str, tuple[float, float]]) -> Differences:
    """Return the settlement differences of all pairs of named points (x, y) [m] of the plate, such as columns."""
    names = tuple(points)
    if len(names) < 2:
        raise InputError([Issue("points", f"{len(names)}", "at least two points")])
    places = np.array([points[name] for name in names], dtype=float)
    mesh = Mesh(plate.nodes, plate.elements)
    element, local = locate(mesh, places, boxes=boxes_of(mesh))
    issues = [
        Issue(f"points[{name!r}]", f"{format_place((x, y))} m", "a point on the plate")
        for name, (x, y), where in zip(names, places, element, strict=True)
        if where < 0
    ]
    first, second = np.array(list(combinations(range(len(names)), 2))).T
    distance = np.linalg.norm(places[second] - places[first], axis=1)
    issues += [
        Issue(f"points[{names[second[pair]]!r}]", f"the same place as {names[first[pair]]!r}", "another place")
        for pair in np.flatnonzero(distance == 0)
    ]
    if issues:
        raise InputError(issues)
    w = np.einsum("pa,pa->p", q9_values(local), plate.settlement[mesh.elements[element]])
    plane = tilt(plate)
    off = w - (places - plane.center) @ np.array([plane.tilt_x, plane.tilt_y])
    difference = w[second] - w[first]
    return Differences(
        names=names,
        settlement=w,
        first=first,
        second=second,
        distance=distance,
        difference=difference,
        distortion=np.abs(difference) / distance,
        relative=np.abs(off[second] - off[first]) / distance,
    )
