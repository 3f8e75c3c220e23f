"""Meshes that are refined until errors are within the accuracy asked for."""

from __future__ import annotations

import dataclasses
from collections.abc import Collection
from typing import Any

import numpy as np
import pytest

from groundslab import InputError, Model, solve
from groundslab.accuracy.judgment import JudgedValue, judge
from groundslab.accuracy.singularities import find_limits
from groundslab.analysis import adaptivity, driver, mesh_hierarchy, nested
from groundslab.analysis.driver import Variants, analyze
from groundslab.analysis.tasks.run import Report, Setting
from groundslab.discretize.plan.local_sizes import local_sizes
from groundslab.discretize.plan_layout import Meshes
from groundslab.fem.shape_functions import areas
from groundslab.model.consistency import usual_size
from groundslab.model.remarks.singular_places import near_singular, singular_places
from groundslab.results.plate_result import PlateResult
from groundslab.results.records import Step
from groundslab.results.results import CombinationResult, Results
from groundslab.views.summary.discretization import coarse_words, round_up

LEGS: list[dict[str, Any]] = [
    {"kind": "point", "P": 45e3, "x": x, "y": y, "width_x": 0.15, "width_y": 0.15}
    for x, y in ((-2.0, -1.1), (1.3, 0.4), (3.1, -1.7))
]


def slab(mesh: dict[str, Any], **parts: Any) -> Model:
    """Return a floor of 10 x 6 m, 200 mm thick, under three rack legs."""
    parts = {"loads": LEGS, "contact": {"tensionless": False}} | parts
    plate = {"length_x": 10.0, "length_y": 6.0, "thickness": 0.2, "E": 30e9, "nu": 0.2}
    return Model.model_validate({"plate": plate, "ground": {"kind": "winkler", "k": 50e6}, "mesh": mesh, **parts})


def sides(results: CombinationResult) -> np.ndarray:
    """Return the sides of the plate's elements [m]."""
    found: np.ndarray = np.sqrt(areas(results.plate.nodes[results.plate.elements]))
    return found


def plate_at(places: np.ndarray, **fields: Any) -> PlateResult:
    """Return a plate of which nothing is known but nodes, whether they touch, and what is given."""
    zero = np.zeros(len(places))
    known = {each.name: zero for each in dataclasses.fields(PlateResult)} | {"nodes": places, "in_contact": zero == 0}
    return PlateResult(**known | {name: np.array(values) for name, values in fields.items()})


def near(results: CombinationResult, x: float, y: float, reach: float) -> np.ndarray:
    """Return which elements have their center within a reach of a place [m]."""
    middle = results.plate.nodes[results.plate.elements[:, 8]]
    found: np.ndarray = np.hypot(middle[:, 0] - x, middle[:, 1] - y) <= reach
    return found


@pytest.mark.slow
def test_errors_are_within_the_accuracy_at_few_unknowns() -> None:
    """Moments and shear forces within 3 % of those of much smaller elements; as few are needed as judged."""
    results = solve(slab({"accuracy": 0.03}))
    found = results.only
    assert judge(found)[0].share <= 0.03
    assert coarse_words(results) == ""
    parts = [
        {"shape": {"kind": "circle", "centre": (load["x"], load["y"]), "radius": 0.3}, "size": 0.025} for load in LEGS
    ]
    truth = solve(slab({"size": 0.15, "refine": parts})).only
    for name in ("moment_x", "moment_y", "shear_x", "settlement"):
        own, exact = (np.abs(getattr(each.plate, name)).max() for each in (found, truth))
        assert own == pytest.approx(exact, rel=0.03)
    at_leg, away = near(found, 1.3, 0.4, 0.3), near(found, -4.0, 2.0, 0.6)
    assert np.median(sides(found)[at_leg]) < np.median(sides(found)[away]) / 3


def test_a_size_is_not_changed() -> None:
    """With a size, an accuracy is what the warning is about."""
    results = solve(slab({"size": 0.1, "accuracy": 0.01}))
    assert len(results.plate.elements) == 100 * 60
    assert "1 %" in coarse_words(results)
    assert "mesh.accuracy" in coarse_words(results)


def test_bounds_are_told() -> None:
    """A mesh that may have no more unknowns is not refined, and the verdict says so, and what the next one takes."""
    results = solve(slab({"accuracy": 0.001, "max_unknowns": 1000}))
    history = results.only.mesh_history
    assert history is not None
    assert history.needed is not None
    assert (history.unknowns, history.end) == ((results.only.unknowns,), "max_unknowns")
    assert not results.provisional
    assert "because of mesh.max_unknowns = 1000" in coarse_words(results)
    assert f"takes mesh.max_unknowns = {round_up(history.needed)}." in coarse_words(results)


@pytest.mark.slow
def test_what_the_next_mesh_takes_is_enough() -> None:
    """With as many unknowns as one bound was said to lack, one mesh more is made, with about so many and no more."""
    few = solve(slab({"accuracy": 0.001, "max_unknowns": 1000})).only.mesh_history
    assert few is not None
    assert few.needed is not None
    more = solve(slab({"accuracy": 0.001, "max_unknowns": round_up(few.needed)})).only.mesh_history
    assert more is not None
    assert more.unknowns[0] == few.unknowns[0]
    assert len(more.unknowns) == 2
    assert few.needed / 2 < more.unknowns[1] < 1.5 * few.needed


@pytest.mark.parametrize(("count", "rounded"), [(7, 7), (95, 95), (101, 110), (110, 110), (123_456, 130_000)])
def test_counts_are_rounded_up(count: int, rounded: int) -> None:
    """To two digits."""
    assert round_up(count) == rounded


@pytest.mark.slow
def test_errors_that_fall_no_more_are_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    """An error that stays as it is costs two further meshes, not all; the verdict says so."""
    stuck = adaptivity.judge(solve(slab({"size": 0.5})).only)[0]
    meshes = []

    def judged(results: CombinationResult) -> list[object]:
        meshes.append(len(results.plate.elements))
        return [stuck]

    monkeypatch.setattr(adaptivity, "judge", judged)
    results = solve(slab({"accuracy": 0.01}))
    history = results.only.mesh_history
    assert history is not None
    assert (len(history.unknowns), history.end) == (3, "no progress")
    assert stuck.share > 0.01
    assert len(set(meshes)) == 3


@pytest.mark.slow
def test_an_error_that_was_small_before_is_not_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    """What smaller elements elsewhere have made too large on the third mesh gets a fourth one."""
    first = adaptivity.judge(solve(slab({"size": 0.5})).only)[0]
    shares = iter([0.05, 0.005, 0.05, 0.005])

    def judged(_: CombinationResult) -> list[JudgedValue]:
        other = dataclasses.replace(first, label="other", share=0.02 if len(made) < 2 else 0.005)
        made.append(next(shares))
        return [dataclasses.replace(first, share=made[-1]), other]

    made: list[float] = []
    monkeypatch.setattr(adaptivity, "judge", judged)
    history = solve(slab({"accuracy": 0.01})).only.mesh_history
    assert history is not None
    assert (len(history.unknowns), history.end) == (4, "accurate")


@pytest.mark.parametrize(
    ("sides", "size"), [((12.0, 12.0), 1.0), ((6.0, 12.0), 0.5), ((10.0, 1.2), 0.024**0.5), ((100.0, 0.5), 0.5 / 6)]
)
def test_long_strips_have_fewer_elements_across(sides: tuple[float, float], size: float) -> None:
    """Twelve on the shorter side, fewer where these would be more than 500 in all, six at least."""
    assert usual_size(sides) == pytest.approx(size, rel=1e-12)
    assert usual_size(sides[::-1]) == usual_size(sides)


@pytest.mark.slow
def test_combinations_and_variants_share_the_mesh() -> None:
    """What one combination needs the others have, too; so have variants of a study."""
    cases = {"cases": [{"name": "left"}, {"name": "right"}]}
    loads = [LEGS[0] | {"case": "left"}, LEGS[2] | {"case": "right"}]
    model = slab({"accuracy": 0.015}, **cases, loads=loads)
    variants = Variants(model)
    one, other = variants.base.values()
    assert one.plate.nodes is other.plate.nodes or (one.plate.nodes == other.plate.nodes).all()
    for x, y in ((-2.0, -1.1), (3.1, -1.7)):
        assert sides(one)[near(one, x, y, 0.2)].max() < 0.16
    stiffer = variants.solve_combinations(model.replace(ground=model.ground.replace(k=80e6)))
    assert (stiffer["left"].plate.nodes == one.plate.nodes).all()


@pytest.mark.slow
def test_parts_with_smaller_elements() -> None:
    """Elements are as small as asked for in the part, and larger elsewhere."""
    part = {"shape": {"kind": "rectangle", "x": (1.0, 2.0), "y": (-1.0, 0.0)}, "size": 0.1}
    found = solve(slab({"size": 1.0, "refine": [part]})).only
    assert sides(found)[near(found, 1.5, -0.5, 0.5)].max() < 0.13
    assert np.median(sides(found)[near(found, 1.5, -0.5, 0.5)]) <= 0.1
    assert sides(found).max() > 0.4
    assert sides(found).max() <= 1.0 + 1e-9


@pytest.mark.slow
def test_few_combinations_are_solved_on_meshes_between_and_all_on_the_last(monkeypatch: pytest.MonkeyPatch) -> None:
    """Legs at three places, twice with less load: what governs makes the meshes; then all are as solved at once."""
    parts = {"a": {"a": 1.0}, "half of a": {"a": 0.5}, "b": {"b": 1.0}, "half of b": {"b": 0.5}, "c": {"c": 1.0}}
    combinations = [{"name": name, "factors": factors} for name, factors in parts.items()]
    loads = [leg | {"case": name} for leg, name in zip(LEGS, "abc", strict=True)]
    cases = [{"name": name} for name in "abc"]
    contact = {"tensionless": True}
    model = slab({"accuracy": 0.03}, cases=cases, combinations=combinations, loads=loads, contact=contact)
    runs: list[tuple[Setting, set[str]]] = []

    def analyzed(model: Model, setting: Setting, report: Report, names: Collection[str]) -> Results:
        known = {*results_before(setting)}
        results = analyze(model, setting, report, names)
        runs.append((setting, {*results} - known))
        return results

    def results_before(setting: Setting) -> list[str]:
        return [name for earlier, names in runs if earlier is setting for name in names]

    monkeypatch.setattr(driver, "analyze", analyzed)
    shown: list[Results] = []
    found = solve(model, on_mesh=shown.append)
    assert [*found] == [*parts]
    assert [[*each] for each in shown] == [[*parts]], "meshes on which few are solved are not handed over"
    (first, every), (_, few), *between, (last, rest) = runs
    assert every == {*parts}
    assert few < every
    assert {name for name in few if "half" in name} == set()
    assert few | rest == every
    assert not few & rest
    assert between
    assert all(names == few for _, names in between)
    assert last is runs[-2][0], "on the same mesh"
    assert first is not last

    at_once = analyze(model, Setting(last.model, Meshes(local=last.meshes.local)), lambda _: None)
    for name, own in found.items():
        for field in ("settlement", "moment_x", "shear_y", "pressure"):
            values = getattr(at_once[name].plate, field)
            np.testing.assert_allclose(getattr(own.plate, field), values, rtol=0, atol=1e-8 * np.abs(values).max())
        assert [each.label for each in judge(own)] == [each.label for each in judge(at_once[name])]
        assert judge(own)[0].share == pytest.approx(judge(at_once[name])[0].share, rel=1e-6)


#: A slab whose corners lift off, under each of its legs alone, by the names of the cases.
LIFTING: dict[str, Any] = {
    "cases": [{"name": name} for name in "abc"],
    "loads": [leg | {"case": name, "width_x": 0.4, "width_y": 0.4} for leg, name in zip(LEGS, "abc", strict=True)],
    "contact": {"tensionless": True},
}


@dataclasses.dataclass
class Watched:
    """Results, with those on the meshes before, and the steps on the way."""

    results: Results
    shown: list[Results]
    steps: list[Step]


@pytest.fixture(scope="module")
def lifting() -> Watched:
    """Return the slab whose corners lift off, solved for an accuracy of 5 %."""
    shown: list[Results] = []
    steps: list[Step] = []
    return Watched(solve(slab({"accuracy": 0.05}, **LIFTING), steps.append, on_mesh=shown.append), shown, steps)


@pytest.mark.slow
def test_several_combinations_are_shown_on_a_coarse_mesh_first(lifting: Watched) -> None:
    """All of them, without errors, which say so; values are near the last ones. One alone needs no such mesh."""
    found, draft = lifting.results, lifting.shown[0]
    assert [*draft] == [*found] == ["a", "b", "c"]
    assert draft.provisional
    assert coarse_words(draft).endswith(" is still to be refined; its errors come then.")
    for name, own in draft.items():
        assert own.comparison is None
        assert judge(own) == []
        history = found[name].mesh_history or pytest.fail("no history")
        assert history.unknowns[0] == own.unknowns < history.unknowns[1]
        assert own.plate.settlement.max() == pytest.approx(found[name].plate.settlement.max(), rel=0.02)
        assert own.plate.moment_x.max() == pytest.approx(found[name].plate.moment_x.max(), rel=0.2)
    shown: list[Results] = []
    solve(slab({"accuracy": 0.02}, loads=LEGS[:1]), on_mesh=shown.append)
    assert shown
    assert all(each.comparison for results in shown for each in results.values())


@pytest.mark.slow
def test_a_large_draft_is_made_coarser_once_more(lifting: Watched, monkeypatch: pytest.MonkeyPatch) -> None:
    """It has fewer unknowns, and everything ends on the same mesh with the same values."""
    monkeypatch.setattr(mesh_hierarchy, "LARGE_DRAFT", 0)
    shown: list[Results] = []
    results = solve(slab({"accuracy": 0.05}, **LIFTING), on_mesh=shown.append)
    assert shown[0]["a"].unknowns < lifting.shown[0]["a"].unknowns / 2
    for name, found in results.items():
        one, other = found.plate.settlement, lifting.results[name].plate.settlement
        assert found.unknowns == lifting.results[name].unknowns
        np.testing.assert_allclose(one, other, atol=1e-6 * np.abs(other).max())


@pytest.mark.slow
def test_contact_starts_from_the_mesh_before() -> None:
    """Of slabs that lift off the zone is found in few steps on the coarse meshes of the second one and those after."""
    steps: list[Step] = []
    solve(slab({"accuracy": 0.01}, **LIFTING), on_step=steps.append)
    first = steps[0].unknowns
    on_coarse = [step.iteration for step in steps if step.unknowns != first and not step.finest]
    assert on_coarse
    assert max(on_coarse) <= 4


@pytest.mark.slow
def test_what_is_unlike_all_before_starts_from_few_elements(lifting: Watched, monkeypatch: pytest.MonkeyPatch) -> None:
    """A zone that takes many steps from the plate lying everywhere takes few more than are tried; it is the same."""
    few = nested.FEW_STEPS
    monkeypatch.setattr(nested, "FEW_STEPS", 1000)
    tried: list[Step] = []
    many = solve(slab({"accuracy": 0.05}, **LIFTING), on_step=tried.append)
    most = [
        max(step.iteration for step in steps if step.unknowns == steps[0].unknowns) for steps in (lifting.steps, tried)
    ]
    assert most[0] <= few < most[1]
    for name, results in lifting.results.items():
        other = many[name].plate
        assert (results.plate.in_contact == other.in_contact).all()
        np.testing.assert_allclose(results.plate.settlement, other.settlement, atol=1e-9 * other.settlement.max())


@pytest.mark.slow
def test_a_combination_that_is_off_on_the_last_mesh_goes_on(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the one that was left out is off when all are solved, it makes another mesh, on which all are solved."""
    cases = {"cases": [{"name": "left"}, {"name": "right"}]}
    loads = [LEGS[0] | {"case": "left"}, LEGS[2] | {"case": "right"}]
    chosen: list[tuple[str, ...]] = []

    def chosen_wrongly(_: object, off: dict[str, list[JudgedValue]]) -> tuple[str, ...]:
        chosen.append(("left",) if not chosen else tuple(off))
        return chosen[-1]

    def judged(results: CombinationResult) -> list[JudgedValue]:
        worse = 8.0 if results.combination == "right" and chosen else 1.0
        return [dataclasses.replace(each, share=worse * each.share) for each in judge(results)]

    monkeypatch.setattr(adaptivity, "find_governing", chosen_wrongly)
    monkeypatch.setattr(adaptivity, "judge", judged)
    monkeypatch.setattr(adaptivity, "PROGRESS", np.inf)  # its error is made larger from one mesh to the next
    begun: list[str] = []
    shown: list[int] = []
    found = solve(
        slab({"accuracy": 0.015}, **cases, loads=loads),
        on_combination=lambda combination: begun.append(combination.name),
        on_mesh=lambda results: shown.append(results["left"].unknowns),
    )
    assert chosen[:2] == [("left",), ("right",)]
    assert begun[:3] == ["left", "right", "left"]
    assert begun[-2:] in (["right", "left"], ["left", "right"])
    assert shown == sorted(shown)
    assert len(shown) >= 2
    assert shown[-1] < found["right"].unknowns == found["left"].unknowns
    assert judged(found["right"])[0].share <= 0.015


def test_parts_beside_counts_are_refused() -> None:
    """Counts say how large all elements are."""
    part = {"shape": {"kind": "circle", "radius": 1.0}, "size": 0.1}
    with pytest.raises(InputError, match="give a size instead of counts"):
        slab({"counts": (10, 6), "refine": [part]})


def test_footprints_count_where_the_mesh_is_adaptive() -> None:
    """With a share of its side, in its middle, at its corners and between; with a size there are none."""
    model = slab({"accuracy": 0.05})
    places, sizes = local_sizes(model) or pytest.fail("no places")
    np.testing.assert_allclose(sizes, np.full(27, 0.0375))
    for k, load in enumerate(LEGS):
        offset = places[9 * k : 9 * k + 9] - [load["x"], load["y"]]
        np.testing.assert_allclose(np.unique(np.abs(offset).round(9)), [0.0, 0.075])
    assert local_sizes(slab({"size": 0.5})) is None


def test_equal_errors_need_elements_smaller_alike() -> None:
    """Of order p, halved errors need sides 2^(-1/p) times as long; else those with larger errors become smaller."""
    h = np.full(8, 0.5)
    found = adaptivity._equidistributed(h, np.ones(8), 2.0, 2.0)
    np.testing.assert_allclose(found, 0.5 / 2**0.5)
    density = np.array([8.0, 1, 1, 1, 1, 1, 1, 1])
    found = adaptivity._equidistributed(h, density, 1.0, 2.0)
    after = density * found / h
    assert np.sqrt((after**2 * h**2).sum()) == pytest.approx(np.sqrt((density**2 * h**2).sum()) / 2)
    np.testing.assert_allclose(after * found, (after * found)[0])


def test_where_section_forces_are_singular() -> None:
    """At a force without a footprint, and at corners of openings; not at those of the plate."""
    openings = [{"kind": "rectangle", "x": (-4.0, -3.0), "y": (1.0, 2.0)}]
    plate = {"length_x": 10.0, "length_y": 6.0, "thickness": 0.2, "E": 30e9, "nu": 0.2, "openings": openings}
    model = slab({"size": 0.5}, plate=plate, loads=[{"kind": "point", "P": 1e5, "x": 1.0, "y": 0.0}])
    places = np.array([(1.0, 0.0), (1.1, 0.0), (1.3, 0.0), (-3.0, 2.1), (-3.0, 2.3), (5.0, 3.0)])
    singular = near_singular(model, places, np.full(len(places), model.plate.thickness))
    assert singular.tolist() == [True, True, False, True, False, False]
    found = find_limits(model, plate_at(places))
    at_the_edge = places[:, 0] == 5.0
    assert found.shear_forces.tolist() == (~singular & ~at_the_edge).tolist()
    assert found.pressures.all()


def test_a_zone_over_the_edge_is_singular_where_its_border_meets_the_edge() -> None:
    """Its corners off the plate count for nothing; those of the same zone drawn to the edge are the same places."""
    plate = {"length_x": 10.0, "length_y": 6.0, "thickness": 0.2, "E": 30e9, "nu": 0.2}
    over, to_edge = (
        {*singular_places(slab({}, plate=plate | {"zones": [zone]}))["corners"]}
        for zone in (
            {"shape": {"kind": "rectangle", "x": (0.0, 2.0), "y": (1.0, high)}, "thickness": 0.4} for high in (3.5, 3.0)
        )
    )
    assert over == to_edge == {(0.0, 1.0), (2.0, 1.0), (0.0, 3.0), (2.0, 3.0)}


def test_pressures_of_ground_with_shear_jump_where_loads_begin() -> None:
    """Within a thickness of a loaded area's border, and along a line load; section forces only at the line's ends."""
    loads = [
        {"kind": "patch", "q": 1e5, "x": (-2.0, 0.0), "y": (-1.0, 1.0)},
        {"kind": "line", "q": 1e5, "points": [(2.0, -1.0), (2.0, 1.0)]},
    ]
    model = slab({"size": 0.5}, ground={"kind": "pasternak", "k0": 2e7, "k1": 1e7}, loads=loads)
    reach = model.plate.thickness
    places = np.array([(-1.0, 1.0 + 0.9 * reach), (-1.0, 1.0 + 1.1 * reach), (2.0, 0.0), (2.0, 1.0 + 0.9 * reach)])
    found = find_limits(model, plate_at(places))
    assert found.shear_forces.tolist() == [True, True, True, False]
    assert found.pressures.tolist() == [False, True, False, False]
    # around a node that has lifted off the pressure jumps, too; there it is zero
    found = find_limits(model, plate_at(places, in_contact=[True, False, True, True]))
    assert found.pressures.tolist() == [False, True, False, False]
    found = find_limits(model, plate_at(places, in_contact=[False, False, False, True]))
    assert found.pressures.tolist() == [False, True, False, False], "touching elsewhere on another mesh"


def test_pressures_are_not_judged_where_a_strip_along_the_edge_would_lift_off() -> None:
    """At an edge node without a line force, and within a thickness of it; beside one that has a line force they are."""
    ground = {"kind": "pasternak", "k0": 2e7, "k1": 1e7}
    model = slab({"size": 0.5}, ground=ground, contact={"tensionless": True}, loads=[{"kind": "uniform", "q": 1e4}])
    places = np.array([(5.0, 0.0), (4.9, 0.0), (4.5, 0.0)])
    found = find_limits(model, plate_at(places, edge_length=[0.5, 0.0, 0.0], line_force=[0.0, 0.0, 0.0]))
    assert found.pressures.tolist() == [False, False, True]
    found = find_limits(model, plate_at(places, edge_length=[0.5, 0.0, 0.0], line_force=[10.0, 0.0, 0.0]))
    assert found.pressures.all()


def test_a_mesh_is_adaptive_unless_it_is_described() -> None:
    """Without size and counts, with an accuracy or not."""
    assert slab({}).mesh.adaptive
    assert slab({}).mesh.largest_error == 0.05
    assert slab({"accuracy": 0.02}).mesh.adaptive
    assert not slab({"size": 0.5}).mesh.adaptive
    assert not slab({"counts": (10, 6)}).mesh.adaptive


def test_first_elements_are_no_larger_than_the_elastic_length() -> None:
    """(D / k)^(1/4) all over a large plate; on a small one 12 elements on the shorter side are smaller anyway.

    For it there are no more than 96 on the shorter side.
    """
    large = {"length_x": 60.0, "length_y": 40.0, "thickness": 0.2, "E": 30e9, "nu": 0.2}
    uniform = [{"kind": "uniform", "q": 1e4}]
    length = (30e9 * 0.2**3 / 12 / (1 - 0.2**2) / 50e6) ** 0.25
    for thickness, expected in ((0.2, length), (0.02, 40 / 96)):
        plate = large | {"thickness": thickness}
        places, extents = local_sizes(slab({}, plate=plate, loads=uniform)) or pytest.fail("no places")
        np.testing.assert_allclose(extents, expected)
        assert np.ptp(places, axis=0) == pytest.approx([60, 40])
    assert local_sizes(slab({}, loads=uniform)) is None


def test_section_forces_are_refined_around_their_places() -> None:
    """A settlement that is off makes elements smaller all over; a moment only where it is."""
    found = solve(slab({"size": 0.5})).only
    h = sides(found)
    place = (-2.0, -1.1)
    values = (JudgedValue(0.2, 1e4, name, place, np.array([place])) for name in ("moment m_x", "settlement w"))
    local, spread = (adaptivity._demand(found, [value], 0.05) for value in values)
    smaller = local < 0.99 * h
    assert smaller.any()
    assert near(found, *place, adaptivity.AROUND * h.max())[smaller].all()
    assert (spread < 0.99 * h).sum() > 1.2 * smaller.sum()
    assert (spread <= h * (1 + 1e-9)).all()


@pytest.mark.slow
def test_variants_have_a_mesh_for_half_the_errors() -> None:
    """The base case of a study has smaller errors than asked for, as those of variants may be larger."""
    model = slab({"accuracy": 0.02})
    base = Variants(model).base
    assert len(base.only.plate.elements) > len(solve(model).only.plate.elements)
    assert judge(base.only)[0].share <= 0.015
