"""Several plates on one ground: each alone where they do not feel each other, strips in closed form where they do."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from groundslab import Model, NeutralEquilibrium, NoEquilibrium, solve
from groundslab.design.demands.by_plate import results_by_plate
from groundslab.design.demands.tilt import tilt
from groundslab.results.results import CombinationResult

K0, K1 = 20e6, 45e6
A = math.sqrt(K0 / K1)
PASTERNAK = {"kind": "pasternak", "k0": K0, "k1": K1}
SOIL = [{"thickness": 3.0, "E": 20e6, "nu": 0.3}, {"thickness": 4.0, "E": 50e6, "nu": 0.25}]
GROUNDS: dict[str, dict[str, Any]] = {
    "winkler": {"kind": "winkler", "k": K0},
    "pasternak": PASTERNAK,
    "vlasov": {"kind": "vlasov", "layers": SOIL, "gamma": 1.5},
    "consistent": {"kind": "layered", "coupling": "consistent", "layers": SOIL},
}
CONCRETE = {"thickness": 0.4, "E": 30e9, "nu": 0.2}
RIGID = {"thickness": 0.5, "E": 3e15, "nu": 0.0}


def rectangle(x: tuple[float, float], y: tuple[float, float]) -> dict[str, Any]:
    """Return a rectangle."""
    return {"kind": "rectangle", "x": x, "y": y}


def plate(x: tuple[float, float], y: tuple[float, float] = (-0.5, 0.5), **keys: Any) -> dict[str, Any]:
    """Return a rectangular plate."""
    return {"outline": rectangle(x, y), **CONCRETE, **keys}


def solved(*plates: dict[str, Any], **parts: Any) -> CombinationResult:
    """Return the results of plates, the first of which is [plate]."""
    first, *others = plates
    usual = {"beyond": {"kind": "infinite"}, "mesh": {"size": 0.25}, "ground": PASTERNAK}
    return solve(Model.model_validate({"plate": first, "plates": others, **usual, **parts})).only


def force(x: float, P: float = 100e3, y: float = 0.0) -> dict[str, Any]:
    """Return a force on a footprint."""
    return {"kind": "point", "P": P, "x": x, "y": y, "width_x": 0.5, "width_y": 0.5}


WEIGHT = {"kind": "self weight", "unit_weight": 25e3}


def test_two_rigid_strips_feel_each_other() -> None:
    """Two rigid strips glued to Pasternak ground, one of them loaded: four unknowns in closed form.

    Under a strip p = k0 w; at its outer edge the ground's tail resists with k1 a w, and between the strips, at the
    distance g, w = cosh and sinh, k1 a (w1 coth(a g) - w2 / sinh(a g)). The strip's own slope bears k1 w' at its ends.
    """
    half, gap, P = 2.0, 1.2, 80e3
    s, t = K1 * A / math.tanh(A * gap), K1 * A / math.sinh(A * gap)
    k = np.zeros((4, 4))
    ends = {"a": [1, -half, 0, 0], "b": [1, half, 0, 0], "c": [0, 0, 1, -half], "d": [0, 0, 1, half]}
    a, b, c, d = (np.array(each, dtype=float) for each in ends.values())
    for settlement, slope in ((0, 1), (2, 3)):
        k[settlement, settlement] += K0 * 2 * half
        k[slope, slope] += K0 * 2 * half**3 / 3 + K1 * 2 * half
    k += K1 * A * (np.outer(a, a) + np.outer(d, d))
    k += s * (np.outer(b, b) + np.outer(c, c)) - t * (np.outer(b, c) + np.outer(c, b))
    at = 0.75
    w = np.linalg.solve(k, [P, P * at, 0.0, 0.0])

    x1, x2 = -half - gap / 2, half + gap / 2
    results = solved(
        plate((x1 - half, x1 + half), name="west", **RIGID),
        plate((x2 - half, x2 + half), name="east", **RIGID),
        beyond={"kind": "infinite", "sides": ["left", "right"]},
        contact={"tensionless": False},
        loads=[{"kind": "line", "q": P, "points": [(x1 + at, -0.5), (x1 + at, 0.5)]}],
        mesh={"size": 0.25},
    )
    for end, x in zip((a, b, c, d), (x1 - half, x1 + half, x2 - half, x2 + half), strict=True):
        assert results.plate.value_at("settlement", x, 0.0) == pytest.approx(end @ w, rel=1e-4)
    tilts = {name: tilt(each) for name, each in results_by_plate(results).items()}
    assert tilts["west"].tilt_x == pytest.approx(w[1], rel=1e-3)
    assert tilts["east"].settlement == pytest.approx(w[2], rel=1e-4)
    assert tilts["east"].tilt_x == pytest.approx(w[3], rel=1e-3)
    assert results.certificate.holds
    assert results.certificate.load == pytest.approx(P)


def test_two_equal_plates_are_one_with_a_line_of_symmetry() -> None:
    """The ground between two equal plates has no slope half way: as if it ended there with a free edge."""
    half = {"kind": "margin", "width": 0.75, "sides": ["left", "right"]}
    right = [WEIGHT, force(1.25), {"kind": "uniform", "q": 5e3}]
    one = solved(plate((0.75, 4.75), (-1, 1)), beyond=half, loads=right)
    both = solved(
        plate((0.75, 4.75), (-1, 1)),
        plate((-4.75, -0.75), (-1, 1), name="left"),
        beyond=half,
        loads=[*right, force(-1.25)],
    )
    for x in (0.75, 1.25, 3.0, 4.75):
        alone = one.plate.value_at("settlement", x, 0.4)
        for sign in (-1, 1):
            assert both.plate.value_at("settlement", sign * x, 0.4) == pytest.approx(alone, rel=1e-4)
    assert both.certificate.load == pytest.approx(2 * one.certificate.load, rel=1e-12)
    assert both.ground.value_at(0.0, 0.0) == pytest.approx(one.ground.value_at(0.0, 0.0), rel=1e-4)


@pytest.mark.parametrize("kind", GROUNDS)
def test_far_plates_are_each_alone(kind: str) -> None:
    """Plates so far from each other that the ground dies out settle as each by itself; on springs all do."""
    distance = 1.0 if kind == "winkler" else 40.0
    first, second = plate((0, 4), (0, 3), thickness=0.25), plate((distance + 4, distance + 9), (0, 3), name="far")
    at = distance + 4.5
    loads, others = [WEIGHT, force(1.0, y=1.0)], [WEIGHT, force(at, 200e3, 1.0)]
    both = solved(first, second, ground=GROUNDS[kind], loads=[*loads, force(at, 200e3, 1.0)])
    assert both.certificate.holds
    near = 1e-6 if kind == "winkler" else 1e-3
    for own, acting, places in ((first, loads, (0.0, 1.0, 4.0)), (second, others, (distance + 4, at, distance + 9))):
        alone = solved(own, ground=GROUNDS[kind], loads=acting)
        for x in places:
            expected = alone.plate.value_at("settlement", x, 1.5)
            assert both.plate.value_at("settlement", x, 1.5) == pytest.approx(expected, rel=near)
            moment = alone.plate.value_at("moment_x", 0.3 * places[0] + 0.7 * x, 1.5)
            found = both.plate.value_at("moment_x", 0.3 * places[0] + 0.7 * x, 1.5)
            assert found == pytest.approx(moment, rel=0.02, abs=100)


@pytest.mark.parametrize("kind", GROUNDS)
def test_loads_act_on_the_plate_that_they_name(kind: str) -> None:
    """Pressures and weight act on all plates, or on the one named, with its thickness; each is in balance."""
    east = plate((5, 8), (0, 2), name="east", thickness=0.6)
    east["zones"] = [{"shape": rectangle((5, 6), (-1, 3)), "thickness": 0.8}]
    loads = [
        {"kind": "uniform", "q": 1e3},
        {"kind": "uniform", "q": 7e3, "plate": "east"},
        WEIGHT | {"plate": "west"},
        WEIGHT | {"plate": "east"},
    ]
    results = solved(plate((0, 4), (0, 3), name="west"), east, ground=GROUNDS[kind], loads=loads, mesh={"size": 0.5})
    west_load = (1e3 + 25e3 * 0.4) * 12
    east_load = (1e3 + 7e3) * 6 + 25e3 * (0.8 * 2 + 0.6 * 4)
    parts = results_by_plate(results)
    assert parts["west"].contact_force.sum() == pytest.approx(west_load, rel=1e-6)
    assert parts["east"].contact_force.sum() == pytest.approx(east_load, rel=1e-6)
    assert results.certificate.load == pytest.approx(west_load + east_load, rel=1e-12)
    assert results.certificate.holds
    thickness = {x: results.elements.thickness[results.plate.element_at(x, 1.0)] for x in (1.0, 5.4, 7.4)}
    assert thickness == {1.0: 0.4, 5.4: 0.8, 7.4: 0.6}
    assert set(results.elements.section.tolist()) == {0, 1, 2}


def test_a_plate_without_load_is_neutral() -> None:
    """Each plate must be in equilibrium by itself: what presses one of them does not hold the other."""
    west, east = plate((0, 4), (0, 3), name="west"), plate((5, 8), (0, 2), name="east")
    with pytest.raises(NoEquilibrium, match="east: the loads do not press the plate down"):
        solved(west, east, loads=[force(2.0, y=1.5)])
    with pytest.raises(NoEquilibrium, match="east: the loads topple the plate"):
        solved(west, east, loads=[WEIGHT, force(5.25, -10e3, 1.0), force(7.75, 30e3, 0.3), force(5.3, -60e3, 1.0)])
    pull = {"kind": "point", "x": 6.5, "y": 1.0, "stiffness": 1e7, "acts": "in tension", "name": "pile"}
    with pytest.raises(NeutralEquilibrium, match="east: the equilibrium is neutral"):
        solved(west, east, loads=[WEIGHT | {"plate": "west"}, force(6.5, -50e3, 1.0)], supports=[pull])


def test_a_hinged_flap_without_load_is_neutral() -> None:
    """The far end of a loaded slab lifts and takes the hinge of a weightless flap along: nothing decides its slope."""
    slab, flap = plate((-3, 3), (-2, 2), name="slab"), plate((3, 5), (-2, 2), name="flap")
    joined: dict[str, Any] = {
        "ground": GROUNDS["winkler"],
        "beyond": {"kind": "none"},
        "joints": [{"kind": "hinge", "between": ["slab", "flap"]}],
    }
    # the loads are on the boundary of those that can be balanced, so that rounding decides when it is found
    with pytest.raises((NeutralEquilibrium, NoEquilibrium), match=r"slab and flap: .* joined plates can"):
        solved(slab, flap, loads=[force(-2.0, y=1.0)], **joined)
    held = solved(slab, flap, loads=[force(-2.0, y=1.0), {"kind": "uniform", "q": 5e3}], **joined)
    assert held.certificate.holds


def test_temperature_curls_the_plate_that_it_names() -> None:
    """On springs that may lift, a plate whose top is colder curls up at its ends; the other one stays as it is."""
    loads = [WEIGHT, {"kind": "temperature", "difference": 15.0, "plate": "east"}]
    results = solved(
        plate((0, 6), (0, 2), name="west"), plate((7, 13), (0, 2), name="east"), ground=GROUNDS["winkler"], loads=loads
    )
    parts = results_by_plate(results)
    assert np.ptp(parts["west"].settlement) < 1e-9
    assert np.ptp(parts["east"].settlement) > 2e-4
    assert results.certificate.holds


def test_round_plates_and_adaptive_meshes() -> None:
    """Plates of any shape, one small beside a large one: meshed and refined until both are accurate."""
    column = {"outline": {"kind": "circle", "centre": (7.0, 0.0), "radius": 1.0}, **CONCRETE, "name": "footing"}
    results = solved(
        plate((-6, 5), (-4, 4)), column, loads=[WEIGHT, force(0.0), force(7.0, 300e3)], mesh={"accuracy": 0.2}
    )
    assert results.certificate.holds
    parts = results_by_plate(results)
    assert parts["footing"].area.sum() == pytest.approx(math.pi, rel=1e-3)
    assert parts["footing"].contact_force.sum() == pytest.approx(300e3 + 25e3 * 0.4 * math.pi, rel=1e-3)
    towards, away = (results.plate.value_at("settlement", x, 0.0) for x in (5.0, -6.0))
    assert towards > 1.5 * away
