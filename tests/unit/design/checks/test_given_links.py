"""Links against punching that are given: what they carry, what codes ask of them, and that proposed ones are enough."""

from __future__ import annotations

import math
from typing import Any

import pytest

import groundslab as gs
from groundslab.design.checks import DesignCheck, check_design
from groundslab.design.checks.punching import LINKS
from groundslab.errors import InputError
from groundslab.model.model import Model
from groundslab.views.tables.result_tables import tables_of
from helpers.calculations import follow, follow_steps
from helpers.solve_once import solve_once

AXES = {"bottom": (0.05, 0.066), "top": (0.05, 0.066)}
D, C, H = 0.45 - 0.058, 0.4, 0.45
BARS = {key: {"diameter": 0.025, "spacing": 0.1} for key in ("bottom_x", "bottom_y", "top_x", "top_y")}
EN: dict[str, Any] = {"f_ck": 30e6, "f_yk": 500e6, **AXES, **BARS}
ACI: dict[str, Any] = EN | {"code": "ACI 318", "f_yk": 420e6}
SECOND: dict[str, Any] = EN | {"code": "EN 1992-1-1:2023"}
#: 2 x 12 legs of 10 mm and more of them farther out.
GIVEN = {"of": "A", "diameter": 0.010, "distances": (0.19, 0.48, 0.77), "legs": (20, 24, 28)}


def raft(steel: dict[str, Any], P: float = 1500e3, **changes: Any) -> Model:
    """Return a raft of 8 m by 5 m by 0.45 m on springs under one column."""
    plate = {"length_x": 8.0, "length_y": 5.0, "thickness": H, "E": 33e9, "nu": 0.2}
    return Model(
        plate=plate | changes.pop("plate", {}),
        ground={"kind": "winkler", "k": 30e6},
        columns=[{"name": "A", "x": 0, "y": 0, "width_x": C, "width_y": C} | changes.pop("column", {})],
        cases=[{"name": "G"}],
        loads=[{"kind": "point", "case": "G", "column": "A", "P": P}, {"kind": "uniform", "case": "G", "q": 20e3}],
        combinations=[{"name": "U", "factors": {"G": 1.35}}],
        reinforcement=steel,
        mesh={"size": 0.5},
        **changes,
    )


def checks(model: Model) -> dict[str, DesignCheck]:
    """Return the checks by their names."""
    return {check.name: check for check in check_design(solve_once(model)).checks}


def with_links(steel: dict[str, Any], **changes: Any) -> dict[str, Any]:
    """Return a reinforcement with the links of GIVEN, some of their keys changed."""
    return steel | {"links": [GIVEN | changes]}


def values(model: Model) -> dict[str, float]:
    """Return the values of the calculation of punching by their symbols."""
    table = next(each for each in tables_of(solve_once(model)) if each.name == "calculations")
    rows = zip(table["check"], table["symbol"], table["value"], strict=True)
    return {str(symbol): float(value) for check, symbol, value in rows if str(check) in ("punching", "two-way shear")}


def test_what_links_carry_by_en1992() -> None:
    """v_Rd,cs = 0.75 v_Rd + n_s A_sw f_ywd,ef / (u d) on the perimeter that governs, 6.52, by the fewest legs."""
    model = raft(with_links(EN, legs=(40, 44, 48)), P=2000e3)
    check = checks(model)["punching within 2 d"]
    found = values(model)
    f = min(250 + 0.25 * D * 1e3, 500 / 1.15)
    A_sw = 40 * math.pi * 0.01**2 / 4
    count = min(1.5 * D / 0.29, 1 + math.floor((found["a"] - 0.19) / 0.29 + 1e-6))
    v_Rd_cs = 0.75 * found["v_Rd"] + count * A_sw * f / (found["u"] * D)
    assert found["v_Rd,cs"] == pytest.approx(v_Rd_cs, rel=1e-5)
    assert check.resistance == pytest.approx(max(v_Rd_cs, found["v_Rd"]), rel=1e-5)
    assert check.demand == pytest.approx(found["v_Ed"], rel=1e-5)
    assert "v_Rd,cs with the links given" in check.words


def test_what_links_carry_by_the_german_annex() -> None:
    """The two inner perimeters carry beta V_Ed alone, or a further one over its 0.33."""
    model = raft(with_links(EN | {"annex": "Germany"}, legs=(40, 48, 29), distances=(0.12, 0.315, 0.51)), P=1500e3)
    found, check = values(model), checks(model)["punching within 2 d"]
    f = min(250 + 0.25 * D * 1e3, 500 / 1.15)
    A_sw = min(88, 29 / 0.33) * math.pi * 0.01**2 / 4  # the third one has a little less than 0.33 of both
    assert found["v_Rd,cs"] == pytest.approx(A_sw * f / (found["u"] * D), rel=1e-5)
    assert check.resistance == pytest.approx(found["v_Rd,cs"], rel=1e-5)
    assert check.status == "no failure found"


@pytest.mark.parametrize("kind", ["links", "studs"])
def test_what_links_carry_by_aci(kind: str) -> None:
    """Phi v_n = 0.75 (v_c + A_v f_yt / (b_o s)), v_c 0.166 lambda_s r beside stirrups, 0.25 at most beside studs."""
    model = raft(with_links(ACI, kind=kind, distances=(0.19, 0.38, 0.57), legs=[16], diameter=0.012), P=1200e3)
    check = checks(model)["two-way shear"]
    b_o = 4 * (C + D)
    lambda_s = min(1.0, math.sqrt(2 / (1 + 0.004 * D * 1e3)))
    r = math.sqrt(30)
    v_c = (0.166 if kind == "links" else min(0.25, 0.083 * (2 + 40 * D / b_o))) * lambda_s * r
    v_s = 16 * math.pi * 0.012**2 / 4 * 413.6 / (b_o * 0.19)
    most = (0.498 if kind == "links" else 0.66) * r
    assert check.resistance == pytest.approx(0.75 * min(v_c + v_s, most), rel=1e-3)
    assert "phi v_n with the links given" in check.words


def test_what_links_carry_by_the_second_generation() -> None:
    """tau_Rd,cs by 8.104; how they are laid is not known, so that they need attention."""
    model = raft(with_links(SECOND, legs=[24]), P=2000e3)
    check, found = checks(model)["punching"], values(model)
    rho_w = 24 * math.pi * 0.01**2 / 4 / (0.29 * found["b_05"])
    f_ywd = 500 / 1.15
    carried = found["eta_c"] * found["tau_Rd,c"] + found["eta_s"] * rho_w * f_ywd
    assert found["tau_cs"] == pytest.approx(max(carried, rho_w * f_ywd), rel=1e-5)
    assert check.resistance == pytest.approx(min(found["tau_cs"], found["tau_max"]), rel=1e-5)
    assert check.status == ("attention" if (check.utilization or 0) <= 1 else "fails")
    assert "12.5.1" in check.words


@pytest.mark.parametrize(
    "steel", [EN, EN | {"annex": "Germany"}, ACI, SECOND], ids=["EN 1992", "Germany", "ACI 318", "2023"]
)
def test_what_links_carry_can_be_followed(steel: dict[str, Any]) -> None:
    """Each formula of the calculation gives its value."""
    (table,) = [each for each in tables_of(solve_once(raft(with_links(steel)))) if each.name == "calculations"]
    assert follow(table) > 20
    symbols = set(table["symbol"])
    assert {"v_Rd,cs", "tau_cs", "v_n"} & symbols


def test_studs_can_be_followed() -> None:
    """Those of ACI 318, too."""
    (table,) = [
        each for each in tables_of(solve_once(raft(with_links(ACI, kind="studs")))) if each.name == "calculations"
    ]
    assert follow(table) > 20


LAYOUTS: list[tuple[str, dict[str, Any], dict[str, Any], str]] = [
    ("enough", EN, {}, ""),
    ("first too far", EN, {"distances": (0.25, 0.48, 0.77)}, "inner perimeter from the face 250 mm > 196 mm"),
    ("first too near", EN, {"distances": (0.10, 0.39, 0.68)}, "inner perimeter from the face 100 mm < 117.6 mm"),
    ("too far apart", EN, {"distances": (0.19, 0.56, 0.85)}, "distance of perimeters 370 mm > 294 mm"),
    ("one perimeter", EN, {"distances": (0.19,), "legs": [60]}, ""),
    ("few legs far out", EN, {"legs": (20, 24, 5)}, "along the perimeter 0.77 m"),
    ("thick links", EN | {"annex": "Germany"}, {"diameter": 0.032, "distances": (0.12, 0.31, 0.5)}, "32 mm > 19.6 mm"),
    ("ACI, too far apart", ACI, {}, "distance of perimeters 290 mm > 196 mm"),
    (
        "ACI, thick links", ACI, {"diameter": 0.032, "distances": (0.19, 0.38, 0.57, 0.76), "legs": [20]},
        "diameter of links 32 mm > 24.5",
    ),
    ("ACI, not far enough", ACI, {"distances": (0.19, 0.38), "legs": [24]}, "d / 2 beyond the outer perimeter"),
]  # fmt: skip


@pytest.mark.parametrize(("_", "steel", "changes", "words"), LAYOUTS, ids=[name for name, *_ in LAYOUTS])
def test_what_codes_ask_of_links(_: str, steel: dict[str, Any], changes: dict[str, Any], words: str) -> None:
    """Each rule that is broken is the one that the check names; a single perimeter breaks that of two."""
    P = 1200e3 if steel is ACI else 1400e3
    check = checks(raft(with_links(steel, **changes), P=P))[LINKS]
    assert check.status == ("fails" if words or len(changes.get("distances", "12")) == 1 else "no failure found")
    assert words in check.words
    assert check.of == "A"
    assert list(follow_steps(check.steps).values())[-1] == pytest.approx(check.utilization, rel=1e-9)


RAFTS: dict[str, dict[str, Any]] = {
    "inside": {},
    "at an edge": {"column": {"y": 2.2}, "P": 800e3},
    "near a corner": {"column": {"x": 3.5, "y": 2.0}, "P": 380e3},
    "beside an opening": {
        "plate": {"openings": [{"kind": "rectangle", "x": (0.7, 1.2), "y": (-0.3, 0.3)}]}, "P": 1150e3
    },
}  # fmt: skip


GERMANY = EN | {"annex": "Germany"}
#: Few bars among which a proposal chooses, and no zones, which links do not depend on.
ALLOWED = {"diameters": (0.016, 0.02, 0.025), "spacings": (0.1, 0.15), "most_zones": 0}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("steel", "where"),
    [
        *[pytest.param(EN, where, id=f"EN 1992 {where}") for where in RAFTS],
        *[pytest.param(GERMANY, where, id=f"Germany {where}") for where in ("inside",)],
        *[pytest.param(ACI, where, id=f"ACI 318 {where}") for where in ("near a corner",)],
    ],
)
def test_links_that_are_proposed_are_enough(steel: dict[str, Any], where: str) -> None:
    """Solved with what is proposed, punching that fails without links, or holds, does not fail."""
    about = dict(RAFTS[where])
    share = {"Germany": 0.7}.get(steel.get("annex", ""), 0.83 if steel is not EN else 1.0)
    without_bars = {key: value for key, value in steel.items() if key not in BARS}
    model = raft(without_bars | {"proposal": ALLOWED}, P=about.pop("P", 1500e3) * share, **about)
    proposal = gs.propose_bars(solve_once(model))
    assert [layout.why for layout in proposal.links] == [""] * len(proposal.links)
    found = checks(proposal.model)
    failing = [check.words for name, check in found.items() if check.status == "fails" and "cover" not in name]
    assert failing == []
    if proposal.reinforcement.links:
        assert found[LINKS].status == "no failure found"
        without = proposal.model.replace(reinforcement=proposal.reinforcement.replace(links=()))
        name = "two-way shear" if steel is ACI else "punching within 2 d"
        assert checks(without)[name].status == "fails"


THIN = {"thickness": 0.19}


@pytest.mark.parametrize("steel", [EN, ACI], ids=["EN 1992", "ACI 318"])
def test_links_that_are_not_allowed_fail(steel: dict[str, Any]) -> None:
    """In slab of 190 mm (9.3.2(1)), or of d = 132 mm (22.6.7.1), links count for nothing, whatever they would carry."""
    thin = steel | {"bottom_y": BARS["bottom_y"]}
    model = raft(with_links(thin, distances=(0.05, 0.12, 0.19)), P=250e3, plate=THIN)
    check = checks(model)[LINKS]
    assert check.status == "fails"
    assert "thin" in check.words


def test_links_by_rules_that_are_not_known_need_attention() -> None:
    """Those of 2023 where they are needed."""
    check = checks(raft(with_links(SECOND, legs=[24]), P=2500e3))[LINKS]
    assert check.status == "attention"
    assert "12.5.1" in check.words


def test_links_where_nothing_punches_are_told() -> None:
    """Around a zone that does not exist; they take nothing off one-way shear, either."""
    found = checks(raft(with_links(EN, of="zone 7")))
    assert found["links without punching"].status == "attention"
    assert LINKS not in found
    assert found["one-way shear"].demand == checks(raft(EN))["one-way shear"].demand


def test_punching_without_links_fails() -> None:
    """What needs links and has none is no design."""
    check = checks(raft(EN, P=2000e3))["punching within 2 d"]
    assert check.status == "fails"
    assert check.words.startswith("punching reinforcement is needed at 1 column")


def test_too_few_legs_fail() -> None:
    """Links that do not carry the force are told by what they carry."""
    check = checks(raft(with_links(EN, legs=[4]), P=2000e3))["punching within 2 d"]
    assert check.status == "fails"
    assert (check.utilization or 0) > 1


def test_links_of_the_table_are_those_given() -> None:
    """The table has the legs that are given, the bar list their number."""
    tables = {table.name: table for table in tables_of(solve_once(raft(with_links(EN))))}
    assert tables["shear_reinforcement"]["legs"][:3] == (20, 24, 28)
    assert tables["shear_reinforcement"]["diameter"][0] == 10
    links = [row for row in tables["bars"].rows() if row[1] == "links"]
    assert [row[7] for row in links] == [72]


@pytest.mark.parametrize(
    ("steel", "links", "where"),
    [
        (EN, [GIVEN | {"of": "B"}], "reinforcement.links[1].of"),
        (EN, [GIVEN, GIVEN], "reinforcement.links[2].of"),
        (EN, [GIVEN | {"legs": (1, 2)}], "reinforcement.links[1].legs"),
        (EN, [GIVEN | {"kind": "studs"}], "reinforcement.links[1].kind"),
        (EN, [GIVEN | {"distances": (0.5, 0.2, 0.7)}], "reinforcement.links[1].distances"),
        (EN, [GIVEN | {"legs": []}], "reinforcement.links[1].legs"),
    ],
)
def test_links_that_cannot_be_are_refused(steel: dict[str, Any], links: list[dict[str, Any]], where: str) -> None:
    """Of what is not there, twice, with other numbers, studs by EN 1992-1-1, out of order, none."""
    with pytest.raises(InputError) as refused:
        raft(steel | {"links": links})
    assert where in [issue.location for issue in refused.value.issues]
