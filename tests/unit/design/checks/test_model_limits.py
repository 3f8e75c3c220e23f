"""What stands at a limit of the model has a row among the checks: by hand, and for every key that is a limit."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from scipy.optimize import fsolve

from groundslab.analysis.driver import solve, solve_combinations
from groundslab.design.checks import DesignCheck, check_design, model_limits
from groundslab.errors import InputError
from groundslab.fem.continuum import piles
from groundslab.model.model import Model
from groundslab.results.results import Results
from groundslab.schema.base import Section
from groundslab.views.tables.result_tables import tables_of
from helpers.calculations import follow_steps

STIFF = {"thickness": 1.0, "E": 30e12, "nu": 0.2}
#: A stiff plate of 4 m x 4 m, 400 kN, on springs.
PLATE: dict[str, Any] = {
    "plate": {"length_x": 4, "length_y": 4} | STIFF,
    "ground": {"kind": "winkler", "k": 10e6},
    "cases": [{"name": "G"}],
    "loads": [{"kind": "self weight", "unit_weight": 25e3, "case": "G"}],
    "combinations": [
        {"name": "char", "limit_state": "characteristic", "factors": {"G": 1.0}},
        {"name": "ULS", "factors": {"G": 1.35}},
    ],
    "mesh": {"size": 1.0},
}
#: Four springs that carry it all, as there is a wide gap above the ground.
CORNERS = [
    {"kind": "point", "name": f"S{n}", "x": x, "y": y, "stiffness": 50e6, "acts": "in compression"}
    for n, (x, y) in enumerate([(-1.5, -1.5), (1.5, -1.5), (-1.5, 1.5), (1.5, 1.5)], start=1)
]
PULL = {"kind": "point", "P": -200e3, "x": 1.5, "y": 0.0, "case": "G"}
#: Two such plates side by side, of which the first has 20 kPa more.
TWO: dict[str, Any] = {
    "plate": {"name": "A", "outline": {"kind": "rectangle", "x": (-4, 0), "y": (-2, 2)}} | STIFF,
    "plates": [{"name": "B", "outline": {"kind": "rectangle", "x": (0, 4), "y": (-2, 2)}} | STIFF],
    "loads": [
        {"kind": "self weight", "unit_weight": 25e3, "case": "G"},
        {"kind": "uniform", "q": 20e3, "plate": "A", "case": "G"},
    ],
}
WALL = {"kind": "line", "name": "wall", "points": [(0, -2), (0, 2)], "stiffness": 1e8}
PILE = {"kind": "pile", "x": 0.0, "y": 0.0, "length": 10.0, "diameter": 0.5}
CONTINUUM = {"ground": {"kind": "continuum", "half_space": {"E": 20e6, "nu": 0.3}}}
DESIGN = {"limit": 1e3, "limit_is": "design resistance"}
CHARACTERISTIC = {"limit": 1e3, "limit_is": "characteristic resistance", "gamma_R": 1.2}


def solved(**changes: Any) -> Results:
    """Return the results of the plate with some keys changed."""
    return solve(Model(**PLATE | changes))


def rows(name: str, of: Results) -> list[DesignCheck]:
    """Return the checks of a name."""
    return [each for each in check_design(of).checks if each.name == name]


def on_corners(**keys: Any) -> Results:
    """Return the plate on four springs alone, which have further keys."""
    return solved(supports=[each | keys for each in CORNERS], contact={"gap": 1.0})


def test_springs_below_their_limit() -> None:
    """Of 540 kN in the ultimate combination each of four carries 135 kN, 0.9 of its limit of 150 kN."""
    found = rows(model_limits.SUPPORT, on_corners(limit=150e3))
    assert sorted(each.of for each in found) == ["S1", "S2", "S3", "S4"]
    for check in found:
        assert (check.status, check.combination, check.unit) == ("no failure found", "ULS", "kN")
        assert (check.demand, check.resistance) == (pytest.approx(135), 150)
        assert check.words.endswith('is 0.9 times its ultimate resistance of 150 kN in "ULS"')


@pytest.mark.parametrize(("limit_is", "status"), [("ultimate resistance", "attention"), ("design resistance", "fails")])
def test_springs_at_their_limit(limit_is: str, status: str) -> None:
    """Of 400 and 540 kN four springs and the ground would carry 56 and 75 kN each: at 50 kN all four yield."""
    supports = [each | {"limit": 50e3, "limit_is": limit_is} for each in CORNERS]
    design = check_design(solved(supports=supports))
    found = [each for each in design.checks if each.name == model_limits.SUPPORT]
    assert [each.status for each in found] == [status] * 4
    assert [each.utilization for each in found] == pytest.approx([1.0] * 4)
    assert found[0].words == f'S1: 50 kN reaches its {limit_is} of 50 kN in "ULS", "char"'
    start = "FOUNDATION FAILS (4 of 4 checks fail): support" if status == "fails" else "DESIGN NEEDS ATTENTION: 4 of 4"
    assert design.headline.startswith(start)


def test_a_line_at_its_limit() -> None:
    """Along a line the force per length is compared: 20 kN/m on 4 m, in the table of supports as well."""
    wall = {"kind": "line", "name": "wall", "points": [(0, -2), (0, 2)], "stiffness": 1e9, "acts": "in compression"}
    of = solved(supports=[wall | {"limit": 20e3}])
    (check,) = rows(model_limits.SUPPORT, of)
    assert (check.status, check.unit, check.resistance) == ("attention", "kN/m", 20)
    assert of["ULS"].supports[0].total == pytest.approx(80e3)
    table = next(each for each in tables_of(of) if each.name == "supports")
    assert table["force over limit"] == pytest.approx((1.0, 1.0))
    assert (table["limit"], table["unit of the limit"]) == ((20.0, 20.0), ("kN/m", "kN/m"))
    assert table["stiffness alone"] == pytest.approx((4e3, 4e3))  # [MN/m]: 1 GN/m2 over 4 m


def on_piles(**keys: Any) -> Results:
    """Return the plate on two piles in a half-space, under 1.6 MN and 2.16 MN."""
    pile = {"kind": "pile", "length": 10.0, "diameter": 0.5, "y": 0.0} | keys
    ground = {"kind": "continuum", "half_space": {"E": 20e6, "nu": 0.3}}
    more = [*PLATE["loads"], {"kind": "uniform", "q": 75e3, "case": "G"}]
    return solved(
        supports=[pile | {"name": "P1", "x": -1.0}, pile | {"name": "P2", "x": 1.0}], ground=ground, loads=more
    )


@pytest.mark.parametrize(
    ("limit_is", "status", "clause"),
    [("ultimate resistance", "attention", ""), ("design resistance", "fails", "EN 1997-1 7.6.2.1, 7.6.3.1")],
)
def test_piles_at_their_limit(limit_is: str, status: str, clause: str) -> None:
    """Each pile has its row; in the table stand its limit, its settlement, and its stiffness in the soil by itself."""
    of = on_piles(limit=100e3, limit_is=limit_is)
    found = rows(model_limits.PILE, of)
    assert [(each.of, each.status, each.clause) for each in found] == [(name, status, clause) for name in ("P1", "P2")]
    assert found[0].words == f'P1: 100 kN reaches its {limit_is} of 100 kN in "ULS", "char"'
    table = next(each for each in tables_of(of) if each.name == "supports")
    alone = piles.Pile(10.0, 0.25, 30e9, 20e6 / 2.6, 0.3).head_stiffness
    assert table["stiffness alone"] == pytest.approx([alone / 1e6] * 4)
    w = np.array(table["greatest settlement"], dtype=float)
    assert table["force over settlement"] == pytest.approx(100 / w)


def test_a_pile_in_tension() -> None:
    """A pile that is pulled is held against its limit in tension, whatever it could carry in compression."""
    places = [(x, y) for x in (-1.0, 1.0) for y in (-1.0, 1.0)]
    limits = {"limit": 20e3, "limit_tension": 100e3}
    up = [{"kind": "uniform", "q": -10e3, "case": "G"}]
    of = solved(**CONTINUUM, loads=up, supports=[PILE | limits | {"x": x, "y": y} for x, y in places])
    found = rows(model_limits.PILE, of)
    assert {(each.status, each.combination, each.resistance) for each in found} == {("no failure found", "ULS", 100)}
    assert [each.demand for each in found] == pytest.approx([1.35 * 160 / 4] * 4)


@pytest.mark.parametrize(
    ("limit", "share", "status"), [(200e3, 135 * 1.2 / 200, "no failure found"), (150e3, 135 * 1.2 / 150, "fails")]
)
def test_a_characteristic_resistance(limit: float, share: float, status: str) -> None:
    """135 kN against R_k / 1.2, in the calculation, too; 100 kN in the characteristic combination against R_k."""
    of = on_corners(limit=limit, limit_is="characteristic resistance", gamma_R=1.2)
    found = rows(model_limits.SUPPORT, of)
    assert {(each.status, each.combination) for each in found} == {(status, "ULS")}
    assert [each.utilization for each in found] == pytest.approx([share] * 4)
    assert [each.resistance for each in found] == pytest.approx([limit / 1.2e3] * 4)
    assert f"kN, its characteristic resistance of {limit / 1e3:.4g} kN over 1.2, in " in found[0].words
    known = follow_steps(found[0].steps)
    assert (known["R_k"], known["eta"]) == pytest.approx((limit / 1e6, share))
    table = next(each for each in tables_of(of) if each.name == "supports")
    assert set(table["limit"]) == {limit / 1e3}  # that of the analysis
    alone = solved(
        supports=[each | {"limit": 150e3, "limit_is": "characteristic resistance", "gamma_R": 1.2} for each in CORNERS],
        contact={"gap": 1.0}, combinations=PLATE["combinations"][:1],
    )  # fmt: skip
    assert [each.utilization for each in rows(model_limits.SUPPORT, alone)] == pytest.approx([100 / 150] * 4)


@pytest.mark.parametrize(("state", "factor"), [("ultimate", 1.15), ("uplift", 1.4), ("characteristic", 1.0)])
def test_partial_factors_of_piles_in_tension(state: str, factor: float) -> None:
    """By Tables A.6 to A.8 and A.16 of EN 1997-1: 54 kN against 100 kN over the factor."""
    places = [(x, y) for x in (-1.0, 1.0) for y in (-1.0, 1.0)]
    keys = {"limit": 20e3, "limit_tension": 100e3, "limit_is": "characteristic resistance"}
    up = [{"kind": "uniform", "q": -10e3, "case": "G"}]
    made = [{"name": "C", "limit_state": state, "factors": {"G": 1.35}}]
    supports = [PILE | keys | {"x": x, "y": y} for x, y in places]
    found = rows(model_limits.PILE, solved(**CONTINUUM, loads=up, supports=supports, combinations=made))
    assert [each.demand for each in found] == pytest.approx([54] * 4)
    assert [each.resistance for each in found] == pytest.approx([100 / factor] * 4)


def test_piles_without_a_resistance() -> None:
    """They are not checked, and the headline says so; those that have one only the other way need attention."""
    design = check_design(on_piles())
    assert 'the resistance of "P1", "P2" in the ground is not checked, as they have no limit' in design.headline
    assert not rows(model_limits.WITHOUT, on_piles(limit=10e6))
    places = [(x, y) for x in (-1.0, 1.0) for y in (-1.0, 1.0)]
    up = [{"kind": "uniform", "q": -10e3, "case": "G"}]
    pulled = solved(**CONTINUUM, loads=up, supports=[PILE | {"limit": 20e3, "x": x, "y": y} for x, y in places])
    (check,) = rows(model_limits.WITHOUT, pulled)
    assert check.status == "attention"
    assert check.words.startswith('not judged: without a limit that way, support 1 54 kN in tension in "ULS"; ')


def test_partial_factors_go_with_characteristic_resistances() -> None:
    """A support's must be given, a pile's have defaults; without such a resistance they are errors."""
    characteristic = {"limit": 1e3, "limit_is": "characteristic resistance"}
    with pytest.raises(InputError, match=r"gamma_R: found nothing"):
        Model(**PLATE | {"supports": [CORNERS[0] | characteristic]})
    with pytest.raises(InputError, match=r"gamma_R: found a partial factor"):
        Model(**PLATE | {"supports": [CORNERS[0] | {"limit": 1e3, "gamma_R": 1.2}]})
    with pytest.raises(InputError, match=r"gamma_R_tension: found a partial factor"):
        Model(**PLATE | CONTINUUM | {"supports": [PILE | {"limit": 1e3, "gamma_R_tension": 1.2}]})
    pile = Model(**PLATE | CONTINUUM | {"supports": [PILE | characteristic]}).supports[0]
    assert (pile.gamma_R, pile.gamma_R_tension) == (1.1, 1.15)


def test_a_support_that_lifts_off() -> None:
    """A plate that is pulled off a support needs attention; an anchor that is slack does not."""
    support = {"kind": "point", "name": "S", "x": 1.9, "y": 0, "stiffness": 1e8}
    (check,) = rows(
        model_limits.ONE_SIDED, solved(supports=[support | {"acts": "in compression"}], loads=[*PLATE["loads"], PULL])
    )
    assert (check.status, check.of) == ("attention", "S")
    assert check.words == 'S: the plate lifts off in "ULS", "char"'
    (check,) = rows(model_limits.ONE_SIDED, solved(supports=[support | {"acts": "in tension"}]))
    assert (check.status, check.words) == ("no failure found", 'S: it is slack in "ULS", "char"')
    (check,) = rows(model_limits.ONE_SIDED, solved(supports=[support | {"acts": "in compression", "gap": 1.0}]))
    assert (check.status, check.words) == ("no failure found", 'S: its gap does not close in "ULS", "char"')
    assert rows(model_limits.ONE_SIDED, solved(supports=[support | {"acts": "in compression"}])) == []


def test_a_line_that_lifts_off_in_part() -> None:
    """Of a line the share of its length is told that carries nothing; it is that of the results."""
    wall = {"kind": "line", "name": "wall", "points": [(-2, 0), (2, 0)], "stiffness": 1e8, "acts": "in compression"}
    of = solved(supports=[wall], loads=[*PLATE["loads"], PULL])
    (check,) = rows(model_limits.ONE_SIDED, of)
    support = of["ULS"].supports[0]
    share = support.length[support.settlement < 0].sum() / 4
    assert 0.1 < share < 0.9
    assert f"the plate lifts off over {100 * share:.3g} % of its length in " in check.words


@pytest.mark.parametrize(("gap", "words"), [(1.0, "does not close"), (1e-4, "closes over 100 % of its length")])
def test_play_of_a_joint(gap: float, words: str) -> None:
    """Two stiff plates on springs settle by 1.35 times 45 and 25 kPa over 10 MPa/m, 2.7 mm apart, unless joined."""
    joint = {"kind": "elastic", "between": ("A", "B"), "stiffness": 1e5, "gap": gap}
    (check,) = rows(model_limits.PLAY, solved(**TWO, joints=[joint]))
    assert (check.status, check.of, check.combination) == ("no failure found", "A - B", "ULS")
    assert words in check.words
    if gap == 1.0:
        assert "the largest step is 2.7 mm" in check.words


def test_ground_at_its_limit_pressure() -> None:
    """A stiff strip under an eccentric force: the share that yields is that of a line p = min(k (a + b x), p_max)."""
    V, e, k, most = 400e3, 0.5, 10e6, 35e3
    x = (np.arange(20_000) + 0.5) / 5_000 - 2.0
    load = {"kind": "point", "P": V, "x": e, "y": 0, "case": "G"}

    def unbalanced(at: np.ndarray) -> list[float]:
        p = np.clip(k * (at[0] + at[1] * x), 0.0, most)
        return [4 * 4 * p.mean() - V, 4 * 4 * (p * x).mean() - V * e]

    a, b = fsolve(unbalanced, [2.5e-3, 1e-3])
    share = float((k * (a + b * x) >= most).mean())
    assert 0.2 < share < 0.8
    of = solved(loads=[load], combinations=PLATE["combinations"][:1], contact={"limit_pressure": most},
                mesh={"size": 0.25})  # fmt: skip
    (check,) = rows(model_limits.GROUND, of)
    assert (check.status, check.demand, check.resistance) == ("attention", 35, 35)
    told = re.search(r"yields at 35 kPa under ([\d.]+) % of the plate's area", check.words)
    assert told is not None
    assert float(told[1]) / 100 == pytest.approx(share, abs=0.125 / 4)  # half an element's length
    values = follow_steps(check.steps)
    assert (values["A"], values["a_y"]) == pytest.approx((16.0, float(told[1])), rel=1e-2)
    assert values["eta"] == 1.0
    (check,) = rows(model_limits.GROUND, solved(contact={"limit_pressure": 100e3}))
    assert (check.status, check.demand) == ("no failure found", pytest.approx(1.35 * 25))
    assert follow_steps(check.steps)["eta"] == pytest.approx(0.3375)


def test_loads_cut_off() -> None:
    """Half of a patch lies beside the plate: 16 kN of 32 kN do not act."""
    patch = {"kind": "patch", "name": "rack", "q": 4e3, "x": (0, 4), "y": (-1, 1), "case": "G"}
    (check,) = rows(model_limits.CUT_OFF, solved(loads=[*PLATE["loads"], patch]))
    assert check.status == "attention"
    assert check.words == 'loads[2] "rack": 50 % of it lies off the plate; 16 kN of 32 kN do not act'


def test_cut_off_loads_are_told_where_nothing_was_solved() -> None:
    """A foundation that fails because its weight was drawn beside it says so."""
    patch = {"kind": "patch", "q": -60e3, "x": (-2, 4), "y": (-2, 2), "case": "G"}
    of = solve_combinations(Model(**PLATE | {"loads": [*PLATE["loads"], patch]}))
    assert not of.results
    assert [each.name for each in check_design(of).checks] == ["static equilibrium"] * 2 + [model_limits.CUT_OFF]


def test_limit_is_needs_a_limit() -> None:
    """A word about a limit that is not there is an error, as is another word."""
    with pytest.raises(InputError, match="limit_is without a limit"):
        Model(**PLATE | {"supports": [CORNERS[0] | {"limit_is": "design resistance"}]})
    with pytest.raises(InputError, match="design resistance"):
        Model(**PLATE | {"supports": [CORNERS[0] | {"limit": 1e3, "limit_is": "design"}]})


#: By class and key a model that has a limit there, and the check that tells of it.
MODELS: dict[str, tuple[str, dict[str, Any]]] = {
    "PointSupport.limit": (model_limits.SUPPORT, {"supports": [CORNERS[0] | {"limit": 1e3}]}),
    "PointSupport.limit_is": (model_limits.SUPPORT, {"supports": [CORNERS[0] | DESIGN]}),
    "PointSupport.acts": (model_limits.ONE_SIDED, {"supports": [CORNERS[0] | {"acts": "in tension"}]}),
    "PointSupport.gap": (model_limits.ONE_SIDED, {"supports": [CORNERS[0] | {"gap": 1.0}]}),
    "PointSupport.gamma_R": (model_limits.SUPPORT, {"supports": [CORNERS[0] | CHARACTERISTIC]}),
    "LineSupport.gamma_R": (model_limits.SUPPORT, {"supports": [WALL | {"acts": "in compression"} | CHARACTERISTIC]}),
    "Pile.gamma_R": (model_limits.PILE, CONTINUUM | {"supports": [PILE | CHARACTERISTIC]}),
    "Pile.gamma_R_tension": (
        model_limits.PILE,
        CONTINUUM | {"supports": [PILE | CHARACTERISTIC | {"limit_tension": 1e3, "gamma_R_tension": 1.2}]},
    ),
    "LineSupport.limit": (model_limits.SUPPORT, {"supports": [WALL | {"acts": "in compression", "limit": 1e3}]}),
    "LineSupport.limit_is": (model_limits.SUPPORT, {"supports": [WALL | {"acts": "in compression"} | DESIGN]}),
    "LineSupport.acts": (model_limits.ONE_SIDED, {"supports": [WALL | {"acts": "in tension"}]}),
    "LineSupport.gap": (model_limits.ONE_SIDED, {"supports": [WALL | {"acts": "in compression", "gap": 1.0}]}),
    "Pile.limit": (model_limits.PILE, CONTINUUM | {"supports": [PILE | {"limit": 1e3}]}),
    "Pile.limit_is": (model_limits.PILE, CONTINUUM | {"supports": [PILE | DESIGN]}),
    "Pile.limit_tension": (model_limits.PILE, CONTINUUM | {"supports": [PILE | {"limit_tension": 100e3}]}),
    "ElasticJoint.gap": (
        model_limits.PLAY,
        TWO | {"joints": [{"kind": "elastic", "between": ("A", "B"), "stiffness": 1e8, "gap": 1e-3}]},
    ),
    "Contact.limit_pressure": (model_limits.GROUND, {"contact": {"limit_pressure": 100e3}}),
}
#: Keys that sound like a limit and are none of what acts in the analysis, or are told elsewhere.
ELSEWHERE = {
    "Contact.tensionless": "the area in contact, in every summary, and limits.contact_share",
    "Contact.gap": "a shape of the ground; where it stays open the area in contact says so",
    "Contact.gaps": "the same",
    "GapPoint.gap": "the same",
    "Model.limits": "the checks of limits",
    "Limits.settlement": "the checks of limits",
    "Limits.uplift": "the checks of limits",
    "Limits.differential_settlement": "the checks of limits",
    "Limits.pressure": "the checks of limits",
    "Beam.torsion": "the check of webs; released torsion is left to compatibility",
    "Mesh.max_unknowns": "the words on a mesh that is too coarse",
    "Reinforcement.w_max": "the check of crack widths",
    "Reinforcement.f_yk": "a strength, of which the checks of bars are made",
    "TR34Floor.f_yk": "the same",
    "HingeJoint.dowels": "the checks of dowels",
    "ElasticJoint.dowels": "the checks of dowels",
    "Reinforcement.aggregate": "a size, of which the check of the bars' clear distance is made",
    "Combine.permanent": "a factor",
    "Combine.variable": "a factor",
    "Combine.uplift": "a factor",
    "Plate.edges": "edges act both ways",
    "Edges.right": "a place",
    "Edges.top": "a place",
    "Model.soil_strength": "the checks of bearing resistance and sliding",
    "SoilStrength.phi": "the same",
    "SoilStrength.gamma_Rv": "the same",
    "SoilStrength.gamma_Rh": "the same",
    "TR34Floor.kind": "the checks of floors",
    "ACI360Floor.R_e3": "the checks of floors",
    "SoilLayer.sublayers": "of the mesh",
    "ConstrainedModulus.limit_ratio": "where the ground ends",
    "Combination.limit_state": "a limit state",
    "Cracking.limit_states": "a limit state",
    "LongTerm.limit_states": "a limit state",
    "Combine.sets": "a limit state",
    "Mesh.size": "of the mesh",
    "Mesh.accuracy": "of the mesh",
    "Refinement.size": "of the mesh",
    "Analysis.max_iterations": "of the program",
    "Output.wall_limits": "of what is told beside",
}
NAMES = re.compile(r"limit|gap|acts|play|tensionless|resist|capacity|_max|max_")
MEANINGS = re.compile(r"\blimit|yield|largest|at most|\bonly\b|\bplay\b|lift|resistance|capacity")


def sections(of: type[Section], known: set[type[Section]]) -> Iterator[type[Section]]:
    """Yield a section and all within it, each once."""
    if of not in known:
        known.add(of)
        yield of
        for field in of.model_fields.values():
            for part in field.sections.parts:
                yield from sections(part, known)


def keys_like_limits() -> Iterator[str]:
    """Yield class and key of all fields of the model whose name or meaning speaks of a limit."""
    for section in sections(Model, set()):
        for name, field in section.model_fields.items():
            if NAMES.search(name) or MEANINGS.search(field.meaning):
                yield f"{section.__name__}.{name}"


def test_no_limit_of_the_model_is_forgotten() -> None:
    """Every key that speaks of a limit is told by a check of this file, or named here with the reason why not."""
    assert set(keys_like_limits()) - ELSEWHERE.keys() == MODELS.keys()


@pytest.mark.parametrize("key", MODELS)
def test_every_limit_has_a_row(key: str) -> None:
    """A model with that limit has a row that tells of it."""
    name, changes = MODELS[key]
    found = rows(name, solved(**changes))
    assert found
    assert all(each.words for each in found)
