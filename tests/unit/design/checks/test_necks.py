"""Shear through necks of a slab, between openings and edges, held against what is loaded beyond them."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np
import pytest

from groundslab.design.checks import DesignCheck, check_design
from groundslab.design.checks.one_way_shear.necks import neck_cuts
from groundslab.model.model import Model
from groundslab.results.results import Results
from helpers.solve_once import solve_once

CODES = ("EN 1992-1-1", "EN 1992-1-1:2023", "ACI 318")
H, D, Q, WIDTH = 0.5, 0.5 - 0.045, 60e3, 0.6
STEEL = {"f_ck": 30e6, "f_yk": 420e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05)}
LAID = {layer: {"diameter": 0.032, "spacing": 0.1} for layer in ("bottom_x", "bottom_y", "top_x", "top_y")}
COLUMN = {"name": "C", "x": 0, "y": 1.0, "width_x": 0.4, "width_y": 0.4}


def rectangle(x: tuple[float, float], y: tuple[float, float]) -> dict[str, Any]:
    """Return a rectangle."""
    return {"kind": "rectangle", "x": x, "y": y}


def sheet(half: float, end: float) -> dict[str, Any]:
    """Return the outline of a rectangle from -half to half and from 0 to end."""
    return {"kind": "polygon", "points": [(-half, 0), (half, 0), (half, end), (-half, end)]}


def raft(code: str, plate: dict[str, Any], voids: list[dict[str, Any]], **changes: Any) -> Model:
    """Return a raft of 4 x 5 m, a column on its lower part, its upper part over a void, under 60 kPa."""
    parts: dict[str, Any] = {
        "plate": {"thickness": H, "E": 31e9, "nu": 0.2, **plate},
        "ground": {"kind": "winkler", "k": 50e6},
        "contact": {"voids": [{"shape": shape} for shape in voids]},
        "cases": [{"name": "G"}],
        "loads": [{"kind": "uniform", "q": Q, "case": "G"}, {"kind": "point", "P": 900e3, "column": "C", "case": "G"}],
        "columns": [COLUMN],
        "combinations": [{"name": "ULS", "factors": {"G": 1.0}}],
        "reinforcement": {**STEEL, **LAID, "code": code},
        "mesh": {"size": 0.25},
    }
    return Model(**parts | changes)


@cache
def notched(code: str, length: float = 1.0, *, wall: bool = False) -> Results:
    """Return the raft with notches from both sides that leave a neck 0.6 m wide, from y = 3 m on, and 4 x 1 m beyond.

    A wall may stand along the neck, without stiffness and with 1 N/m.
    """
    half, end = WIDTH / 2, 3 + length
    right = [(2, 0), (2, 3), (half, 3), (half, end), (2, end), (2, end + 1)]
    outline = {"kind": "polygon", "points": [*right, *((-x, y) for x, y in reversed(right))]}
    voids = [rectangle((-half, half), (3, end)), rectangle((-2, 2), (end, end + 1))]
    model = raft(code, {"outline": outline}, voids)
    line = {"kind": "line", "q": 1.0, "points": [(0, 2.6), (0, end + 0.6)], "case": "G"}
    return solve_once(model.replace(loads=[*model.loads, line]) if wall else model)


def shear_of(combined: Results) -> DesignCheck:
    """Return the check of one-way shear."""
    return next(each for each in check_design(combined).checks if each.name == "one-way shear")


def resistance(code: str) -> float:
    """Return what needs no links by hand [kN/m]: of 32 mm at 100 mm on d = 0.455 m, rho = 1.77 %."""
    rho, d = math.pi * 0.032**2 / 4 / 0.1 / D, 1e3 * D
    if code == "ACI 318":  # Table 22.5.5.1 (c)
        return 0.75 * 0.66 * math.sqrt(2 / (1 + 0.004 * d)) * rho ** (1 / 3) * math.sqrt(30) * d
    if code == "EN 1992-1-1":  # (6.2a)
        return 0.18 / 1.5 * (1 + math.sqrt(200 / d)) * (100 * rho * 30) ** (1 / 3) * d
    return 0.66 / 1.4 * (100 * rho * 30 * 32 / d) ** (1 / 3) * 0.9 * d  # (8.27), d_dg = 16 + 16 mm


@pytest.mark.slow
@pytest.mark.parametrize(("code", "length"), [*((code, 1.0) for code in CODES), ("EN 1992-1-1", 0.2)])
def test_all_that_is_loaded_beyond_passes_through_a_neck(code: str, length: float) -> None:
    """60 kPa on 4 x 1 m beyond and up to half of the neck's own on 0.6 m: more than 400 kN/m, which need links.

    No place of the neck is a thickness away from its edges. Bars are the same everywhere, so the greatest v governs.
    """
    check = shear_of(notched(code, length))
    beyond, own = Q * 4 * 1 / 1e3 / WIDTH, Q * length / 1e3
    assert beyond == pytest.approx(400)
    assert check.demand is not None
    assert beyond <= check.demand <= (beyond + own) * 1.001
    assert check.place is not None
    assert check.place[0] == pytest.approx(0, abs=1e-6)
    assert 3 <= check.place[1] <= 3 + length
    assert check.resistance == pytest.approx(resistance(code), rel=1e-3)
    assert check.status == "attention"
    assert check.utilization == pytest.approx(check.demand / resistance(code), rel=1e-3)
    assert check.utilization > 1.19


def test_elements_keep_equilibrium_along_the_neck() -> None:
    """Away from its mouth each cut bears what is loaded beyond, but for half an element's own load, 0.125 m."""
    results = notched("ACI 318")["ULS"]
    cuts = [cut for cut in neck_cuts(results, np.full(len(results.plate.nodes), H)) if 3.05 < cut.place[1] < 3.95]
    assert len(cuts) >= 4
    for cut in cuts:
        beyond = Q * (4 + WIDTH * (4 - cut.place[1])) / WIDTH
        assert cut.shear(results, results.plate) == pytest.approx(beyond, abs=0.126 * Q)


def test_a_wall_along_a_neck_does_not_hide_it() -> None:
    """What passes through a neck does so below a wall that follows it, too, which bears nothing of it."""
    for wall in (False, True):
        check = shear_of(notched("ACI 318", wall=wall))
        assert check.demand is not None
        assert check.demand >= 400


@pytest.mark.slow
def test_necks_beside_openings_share_what_passes() -> None:
    """Two openings leave three necks, of 0.3, 0.6 and 0.3 m: together they bear what is beyond, the worst its mean.

    4 x 1 m and 1.2 x 1 m between under 60 kPa make 312 kN at their lower ends and 240 kN at their upper ones.
    """
    openings = [rectangle((-1.7, -0.3), (3, 4)), rectangle((0.3, 1.7), (3, 4))]
    voids = [rectangle((-2, 2), (4, 5)), *(rectangle(x, (3, 4)) for x in ((-2, -1.7), (-0.3, 0.3), (1.7, 2)))]
    plate = {"outline": sheet(2, 5), "openings": openings}
    combined = solve_once(raft("ACI 318", plate, voids))
    results = combined["ULS"]
    cuts = neck_cuts(results, np.full(len(results.plate.nodes), H))
    middle = [cut for cut in cuts if abs(cut.place[1] - 3.5) < 0.2 and abs(cut.normal[1]) > 0.99]
    by_place = {round(cut.place[0], 2): cut for cut in middle}
    assert sorted(by_place) == [-1.85, 0.0, 1.85]
    shear = {x: cut.shear(results, results.plate) * (WIDTH if x == 0 else 0.3) for x, cut in by_place.items()}
    assert sum(shear.values()) == pytest.approx(Q * (4 + 1.2 * 0.5), rel=0.05)
    check = shear_of(combined)
    assert check.demand is not None
    assert 240 / 1.2 * 0.99 <= check.demand <= 312 / 0.6


def test_wide_slab_and_corners_have_no_necks() -> None:
    """A raft of 4 x 5 m with h = 0.5 m has none, nor do its corners or one round opening 1.5 m from its edges."""
    opening = {"kind": "circle", "centre": (0, 3.2), "radius": 0.3}
    for openings in ([], [opening]):
        plate = {"outline": sheet(2.5, 5), "openings": openings}
        results = solve_once(raft("ACI 318", plate, []))["ULS"]
        assert not neck_cuts(results, np.full(len(results.plate.nodes), H / 2))


@pytest.mark.slow
def test_the_narrowest_place_between_round_openings_is_found() -> None:
    """Circles of 0.5 m whose centers are 1.6 m apart leave 0.6 m; staggered corners 0.5 m apart leave that."""
    circles = [{"kind": "circle", "centre": (x, 3.0), "radius": 0.5} for x in (-0.8, 0.8)]
    squares = [rectangle((-1.3, -0.2), (2.5, 3.0)), rectangle((0.2, 1.3), (3.3, 3.8))]
    for openings, width in ((circles, 0.6), (squares, 0.5)):
        plate = {"outline": sheet(2.5, 6), "openings": openings}
        results = solve_once(raft("ACI 318", plate, []))["ULS"]
        cuts = neck_cuts(results, np.full(len(results.plate.nodes), 0.3))
        lengths = [float(np.linalg.norm(cut.legs[0, 1] - cut.legs[0, 0])) for cut in cuts]
        assert min(lengths) == pytest.approx(width, rel=0.02)
