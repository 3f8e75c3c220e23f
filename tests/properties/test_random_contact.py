"""Every problem that has a solution gets one: plates thin and thick, on ground that is stiff or yields or has voids.

`make test-random` tries many more.
"""

from __future__ import annotations

from collections import Counter
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy import sparse
from scipy.optimize import linprog

from groundslab.analysis.driver import solve
from groundslab.case.casefile import load
from groundslab.discretize.discretize import discretize
from groundslab.errors import IllConditioned, NeutralEquilibrium, NoEquilibrium
from groundslab.fem.problem import Problem, W
from groundslab.model.ground import Pasternak, Winkler
from groundslab.model.loads.load_types import PatchLoad, PointLoad, UniformLoad
from groundslab.model.model import Model
from groundslab.model.plate import Plate
from groundslab.model.settings import Contact, Mesh
from groundslab.model.supports import PointSupport
from groundslab.model.varying_ground import Void
from groundslab.results.results import CombinationResult
from groundslab.solvers import interior_point
from helpers.examples import examples
from helpers.paths import DATA

pytestmark = pytest.mark.slow

MODELS = examples(60)
FILES = sorted((DATA / "contact").glob("*.toml"))
#: What an iteration may take: tens of steps on each mesh; on coarse ones, on which all hangs on a few nodes, those of
#: an interior point method that stalls besides.
TENS = 100
STALLED = TENS + interior_point.MAX_STEPS


def random_model(seed: int) -> Model:
    """Return a plate drawn by lot; about one in ten has no equilibrium."""
    rng = np.random.default_rng(seed)

    def between(low: float, high: float) -> float:
        return float(f"{np.exp(rng.uniform(np.log(low), np.log(high))):.4g}")

    L = between(1, 40)
    B = L * float(rng.choice([0.1, 0.5, 1.0]))
    q = between(1e2, 1e5)
    loads: list[Any] = [UniformLoad(q=q)] if rng.random() < 0.6 else []
    total = q * L * B * len(loads)
    for _ in range(rng.integers(1, 4)):
        P = between(0.1, 2) * q * L * B * float(rng.choice([1, 1, 1, -0.3]))
        x, y = (float(side * value) for side, value in zip((L, B), rng.uniform(-0.5, 0.4, 2), strict=True))
        if rng.random() < 0.5:
            loads.append(PointLoad(P=P, x=x, y=y, M_x=P * L / 20 if rng.random() < 0.2 else 0.0))
        else:
            patch = {"x": (x, x + 0.1 * L), "y": (y, y + 0.1 * B)}
            loads.append(PatchLoad(q=P / (0.01 * L * B), **patch))
        total += P
    k0 = between(1e3, 1e10)
    ground = Winkler(k=k0) if rng.random() < 0.5 else Pasternak(k0=k0, k1=k0 * between(1e-4, 1e5))
    contact: dict[str, Any] = {}
    if rng.random() < 0.4 and total > 0:
        contact["limit_pressure"] = total / (L * B) * (1 + between(1e-3, 19))
    if rng.random() < 0.25:
        contact["gap"] = between(1e-4, 1e-1)
    if rng.random() < 0.3:
        void = {"x": (-L / 4, L / 4), "y": (-B / 4, B / 4)}
        contact["voids"] = [Void(**void, depth=between(1e-4, 1e2) if rng.random() < 0.5 else None)]
    supports = [
        PointSupport(
            x=float(rng.choice([-0.5, 0.0, 0.3]) * L),
            y=float(rng.choice([-0.5, 0.0, 0.3]) * B),
            acts=str(rng.choice(["in compression", "in tension"])),
            stiffness=between(1e4, 1e10) if rng.random() < 0.5 else None,
        )
        for _ in range(rng.integers(0, 3))
    ]
    places = {(each.x, each.y) for each in supports}
    return Model(
        plate=Plate(length_x=L, length_y=B, thickness=L * between(1e-4, 1), E=between(1e9, 1e11), nu=0.2),
        ground=ground,
        loads=loads,
        supports=supports if len(places) == len(supports) else [],
        contact=Contact(**contact),
        mesh=Mesh(size=B / float(rng.choice([3, 5, 8])) if B > 0.2 * L else B / 2),
    )


def room_for_balance(problem: Problem) -> float:
    """Return by how much forces can stay off zero and off their limits and still balance the loads; negative if not.

    A linear programme over single forces at the nodes, with no regard to how the program decides.
    """
    b, law = problem.contact.bearing, problem.contact.bearing.law
    use = np.flatnonzero(~law.bilateral & (law.limit_force > 0))
    up = np.where(b.support[use] < 0, 1.0, -law.sign[use])
    nodes = problem.mesh.nodes
    size, length = np.abs(problem.load[:, W]).sum() or 1.0, np.ptp(nodes, axis=0).max()
    places = nodes[b.node[use]] / length
    balance = np.vstack([up, up * places[:, 0], up * places[:, 1]])
    x, y = nodes.T / length
    F, turning = problem.load[:, 0], problem.load[:, 1:3] / length
    wanted = np.array([F.sum(), F @ x + turning[:, 0].sum(), F @ y + turning[:, 1].sum()]) / size
    capacity = law.limit_force[use] / size
    limited = np.isfinite(capacity)
    # forces p + r s, p >= 0, below capacity - r s, with r as large as it can be
    share = np.minimum(capacity, 1 / len(use))
    A = np.column_stack([balance, balance @ share])
    above = sparse.hstack([sparse.eye_array(len(use)), sparse.csr_array(2 * share[:, None])], format="csr")[limited]
    found = linprog(
        np.append(np.zeros(len(use)), -1.0), above, capacity[limited], A, wanted,
        bounds=[(0, None)] * len(use) + [(-1.0, 1.0)], method="highs",
    )  # fmt: skip
    return float(found.x[-1]) if found.status == 0 else -1.0


def settled(described: Model) -> CombinationResult | None:
    """Return the certified results within some tens of steps, nothing where a refusal is right."""
    steps: list[Any] = []
    try:
        results = solve(described, on_step=steps.append)
    except NeutralEquilibrium:
        return None
    except NoEquilibrium:
        assert room_for_balance(discretize(described)) < 1e-5
        return None
    except IllConditioned:
        assert not steps
        return None
    assert results.certificate.holds
    taken = Counter((step.unknowns, step.gamma, step.finest) for step in steps)
    assert all(count <= (TENS if finest else STALLED) for (*_, finest), count in taken.items())
    return results


@cache
def is_settled(seed: int) -> bool:
    """Return whether a random model has certified results."""
    return settled(random_model(seed)) is not None


@pytest.mark.parametrize("seed", range(MODELS))
def test_random_models_end_well(seed: int) -> None:
    """Certified in some tens of steps; refused only where a linear programme finds no balance, or by name."""
    is_settled(seed)


def test_a_coarser_mesh_does_not_decide_on_equilibrium() -> None:
    """Near its limit pressure the ground cannot balance the loads from the few nodes of a coarser mesh, and yet can."""
    described = random_model(473)
    assert room_for_balance(discretize(described)) > 0.01
    assert settled(described) is not None


def test_most_random_models_have_a_solution() -> None:
    """The lot is not drawn so that everything is refused."""
    assert sum(is_settled(seed) for seed in range(20)) >= 14


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_hard_files_end_well(path: Path) -> None:
    """Thin plates and ground at its limit, on which a plain iteration does not end; one is too thin for 16 digits."""
    assert (settled(load(path)) is None) is (path.stem == "too_thin_zone")
