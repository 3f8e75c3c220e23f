"""Punching of ten columns against a recomputation that shares no code with ours: points on perimeters, points inside.

The perimeter is sampled by points with their share of its length, the part inside by points with their share of its
area; an opening's shadow is the interval of angles that it fills, seen from the column's center.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
import shapely

import groundslab as gs
from groundslab.design.codes.aci318.checks.two_way_demand import CriticalSection, TwoWay, critical_section, two_way
from groundslab.design.codes.en1992_2004.checks.governing_perimeters import column_demands as demands
from groundslab.design.codes.en1992_2004.checks.punching_demand import Demand
from groundslab.design.codes.en1992_2023.checks.punching_demand import column_demands
from groundslab.design.demands import perimeter_loads
from groundslab.design.rules.punching import Demands
from helpers.solve_once import solve_once

LENGTH_X, LENGTH_Y, H, K, UNIT_WEIGHT = 18.0, 10.0, 0.4, 40e6, 25e3
D = H - 0.045
FACTOR = 1.35
#: Perimeters are sampled about so far apart, areas about so far apart [m].
ALONG, APART = 5e-4, 8e-3

OPENINGS: list[dict[str, Any]] = [
    {"kind": "rectangle", "x": (-5.6, -4.9), "y": (-0.5, 0.4)},  # east of B and west of C
    {"kind": "circle", "centre": (-3.0, 1.2), "radius": 0.35},  # north east of C
    {"kind": "rectangle", "x": (0.5, 0.8), "y": (0.5, 1.9)},  # across the corner of D, longer along its ray
    {"kind": "rectangle", "x": (4.0, 4.6), "y": (-4.4, -3.7)},  # beside F, at the edge
    {"kind": "rectangle", "x": (7.0, 7.6), "y": (3.2, 3.7)},  # by H, in the corner
    {"kind": "circle", "centre": (6.8, -0.6), "radius": 0.3},  # by J, which is round
]


def column(name: str, x: float, y: float, *size: float) -> dict[str, Any]:
    """Return a column of two widths, or of a diameter."""
    if len(size) == 1:
        return {"name": name, "x": x, "y": y, "diameter": size[0]}
    return {"name": name, "x": x, "y": y, "width_x": size[0], "width_y": size[1]}


def placed() -> list[dict[str, Any]]:
    """Return ten columns, their sizes and places drawn: inside, by openings, at edges and corners, set back, round."""
    rng = np.random.default_rng(11)
    a, b = np.round(rng.uniform(0.3, 0.5, (2, 10)), 3)
    s = np.round(rng.uniform(-0.05, 0.05, (2, 10)), 3)
    west, east, south, north = -LENGTH_X / 2, LENGTH_X / 2, -LENGTH_Y / 2, LENGTH_Y / 2
    return [
        column("A", -1.2 + s[0, 0], -1.5 + s[1, 0], a[0], b[0]),
        column("B", -6.3 + s[0, 1], 0.1 + s[1, 1], a[1], b[1]),
        column("C", -4.0 + s[0, 2], 0.2 + s[1, 2], a[2], b[2]),
        column("D", 0.0 + s[0, 3], 0.1 + s[1, 3], a[3], b[3]),
        column("E", -3.5 + s[0, 4], south + b[4] / 2, a[4], b[4]),
        column("F", 3.2 + s[0, 5], south + b[5] / 2, a[5], b[5]),
        column("G", west + a[6] / 2, north - b[6] / 2, a[6], b[6]),
        column("H", east - a[7] / 2, north - b[7] / 2, a[7], b[7]),
        column("I", -5.0 + s[0, 8], north - b[8] / 2 - 0.1, a[8], b[8]),
        column("J", 5.9 + s[0, 9], -0.8 + s[1, 9], a[9]),
    ]


COLUMNS = placed()
#: Column's force and moments [N, N m]; E is bent outwards over the edge, F and G inwards.
FORCES = {
    each["name"]: forces
    for each, forces in zip(
        COLUMNS,
        [
            (900e3, 40e3, -30e3), (800e3, 0.0, 0.0), (850e3, 20e3, 0.0), (900e3, 0.0, 25e3), (500e3, 10e3, -20e3),
            (520e3, 0.0, 30e3), (300e3, 15e3, -10e3), (320e3, 0.0, 0.0), (600e3, 0.0, 0.0), (700e3, -20e3, 10e3),
        ],
        strict=True,
    )
}  # fmt: skip


def model(reinforcement: dict[str, Any]) -> gs.Model:
    """Return the slab."""
    return gs.Model(
        plate={
            "length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": H, "E": 30e9, "nu": 0.2, "openings": OPENINGS,
        },
        ground={"kind": "winkler", "k": K},
        columns=COLUMNS,
        cases=[{"name": "G"}],
        loads=[
            {"kind": "self weight", "unit_weight": UNIT_WEIGHT, "case": "G"},
            *(
                {"kind": "point", "column": name, "P": P, "M_x": M_x, "M_y": M_y, "case": "G"}
                for name, (P, M_x, M_y) in FORCES.items()
            ),
        ],
        combinations=[{"name": "ULS", "factors": {"G": FACTOR}}],
        reinforcement={"bottom": (0.04, 0.05), "top": (0.04, 0.05), **reinforcement},
        mesh={"size": 0.5},
    )  # fmt: skip


@pytest.fixture(scope="module")
def results() -> gs.Results:
    """Return the slab by EN 1992-1-1, solved."""
    return solve_once(model({"concrete": "C30/37", "steel": "B500B"}))


@pytest.fixture(scope="module")
def by_en1992(results: gs.Results) -> Demands[Demand]:
    """Return what punches by EN 1992-1-1."""
    return demands(results)


@pytest.fixture(scope="module")
def aci_results() -> gs.Results:
    """Return the slab by ACI 318, solved."""
    return solve_once(model({"code": "ACI 318", "f_ck": 30e6, "f_yk": 420e6}))


@pytest.fixture(scope="module")
def by_aci318(aci_results: gs.Results) -> dict[tuple[str, str], TwoWay]:
    """Return what punches by ACI 318."""
    return two_way(aci_results).found


# --- the recomputation -----------------------------------------------------------------------------------------------


def holes() -> list[shapely.Polygon]:
    """Return the openings."""
    return [
        shapely.box(o["x"][0], o["y"][0], o["x"][1], o["y"][1])
        if o["kind"] == "rectangle"
        else shapely.Point(o["centre"]).buffer(o["radius"], quad_segs=400)
        for o in OPENINGS
    ]


PLATE = shapely.box(-LENGTH_X / 2, -LENGTH_Y / 2, LENGTH_X / 2, LENGTH_Y / 2).difference(shapely.union_all(holes()))
#: The four edges of the rectangle: axis, place, direction outwards.
EDGES = [(0, -LENGTH_X / 2, -1), (0, LENGTH_X / 2, 1), (1, -LENGTH_Y / 2, -1), (1, LENGTH_Y / 2, 1)]


def base_of(each: dict[str, Any]) -> shapely.Polygon:
    """Return a column's footprint."""
    if "diameter" in each:
        return shapely.Point(each["x"], each["y"]).buffer(each["diameter"] / 2, quad_segs=400)
    a, b = each["width_x"] / 2, each["width_y"] / 2
    return shapely.box(each["x"] - a, each["y"] - b, each["x"] + a, each["y"] + b)


@dataclass
class Sampled:
    """A perimeter as points, and what it cuts off."""

    whole: np.ndarray  # (p, 2): points on all of it
    part: np.ndarray  # (p,): their shares of its length
    counts: np.ndarray  # (p,): whether they count
    tangents: np.ndarray  # (p, 2)
    inside: shapely.Polygon
    edges: int  # so many edges it runs out to

    def center(self) -> np.ndarray:
        """Return the center of what counts."""
        ds = self.part[self.counts]
        return ds @ self.whole[self.counts] / ds.sum()

    def u(self) -> float:
        """Return the length that counts."""
        return float(self.part[self.counts].sum())


def sampled(each: dict[str, Any], distance: float, reach: float, *, square: bool, widened: bool) -> Sampled:
    """Return the shortest perimeter by brute force over the edges that it may run out to."""
    base, best = base_of(each), None
    (x0, y0, x1, y1), near = base.bounds, []
    for axis, at, way in EDGES:
        side = (x0, y0, x1, y1)[axis + (2 if way > 0 else 0)]
        if abs(at - side) <= distance:
            near.append((axis, way))
    for count in range(len(near) + 1):
        for chosen in itertools.combinations(near, count):
            region = base
            for axis, way in chosen:
                moved = shapely.affinity.translate(region, *(50.0 * way if axis == k else 0.0 for k in (0, 1)))
                region = region.union(moved).convex_hull
            region = region.buffer(distance, quad_segs=400, join_style="mitre" if square else "round")
            pieces = [p for p in shapely.get_parts(PLATE.intersection(region)) if p.intersects(base.buffer(-0.01))]
            line = pieces[0].boundary.difference(PLATE.boundary.buffer(1e-7))
            if best is None or line.length < best[0].length - 1e-9:
                best = line, pieces[0]
    assert best is not None
    line, inside = best
    reached = sum(inside.distance(_edge(axis, at)) < 1e-6 for axis, at, _ in EDGES)
    points, part, tangents = [], [], []
    for chain in shapely.get_parts(line):
        xy = shapely.get_coordinates(chain)
        for p, q in itertools.pairwise(xy):
            length = math.dist(p, q)
            n = max(1, round(length / ALONG))
            points.append(p + (np.arange(n)[:, None] + 0.5) / n * (q - p))
            part.append(np.full(n, length / n))
            tangents.append(np.tile((q - p) / length, (n, 1)))
    whole = np.concatenate(points)
    counts = ~shaded(whole, each, base, reach, widened)
    return Sampled(whole, np.concatenate(part), counts, np.concatenate(tangents), inside, reached)


def shaded(points: np.ndarray, each: dict[str, Any], base: shapely.Polygon, reach: float, widened: bool) -> np.ndarray:
    """Return which points lie in the interval of angles of any opening within reach."""
    middle, dark = np.array([each["x"], each["y"]]), np.zeros(len(points), dtype=bool)
    for hole in holes():
        if hole.distance(base) > reach:
            continue
        to = np.array(hole.centroid.coords[0]) - middle
        axis = math.atan2(to[1], to[0])
        rim = shapely.get_coordinates(shapely.segmentize(hole.exterior, 0.001)) - middle
        along = rim @ (np.cos(axis), np.sin(axis))
        across = rim @ (-np.sin(axis), np.cos(axis))
        l_1, l_2 = np.ptp(along), np.ptp(across)
        if widened and l_1 > l_2:
            across = across * math.sqrt(l_1 * l_2) / l_2
        angles = np.arctan2(across, along)
        own = points - middle
        turned = np.angle(np.exp(1j * (np.arctan2(own[:, 1], own[:, 0]) - axis)))
        dark |= (turned > angles.min()) & (turned < angles.max())
    return dark


def acting(plate: Any, each: dict[str, Any], inside: shapely.Polygon, about: np.ndarray) -> tuple[float, np.ndarray]:
    """Return the force that punches and its moments about a place, by points inside."""
    x0, y0, x1, y1 = inside.bounds
    n_x, n_y = (math.ceil((high - low) / APART) for low, high in ((x0, x1), (y0, y1)))
    x = x0 + (np.arange(n_x) + 0.5) / n_x * (x1 - x0)
    y = y0 + (np.arange(n_y) + 0.5) / n_y * (y1 - y0)
    X, Y = (grid.ravel() for grid in np.meshgrid(x, y))
    shapely.prepare(inside)
    held = shapely.contains_xy(inside, X, Y)
    X, Y = X[held], Y[held]
    dA = inside.area / len(X)
    net = (plate.value_at("pressure", X, Y) - FACTOR * UNIT_WEIGHT * H) * dA
    P, M_x, M_y = (FACTOR * value for value in FORCES[each["name"]])
    V = P - net.sum()
    moments = np.array([M_x, M_y]) + P * (np.array([each["x"], each["y"]]) - about)
    return float(V), moments - net @ np.column_stack([X - about[0], Y - about[1]])


def table_6_1(ratio: float) -> float:
    """Return k of Table 6.1."""
    return float(np.interp(ratio, (0.5, 1, 2, 3), (0.45, 0.6, 0.7, 0.8)))


def axes_of(line: Sampled) -> np.ndarray:
    """Return the directions that moments are taken along: x and y, or along the edge and across, or of a corner."""
    if line.edges == 0:
        return np.eye(2)
    ends = line.whole[shapely.distance(PLATE.exterior, shapely.points(line.whole)) < 2 * ALONG]
    first = ends[0]
    last = ends[np.argmax(np.linalg.norm(ends - first, axis=1))]
    along = (last - first) / np.linalg.norm(last - first)
    return np.array([along, [-along[1], along[0]]])


def expected_beta(each: dict[str, Any], line: Sampled, V: float, moments: np.ndarray) -> tuple[float, np.ndarray]:
    """Return beta and W, by 6.39, 6.44 or Figure 6.21N."""
    axes, ds = axes_of(line), line.part[line.counts]
    e = (line.whole[line.counts] - line.center()) @ axes.T
    W = ds @ np.abs(e)
    extents = np.ptp(shapely.get_coordinates(base_of(each)) @ axes.T, axis=0)
    k = np.array([table_6_1(extents[0] / extents[1]), table_6_1(extents[1] / extents[0])])
    terms = k * np.abs(axes @ moments) * line.u() / (V * W)
    general = 1 + math.hypot(*terms)
    if line.edges == 0:
        return general, W
    own = np.array(FORCES[each["name"]][1:])
    outwards = any(own[axis] * way > 0 for axis, at, way in EDGES if base_of(each).distance(_edge(axis, at)) < 1e-6)
    if line.edges == 2:
        simple = 1.5
    else:
        ((axis, way),) = ((a, w) for a, b, w in EDGES if base_of(each).distance(_edge(a, b)) <= 2 * D)
        c_1 = np.ptp(shapely.get_coordinates(base_of(each))[:, axis])
        inner = each["xy"[axis]] - way * c_1 / 2
        kept = (inner - line.whole[line.counts][:, axis]) * way > -min(1.5 * D, c_1 / 2)
        # the table's ratio of sides is halved, whichever of them is c_1 (6.4.3(4))
        at_edge = table_6_1(max(extents) / (2 * min(extents)))
        simple = line.u() / ds[kept].sum() + terms[0] / k[0] * at_edge
    return (max(simple, general) if outwards or not line.counts.all() else simple), W


def _edge(axis: int, at: float) -> shapely.LineString:
    ends = [(at, -100.0), (at, 100.0)] if axis == 0 else [(-100.0, at), (100.0, at)]
    return shapely.LineString(ends)


# --- the comparison --------------------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("each", COLUMNS, ids=[each["name"] for each in COLUMNS])
def test_ten_columns_by_en1992(each: dict[str, Any], results: gs.Results, by_en1992: Demands[Demand]) -> None:
    """u, its center, W, V_Ed, beta and v_Ed at 2 d are those of points on what openings leave of the perimeter."""
    demand = by_en1992.found["ULS", each["name"]]
    assert demand.d == pytest.approx(D)
    stress = demand.at_2d
    assert stress is not None
    line = sampled(each, 2 * D, 6 * D, square=False, widened=True)
    assert stress.u == pytest.approx(line.u(), rel=3e-4)
    assert stress.control.center == pytest.approx(line.center(), abs=5e-4)
    V, moments = acting(results.only.plate, each, line.inside, line.center())
    assert stress.V_Ed == pytest.approx(V, rel=2e-4)
    beta, W = expected_beta(each, line, V, moments)
    assert sorted(stress.control.moduli) == pytest.approx(sorted(W), rel=2e-3)
    assert stress.beta == pytest.approx(beta, rel=2e-3)
    assert stress.v_Ed == pytest.approx(beta * V / (line.u() * D), rel=2e-3)


@pytest.fixture(scope="module")
def second_results() -> gs.Results:
    """Return the slab by EN 1992-1-1:2023, solved."""
    return solve_once(model({"code": "EN 1992-1-1:2023", "concrete": "C30/37", "steel": "B500B"}))


def face_of(each: dict[str, Any], line: Sampled) -> float:
    """Return b_0: the face, run straight out to the edges that the perimeter runs out to, without shadows."""
    base = base_of(each)
    region = base
    for axis, at, way in EDGES:
        if line.inside.distance(_edge(axis, at)) < 1e-6 and line.edges:
            moved = shapely.affinity.translate(region, *(50.0 * way if axis == k else 0.0 for k in (0, 1)))
            region = region.union(moved).convex_hull
    border = PLATE.intersection(region).boundary.difference(PLATE.boundary.buffer(1e-7))
    points, part = [], []
    for chain in shapely.get_parts(border):
        for p, q in itertools.pairwise(shapely.get_coordinates(chain)):
            n = max(1, round(math.dist(p, q) / ALONG))
            points.append(p + (np.arange(n)[:, None] + 0.5) / n * (q - p))
            part.append(np.full(n, math.dist(p, q) / n))
    dark = shaded(np.concatenate(points), each, base, 6 * D, widened=True)
    return float(np.concatenate(part)[~dark].sum())


@pytest.mark.slow
@pytest.mark.parametrize("each", COLUMNS, ids=[each["name"] for each in COLUMNS])
def test_ten_columns_by_the_second_generation(each: dict[str, Any], second_results: gs.Results) -> None:
    """b_0.5, b_0, V_Ed up to 0.67 d_v, beta_e and tau_Rd,c by EN 1992-1-1:2023 8.4, with bars of 2 %."""
    found = column_demands(second_results).found["ULS", each["name"]]
    line = sampled(each, D / 2, 6 * D, square=False, widened=True)
    farther = sampled(each, 0.67 * D, 6 * D, square=False, widened=True)
    assert found.b_05 == pytest.approx(line.u(), rel=1e-3)
    b_0 = face_of(each, line)
    assert found.b_0 == pytest.approx(b_0, rel=1e-3)
    inside = farther.inside if farther.edges == line.edges else line.inside
    V, _ = acting(second_results.only.plate, each, inside, line.center())
    assert found.V_Ed == pytest.approx(V, rel=2e-4)
    P, *moments = FORCES[each["name"]]
    e = np.array([each["x"], each["y"]]) + np.array(moments) / P - line.center()
    axes = np.eye(2) if line.edges != 1 else axes_of(line)
    along, across = np.abs(axes @ e)
    e_b = (math.hypot(along, across), along + 0.5 * across, 0.27 * (along + across))[line.edges]
    widths = np.ptp(line.whole @ axes.T, axis=0)
    beta = max(1.05, 1 + 1.1 * e_b / math.sqrt(widths[0] * widths[1]))
    assert found.beta_e == pytest.approx(beta, rel=2e-3)
    assert found.tau_Ed == pytest.approx(beta * V / (line.u() * D), rel=2e-3)
    k_pb = min(2.5, max(1.0, 3.6 * math.sqrt(1 - b_0 / line.u())))
    tau = min(0.6 * k_pb * (100 * 0.02 * 30 * 32 / (1e3 * found.a_pd)) ** (1 / 3), 0.5 * math.sqrt(30)) / 1.4
    assert found.tau_Rd_c / 1e6 == pytest.approx(tau, rel=2e-3)
    assert (found.a_pd < D) <= (line.edges == 0)


@pytest.mark.slow
@pytest.mark.parametrize("each", COLUMNS, ids=[each["name"] for each in COLUMNS])
def test_ten_columns_by_aci318(
    each: dict[str, Any], aci_results: gs.Results, by_aci318: dict[tuple[str, str], TwoWay]
) -> None:
    """b_o, its centroid, V_u and v_u at d / 2, by J_c and gamma_v on principal axes, are those of points on it."""
    line = sampled(each, D / 2, 4 * H, square=True, widened=False)
    (punching,) = [one for one in perimeter_loads.punching_columns(aci_results.model) if one.name == each["name"]]
    section = critical_section(aci_results.only, punching, aci_results.model.reinforcement)
    assert isinstance(section, CriticalSection)
    assert section.center == pytest.approx(line.center(), abs=5e-4)
    found = by_aci318["ULS", each["name"]]
    assert found.b_o == pytest.approx(line.u(), rel=1e-3)
    assert found.alpha_s == {0: 40, 1: 30, 2: 20}[line.edges]
    V, moments = acting(aci_results.only.plate, each, line.inside, line.center())
    assert found.V_u == pytest.approx(V, rel=2e-4)
    ds, t = line.part[line.counts], line.tangents[line.counts]
    e = line.whole[line.counts] - line.center()
    J = D * (ds[:, None] * e).T @ e + D**3 / 12 * (ds[:, None] * t).T @ t
    of_axes, axes = np.linalg.eigh(J)
    b = np.ptp(line.whole @ axes, axis=0)
    gamma_v = 1 - 1 / (1 + 2 / 3 * np.sqrt(b / b[::-1]))
    v_u = V / (line.u() * D) + ((e @ axes) @ (gamma_v * (moments @ axes) / of_axes)).max()
    assert found.v_u == pytest.approx(v_u, rel=2e-3)
