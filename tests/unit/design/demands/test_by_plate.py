"""Results plate by plate: tilt, limits, columns, edges along joints, and what is drawn of several plates."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab import Model, Results, solve
from groundslab.design.checks import check_design
from groundslab.design.demands.by_plate import distances_to_edges, plate_under, results_by_plate, split_by_plate
from groundslab.design.demands.perimeters import RectangularColumn, perimeter
from groundslab.design.demands.tilt import largest_tilt, tilt
from groundslab.views.scene.plan import plan_of
from groundslab.views.summary import sections as summary
from groundslab.views.tables.result_tables import tables_of

STUFF = {"thickness": 0.3, "E": 30e9, "nu": 0.2}


def rectangle(x: tuple[float, float], y: tuple[float, float] = (0, 3)) -> dict[str, Any]:
    """Return a rectangle."""
    return {"kind": "rectangle", "x": x, "y": y}


@pytest.fixture(scope="module")
def results() -> Results:
    """Return the results of two bays with a hinge between them and a pad beside them, which tilts, and of a fill."""
    column = {"width_x": 0.3, "width_y": 0.3}
    return solve(
        Model.model_validate(
            {
                "plate": {"name": "west", "outline": rectangle((0, 4)), **STUFF},
                "plates": [
                    {"name": "east", "outline": rectangle((4, 8)), **STUFF},
                    {"name": "pad", "outline": rectangle((9, 11), (0, 2)), **STUFF},
                ],
                "joints": [{"kind": "hinge", "between": ("west", "east")}],
                "ground": {"kind": "pasternak", "k0": 2e7, "k1": 1e7},
                "beyond": {"kind": "infinite"},
                "columns": [
                    {"name": "A", "x": 3.6, "y": 1.5, **column},
                    {"name": "B", "x": 1.0, "y": 1.5, **column},
                    {"name": "C", "x": 10.3, "y": 1.0, **column},
                ],
                "cases": [{"name": "G"}],
                "loads": [
                    {"kind": "self weight", "unit_weight": 25e3, "case": "G"},
                    *({"kind": "point", "column": name, "P": 100e3, "case": "G"} for name in "ABC"),
                    {"kind": "patch", "on": "ground", "q": 2e4, "x": (0, 8), "y": (2, 5), "case": "G"},
                ],
                "combinations": [{"name": "SLS", "limit_state": "characteristic", "factors": {"G": 1.0}}],
                "limits": {"tilt": 0.002, "differential_settlement": 0.02, "contact_share": 0.5, "mean_pressure": 1e5},
                "mesh": {"size": 0.25},
            }
        )
    )


def test_each_plate_has_its_own_results(results: Results) -> None:
    """The parts are those of the plates, and share all nodes and elements between them."""
    parts = results_by_plate(results.only)
    assert list(parts) == ["west", "east", "pad"]
    assert [part.area.sum() for part in parts.values()] == pytest.approx([12, 12, 4])
    whole = results.only.plate
    assert sum(len(part.elements) for part in parts.values()) == len(whole.elements)
    assert sum(part.contact_force.sum() for part in parts.values()) == pytest.approx(whole.contact_force.sum())
    assert plate_under(results.only, 9.5, 1.0).nodes[:, 0].min() == 9.0


def test_tilt_and_limits_are_those_of_single_plates(results: Results) -> None:
    """Each plate's tilt is its own, the largest governs; settlement differences are not taken from plate to plate."""
    parts = results_by_plate(results.only)
    worst = max(parts, key=lambda name: tilt(parts[name]).tilt)
    assert largest_tilt(results.only) == tilt(parts[worst])
    table = {table.name: table for table in tables_of(results)}["tilt"]
    assert table["plate"] == ("west", "east", "pad")
    assert table["tilt"][2] == pytest.approx(1e3 * tilt(parts["pad"]).tilt)
    checks = {check.name: check for check in check_design(results).checks}
    assert checks["tilt"].of == worst
    assert checks["tilt"].demand == pytest.approx(1e3 * tilt(parts[worst]).tilt)
    largest = max(np.ptp(part.settlement) for part in parts.values())
    assert checks["differential settlement"].demand == pytest.approx(1e3 * largest)
    pressures = {name: part.contact_force.sum() / part.area.sum() for name, part in parts.items()}
    assert checks["mean pressure"].of == max(pressures, key=lambda name: pressures[name])


def test_the_coarser_mesh_is_split_too(results: Results) -> None:
    """What elements twice as large give stands at the nodes of each plate, so that its checks have errors."""
    parts = split_by_plate(results.only)
    before = results_by_plate(results.only.coarser)
    for name, part in parts.items():
        assert np.array_equal(part.coarser.plate.nodes, part.plate.nodes)
        assert np.array_equal(part.coarser.plate.settlement, before[name].settlement)
        assert len(part.coarser.elements.thickness) == len(part.plate.elements)
        assert not np.array_equal(part.coarser.plate.settlement, part.plate.settlement)
    limits = [check for check in check_design(results).checks if check.clause == "limits of the case"]
    assert len(limits) == 4
    assert all(check.error is not None for check in limits)


def test_a_joint_is_an_edge(results: Results) -> None:
    """Punching 0.25 m from a joint has the perimeter of a free edge, and one-way shear counts from the joint."""
    beside, d = RectangularColumn(3.6, 1.5, 0.3, 0.3), 0.25
    own = perimeter(plate_under(results.only, 3.6, 1.5), beside, 2 * d)
    across = perimeter(results.only.plate, beside, 2 * d)
    assert own.u == pytest.approx(0.3 + 2 * (0.4 + 0.15) + np.pi * 2 * d, rel=1e-3)
    assert across.u == pytest.approx(4 * 0.3 + 2 * np.pi * 2 * d, rel=1e-3)
    assert distances_to_edges(results.only, np.array([[4.0, 1.5], [3.6, 1.5]])) == pytest.approx([0.0, 0.4])


def test_steps_across_a_hinge_vanish(results: Results) -> None:
    """Along the hinge both plates settle alike, over the length of the joint."""
    (joint,) = results.only.joints
    assert set(joint.nodes[:, 0]) == {4.0}
    assert joint.length.sum() == pytest.approx(3.0)
    assert not joint.step.any()


def test_plan_and_summary_name_all_plates(results: Results) -> None:
    """What draws a plan has every plate, and which loads are on the ground; the certificate shows their sum."""
    plan = plan_of(results.model)
    assert [plate["name"] for plate in plan["plates"]] == ["east", "pad"]
    assert plan["bounds"] == [0.0, 0.0, 11.0, 3.0]
    assert [load.get("on") for load in plan["loads"]] == [None] * 4 + ["ground"]
    rows = {row.key: row.value for row in summary.certificate_section(results.only).rows}
    assert rows["ground_load"] == pytest.approx(2e4 * 8 * 2)
    assert rows["load"] == pytest.approx(25e3 * 0.3 * 28 + 300e3)
    assert rows["joint_mismatch"] < 1e-5
    (cut,) = summary.cut_loads(results.model)
    assert "under the plate" in cut.rows[0].label
