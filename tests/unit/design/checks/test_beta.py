"""The factor beta of punching: by moments, constant where that holds, by sectors, or as given."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab.design.checks import DesignCheck, check_design
from groundslab.design.codes.en1992_2004.checks.governing_perimeters import column_demands
from groundslab.design.demands.by_plate import plate_under
from groundslab.design.rules.punching_beta import SECTORS, beta_by_sectors, sector_pieces
from groundslab.errors import InputError
from groundslab.model.model import Model
from groundslab.views.tables.result_tables import tables_of
from helpers.calculations import follow
from helpers.solve_once import solve_once

BARS = {key: {"diameter": 0.020, "spacing": 0.15} for key in ("bottom_x", "bottom_y", "top_x", "top_y")}
EN: dict[str, Any] = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.05, 0.07), "top": (0.05, 0.07), **BARS}
SECOND = EN | {"code": "EN 1992-1-1:2023"}
PLACES = {"inside": (0.0, 0.0), "edge": (0.0, 2.7), "corner": (3.7, 2.7)}


def raft(
    steel: dict[str, Any], where: str = "inside", M: float = 0.0, P: float = 500e3, size: float = 0.5, **column: Any
) -> Model:
    """Return a raft of 8 m by 6 m by 0.5 m on springs under one column with a moment M along x."""
    x, y = PLACES[where]
    return Model(
        plate={"length_x": 8.0, "length_y": 6.0, "thickness": 0.5, "E": 33e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 40e6},
        columns=[{"name": "C", "x": x, "y": y, "width_x": 0.4, "width_y": 0.4, **column}],
        cases=[{"name": "G"}],
        loads=[
            {"kind": "point", "case": "G", "column": "C", "P": P, "M_x": M},
            {"kind": "uniform", "case": "G", "q": 30e3},
        ],
        combinations=[{"name": "U", "factors": {"G": 1.0}}],
        reinforcement=steel,
        mesh={"size": size},
    )


def check(model: Model) -> DesignCheck:
    """Return the check of punching."""
    names = ("punching within 2 d", "punching")
    return next(each for each in check_design(solve_once(model)).checks if each.name in names)


def beta(model: Model) -> float:
    """Return the beta of the calculation."""
    (table,) = [each for each in tables_of(solve_once(model)) if each.name == "calculations"]
    rows = zip(table["check"], table["symbol"], table["value"], strict=True)
    return next(float(v) for name, symbol, v in rows if name == "punching" and str(symbol) in ("beta", "beta_e"))


@pytest.mark.parametrize(("where", "value"), [("inside", 1.15), ("edge", 1.4), ("corner", 1.5)])
def test_constants_of_beta(where: str, value: float) -> None:
    """Figure 6.21N, whatever the moments; the German annex has 1.10 inside."""
    constant = EN | {"beta": "constant", "braced": True}
    assert beta(raft(constant, where)) == pytest.approx(value)
    assert beta(raft(constant, where, M=80e3)) == pytest.approx(value)
    assert f"{value:.2f} constant" in check(raft(constant, where, P=2500e3)).words
    german = raft(constant | {"annex": "Germany"}, where)
    assert beta(german) == pytest.approx(1.10 if where == "inside" else value)


@pytest.mark.parametrize("steel", [EN, SECOND], ids=["2004", "2023"])
def test_a_number_is_taken(steel: dict[str, Any]) -> None:
    """For all, or of one column, before that for all."""
    assert beta(raft(steel | {"beta": 1.33})) == pytest.approx(1.33)
    assert beta(raft(steel | {"beta": "sectors"}, beta=1.25)) == pytest.approx(1.25)
    own = raft(steel | {"beta": 1.33}, beta="code")
    assert beta(own) == pytest.approx(beta(raft(steel)))


@pytest.mark.parametrize("steel", [EN, SECOND], ids=["2004", "2023"])
def test_sectors_without_a_moment(steel: dict[str, Any]) -> None:
    """In the middle all sectors carry nearly the same; with a moment the far side more, and never the less the more."""
    by_sectors = [beta(raft(steel | {"beta": "sectors"}, M=M, size=0.25)) for M in (0.0, 50e3, 200e3)]
    assert 1.0 <= by_sectors[0] < 1.12
    assert by_sectors == sorted(by_sectors)
    assert by_sectors[-1] > 1.3


def test_sectors_at_a_corner_are_continuous_in_the_moment() -> None:
    """1 kNm inwards or outwards moves beta by a thousandth; by moments it jumps, and the check says why."""
    shares = [check(raft(EN | {"beta": "sectors"}, "corner", M=M)).utilization or 0.0 for M in (-1e3, 1e3)]
    assert shares[0] == pytest.approx(shares[1], rel=0.01)
    inwards, outwards = (check(raft(EN, "corner", M=M, P=700e3)) for M in (-1e3, 1e3))
    assert (outwards.utilization or 0.0) > 1.5 * (inwards.utilization or 0.0)
    assert "as a moment of 1 kNm bends the column outwards" in outwards.words


def test_the_slab_s_shear_forces_balance_what_punches() -> None:
    """All sectors together carry V_Ed of the perimeter at 2 d, to 3 %; more sectors tell a larger mean."""
    results = solve_once(raft(EN | {"beta": "sectors"}, M=100e3))
    (demand,) = column_demands(results).found.values()
    far = demand.at_2d
    assert far is not None
    assert far.control is not None
    of_combination = results.results["U"]
    plate, center = plate_under(of_combination, 0.0, 0.0), np.zeros(2)
    pieces = sector_pieces(plate, far.control.legs, center, demand.d)
    total = sum(float(piece.forces(plate) @ piece.ds) for piece in pieces)
    assert total == pytest.approx(far.V_Ed, rel=0.03)

    def by(count: int, *, by_length: bool = False) -> float:
        axis = np.array([1.0, 0.0])
        found = beta_by_sectors(pieces, plate, center, axis, sign=1.0, count=count, by_length=by_length)
        assert found is not None
        return found

    assert by(1) == pytest.approx(1.0)
    assert by(4) < by(8) < by(SECTORS) < by(24) < 1.1 * by(SECTORS)
    assert by(SECTORS, by_length=True) == pytest.approx(by(SECTORS), rel=0.05)
    assert far.beta == pytest.approx(by(SECTORS), rel=1e-6)


@pytest.mark.parametrize(
    ("steel", "way"),
    [(EN, "constant"), (EN, "sectors"), (EN, 1.3), (SECOND, "sectors"), (SECOND, 1.3)],
)
def test_other_ways_are_named_where_they_differ(steel: dict[str, Any], way: str | float) -> None:
    """The calculation is followed, and has betas of other ways that differ by more than a fifth."""
    model = raft(steel | {"beta": way, "braced": True}, M=150e3)
    (table,) = [each for each in tables_of(solve_once(model)) if each.name == "calculations"]
    assert follow(table) > 10
    symbols = {str(symbol) for symbol in table["symbol"]}
    name = "beta" if steel is EN else "beta_e"
    by_moments, taken = beta(raft(steel, M=150e3)), beta(model)
    assert (f"{name}_m" in symbols) == (abs(by_moments - taken) > 0.2 * taken)
    assert (f"{name}_a,24" in symbols) == (way == "sectors")


def test_constants_need_a_braced_case() -> None:
    """Of all, or of one column."""
    for steel, column in ((EN | {"beta": "constant"}, {}), (EN, {"beta": "constant"})):
        with pytest.raises(InputError) as refused:
            raft(steel, **column)
        assert [issue.location for issue in refused.value.issues] == ["reinforcement.braced"]


def test_constants_of_the_second_generation_are_not_known() -> None:
    """They were read in no source."""
    with pytest.raises(InputError) as refused:
        raft(SECOND | {"beta": "constant", "braced": True})
    assert [issue.location for issue in refused.value.issues] == ["reinforcement.beta"]


def test_aci_has_no_beta() -> None:
    """It has the stress of moments where that is largest."""
    aci = EN | {"code": "ACI 318", "f_yk": 420e6}
    with pytest.raises(InputError) as refused:
        raft(aci | {"beta": "sectors"})
    assert [issue.location for issue in refused.value.issues] == ["reinforcement.beta"]
    with pytest.raises(InputError) as refused:
        raft(aci, beta=1.2)
    assert [issue.location for issue in refused.value.issues] == ["columns[1].beta"]


@pytest.mark.parametrize(("x", "holds"), [(4.6, True), (7.0, False)])
def test_constants_need_like_spans(x: float, holds: bool) -> None:
    """Spans of 4 m and 4.6 m are alike, 4 m and 7 m are not: beta by moments is taken, and a check says so."""
    places = {"A": -4, "B": 0, "C": x}
    columns = [{"name": name, "x": place, "y": 0, "width_x": 0.4, "width_y": 0.4} for name, place in places.items()]
    model = Model(
        plate={"outline": {"kind": "rectangle", "x": (-6, 9), "y": (-3, 3)}, "thickness": 0.5, "E": 33e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 40e6},
        columns=columns,
        cases=[{"name": "G"}],
        loads=[{"kind": "point", "case": "G", "column": name, "P": 600e3} for name in "ABC"],
        combinations=[{"name": "U", "factors": {"G": 1.0}}],
        reinforcement=EN | {"beta": "constant", "braced": True},
        mesh={"size": 0.5},
    )  # fmt: skip
    results = solve_once(model)
    rows = [each for each in check_design(results).checks if each.name == "constant beta"]
    assert [each.status for each in rows] == ([] if holds else ["attention"])
    betas = {demand.name: demand.at_2d.way for demand in column_demands(results).found.values() if demand.at_2d}
    assert betas == {"A": "constant", "B": "constant" if holds else "code", "C": "constant"}
