"""Discretization errors: in energy, carried from mesh to mesh, of values; footprints that the mesh does not see."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import groundslab
from groundslab.accuracy.energy import energy_errors, error_density
from groundslab.accuracy.judgment import BEAM_SHEAR, judge
from groundslab.accuracy.prolongation import make_prolongation
from groundslab.accuracy.resolution import find_unresolved
from groundslab.accuracy.singularities import limits_without_contact
from groundslab.accuracy.values import (
    AROUND,
    FASTEST_AROUND,
    RECOVERED,
    SLOWEST,
    SLOWEST_AROUND,
    error_of_contact_share,
    error_of_largest,
    estimate_error,
    estimate_errors,
)
from groundslab.analysis import nested
from groundslab.analysis.mesh_hierarchy import MeshHierarchy
from groundslab.fem.problem import BETA_X, BETA_Y, W
from groundslab.fem.shape_functions import areas
from groundslab.model.model import Model
from groundslab.results.mirroring import ResultMesh, make_result_mesh
from groundslab.results.recovery import expand, recover_fields
from groundslab.results.results import CombinationResult, Comparison
from groundslab.solvers import factorization
from groundslab.solvers.solution import Solution
from helpers import synthetic


def slab(**changes: Any) -> Model:
    """Return a small slab with a thicker zone under a uniform load."""
    zone = {"shape": {"kind": "rectangle", "x": (-1.0, 1.0), "y": (-1.0, 1.0)}, "thickness": 0.5}
    parts: dict[str, Any] = {
        "plate": {"length_x": 6.0, "length_y": 4.0, "thickness": 0.25, "E": 30e9, "nu": 0.2, "zones": [zone]},
        "ground": {"kind": "pasternak", "k0": 20e6, "k1": 5e6},
        "contact": {"tensionless": False},
        "loads": [{"kind": "uniform", "q": 1e4}],
        "mesh": {"size": 0.5, "symmetry": "off"},
    }
    return Model(**parts | changes)


def solved(model: Model) -> tuple[tuple[Solution, ResultMesh], tuple[Solution, ResultMesh]]:
    """Return the solutions on the finest mesh and on the next coarser one, each with its mesh of results."""
    hierarchy = MeshHierarchy(model, factorization.choose("auto")[1], 0, 1.0, False)
    found = nested.solve_nested(hierarchy, "", np.ones(1), lambda _: None)
    fine, coarse = ((each, make_result_mesh(model, each.system.problem)) for each in (found[0][-1], found[1][-1]))
    return fine, coarse


def bend(solution: Solution, power: int) -> None:
    """Set the deflection to a power of x, in place, without shear."""
    x = solution.system.problem.mesh.nodes[:, 0]
    solution.U[:] = 0.0
    solution.U[:, W], solution.U[:, BETA_X], solution.U[:, BETA_Y] = x**power, power * x ** (power - 1), 0.0


def test_what_elements_hold_exactly_has_no_error_in_energy() -> None:
    """Constant curvature, with a jump of the moments at the zone's border, which is no error."""
    model = slab(ground={"kind": "winkler", "k": 2e7})
    (fine, frame), _ = solved(model)
    bend(fine, 2)
    fields = recover_fields(fine, frame)
    bend(fine, 5)
    scale = energy_errors(model, fine, recover_fields(fine, frame)).sum()
    bend(fine, 2)
    assert energy_errors(model, fine, fields).sum() < 1e-12 * scale


def test_error_in_energy_falls_with_the_elements() -> None:
    """By a half at least from one mesh to the next."""
    patch = {"kind": "patch", "x": (-1.0, 1.5), "y": (-1.0, 0.5), "q": 1e5}
    results = groundslab.solve(slab(loads=[patch])).only
    assert results.comparison is not None
    assert 0 < results.comparison.energy_error < 0.1
    assert 0.1 < results.comparison.reduction < 0.6


def test_errors_of_the_elements_make_up_the_error_in_energy() -> None:
    """Squared and averaged over the area, on a plate with nothing beyond it; a concentrated load is where it peaks."""
    patch = {"kind": "patch", "x": (1.5, 2.0), "y": (-0.5, 0.0), "q": 1e6}
    results = groundslab.solve(slab(loads=[patch], ground={"kind": "winkler", "k": 2e7})).only
    density, comparison = results.elements.discretization_error, results.comparison
    assert density is not None
    assert comparison is not None
    assert comparison.elements.discretization_error is not None
    xy = results.plate.nodes[results.plate.elements]
    share = areas(xy) / areas(xy).sum()
    assert np.sqrt((density**2 * share).sum()) == pytest.approx(comparison.energy_error, rel=1e-9)
    assert np.hypot(*(xy[density.argmax(), 8] - (1.75, -0.25))) < 1.0
    assert density.max() > 3 * np.median(density)
    before = np.sqrt((comparison.elements.discretization_error**2 * share).sum())
    assert comparison.energy_error / before == pytest.approx(comparison.reduction, rel=1e-9)


def test_errors_of_the_elements_leave_out_the_ground_beyond() -> None:
    """The ground around the plate has a part of the error in energy, which belongs to no element of the plate."""
    results = groundslab.solve(slab(beyond={"kind": "margin", "width": 1.0})).only
    density = results.elements.discretization_error
    assert density is not None
    assert results.comparison is not None
    share = areas(results.plate.nodes[results.plate.elements])
    mean = np.sqrt((density**2 * share).sum() / share.sum())
    assert 0.1 * results.comparison.energy_error < mean < results.comparison.energy_error


def test_error_of_elements_of_different_size() -> None:
    """The same error spread evenly has one density everywhere, whatever the sizes of the elements are."""
    zone = {"shape": {"kind": "rectangle", "x": (-1.0, 0.8), "y": (-1.0, 1.0)}, "thickness": 0.5}
    plate = {"length_x": 6.0, "length_y": 4.0, "thickness": 0.25, "E": 30e9, "nu": 0.2, "zones": [zone]}
    (fine, frame), _ = solved(slab(plate=plate))
    of_elements = areas(frame.mesh.xy)
    assert of_elements.max() > 1.05 * of_elements.min()
    density = error_density(fine, frame, 1e-4 * of_elements / of_elements.sum(), 1.0)
    np.testing.assert_allclose(density, 1e-2, rtol=1e-12)
    assert not error_density(fine, frame, np.zeros(len(of_elements)), 0.0).any()


@pytest.mark.parametrize("counts", [(8, 6), (9, 7)])
def test_fields_of_the_coarser_mesh_at_the_nodes_of_the_finer(counts: tuple[int, int]) -> None:
    """A quadratic settlement is the same on both, whether the meshes are nested or not."""
    plate = {"length_x": 6.0, "length_y": 4.0, "thickness": 0.25, "E": 30e9, "nu": 0.2}
    (fine, frame), (coarse, own) = solved(slab(plate=plate, mesh={"counts": counts, "symmetry": "off"}))
    bend(coarse, 2)
    prolongation = make_prolongation(own, frame, (coarse.system.problem.mesh, fine.system.problem.mesh))
    plate_fields, elements, ground = expand(prolongation.apply(recover_fields(coarse, own)), frame)
    np.testing.assert_allclose(plate_fields.settlement, plate_fields.nodes[:, 0] ** 2, atol=1e-12)
    np.testing.assert_allclose(ground.settlement[0][: len(plate_fields.nodes)].max(), 9.0)
    np.testing.assert_allclose(plate_fields.area.sum(), 24.0)
    assert plate_fields.contact_share == pytest.approx(1.0)
    assert len(elements.moment_x) == len(plate_fields.elements)


def test_nothing_is_averaged_across_a_border() -> None:
    """On both sides of the zone's border the moments are those of their own thickness."""
    (fine, frame), (coarse, own) = solved(slab())
    bend(coarse, 2)
    prolongation = make_prolongation(own, frame, (coarse.system.problem.mesh, fine.system.problem.mesh))
    plate, elements, _ = expand(prolongation.apply(recover_fields(coarse, own)), frame)
    thickness, _ = elements.at_nodes(plate)
    D = 30e9 * thickness**3 / 12 / (1 - 0.04)
    np.testing.assert_allclose(plate.moment_x, -2 * D, rtol=1e-9)


def comparison(q: float) -> Comparison:
    """Return a comparison of meshes with so much of the error in energy left on the finer one."""
    parts = synthetic.results()
    return Comparison(parts.plate, parts.elements, parts.ground, (), parts.constants, energy_error=0.1, reduction=q)


def test_error_of_a_value() -> None:
    """A sequence that halves its error with each mesh is told its error; slow convergence is not believed."""
    assert estimate_error(1.1, 1.2, comparison(0.5)) == pytest.approx(0.1)
    assert estimate_error(1.1, 1.2, comparison(0.99)) == pytest.approx(0.1 * SLOWEST / (1 - SLOWEST))


def test_footprints_that_the_mesh_does_not_see() -> None:
    """The worst is told with its sides; elements as small as the footprint see it."""
    loads = [{"kind": "point", "P": 1e5, "x": 0.3, "y": 0.2, "width_x": 0.2, "width_y": 0.4}]
    coarse = find_unresolved(groundslab.solve(slab(loads=loads)).only)
    assert coarse is not None
    assert (coarse.count, coarse.footprint, coarse.element) == (1, pytest.approx(0.2), pytest.approx(0.5))
    assert find_unresolved(groundslab.solve(slab(loads=loads, mesh={"size": 0.2})).only) is None
    assert find_unresolved(groundslab.solve(slab()).only) is None


def compared(q: float, **reductions: np.ndarray) -> CombinationResult:
    """Return results with such a comparison, and such reductions around nodes."""
    return replace(synthetic.results(), comparison=replace(comparison(q), **reductions))


def test_the_largest_value_may_lie_where_another_one_is_uncertain() -> None:
    """Both meshes agree on the largest value; one beside it has changed so much that it may be the largest."""
    about = compared(0.5)
    values, coarser = np.array([1.0, 0.95, 0.1]), np.array([1.0, 0.80, 0.1])
    assert error_of_largest(about, "settlement", values, coarser) == pytest.approx(0.95 + 0.15 - 1.0)
    assert error_of_largest(about, "settlement", values[[0, 2]], coarser[[0, 2]]) == 0


@pytest.mark.parametrize(("size", "order"), [(0.5, 1.0), (None, RECOVERED)])
def test_meshes_that_agree_at_one_node_by_accident(size: float | None, order: float) -> None:
    """The moment there has the error of the elements that meet there; what is not asked for has no part in it.

    Recovered section forces converge faster where the mesh follows the borders of loads, pressures do not.
    """
    n = len(synthetic.results().plate.nodes)
    elements = synthetic.results().plate.elements
    about = compared(0.9, moment_reduction=np.full(n, 0.4), shear_reduction=np.full(n, 0.5))
    model = about.solved_model
    about = replace(about, solved_model=model.replace(mesh=model.mesh.replace(size=size)))
    values, coarser = np.ones(n), np.full(n, 1.2)
    coarser[elements[0, 8]] = 1.0
    errors = estimate_errors(about, "moment_x", values, coarser)
    alone = np.arange(n) == elements[0, 8]
    left = 0.2 * 0.4**order / (1 - 0.4**order)
    np.testing.assert_allclose(errors[~alone], left)
    np.testing.assert_allclose(errors[alone], AROUND * left)
    of_shear = 0.2 * 0.5**order / (1 - 0.5**order)
    np.testing.assert_allclose(estimate_errors(about, "shear_x", values, coarser)[~alone], of_shear)
    np.testing.assert_allclose(estimate_errors(about, "pressure", values, coarser)[~alone], 0.2 * 0.4 / 0.6)
    assert estimate_errors(about, "moment_x", values[alone], coarser[alone], alone) == 0


@pytest.mark.parametrize(("reduction", "believed"), [(0.05, FASTEST_AROUND), (0.95, SLOWEST_AROUND)])
def test_orders_that_are_not_believed(reduction: float, believed: float) -> None:
    """Moments converge neither faster nor slower than between bounds, whatever the energy says around them."""
    n = len(synthetic.results().plate.nodes)
    about = compared(0.5, moment_reduction=np.full(n, reduction), shear_reduction=np.full(n, 0.5))
    errors = estimate_errors(about, "moment_y", np.ones(n), np.full(n, 1.1))
    np.testing.assert_allclose(errors, 0.1 * believed / (1 - believed))


def test_what_is_nowhere_positive_stays_so() -> None:
    """The least gap is zero where the plate rests on the ground, whatever the errors of gaps elsewhere are."""
    gaps, coarser = np.array([0.0, 1e-6, 2e-3]), np.array([0.0, 5e-6, 1e-3])
    assert error_of_largest(compared(0.5), "gap", -gaps, -coarser) == 0
    assert error_of_largest(compared(0.5), "gap", gaps, coarser) == pytest.approx(1e-3)


def test_errors_are_judged_against_what_governs_over_all_combinations() -> None:
    """A light combination beside a heavy one has small shares; an uplift counts beside the largest displacement."""
    cases = [{"name": "heavy"}, {"name": "light"}]
    patch = {"kind": "patch", "x": (-1.0, 1.5), "y": (-1.0, 0.5)}
    loads = [patch | {"q": 1e6, "case": "heavy"}, patch | {"q": 1e4, "case": "light"}]
    contact = {"tensionless": True}
    results = groundslab.solve(slab(cases=cases, loads=loads, contact=contact))
    heavy, light = results.values()
    assert heavy.largest == light.largest
    assert heavy.largest is not None
    worst = judge(heavy)[0]
    same = next(value for value in judge(light) if value.label == worst.label and value.value * worst.value > 0)
    assert same.share == pytest.approx(worst.share / 100, rel=1e-6)
    gap = next(value for value in judge(heavy) if value.label.startswith("gap"))
    alone = error_of_largest(heavy, "gap", heavy.plate.gap, heavy.coarser.plate.gap)  # type: ignore[union-attr]
    assert heavy.largest.displacement == max(np.abs(heavy.plate.settlement).max(), heavy.plate.gap.max())
    assert gap.share == pytest.approx(alone / heavy.largest.displacement)


def ribbed(ground: dict[str, Any], **parts: Any) -> Model:
    """Return a slab of 0.25 m with a rib of 0.6 m across, from edge to edge, and a load on it."""
    section = {"kind": "rib", "width": 0.6, "height": 0.6, "effective_width": 1.5}
    return Model.model_validate(
        {
            "plate": {"length_x": 6.0, "length_y": 4.0, "thickness": 0.25, "E": 33e9, "nu": 0.2},
            "ground": ground,
            "beams": [{"name": "r", "points": [(-2.0, 0.0), (2.0, 0.0)], "section": section}],
            "loads": [{"kind": "point", "P": 1e5, "x": 0.0, "y": 0.0}, {"kind": "uniform", "q": 1e4}],
            "mesh": {"counts": (24, 16)},
            **parts,
        }
    )


SHEARED = {"kind": "pasternak", "k0": 2e7, "k1": 1e7}


def test_shear_forces_over_webs_and_at_ends_of_ribs_are_not_judged() -> None:
    """Over 0.3 m on each side of the axis they are the rib's; its end is as wide as its web, for pressures too."""
    model = ribbed(SHEARED)
    places = np.array([(1.0, 0.0), (1.0, 0.29), (1.0, 0.31), (2.5, 0.0), (2.6, 0.0)])
    limits = limits_without_contact(model, places)
    assert limits.shear_forces.tolist() == [False, False, True, False, True]
    places = np.array([(1.0, 0.2), (1.0, 0.3), (2.5, 0.0), (2.6, 0.0)])
    assert limits_without_contact(model, places).pressures.tolist() == [False, True, False, True]


def test_shear_of_a_beam_is_judged_away_from_forces_without_a_footprint() -> None:
    """Its largest value is right beside the force; what is judged is a slab's thickness farther on, and less."""
    results = groundslab.solve(ribbed({"kind": "winkler", "k": 3e7})).only
    (beam,) = results.beams
    (judged,) = (value for value in judge(results) if value.label == BEAM_SHEAR)
    assert judged.place is not None
    assert abs(judged.place[0]) > 0.25
    part = beam.between_ends(0.25)
    assert judged.value == pytest.approx(np.abs(part.shear[np.abs(part.way - 2.0) > 0.2501]).max())
    assert judged.value < 0.9 * np.abs(part.shear).max()
    assert len(judged.around)


def test_least_pressures_are_judged_where_they_may_be_below_zero() -> None:
    """Under a load that presses all of the slab they are far above; where a load at an edge lifts it they are not."""

    def least(loads: list[dict[str, Any]]) -> list[float]:
        results = groundslab.solve(ribbed({"kind": "winkler", "k": 3e7}, loads=loads, contact={"tensionless": False}))
        return [value.value for value in judge(results.only) if value.label == "pressure p" and value.sign < 0]

    assert least([{"kind": "uniform", "q": 1e4}]) == []
    (pulled,) = least([{"kind": "point", "P": 1e5, "x": 2.8, "y": 0.0, "width_x": 0.3, "width_y": 0.3}])
    assert pulled < 0


@pytest.mark.parametrize(("second", "found"), [(0.95, True), (0.6, False)])
def test_elements_become_smaller_at_the_next_largest_values_too(second: float, found: bool) -> None:
    """Under a column with nearly the largest load the moment would be the largest, and as far off, on the next mesh."""
    columns = [
        {"kind": "point", "P": P, "x": x, "y": 0.0, "width_x": 0.4, "width_y": 0.4}
        for x, P in ((-2.0, 1e5), (2.0, second * 1e5))
    ]
    model = ribbed({"kind": "winkler", "k": 3e7}, loads=columns, beams=[], mesh={"counts": (12, 8)})
    values = [value for value in judge(groundslab.solve(model).only) if value.label == "moment m_x" and value.sign > 0]
    (largest,) = values
    assert (largest.coarse[:, 0] < 0).any()
    assert (largest.coarse[:, 0] > 0).any() == found


def test_forces_of_beams_that_are_nothing_beside_the_slab_are_no_errors() -> None:
    """A ring under an even load around has no shear force: its noise counts beside a tenth of a strip of the slab."""
    circle = {"kind": "circle", "radius": 2.5}
    model = ribbed(
        {"kind": "winkler", "k": 3e7},
        plate={"outline": {"kind": "circle", "radius": 3.0}, "thickness": 0.25, "E": 33e9, "nu": 0.2},
        beams=[{"name": "ring", "shape": circle, "section": {"kind": "rectangle", "width": 0.4, "height": 0.6}}],
        loads=[{"kind": "line", "q": 8e4, "shape": circle}],
        mesh={"size": 0.5},
    )
    results = groundslab.solve(model).only
    (ring,) = results.beams
    (judged,) = (value for value in judge(results) if value.label == BEAM_SHEAR)
    slab_shear = np.hypot(results.plate.shear_x, results.plate.shear_y).max()
    assert np.abs(ring.shear).max() < 0.01 * 0.25 * slab_shear
    assert judged.share < 0.1


def test_a_smooth_part_of_a_slab_converges_faster_than_a_singular_one() -> None:
    """Around a force without a footprint elements half as large gain less than away from it."""
    force = {"kind": "point", "P": 1e5, "x": -1.5, "y": 0.0}
    results = groundslab.solve(slab(loads=[force])).only
    assert results.comparison is not None
    reduction = results.comparison.moment_reduction
    assert reduction is not None
    distance = np.hypot(results.plate.nodes[:, 0] + 1.5, results.plate.nodes[:, 1])
    assert reduction[distance < 0.3].mean() > reduction[distance > 2.0].mean() + 0.1


def test_shear_forces_that_have_a_kink_within_elements_converge_more_slowly_than_moments() -> None:
    """Where the border of a load cuts elements; on a line of the mesh they do not."""
    reductions = []
    for x in (1.3, 1.5):
        patch = {"kind": "patch", "x": (-x, x), "y": (-2.0, 2.0), "q": 1e5}
        plate = {"length_x": 6.0, "length_y": 4.0, "thickness": 0.25, "E": 30e9, "nu": 0.0}
        ground = {"kind": "winkler", "k": 2e7}
        results = groundslab.solve(slab(plate=plate, loads=[patch], ground=ground, mesh={"counts": (24, 16)})).only
        assert results.comparison is not None
        assert results.comparison.shear_reduction is not None
        there = np.abs(results.plate.nodes[:, 0] - 1.25) < 0.3
        reductions.append(float(results.comparison.shear_reduction[there].mean()))
    assert reductions[0] > reductions[1] + 0.1


def strip_that_lifts_off(ground: dict[str, object], size: float) -> tuple[float, float, float]:
    """Return the share in contact of a strip that lifts off beyond a line across it, its error, and a row of nodes."""
    plate = {"length_x": 6.0, "length_y": 1.0, "thickness": 0.25, "E": 30e9, "nu": 0.0}
    loads = [{"kind": "patch", "x": (-3.0, -2.0), "y": (-0.5, 0.5), "q": 1e5}]
    parts = {"contact": {"tensionless": True}, "mesh": {"size": size, "symmetry": "off"}}
    results = groundslab.solve(slab(plate=plate, loads=loads, ground=ground, **parts)).only
    rows = np.unique(results.plate.nodes[results.plate.in_contact, 0])
    assert 0.1 < results.plate.contact_share < 0.9
    return results.plate.contact_share, error_of_contact_share(results) or 0.0, (rows[-1] - rows[-2]) / 6.0


def test_the_share_in_contact_is_known_to_a_row_of_nodes() -> None:
    """On ground with shear: about the row of nodes at the line, over the strip's length."""
    _, error, row = strip_that_lifts_off({"kind": "pasternak", "k0": 20e6, "k1": 5e6}, 0.25)
    assert 0.5 * row < error < 1.1 * row


@pytest.mark.parametrize("size", [0.5, 0.33, 0.25, 0.1])
def test_the_share_in_contact_is_known_within_elements_on_springs(size: float) -> None:
    """On springs: to a small part of that row, and what is told holds the value on elements far smaller."""
    share, error, row = strip_that_lifts_off({"kind": "winkler", "k": 2e7}, size)
    truth, *_ = strip_that_lifts_off({"kind": "winkler", "k": 2e7}, 0.04)
    assert abs(share - truth) < error < 0.3 * row


@pytest.mark.parametrize("x", [1.3, 1.6, 2.0])
@pytest.mark.parametrize("counts", [(15, 10), (24, 16), (47, 31)])
def test_the_share_in_contact_of_a_rigid_plate(x: float, counts: tuple[int, int]) -> None:
    """A rigid plate under a force beyond its kern, on springs: three times the distance from the edge."""
    plate = {"length_x": 6.0, "length_y": 4.0, "thickness": 6.0, "E": 30e12, "nu": 0.0}
    force = {"kind": "point", "P": 1e6, "x": x, "y": 0.0, "width_x": 0.4, "width_y": 0.4}
    parts = {"contact": {"tensionless": True}, "mesh": {"counts": counts, "symmetry": "off"}}
    results = groundslab.solve(slab(plate=plate, loads=[force], ground={"kind": "winkler", "k": 2e7}, **parts)).only
    error = error_of_contact_share(results) or 0.0
    assert abs(results.plate.contact_share - 3 * (3.0 - x) / 6.0) < error < 0.003
