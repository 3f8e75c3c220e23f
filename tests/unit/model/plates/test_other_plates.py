"""Further plates: which are refused, their sections, and what they cover."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab import InputError, Model
from groundslab.case import casefile
from groundslab.discretize.discretize import discretize
from groundslab.discretize.plan_layout import plan_of
from groundslab.geometry.regions import sections
from groundslab.geometry.validity import find_issues
from groundslab.model.plates.other_plates import first_sections
from groundslab.model.plates.region import PlateRegion

STUFF = {"thickness": 0.3, "E": 30e9, "nu": 0.2}
UNIFORM = {"kind": "uniform", "q": 1e4}


def rectangle(x: tuple[float, float], y: tuple[float, float] = (0, 4)) -> dict[str, Any]:
    """Return a rectangle."""
    return {"kind": "rectangle", "x": x, "y": y}


def model(*plates: dict[str, Any], **parts: Any) -> Model:
    """Return a model of a plate from 0 to 4 m and of further ones."""
    usual = {
        "plate": {"outline": rectangle((0, 4)), "name": "A", **STUFF},
        "plates": plates,
        "ground": {"kind": "pasternak", "k0": 2e7, "k1": 1e7},
        "beyond": {"kind": "infinite"},
        "loads": [UNIFORM],
        "mesh": {"size": 1.0},
    }
    return Model.model_validate(usual | parts)


def further(outline: dict[str, Any], name: str = "B", **keys: Any) -> dict[str, Any]:
    """Return a further plate."""
    return {"name": name, "outline": outline, **STUFF, **keys}


HOLED = {"outline": rectangle((0, 4)), "openings": [rectangle((1, 3), (1, 3))], **STUFF}
REFUSED: dict[str, tuple[dict[str, Any], str, str]] = {
    "overlap": ({"plates": [further(rectangle((3, 6)))]}, "plates[1].outline", "overlaps the first plate at (3.5, 2)"),
    "within": ({"plates": [further(rectangle((1, 2), (1, 2)))]}, "plates[1].outline", "overlaps the first plate"),
    "opening": (
        {"plate": HOLED, "plates": [further(rectangle((1.5, 2.5), (1.5, 2.5)))]},
        "plates[1].outline",
        "in an opening of the first plate",
    ),
    "touch": ({"plates": [further(rectangle((4, 6)))]}, "plates[1].outline", "touches the first plate"),
    "narrow": ({"plates": [further(rectangle((4.001, 6)))]}, "plates[1].outline", "a strip too narrow"),
    "of others": (
        {"plates": [further(rectangle((5, 7))), further(rectangle((6, 9)), "C")]},
        "plates[2].outline",
        "overlaps plates[1]",
    ),
    "no name": ({"plates": [further(rectangle((5, 6)), "")]}, "plates[1].name", "no name"),
    "same name": ({"plates": [further(rectangle((5, 6)), "A")]}, "plates[1].name", '"A" again'),
    "opening outside": (
        {"plates": [further(rectangle((5, 6)), openings=[rectangle((7, 8))])]},
        "plates[1].openings[1]",
        "an opening outside the plate",
    ),
    "unknown plate": ({"loads": [UNIFORM | {"plate": "D"}]}, "loads[1].plate", '"D"'),
    "point between": ({"loads": [{"kind": "point", "P": 1e3, "x": 4.5, "y": 1}]}, "loads[1]", "a part off the plate"),
    "patch between": (
        {"loads": [{"kind": "patch", "q": 1e3, "x": (4.2, 4.8), "y": (0, 1)}]},
        "loads[1]",
        "a load off the plate",
    ),
    "column between": ({"columns": [{"name": "c", "x": 4.5, "y": 1, "diameter": 0.2}]}, "columns[1]", "off the plate"),
    "counts": ({"mesh": {"counts": (4, 4)}}, "mesh.counts", "counts"),
    "selvadurai": (
        {"ground": {"kind": "winkler", "selvadurai": {"E": 1e7, "depth": 3}}},
        "ground.selvadurai",
        "the k of one plate",
    ),
    "soil strength": ({"soil_strength": {"phi": 30.0, "unit_weight": 18e3}}, "soil_strength", "with several plates"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_refused(name: str) -> None:
    """Plates that meet or have no name, and what does not lie on any of them or is for one, are errors."""
    parts, location, words = REFUSED[name]
    with pytest.raises(InputError) as refused:
        model(**({"plates": [further(rectangle((5, 7)))]} | parts))
    assert [issue.location for issue in refused.value.issues] == [location]
    assert words in str(refused.value.issues[0])


def zoned() -> Model:
    """Return two plates with two zones and one, the last of which reaches over the first plate, too."""
    first = {
        "outline": rectangle((0, 4)),
        "zones": [
            {"shape": rectangle((0, 1)), "thickness": 0.4},
            {"shape": rectangle((3, 9)), "thickness": 0.5},
        ],
        **STUFF,
    }
    other = further(
        rectangle((5, 8)), zones=[{"shape": rectangle((3.5, 6)), "E": 20e9}], openings=[rectangle((7, 7.5), (1, 2))]
    )
    return model(other, plate=first)


def test_sections() -> None:
    """Sections count from plate to plate, and a zone counts on its own plate alone."""
    found = zoned()
    assert first_sections(found.every_plate) == [0, 3]
    plan = plan_of(found, (False, False), 2.0)
    assert find_issues(plan) == []
    places = np.array([(0.5, 1), (2, 1), (3.7, 1), (4.5, 1), (5.5, 1), (6.5, 1), (7.2, 1.5), (7.2, 3), (-1, 1)])
    assert sections(plan, places).tolist() == [1, 0, 2, -1, 4, 3, -1, 3, -1]
    problem = discretize(found)
    assert set(zip(problem.plate.section.tolist(), problem.plate.number.tolist(), strict=True)) == {
        (0, 0), (1, 0), (2, 0), (3, 1), (4, 1),
    }  # fmt: skip
    assert problem.plate.names == ("plate 1", "B")
    D = {n: float(problem.plate.bending[n, 0, 0]) for n in range(5)}
    assert D[1] / D[0] == pytest.approx((4 / 3) ** 3)
    assert D[4] / D[3] == pytest.approx(2 / 3)


def test_written_and_read() -> None:
    """A file says the same as the model, and editors know the key."""
    found = zoned()
    text = casefile.to_toml(found)
    assert "[[plates]]" in text
    assert "[[plates.zones]]" in text
    assert casefile.loads(text) == found


def test_region() -> None:
    """What all plates cover, and which plate a place lies on."""
    found = zoned()
    region = PlateRegion(found.plate, found.plates)
    assert region.bounds == found.bounds == (0.0, 8.0, 0.0, 4.0)
    assert region.area.area == pytest.approx(16 + 12 - 0.5)
    assert [region.plate_at(place) for place in ((4.0, 1.0), (5.0, 1.0), (7.9, 4.0))] == [0, 1, 1]
