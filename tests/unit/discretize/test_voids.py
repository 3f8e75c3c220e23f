"""Voids and cavities: what bears where, and how much of the plate is said to be in contact."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab import CombinationResult, InputError, Model, solve
from groundslab.fem.shape_functions import areas
from groundslab.results.results import results_of
from groundslab.results.soil_profile import crossed_borders
from groundslab.study.definition.outputs import RequestedOutput, scalar_of
from groundslab.views.files.vtk import plate_mesh
from groundslab.views.summary import sections
from groundslab.views.summary.json_summary import to_json
from groundslab.views.tables.result_tables import tables_of

CAVITY = {"x": (1.0, 2.0), "y": (-1.0, 1.0)}
SHEAR = {"kind": "pasternak", "k0": 2e7, "k1": 1e7}
SPRINGS = {"kind": "winkler", "k": 2e7}


def solved(void: dict[str, Any], mesh: dict[str, Any], ground: dict[str, Any], **contact: Any) -> CombinationResult:
    """Return the results of a plate of 6 x 4 m that bears everywhere beside a void."""
    return solve(
        Model(
            plate={"length_x": 6.0, "length_y": 4.0, "thickness": 0.4, "E": 3e10, "nu": 0.2},
            ground=ground,
            contact={"voids": [void], **contact},
            loads=[{"kind": "uniform", "q": 2e4}],
            mesh=mesh,
        )
    ).only


@pytest.mark.parametrize("mesh", [{"size": 0.5}, {"size": 0.37}, {"counts": (12, 8)}, {"counts": (13, 9)}])
def test_a_cavity_is_not_in_contact(mesh: dict[str, Any]) -> None:
    """22 of 24 m2 bear, on any mesh; nodes in the cavity touch nothing, sink into nothing and carry nothing."""
    results = solved(CAVITY, mesh, SPRINGS)
    plate = results.plate
    assert plate.contact_share == pytest.approx(22 / 24, rel=1e-12)
    x, y = plate.nodes.T
    inside = (x > 1.2) & (x < 1.6) & (np.abs(y) < 0.6)
    assert inside.any()
    assert not plate.in_contact[inside].any()
    assert not plate.contact_area[inside].any()
    assert not plate.penetration.any()
    assert not plate.pressure[inside].any()
    assert plate.pressure @ plate.area == pytest.approx(24 * 2e4, rel=1e-9)


def test_nodes_on_the_edge_of_a_cavity_have_two_sides() -> None:
    """One of them bears with all of its pressure, the other not at all; nothing is averaged across the edge."""
    plate = solved(CAVITY, {"size": 0.5}, SPRINGS).plate
    x, y = plate.nodes.T
    on_edge = np.isclose(x, 1.0) & (np.abs(y) < 0.9)
    assert sorted(plate.in_contact[on_edge]) == [False] * 7 + [True] * 7
    bears = on_edge & plate.in_contact
    np.testing.assert_allclose(plate.pressure[bears], 2e7 * plate.settlement[bears], rtol=0.05)
    assert not plate.pressure[on_edge & ~plate.in_contact].any()


def test_all_readers_give_the_same_contact() -> None:
    """Summary, tables, ParaView's file and studies: 91.67 % where 2 of 24 m2 are a cavity."""
    results = solved(CAVITY, {"size": 0.5}, SPRINGS)
    combined = solve(results.model)
    rows = {f"{s.key}.{row.key}": row.value for s in sections.summary(results) for row in s.rows}
    assert rows["contact.share"] == pytest.approx(22 / 24)
    data = plate_mesh(results).point_data
    share = data["area of the node in contact [m2]"].sum() / data["area of the node [m2]"].sum()
    assert share == pytest.approx(22 / 24)
    output = RequestedOutput(name="share", of="in contact")
    assert scalar_of(output, combined, list(combined.results)) == pytest.approx(22 / 24)
    texts = [cell for table in tables_of(combined) for row in table.rows() for cell in row if isinstance(cell, float)]
    assert any(value == pytest.approx(100 * 22 / 24) for value in texts)


@pytest.mark.slow
@pytest.mark.parametrize("beyond", [{"kind": "none"}, {"kind": "margin", "width": 1.0}])
def test_the_plate_of_the_results_is_whole(beyond: dict[str, Any]) -> None:
    """With sections, ground beyond and voids at once, nodes that stand for several sides stay where they are."""
    zone = {"shape": {"kind": "rectangle", "x": (-2.0, 0.5), "y": (-1.5, 1.5)}, "thickness": 0.6}
    results = solve(
        Model(
            plate={"length_x": 6.0, "length_y": 4.0, "thickness": 0.4, "E": 3e10, "nu": 0.2, "zones": [zone]},
            ground=SHEAR,
            beyond=beyond,
            contact={"voids": [CAVITY, {"x": (-1.0, 1.5), "y": (-0.5, 0.5), "depth": 1e-3}]},
            loads=[{"kind": "uniform", "q": 2e4}],
            mesh={"size": 0.5},
        )
    )
    plate = results.plate
    assert areas(plate.nodes[plate.elements]).sum() == pytest.approx(24.0, rel=1e-12)
    assert plate.area.sum() == pytest.approx(24.0, rel=1e-12)
    assert plate.contact_force.sum() == pytest.approx(results.certificate.reaction, rel=1e-9)


@pytest.mark.parametrize("ground", [SPRINGS, SHEAR])
def test_a_void_that_is_not_reached_is_a_cavity(ground: dict[str, Any]) -> None:
    """With a depth of 1 m or without one settlements are the same; the gap is what is left of the depth."""
    deep = solved({**CAVITY, "depth": 1.0}, {"size": 0.5}, ground)
    none = solved(CAVITY, {"size": 0.5}, ground)
    np.testing.assert_allclose(deep.plate.settlement, none.plate.settlement, rtol=1e-9)
    x, y = deep.plate.nodes.T
    inside = (x > 1.01) & (x < 1.99) & (np.abs(y) < 0.99)
    assert deep.plate.contact_share == pytest.approx(none.plate.contact_share)
    if ground is SPRINGS:
        np.testing.assert_allclose(deep.plate.gap[inside], 1.0 - deep.plate.settlement[inside], rtol=1e-9)


def test_beside_a_cavity_the_limit_pressure_acts_on_the_area_that_bears() -> None:
    """No node carries more than the limit times its area outside; all together carry the load."""
    plate = solved(CAVITY, {"size": 0.5}, SPRINGS, limit_pressure=2.3e4).plate
    assert plate.pressure.max() <= 2.3e4 * (1 + 1e-9)
    assert plate.penetration.max() > 0
    assert plate.pressure @ plate.area == pytest.approx(24 * 2e4, rel=1e-9)


def test_of_voids_that_overlap_the_deepest_counts() -> None:
    """A shallow void within a cavity is none; a cavity within a shallow void is one."""
    results = solve(
        Model(
            plate={"length_x": 6.0, "length_y": 4.0, "thickness": 0.4, "E": 3e10, "nu": 0.2},
            ground=SPRINGS,
            contact={"voids": [CAVITY, {"x": (-1.0, 2.5), "y": (-0.5, 0.5), "depth": 1e-5}]},
            loads=[{"kind": "uniform", "q": 2e4}],
            mesh={"size": 0.5},
        )
    )
    assert results.plate.contact_share == pytest.approx(22 / 24)


def test_what_a_grid_cannot_follow_is_said() -> None:
    """Summary and JSON name the void, its area as drawn and on the mesh; a mesh that follows it says nothing."""
    assert crossed_borders(solved(CAVITY, {"size": 0.37}, SHEAR)) == ()
    (found,) = crossed_borders(results := solved(CAVITY, {"counts": (13, 9)}, SHEAR))
    width, height = 6 / 13, 4 / 9
    assert found.name == "contact.voids[1]"
    assert found.drawn == pytest.approx(2.0)
    # of 13 x 9 elements those in columns 9 and 10 of 8.67 to 10.83 and rows 2.25 to 6.75, by the larger part
    assert found.meshed == pytest.approx(2 * 5 * width * height)
    document = to_json(results_of(results))
    assert document["plate"]["contact.voids[1].meshed"]["value"] == pytest.approx(found.meshed)
    assert document["plate"]["notes"] == [sections.CROSSED]
    area = float(results.plate.area.sum() - results.plate.contact_area.sum())
    assert area == pytest.approx(found.meshed, abs=width * height)


def test_a_void_that_no_element_takes_is_refused_on_ground_with_shear() -> None:
    """A void much smaller than the elements of a grid that is asked for would be lost: it is an error."""
    with pytest.raises(InputError) as raised:
        solved({"x": (0.1, 0.3), "y": (0.1, 0.3)}, {"counts": (12, 8)}, SHEAR)
    assert [issue.location for issue in raised.value.issues] == ["contact.voids[1]"]
    assert solved({"x": (0.1, 0.3), "y": (0.1, 0.3)}, {"counts": (12, 8)}, SPRINGS).plate.contact_share < 1
