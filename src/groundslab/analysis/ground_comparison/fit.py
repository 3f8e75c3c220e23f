"""Constants of springs with which a slab settles most like on the continuum, by least squares."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from groundslab.analysis.driver import Variants
from groundslab.analysis.ground_comparison.figures import Samples, sample
from groundslab.arrays import Array
from groundslab.model.consistency import SHORT_SIDE_ELEMENTS
from groundslab.model.ground import AnyGround, Pasternak, Winkler
from groundslab.model.model import Model

#: Grounds whose constants are fitted, by their kinds: how many there are, of k0 and k1, and what makes a ground of them.
FITTED: dict[str, tuple[int, Callable[..., AnyGround]]] = {
    "pasternak": (2, lambda k0, k1: Pasternak(k0=k0, k1=k1)),
    "winkler": (1, lambda k: Winkler(k=k)),
}
#: Slopes are differences between constants that differ by about this share: meshes differ a little with them, too.
DIFFERENCE = 0.02
#: The constants are found to this share, or until a step lessens the sum of squares by a smaller share than the other one.
TOLERANCE, LEAST_GAIN = 1e-6, 1e-5
#: Constants are sought up to this factor above and below the first ones.
REACH = 1e4
MOST_SOLUTIONS = 30


def fit(
    model: Model, start: Sequence[float], make: Callable[..., AnyGround], samples: Samples, settlement: Array
) -> AnyGround:
    """Return the ground on which a model with one combination settles most like given values (p,) at samples [m].

    The integral over the plate of the square of the difference is least. `start` are the constants to begin with.
    """
    from scipy.optimize import least_squares

    first, weights = np.log(start), samples.weights / np.abs(settlement).max()
    variants = Variants(_on_given_mesh(model).model_copy(update={"ground": make(*start)}))

    def residuals(logs: Array) -> Array:
        on_these = variants.base.model.model_copy(update={"ground": make(*np.exp(logs).tolist())})
        found = sample(variants.solve_combinations(on_these).only.plate, "settlement", samples.places)
        # a place that a mesh with other chords of a curved edge does not reach counts nothing
        return np.nan_to_num((found - settlement) * weights)

    best = least_squares(
        residuals,
        first,
        bounds=(first - np.log(REACH), first + np.log(REACH)),
        diff_step=DIFFERENCE / np.abs(first),
        xtol=TOLERANCE / np.abs(first).max(),
        ftol=LEAST_GAIN,
        gtol=None,
        max_nfev=MOST_SOLUTIONS,
    )
    return make(*np.exp(best.x).tolist())


def _on_given_mesh(model: Model) -> Model:
    """Return a model whose mesh is not adaptive: settlements need no finer one than the first."""
    if not model.mesh.adaptive:
        return model
    size = min(model.plate.sides) / SHORT_SIDE_ELEMENTS
    return model.model_copy(update={"mesh": model.mesh.model_copy(update={"size": size})})
