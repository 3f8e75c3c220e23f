"""Links against one-way shear in parts of a slab: what they carry, how far apart they may be, and where they stand."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from shapely import box, union_all

import groundslab as gs
from groundslab.design.checks import DesignCheck, check_design
from groundslab.design.checks.one_way_shear.shear import checks as shear_checks
from groundslab.design.codes.registry import code_of
from groundslab.design.rules.shear_demand import ShearDemand
from groundslab.errors import InputError
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.model import Model
from groundslab.model.plate import Zone
from groundslab.views.tables.result_tables import tables_of
from helpers.calculations import follow, follow_steps
from helpers.solve_once import solve_once

H, AXIS, L, W = 0.4, 0.05, 8.0, 6.0
D = H - AXIS
LAYERS = ("bottom_x", "bottom_y", "top_x", "top_y")
LAID: dict[str, Any] = {
    "f_ck": 30e6, "f_yk": 500e6, "bottom": (AXIS, AXIS), "top": (AXIS, AXIS),
    **{layer: {"diameter": 0.016, "spacing": 0.1} for layer in LAYERS},
}  # fmt: skip
GERMANY, ACI = LAID | {"annex": "Germany"}, LAID | {"code": "ACI 318", "f_yk": 420e6}
SECOND = LAID | {"code": "EN 1992-1-1:2023"}
#: Under a line load along y on x = 0 the slab shears on both sides.
AREA = {"kind": "rectangle", "x": (-1.6, 1.6), "y": (-3.0, 3.0)}
GIVEN = {"name": "middle", "shape": AREA, "diameter": 0.008, "spacing_x": 0.2, "spacing_y": 0.2}


def slab(steel: dict[str, Any], q: float = 560e3, h: float = H) -> Model:
    """Return a slab under a line load from edge to edge, which bends and shears it along x alone."""
    return Model(
        plate={"length_x": L, "length_y": W, "thickness": h, "E": 33e9, "nu": 0.0},
        ground={"kind": "winkler", "k": 25e6},
        cases=[{"name": "G"}],
        loads=[{"kind": "line", "case": "G", "q": q, "points": [(0.0, -W / 2), (0.0, W / 2)]}],
        combinations=[{"name": "U", "factors": {"G": 1.35}, "limit_state": "ultimate"}],
        reinforcement=steel,
        mesh={"size": 0.5},
    )


def check(model: Model) -> DesignCheck:
    """Return the check of one-way shear."""
    return next(each for each in shear_checks(solve_once(model)) if each.name == "one-way shear")


def with_links(steel: dict[str, Any], *links: dict[str, Any]) -> dict[str, Any]:
    """Return a reinforcement with links in the middle of the slab, some of their keys changed."""
    return steel | {"shear_links": [GIVEN | changes for changes in links or ({},)]}


def test_links_by_hand() -> None:
    """Against v / (z f_ywd cot theta) with cot theta = 2.5, v at d from the line."""
    without, found = check(slab(LAID)), check(slab(with_links(LAID)))
    assert without.status == "attention"
    assert without.demand is not None
    needed = without.demand * 1e3 / (0.9 * D * 500e6 / 1.15 * 2.5)
    least = 0.08 * math.sqrt(30) / 500
    assert found.demand == pytest.approx(1e4 * max(needed, least), rel=0.01)
    assert found.resistance == pytest.approx(1e4 * math.pi * 0.004**2 / 0.2**2)
    assert (found.status, found.of) == ("no failure found", "middle")
    table = next(each for each in tables_of(solve_once(slab(with_links(LAID)))) if each.name == "calculations")
    symbols = dict(zip(table["symbol"], table["value"], strict=True))
    assert symbols["a_prov"] == pytest.approx(found.resistance)
    follow(table)


@pytest.mark.parametrize(
    ("changes", "what"),
    [
        ({"diameter": 0.006, "spacing_x": 0.26, "spacing_y": 0.26}, "links"),
        ({"diameter": 0.016, "spacing_y": 0.27}, "distance of legs 270"),
        ({"shape": AREA | {"x": (-0.3, 0.3)}}, "links of"),
    ],
)
def test_links_that_are_not_enough(changes: dict[str, Any], what: str) -> None:
    """Too few fail, and those too far apart (0.75 d = 262 mm); beside links the slab still needs some."""
    found = check(slab(with_links(LAID, changes)))
    assert found.status == ("attention" if "shape" in changes else "fails")
    assert what in found.words


@pytest.mark.parametrize("steel", [LAID, GERMANY, ACI], ids=["EN", "Germany", "ACI"])
def test_links_close_the_check(steel: dict[str, Any]) -> None:
    """By each code what needs links is no failure with enough of them near enough."""
    assert check(slab(steel)).status == "attention"
    near = with_links(steel, {"spacing_x": 0.125, "spacing_y": 0.125})
    assert check(slab(near)).status == "no failure found"


def test_the_second_generation_needs_attention() -> None:
    """Its distances were read nowhere."""
    found = check(slab(with_links(SECOND, {"shape": AREA | {"x": (-3.5, 3.5)}, "spacing_y": 0.1}), q=1000e3))
    assert found.status == "attention"
    assert "not known" in found.words


def test_thin_slabs_have_none() -> None:
    """Less than 200 mm (9.3.2(1)) links help nothing."""
    found = check(slab(with_links(LAID, {"spacing_x": 0.1, "spacing_y": 0.1}), q=250e3, h=0.19))
    assert found.status == "fails"
    assert "too thin" in found.words


def test_thin_parts_are_not_hidden_by_thick_ones() -> None:
    """Where the slab is too thin for links on one side, that side counts, however much more the other one bears."""
    thin = {"thickness": 0.19, "shape": {"kind": "rectangle", "x": (1.8, 4.0), "y": (-3.0, 3.0)}}
    wide = AREA | {"x": (-3.9, 3.9)}
    steel = with_links(LAID, {"shape": wide, "spacing_x": 0.1, "spacing_y": 0.1})
    model = slab(steel, q=1000e3)
    model = model.replace(plate=model.plate.model_copy(update={"zones": (Zone.model_validate(thin),)}))
    found = check(model)
    assert found.status == "fails"
    assert "too thin" in found.words


def test_what_fails_stands_before_what_needs_attention() -> None:
    """Links too few on one side, hardly too few, fail; none on the other one, much needed, is still attention."""
    few = {"shape": AREA | {"x": (0.0, 3.9)}, "diameter": 0.006}
    model = slab(with_links(LAID, few))
    found, beside = check(model), check(slab(LAID))
    assert found.utilization is not None
    assert beside.utilization is not None
    assert found.utilization < beside.utilization
    assert (found.status, beside.status) == ("fails", "attention")
    assert found.of == "middle"


def test_thin_parts_that_need_links_stand_before_thick_ones() -> None:
    """Without any links, too: what is too thin for links fails, whatever a thicker part uses."""
    thin = {"thickness": 0.19, "shape": {"kind": "rectangle", "x": (1.8, 4.0), "y": (-3.0, 3.0)}}
    model = slab(LAID, q=1000e3)
    model = model.replace(plate=model.plate.model_copy(update={"zones": (Zone.model_validate(thin),)}))
    found, thick = check(model), check(slab(LAID, q=1000e3))
    assert (found.status, thick.status) == ("fails", "attention")
    assert "too thin" in found.words


def test_struts_that_fail_are_no_question_of_links() -> None:
    """As many as one likes do not help."""
    found = check(slab(with_links(LAID, {"spacing_x": 0.05, "spacing_y": 0.05, "diameter": 0.02}), q=6000e3))
    assert found.status == "fails"
    assert "do not suffice" in found.words


def test_what_governs_is_the_worst_of_all() -> None:
    """Links on one side alone leave the other one."""
    right = with_links(LAID, {"shape": AREA | {"x": (0.0, 1.6)}})
    found = check(slab(right))
    assert found.status == "attention"
    assert found.place is not None
    assert found.place[0] < 0


def test_distances_of_links_in_slabs() -> None:
    """EN 9.3.2(4), its German rule by V / V_Rd,max, ACI 318-19 Table 9.7.6.2.2."""
    results = solve_once(slab(LAID))["U"]

    def allowed(code: dict[str, Any], v: float) -> float:
        steel = Reinforcement.model_validate(code)
        rule = code_of(steel).shear
        assert rule is not None
        assert rule.link_distance is not None
        return rule.link_distance(steel, ShearDemand(results, (0.0, 0.0), v, v / 2, D, H)).value

    assert allowed(LAID, 300e3) == pytest.approx(0.75 * D)
    strut = 0.75 * 0.85 * 30e6 / 1.5
    z = min(0.9 * D, max(D - 2 * 0.042, D - 0.042 - 0.03))
    most = z * strut / 2
    assert allowed(GERMANY, 0.29 * most) == pytest.approx(0.7 * H)
    assert allowed(GERMANY, 0.5 * most) == pytest.approx(0.5 * H)
    assert allowed(GERMANY, 0.7 * most) == pytest.approx(0.25 * H)
    assert allowed(ACI, 300e3) == pytest.approx(D / 2)
    assert allowed(ACI, 0.75 * (0.17 + 0.34) * math.sqrt(30) * 1e6 * D) == pytest.approx(D / 4)


def test_links_are_named_once_and_on_the_slab() -> None:
    """Two of one name, and some beside the plate."""
    with pytest.raises(InputError) as refused:
        slab(with_links(LAID, {}, {"shape": AREA | {"x": (10.0, 12.0)}}))
    assert "reinforcement.shear_links[2]" in str(refused.value)
    with pytest.raises(InputError) as refused:
        slab(with_links(LAID, {"name": "far", "shape": AREA | {"x": (10.0, 12.0)}}))
    assert "a part of it" in str(refused.value)


def test_the_design_says_so() -> None:
    """As one of all checks, with its error."""
    found = {each.name: each for each in check_design(solve_once(slab(with_links(LAID)))).checks}["one-way shear"]
    assert found.utilization is not None
    assert found.utilization < 1
    assert np.isfinite(found.utilization)


@pytest.mark.parametrize("steel", [LAID, ACI], ids=["EN", "ACI"])
def test_what_is_proposed_is_enough(steel: dict[str, Any]) -> None:
    """Rectangles of links that propose_bars writes close the check, and none lies over another."""
    asked = {key: value for key, value in steel.items() if key not in LAYERS}
    proposal = gs.propose_bars(solve_once(slab(asked)))
    links = proposal.reinforcement.shear_links
    found = check(proposal.model)
    assert links
    assert found.status == "no failure found"
    assert found.unit == "cm2/m2" or found.unit == "mm"
    shapes = [box(*(each.shape.ring().bounds[side] for side in (0, 2, 1, 3))) for each in links]
    assert union_all(shapes).area == pytest.approx(sum(shape.area for shape in shapes))


def test_nothing_is_proposed_where_nothing_is_needed() -> None:
    """Concrete alone bears it."""
    asked = {key: value for key, value in LAID.items() if key not in LAYERS}
    assert gs.propose_bars(solve_once(slab(asked, q=150e3))).reinforcement.shear_links == ()


@pytest.mark.parametrize("code", [LAID, GERMANY, ACI], ids=["EN", "Germany", "ACI"])
def test_distances_that_are_given_have_a_sheet(code: dict[str, Any]) -> None:
    """The largest distance of legs with its formula, and the share of it that is used."""
    found = check(slab(with_links(code)))
    values = follow_steps(found.steps)
    assert values["s_w"] / values["s_max"] == pytest.approx(values["eta_s"])
    assert found.utilization == pytest.approx(max(values["eta_w"], values["eta_s"]))
