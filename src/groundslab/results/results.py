"""What an analysis gives back: frozen arrays on nine-node meshes, the constants of the ground, the certificate."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from groundslab.arrays import Memo
from groundslab.errors import GroundslabError, InputError, Issue, NotCertified
from groundslab.fem.mesh import Mesh, Whereabouts, bounding_boxes, interpolated, locate
from groundslab.results.fields import PLATE_FIELDS
from groundslab.schema.wording import describe, one_of, suggestion

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray
    from shapely import STRtree

    from groundslab.model.loads.load_cases import Combination
    from groundslab.model.model import Model

    Array = NDArray[np.float64]
    Integers = NDArray[np.int64]
    Flags = NDArray[np.bool_]


#: Of more points outside than these, an error tells only how many they are.
MOST_NAMED = 100


@dataclass(frozen=True, slots=True)
class PlateResult:
    """The plate: nine-node mesh and nodal fields in SI units (see PLATE_FIELDS).

    Moments and shear forces are recovered by patches of elements. A node on the border of two sections (zones of the
    plate) stands once for each of them, so that nothing is averaged across a change of thickness.
    """

    nodes: Array  # (n, 2)
    elements: Integers  # (m, 9): four corners, four midsides, centre
    settlement: Array  # (n,)
    rotation_x: Array
    rotation_y: Array
    gap: Array
    penetration: Array
    pressure: Array
    line_force: Array
    moment_x: Array
    moment_y: Array
    moment_xy: Array
    shear_x: Array
    shear_y: Array
    in_contact: Flags  # (n,)
    area: Array  # (n,) [m2]: each node's share of the plate's area
    contact_area: Array  # (n,) [m2]: what of it rests on the ground; beside a void or a cavity only a part may
    edge_length: Array  # (n,) [m]: each node's share of the length of the plate's edge, 0 inside

    @property
    def contact_force(self) -> Array:
        """Return the ground's force on each node (n,) [N]: its pressure and its line force."""
        return self.pressure * self.area + self.line_force * self.edge_length

    @overload
    def value_at(self, field: str, x: float, y: float) -> float: ...
    @overload
    def value_at(self, field: str, x: ArrayLike, y: ArrayLike) -> Array: ...
    def value_at(self, field: str, x: ArrayLike, y: ArrayLike) -> float | Array:
        """Return a nodal field at points of the plate, by the elements' shape functions.

        Parameters
        ----------
        field
            One of the names of PLATE_FIELDS.
        x, y
            Places [m]: numbers or arrays of any shapes that broadcast against each other.

        Returns
        -------
        float or Array
            In the field's SI unit: a float for two numbers, else an array of the shape that x and y have together.
            On the border of two sections the value is that of one of them.

        Raises
        ------
        InputError
            If there is no such field, if x and y do not fit together, or if a point does not lie on the plate; it names
            the points.
        """
        if field not in PLATE_FIELDS:
            names = tuple(PLATE_FIELDS)
            raise InputError([Issue("field", describe(field), one_of(names), suggestion(field, names))])
        return _values_at(Mesh(self.nodes, self.elements), getattr(self, field), x, y, "the plate")

    @overload
    def element_at(self, x: float, y: float) -> int: ...
    @overload
    def element_at(self, x: ArrayLike, y: ArrayLike) -> Integers: ...
    def element_at(self, x: ArrayLike, y: ArrayLike) -> int | Integers:
        """Return which element of the plate holds each point, to read fields of elements there.

        `results.elements.moment_x[results.plate.element_at(x, y)]`, for example, is the element's own moment, not
        averaged.

        Parameters
        ----------
        x, y
            Places [m]: numbers or arrays of any shapes that broadcast against each other.

        Returns
        -------
        int or Integers
            Rows of `elements`: an int for two numbers, else an array of the shape that x and y have together. A point
            on a common side belongs to one of its elements.

        Raises
        ------
        InputError
            If x and y do not fit together, or if a point does not lie on the plate; it names the points.
        """
        places = _places(x, y)
        found: Integers = _located(Mesh(self.nodes, self.elements), places, "the plate")[0]
        return int(found[0]) if places.ndim == 1 else found.reshape(places.shape[:-1])


@dataclass(frozen=True, slots=True)
class ElementResult:
    """The plate element by element, in the order of its elements: values at their centres in SI units.

    See ELEMENT_FIELDS: moments and shear forces are the element's own, averaged with nobody else's.
    """

    pressure: Array  # (m,) [Pa]: mean contact pressure under the element, no line force
    moment_x: Array  # (m,) [N m/m]
    moment_y: Array
    moment_xy: Array
    shear_x: Array  # (m,) [N/m]
    shear_y: Array
    thickness: Array  # (m,) [m]
    section: Integers  # (m,): 0 outside all zones, else the number of the zone from 1


@dataclass(frozen=True, slots=True)
class GroundResult:
    """The ground, under the plate and beyond it: settlement of every surface, from the top one downwards."""

    nodes: Array  # (n, 2)
    elements: Integers  # (m, 9)
    settlement: Array  # (number of surfaces, n)

    @overload
    def value_at(self, x: float, y: float, surface: int = 0) -> float: ...
    @overload
    def value_at(self, x: ArrayLike, y: ArrayLike, surface: int = 0) -> Array: ...
    def value_at(self, x: ArrayLike, y: ArrayLike, surface: int = 0) -> float | Array:
        """Return the settlement of a surface of the ground at points, by the elements' shape functions.

        Parameters
        ----------
        x, y
            Places [m], under the plate or beyond it: numbers or arrays of any shapes that broadcast against each other.
        surface
            Number of the surface: 0 is the top of the ground, 1 lies under the first layer, and so on.

        Returns
        -------
        float or Array
            In metres: a float for two numbers, else an array of the shape that x and y have together.

        Raises
        ------
        InputError
            If there is no such surface, if x and y do not fit together, or if a point lies outside the mesh; it names
            the points.
        """
        if surface not in range(len(self.settlement)):
            expected = f"a whole number from 0 to {len(self.settlement) - 1}"
            raise InputError([Issue("surface", describe(surface), expected)])
        return _values_at(Mesh(self.nodes, self.elements), self.settlement[surface], x, y, "the meshed ground")


def _values_at(mesh: Mesh, values: Array, x: ArrayLike, y: ArrayLike, region: str) -> float | Array:
    """Return nodal values (n,) at points: a float for two numbers, else an array of their shape."""
    places = _places(x, y)
    found = interpolated(mesh, values, _located(mesh, places, region))
    return float(found[0]) if places.ndim == 1 else found.reshape(places.shape[:-1])


def _places(x: ArrayLike, y: ArrayLike) -> Array:
    """Return points as an array (..., 2) of floats; InputError if x and y are no numbers or do not fit together."""
    try:
        places: Array = np.stack(np.broadcast_arrays(np.asarray(x, dtype=float), np.asarray(y, dtype=float)), axis=-1)
    except (TypeError, ValueError):
        found = " and ".join(describe(each) if np.ndim(each) == 0 else f"shape {np.shape(each)}" for each in (x, y))
        raise InputError([Issue("x, y", found, "numbers in metres, in shapes that broadcast")]) from None
    return places


def _located(mesh: Mesh, places: Array, region: str) -> Whereabouts:
    """Return the elements that hold points (..., 2) and the places in them; InputError names points outside."""
    boxes = _BOXES.get(mesh.elements, mesh.nodes, lambda: bounding_boxes(mesh))
    where = locate(mesh, places.reshape(-1, 2), boxes=boxes)
    outside = np.argwhere(where[0].reshape(places.shape[:-1]) < 0)
    issues = []
    for index in outside[:MOST_NAMED]:
        x, y = places[tuple(index)]
        issues.append(Issue(f"point{index.tolist() or ''}", f"({x:g}, {y:g}) m", f"a point on {region}"))
    if len(outside) > MOST_NAMED:
        found = f"{len(outside) - MOST_NAMED} more points outside"
        issues.append(Issue("points", found, f"points on {region}"))
    if issues:
        raise InputError(issues)
    return where


#: Boxes to search for points in, of the meshes at whose points values have been asked for.
_BOXES: Memo[STRtree] = Memo()


@dataclass(frozen=True, slots=True)
class SupportResult:
    """A support: what it carries, node by node along a line; one node for a point."""

    name: str
    nodes: Array  # (k, 2) [m]
    length: Array  # (k,) [m]: the share of the line that belongs to each node, 0 for a point
    settlement: Array  # (k,) [m], of the plate there
    force: Array  # (k,) [N], upwards positive, as it pushes the plate
    moment_x: Array  # (k,) [N m], positive if it presses the side of larger x down
    moment_y: Array  # (k,) [N m]

    @property
    def total(self) -> float:
        """Return the force of the whole support [N], upwards positive."""
        return float(self.force.sum())


@dataclass(frozen=True, slots=True)
class Constants:
    """The parameters of the ground that the analysis ended with (SI units, from the top layer downwards)."""

    k0: tuple[float, ...]
    k1: tuple[float, ...]
    gamma: float | None
    gamma_iterations: int


@dataclass(frozen=True, slots=True)
class Step:
    """One step of the iteration, as shown in the convergence history."""

    unknowns: int  # of the mesh that the step ran on
    increment: int  # of the load, from 1
    gamma: float | None
    iteration: int  # of the contact, from 1
    in_contact: int  # nodes
    changed: int  # nodes that change sides after this step
    finest: bool  # whether this is the mesh that was asked for


@dataclass(frozen=True, slots=True)
class Certificate:
    """How well the result fulfils the equations; every figure is a ratio unless it says otherwise.

    All of them are computed anew from the solution, with none of the matrices that were factorised. Of several load
    increments the worst counts.
    """

    residual: float  # largest force left over at a node / largest nodal force
    load: float  # sum of the loads [N]
    reaction: float  # sum of the contact forces and of the supports' reactions [N]
    force_balance: float  # |load - reaction| / sum of the loads' sizes
    moment_balance: float  # the same for the moments about both axes, over load size times plate size
    ground_balance: float  # contact forces against what the ground carries down and out, over load size
    worst_gap: float  # largest violation of g >= 0, over the largest settlement
    worst_pressure: float  # largest violation of p >= 0, over the largest nodal contact force
    worst_product: float  # largest |p g|, over largest contact force times largest settlement
    gamma_change: float  # relative change of gamma in the last step
    # infinite ground only: largest change of the settlement with a wider meshed margin, over the largest settlement
    margin_effect: float | None

    TOLERANCE = 1e-6
    MARGIN_TOLERANCE = 0.01

    @property
    def holds(self) -> bool:
        """Whether no figure is above its limit."""
        return not self.too_large()

    def too_large(self) -> dict[str, float]:
        """Return the figures that are above their limits, by name; one that is no number is, too."""
        figures, limits = self.limited(), self.limits()
        return {name: value for name, value in figures.items() if not value <= limits[name]}

    def limited(self) -> dict[str, float]:
        """Return the figures that have a limit, by name."""
        margin = {} if self.margin_effect is None else {"margin_effect": self.margin_effect}
        return self.must_vanish() | margin

    def limits(self) -> dict[str, float]:
        """Return the limit of each figure that has one, by name."""
        return dict.fromkeys(self.must_vanish(), self.TOLERANCE) | {"margin_effect": self.MARGIN_TOLERANCE}

    def must_vanish(self) -> dict[str, float]:
        """Return the figures that are zero for an exact solution, by name."""
        names = (
            "residual", "force_balance", "moment_balance", "ground_balance",
            "worst_gap", "worst_pressure", "worst_product", "gamma_change",
        )  # fmt: skip
        return {name: getattr(self, name) for name in names}


@dataclass(frozen=True, slots=True)
class Increment:
    """The state under a share of the load, on the way to all of it."""

    share: float  # of the load, settlements of supports included
    plate: PlateResult
    elements: ElementResult
    ground: GroundResult


@dataclass(frozen=True, slots=True)
class Results:
    """All that came out of one analysis, with the description that it came from."""

    model: Model
    plate: PlateResult
    elements: ElementResult
    ground: GroundResult
    constants: Constants
    certificate: Certificate
    steps: tuple[Step, ...]
    solver: str
    unknowns: int
    symmetry: tuple[bool, bool]
    combination: str
    limit_state: str
    factors: tuple[tuple[str, float], ...]
    supports: tuple[SupportResult, ...]
    increments: tuple[Increment, ...] = ()  # all but the last, which is what these results tell

    def plot(self, *fields: str, **wanted: Any) -> Figure:
        """Return a figure of these results: `groundslab.plot` with them."""
        from groundslab.views.plots import plot

        return plot(self, *fields, **wanted)


@dataclass(frozen=True, slots=True)
class Combined:
    """What came out of all combinations of a model, each solved by itself."""

    model: Model
    combinations: tuple[Combination, ...]
    results: dict[str, Results]  # by the combination's name
    refused: dict[str, GroundslabError]  # why the others have no results

    def __getitem__(self, combination: str) -> Results:
        """Return the results of a combination; raises what it was refused for."""
        if combination in self.refused:
            raise self.refused[combination]
        return self.results[combination]

    def plot(self, *fields: str, **wanted: Any) -> Figure:
        """Return a figure of the combinations' results: `groundslab.plot` with them."""
        from groundslab.views.plots import plot

        return plot(self, *fields, **wanted)


def alone(results: Results) -> Combined:
    """Return the results of one combination as those of all there are."""
    from groundslab.model.loads.load_cases import Combination

    about = {"name": results.combination, "limit_state": results.limit_state}
    combination = Combination(**about, factors=dict(results.factors) or {"": 1.0})
    if results.certificate.holds:
        return Combined(results.model, (combination,), {combination.name: results}, {})
    return Combined(results.model, (combination,), {}, {combination.name: NotCertified(results)})
