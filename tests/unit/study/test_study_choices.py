"""Choices, one-at-a-time variants and targets of a study, and what it keeps for them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy import stats

from groundslab import Model, Plate, PointLoad, Winkler
from groundslab.analysis.driver import solve_combinations
from groundslab.errors import InputError
from groundslab.study.definition.outputs import RequestedOutput, nodal_values_of, scalar_of
from groundslab.study.definition.schema import StudyFile
from groundslab.study.definition.setup import Setup, setup_of
from groundslab.study.sampling.designs import list_variants

CASE = Model(
    plate=Plate(length_x=4.0, length_y=2.0, thickness=0.3, E=30e9, nu=0.2),
    ground=Winkler(k=30e6),
    loads=[PointLoad(P=100e3, x=1.0, y=0.5, width_x=0.5, width_y=0.5)],
)
K = {"path": "ground.k", "name": "k", "distribution": {"kind": "lognormal", "mean": 30e6, "cov": 0.3}}
P = {"path": "loads[1].P", "name": "P", "distribution": {"kind": "normal", "mean": 100e3, "cov": 0.1}}
T = {"path": "plate.thickness", "name": "t", "values": [0.2, 0.3, 0.4], "choose": True}
NU = {"path": "plate.nu", "name": "nu", "values": [0.0, 0.2], "choose": True}
W = {"name": "w", "of": "settlement", "take": "largest"}


def described(kind: str, vary: list[dict[str, Any]], **more: Any) -> Setup:
    """Return a study of the case."""
    sampling = {"kind": kind} | ({"count": 16} if kind not in ("tornado", "grid", "list") else {})
    return setup_of(StudyFile(case="case.toml", sampling=sampling, vary=vary, keep=[W], **more), CASE, from_file=False)


@pytest.mark.parametrize("kind", ["monte carlo", "latin hypercube", "sobol"])
def test_choices_are_solved_with_the_same_chance(kind: str) -> None:
    """Each design has the same drawn values and the same fields, and they are those of the study without choices."""
    field = {"path": "ground.k", "distribution": {"kind": "lognormal", "mean": 1.0, "cov": 0.3}}
    fields = [field | {"correlation_length": 2.0}]
    setup = described(kind, [P, T, NU], random_field=fields)
    made, plain = list_variants(setup), list_variants(described(kind, [P], random_field=fields))
    assert setup.count == len(made) == 16 * 6
    assert made.values[0] == plain.values[0] * 6
    assert made.values[1] == [t for t in (0.2, 0.3, 0.4) for _ in range(32)]
    assert made.values[2] == [nu for _ in range(3) for nu in (0.0, 0.2) for _ in range(16)]
    assert np.array_equal(made.seeds, np.tile(plain.seeds, (6, 1)))


def test_tornado_takes_one_variable_after_the_other() -> None:
    """Of d variables there are 1 + 2 d variants: the medians, then each one's 10 % and 90 % quantile by itself."""
    setup = described("tornado", [K, P])
    made = list_variants(setup)
    k, p = (variable.distribution for variable in setup.variables if variable.distribution is not None)
    assert setup.count == len(made) == 5
    assert made.values[0] == pytest.approx(k.ppf([0.5, 0.1, 0.9, 0.5, 0.5]), rel=1e-12)
    assert made.values[1] == pytest.approx(p.ppf([0.5, 0.5, 0.5, 0.1, 0.9]), rel=1e-12)
    assert p.ppf(0.9) == pytest.approx(100e3 * (1 + 0.1 * stats.norm.ppf(0.9)), rel=1e-12)


@pytest.mark.parametrize(
    ("kind", "vary", "more", "where"),
    [
        ("saltelli", [P, T], {}, "vary[2].choose"),
        ("tornado", [P, T], {}, "vary[2].choose"),
        ("grid", [T], {}, "vary[1].choose"),
        ("monte carlo", [P | {"choose": True}], {}, "vary[1].choose"),
        ("monte carlo", [P, K, T], {"correlation": [{"between": ["P", "t"], "rho": 0.5}]}, "vary[3].choose"),
        ("tornado", [{**T, "choose": False}], {}, "vary[1].values"),
        ("tornado", [P, K], {"correlation": [{"between": ["P", "k"], "rho": 0.5}]}, "correlation"),
        ("monte carlo", [P], {"limit_state": [{"name": "a", "keep": "w", "at_most": 1.0, "target": 1.5}]}, "target"),
    ],
)
def test_what_does_not_go_together_is_a_fault(kind: str, vary: Any, more: Any, where: str) -> None:
    """Choices and one-at-a-time variants where they mean nothing, and targets that are no probability, are refused."""
    with pytest.raises(InputError) as caught:
        described(kind, vary, **more)
    assert any(where in issue.location for issue in caught.value.issues)


def test_a_count_for_a_tornado_is_a_fault() -> None:
    """How many variants a tornado has follows from its variables."""
    with pytest.raises(InputError, match="two for each variable"):
        StudyFile(case="case.toml", sampling={"kind": "tornado", "count": 3}, vary=[P], keep=[W])


def test_targets_reach_the_limit_states() -> None:
    """A target is kept with its limit state, none where none is given."""
    limits = [
        {"name": "a", "keep": "w", "at_most": 0.01, "target": 0.05},
        {"name": "b", "keep": "w", "at_least": 0.0},
    ]
    assert [each.target for each in described("monte carlo", [P], limit_state=limits).limits] == [0.05, None]


@pytest.mark.slow
def test_tensile_stress_and_settlement_difference() -> None:
    """The stress is 6 m / t^2 of the principal moment that pulls most, with the thickness of each node's zone."""
    zone = {"thickness": 0.6, "shape": {"kind": "rectangle", "x": [0.0, 2.0], "y": [-1.0, 1.0]}}
    model = CASE.replace(plate=CASE.plate.replace(zones=[zone]))
    combined = solve_combinations(model)
    plate = next(iter(combined.results.values())).plate
    middle, half = (plate.moment_x + plate.moment_y) / 2, (plate.moment_x - plate.moment_y) / 2
    radius = np.hypot(half, plate.moment_xy)
    m = np.maximum(middle + radius, radius - middle)
    # nodes of the border stand once for each zone
    inside = plate.nodes[:, 0] > 1e-9
    outside = plate.nodes[:, 0] < -1e-9
    names = tuple(combined.results)

    def kept(of: str, take: Any, x: float | None = None, y: float | None = None) -> Any:
        made = nodal_values_of if take == "everywhere" else scalar_of
        return made(RequestedOutput(name="s", of=of, take=take, x=x, y=y), combined, names)

    stress = kept("tensile stress", "everywhere")
    assert stress[inside] == pytest.approx(6 * m[inside] / 0.6**2, rel=1e-12)
    assert stress[outside] == pytest.approx(6 * m[outside] / 0.3**2, rel=1e-12)
    assert kept("tensile stress", "largest") == stress.max() > 0
    node = int(np.argmax(np.where(inside, stress, 0)))
    assert kept("tensile stress", "at", *plate.nodes[node]) == pytest.approx(stress[node], rel=1e-9)
    assert kept("settlement difference", None) == np.ptp(plate.settlement)
