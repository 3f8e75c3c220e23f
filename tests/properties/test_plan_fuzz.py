"""Drawn plates of any kind, sensible and senseless, end in a certified result or a clear error."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from groundslab.analysis.driver import solve
from groundslab.case.casefile import from_table
from groundslab.errors import GroundslabError
from helpers.examples import examples

pytestmark = pytest.mark.slow

NUMBERS = st.integers(-6, 6).map(float) | st.floats(-8, 8).map(lambda value: round(value, 2))
LENGTHS = NUMBERS.map(lambda value: f"{value!r} m")
POINTS = st.lists(LENGTHS, min_size=2, max_size=2)
RANGES = st.lists(NUMBERS, min_size=2, max_size=2).map(lambda pair: [f"{value!r} m" for value in sorted(pair)])
RECTANGLES = st.fixed_dictionaries({"kind": st.just("rectangle"), "x": RANGES, "y": RANGES})
POLYGONS = st.fixed_dictionaries(
    {"kind": st.just("polygon"), "points": st.lists(POINTS, min_size=2, max_size=6)},
    optional={"bulges": st.lists(st.sampled_from([0, 0.3, -0.5, 1.0]), min_size=1, max_size=3)},
)
CIRCLES = st.fixed_dictionaries(
    {"kind": st.just("circle"), "centre": POINTS, "radius": st.sampled_from(["0.5 m", "1.2 m", "5 m"])}
)
SHAPES = RECTANGLES | POLYGONS | CIRCLES
PLATES = st.sampled_from(
    [
        {"kind": "rectangle", "x": ["-6 m", "6 m"], "y": ["-5 m", "5 m"]},
        {
            "kind": "polygon",
            "points": [["-6 m", "-6 m"], ["6 m", "-6 m"], ["6 m", "0 m"], ["0 m", "6 m"], ["-6 m", "6 m"]],
        },
        {"kind": "circle", "radius": "6 m"},
    ]
)
LOADS = st.one_of(
    st.fixed_dictionaries({"kind": st.just("self weight"), "unit_weight": st.just("25 kN/m^3")}),
    st.fixed_dictionaries({"kind": st.just("point"), "P": st.just("100 kN"), "x": LENGTHS, "y": LENGTHS}),
    st.fixed_dictionaries({"kind": st.just("area"), "q": st.just("5 kPa"), "shape": SHAPES}),
    st.fixed_dictionaries(
        {"kind": st.just("line"), "q": st.just("9 kN/m"), "points": st.lists(POINTS, min_size=1, max_size=3)}
    ),
)


def cases(shapes: st.SearchStrategy[Any], parts: st.SearchStrategy[Any]) -> st.SearchStrategy[dict[str, Any]]:
    """Return descriptions of plates with such outlines, and such openings and zones."""
    plate = st.fixed_dictionaries(
        {
            "outline": shapes,
            "openings": st.lists(parts, max_size=1),
            "zones": st.lists(st.fixed_dictionaries({"shape": parts, "thickness": st.just("0.5 m")}), max_size=2),
            "support": st.sampled_from(["free", "free", "soft", "clamped", "hinged"]),
            "thickness": st.just("0.3 m"),
            "E": st.just("30 GPa"),
            "nu": st.just(0.2),
        }
    )
    return st.fixed_dictionaries(
        {
            "plate": plate,
            "ground": st.just({"kind": "pasternak", "k0": "20 MPa/m", "k1": "5 MPa m"}),
            "beyond": st.sampled_from([{"kind": "none"}, {"kind": "infinite"}]),
            "contact": st.sampled_from([{"tensionless": True}, {"tensionless": False}]),
            "loads": st.lists(LOADS, min_size=1, max_size=2).map(
                lambda some: [{"kind": "uniform", "q": "9 kPa"}, *some]
            ),
            "mesh": st.just({"size": "1.5 m"}),
        }
    )


def ends_well(case: dict[str, Any]) -> None:
    """Solve a case; only errors raised on purpose are let pass, and only with something to say."""
    try:
        results = solve(from_table(case))
    except GroundslabError as error:
        said = str(error)
    else:
        said = "a certified result" * results.certificate.holds
    assert len(said) > 15


@settings(max_examples=examples(20), deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
@given(cases(SHAPES, SHAPES))
def test_any_drawing_ends_well(case: dict[str, Any]) -> None:
    """Outlines that cross themselves, openings outside, zones of no size: an error, never a crash."""
    ends_well(case)


@settings(max_examples=examples(30), deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
@given(cases(PLATES, CIRCLES | RECTANGLES))
def test_sensible_outlines_end_well(case: dict[str, Any]) -> None:
    """Sound outlines with openings and zones anywhere: most are solved, the rest refused."""
    ends_well(case)
