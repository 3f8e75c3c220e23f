"""Ground made of surfaces that carry one settlement each: element matrices, columns of layers, infinite edges.

The energy per plan area of a column with S free surfaces is 1/2 w.A0 w + 1/2 grad w . A1 grad w, with A0 [Pa/m] and
A1 [Pa m] symmetric S x S matrices (top surface first, rigid base left out). Winkler, Pasternak, Vlasov, a stack of
interface elements and the consistent stack differ in A0 and A1 alone.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.fem.shape_functions import CHUNK, derivatives, gauss, q9_values

#: A number for one column of soil, or one for each of c columns, (c,).
Values = float | Array


@dataclass(frozen=True, slots=True)
class Parts:
    """Which columns lie under the elements of a mesh: p parts of elements, of each element at least one."""

    element: Integers  # (p,), ascending
    column: Integers  # (p,)
    area_fraction: Array  # (p,): of the element's area

    def mean(self, values: Array) -> Array:
        """Return the mean (m, ...) over each element of what the columns have (c, ...)."""
        weighted = self.area_fraction.reshape(-1, *(1,) * (values.ndim - 1)) * values[self.column]
        return np.add.reduceat(weighted, np.flatnonzero(np.diff(self.element, prepend=-1)), axis=0)


@dataclass(frozen=True, slots=True)
class Column:
    """The ground under one point of the plan: A0 [Pa/m] and A1 [Pa m], each (S, S), or (m, S, S) by element."""

    A0: Array
    A1: Array

    @property
    def surfaces(self) -> int:
        """Return S, the number of surfaces that can settle."""
        return int(self.A0.shape[-1])

    @property
    def varies(self) -> bool:
        """Return whether A0 and A1 are given by element."""
        return self.A0.ndim > 2

    def at(self, elements: Integers) -> Column:
        """Return the columns (e, S, S) of some elements (e,), or the one column that all have."""
        return Column(self.A0[elements], self.A1[elements]) if self.varies else self

    def mix(self, parts: Parts) -> Column:
        """Return the mean column under each element of a mesh, of columns (c, S, S) under parts of them."""
        return Column(parts.mean(self.A0), parts.mean(self.A1))


@dataclass(frozen=True, slots=True)
class Layer:
    """A soil layer of some thickness [m] and Poisson's ratio nu, with E a quadratic in the relative depth s = z / h.

    Where the ground varies over the plan, all of them are arrays (c,) over its columns.
    """

    thickness: Values
    moduli: tuple[Values, Values, Values]  # c0, c1, c2 [Pa] of E = c0 + c1 s + c2 s^2
    nu: Values

    def E(self, s: Array) -> Array:
        """Return E [Pa] at the relative depth s (paper (1.1), (1.2)); s broadcasts against the columns."""
        c0, c1, c2 = self.moduli
        return c0 + s * (c1 + s * c2)

    @property
    def mean(self) -> Values:
        """Return the mean of E over the thickness [Pa]."""
        c0, c1, c2 = self.moduli
        return c0 + c1 / 2 + c2 / 3

    @property
    def oedometric_ratio(self) -> Values:
        """Return Ec / E for confined compression, (1 - nu) / ((1 + nu)(1 - 2 nu))."""
        return (1 - self.nu) / ((1 + self.nu) * (1 - 2 * self.nu))

    @property
    def shear(self) -> Values:
        """Return G / E."""
        return 1 / (2 * (1 + self.nu))

    @property
    def stiffnesses(self) -> tuple[Values, Values]:
        """Return Ec / h [Pa/m] and G h [Pa m] for the mean of E."""
        return self.oedometric_ratio * self.mean / self.thickness, self.shear * self.mean * self.thickness

    def at(self, columns: slice | Flags) -> Layer:
        """Return the layer of some of the columns."""
        thickness, c0, c1, c2, nu = (np.asarray(value)[columns] for value in (self.thickness, *self.moduli, self.nu))
        return Layer(thickness, (c0, c1, c2), nu)

    def split(self, n: int) -> list[Layer]:
        """Return n equal parts of the layer, each with the moduli of its own depths."""
        _, c1, c2 = self.moduli
        starts = np.arange(n) / n
        return [Layer(self.thickness / n, (self.E(s), (c1 + 2 * c2 * s) / n, c2 / n**2), self.nu) for s in starts]


def single(k0: Array | float, k1: Array | float) -> Column:
    """Return the column of one surface on k0 [Pa/m] and k1 [Pa m] (scalars, or arrays over elements)."""
    k0, k1 = np.broadcast_arrays(np.asarray(k0, float), np.asarray(k1, float))
    return Column(k0[..., None, None].copy(), k1[..., None, None].copy())


def interface_stack(k0: Array, k1: Array) -> Column:
    """Return the column of interface layers, (paper (2.3), (2.5)): energy of d = w_top - w_bottom in each.

    k0 and k1 are (L,) or (m, L), from the top layer downwards.
    """
    pair = np.array([[1.0, -1.0], [-1.0, 1.0]])
    return Column(_stack(k0[..., None, None] * pair), _stack(k1[..., None, None] * pair))


def consistent_stack(layers: list[Layer]) -> Column:
    """Return the column in which the settlement is linear in z within each layer, E(z) integrated exactly.

    Of layers over c columns, the c columns (c, S, S).
    """
    A0, A1 = [], []
    for layer in layers:
        s, weight = np.polynomial.legendre.leggauss(4)
        s, weight = (s + 1) / 2, weight / 2
        psi = np.stack([1 - s, s])
        h = np.asarray(layer.thickness)
        of_columns = (slice(None), *(None,) * h.ndim)
        E = layer.E(s[of_columns]) * weight[of_columns]
        slope = np.array([[1.0, -1.0], [-1.0, 1.0]]) / h[..., None, None]
        A0.append(np.asarray(layer.oedometric_ratio * E.sum(axis=0))[..., None, None] * slope)
        A1.append(np.asarray(layer.shear * h)[..., None, None] * np.einsum("is,js,s...->...ij", psi, psi, E))
    return Column(_stack(np.stack(A0, axis=-3)), _stack(np.stack(A1, axis=-3)))


def _stack(layers: Array) -> Array:
    """Return the sum (..., L, L) of layer matrices (..., L, 2, 2), the rigid base's row and column left out."""
    L = layers.shape[-3]
    A = np.zeros((*layers.shape[:-3], L + 1, L + 1))
    for i in range(L):
        A[..., i : i + 2, i : i + 2] += layers[..., i, :, :]
    return A[..., :L, :L]


def mass_and_slope(xy: Array) -> tuple[Array, Array]:
    """Return int N N^T dA (m, 9, 9) [m2] and int grad N . grad N^T dA (m, 9, 9) of m elements (paper (2.9), (2.10)).

    Four Gauss points each way, so that both are exact on rectangles and the mass on every straight-sided quadrilateral.
    """
    points, weights = gauss(4)
    N = q9_values(points)
    mass, slope = (np.empty((len(xy), 9, 9)) for _ in range(2))
    for start in range(0, len(xy), CHUNK):
        chunk = slice(start, start + CHUNK)
        x, y, det = derivatives(points, xy[chunk])
        dA = det * weights
        mass[chunk] = (dA @ (N[:, :, None] * N[:, None, :]).reshape(-1, 81)).reshape(-1, 9, 9)
        slope[chunk] = x.swapaxes(1, 2) @ (dA[..., None] * x) + y.swapaxes(1, 2) @ (dA[..., None] * y)
    return mass, slope


#: Mass and stiffness of a three-node edge (end, end, middle) of unit length.
EDGE_MASS = np.array([[4.0, -1.0, 2.0], [-1.0, 4.0, 2.0], [2.0, 2.0, 16.0]]) / 30
EDGE_SLOPE = np.array([[7.0, 1.0, -8.0], [1.0, 7.0, -8.0], [-8.0, -8.0, 16.0]]) / 3


@dataclass(frozen=True, slots=True)
class EdgeDecay:
    """Decay of the infinite ground beyond a straight edge, in modes phi exp(-a d): A0 phi = a^2 A1 phi, phi.A1 phi = 1.

    The amplitudes of the modes at an edge that settles by w are `projection` w (docs/theory.md, infinite ground). All
    arrays have a leading axis of edges, (e, ...), where the ground varies.
    """

    phi: Array  # (S, S): a mode in each column
    projection: Array  # (S, S): phi^T A1
    decay: Array  # (S,) [1/m]: a

    @property
    def varies(self) -> bool:
        """Return whether the tails differ between edges."""
        return self.decay.ndim > 1

    @property
    def spring(self) -> Array:
        """Return the edge spring (S, S) [Pa] on w along the edge; sqrt(k0 k1) for one surface."""
        return self.projection.swapaxes(-1, -2) @ (self.decay[..., None] * self.projection)

    @property
    def slope(self) -> Array:
        """Return the edge stiffness (S, S) [Pa m2] on the tangential derivative of w; k1 / 2a for one surface."""
        return self.projection.swapaxes(-1, -2) @ (self.projection / (2 * self.decay[..., None]))

    @property
    def corner(self) -> Array:
        """Return the spring (S, S) [Pa m] of the quarter plane between two edges; 3 k1 / 4 for one surface."""
        return 0.75 * self.projection.swapaxes(-1, -2) @ self.projection

    def square_integrals(self) -> tuple[Array, Array, Array, Array]:
        """Return matrices (S, S) on the amplitudes c that integrate the top surface's w0 over the ground beyond.

        X [m]: int w0^2 = c.X c for each edge length, and c,s.X c,s for its tangential derivative; Y [1/m]: the normal
        derivative squared; at a corner Xc [m2]: int w0^2, Yc [-]: int |grad w0|^2. For one surface they are 1/2a, a/2,
        1/4a^2 and 1/2.
        """
        a = self.decay
        at_top = self.phi[..., 0, :]
        top = at_top[..., :, None] * at_top[..., None, :]
        total, product = a[..., :, None] + a[..., None, :], a[..., :, None] * a[..., None, :]
        return top / total, top * product / total, top / total**2, 2 * top * product / total**2


def edge_decay(column: Column) -> EdgeDecay:
    """Return the tail of a column whose layers all carry shear, or the tails of columns (e, S, S)."""
    L = np.linalg.cholesky(column.A1)
    inner = np.linalg.solve(L, np.linalg.solve(L, column.A0).swapaxes(-1, -2))
    a2, V = np.linalg.eigh((inner + inner.swapaxes(-1, -2)) / 2)
    return EdgeDecay(np.linalg.solve(L.swapaxes(-1, -2), V), (L @ V).swapaxes(-1, -2), np.sqrt(a2))


def decay_length(column: Column) -> float:
    """Return the length [m] over which the ground's surface dies out beyond an edge that presses it down.

    It is sqrt(k1/k0) for one surface. Of several, which are taken to settle along the edge as they do under a load
    everywhere, the modes count by their share in the edge's force: 1/L is the mean of their decays a, each weighed by
    the square of its amplitude.
    """
    t = edge_decay(column)
    amplitudes = t.projection @ np.linalg.solve(column.A0, np.eye(column.surfaces)[0])
    return float(amplitudes @ amplitudes / (amplitudes @ (t.decay * amplitudes)))
