"""Constants of springs with which a slab settles most like on the continuum, by least squares."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from groundslab.analysis.driver import Variants
from groundslab.analysis.ground_comparison.figures import Samples, sample_within
from groundslab.analysis.ground_comparison.soil_column import on_ground
from groundslab.arrays import Array
from groundslab.fem.mesh import MeshLocations, locate
from groundslab.model.consistency import usual_size
from groundslab.model.ground import Pasternak, Winkler
from groundslab.model.model import Model

Springs = Winkler | Pasternak

#: Grounds whose constants are fitted, by their kinds: their constants k0, or k0 and k1, by their keys.
FITTED: dict[str, tuple[type[Springs], tuple[str, ...]]] = {
    "pasternak": (Pasternak, ("k0", "k1")),
    "winkler": (Winkler, ("k",)),
}
#: The meshed ground beyond the plate is as wide as the first constants need: from those found all are sought again.
ROUNDS = {"pasternak": 2, "winkler": 1}
#: Slopes are differences between constants that differ by this share.
DIFFERENCE = 1e-4
#: The constants are found to this share, or until a step lessens the sum of squares by less than the other one.
TOLERANCE, LEAST_GAIN = 1e-6, 1e-5
#: Constants are told apart if settlements change by this share of the largest one where they change by a factor of e.
LEAST_EFFECT = 5e-3
#: Constants are sought up to this factor above and below the first ones, in so many steps at most.
REACH, MOST_STEPS = 1e4, 30


def fit(kind: str, model: Model, start: Sequence[float], samples: Samples, settlement: Array) -> tuple[Springs, bool]:
    """Return the springs on which a model with one combination settles most like given values (p,) at samples [m].

    The integral over the plate of the square of the difference is least. `start` are k0 and k1 to begin with. Also
    returns whether the constants can be told apart.
    """
    springs, names = FITTED[kind]
    ground, determined = springs(**dict(zip(names, start, strict=False))), True
    for _ in range(ROUNDS[kind]):
        ratios, determined = _best_ratios(model, ground, names, samples, settlement)
        ground = ground.replace(
            **{name: getattr(ground, name) * ratio for name, ratio in zip(names, ratios, strict=True)}
        )
    return ground, determined


def _best_ratios(
    model: Model, first: Springs, names: Sequence[str], samples: Samples, settlement: Array
) -> tuple[list[float], bool]:
    """Return the ratios of the best constants to the first ones, whose mesh all have, and if they can be told apart."""
    from scipy.optimize import least_squares

    variants = Variants(_prepare(model, first))
    weights = samples.weights / np.abs(settlement).max()
    where: MeshLocations | None = None  # the samples are in the mesh that all trials have

    def residuals(x: Array) -> Array:
        nonlocal where
        factors = {f"ground.{name}": _constant(ratio) for name, ratio in zip(names, np.exp(x - 1), strict=True)}
        mesh, settled = variants.solve_settlement(variants.base.model, factors)
        where = where or locate(mesh, samples.places)
        fitted = sample_within(mesh, settled, where)
        # a place that a mesh with other chords of a curved edge does not reach counts nothing
        difference: Array = np.nan_to_num((fitted - settlement) * weights)
        return difference

    # unknowns are 1 + log(ratio), whose differences are relative to them
    start, reach = np.ones(len(names)), np.log(REACH)
    fitted = least_squares(
        residuals, start, bounds=(start - reach, start + reach), diff_step=DIFFERENCE,
        xtol=TOLERANCE, ftol=LEAST_GAIN, gtol=None, max_nfev=MOST_STEPS,
    )  # fmt: skip
    least = np.linalg.svd(fitted.jac, compute_uv=False).min()
    return np.exp(fitted.x - 1).tolist(), bool(least > LEAST_EFFECT)


def _prepare(model: Model, ground: Springs) -> Model:
    """Return a model on springs, whose mesh is not adaptive: settlements need no finer one than the first."""
    changes: dict[str, object] = {"symmetry": "off"}
    if model.mesh.adaptive:
        changes["size"] = max(usual_size(plate.sides) for plate in model.every_plate)
    return on_ground(model, ground).model_copy(update={"mesh": model.mesh.model_copy(update=changes)})


def _constant(ratio: float) -> Callable[[Array, Array], Array]:
    """Return a ratio as what it is at all places."""
    return lambda x, _: np.full(len(x), ratio)
