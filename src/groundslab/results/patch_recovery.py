"""Superconvergent patch recovery: nodal values from the 2 x 2 Gauss points of nine-node elements.

At these points the derivatives of a quadratic element are one order more accurate than elsewhere. Around each corner
node a polynomial is fitted to them by least squares, and nodes take their values from it (Zienkiewicz and Zhu 1992).
No patch reaches over an edge of the mesh, so a mesh whose parts do not share nodes is recovered part by part.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.fem.assembly import scatter
from groundslab.fem.hanging import find_hanging
from groundslab.fem.mesh import sides_on_boundary
from groundslab.fem.shape_functions import COLUMN, ROW, gauss, unique_integers

#: Terms x^a y^b of a complete quadratic; the further ones of a biquadratic.
_POWERS = np.array([(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (2, 1), (1, 2), (2, 2)])
_QUADRATIC = 6
#: A fit counts if the smallest eigenvalue of its matrix is above this share of the largest. Sound patches have 1e-2,
#: biquadratics on elements of very different sizes somewhat less.
_DEFINITE = 1e-4
#: The nodes of an element that lie nearest to each corner, and which share of their value they take from it.
_NEAR = np.array([[corner, 4 + corner, 4 + (corner - 1) % 4, 8] for corner in range(4)])
_SHARE = np.array([1.0, 1 / 2, 1 / 2, 1 / 4])
#: A polynomial so many times as far away as another one is not asked.
FARTHER = 1.8
_CHUNK = 8192
#: Share of the values' scatter in a patch that its fit leaves over: up to the first the fit counts alone, from the
#: second on the elements extrapolate by themselves, between them a mixture.
SMOOTH, ROUGH = 0.05, 0.15
#: Scatter below this share of the values themselves is none.
FLAT = 0.05


@dataclass(frozen=True, slots=True)
class _Alike:
    """Patches of as many elements, with polynomials of as many terms: P patches, p points in each."""

    vertex: Integers  # (P,)
    elements: Integers  # (P, elements)
    A: Array  # (P, p, terms): the terms at the points
    inverse: Array  # (P, terms, p): from values at the points to the coefficients of the best polynomial


@dataclass(frozen=True, slots=True)
class Patches:
    """The patches of a mesh: for each of V corner nodes a polynomial in the coordinates L^-1 (x - center)."""

    nodes: Array  # (n, 2) [m]
    elements: Integers  # (m, 9)
    corner: Integers  # (m, 4): numbers of the elements' corner nodes
    center: Array  # (V, 2) [m]
    L: Array  # (V, 3) [m]: L_xx, L_yx, L_yy, the lower triangle of the points' covariance
    alike: tuple[_Alike, ...]
    first: Integers  # (V + 1,): whose polynomials a corner node takes: source[first[v]:first[v + 1]]
    source: Integers


def extrapolation() -> Array:
    """Return the matrix (9, 4) from values at the 2 x 2 Gauss points to the element's nodes, bilinear between them."""
    at = np.column_stack([COLUMN - 1, ROW - 1]) * np.sqrt(3.0)
    sign = np.sign(gauss(2)[0])
    bilinear: Array = (1 + at[:, :1] * sign[:, 0]) * (1 + at[:, 1:] * sign[:, 1]) / 4
    return bilinear


def make_patches(nodes: Array, elements: Integers, points: Array) -> Patches:
    """Return the patches of a mesh, nodes (n, 2) [m], elements (m, 9), with 2 x 2 Gauss points (m, 4, 2) [m].

    A corner node inside has the patch of the elements that meet there; one on the edge, where points lie on one side
    only, takes the mean of those of its neighbors inside (Zienkiewicz and Zhu 1992): at the other end of an element's
    side, else across an element. Polynomials are quadratic; biquadratic where all elements are rectangles along x and
    y, whose points make rows and columns. That smears peaks less, but on other quadrilaterals it follows the scatter of
    the points' values.
    """
    vertices, corner = unique_integers(elements[:, :4])
    on_edge = np.zeros(len(nodes), dtype=bool)
    on_edge[sides_on_boundary(elements)[:, :2]] = True
    # in the middle of a longer side the elements of a corner lie on one side only, too
    hanging, uneven = find_hanging(elements), np.zeros(len(nodes), dtype=bool)
    on_edge[hanging[:, 2]] = uneven[hanging[:, 1:]] = True
    inside = ~on_edge[vertices]
    V = len(inside)
    is_corner, center, L = np.zeros(V, dtype=bool), np.zeros((V, 2)), np.ones((V, 3))
    meeting = np.bincount(corner.ravel(), minlength=V)
    order = np.argsort(corner.ravel(), kind="stable") // 4
    first = np.cumsum(meeting) - meeting
    oblong = _rectangles(nodes[elements[:, :4]])
    patches = []
    for count in np.flatnonzero(np.bincount(meeting[inside])):
        same = np.flatnonzero(inside & (meeting == count))
        patch = order[first[same][:, None] + np.arange(count)]
        rows_and_columns = oblong[patch].all(axis=1)
        for terms, fit in ((len(_POWERS), rows_and_columns), (_QUADRATIC, np.ones_like(rows_and_columns))):
            left = fit & ~is_corner[same] & (4 * count >= terms)
            where, which = same[left], patch[left]
            for start in range(0, len(where), _CHUNK):
                v, members = where[start : start + _CHUNK], which[start : start + _CHUNK]
                x = points[members].reshape(len(v), -1, 2)
                sound, center[v], L[v], A, inverse = _least_squares(x, terms)
                is_corner[v] = sound
                if sound.any():
                    patches.append(_Alike(v[sound], members[sound], A[sound], inverse[sound]))
    return Patches(
        nodes,
        elements,
        corner,
        center,
        L,
        tuple(patches),
        *_sources(nodes[vertices], corner, is_corner, is_corner & ~uneven[vertices]),
    )


def recover_nodes(p: Patches, values: Array, sizes: Sequence[Array]) -> Array:
    """Return values (n, k) at the nodes from values (m, 4, k) at the elements' 2 x 2 Gauss points.

    Each of sizes (k,) weighs the squares of values that belong together, such as the components of a tensor, 0 for the
    others. Midside nodes and centers are means of their corners' polynomials. Where there is no neighbor inside, as in
    a strip one element wide, each element extrapolates bilinearly, and the nodes take the mean of its elements. So they
    do as far as a fit leaves too much over (SMOOTH, ROUGH): no polynomial may smear a peak.
    """
    n, V, k = len(p.nodes), len(p.center), values.shape[2]
    coefficients, all_doubt = np.zeros((V, len(_POWERS), k)), np.zeros((V, k))
    for g in p.alike:
        f = values[g.elements].reshape(len(g.vertex), -1, k)
        best = g.inverse @ f
        coefficients[g.vertex, : best.shape[1]] = best
        all_doubt[g.vertex] = _doubt(f, f - g.A @ best, sizes)
    doubtful = all_doubt.max(axis=1) > 0
    sums, extrapolate = np.zeros((n, k)), extrapolation()
    for start in range(0, len(p.elements), _CHUNK):
        part = slice(start, start + _CHUNK)
        elements, own_values = p.elements[part], values[part]
        at_nodes = np.zeros((len(elements), 9, k))
        for c, near in enumerate(_NEAR):
            vertex = p.corner[part, c]
            count = p.first[vertex + 1] - p.first[vertex]
            alone = np.flatnonzero(count == 0)
            if len(alone):
                at_nodes[np.ix_(alone, near)] += _SHARE[:, None] * (extrapolate[near] @ own_values[alone])
            # most corners have one source; some at corners of the outline have two or more, taken in turn
            for turn in range(count.max(initial=0)):
                those = np.flatnonzero(count > turn)
                x = p.nodes[elements[those[:, None], near]]
                which = p.source[p.first[vertex[those]] + turn]
                at = _terms(x, p.center[which], p.L[which]) @ coefficients[which]
                poor = np.flatnonzero(doubtful[which])
                if len(poor):
                    doubt = all_doubt[which[poor], None]
                    at[poor] = (1 - doubt) * at[poor] + doubt * (extrapolate[near] @ own_values[those[poor]])
                at_nodes[those[:, None], near] += (_SHARE / count[those, None])[..., None] * at
        sums += np.column_stack([scatter(elements, at_nodes[..., i], n) for i in range(k)])
    meeting = np.bincount(p.elements.ravel(), minlength=n)
    return sums / np.maximum(meeting, 1)[:, None]


def _rectangles(xy: Array) -> Flags:
    """Return which quadrilaterals with corners xy (m, 4, 2) are rectangles along x and y, (m,)."""
    low, high = xy.min(axis=1, keepdims=True), xy.max(axis=1, keepdims=True)
    off = np.minimum(xy - low, high - xy).max(axis=(1, 2))
    oblong: Flags = off < 1e-9 * (high - low).min(axis=(1, 2))
    return oblong


def _doubt(f: Array, rest: Array, sizes: Sequence[Array]) -> Array:
    """Return how little fits to f (P, p, k) that leave a rest (P, p, k) are worth, from 0 to 1, (P, k)."""
    scatter_of, left = ((part**2).sum(axis=1) for part in (f - f.mean(axis=1, keepdims=True), rest))
    whole = (f**2).sum(axis=1)
    doubt = np.zeros((len(f), f.shape[2]))
    for size in sizes:
        # at a flat peak what is left over is what the elements scatter, not a peak that is smeared
        spread = scatter_of @ size + FLAT**2 * (whole @ size) + np.finfo(float).tiny
        share = np.clip((np.sqrt(left @ size / spread) - SMOOTH) / (ROUGH - SMOOTH), 0.0, 1.0)
        doubt[:, size > 0] = share[:, None]
    return doubt


def _least_squares(x: Array, terms: int) -> tuple[Flags, Array, Array, Array, Array]:
    """Return whether points x (P, p, 2) determine a polynomial, center, L, its terms at the points, and their inverse.

    In coordinates whose covariance is the identity, so that the answer does not depend on how a patch is stretched.
    """
    center = x.mean(axis=1)
    dx, dy = np.moveaxis(x - center[:, None], -1, 0)
    tiny = np.finfo(float).tiny
    xx = np.sqrt(np.maximum((dx * dx).mean(axis=1), tiny))
    yx = (dx * dy).mean(axis=1) / xx
    yy = np.sqrt(np.maximum((dy * dy).mean(axis=1) - yx**2, tiny))
    L = np.column_stack([xx, yx, yy])
    A = np.ascontiguousarray(_terms(x, center, L)[..., :terms])
    transposed = np.swapaxes(A, 1, 2)
    normal = transposed @ A
    eigenvalues = np.linalg.eigvalsh(normal)
    definite = eigenvalues[:, 0] > _DEFINITE * eigenvalues[:, -1]
    normal[~definite] = np.eye(terms)
    inverse = np.linalg.solve(normal, transposed).astype(np.float64, copy=False)
    return definite, center, L, A, inverse


def _terms(x: Array, center: Array, L: Array) -> Array:
    """Return the terms (P, p, 9) at points x (P, p, 2) of patches with center (P, 2) and L (P, 3)."""
    X = (x[..., 0] - center[:, :1]) / L[:, :1]
    Y = (x[..., 1] - center[:, 1:] - L[:, 1:2] * X) / L[:, 2:]
    ones = np.ones_like(X)
    powers = (ones, X, X * X), (ones, Y, Y * Y)
    return np.stack([powers[0][a] * powers[1][b] for a, b in _POWERS], axis=-1)


def _sources(places: Array, corner: Integers, fitted: Flags, even: Flags) -> tuple[Integers, Integers]:
    """Return whose polynomials each corner node takes: source[first[v]:first[v + 1]], first (V + 1,).

    Its own if fitted; else those at the other ends of its elements' sides; else those across its elements; of these
    first such as come from elements alike in size. One much farther away than another, over larger elements, is none.
    """
    V = len(fitted)
    with_patch = np.flatnonzero(fitted)
    pairs, served = [with_patch * V + with_patch], fitted.copy()
    for step, others in (((1, 3), even), ((2,), even), ((1, 3), fitted), ((2,), fitted)):
        taker = np.concatenate([corner.ravel() for _ in step])
        giver = np.concatenate([np.roll(corner, -s, axis=1).ravel() for s in step])
        new = np.flatnonzero(~served[taker] & others[giver])
        distance, least = np.linalg.norm(places[taker[new]] - places[giver[new]], axis=1), np.full(V, np.inf)
        np.minimum.at(least, taker[new], distance)
        new = new[distance <= FARTHER * least[taker[new]]]
        pairs.append(np.unique(taker[new] * V + giver[new]))
        served[taker[new]] = True
    all_pairs = np.sort(np.concatenate(pairs))
    first = np.concatenate([[0], np.cumsum(np.bincount(all_pairs // V, minlength=V))])
    return first, all_pairs % V
