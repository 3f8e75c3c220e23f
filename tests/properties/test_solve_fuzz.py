"""Whatever is asked for in sound words ends in a certified result or a clear and true refusal."""

from __future__ import annotations

import contextlib
import json
import re
import shutil
import warnings
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from scipy import sparse
from scipy.optimize import linprog

from groundslab.analysis.driver import solve, solve_combinations
from groundslab.discretize.discretize import discretize
from groundslab.errors import EditedFilesKept, GroundslabError, InputError, NoEquilibrium
from groundslab.fem.problem import BETA_X, TOP, Problem, W
from groundslab.model.combinations import list_combinations
from groundslab.model.loads.load_types import UniformLoad
from groundslab.model.model import Model
from groundslab.solvers.equilibrium import require_equilibrium
from groundslab.views.files import results_folder
from helpers import synthetic
from helpers.examples import examples
from helpers.strategies import models, rich_models

pytestmark = pytest.mark.slow

FUZZ = settings(deadline=None, derandomize=True, database=None, suppress_health_check=list(HealthCheck))


@settings(FUZZ, max_examples=examples(16))
@given(models())
def test_any_model_ends_in_a_certified_result_or_a_clear_error(model):
    """Of random models of all kinds none crashes, warns, or gives a result that does not fulfil the equations.

    An ordinary one, without misprinted formulas and with a load that can be balanced, does give a result.
    """
    try:
        results = solve(model)
    except GroundslabError as error:
        said = str(error)
        results = None
    if results is not None:
        assert results.certificate.holds
        assert all(abs(value) < float("inf") for value in results.plate.settlement)
        return
    assert len(said) > 20
    if getattr(model.ground, "formulas", "exact") != "as printed":
        with pytest.raises(GroundslabError):
            require_equilibrium(discretize(model))


def room(problem: Problem) -> float:
    """Return by how much bearings and held nodes can balance the loading, each away from its limits; below 0 if not.

    An independent judge: the linear programme of all single forces and moments with the three equations of equilibrium,
    in shares of the load, of which the least distance from both limits of every force, as a share of what it can bear,
    is made as large as possible.
    """
    if not problem.contact.tensionless:
        return 1.0
    if not problem.load[:, :TOP].any():
        return 0.0
    two_sided, one_sided, capacity, wanted = equilibrium(problem)
    # forces are r = t * share + s with s >= 0 and r <= capacity - t * share
    m, n = two_sided.shape[1], one_sided.shape[1]
    share = np.minimum(capacity, 1 / max(n, 1))
    A = np.hstack([two_sided, one_sided, (one_sided @ share)[:, None]])
    above = sparse.hstack([sparse.csr_array((n, m)), sparse.eye_array(n), sparse.csr_array(2 * share[:, None])])
    bounds = [(None, None)] * m + [(0, None)] * n + [(None, 1.0)]
    found = linprog(np.append(np.zeros(m + n), -1.0), A_eq=A, b_eq=wanted, A_ub=above if n else None,
                    b_ub=capacity if n else None, bounds=bounds, method="highs")  # fmt: skip
    return float(-found.fun) if found.status == 0 else -1.0


def balanced_share(problem: Problem) -> float:
    """Return the largest share of the loading that bearings and held nodes balance where it acts."""
    two_sided, one_sided, capacity, wanted = equilibrium(problem)
    A = np.hstack([two_sided, one_sided, -wanted[:, None]])
    bounds = [(None, None)] * two_sided.shape[1] + [(0.0, each) for each in capacity] + [(0.0, None)]
    found = linprog(np.append(np.zeros(A.shape[1] - 1), -1.0), A_eq=A, b_eq=np.zeros(3), bounds=bounds, method="highs")
    return float(-found.fun)


def equilibrium(problem: Problem) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return what unit forces that may push and pull, and such that may push, add to the three sums of the loading.

    (3, m) and (3, n), with what each of the n can bear (n,) and the sums that are to be balanced (3,), as shares of all
    loads.
    """
    b, law, nodes = problem.contact.bearing, problem.contact.bearing.law, problem.mesh.nodes
    size = np.ptp(nodes[problem.plate.nodes], axis=0).max()
    F = problem.load[:, :TOP] * [1.0, 1 / size, 1 / size]
    total = np.abs(F).sum()

    def rows(node: np.ndarray, field: np.ndarray) -> np.ndarray:
        x, y = (nodes[node] / size).T
        force = field == W
        return np.array([force * 1.0, force * x + (field == BETA_X), force * y + (field == BETA_X + 1)])

    place, kind = np.nonzero(problem.unknown[:, :TOP] < 0)
    free = np.isin(place, problem.plate.nodes)
    if not problem.plate.element.center_w:
        free &= ~(np.isin(place, problem.mesh.elements[problem.plate.elements, 8]) & (kind == W))
    two_sided = np.hstack([rows(place[free], kind[free]), rows(b.node[law.bilateral], b.field[law.bilateral])])
    use = ~law.bilateral & (law.limit_force > 0)
    up = np.where(b.support[use] < 0, 1.0, -law.sign[use])  # the ground pushes up whatever the sign of its gap
    one_sided = rows(b.node[use], np.full(use.sum(), W)) * up
    capacity = np.minimum(law.limit_force[use] / total, 1e3)
    wanted = rows(np.arange(len(nodes)), np.full(len(nodes), W)) @ F[:, 0] + [0.0, *F[:, 1:].sum(axis=0)]
    return two_sided, one_sided, capacity, wanted / total


#: Models with more nodes are left out: what is refused, or certified, does not depend on how fine a mesh is.
MANY_NODES = 1200


def judge(model: Model) -> tuple[int, int]:
    """Solve combinations, hold each to its promise and each refusal to the linear programme; return the counts."""
    problem = discretize(model)
    assume(len(problem.mesh.nodes) <= MANY_NODES)
    wanted = list_combinations(model)
    combined = solve_combinations(model)
    assert [each.name for each in combined.combinations] == [each.name for each in wanted]
    for combination in wanted:
        given_factors = dict(combination.factors)
        factors = np.array([given_factors.get(case.name, 0.0) for case in model.cases] or [1.0])
        under = problem.combine(factors)
        refusal = combined.refused.get(combination.name)
        if refusal is None:
            assert combined.results[combination.name].certificate.holds
            assert room(under) > -1e-6
        else:
            assert isinstance(refusal, NoEquilibrium), repr(refusal)[:300]
            assert room(under) < 1e-4, refusal
            is_true(refusal, under)
    return len(combined.results), len(combined.refused)


def is_true(refusal: NoEquilibrium, problem: Problem) -> None:
    """Hold what a refusal says of the loads to the loads."""
    x, y = problem.mesh.nodes.T
    F = problem.load[:, W]
    moments = F @ x + problem.load[:, BETA_X].sum(), F @ y + problem.load[:, BETA_X + 1].sum()
    size = np.abs(F).sum()
    said = str(refusal)
    if "do not press the plate down" in said:
        assert F.sum() <= 1e-8 * size
    elif "topple the plate" in said:
        from shapely import MultiPoint, Point

        hull = MultiPoint(problem.mesh.nodes[problem.plate.nodes]).convex_hull
        place = [0.0 if mirrored else M / F.sum() for M, mirrored in zip(moments, problem.symmetry, strict=True)]
        inside = hull.buffer(-1e-6 * np.sqrt(hull.area))
        assert not inside.contains(Point(place)), said
    elif "more than ground and supports can carry" in said:
        law, b = problem.contact.bearing.law, problem.contact.bearing
        assert law.limit_force[~law.bilateral & ((b.support < 0) | (law.sign < 0))].sum() <= F.sum() * (1 + 1e-5)
    elif share := re.search(r"can balance where they act: ([\d.]+) % of them", said):
        assert float(share[1]) / 100 == pytest.approx(balanced_share(problem), abs=1e-4)
    else:
        assert "cannot be balanced" in said


@settings(FUZZ, max_examples=examples(25))
@given(rich_models())
def test_supports_and_combinations_end_in_certified_results_or_true_refusals(model):
    """With supports, limits, cavities and every kind of load, each combination is solved, or rightly refused."""
    # refused as a whole: a void between the nodes, rigid supports that differ where they meet
    with contextlib.suppress(InputError):
        judge(model)


@pytest.mark.parametrize(
    ("contact", "x", "said"),
    [
        # carries at most 1e5 Pa on about 2 (2 m - 1.5 m) x 4 m
        ({"limit_pressure": 1e5}, 1.5, r"40 % of them bring contact\.limit_pressure to the limit"),
        # nothing under the load but a cavity
        (
            {"voids": [{"x": (-2, 1.0), "y": (-2, 2)}]},
            0.5,
            "cannot be balanced: their resultant of 1000 kN acts on the plate",
        ),
    ],
)
def test_a_load_on_the_plate_that_nothing_can_carry(contact: dict[str, object], x: float, said: str) -> None:
    """A resultant that acts on the plate is not said to act outside it, where yielding or missing ground fails it."""
    model = Model(
        plate={"length_x": 4, "length_y": 4, "thickness": 0.3, "E": 3e10, "nu": 0.2},
        ground={"kind": "winkler", "k": 2e7},
        contact=contact,
        loads=[{"kind": "point", "P": 1e6, "x": x, "y": 0}],
        mesh={"counts": (8, 8)},
    )
    with pytest.raises(NoEquilibrium, match=said):
        solve(model)


def test_a_slab_that_curls_off_the_ground_between_supports() -> None:
    """Ground presses with newtons beside supports that hold a slab with 100 kN: none of its nodes pulls, and it counts.

    Clamped along one side, held both ways along a line, it shrinks more below than above, and leans on 1 % of its area.
    """
    held = {"stiffness": 8e8, "acts": "both ways"}
    model = Model(
        plate={
            "length_x": 2, "length_y": 9.5, "thickness": 0.333, "E": 23.3e9, "nu": 0.0, "edges": {"right": "clamped"},
        },
        ground={"kind": "pasternak", "k0": 4e7, "k1": 4e6},
        beyond={"kind": "infinite"},
        contact={"voids": [{"x": (0.75, 1.0), "y": (1.8, 4.75)}]},
        supports=[
            {"kind": "point", "x": 0.25, "y": -2.375, **held},
            {"kind": "line", "points": [(0.75, -4.75), (0.75, 2.375)], **held},
        ],
        loads=[{"kind": "uniform", "q": 1e3}, {"kind": "shrinkage", "top": 3.4e-4, "bottom": -4.05e-4}],
        mesh={"size": 2.0},
    )  # fmt: skip
    results = solve(model)
    assert results.certificate.holds
    assert 0 < results.plate.contact_share < 0.02
    assert results.plate.pressure.min() >= -1e-9 * results.plate.pressure.max()


@pytest.mark.parametrize("tensionless", [True, False])
def test_a_case_without_loads(tensionless: bool) -> None:
    """A case in which nothing acts is refused where nothing holds the plate, and else gives nothing, certified."""
    data = {
        "plate": {"length_x": 4, "length_y": 4, "thickness": 0.3, "E": 3e10, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 2e7},
        "contact": {"tensionless": tensionless},
        "cases": [{"name": "full"}, {"name": "empty"}],
        "loads": [UniformLoad(q=1e4, case="full")],
        "mesh": {"counts": (4, 4)},
    }
    combined = solve_combinations(Model(**data))
    if tensionless:
        assert isinstance(combined.refused["empty"], NoEquilibrium)
    else:
        assert combined.results["empty"].certificate.holds
        assert not combined.results["empty"].plate.settlement.any()


#: Names below a folder: those that groundslab uses, those of others, and in between.
NAMES = st.sampled_from([
    "plate.vtu", "results.npz", "case.toml", "summary.json", "picture.png", "combinations.csv", "tables/tilt.csv",
    "01-a/plate.vtu", "increments/01-plate.vtu", "thesis.odt", "tables/thesis.odt", "01-a/mine.vtu", "Plate.vtu",
    ".DS_Store", "deep/er/plate.vtu", "../beside.txt", "../raft-results/x", "plate.vtu/", "",
])  # fmt: skip
CONTENT = b"\0 somebody's work"


@settings(FUZZ, max_examples=examples(15))
@given(there=st.sets(NAMES, max_size=4), listed=st.sets(NAMES, max_size=6), ours=st.booleans())
def test_writing_results_destroys_nobodys_work(tmp_path_factory, there, listed, ours):
    """Whatever lies in a folder and whatever its summary says, no byte of others is lost; else results are there."""
    above = tmp_path_factory.mktemp("fuzz")
    folder = above / "raft"
    if ours:
        results_folder.save_results(synthetic.results(), folder)
    mine: list[Path] = []
    for name in there:
        path = folder / name
        if name and not name.endswith("/") and not path.exists() and not path.parent.is_file():
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(CONTENT)
            if path.name != ".DS_Store":
                mine.append(path.resolve())
    summary = folder / "summary.json"
    if summary.is_file() and summary.resolve() not in mine:
        document = json.loads(summary.read_text())
        summary.write_text(json.dumps(document | {"files": sorted({*document["files"], *listed})}))
    with contextlib.suppress(InputError), warnings.catch_warnings():
        # a summary that lists other files was edited: it is kept beside the folder
        warnings.simplefilter("ignore", EditedFilesKept)
        results_folder.save_results(synthetic.results(lifts=False), folder)
        assert len(results_folder.load_results(folder).results) == 1
    assert all(path.read_bytes() == CONTENT for path in mine)
    assert not [path for path in above.iterdir() if path.name.startswith(".")]
    shutil.rmtree(above)
