"""Random pairs of plates, apart or joined, under random loads: what must hold whatever they are."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab import Model, solve
from groundslab.design.demands.by_plate import results_by_plate
from helpers.examples import examples

GROUNDS: list[dict[str, Any]] = [
    {"kind": "winkler", "k": 2e7},
    {"kind": "pasternak", "k0": 2e7, "k1": 3e7},
    {"kind": "vlasov", "layers": [{"E": 3e7, "nu": 0.3, "thickness": 4.0}]},
    {
        "kind": "layered",
        "coupling": "consistent",
        "layers": [{"E": 3e7, "nu": 0.3, "thickness": 3.0, "sublayers": 2}],
    },
]


def random_plates(seed: int) -> tuple[dict[str, Any], dict[str, Any], dict[str, Any]]:
    """Return two plates, side by side or some way apart, and the other sections of a model."""
    rng = np.random.default_rng(seed)
    sides = rng.uniform(2, 6, 4).round(1)
    joined, apart = bool(seed % 2), round(float(rng.uniform(0.3, 2)), 1)
    x1 = float(sides[0]) + (0.0 if joined else apart)
    places = (0.0, float(sides[0]), 0.0, float(sides[1])), (x1, x1 + float(sides[2]), -0.5, float(sides[3]) - 0.5)
    plates = [
        {
            "name": name,
            "outline": {"kind": "rectangle", "x": (a, b), "y": (c, d)},
            "thickness": float(t),
            "E": 30e9,
            "nu": 0.2,
        }
        for name, (a, b, c, d), t in zip("AB", places, rng.uniform(0.15, 0.5, 2).round(2), strict=True)
    ]
    loads: list[dict[str, Any]] = [{"kind": "self weight", "unit_weight": 25e3}]
    for a, b, c, d in places:
        at = rng.uniform(0.2, 0.8, 2)
        loads.append(
            {
                "kind": "point",
                "P": float(rng.uniform(0, 2e5)),
                "x": a + at[0] * (b - a),
                "y": c + at[1] * (d - c),
                "width_x": 0.3,
                "width_y": 0.3,
            }
        )
    elastic = {"kind": "elastic", "stiffness": float(10 ** rng.uniform(6, 9)), "gap": float(rng.choice([0, 2e-5]))}
    joint = {"kind": "hinge"} if rng.random() < 0.4 else elastic
    ground = GROUNDS[int(rng.integers(len(GROUNDS)))]
    if ground["kind"] != "winkler":
        loads.append({"kind": "patch", "on": "ground", "q": 15e3, "x": (-1.0, 5.0), "y": (-3.0, 0.0)})
    parts = {
        "joints": [{"between": ("A", "B"), **joint}] if joined else [],
        "ground": ground,
        "beyond": {"kind": "infinite"},
        "loads": loads,
        "mesh": {"size": 0.8},
    }
    return plates[0], plates[1], parts


@pytest.mark.parametrize("seed", range(examples(12)))
def test_balance_plate_by_plate_and_order(seed: int) -> None:
    """The ground carries each plate's loads less what its joint passes on, in whichever order plates are described."""
    first, second, parts = random_plates(seed)
    model = Model.model_validate({"plate": first, "plates": [second], **parts})
    results = solve(model).only
    assert results.certificate.holds
    passed = sum(joint.total for joint in results.joints)
    for plate, part, sign, force in zip(
        model.every_plate, results_by_plate(results).values(), (-1, 1), parts["loads"][1:3], strict=True
    ):
        x, y = plate.sides
        acting = 25e3 * plate.thickness * x * y + force["P"] + sign * passed
        assert part.contact_force.sum() == pytest.approx(acting, rel=1e-5)
    swapped = solve(Model.model_validate({"plate": second, "plates": [first], **parts})).only
    for each in (first, second):
        (x0, x1), (y0, y1) = each["outline"]["x"], each["outline"]["y"]
        for x, y in ((0.9 * x0 + 0.1 * x1, y0), (0.3 * x0 + 0.7 * x1, (y0 + y1) / 2)):
            here, there = (found.plate.value_at("settlement", x, y) for found in (results, swapped))
            assert there == pytest.approx(here, rel=1e-5)
