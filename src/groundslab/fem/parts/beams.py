"""Timoshenko beams along sides of plate elements: where they run, their stiffness, and section forces at points.

Unknowns of a piece, node after node (start, end, middle): w, beta_x, beta_y of the plate, and u, v of its middle plane,
e below which the beam's centroid lies. The beam bends by the slope beta . t along its direction t, twists by beta . n,
n to the left of it, and stretches:

    M = -E I t . dbeta/ds,   T = -G J n . dbeta/ds,   V = G A_v (dw/ds - t . beta),   N = E A t . (du/ds - e dbeta/ds),

M about its own centroid, s along the axis, which may be curved. All are integrated at two points, where the shear
strain of a quadratic w and beta is taken on MITC9's sides, too, and u and e beta are of one order: nothing locks
(Zienkiewicz, Taylor and Too 1971).

Walls are deep beams, which shear as much as they bend. The plate's normals follow a wall's foot, the slope of which
differs from its sections' by that shear strain: beta . t is an unknown of its own, theta, up to the wall's corners.
Over an opening a beam spans from edge to edge, with no nodes between: exactly, as without loads M is linear there and V
constant. What acts on it there goes to both ends as if these were fixed, see `spans`.
See docs/theory.md, beams.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.fem.shape_functions import gauss_line

#: w, beta_x, beta_y, u, v, theta of a node.
FIELDS, THETA = 6, 5
#: The two Gauss points, from -1 at the start to 1 at the end.
POINTS = np.array([-1.0, 1.0]) / np.sqrt(3.0)
#: Of a line through the values at both points: its values at the start and at the end.
TO_ENDS = np.array([[1 + np.sqrt(3.0), 1 - np.sqrt(3.0)], [1 - np.sqrt(3.0), 1 + np.sqrt(3.0)]]) / 2


@dataclass(frozen=True, slots=True)
class Beams:
    """All beams on a mesh, b pieces together: each runs along one side of an element."""

    sides: Integers  # (b, 3): start, end and middle node of each piece, along its beam; of a span start, end and start
    number: Integers  # (b,): which beam it belongs to; the pieces of a beam follow each other
    start: Array  # (b,) [m]: where it starts, measured along the beam
    length: Array  # (b,) [m]
    rigidity: Array  # (b, 4): E I and G J [N m2], G A_v and E A [N], of which the last is 0 of concentric ones
    eccentricity: Array  # (b,) [m]: how far the centroid lies below the plate's middle plane
    released: Flags  # (b, 2): whether it bends freely at its start, at its end: hinges at ends of beams
    smooth: Flags  # (b,): whether it goes on from the piece before, which may be another beam's, without a corner
    theta: Integers  # (b,): field of theta at its nodes, 0 where its sections turn with the plate
    along: Array  # (b, 3, 2): direction of the axis at its nodes

    @property
    def deep(self) -> Flags:
        """Return which pieces are deep beams, the sections of which turn by themselves, (b,)."""
        return self.theta > 0

    @property
    def spans(self) -> Flags:
        """Return which pieces span an opening, (b,)."""
        mask: Flags = self.sides[:, 2] == self.sides[:, 0]
        return mask


def stiffness(beams: Beams, nodes: Array) -> Array:
    """Return the stiffness matrices (b, 3, 3, 6, 6) of pieces between nodes a, c and fields i, j: entry [a, c, i, j].

    nodes (n, 2) are those of the mesh [m]. What is released has been eliminated.
    """
    K = _full_stiffness(beams, nodes)
    if beams.released.any():
        mask = beams.released.any(axis=1)
        _, K_r, inverse = _releases(nodes[beams.sides[mask]], K[mask], beams.released[mask])
        K[mask] -= np.einsum("bkai,bkl,blcj->bacij", K_r, inverse, K_r)
    return K


def section_forces(beams: Beams, nodes: Array, u: Array) -> Array:
    """Return M, T [N m], V and N [N] at both Gauss points of pieces, (b, 2, 4), for unknowns u (b, 3, 6) of nodes.

    M is positive where the beam sags, N in tension. V = d(M + e N)/ds where no torsion enters.
    """
    B, _ = _strains(beams, nodes)
    deformation = without_motion(beams, nodes, u)
    if beams.released.any():
        mask = beams.released.any(axis=1)
        K = _full_stiffness(beams, nodes)[mask]
        released, K_r, inverse = _releases(nodes[beams.sides[mask]], K, beams.released[mask])
        turned = np.einsum("bkl,blai,bai->bk", inverse, K_r, deformation[mask])
        deformation[mask] -= np.einsum("bk,bkai->bai", turned, released)
    forces: Array = np.einsum("bprai,bai->bpr", B, deformation) * beams.rigidity[:, None] * [-1.0, -1.0, 1.0, 1.0]
    return forces


def _full_stiffness(beams: Beams, nodes: Array) -> Array:
    """Return the stiffness matrices of pieces whose ends turn with the plate."""
    B, ds = _strains(beams, nodes)
    K: Array = np.einsum("bprai,br,bp,bprcj->bacij", B, beams.rigidity, ds, B, optimize=True)
    return K


def _releases(xy: Array, K: Array, released: Flags) -> tuple[Array, Array, Array]:
    """Return the slopes along the axis at released ends as unknowns r (b, 2, 3, 6), K r, and (r . K r)^-1 (b, 2, 2).

    An end that is not released has neither.
    """
    a, b, middle = (xy[:, k] for k in range(3))
    ways = np.stack([2 * middle - 1.5 * a - 0.5 * b, 0.5 * a + 1.5 * b - 2 * middle], axis=1)
    r = np.zeros((len(xy), 2, 3, FIELDS))
    for end in (0, 1):
        r[:, end, end, 1:3] = ways[:, end] / np.linalg.norm(ways[:, end], axis=1, keepdims=True)
    r[~released] = 0.0
    K_r = np.einsum("bacij,bkcj->bkai", K, r)
    resisted = np.einsum("bkai,blai->bkl", r, K_r)
    resisted[:, [0, 1], [0, 1]] += ~released
    return r, K_r, np.linalg.inv(resisted)


def without_motion(beams: Beams, nodes: Array, u: Array) -> Array:
    """Return unknowns (b, 3, 6) less the rigid motion of each piece's middle, whose size would be rounding."""
    xy, slope = nodes[beams.sides], u[:, 2, 1:3]
    left: Array = u - u[:, 2:]
    left[..., 0] -= np.einsum("bax,bx->ba", xy - xy[:, 2:], slope)
    left[..., THETA] = u[..., THETA] - np.where(beams.deep[:, None], np.einsum("bax,bx->ba", beams.along, slope), 0.0)
    return left


def lengths_of(xy: Array) -> Array:
    """Return the lengths (b,) [m] of pieces between nodes xy (b, 3, 2), which may be curved, but for spans."""
    s, weights = gauss_line(3)
    dN = np.column_stack([s - 0.5, s + 0.5, -2 * s])
    length: Array = np.linalg.norm(np.einsum("pa,bax->bpx", dN, xy), axis=2) @ weights
    return length


def _strains(beams: Beams, nodes: Array) -> tuple[Array, Array]:
    """Return B (b, 2, 4, 3, 6) from fields (last) of nodes to strains, and ds (b, 2) [m].

    The strains are curvature, twist, shear strain, and the strain of the centroid's axis.
    """
    xy = nodes[beams.sides]
    s = POINTS[:, None]
    N = np.hstack([s * (s - 1) / 2, s * (s + 1) / 2, 1 - s * s])
    dN = np.hstack([s - 0.5, s + 0.5, -2 * s])
    tangent = np.einsum("pa,bax->bpx", dN, xy)
    ds = np.linalg.norm(tangent, axis=2)
    t = tangent / ds[..., None]
    n = np.stack([-t[..., 1], t[..., 0]], axis=-1)
    slope = dN / ds[..., None]
    B = np.zeros((len(xy), 2, 4, 3, FIELDS))
    B[:, :, 0, :, 1:3] = slope[..., None] * t[:, :, None]
    B[:, :, 1, :, 1:3] = slope[..., None] * n[:, :, None]
    B[:, :, 2, :, 0] = slope
    B[:, :, 2, :, 1:3] = -N[:, :, None] * t[:, :, None]
    B[:, :, 3, :, 3:5] = B[:, :, 0, :, 1:3]
    B[:, :, 3, :, 1:3] = -beams.eccentricity[:, None, None, None] * B[:, :, 0, :, 1:3]
    spans = beams.spans
    if spans.any():
        B[spans], ds[spans] = _strains_of_spans(xy[spans], beams.rigidity[spans], beams.eccentricity[spans])
    if beams.deep.any():
        # sections that turn by themselves have theta along the axis, and what the plate turns across it
        deep, along = beams.deep, beams.along[beams.deep]
        across = np.stack([-along[..., 1], along[..., 0]], axis=-1)
        turning = B[deep][..., 1:3]
        B[deep, ..., THETA] = np.einsum("bprax,bax->bpra", turning, along)
        B[deep, ..., 1:3] = np.einsum("bprax,bax,bay->bpray", turning, across, across)
    return B, ds


def _strains_of_spans(xy: Array, rigidity: Array, eccentricity: Array) -> tuple[Array, Array]:
    """Return B (b, 2, 4, 3, 6) and ds (b, 2) as `_strains` for spans between nodes xy (b, 3: start, end, start, 2).

    The shear strain is that of a beam without loads, gamma = ((w_2 - w_1) / L - (beta_1 + beta_2) / 2) phi / (1 + phi),
    phi = 12 E I / (G A_v L^2), and the curvature (beta_2 - beta_1) / L + 12 gamma / (phi L^2) (L / 2 - s).
    """
    way = xy[:, 1] - xy[:, 0]
    L = np.linalg.norm(way, axis=1)
    t = way / L[:, None]
    n = np.column_stack([-t[:, 1], t[:, 0]])
    phi = 12 * rigidity[:, 0] / (rigidity[:, 2] * L**2)
    B = np.zeros((len(xy), 2, 4, 3, FIELDS))
    skew = np.zeros((len(xy), 3, FIELDS))  # (w_2 - w_1) / L - (beta_1 + beta_2) / 2
    for node, sign in ((0, -1.0), (1, 1.0)):
        B[:, :, 0, node, 1:3] = sign * (t / L[:, None])[:, None]
        B[:, :, 1, node, 1:3] = sign * (n / L[:, None])[:, None]
        B[:, :, 3, node, 3:5] = sign * (t / L[:, None])[:, None]
        B[:, :, 3, node, 1:3] = -eccentricity[:, None, None] * B[:, :, 0, node, 1:3]
        skew[:, node, 0] = sign / L
        skew[:, node, 1:3] = -t / 2
    B[:, :, 2] = ((phi / (1 + phi))[:, None, None] * skew)[:, None]
    B[:, :, 0] -= np.einsum("bai,b,p->bpai", skew, 6 / ((1 + phi) * L), POINTS)
    return B, np.repeat(L[:, None] / 2, 2, axis=1)
