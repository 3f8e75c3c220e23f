"""Results on meshes: fields of the plate, its elements, the ground and the supports, as frozen arrays in SI units."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.errors import InputError, Issue
from groundslab.fem.continuum.pressed_cells import PressedCells
from groundslab.fem.mesh import Mesh, in_space, interpolate, locate_within
from groundslab.optional import import_optional
from groundslab.results.fields import PLATE_FIELDS
from groundslab.schema.wording import describe, one_of, suggestion

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from pyvista import UnstructuredGrid


@dataclass(frozen=True, slots=True, weakref_slot=True)
class PlateResult:
    """The plate: its nine-node mesh and nodal fields in SI units, n nodes and m elements.

    Moments and shear forces are recovered by patches of elements. A node stands once for each side where fields jump:
    on the border of two sections (zones of the plate) or of two zones of springs, along line loads and line supports.

    Attributes
    ----------
    nodes : (n, 2) array of float
        Coordinates of the nodes [m].
    elements : (m, 9) array of int
        Nodes of the elements: four corners, four midsides, center.
    settlement : (n,) array of float
        Settlement w [m], downwards positive.
    rotation_x, rotation_y : (n,) array of float
        Rotations of the normal beta_x, beta_y [rad]: u = -z beta_x, v = -z beta_y.
    gap : (n,) array of float
        Distance between plate and ground [m].
    penetration : (n,) array of float
        How far the plate has sunk into ground that yields [m].
    pressure : (n,) array of float
        Contact pressure [Pa], compression positive.
    line_force : (n,) array of float
        Line force of the ground along the plate's edge [N/m], upwards positive; 0 inside.
    moment_x, moment_y, moment_xy : (n,) array of float
        Bending and twisting moments [N m/m], sagging positive.
    shear_x, shear_y : (n,) array of float
        Transverse shear forces [N/m].
    in_contact : (n,) array of bool
        Whether the node rests on the ground.
    area : (n,) array of float
        Each node's share of the plate's area [m2].
    contact_area : (n,) array of float
        What of it rests on the ground [m2]; beside a void or a cavity, and where the plate lifts off springs, it may be
        a part.
    edge_length : (n,) array of float
        Each node's share of the length of the plate's edge [m]; 0 inside.

    See Also
    --------
    ElementResult : The same forces element by element, not averaged.
    """

    nodes: Array
    elements: Integers
    settlement: Array
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
    in_contact: Flags
    area: Array
    contact_area: Array
    edge_length: Array

    @property
    def contact_force(self) -> Array:
        """The ground's force on each node (n,) [N]: its pressure and its line force."""
        return self.pressure * self.area + self.line_force * self.edge_length

    @property
    def contact_share(self) -> float:
        """The part of the plate's area that rests on the ground."""
        return float(self.contact_area.sum() / self.area.sum())

    def part(self, elements: Flags) -> PlateResult:
        """Return some of the elements with their nodes, as one of several plates.

        Parameters
        ----------
        elements : (m,) array of bool
            Which elements.

        Returns
        -------
        PlateResult
            Their nodes and elements, numbered anew, with the same fields.
        """
        nodes, numbers = np.unique(self.elements[elements], return_inverse=True)
        nodal = {field.name: getattr(self, field.name)[nodes] for field in fields(self) if field.name != "elements"}
        return PlateResult(elements=numbers.reshape(-1, 9), **nodal)

    def point_data(self) -> dict[str, Array]:
        """Return the nodal fields in SI units, by names with these, such as "settlement w [m]".

        Returns
        -------
        dict of str to array
            The fields (n,), and which nodes are in contact as 1 or 0.
        """
        data: dict[str, Any] = {about.si_name: getattr(self, name) for name, about in PLATE_FIELDS.items()}
        return data | self.node_data()

    def node_data(self) -> dict[str, Array]:
        """Return what is known of the nodes beside their fields, in SI units, by name.

        Returns
        -------
        dict of str to array
            Areas and lengths (n,), and which nodes are in contact as 1 or 0.
        """
        data: dict[str, Any] = {}
        data["in contact"] = self.in_contact.astype(np.int8)
        data["area of the node [m2]"] = self.area
        data["area of the node in contact [m2]"] = self.contact_area
        data["length of the edge at the node [m]"] = self.edge_length
        return data

    def to_pyvista(self) -> UnstructuredGrid:
        """Return the plate as a grid of PyVista, with its nodal fields in SI units.

        Returns
        -------
        pyvista.UnstructuredGrid
            Biquadratic quadrilaterals at z = 0, with the arrays of `point_data`.

        Raises
        ------
        InputError
            If PyVista is not installed.
        """
        pyvista = import_optional("pyvista", "which makes grids", "viz")
        grid = pyvista.UnstructuredGrid({pyvista.CellType.BIQUADRATIC_QUAD: self.elements}, in_space(self.nodes))
        for name, values in self.point_data().items():
            grid.point_data[name] = values
        return grid

    @overload
    def value_at(self, field: str, x: float, y: float) -> float: ...
    @overload
    def value_at(self, field: str, x: ArrayLike, y: ArrayLike) -> Array: ...
    def value_at(self, field: str, x: ArrayLike, y: ArrayLike) -> float | Array:
        """Return a nodal field at points of the plate, interpolated by the elements' shape functions.

        Parameters
        ----------
        field : str
            Name of a nodal field, such as "settlement" or "moment_x".
        x, y : array_like of float
            Coordinates [m], of any shapes that broadcast against each other.

        Returns
        -------
        float or array of float
            In the field's SI unit: a float for two numbers, else an array of the broadcast shape of x and y. On the
            border of two sections, and along line loads and line supports, the value is that of one side.

        Raises
        ------
        InputError
            If there is no such field, if x and y do not fit together, or if a point does not lie on the plate; it names
            the points.

        Examples
        --------
        >>> plate = results.plate
        >>> print(f"{1e3 * plate.value_at('settlement', 0.0, 0.0):.2f} mm")
        3.00 mm
        >>> plate.value_at("moment_x", [0.0, 1.0, 2.0], 0.0).shape
        (3,)
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
        """Return the element of the plate that holds each point, to read fields of elements there.

        `results.elements.moment_x[results.plate.element_at(x, y)]`, for example, is the element's own moment, not
        averaged.

        Parameters
        ----------
        x, y : array_like of float
            Coordinates [m], of any shapes that broadcast against each other.

        Returns
        -------
        int or array of int
            Rows of `elements`: an int for two numbers, else an array of the broadcast shape of x and y. A point on a
            common side belongs to one of its elements.

        Raises
        ------
        InputError
            If x and y do not fit together, or if a point does not lie on the plate; it names the points.

        Examples
        --------
        >>> element = results.plate.element_at(0.5, 0.5)
        >>> print(f"{1e3 * results.elements.thickness[element]:.0f} mm")
        300 mm
        """
        points = _points(x, y)
        elements: Integers = locate_within(Mesh(self.nodes, self.elements), points, "the plate")[0]
        return int(elements[0]) if points.ndim == 1 else elements.reshape(points.shape[:-1])


@dataclass(frozen=True, slots=True)
class ElementResult:
    """The plate's elements, in the order of `PlateResult.elements`: values at their centers, not averaged between them.

    Attributes
    ----------
    pressure : (m,) array of float
        Mean contact pressure under the element [Pa], without line forces.
    moment_x, moment_y, moment_xy : (m,) array of float
        Bending and twisting moments [N m/m], sagging positive.
    shear_x, shear_y : (m,) array of float
        Transverse shear forces [N/m].
    thickness : (m,) array of float
        Thickness of the plate [m].
    section : (m,) array of int
        Section of the plate: 0 outside all zones, else the number of the zone, from 1.
    discretization_error : (m,) array of float or None
        Density of the discretization error in energy [1], large where the mesh is too coarse. None if unknown.
    stiffness_ratio : (m,) array of float or None
        Lesser bending stiffness along x and y over that of the uncracked section [1]. None if nothing may crack.
    membrane_x, membrane_y, membrane_xy : (m,) array of float or None
        Forces in the plate's plane [N/m], tension positive. None if no beam is eccentric.
    """

    pressure: Array
    moment_x: Array
    moment_y: Array
    moment_xy: Array
    shear_x: Array
    shear_y: Array
    thickness: Array
    section: Integers
    discretization_error: Array | None = None
    stiffness_ratio: Array | None = None
    membrane_x: Array | None = None
    membrane_y: Array | None = None
    membrane_xy: Array | None = None

    def at_nodes(self, plate: PlateResult) -> tuple[Array, Integers]:
        """Return thickness [m] and section of the plate's nodes, (n,) each: a node belongs to one section only.

        Parameters
        ----------
        plate : PlateResult
            The plate of the same results.

        Returns
        -------
        thickness : (n,) array of float
            Thickness at each node [m].
        section : (n,) array of int
            Section of each node.
        """
        thickness, section = np.zeros(len(plate.nodes)), np.zeros(len(plate.nodes), dtype=np.int64)
        thickness[plate.elements] = self.thickness[:, None]
        section[plate.elements] = self.section[:, None]
        return thickness, section


@dataclass(frozen=True, slots=True)
class GroundResult:
    """The ground, under the plate and beyond it.

    Attributes
    ----------
    nodes : (n, 2) array of float
        Coordinates of the nodes [m].
    elements : (m, 9) array of int
        Nodes of the elements: four corners, four midsides, center.
    settlement : (S, n) array of float
        Settlement of every surface [m], from the top one downwards.
    cells : PressedCells or None
        On an elastic continuum the cells on which the plate presses; None on other ground.
    """

    nodes: Array
    elements: Integers
    settlement: Array
    cells: PressedCells | None = None

    @overload
    def value_at(self, x: float, y: float, surface: int = 0) -> float: ...
    @overload
    def value_at(self, x: ArrayLike, y: ArrayLike, surface: int = 0) -> Array: ...
    def value_at(self, x: ArrayLike, y: ArrayLike, surface: int = 0) -> float | Array:
        """Return the settlement of a surface of the ground at points, interpolated by the elements' shape functions.

        Parameters
        ----------
        x, y : array_like of float
            Coordinates [m] under the plate or beyond it, of any shapes that broadcast against each other.
        surface : int, default: 0
            Number of the surface: 0 is the top of the ground, 1 lies under the first layer, and so on.

        Returns
        -------
        float or array of float
            Settlement [m]: a float for two numbers, else an array of the broadcast shape of x and y.

        Raises
        ------
        InputError
            If there is no such surface, if x and y do not fit together, or if a point lies outside the mesh; it names
            the points.

        Examples
        --------
        >>> print(f"{1e3 * results.ground.value_at(0.0, 0.0):.2f} mm")
        3.00 mm
        """
        if surface not in range(len(self.settlement)):
            expected = f"a whole number from 0 to {len(self.settlement) - 1}"
            raise InputError([Issue("surface", describe(surface), expected)])
        return _values_at(Mesh(self.nodes, self.elements), self.settlement[surface], x, y, "the meshed ground")

    def settlement_at(self, x: ArrayLike, y: ArrayLike, z: ArrayLike) -> Array:
        """Return the settlement of a continuum at points anywhere in it, beside the plate too.

        Parameters
        ----------
        x, y, z : array_like of float
            Coordinates and depth below the base of the plate [m], of any shapes that broadcast against each other.

        Returns
        -------
        array of float
            Settlement [m]; at the surface, half a cell about the plate's edge, it wavers by up to a fifth.

        Raises
        ------
        InputError
            If the ground is no continuum, or if a point lies above its surface or below its base.
        """
        if self.cells is not None and not self.cells.settles_alike:
            raise InputError([Issue("ground", "layers that differ from place to place", "the same layers everywhere")])
        return self._in_depth(0, x, y, z)

    def stress_at(self, x: ArrayLike, y: ArrayLike, z: ArrayLike) -> Array:
        """Return the vertical stress by the plate in a continuum, without the soil's own weight.

        Parameters
        ----------
        x, y, z : array_like of float
            Points as for `settlement_at` [m].

        Returns
        -------
        array of float
            Stress sigma_z [Pa], compression positive; at z = 0 the pressure of the cell.
        """
        return self._in_depth(1, x, y, z)

    def _in_depth(self, which: int, *coordinates: ArrayLike) -> Array:
        """Return settlement (0) or vertical stress (1) at points."""
        if self.cells is None:
            raise InputError([Issue("ground", "ground of which only surfaces are known", "a continuum")])
        points = _points(*coordinates)
        return self.cells.at_points(points.reshape(-1, 3))[which].reshape(points.shape[:-1])


def _values_at(mesh: Mesh, values: Array, x: ArrayLike, y: ArrayLike, region: str) -> float | Array:
    """Return nodal values (n,) at points: a float for two numbers, else an array of their shape."""
    points = _points(x, y)
    values_there = interpolate(mesh, values, locate_within(mesh, points, region))
    return float(values_there[0]) if points.ndim == 1 else values_there.reshape(points.shape[:-1])


def _points(*coordinates: ArrayLike) -> Array:
    """Return points as an array (..., 2 or 3) of floats; InputError if these are no numbers or do not fit together."""
    try:
        points: Array = np.stack(np.broadcast_arrays(*(np.asarray(x, dtype=float) for x in coordinates)), axis=-1)
    except (TypeError, ValueError):
        shapes = " and ".join(
            describe(coordinate) if np.ndim(coordinate) == 0 else f"shape {np.shape(coordinate)}"
            for coordinate in coordinates
        )
        names = ", ".join("xyz"[: len(coordinates)])
        raise InputError([Issue(names, shapes, "numbers in meters, in shapes that broadcast")]) from None
    return points
