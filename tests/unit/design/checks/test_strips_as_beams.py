"""Strips of the plate that are designed as beams: their forces, bars, links, and what is no longer the plate's."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.design.bars.beam_bars import courses
from groundslab.design.bars.members import members_of, strip_forces
from groundslab.design.checks import DesignCheck, check_design
from groundslab.design.checks.beams import BARS, LINKS
from groundslab.design.codes.registry import code_of
from groundslab.design.rules.webs import Web
from groundslab.errors import InputError
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.model import Model
from groundslab.results.records import BeamResult
from groundslab.views.tables.result_tables import tables_of
from helpers.calculations import follow_steps
from helpers.solve_once import solve_once

L, B, H, AXIS, C = 8.0, 1.0, 0.6, 0.06, 0.4
D = H - AXIS
LAYERS = ("bottom_x", "bottom_y", "top_x", "top_y")
STEEL: dict[str, Any] = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (AXIS, AXIS), "top": (AXIS, AXIS)}
LAID = STEEL | {layer: {"diameter": 0.020, "spacing": 0.125} for layer in LAYERS}
GERMANY, ACI = LAID | {"annex": "Germany"}, LAID | {"code": "ACI 318", "f_yk": 420e6}
SECOND = LAID | {"code": "EN 1992-1-1:2023"}
ALONG = {"of": "S", "diameter": 0.012, "legs": 4, "spacing": 0.2}


def footing(
    steel: dict[str, Any] | None = None,
    *,
    e: float = 0.0,
    P: float = 700e3,
    b: float = B,
    size: float = 0.5,
    **strip: Any,
) -> Model:
    """Return a footing of 8 m by 1 m by 0.6 m under two columns, whose forces are off its axis by e and -e [m]."""
    return Model(
        plate={"length_x": L, "length_y": b, "thickness": H, "E": 33e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 40e6},
        columns=[{"name": name, "x": x, "y": 0.0, "width_x": C, "width_y": C} for name, x in (("A", -3.0), ("B", 3.0))],
        cases=[{"name": "G"}],
        loads=[
            {"kind": "point", "case": "G", "column": name, "P": P, "M_y": sign * P * e}
            for name, sign in (("A", 1), ("B", -1))
        ],
        combinations=[{"name": "U", "factors": {"G": 1.35}, "limit_state": "ultimate"}],
        output={
            "strips": [{"name": "S", "start": (-L / 2, 0), "end": (L / 2, 0), "width": b, "design": "beam"} | strip]
        },
        reinforcement=steel,
        mesh={"size": size},
    )


def checks(model: Model) -> dict[str, DesignCheck]:
    """Return the checks by their names."""
    return {check.name: check for check in check_design(solve_once(model)).checks}


def with_links(steel: dict[str, Any], *links: dict[str, Any]) -> dict[str, Any]:
    """Return a reinforcement with links along the strip, some of their keys changed."""
    return steel | {"beam_links": [ALONG | changes for changes in links or ({},)]}


def forces(model: Model) -> BeamResult:
    """Return the section forces of the strip."""
    return strip_forces(solve_once(model)["U"], model.output.strips[0])


def test_forces_are_those_of_what_lies_ahead() -> None:
    """M, V and T between the columns are what pressure and the column ahead make."""
    model = footing(e=0.1)
    own, plate = forces(model), solve_once(model)["U"].plate
    for x in (-1.0, 0.0, 1.5):
        ahead = np.where(plate.nodes[:, 0] > x + 1e-9, 1.0, np.where(plate.nodes[:, 0] > x - 1e-9, 0.5, 0.0))
        p = ahead * plate.pressure * plate.area
        P = 1.35 * 700e3
        at = own.at(np.array([x + L / 2]))
        lever = plate.nodes[:, 0] - x
        assert -at.shear[0] == pytest.approx(p.sum() - P, abs=0.01 * P)
        assert at.moment[0] == pytest.approx(p @ lever - P * (3.0 - x), rel=0.02)
        assert abs(at.torsion[0]) == pytest.approx(abs(p @ plate.nodes[:, 1] + P * 0.1), rel=0.02)


def test_links_by_hand() -> None:
    """V / (z f_ywd cot theta), with V at d from the face of a column; cot theta is 2.5."""
    model = footing(with_links(LAID, {"spacing": 0.15}), P=1800e3, size=0.25)
    own, found = forces(model), checks(model)[LINKS]
    to_face = 1.0 + C / 2 + D  # from the start of the strip, the column being 1 m from it
    V = abs(float(np.interp(to_face, own.way, own.shear)))
    needed = V / (0.9 * D * 500e6 / 1.15 * 2.5)
    assert needed > 0.08 * math.sqrt(30) / 500 * B
    rows = next(each for each in tables_of(solve_once(model)) if each.name == "beam_reinforcement")
    links = dict(zip(rows["bars"], rows["required links"], strict=True))["links"]
    assert links == pytest.approx(1e4 * needed, rel=0.01)
    assert found.status == "no failure found"
    few = footing(with_links(LAID, {"diameter": 0.010, "spacing": 0.3}), P=1800e3, size=0.25)
    found = checks(few)[LINKS]
    assert found.demand == pytest.approx(1e4 * needed, rel=0.01)
    assert found.resistance == pytest.approx(1e4 * 4 * math.pi * 0.005**2 / 0.3)
    assert found.status == "fails"


def test_without_links_a_beam_fails() -> None:
    """One whose bars are laid; as long as none are, there is nothing to judge."""
    assert checks(footing(LAID))[LINKS].status == "fails"
    assert LINKS not in checks(footing(STEEL))


@pytest.mark.parametrize(
    ("changes", "what"),
    [
        ({"spacing": 0.41}, "distance of links 410"),
        ({"legs": 2, "diameter": 0.016, "spacing": 0.1}, "distance of legs 984"),
        ({"diameter": 0.008, "spacing": 0.4}, "links 8."),
        ({"start": 2.0}, "links"),
        ({"end": 6.0}, "links"),
    ],
)
def test_links_that_are_not_enough_fail(changes: dict[str, Any], what: str) -> None:
    """Too far from each other along or across (0.75 d = 405 mm), too few, or not all along the beam."""
    found = checks(footing(with_links(LAID, changes)))[LINKS]
    assert found.status == "fails"
    assert what in found.words


def test_links_in_parts() -> None:
    """Links of several parts are one beam's."""
    parts = with_links(LAID, {"end": 4.0}, {"start": 4.0, "legs": 5})
    assert checks(footing(parts))[LINKS].status == "no failure found"


@pytest.mark.parametrize("code", [LAID, GERMANY, ACI, SECOND], ids=["EN", "Germany", "ACI", "2023"])
def test_inner_legs_carry_no_torsion(code: dict[str, Any]) -> None:
    """Closed links carry torsion by their outer legs: with twice the legs they need as much more as that part is."""
    steel = Reinforcement.model_validate(code)
    rule = code_of(steel).beams
    assert rule is not None
    V, T = np.array([400e3]), np.array([120e3])
    web = Web(V, T, B, np.array([H]), np.array([D]), AXIS)
    need = rule.web(steel, "ultimate", web)
    two, four = (float(need.links_of(np.array([legs]))[0]) for legs in (2, 4))
    assert two == float(need.links[0])
    assert four - two == pytest.approx(float(need.closed[0]))
    assert need.closed[0] > 0


@pytest.mark.parametrize("code", [LAID, GERMANY, ACI, SECOND], ids=["EN", "Germany", "ACI", "2023"])
@pytest.mark.parametrize(
    ("changes", "e", "share"),
    [
        ({}, 0.0, ""),
        ({"legs": 5, "spacing": 0.25}, 0.25, ""),
        ({"spacing": 0.5, "diameter": 0.016}, 0.0, "eta_s"),
        ({"spacing": 0.3, "diameter": 0.016, "legs": 6}, 0.25, "eta_s"),
        ({"legs": 2, "diameter": 0.02, "spacing": 0.1}, 0.0, "eta_s"),
    ],
)
def test_links_and_bars_that_are_given_have_a_sheet(
    code: dict[str, Any], changes: dict[str, Any], e: float, share: str
) -> None:
    """Each value follows from the numbers above it; the last one is the share of the check, of links or distances."""
    found = checks(footing(with_links(code, changes), e=e))
    for name in (LINKS, BARS):
        check = found[name]
        values = follow_steps(check.steps)
        symbol, last = list(values.items())[-1]
        assert last == pytest.approx(check.utilization, rel=1e-9)
        assert symbol in (("eta_w", "eta_s") if name == LINKS else ("eta_A",))
    if share and not e and code is not SECOND:
        assert found[LINKS].steps[-1].symbol == share
    if e and not share:
        torsion = {step.symbol for step in found[LINKS].steps}
        assert {"a_c", "n_w"} <= torsion


def test_bars_by_hand() -> None:
    """The slab's bars over the width against M / (z f_yd), M at the face of a column; more of them pass."""
    own, found = forces(footing()), checks(footing(with_links(LAID)))[BARS]
    M = np.abs(own.moment).max()
    K = M / (B * D**2 * 30e6 / 1.5)
    needed = M / (D * (1 - (1 - math.sqrt(1 - 2 * K)) / 2) * 500e6 / 1.15)
    least = 0.26 * 2.9 / 500 * B * D
    assert found.demand == pytest.approx(1e4 * max(needed, least), rel=0.02)
    assert found.resistance == pytest.approx(1e4 * math.pi * 0.01**2 / 0.125 * B)
    few = with_links(LAID | {layer: {"diameter": 0.012, "spacing": 0.25} for layer in LAYERS})
    assert checks(footing(few))[BARS].status == "fails"


def test_moments_count_at_faces_unless_peaks_do() -> None:
    """Within the faces of a column the moment is that at them."""
    results = solve_once(footing(LAID, P=1500e3))["U"]
    member = members_of(results.model)[0]
    peaks = strip_forces(results, results.model.output.strips[0])
    inside = (peaks.way > 0.8 + 1e-6) & (peaks.way < 1.2 - 1e-6)
    own = member.forces(results)
    low, high = np.interp([0.8, 1.2], peaks.way, peaks.moment)
    assert own.moment[inside].max() <= max(low, high) + 1e-6
    beside = ~inside & (own.way < L / 2)
    assert (own.moment[beside] == peaks.moment[beside]).all()
    counted = solve_once(footing(LAID | {"averaging": {"at_columns": "peak"}}, P=1500e3))["U"]
    assert (members_of(counted.model)[0].forces(counted).moment == peaks.moment).all()


def test_torsion_can_be_released() -> None:
    """Then neither bars nor links are for it."""
    tables = {}
    for torsion in ("resisted", "released"):
        model = footing(LAID, e=0.15, torsion=torsion)
        tables[torsion] = next(each for each in tables_of(solve_once(model)) if each.name == "beam_reinforcement")
    along = {name: dict(zip(table["bars"], table["required area"], strict=True)) for name, table in tables.items()}
    assert along["resisted"]["torsion"] > 1.0
    assert along["released"]["torsion"] == 0.0


def test_shear_along_is_the_beam_s() -> None:
    """What one-way shear judges in the strip is across it."""
    along = checks(footing(with_links(LAID)))["one-way shear"]
    as_plate = checks(footing(LAID, design="plate"))["one-way shear"]
    assert as_plate.utilization is not None
    assert along.utilization is not None
    assert along.utilization < 0.3 * as_plate.utilization


def test_shear_across_is_the_plate_s() -> None:
    """A wide footing under a line load along it bends and shears across, whatever it is along it."""

    def wide(design: str) -> Model:
        return Model(
            plate={"length_x": L, "length_y": 3.0, "thickness": H, "E": 33e9, "nu": 0.2},
            ground={"kind": "winkler", "k": 40e6},
            cases=[{"name": "G"}],
            loads=[{"kind": "line", "case": "G", "q": 600e3, "points": [(-L / 2, 0.0), (L / 2, 0.0)]}],
            combinations=[{"name": "U", "factors": {"G": 1.35}, "limit_state": "ultimate"}],
            output={"strips": [{"name": "S", "start": (-L / 2, 0), "end": (L / 2, 0), "width": 3.0, "design": design}]},
            reinforcement=with_links(LAID) if design == "beam" else LAID,
            mesh={"size": 0.5},
        )

    beam, plate = (checks(wide(design))["one-way shear"] for design in ("beam", "plate"))
    assert beam.demand == pytest.approx(plate.demand, rel=0.02)
    assert beam.utilization is not None
    assert beam.utilization > 0.5


@pytest.mark.parametrize("steel", [LAID, GERMANY, ACI], ids=["EN", "Germany", "ACI"])
def test_what_is_proposed_is_enough(steel: dict[str, Any]) -> None:
    """Bars and links of propose_bars satisfy both checks, with torsion."""
    asked = {key: value for key, value in steel.items() if key not in LAYERS}
    proposal = gs.propose_bars(solve_once(footing(asked, e=0.1)))
    found = checks(proposal.model)
    assert proposal.reinforcement.beam_links
    assert found[LINKS].status == found[BARS].status == "no failure found"
    assert found[LINKS].utilization is not None
    assert found[LINKS].utilization > 0.5


def test_distances_by_the_second_generation_need_attention() -> None:
    """They were read nowhere."""
    found = checks(footing(with_links(SECOND)))[LINKS]
    assert found.status == "attention"
    assert "not known" in found.words


def test_distances_of_links() -> None:
    """EN 9.2.2(6), (8) and 9.2.3(3), the German tables NA.9.1 and NA.9.2, ACI 318-19 Table 9.7.6.2.2 and 9.7.6.3.3."""

    def allowed(code: dict[str, Any], used: float, T: float = 0.0, V: float = 100e3) -> tuple[float, float]:
        steel = Reinforcement.model_validate(code)
        rule = code_of(steel).beams
        assert rule is not None
        assert rule.link_distances is not None
        web = Web(np.array([V]), np.array([T]), B, np.array([H]), np.array([D]), AXIS)
        along, across = rule.link_distances(steel, "ultimate", web, np.array([used]))
        return float(along[0]), float(across[0])

    assert allowed(LAID, 0.9) == pytest.approx((0.75 * D, 0.75 * D))
    assert allowed(LAID, 0.9, T=1.0) == pytest.approx((2 * (B + H) / 8, 0.75 * D))
    assert allowed(GERMANY, 0.3) == pytest.approx((0.3, 0.6))
    assert allowed(GERMANY, 0.31) == pytest.approx((0.3, 0.6))
    assert allowed(GERMANY, 0.7) == pytest.approx((0.25 * H, 0.6))
    assert allowed(ACI, 0.5) == pytest.approx((D / 2, D))
    sharp = 0.75 * (0.17 + 0.34) * math.sqrt(30) * 1e6 * B * D
    assert allowed(ACI, 0.5, V=sharp) == pytest.approx((D / 4, D / 2))
    p_h = 2 * (B + H - 4 * AXIS)
    assert allowed(ACI, 0.5, T=200e3) == pytest.approx((min(p_h / 8, D / 2, 0.3), D))


def test_tables_and_figure_have_strips() -> None:
    """Where beams stand strips that are beams do, too."""
    results = solve_once(footing(LAID))
    tables = {table.name: table for table in tables_of(results)}
    assert list(tables["beams"]["beam"]) == ["S"]
    assert set(tables["beam_reinforcement"]["beam"]) == {"S"}
    own = forces(footing(LAID))
    assert tables["beams"]["least moment"][0] == pytest.approx(own.moment.min() / 1e3, rel=1e-3)
    assert gs.plot(results, kind="beams").axes


@pytest.mark.parametrize(
    ("strip", "expected"),
    [
        ({"width": 0.8}, "one that reaches from edge to edge"),
        ({"start": (-4.0, -0.2), "end": (4.0, 0.2), "width": 2.0}, "one along x or along y"),
        ({"end": (5.0, 0.0)}, "one whose axis lies on it"),
        ({"b": 3.2}, "five times the thickness"),
    ],
)
def test_strips_that_are_no_beams(strip: dict[str, Any], expected: str) -> None:
    """A beam reaches from edge to edge, along the bars, on the plate."""
    with pytest.raises(InputError) as refused:
        footing(LAID, **strip)
    assert expected in str(refused.value)


@pytest.mark.parametrize(
    ("links", "expected"),
    [
        ([{"of": "T"}], "output.strips"),
        ([{"end": 9.0}], "at most 8.0 m"),
        ([{"start": 3.0, "end": 2.0}], "more than start"),
        ([{"end": 4.0}, {"start": 3.0}], "do not overlap"),
    ],
)
def test_links_that_lie_nowhere(links: list[dict[str, Any]], expected: str) -> None:
    """Links along what is no beam, beyond its end, or twice."""
    with pytest.raises(InputError) as refused:
        footing(with_links(LAID, *links))
    assert expected in str(refused.value).replace('strip with design = "beam"', "output.strips")


@pytest.mark.parametrize(("width", "judged"), [(1.0, False), (2.0, True)])
def test_punching_stays_where_a_perimeter_goes_around(width: float, judged: bool) -> None:
    """A beam that ends at less than d beside a column cannot be punched; a wider one can."""
    model = footing(with_links(LAID), b=width)
    found = checks(model)["punching within 2 d"]
    assert (found.utilization is not None) == judged
    assert ("stand on strips" in found.words) != judged


@pytest.mark.parametrize(("spacing", "status"), [(0.2, "no failure found"), (0.6, "fails")])
def test_links_of_ribs_are_checked_where_they_are_given(spacing: float, status: str) -> None:
    """As those of strips; without any the table says what is needed."""
    section = {"kind": "rib", "width": 0.4, "height": 0.5, "effective_width": 1.5}
    ribs = Model(
        plate={"length_x": L, "length_y": 4.0, "thickness": 0.25, "E": 33e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 40e6},
        beams=[{"name": "R", "points": [(-L / 2, 0.0), (L / 2, 0.0)], "section": section}],
        columns=[{"name": "A", "x": 0.0, "y": 0.0, "width_x": C, "width_y": C}],
        cases=[{"name": "G"}],
        loads=[{"kind": "point", "case": "G", "column": "A", "P": 800e3}],
        combinations=[{"name": "U", "factors": {"G": 1.35}, "limit_state": "ultimate"}],
        reinforcement=STEEL,
        mesh={"size": 0.5},
    )
    assert LINKS not in checks(ribs)
    links = {"of": "R", "diameter": 0.012, "legs": 2, "spacing": spacing}
    given = ribs.replace(reinforcement=Reinforcement.model_validate(STEEL | {"beam_links": [links]}))
    found = checks(given)[LINKS]
    assert (found.status, found.of) == (status, "R")


def test_no_beam_lies_on_another_along_it() -> None:
    """Each would leave its torsion to the other; they may meet end to end."""

    def halves(end: float) -> Model:
        parts = [("W", -L / 2, end), ("E", 0.0, L / 2)]
        strips = [{"name": name, "start": (low, 0), "end": (high, 0), "width": B, "design": "beam"}
                  for name, low, high in parts]  # fmt: skip
        return footing(LAID).replace(output={"strips": strips})

    assert len(halves(0.0).output.beams) == 2
    with pytest.raises(InputError) as refused:
        halves(1.0)
    assert "one that ends where the other begins" in str(refused.value)


def test_shear_counts_where_beams_cross() -> None:
    """Up to the faces of columns, however wide the beam across is."""
    steel = Reinforcement.model_validate(with_links(LAID))
    cross = {"name": "T", "start": (-1.0, -B / 2), "end": (-1.0, B / 2), "width": 3.0, "design": "beam"}
    plain = footing(LAID, P=1800e3)
    crossed = plain.replace(output={"strips": [*plain.output.strips, cross]})
    of = [next(each for each in courses(solve_once(model), steel) if each.member.name == "S")
          for model in (plain, crossed)]  # fmt: skip
    assert (of[0].webs.V == of[1].webs.V).all()
    assert of[0].webs.V.max() > 0
