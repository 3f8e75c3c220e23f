"""Element matrices of plate and ground, each computed once for all elements of its kind."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.fem import plate
from groundslab.fem.assembly import find_congruent
from groundslab.fem.foundation import mass_and_slope
from groundslab.fem.hanging import connect
from groundslab.fem.parts import membrane as stretching
from groundslab.fem.problem import TOP, Problem


@dataclass(frozen=True, slots=True)
class Blocks:
    """Element matrices of the different kinds of elements, and the kind of each one.

    Elements that are alike share one matrix: of the same shape, rigidity or none, voids and hanging nodes. Of the
    ground, int N N and int grad N grad N are kept, to be scaled by the column. All are between the element's own nodes;
    T makes w at these from the nodes that have one, and P values of all fields from those of the nodes that move it.
    """

    kind: Integers  # (m,)
    plate: Array  # (u, 27, 27), zero beside the plate
    mass: Array  # (u, 9, 9)
    slope: Array  # (u, 9, 9)
    T: Array  # (u, 9, 9)
    P: Array  # (u, 9, 9): see `hanging.connect`
    membrane: Array  # (u, 18, 18), zero beside the plate; (u, 0, 0) where no plate has u and v

    def of(self, kinds: Integers) -> Blocks:
        """Return the blocks of some kinds (k,), renumbered."""
        every = self.plate, self.mass, self.slope, self.T, self.P, self.membrane
        return Blocks(np.arange(len(kinds)), *(array[kinds] for array in every))

    def between_unknowns(self, fields: int, in_plane: tuple[int, ...]) -> Array:
        """Return the plate's matrices between unknowns of nodes, (u, 9, 9, F, F); in_plane are the fields u and v."""
        K = np.zeros((len(self.plate), 9, 9, fields, fields))
        K[..., :TOP, :TOP] = self._between_fields(self.plate, TOP)
        if in_plane:
            u, v = in_plane
            K[..., u : v + 1, u : v + 1] = self._between_fields(self.membrane, len(in_plane))
        return K

    def _between_fields(self, matrices: Array, fields: int) -> Array:
        """Return matrices (u, 9 f, 9 f) between the fields of nodes that move the elements, (u, 9, 9, f, f)."""
        by_field = matrices.reshape(-1, fields, 9, fields, 9)
        hangs = self.hangs
        if hangs.any():
            P, by_field = self.P[hangs], by_field.copy()
            by_field[hangs] = np.einsum("eba,eibjc,ecd->eiajd", P, by_field[hangs], P, optimize=True)
        return by_field.transpose(0, 2, 4, 1, 3)

    @property
    def hangs(self) -> Flags:
        """Return which kinds have a node that hangs, (u,)."""
        return np.asarray((np.diagonal(self.P, axis1=1, axis2=2) < 1).any(axis=1))

    def ground(self, plate_rows: bool, plate_columns: bool) -> tuple[Array, Array]:
        """Return mass and slope (u, 9, 9) between fields, rows and columns being w of the plate or of the ground."""
        mass, slope, hang = self.mass, self.slope, bool(self.hangs.any())
        if plate_rows or hang:
            R = self.T @ self.P if plate_rows else self.P
            mass, slope = np.swapaxes(R, 1, 2) @ mass, np.swapaxes(R, 1, 2) @ slope
        if plate_columns or hang:
            C = self.T @ self.P if plate_columns else self.P
            mass, slope = mass @ C, slope @ C
        return mass, slope


def blocks(problem: Problem) -> Blocks:
    """Return the element matrices of a problem, each computed once for all elements of its kind."""
    xy = problem.mesh.xy
    sheet = problem.plate
    depths = problem.contact.depths
    sections = len(sheet.bending)
    masses = depths.mass_kinds
    shapes, shape = find_congruent(xy)
    _, hanging, P, halves = connect(problem.mesh.elements)
    section = np.full(len(xy), sections)  # none
    section[sheet.elements] = sheet.rigidity
    all_kinds = ((shape * (sections + 1) + section) * len(masses) + depths.mass_kind) * len(P) + hanging
    kinds, kind = np.unique(all_kinds, return_inverse=True)
    kinds, P, halves = kinds // len(P), P[kinds % len(P)], halves[kinds % len(P)]
    kinds, masses = kinds // len(masses), masses[kinds % len(masses)]
    xy, section = xy[shapes[kinds // (sections + 1)]], kinds % (sections + 1)
    under = np.flatnonzero(section < sections)
    K, T = np.zeros((len(kinds), 27, 27)), np.tile(np.eye(9), (len(kinds), 1, 1))
    section = section[under]
    T[under] = sheet.element.w_functions(xy[under])
    rigidities = sheet.bending[section], sheet.shear[section]
    K[under] = plate.stiffness(sheet.element, xy[under], *rigidities, T[under], halves[under])
    stretches = bool(len(sheet.membrane))
    membrane = np.zeros((len(kinds), 18, 18) if stretches else (len(kinds), 0, 0))
    if stretches:
        of_rigidity = np.empty(sections, dtype=np.int64)
        of_rigidity[sheet.rigidity] = sheet.section
        membrane[under] = stretching.stiffness(xy[under], sheet.membrane[of_rigidity[section]])
    mass, slope = mass_and_slope(xy)
    on_diagonal = masses[:, 1:] * mass.sum(axis=2)
    return Blocks(kind, K, masses[:, :1, None] * mass + on_diagonal[:, :, None] * np.eye(9), slope, T, P, membrane)
