"""A made-up comparison of grounds, for tests of what is done with one; no equation was solved for it."""

from __future__ import annotations

from groundslab.analysis.ground_comparison.comparison import ComparedGround, GroundComparison
from groundslab.analysis.ground_comparison.figures import COMPARED_FIELDS, CURVE_FIELDS, FIGURES
from groundslab.model.ground import AnyGround, Continuum, Pasternak, Vlasov, Winkler
from groundslab.model.model import Model
from helpers import synthetic

LAYER = {"E": 30e6, "nu": 0.3, "thickness": 6.0}
GROUNDS: tuple[tuple[AnyGround, dict[str, float]], ...] = (
    (Continuum(layers=[LAYER]), {}),
    (Vlasov(layers=[LAYER]), {"k0": 7e6, "k1": 2e7, "gamma": 1.5}),
    (Pasternak(k0=5e6, k1=3e7), {"k0": 5e6, "k1": 3e7}),
    (Winkler(k=8e6), {"k": 8e6}),
)


def comparison(model: Model | None = None) -> GroundComparison:
    """Return a comparison in which all figures on ground number n, from 0, are 1 + n / 10 times those on the continuum.

    Moments m_y are next to nothing; beside x = 0 the line along x runs in an opening.
    """
    found = []
    for number, (ground, constants) in enumerate(GROUNDS):
        factor = 1 + number / 10
        figures = {name: factor * (1e-3 if "_y" in name else 0.5) for name in FIGURES}
        figures["largest_moment_y"] = factor * 20.0
        rms = dict.fromkeys(COMPARED_FIELDS, number / 10)
        middle = {"x": None, "y": factor}
        curves = {axis: dict.fromkeys(CURVE_FIELDS, (factor, middle[axis], 2 * factor)) for axis in "xy"}
        found.append(ComparedGround(ground, number > 1, constants, figures, rms, curves))
    lines = {"x": (-4.8, 0.0, 4.8), "y": (-3.6, 0.0, 3.6)}
    model = synthetic.model() if model is None else model
    return GroundComparison(model, "all loads", "characteristic", (0.0, 1.0), lines, tuple(found), ("A note.",))
