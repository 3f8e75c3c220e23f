"""The closed-form solutions, each against an independent way to the same number."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad, simpson, solve_bvp
from scipy.optimize import fsolve
from scipy.sparse import diags_array, eye_array, kron
from scipy.sparse.linalg import splu
from scipy.special import jv

from groundslab.verification import analytic_plates
from groundslab.verification.analytic import circular_plate, navier, partly_loaded_circular_plate, plate_on_a_column
from groundslab.verification.analytic_beams import beam_on_springs, disk_on_infinite_plate
from groundslab.verification.analytic_plates import clamped_plate, rings
from groundslab.verification.analytic_rigid import rigid_plate_on_springs
from groundslab.verification.analytic_springs import (
    OnSprings,
    curling_strip,
    lifting_circular_plate,
)

THICK = {"t": 0.5, "E": 30e9, "nu": 0.2, "factor": 5 / 6}
THIN = {**THICK, "factor": math.inf}
LIFTING = {"radius": 5.0, "b": 0.4, "P": 1e6, "t": 0.4, "E": 30e9, "nu": 0.2, "k": 200e6}


def stiffnesses(t: float, E: float, nu: float, factor: float) -> tuple[float, float]:
    """Return D and S."""
    return E * t**3 / (12 * (1 - nu**2)), factor * E / (2 * (1 + nu)) * t


def radial(r: Any, y: Any, p: Any, D: float, S: float, nu: float) -> Any:
    """Return the slopes of w, beta, m_r and q_r of a Mindlin plate under the pressure p, by its three equations."""
    w, beta, m, shear = y
    dbeta = -m / D - nu * beta / r
    m_t = -D * (beta / r + nu * dbeta)
    return np.array([beta + shear / S + 0 * w, dbeta, shear - (m - m_t) / r, -shear / r - p])


@pytest.mark.slow
@pytest.mark.parametrize(("factor", "b"), [(5 / 6, 0.4), (math.inf, 0.4), (5 / 6, 1.5)])
def test_lifting_plate_solves_the_boundary_value_problem(factor: float, b: float) -> None:
    """A collocation solution of the radial equations on springs that only press has the same w and m_r everywhere."""
    given = {**LIFTING, "factor": factor, "b": b}
    D, S = stiffnesses(given["t"], given["E"], given["nu"], factor)
    k, q, R = given["k"], given["P"] / (math.pi * b**2), given["radius"]
    # two stretches, r < b and r > b, solved side by side over x = 0 .. 1, so that the step of the load is met exactly
    first = 1e-3 * b

    def slopes(x: Any, y: Any) -> Any:
        inner, outer = first + x * (b - first), b + x * (R - b)
        pressed = [k * np.maximum(w, 0) for w in (y[0], y[4])]
        return np.vstack(
            [
                (b - first) * radial(inner, y[:4], q - pressed[0], D, S, given["nu"]),
                (R - b) * radial(outer, y[4:], -pressed[1], D, S, given["nu"]),
            ]
        )

    def ends(at_0: Any, at_1: Any) -> Any:
        slope = (at_0[2] / -D) / (1 + given["nu"])  # beta / r at the centre
        centre = [at_0[1] - slope * first, at_0[3] + (q - k * at_0[0]) * first / 2]
        return np.array([*centre, *(at_1[:4] - at_0[4:]), at_1[6], at_1[7]])

    scale = np.array([1e-3, 1e-3, 1e5, 1e5])

    def scaled(x: Any, y: Any) -> Any:
        return slopes(x, y * np.tile(scale, 2)[:, None]) / np.tile(scale, 2)[:, None]

    def scaled_ends(a: Any, z: Any) -> Any:
        return ends(a * np.tile(scale, 2), z * np.tile(scale, 2)) / np.array([1e-3, 1e5, *scale, 1e5, 1e5])

    x = np.linspace(0, 1, 201)
    found = solve_bvp(scaled, scaled_ends, x, np.ones((8, x.size)) * 0.1, tol=1e-8, max_nodes=20000)
    assert found.success
    largest = lifting_circular_plate(r=first, **given)["settlement"]
    for place in (0.0, 0.3, 0.6, 0.9, 1.0):
        y = found.sol(place)
        for r, w, m in ((first + place * (b - first), y[0], y[2]), (b + place * (R - b), y[4], y[6])):
            exact = lifting_circular_plate(r=r, **given)
            assert w * 1e-3 == pytest.approx(exact["settlement"], abs=2e-6 * largest)
            assert m * 1e5 == pytest.approx(exact["moment"], abs=1e-5 * given["P"])
    assert lifting_circular_plate(r=R, **given)["settlement"] < -1e-3 * largest


@pytest.mark.slow
@pytest.mark.parametrize("b", [0.0, 0.4])
@pytest.mark.parametrize("factor", [5 / 6, math.inf])
def test_lifting_plate_is_in_equilibrium(b: float, factor: float) -> None:
    """The pressure under the contact disc carries the load, and settlement and its slope pass over the contact line."""
    given = {**LIFTING, "factor": factor, "b": b}
    c = lifting_circular_plate(r=1.0, **given)["contact radius"]
    pressed, _ = quad(
        lambda r: 2 * math.pi * r * given["k"] * lifting_circular_plate(r=r, **given)["settlement"],
        1e-6,
        c,
        points=[b] if b else None,
        epsabs=1.0,
    )
    assert pressed == pytest.approx(given["P"], rel=1e-6)
    step = 1e-5
    before, at, after = (lifting_circular_plate(r=c + d, **given) for d in (-step, 0.0, step))
    assert at["settlement"] == pytest.approx(0.0, abs=1e-12)
    assert after["settlement"] + before["settlement"] == pytest.approx(0.0, abs=1e-3 * abs(before["settlement"]))
    assert after["moment"] == pytest.approx(before["moment"], rel=1e-3)
    assert lifting_circular_plate(r=given["radius"], **given)["moment"] == pytest.approx(0.0, abs=1e-9 * given["P"])


def test_small_disc_tends_to_the_force() -> None:
    """Over a disc that shrinks the thin plate settles as under the force, with an error that falls with b^2."""
    force = lifting_circular_plate(r=0.0, **{**LIFTING, "b": 0.0}, factor=math.inf)["settlement"]
    errors = [
        lifting_circular_plate(r=0.0, **{**LIFTING, "b": b}, factor=math.inf)["settlement"] / force - 1
        for b in (0.04, 0.02)
    ]
    assert abs(errors[1]) < 1e-3
    assert 3 < errors[0] / errors[1] < 4


def test_large_plate_lifts_where_any_larger_one_does() -> None:
    """The contact disc of a very wide plate does not depend on its radius; without tension it is smaller than kei's."""
    length = OnSprings.of(t=0.4, E=30e9, nu=0.2, factor=math.inf, k=200e6).length
    radii = [
        lifting_circular_plate(r=1.0, **{**LIFTING, "radius": n * length, "b": 0.0}, factor=math.inf)["contact radius"]
        for n in (40, 60)
    ]
    assert radii[0] == pytest.approx(radii[1], rel=2e-3)
    assert radii[1] < 3.915 * length  # the first zero of kei


def test_small_plate_does_not_lift() -> None:
    """A plate of two elastic lengths keeps contact: said so; a force on a plate with shear has no settlement."""
    length = OnSprings.of(t=0.4, E=30e9, nu=0.2, factor=5 / 6, k=200e6).length
    with pytest.raises(ValueError, match="does not lift off"):
        lifting_circular_plate(r=0.0, **{**LIFTING, "radius": 2 * length}, factor=5 / 6)
    with pytest.raises(ValueError, match="without limit"):
        lifting_circular_plate(r=0.0, **{**LIFTING, "b": 0.0}, factor=5 / 6)
    with pytest.raises(ValueError, match="below 1"):
        OnSprings.of(t=0.4, E=30e9, nu=0.2, factor=1e-3, k=200e9)


@pytest.mark.parametrize("clamped", [True, False])
def test_full_disc_is_the_uniform_load(clamped: bool) -> None:
    """A disc as large as the plate gives the polynomial of the uniform load."""
    for r in (0.0, 0.7, 2.0):
        disc = partly_loaded_circular_plate(r=r, radius=2.0, b=2.0, clamped=clamped, q=1e3, **THICK)
        whole = circular_plate(r=r, radius=2.0, clamped=clamped, q=1e3, **THICK)
        assert disc["settlement"] == pytest.approx(whole["settlement"], rel=1e-12, abs=1e-18)
        assert disc["moment_r"] == pytest.approx(whole["moment"], rel=1e-12, abs=1e-9)


def test_small_ring_is_the_central_force() -> None:
    """A thin plate under a small ring settles by P R^2 / 16 pi D if clamped, (3 + nu) / (1 + nu) times that if not."""
    D, P, b = stiffnesses(**THIN)[0], 1e5, 1e-4
    for clamped, factor in ((True, 1.0), (False, 3.2 / 1.2)):
        w = partly_loaded_circular_plate(0.0, 2.0, b, clamped=clamped, ring=P / (2 * math.pi * b), **THIN)
        assert w["settlement"] == pytest.approx(factor * P * 4 / (16 * math.pi * D), rel=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("clamped", [True, False])
@pytest.mark.parametrize("load", [{"q": 1e3}, {"ring": 1e3}, {"q": 1e3, "ring": -700.0}])
def test_partly_loaded_plate_solves_the_boundary_value_problem(clamped: bool, load: dict[str, float]) -> None:
    """A collocation solution of the radial equations has the same w, m_r and m_t within the load and beyond it."""
    R, b, first = 2.0, 0.8, 1e-3
    D, S = stiffnesses(**THICK)
    nu, q, ring = THICK["nu"], load.get("q", 0.0), load.get("ring", 0.0)
    scale = np.tile([1e-6, 1e-6, 1e3, 1e3], 2)

    def slopes(x: Any, y: Any) -> Any:
        y = y * scale[:, None]
        inner, outer = first + x * (b - first), b + x * (R - b)
        found = [
            (b - first) * radial(inner, y[:4], q, D, S, nu),
            (R - b) * radial(outer, y[4:], 0.0, D, S, nu),
        ]
        return np.vstack(found) / scale[:, None]

    def ends(at_0: Any, at_1: Any) -> Any:
        a, z = at_0 * scale, at_1 * scale
        centre = [a[1] + a[2] / (D * (1 + nu)) * first, a[3] + q * first / 2]
        joint = z[:4] - a[4:] - np.array([0, 0, 0, ring])
        edge = [z[4], z[5] if clamped else z[6]]
        return np.array([*centre, *joint, *edge]) / [1e-6, 1e3, *scale[:4], 1e-6, 1e-6 if clamped else 1e3]

    x = np.linspace(0, 1, 101)
    found = solve_bvp(slopes, ends, x, np.zeros((8, x.size)), tol=1e-9, max_nodes=20000)
    assert found.success
    given = {"radius": R, "b": b, "clamped": clamped, **load, **THICK}
    largest = abs(partly_loaded_circular_plate(r=0.0, **given)["settlement"])
    for place in (0.0, 0.25, 0.5, 0.999):
        y = found.sol(place) * scale
        for r, w, beta, m in ((first + place * (b - first), *y[:3]), (b + place * (R - b), *y[4:7])):
            exact = partly_loaded_circular_plate(r=r, **given)
            m_t = nu * m - D * (1 - nu**2) * beta / r
            assert w == pytest.approx(exact["settlement"], abs=1e-6 * largest)
            assert m == pytest.approx(exact["moment_r"], abs=1e-3)
            assert m_t == pytest.approx(exact["moment_t"], abs=1e-3)


@pytest.mark.parametrize("clamped", [True, False])
def test_disc_and_ring_are_reciprocal(clamped: bool) -> None:
    """What a ring does to the disc the disc does to the ring (Betti), wherever they lie, shear included."""
    given = {"radius": 2.0, "clamped": clamped, **THICK}
    for disc, ring in ((0.5, 1.2), (1.2, 0.5), (0.9, 0.9)):
        under_ring = {"b": ring, "ring": 1.0, **given}
        by_ring, _ = quad(
            lambda r, under_ring=under_ring: r * partly_loaded_circular_plate(r=r, **under_ring)["settlement"],
            0,
            disc,
            points=[min(ring, disc)],
            epsabs=0,
            epsrel=1e-10,
        )
        by_disc = partly_loaded_circular_plate(r=ring, b=disc, q=1.0, **given)["settlement"] * ring
        assert by_ring == pytest.approx(by_disc, rel=1e-9)


CURLING = {"t": 0.2, "E": 30e9, "nu": 0.15, "k": 50e6, "alpha": 1e-5, "dT": -10.0}


@pytest.mark.parametrize("b", [1.0, 4.0, 12.0])
def test_thin_strip_curls_as_westergaard_says(b: float) -> None:
    """Without shear the moments are Westergaard's, his coefficient taken from his formula for the stress."""
    plate = OnSprings.of(CURLING["t"], CURLING["E"], CURLING["nu"], math.inf, CURLING["k"])
    lam = b / (plate.length * math.sqrt(8))
    held = -plate.D * 1.15 * CURLING["alpha"] * CURLING["dT"] / CURLING["t"]
    for y in (0.0, 0.2 * b, b / 2):
        s = y / (plate.length * math.sqrt(2))
        tan, tanh = math.tan(lam), math.tanh(lam)
        of_y = (tan + tanh) * math.cos(s) * math.cosh(s) + (tan - tanh) * math.sin(s) * math.sinh(s)
        share = 2 * math.cos(lam) * math.cosh(lam) / (math.sin(2 * lam) + math.sinh(2 * lam)) * of_y
        strip = curling_strip(y=y, b=b, factor=math.inf, **CURLING)
        assert strip["moment across"] == pytest.approx(held * (1 - share), rel=1e-9, abs=1e-9 * abs(held))
        assert strip["moment along"] == pytest.approx(held * (1 - 0.15 * share), rel=1e-9)


@pytest.mark.parametrize("factor", [0.05, 5 / 6, math.inf])
def test_curling_strip_solves_the_boundary_value_problem(factor: float) -> None:
    """A collocation solution of the strip's equations, free edges included, has the same w and m."""
    b, nu, k = 4.0, CURLING["nu"], CURLING["k"]
    D, S = stiffnesses(CURLING["t"], CURLING["E"], nu, factor)
    held = (1 + nu) * CURLING["alpha"] * CURLING["dT"] / CURLING["t"]
    scale = np.array([1e-3, 1e-3, 1e4, 1e4])

    def slopes(_: Any, y: Any) -> Any:
        w, beta, m, shear = y * scale[:, None]
        return np.array([beta + shear / S, -m / D - held, shear, k * w]) / scale[:, None]

    def ends(a: Any, z: Any) -> Any:
        return np.array([a[1], a[3], z[2], z[3]])

    x = np.linspace(0, b / 2, 101)
    found = solve_bvp(slopes, ends, x, np.zeros((4, x.size)), tol=1e-9)
    assert found.success
    for y in (0.0, 0.7, 1.5, 2.0):
        w, _, m, _ = found.sol(y) * scale
        strip = curling_strip(y=y, b=b, factor=factor, **CURLING)
        assert w == pytest.approx(strip["settlement"], abs=1e-10)
        assert m == pytest.approx(strip["moment across"], abs=1e-3)


def test_warm_bottom_lifts_the_edges() -> None:
    """A strip warmer below than above is bent downwards in its middle; a narrow one is free, a wide one held."""
    warm = {**CURLING, "dT": 10.0}
    D, _ = stiffnesses(warm["t"], warm["E"], warm["nu"], math.inf)
    held = -D * 1.15 * 1e-5 * 10 / 0.2
    edge, middle = (curling_strip(y=y, b=4.0, factor=math.inf, **warm)["settlement"] for y in (2.0, 0.0))
    assert edge < 0 < middle
    narrow = curling_strip(y=0.0, b=0.1, factor=math.inf, **warm)
    assert abs(narrow["moment across"]) < 1e-4 * abs(held)
    assert narrow["moment along"] == pytest.approx(held * 0.85, rel=1e-4)
    assert curling_strip(y=0.0, b=60.0, factor=math.inf, **warm)["moment across"] == pytest.approx(held, rel=1e-3)


COLUMN = {"a": 4.0, "b": 3.0, "q": 1e4, "u": 0.5, "v": 0.5}


@pytest.mark.slow
def test_no_column_is_navier_and_a_rigid_one_does_not_settle() -> None:
    """K = 0 gives the plate without a column; the higher K, the less the centre (or the mean) settles."""
    for x, y in ((0.0, 0.0), (0.7, -1.1)):
        free = navier(x=x, y=y, a=4.0, b=3.0, q=1e4, k0=0.0, k1=0.0, **THICK)["settlement"]
        with_none = plate_on_a_column(x=x, y=y, K=0.0, **COLUMN, **THICK)
        assert with_none["settlement"] == pytest.approx(free, rel=1e-6)
        assert with_none["force"] == 0
    rigid = plate_on_a_column(x=0.0, y=0.0, K=1e15, **COLUMN, **THICK)["settlement"]
    assert abs(rigid) < 1e-5 * navier(x=0.0, y=0.0, a=4.0, b=3.0, q=1e4, k0=0.0, k1=0.0, **THICK)["settlement"]


def test_rigid_point_under_a_square_plate_takes_the_share_of_the_tables() -> None:
    """A thin square plate: 0.00406 q a^4 / D over 0.01160 a^2 / D, the tables' central deflections, is the force."""
    found = plate_on_a_column(x=0.0, y=0.0, a=2.0, b=2.0, q=1e4, K=1e15, u=0.0, v=0.0, **THIN)
    assert found["force"] == pytest.approx(0.00406 / 0.01160 * 1e4 * 4, rel=1e-3)


@pytest.mark.parametrize("mean", [False, True])
def test_column_agrees_with_finite_differences(mean: bool) -> None:
    """Differences for the two membranes of the hinged plate, extrapolated from two grids, give force and settlement.

    lap M = -p with M = 0 on the edges, then lap w = -M / D; the shear adds M / S.
    """
    D, S = stiffnesses(**THICK)
    K, a, b, q, u, v = 5e7, COLUMN["a"], COLUMN["b"], COLUMN["q"], COLUMN["u"], COLUMN["v"]

    def solved(n: int) -> Any:
        h = 0.5 / n  # u and v are n steps, their borders lie on grid lines: the load there is halved
        nx, ny = round(a / h) - 1, round(b / h) - 1
        line = [diags_array([1.0, -2.0, 1.0], offsets=[-1, 0, 1], shape=(m, m)) / h**2 for m in (nx, ny)]
        lap = splu((kron(line[0], eye_array(ny)) + kron(eye_array(nx), line[1])).tocsc())
        x, y = (np.arange(1, nx + 1) * h - a / 2)[:, None], (np.arange(1, ny + 1) * h - b / 2)[None, :]
        on = np.ones((nx, ny))
        for s, width in ((np.abs(x), u), (np.abs(y), v)):
            on = on * np.where(s < width / 2 - 1e-9, 1.0, np.where(s < width / 2 + 1e-9, 0.5, 0.0))
        centre = np.zeros((nx, ny))
        centre[nx // 2, ny // 2] = 1
        felt = (on * h**2 / (u * v) if mean else centre).ravel()

        def settled(p: Any) -> Any:
            M = lap.solve(-p.ravel())
            return lap.solve(-M / D) + M / S

        w_q, w_1 = settled(np.full((nx, ny), q)), settled(on / (u * v))
        force = K * felt @ w_q / (1 + K * felt @ w_1)
        return np.array([force, (w_q - force * w_1)[centre.ravel() > 0][0]])

    coarse, fine = solved(8), solved(16)
    force, w = fine + (fine - coarse) / 3
    found = plate_on_a_column(x=0.0, y=0.0, K=K, mean=mean, **COLUMN, **THICK)
    assert found["force"] == pytest.approx(force, rel=2e-5)
    assert found["settlement"] == pytest.approx(w, rel=2e-5)


def test_spring_mat_of_code_aster() -> None:
    """Equilibrium of a rigid plate 1 m x 2 m under 5 (y - b)^2 Pa on springs that only press: 4/1125 m, -4/3375 m."""
    b, k = 2.0, 5000.0

    def unbalanced(unknown: Any) -> list[float]:
        w, slope = unknown
        y = np.linspace(0, b, 200001)
        p = 5 * (y - b) ** 2 - k * np.maximum(w + slope * y, 0)
        return [float(np.trapezoid(p, y)), float(np.trapezoid(p * y, y))]

    w, slope = fsolve(unbalanced, [1e-3, -1e-3], xtol=1e-12)
    force, _ = quad(lambda y: 5 * (y - b) ** 2, 0, b)
    moment, _ = quad(lambda y: 5 * (y - b) ** 2 * y, 0, b)
    exact = [rigid_plate_on_springs(y, b, force, moment / force, k) for y in (0.0, b)]
    assert exact == pytest.approx([w, w + slope * b], rel=1e-6)
    assert exact == pytest.approx([4 / 1125, -4 / 3375], rel=1e-12)


def test_rigid_plate_within_the_middle_third() -> None:
    """With full contact the linear pressure has the force and its moment; both branches meet at a third."""
    b, k, force, arm = 3.0, 5000.0, 40.0, 1.2
    total, _ = quad(lambda y: k * rigid_plate_on_springs(y, b, force, arm, k), 0, b)
    moment, _ = quad(lambda y: y * k * rigid_plate_on_springs(y, b, force, arm, k), 0, b)
    assert [total, moment] == pytest.approx([force, force * arm], rel=1e-12)
    sides = [rigid_plate_on_springs(0.7, b, force, b / 3 + d, k) for d in (-1e-9, 1e-9)]
    assert sides[0] == pytest.approx(sides[1], rel=1e-7)
    with pytest.raises(ValueError, match="arm"):
        rigid_plate_on_springs(0.0, b, force, 2.0, k)


@pytest.mark.slow
def test_disk_on_pasternak_ground_is_hankels_integral() -> None:
    """Settlement and moment under a disk are the integrals over all wave numbers, at its middle, inside and outside."""
    a, q, D, nu, k0, k1 = 0.3, 1e6, 2.5e6, 0.2, 4e7, 1e7
    s = np.linspace(1e-9, 2000.0, 1_000_001)
    f = q * a * jv(1, a * s) / (D * s**4 + k1 * s**2 + k0)
    for r in (0.0, 0.1, 0.7):
        slope_over_r = -(s**2) * (jv(1, r * s) / (r * s) if r else 0.5)
        w, turned, bent = (
            simpson(f * each, x=s) for each in (jv(0, r * s), slope_over_r, -(s**2) * jv(0, r * s) - slope_over_r)
        )
        found = disk_on_infinite_plate(r, a, q, D, nu, k0, k1)
        assert found["settlement"] == pytest.approx(w, rel=1e-9)
        assert found["moment"] == pytest.approx(-D * (bent + nu * turned), rel=1e-6)


def test_beam_on_springs_is_in_equilibrium() -> None:
    """The springs carry the force, also about the beam's end; at its ends there is no moment."""
    length, P, at, EI, k = 5.0, 1e6, 1.7, 5.76e8, 5e7

    def pressure(x: float) -> float:
        return k * beam_on_springs(x, length, P, at, EI, k)["settlement"]

    assert quad(pressure, 0, length, points=[at])[0] == pytest.approx(P, rel=1e-9)
    assert quad(lambda x: pressure(x) * x, 0, length, points=[at])[0] == pytest.approx(P * at, rel=1e-9)
    for end in (0.0, length):
        assert beam_on_springs(end, length, P, at, EI, k)["moment"] == pytest.approx(0, abs=1e-6 * P)


def test_rings_of_one_stiffness_are_a_plate() -> None:
    """W = (5 + nu) / (64 (1 + nu)) q a^4 / D and m = (3 + nu) / 16 q a^2 in the middle, however it is divided."""
    for radii in ([0.0, 2.0], [0.0, 0.5, 2.0], [0.0, 1.0, 1.5, 2.0]):
        found = rings(0.0, radii, [3.0] * (len(radii) - 1), 0.3, 1.0)
        assert found["settlement"] == pytest.approx(5.3 / (64 * 1.3) * 2**4 / 3)
        assert found["moment"] == pytest.approx(3.3 / 16 * 2**2)
    hole = rings(0.5, [0.5, 2.0], [3.0], 0.3, 1.0)
    assert hole["moment"] == pytest.approx(0, abs=1e-12)


def test_clamped_plate_converges(monkeypatch: pytest.MonkeyPatch) -> None:
    """With two terms less no digit changes that a case is held against; a long plate is a clamped beam."""
    given = {"y": 0.0, "a": 10.0, "q": 100.0, "D": 1e6, "nu": 0.3}
    square, beam = (clamped_plate(x=0.0, b=b, **given) for b in (10.0, 60.0))
    assert beam["settlement"] == pytest.approx(100 * 10**4 / (384 * 1e6), rel=2e-3)
    assert beam["moment"] == pytest.approx(100 * 10**2 / 24, rel=2e-3)
    monkeypatch.setattr(analytic_plates, "TERMS", analytic_plates.TERMS - 2)
    fewer = clamped_plate(x=0.0, b=10.0, **given)
    assert [fewer[name] for name in square] == pytest.approx(list(square.values()), rel=1e-5)
