"""Moments and shear forces of ribs and beams cast with a slab against statics: cuts through the whole model."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.arrays import Array
from groundslab.design.bars.beam_bars import beam_needs
from groundslab.design.bars.members import members_of
from groundslab.design.demands.cuts.section_cuts import carried_across

#: A strip of 1 m by 0.4 m under 150 kN/m, with a rib of 0.4 m by 0.4 m below it.
B, T, Q = 1.0, 0.4, 150e3
RIB = {"kind": "rib", "width": 0.4, "height": 0.4, "effective_width": B}
RIBS = [RIB, RIB | {"eccentric": True}, RIB | {"side": "above"}]
BARS: dict[str, Any] = {"concrete": "C30/37", "steel": "B500B", "bottom": (0.04, 0.05), "top": (0.04, 0.05)}
#: From supports shear forces count at a distance of the height.
H = 0.8


def rib(length: float, places: list[float], section: dict[str, Any], k: float = 1.0, **others: Any) -> gs.Model:
    """Return a strip with a rib along its axis, on lines across it and on springs."""
    across = [{"kind": "line", "points": [(x, -B / 2), (x, B / 2)], "acts": "both ways"} for x in places]
    parts: dict[str, Any] = {
        "plate": {"length_x": length, "length_y": B, "thickness": T, "E": 30e9, "nu": 0.0},
        "ground": {"kind": "winkler", "k": k},
        "contact": {"tensionless": False},
        "supports": across,
        "beams": [{"name": "R", "points": [(-length / 2, 0.0), (length / 2, 0.0)], "section": section}],
        "cases": [{"name": "G"}],
        "loads": [{"kind": "uniform", "case": "G", "q": Q}],
        "combinations": [{"name": "ULS", "factors": {"G": 1.0}, "limit_state": "ultimate"}],
        "reinforcement": BARS,
        "mesh": {"size": 0.2},
    }
    return gs.Model(**parts | others)


def solved(model: gs.Model) -> tuple[gs.Results, Array, Array, Array]:
    """Return results, and ways, M and V of the rib's section."""
    results = gs.solve(model)
    assert results["ULS"].certificate.holds
    assert results.model.reinforcement is not None
    own = members_of(model)[0].forces(results["ULS"])
    return results, own.way, own.moment, own.shear


@pytest.mark.parametrize("section", RIBS)
def test_a_simple_rib_carries_all_of_the_load(section: dict[str, Any]) -> None:
    """By statics 150 8^2 / 8 = 1200 kNm and 150 (4 - s) kN, which is 468.8 kN at 0.875 m; to 1 %."""
    _, s, M, V = solved(rib(8.0, [-4.0, 4.0], section))
    assert M.max() == pytest.approx(1200e3, rel=0.01)
    assert np.interp(0.875, s, V) == pytest.approx(468.75e3, rel=0.01)
    away = (s > H) & (s < 8 - H)
    assert V[away] == pytest.approx(Q * (4 - s[away]), abs=0.01 * Q * (4 - H))


def test_its_links_begin_at_d_from_the_ends() -> None:
    """V = 150 (4 - 0.75) = 487.5 kN on elements of 0.15 to 0.3 m; 468.8 kN would need 6.39 cm2/m of links."""
    for size in (0.15, 0.2, 0.3):
        results, *_ = solved(rib(8.0, [-4.0, 4.0], RIB, mesh={"size": size}))
        assert results.model.reinforcement is not None
        links = next(need for need in beam_needs(results, results.model.reinforcement) if need.what == "links")
        assert min(links.way, 8 - links.way) == pytest.approx(0.75)
        assert abs(links.force) == pytest.approx(487.5e3, rel=0.01)
        assert links.area / abs(links.force) == pytest.approx(6.39e-4 / 468.75e3, rel=1e-3)


@pytest.mark.parametrize("section", RIBS)
def test_a_continuous_rib_carries_what_its_supports_take(section: dict[str, Any]) -> None:
    """Over three supports: shear forces are the reactions less the load between, moments their lever arms; to 1 %."""
    results, s, M, V = solved(rib(12.0, [-6.0, 0.0, 6.0], section))
    A, middle, _ = (support.total for support in results["ULS"].supports)
    shear = A + np.where(s > 6, middle, 0.0) - Q * s
    moment = A * s + middle * np.maximum(s - 6, 0) - Q * s**2 / 2
    away = (s > H) & (s < 12 - H) & (np.abs(s - 6) > H)
    assert V[away] == pytest.approx(shear[away], abs=0.01 * np.abs(shear).max())
    assert M[away] == pytest.approx(moment[away], abs=0.01 * np.abs(moment).max())


@pytest.mark.parametrize(("side", "direct"), [("below", True), ("above", False)])
def test_links_at_an_inner_support_begin_at_d_from_it(side: str, *, direct: bool) -> None:
    """Half of the inner reaction is at its face; links of a rib below the slab take 150 0.75 = 112.5 kN less.

    A rib above it hangs on the support: all of that counts. Struts bear it in any case.
    """
    results, *_ = solved(rib(12.0, [-6.0, 0.0, 6.0], RIB | {"side": side}))
    assert results.model.reinforcement is not None
    needs = {need.what: need for need in beam_needs(results, results.model.reinforcement)}
    at_face = results["ULS"].supports[1].total / 2
    assert abs(needs["links"].force) == pytest.approx(at_face - 112.5e3 * direct, rel=0.01)
    assert abs(needs["struts"].force) == pytest.approx(at_face, rel=0.01)
    # V / (b_w z) of V_Rd,max = nu f_cd / 2 = 5.28 MPa, z = 0.675 m
    assert needs["struts"].area == pytest.approx(at_face / (0.4 * 0.675) / 5.28e6, rel=0.01)


@pytest.mark.parametrize("section", RIBS)
def test_a_rib_on_springs_carries_loads_less_the_ground(section: dict[str, Any]) -> None:
    """V is the integral of the ground's pressure less the load from one end, which rests on 4 m in the middle."""
    load = {"kind": "patch", "case": "G", "q": 300e3, "x": (-2.0, 2.0), "y": (-B / 2, B / 2)}
    k = 20e6
    results, s, _, V = solved(rib(10.0, [], section, k, loads=[load], mesh={"size": 0.2}))
    w = results["ULS"].beams[0].settlement
    pressed = np.concatenate([[0.0], np.cumsum(k * B * (w[1:] + w[:-1]) / 2 * np.diff(s))])
    shear = pressed - 300e3 * np.clip(s - 3, 0, 4)
    away = (s > H) & (s < 10 - H)
    assert V[away] == pytest.approx(shear[away], abs=0.01 * np.abs(shear).max())


@pytest.mark.parametrize("section", RIBS)
def test_cuts_through_slab_and_rib_carry_the_same(section: dict[str, Any]) -> None:
    """The slab's shear forces over the effective width and the rib's own add up to V of the section, to 1 %."""
    from groundslab.design.demands.cuts.section_cuts import strip

    results, s, _, V = solved(rib(8.0, [-4.0, 4.0], section))
    cuts = strip(results["ULS"].plate, (-2.9, 0.0), (2.9, 0.0), B, 30)
    ends = np.stack([np.column_stack([cuts.x, cuts.x * 0 + side]) for side in (B / 2, -B / 2)])
    own = carried_across(results["ULS"], *ends)[:, 1]
    assert np.abs(own).max() < 0.7 * np.abs(V).max()
    assert own + cuts.shear == pytest.approx(np.interp(cuts.x + 4, s, V), abs=0.01 * np.abs(V).max())


def test_a_rectangle_carries_its_share_of_both() -> None:
    """Of one curvature: 0.4 0.8^3 / 12 = 0.017067 m4 beside 1 0.4^3 / 12 = 0.005333 m4, of moment and shear force."""
    _, s, M, V = solved(rib(8.0, [-4.0, 4.0], {"kind": "rectangle", "width": 0.4, "height": 0.8}))
    share = 0.4 * 0.8**3 / (0.4 * 0.8**3 + B * T**3)
    assert M.max() == pytest.approx(share * 1200e3, rel=0.01)
    away = (s > H) & (s < 8 - H)
    assert V[away] == pytest.approx(share * Q * (4 - s[away]), abs=0.01 * share * Q * (4 - H))


def test_a_rib_and_the_slab_beside_its_flange_carry_the_load() -> None:
    """In a slab of 3 m, 1.5 m of which are the flange: both moments add up to q L^2 / 8 of 3 m, to 1 %."""
    from groundslab.design.demands.cuts.section_cuts import strip

    wide = 3.0
    lines = [{"kind": "line", "points": [(x, -wide / 2), (x, wide / 2)], "acts": "both ways"} for x in (-4.0, 4.0)]
    plate = {"length_x": 8.0, "length_y": wide, "thickness": 0.3, "E": 30e9, "nu": 0.2}
    model = rib(8.0, [], RIB | {"effective_width": 1.5}, plate=plate, supports=lines)
    results, s, M, _ = solved(model)
    whole, flange = (strip(results["ULS"].plate, (-3.0, 0.0), (3.0, 0.0), b, 7) for b in (wide, 1.5))
    exact = Q * wide * (8.0**2 / 8 - whole.x**2 / 2)
    beside = whole.moment - flange.moment
    assert beside + np.interp(whole.x + 4, s, M) == pytest.approx(exact, abs=0.01 * exact.max())


def test_the_slab_is_checked_beside_the_web() -> None:
    """Its one-way shear governs at the web's face or beyond, not over the web of 0.4 m, whose shear is the rib's."""
    results = gs.solve(rib(8.0, [-4.0, 4.0], RIB))
    (check,) = (check for check in gs.check_design(results).checks if check.name == "one-way shear")
    assert check.place is not None
    assert abs(check.place[1]) >= 0.2 - 1e-9


@pytest.mark.parametrize("torsion", ["resisted", "released"])
def test_torsion_of_a_rib_by_statics(torsion: str) -> None:
    """40 kN/m at 0.2 m from the axis between forks 8 m apart: 8 (4 - s) kNm, all but what a strip of 0.1 m carries.

    J of the rib is 0.1406 0.4^4 = 0.0036 m4, that of the strip 0.4 0.1^3 (1 / 3 - 0.21 / 4) = 0.000112 m4: 97 %. A
    released rib carries none of it.
    """
    from groundslab.model.structure.beams import torsion_constant

    width, e, q = 0.4, 0.2, 40e3
    load = {"kind": "line", "case": "G", "q": q, "points": [(-4.0, e), (4.0, e)]}
    plate = {"length_x": 8.0, "length_y": width, "thickness": 0.1, "E": 30e9, "nu": 0.0}
    lines = [{"kind": "line", "points": [(x, -width / 2), (x, width / 2)], "acts": "both ways"} for x in (-4.0, 4.0)]
    section = {"kind": "rib", "width": width, "height": 0.4, "effective_width": width}
    beam = {"name": "R", "points": [(-4.0, 0.0), (4.0, 0.0)], "section": section, "torsion": torsion}
    model = rib(8.0, [], RIB, plate=plate, supports=lines, beams=[beam], loads=[load], reinforcement=None)
    results = gs.solve(model)
    own = results["ULS"].beams[0]
    away = (own.way > H) & (own.way < 8 - H)
    share = torsion_constant(width, 0.4) / (torsion_constant(width, 0.4) + torsion_constant(width, 0.1))
    assert share == pytest.approx(0.97, abs=0.002)
    wanted = np.abs(q * e * (4 - own.way[away])) * (share if torsion == "resisted" else 0.0)
    assert np.abs(own.torsion[away]) == pytest.approx(wanted, abs=0.01 * q * e * 4)
