"""Timoshenko beams along sides of plate elements: where they run, their stiffness, and section forces at points.

Unknowns of a piece, node after node (start, end, middle): w, beta_x, beta_y of the plate, on whose middle plane the
beam's axis lies. The beam bends by the slope beta . t along its direction t, twists by beta . n, n to the left of it:

    M = -E I t . dbeta/ds,   T = -G J n . dbeta/ds,   V = G A_v (dw/ds - t . beta),

s along the axis, which may be curved. All are integrated at two points, where the shear strain of a quadratic w and
beta is taken on MITC9's sides, too: neither locks (Zienkiewicz, Taylor and Too 1971). See docs/theory.md, beams.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.fem.shape_functions import gauss_line

#: The two Gauss points, from -1 at the start to 1 at the end.
POINTS = np.array([-1.0, 1.0]) / np.sqrt(3.0)
#: Of a line through the values at both points: its values at the start and at the end.
TO_ENDS = np.array([[1 + np.sqrt(3.0), 1 - np.sqrt(3.0)], [1 - np.sqrt(3.0), 1 + np.sqrt(3.0)]]) / 2


@dataclass(frozen=True, slots=True)
class Beams:
    """All beams on a mesh, b pieces together: each runs along one side of an element."""

    sides: Integers  # (b, 3): start, end and middle node of each piece, in the direction of its beam
    number: Integers  # (b,): which beam it belongs to; the pieces of a beam follow each other
    start: Array  # (b,) [m]: where it starts, measured along the beam
    length: Array  # (b,) [m]
    rigidity: Array  # (b, 3): E I and G J [N m2], G A_s [N]
    released: Flags  # (b, 2): whether it bends freely at its start, at its end: hinges at ends of beams


def stiffness(beams: Beams, nodes: Array) -> Array:
    """Return the stiffness matrices (b, 3, 3, 3, 3) of pieces between nodes a, c and fields i, j: entry [a, c, i, j].

    nodes (n, 2) are those of the mesh [m]. What is released has been eliminated.
    """
    xy = nodes[beams.sides]
    K = _full_stiffness(xy, beams.rigidity)
    if beams.released.any():
        some = beams.released.any(axis=1)
        _, K_r, inverse = _releases(xy[some], K[some], beams.released[some])
        K[some] -= np.einsum("bkai,bkl,blcj->bacij", K_r, inverse, K_r)
    return K


def section_forces(beams: Beams, nodes: Array, u: Array) -> Array:
    """Return M [N m], T [N m] and V [N] at both Gauss points of pieces, (b, 2, 3), for unknowns u (b, 3, 3).

    u are w, beta_x and beta_y of each node. M is positive where the beam sags, V = dM/ds where no torsion enters.
    """
    xy = nodes[beams.sides]
    B, _ = _strains(xy)
    own = without_motion(xy, u)
    if beams.released.any():
        some = beams.released.any(axis=1)
        K = _full_stiffness(xy[some], beams.rigidity[some])
        released, K_r, inverse = _releases(xy[some], K, beams.released[some])
        turned = np.einsum("bkl,blai,bai->bk", inverse, K_r, own[some])
        own[some] -= np.einsum("bk,bkai->bai", turned, released)
    forces: Array = np.einsum("bprai,bai->bpr", B, own) * beams.rigidity[:, None] * [-1.0, -1.0, 1.0]
    return forces


def _full_stiffness(xy: Array, rigidity: Array) -> Array:
    """Return the stiffness matrices of pieces whose ends turn with the plate."""
    B, ds = _strains(xy)
    K: Array = np.einsum("bprai,br,bp,bprcj->bacij", B, rigidity, ds, B, optimize=True)
    return K


def _releases(xy: Array, K: Array, released: Flags) -> tuple[Array, Array, Array]:
    """Return the slopes along the axis at released ends as unknowns r (b, 2, 3, 3), K r, and (r . K r)^-1 (b, 2, 2).

    An end that is not released has neither.
    """
    a, b, middle = (xy[:, k] for k in range(3))
    ways = np.stack([2 * middle - 1.5 * a - 0.5 * b, 0.5 * a + 1.5 * b - 2 * middle], axis=1)
    r = np.zeros((len(xy), 2, 3, 3))
    for end in (0, 1):
        r[:, end, end, 1:] = ways[:, end] / np.linalg.norm(ways[:, end], axis=1, keepdims=True)
    r[~released] = 0.0
    K_r = np.einsum("bacij,bkcj->bkai", K, r)
    resisted = np.einsum("bkai,blai->bkl", r, K_r)
    resisted[:, [0, 1], [0, 1]] += ~released
    return r, K_r, np.linalg.inv(resisted)


def without_motion(xy: Array, u: Array) -> Array:
    """Return unknowns (b, 3, 3) less the rigid motion of each piece's middle, whose size would be rounding."""
    left: Array = u - u[:, 2:]
    left[..., 0] -= np.einsum("bax,bx->ba", xy - xy[:, 2:], u[:, 2, 1:])
    return left


def lengths_of(xy: Array) -> Array:
    """Return the lengths (b,) [m] of pieces between nodes xy (b, 3, 2), which may be curved."""
    s, weights = gauss_line(3)
    dN = np.column_stack([s - 0.5, s + 0.5, -2 * s])
    length: Array = np.linalg.norm(np.einsum("pa,bax->bpx", dN, xy), axis=2) @ weights
    return length


def _strains(xy: Array) -> tuple[Array, Array]:
    """Return B (b, 2, 3, 3, 3) from fields (last) of nodes to curvature, twist and shear strain, and ds (b, 2) [m]."""
    s = POINTS[:, None]
    N = np.hstack([s * (s - 1) / 2, s * (s + 1) / 2, 1 - s * s])
    dN = np.hstack([s - 0.5, s + 0.5, -2 * s])
    along = np.einsum("pa,bax->bpx", dN, xy)
    ds = np.linalg.norm(along, axis=2)
    t = along / ds[..., None]
    n = np.stack([-t[..., 1], t[..., 0]], axis=-1)
    slope = dN / ds[..., None]
    B = np.zeros((len(xy), 2, 3, 3, 3))
    B[:, :, 0, :, 1:] = slope[..., None] * t[:, :, None]
    B[:, :, 1, :, 1:] = slope[..., None] * n[:, :, None]
    B[:, :, 2, :, 0] = slope
    B[:, :, 2, :, 1:] = -N[:, :, None] * t[:, :, None]
    return B, ds
