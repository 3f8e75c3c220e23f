"""Why a published number cannot be right: arguments from equilibrium and from the published numbers themselves.

Each argument computes what it says and whether it holds; docs/paper.md tells them in full.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.results.results import CombinationResult

Run = Callable[[str], CombinationResult]


@dataclass(frozen=True, slots=True)
class Proof:
    """Whether an argument holds, and what it says."""

    holds: bool
    says: str


def most_carried(r: Array, w: Array, k0: float, k1: float) -> float:
    """Return the most [N] that ground can carry under a plate that settles by w(r) about its center [m].

    Wherever the contact ends, at a radius c: k0 times the volume inside, and at its rim the shear force of undisturbed
    ground outside, 2 pi c k1 a w(c) K1(a c) / K0(a c) with a = sqrt(k0 / k1), the exact decay outside a circle.
    """
    from scipy.special import kv

    c = np.linspace(1e-6, r[-1], 2000)
    settled = np.interp(c, r, w)
    inside = np.concatenate([[0.0], np.cumsum(np.diff(c) * (settled[1:] * c[1:] + settled[:-1] * c[:-1]) / 2)])
    carried = 2 * math.pi * k0 * inside
    if k1 > 0:
        a = math.sqrt(k0 / k1)
        carried += 2 * math.pi * c * k1 * a * np.maximum(settled, 0) * kv(1, a * c) / kv(0, a * c)
    return float(carried.max())


def depression(run: Run, model: str, x: list[float], published_mm: list[float]) -> Proof:
    """Hold the load against the most that the published profile can carry; our own profile must pass the same sum."""
    results = run(model)
    k0, k1 = results.constants.k0[0], results.constants.k1[0]
    ours = np.array([results.plate.value_at("settlement", place, 0.0) for place in x])
    load = results.certificate.load
    theirs = most_carried(np.array(x), np.array(published_mm) / 1e3, k0, k1)
    carried = most_carried(np.array(x), ours, k0, k1)
    return Proof(
        theirs < 0.85 * load < 0.95 * load < carried,
        f"no equilibrium: the printed profile, turned about the center, carries at most {theirs / 1e6:.2f} MN of the "
        f"{load / 1e6:.2f} MN applied; the same sum over our profile gives {carried / 1e6:.2f} MN",
    )


def off_the_curve(run: Run, model: str, x: list[float], published_mm: list[float], place: float) -> Proof:
    """Hold a value against the even polynomial through its neighbors; our own value must lie on ours."""
    results = run(model)
    at = np.array(x)
    others = at != place

    def miss(w: Array) -> float:
        powers = at[others, None] ** (2 * np.arange(others.sum()))
        smooth = np.linalg.solve(powers, w[others]) @ place ** (2 * np.arange(others.sum()))
        return float(abs(smooth - w[~others][0]))

    ours = miss(np.array([results.plate.value_at("settlement", value, 0.0) for value in x]) * 1e3)
    theirs = miss(np.array(published_mm))
    return Proof(
        theirs > 5 * ours,
        f"not on a smooth curve: it lies {theirs:.2f} mm off the even polynomial through its neighbors "
        f"(our value {ours:.2f} mm)",
    )


def below_the_mean(run: Run, model: str, published_mm: float, q: float) -> Proof:
    """Hold a largest settlement against the mean q / k, which every free plate on springs has under uniform load."""
    mean = q / run(model).constants.k0[0] * 1e3
    return Proof(
        published_mm < mean * (1 - 1e-3),
        f"no equilibrium: the mean settlement of a free plate on springs is q/k = {mean:.3f} mm at any thickness, and "
        "the largest cannot be smaller",
    )


def never_so_stiff(run: Run, models: list[str], published_mm: float) -> Proof:
    """Hold a settlement against the printed constants themselves, with every outer edge of the ground."""
    least = min(run(model).plate.value_at("settlement", 0.0, 0.0) for model in models) * 1e3
    return Proof(
        least > 1.05 * published_mm,
        f"not with the printed k0 and k1: whatever the ground's outer edge, they give at least {least:.3f} mm",
    )


def gamma_differs(run: Run, models: list[str]) -> Proof:
    """Show that plates of different stiffness have different gammas, where the paper prints the same one."""
    gammas = [run(model).constants.gamma or 0.0 for model in models]
    return Proof(
        max(gammas) > 1.1 * min(gammas),
        "not by (2.23): printed alike for a thin and a thick plate, whose settlements differ in shape; (2.23) gives "
        + " and ".join(f"{gamma:.4f}" for gamma in gammas),
    )


#: What a case file may name.
PROOFS: dict[str, Callable[..., Proof]] = {
    "depression": depression,
    "off the curve": off_the_curve,
    "below the mean": below_the_mean,
    "never so stiff": never_so_stiff,
    "gamma differs": gamma_differs,
}
