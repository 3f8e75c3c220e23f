"""The ground beyond the plate: elements as fine as it dies out, and a margin whose effect is known and judged."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab import CombinationResult, Model, NotCertified, solve
from groundslab.discretize.discretize import discretize
from groundslab.fem.foundation import Layer as GroundLayer
from groundslab.fem.foundation import consistent_stack, decay_length, interface_stack, single
from groundslab.results.results import results_of
from groundslab.views.summary import sections as summary
from groundslab.views.summary.json_summary import to_json

pytestmark = pytest.mark.slow


def slab(beyond: dict[str, str] | None = None, **mesh: object) -> Model:
    """Return a thin slab glued to a shallow stiff layer that dies out within 0.13 m, loaded at a corner."""
    return Model.model_validate(
        {
            "plate": {"length_x": 10.0, "length_y": 10.0, "thickness": 0.15, "E": 30e9, "nu": 0.2},
            "ground": {"kind": "vlasov", "layers": [{"thickness": 0.5, "E": 100e6, "nu": 0.3}]},
            "beyond": {"kind": "infinite", **(beyond or {})},
            "contact": {"tensionless": False},
            "loads": [{"kind": "point", "P": 50e3, "x": 5.0, "y": 5.0}],
            "mesh": mesh,
        }
    )


def largest(results: CombinationResult) -> float:
    """Return the largest settlement [mm]."""
    return float(results.plate.settlement.max() * 1e3)


@pytest.fixture(scope="module")
def fine() -> float:
    """Return the largest settlement on a uniform mesh of 0.1 m, finer than the ground's decay [mm]."""
    return largest(solve(slab(counts=(100, 100))))


@pytest.mark.parametrize(("width", "size"), [(None, 0.6), (22.0, 1.25), (1.0, 1.25)])
def test_corner_load_on_shallow_stiff_soil(fine: float, width: float | None, size: float) -> None:
    """Elements ten times as long as the ground's decay settle within 1 % of a fine mesh, however wide the margin."""
    results = solve(slab({} if width is None else {"width": width}, size=size))
    assert largest(results) == pytest.approx(fine, rel=0.01)
    assert results.certificate.margin_effect is not None
    assert results.certificate.margin_effect < 1e-3


def test_the_plates_elements_are_fine_at_its_edges_only() -> None:
    """Beside the edges elements are shorter than the ground's decay, in the middle as large as allowed."""
    problem = discretize(slab(size=1.25))
    sides = np.ptp(problem.mesh.xy[problem.plate.elements], axis=1)
    decay = decay_length(problem.ground.column(1.0))
    at_corner = np.abs(problem.mesh.xy[problem.plate.elements]).max(axis=1).min(axis=1) == 5.0
    assert sides[at_corner].max() <= 0.7 * decay
    assert sides.max() > 1.0


def test_the_wider_mesh_has_the_same_elements_and_more() -> None:
    """The mesh on which the margin is judged is the same one and further ground, also around a plate of any shape."""
    shape = {"kind": "polygon", "points": [(0, 0), (6, 0), (6, 2), (2, 2.1), (2, 5), (0, 5)]}
    drawn = pasternak(None).replace(plate={"outline": shape, "thickness": 0.3, "E": 30e9, "nu": 0.2})
    for model in (pasternak(None), drawn):
        narrow, wide = discretize(model, margin=1.0).mesh, discretize(model, margin=2.0).mesh
        np.testing.assert_array_equal(wide.nodes[: len(narrow.nodes)], narrow.nodes)
        np.testing.assert_array_equal(wide.elements[: len(narrow.elements)], narrow.elements)
        width = np.ptp(narrow.nodes, axis=0) - (np.array([4.0, 4.0]) if model is not drawn else np.array([6.0, 5.0]))
        np.testing.assert_allclose(np.ptp(wide.nodes, axis=0) - np.ptp(narrow.nodes, axis=0), width)


def pasternak(width: float | None) -> Model:
    """Return a plate on ground that dies out over 7 m, with a margin of a width [m]."""
    return Model.model_validate(
        {
            "plate": {"length_x": 4.0, "length_y": 4.0, "thickness": 0.3, "E": 30e9, "nu": 0.2},
            "ground": {"kind": "pasternak", "k0": 1e6, "k1": 50e6},
            "beyond": {"kind": "infinite"} | ({} if width is None else {"width": width}),
            "loads": [{"kind": "point", "P": 1e5, "x": 1.0, "y": 1.0}, {"kind": "uniform", "q": 5e3}],
            "mesh": {"size": 0.5},
        }
    )


def test_a_margin_that_matters_fails_the_certificate() -> None:
    """Half a metre of ground that reaches out for seven changes settlements by a tenth: refused, with what to do."""
    right = solve(pasternak(20.0))
    assert right.certificate.margin_effect is not None
    assert right.certificate.margin_effect < 1e-4
    assert largest(solve(pasternak(None))) == pytest.approx(largest(right), rel=0.01)
    with pytest.raises(NotCertified, match=r"increase beyond\.width or reduce mesh\.size") as error:
        solve(pasternak(0.5))
    results = error.value.results
    assert abs(largest(results) / largest(right) - 1) > 0.05
    assert list(results.certificate.too_large()) == ["margin_effect"]
    section = summary.certificate_section(results)
    assert [row.key for row in section.rows if row.ok is False] == ["margin_effect"]
    assert "beyond.width" in section.notes[0]
    assert not to_json(results_of(results))["certified"]


@pytest.mark.parametrize("width", [1e-3, 0.1])
def test_a_margin_next_to_nothing_is_judged_by_a_decay_length(width: float) -> None:
    """Twice nothing is nothing: a very narrow margin is widened by what the ground needs to die out, and refused."""
    with pytest.raises(NotCertified) as error:
        solve(pasternak(width))
    assert error.value.results.certificate.margin_effect > 0.1


def test_a_rigid_block_on_point_supports_is_the_same_with_any_margin() -> None:
    """A block of 15 m on 0.5 m of rock, the margin 340 decay lengths wide: as with one of three, and of one."""

    def block(**beyond: Any) -> CombinationResult:
        corners = [(x, y) for x in (-15.0, 15.0) for y in (-7.5, 7.5)]
        supports = [{"kind": "point", "x": x, "y": y} for x, y in corners]
        return solve(
            Model.model_validate(
                {
                    "plate": {"length_x": 30.0, "length_y": 15.0, "thickness": 15.0, "E": 1.79e9, "nu": 0.0},
                    "ground": {"kind": "vlasov", "layers": [{"E": 6.24e9, "nu": 0.2, "thickness": 0.5}]},
                    "beyond": {"kind": "infinite", **beyond},
                    "supports": supports,
                    "loads": [
                        {"kind": "point", "P": 4.4e6, "M_x": 1.3e7, "x": 0.0, "y": 0.0},
                        {"kind": "uniform", "q": 33e3},
                        {"kind": "patch", "q": 3.3e8, "x": [3.0, 3.03], "y": [1.5, 1.515]},
                    ],
                    "mesh": {"size": 2.5},
                }
            )
        )

    wide, usual, three = (block(**beyond) for beyond in ({"width": 60.0}, {}, {"width": 0.53}))
    # beside the force at a point, whose settlement depends on the mesh; that of a narrow margin has smaller elements
    places = [(x, y) for x in (-15.0, -7.0, 2.0, 4.0, 15.0) for y in (-7.5, -2.0, 1.5, 7.5)]
    for other in (usual, three):
        for x, y in places:
            expected = wide.plate.value_at("settlement", x, y)
            found = other.plate.value_at("settlement", x, y)
            assert found == pytest.approx(expected, abs=0.005 * wide.plate.settlement.max())
    assert wide.certificate.margin_effect is not None
    assert wide.certificate.margin_effect < 1e-3


def test_edge_decay() -> None:
    """One surface dies out over sqrt(k1/k0); a stack that is cut into more layers hardly changes its length."""
    assert decay_length(single(4e6, 9e6)) == pytest.approx(1.5)
    assert decay_length(interface_stack(np.array([4e6]), np.array([9e6]))) == pytest.approx(1.5)
    whole = GroundLayer(2.0, (30e6, 0.0, 0.0), 0.3)
    few, many = (decay_length(consistent_stack(whole.split(n))) for n in (4, 16))
    assert few == pytest.approx(many, rel=0.1)
