"""What a report says of its case: the assumptions that hold in it, the keys that count, and no others."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from groundslab.model.combinations import list_combinations
from groundslab.model.model import Model
from groundslab.results.results import Results
from groundslab.views.report import content
from groundslab.views.report.assumptions import list_assumptions
from groundslab.views.report.input_tables import input_tables
from groundslab.views.summary import combinations
from groundslab.views.summary.sections import description
from helpers import synthetic

BAR = {"diameter": 0.012, "spacing": 0.15}
BARS = dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y"), BAR)
EN = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.052), "top": (0.04, 0.052)}
ACI = {**EN, "code": "ACI 318", "f_yk": 420e6}
CASES = [{"name": "G"}, {"name": "Q", "action": "variable"}]
LAYERS = [{"E": 10e6, "nu": 0.3, "thickness": 4}]


def model(**changes: Any) -> Model:
    """Return a slab on springs with two cases and two combinations."""
    parts: dict[str, Any] = {
        "plate": {"length_x": 9.6, "length_y": 7.2, "thickness": 0.4, "E": 30e9, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 20e6},
        "cases": CASES,
        "loads": [{"kind": "uniform", "q": 1e4, "case": "G"}],
        "combinations": [{"name": "ULS", "factors": {"G": 1.35}},
                         {"name": "QP", "limit_state": "quasi-permanent", "factors": {"G": 1.0}}],
    }  # fmt: skip
    return Model(**parts | changes)


def said(**changes: Any) -> str:
    """Return the assumptions of a case as one text."""
    of = model(**changes)
    return " ".join(list_assumptions(Results(of, of.combinations, {}, {})))


def test_what_cracks_and_yields_is_not_called_elastic() -> None:
    """With [cracking] it says which combinations crack; piles with a limit yield; else nothing does."""
    elastic = "it does not crack, creep or yield"
    assert elastic in said()
    cracked = said(reinforcement={**EN, **BARS}, cracking={"creep": 2.5, "limit_states": ["quasi-permanent"]})
    assert elastic not in cracked
    assert "In quasi-permanent combinations it has the secant stiffness of cracked sections" in cracked
    assert "creep coefficient 2.5" in cracked
    pile = {"kind": "point", "name": "P1", "x": 0, "y": 0, "stiffness": 5e7, "acts": "in compression", "limit": 1e6}
    assert "a limit yield there and keep that force: P1." in said(supports=[pile])
    assert "yield there" not in said(supports=[{**pile, "limit": None}])


def test_ground_and_contact_are_those_of_the_case() -> None:
    """Springs speak of no layers, layers of no springs; a glued plate does not lift off; a limit pressure is named."""
    assert "springs" in said()
    assert "rigid base" not in said()
    layered = said(ground={"kind": "vlasov", "layers": LAYERS}, beyond={"kind": "infinite"})
    assert "rigid base" in layered
    assert "extends infinitely beyond the plate" in layered
    assert "springs" not in layered
    assert "on a half-space" in said(ground={"kind": "continuum", "half_space": {"E": 20e6, "nu": 0.3}})
    assert "the ground can carry tension" in said(contact={"tensionless": False})
    assert "limit pressure of 300 kPa" in said(contact={"limit_pressure": 3e5})
    assert "must not be added up" not in said(combinations=[{"name": "ULS", "factors": {"G": 1.35}}])


def echoed(of: Model) -> str:
    """Return all that the chapter of the case shows."""
    return " ".join(
        f"{head.text} {head.symbol} {cell.text}"
        for section in input_tables(of, list_combinations(of)) for grid in section.grids for row in grid.rows
        for head, cell in zip(grid.heads, row, strict=True)
    )  # fmt: skip


def test_a_case_by_aci_318_shows_no_factors_of_en() -> None:
    """No gamma_G 1.35, no annex, no UPL factors of EN 1997, no psi; a case by EN has what its sets take."""
    aci = model(reinforcement=ACI, combine={"sets": ["ultimate", "characteristic"], "expression": "ACI 318"},
                combinations=[])  # fmt: skip
    shown = echoed(aci)
    for word in ("1.35", "recommended", "annex", "EN 1997", "psi_0", "equilibrium", "uplift", "gamma_C", "w_max"):
        assert word not in shown, word
    assert "size effect" in shown
    en = echoed(model(reinforcement=EN, combine={"sets": ["ultimate"]}, combinations=[]))
    for word in ("1.35", "annex", "psi_0"):
        assert word in en, word
    assert "uplift" not in en
    assert "size effect" not in en
    assert "EN 1997" in echoed(model(combine={"sets": ["uplift"]}, combinations=[]))


def test_constants_that_are_the_same_stand_once() -> None:
    """Two combinations with the same constants share a row without a name; others have a row each, with their names."""
    both = synthetic.combined()
    found = combinations.entries(both)
    (row,) = content.list_constants(found, "SI").rows
    assert not [head for head in content.list_constants(found, "SI").heads if head.text == "combination"]
    first, second, *others = found
    assert second.results is not None
    softer = replace(second.results, constants=replace(second.results.constants, k0=(1e6,)))
    table = content.list_constants([first, replace(second, results=softer), *others], "SI")
    assert len(table.rows) == 2
    assert len(table.heads) == len(row) + 1
    assert table.rows[1][0].text == second.combination.name


def test_several_plates_are_described_as_several() -> None:
    """The sides are those of all plates together, as their area is; each plate has a row of its own."""
    of = model(plates=[{"name": "bay 2", "outline": {"kind": "rectangle", "x": (5.0, 11.0), "y": (-3.6, 3.6)},
                        "thickness": 0.25, "E": 30e9, "nu": 0.2}])  # fmt: skip
    plates, *_ = description(synthetic.results(model=of))
    rows = {row.key: row.value for row in plates.rows}
    assert plates.title == "Plates"
    assert (rows["plates"], rows["length_x"], rows["length_y"]) == (2, pytest.approx(15.8), pytest.approx(7.2))
    assert rows["plate_2"] == "6 x 7.2 m, t 0.25 m, E 30000 MPa, nu 0.2"


def test_national_parameters_are_named_in_one_line() -> None:
    """Of an annex, with where its sources are listed; recommended values and other codes have none."""
    german = said(reinforcement={**EN, "annex": "Germany"})
    assert german.count("National parameters are those of DIN EN 1992-1-1/NA") == 1
    assert "one source" not in german
    assert "National parameters" not in said(reinforcement=EN) + said(reinforcement=ACI)
