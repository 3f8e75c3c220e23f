"""What is said of a design: failures by hand, first in every view, and no approval where nothing fails."""

from __future__ import annotations

import io
import json
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from rich.console import Console

from groundslab.design.bars.required_bars import governing_needs
from groundslab.design.checks import Design, DesignCheck, check_design
from groundslab.design.codes.en1992_2004.annex import RECOMMENDED
from groundslab.design.codes.en1992_2004.checks.governing_perimeters import column_demands
from groundslab.design.codes.en1992_2004.materials import Concrete
from groundslab.design.codes.en1992_2004.punching import max_resistance, resistance_without_links
from groundslab.design.rules.check import SUPPORT_INSIDE
from groundslab.errors import GroundslabError, NotConverged, SingularMatrix
from groundslab.model.model import Model
from groundslab.results.records import SupportResult
from groundslab.results.results import Results
from groundslab.views.report.html import render_report
from groundslab.views.summary import terminal
from groundslab.views.summary.json_summary import json_text
from groundslab.workbench.solver.summary import build_summary
from helpers import synthetic
from helpers.synthetic import LENGTH_X, LENGTH_Y

STEEL = {"f_ck": "30 MPa", "f_yk": "500 MPa", "bottom": ("40 mm", "50 mm"), "top": ("40 mm", "50 mm")}
ULS = {"name": "ULS", "factors": {"G": 1.35}}
COLUMN = {"name": "C1", "x": 0, "y": 0, "width_x": 0.3, "width_y": 0.3}


def described(P: float = 100e3, **changes: Any) -> Model:
    """Return a slab of 400 mm with a column in its middle that carries so much, and one ultimate combination."""
    parts: dict[str, Any] = {
        "plate": {"length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": 0.4, "E": 30e9, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 20e6},
        "columns": [COLUMN],
        "cases": [{"name": "G"}],
        "loads": [{"kind": "point", "P": P, "column": "C1", "case": "G"}],
        "combinations": [ULS, {"name": "SLS", "limit_state": "characteristic", "factors": {"G": 1.0}}],
        "reinforcement": STEEL,
    }
    return Model(**parts | changes)


def solved(model: Model, m_x: float = 10e3) -> Results:
    """Return made-up results of all combinations, with one moment everywhere, an even pressure of 50 kPa."""
    made = {}
    for each in model.combinations:
        one = synthetic.results(24, model=model, combination=each.name, limit_state=each.limit_state,
                                factors=each.factors)  # fmt: skip
        flat = np.zeros(len(one.plate.nodes))
        fields = {"moment_x": flat + m_x, "moment_y": flat, "moment_xy": flat, "pressure": flat + 50e3}
        made[each.name] = replace(one, plate=replace(one.plate, **fields))
    return Results(model, model.combinations, made, {})


def words(design: Design, name: str) -> str:
    """Return what one check says, its status before it."""
    (check,) = [each for each in design.checks if each.name == name]
    return f"{check.status}: {check.words}"


def printed(combined: Results) -> str:
    """Return what the terminal shows."""
    console = Console(file=io.StringIO(), width=80)
    terminal.print_summary(combined, console)
    assert isinstance(console.file, io.StringIO)
    return console.file.getvalue()


def test_resistances_by_hand() -> None:
    """C30: nu = 0.6 (1 - 30/250) = 0.528, v_Rd,max = 0.4 0.528 20 MPa; d = 200 mm: k = 2, 0.12 k 60^(1/3) = 0.940 MPa.

    A ratio of bars above 0.02 does not count; with few bars the least value 0.035 2^1.5 30^0.5 = 0.542 MPa holds.
    """
    concrete = Concrete(30e6)
    assert max_resistance(concrete) == pytest.approx(4.224e6)
    assert resistance_without_links(concrete, 0.2) == pytest.approx(0.9396e6, rel=1e-4)
    assert resistance_without_links(concrete, 0.2, 0.05) == resistance_without_links(concrete, 0.2)
    assert resistance_without_links(concrete, 0.2, 0.001) == pytest.approx(0.5422e6, rel=1e-3)
    # k = 1 + sqrt(200 / 800) = 1.5
    assert resistance_without_links(concrete, 0.8) == pytest.approx(0.12 * 1.5 * 60 ** (1 / 3) * 1e6)


def test_punching_at_the_face_by_hand() -> None:
    """1.35 x 1.5 MN less 50 kPa on 0.09 m2, over u_0 = 1.2 m and d = 0.355 m, is 4.743 MPa: above 4.224 MPa.

    Half of it is not, and the check says how near it comes, not that punching is fine.
    """
    of = solved(described(1.5e6))
    (demand,) = column_demands(of).found.values()
    assert demand.face is not None
    assert demand.face.u == pytest.approx(1.2)
    assert demand.face.v_Ed == pytest.approx((1.35 * 1.5e6 - 50e3 * 0.09) / (1.2 * 0.355))
    design = check_design(of)
    assert design.status == "fails"
    said = words(design, "punching at the column's face")
    assert said.startswith('fails: 1 column; worst C1 in "ULS": v_Ed 4.74 MPa, with beta 1.00, is 1.12 times 4.22 MPa')
    half = words(check_design(solved(described(0.75e6))), "punching at the column's face")
    assert half == "no failure found: v_Ed is at most 56 % of v_Rd,max, C1"


def test_punching_at_2d_by_hand() -> None:
    """On u = 1.2 + 4 pi d, v_Rd,c for 2 % of bars is 0.822 MPa: more needs links, 1.5 times as much fails.

    Without bars it is v_min, and what is between asks for bars in tension: of 0.98 v_Rd,c for 2 % times 0.98^3.
    """
    d = 0.355
    u, area = 1.2 + 4 * np.pi * d, 0.09 + 1.2 * 2 * d + np.pi * (2 * d) ** 2
    v_Rd_c = 0.12 * (1 + np.sqrt(200 / 355)) * 60 ** (1 / 3) * 1e6
    assert resistance_without_links(Concrete(30e6), d) == pytest.approx(v_Rd_c)
    v_min = 0.035 * (1 + np.sqrt(200 / 355)) ** 1.5 * np.sqrt(30) * 1e6
    least = v_min / v_Rd_c
    shares = {0.98 * least: "no failure found", 1.02 * least: "attention", 0.98: "attention", 1.02: "fails",
              1.48: "fails", 1.52: "fails"}  # fmt: skip
    for share, status in shares.items():
        P = (share * v_Rd_c * u * d + 50e3 * area) / 1.35
        said = words(check_design(solved(described(P))), "punching within 2 d")
        assert said.startswith(status), said
        assert ("punching reinforcement is needed" in said) == (1 < share < 1.5)
        of_bars = f"C1 needs bars in tension of {2 * share**3:.2g} % of the section, and none are provided"
        assert (of_bars in said) == (least < share < 1)
    assert RECOMMENDED.k_max == 1.5


@pytest.mark.parametrize(
    ("code", "about"),
    [
        ("EN 1992-1-1", "punching within 2 d"),
        ("EN 1992-1-1:2023", "punching"),
        ("ACI 318", "two-way shear"),
    ],
)
def test_a_support_inside_the_perimeter(code: str, about: str) -> None:
    """A pile under the column takes off a part: what holds without it holds; what does not is not judged.

    What the pile adds as it pulls counts in full, on the safe side: what holds with it holds, what does not is not
    judged, as no perimeter of the column alone has both.
    """
    supports = [{"kind": "point", "x": 0, "y": 0, "stiffness": "10 MN/m"}]

    def checked(P: float, force: float) -> tuple[DesignCheck, ...]:
        of = solved(described(P, supports=supports, reinforcement=STEEL | {"code": code, "f_ck": "30 MPa"}))
        zero = np.zeros(1)
        pile = SupportResult("pile", np.zeros((1, 2)), zero, zero, zero + force, zero, zero)
        made = {name: replace(one, supports=(pile,)) for name, one in of.results.items()}
        return tuple(each for each in check_design(replace(of, results=made)).checks if about in each.name)

    alone = solved(described(100e3, reinforcement=STEEL | {"code": code}))
    (bare,) = [each for each in check_design(alone).checks if each.name == about]
    (held,) = checked(100e3, 50e3)
    assert (held.status, held.demand) == (bare.status, pytest.approx(bare.demand))
    (pulled,) = checked(100e3, -135e3)
    assert pulled.demand == pytest.approx(bare.demand + checked(200e3, 0.0)[0].demand - bare.demand, rel=1e-9)
    assert [each.unjudged for each in checked(100e3, -9e6)] == [SUPPORT_INSIDE]
    (given_up,) = [each for each in checked(5e6, 4e6) if each.unjudged is not None]
    assert given_up.unjudged is SUPPORT_INSIDE
    assert given_up.status == "attention"
    assert "(C1) have another support inside their perimeters; with what it adds and" in given_up.words
    assert given_up.words.endswith(SUPPORT_INSIDE.do)


def test_bending_that_no_reinforcement_carries() -> None:
    """20 MNm/m fail, with the layer, the moment, the place and the combination; 900 kNm/m need bars in compression."""
    said = words(check_design(solved(described(), 20e6)), "bending")
    assert said.startswith(
        "fails: the concrete is too weak for any reinforcement on 100 % of the plate's area; bottom x: "
    )
    assert '2e+04 kNm/m at (0.000, 0.000) m in "ULS", thickness 0.4 m' in said
    design = check_design(solved(described(), 900e3))
    assert design.status == "attention"
    assert words(design, "bending").startswith("no failure found")
    assert words(design, "compression reinforcement").startswith("attention: bars in compression, held by links")
    assert design.headline == "DESIGN NEEDS ATTENTION: 1 of 5 checks needs it."


def test_nothing_that_fails_is_no_approval() -> None:
    """Where nothing fails the headline says what was not checked; without bars, that nothing was."""
    design = check_design(solved(described()))
    assert design.headline.startswith("No failure found in 5 checks; anchorage is not checked")
    assert not design.open
    assert check_design(solved(described(reinforcement=None))).headline.startswith("Strength was not checked")
    assert "This is not a design approval" in printed(solved(described()))


def test_ultimate_combinations_that_count_for_nothing() -> None:
    """Unsolved ones leave a design open; if all are, nothing is checked; characteristic ones are never designed for."""
    model = described(combinations=[ULS, {**ULS, "name": "more"}])
    of = solved(model)
    refused: dict[str, GroundslabError] = {"more": NotConverged("gamma", [], {})}
    design = check_design(replace(of, results={"ULS": of.results["ULS"]}, refused=refused))
    assert words(design, "unsolved combinations").startswith('attention: not judged: no certified result of "more"')
    assert design.headline.endswith(" Not judged: 1 of 6 (unsolved combinations).")
    none = check_design(replace(of, results={}, refused={**refused, "ULS": SingularMatrix("no")}))
    assert [(each.name, each.status) for each in none.checks] == [("unsolved combinations", "attention")]
    assert column_demands(solved(described())).found.keys() == {("ULS", "C1")}
    given = check_design(solved(described(combinations=[{**ULS, "factors": {"G": 1.0}}])))
    assert "must hold the partial factors" in words(given, "partial factors")


FAILING = solved(described(5e6))
ALONE = solved(described(5e6, combinations=[ULS]))


@pytest.mark.parametrize("of", [FAILING, ALONE], ids=["several", "one"])
def test_failure_comes_first_on_the_terminal(of: Results) -> None:
    """The headline is the first line, the reasons follow, and the last line repeats it; 80 columns, no tags."""
    lines = printed(of).splitlines()
    assert lines[0].startswith("DESIGN FAILS: punching at the column's face, 3.75 times its limit; 2 of 5")
    assert lines[1] == "checks fail."
    assert lines[4].startswith("  3.75 punching at the column's face: 1 column; worst C1")
    assert any(line.startswith("DESIGN FAILS") for line in lines[-3:])
    assert max(map(len, lines)) <= 80
    assert "certified: equilibrium and contact conditions are satisfied on this mesh" in " ".join(lines)
    assert not any("fulfil" in line for line in lines)


@pytest.mark.parametrize("of", [FAILING, ALONE], ids=["several", "one"])
def test_failure_comes_first_in_json(of: Results) -> None:
    """The design stands before any figure, with its verdict, its words, and each check."""
    document = json.loads(json_text(of))
    heads = ["program", "version", "format", "environment", "title", "certified", "provisional", "design"]
    assert list(document)[: len(heads)] == heads
    assert document["certified"] is True
    assert document["design"]["status"] == "fails"
    assert document["design"]["headline"].startswith("DESIGN FAILS")
    assert [each["status"] for each in document["design"]["checks"]][:2] == ["fails", "fails"]
    if of is ALONE:
        assert (document["combination"], document["limit_state"]) == ("ULS", "ultimate")


@pytest.mark.slow
def test_failure_comes_first_in_report_and_workbench() -> None:
    """The report's title block has it before the certificate's verdict; the workbench gets headline and checks."""
    page = render_report(FAILING)
    assert page.index("DESIGN FAILS") < page.index("certified: equilibrium") < page.index('<nav class="contents')
    reported = build_summary(FAILING)["design"]
    assert reported["headline"].startswith("DESIGN FAILS")
    assert reported["checks"][0]["status"] == "fails"


def test_two_meganewtons_on_a_thin_slab() -> None:
    """250 mm, a column of 300 mm with 2000 kN: d = 205 mm, 8.1 MPa at its face; the first line says so."""
    plate = {"length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": 0.25, "E": 30e9, "nu": 0.2}
    of = solved(described(2e6, plate=plate, combinations=[{"name": "ULS", "factors": {"G": 1.0}}]))
    thin = {name: replace(each, elements=replace(each.elements, thickness=np.full_like(each.elements.thickness, 0.25)))
            for name, each in of.results.items()}  # fmt: skip
    design = check_design(replace(of, results=thin))
    (face,) = [each for each in design.checks if each.name == "punching at the column's face"]
    assert face.demand == pytest.approx((2e6 - 50e3 * 0.09) / (1.2 * 0.205) / 1e6)
    assert face.utilization == pytest.approx(1.92, abs=0.01)
    assert design.headline.startswith("DESIGN FAILS: punching")
    assert design.checks[0].utilization == max(each.utilization or 0.0 for each in design.checks)


def test_accidental_combinations_have_their_own_partial_factors() -> None:
    """Steel has 500 MPa instead of 434.8: a moment of 1.1 times the ultimate one needs fewer bars, of 1.2 times more.

    Concrete has 25 MPa instead of 20, which counts for less.
    """
    rare = {"name": "impact", "limit_state": "accidental", "factors": {"G": 1.0}}
    model = described(combinations=[ULS, rare])
    combined = solved(model, 200e3)
    for times, governs in ((1.1, "ULS"), (1.2, "impact")):
        impact = combined.results["impact"]
        plate = replace(impact.plate, moment_x=times * combined.results["ULS"].plate.moment_x)
        both = replace(combined, results={**combined.results, "impact": replace(impact, plate=plate)})
        needs = governing_needs(both, model.reinforcement)
        assert next(need for need in needs if need.layer == "bottom_x").combination == governs


def test_punching_of_an_accidental_combination() -> None:
    """At the face 1.35 x 1480 kN make 4.68 MPa: more than 4.22 MPa, not than 5.28 MPa of an accidental situation."""
    names = {"ultimate": "ULS", "accidental": "impact"}
    for worst, status in (("ultimate", "fails"), ("accidental", "no failure found")):
        made = [{"name": name, "limit_state": state, "factors": {"G": 1.35 if state == worst else 0.5}}
                for state, name in names.items()]  # fmt: skip
        found = check_design(solved(described(1480e3, combinations=made))).checks
        face = next(each for each in found if each.name == "punching at the column's face")
        assert (face.status, face.combination) == (status, names[worst])
        assert face.resistance == pytest.approx(4.224 if worst == "ultimate" else 5.28)
