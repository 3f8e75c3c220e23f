"""Check a model without solving it."""

from __future__ import annotations

import math

from groundslab.discretize.discretize import discretize
from groundslab.fem.foundation import Column
from groundslab.model.combinations import place_patterns
from groundslab.model.consistency import estimate_elements
from groundslab.model.model import Model
from groundslab.model.plan_origin import move_to_center
from groundslab.solvers import factorization

#: `check` makes a mesh of at most so many elements,
MAX_CHECKED_ELEMENTS = 20_000
#: and looks for symmetry among at most so many loads.
MAX_COMPARED_LOADS = 10_000


def check(model: Model) -> None:
    """Validate a model: raise the errors that `solve` would raise before it solves anything.

    The arrays of a problem are made as for solving, but those of the loads, whose coordinates the model has checked
    already; of a mesh of more than MAX_CHECKED_ELEMENTS elements a coarser one is made.

    Parameters
    ----------
    model : Model
        The model.

    Raises
    ------
    InputError
        If the model describes no problem that can be solved.

    Examples
    --------
    >>> import groundslab
    >>> groundslab.check(model)
    """
    if model.analysis.solver != "auto":
        factorization.choose(model.analysis.solver)
    model = place_patterns(move_to_center(model))
    ratio = estimate_elements(model.plate, model.plates, model.mesh) / MAX_CHECKED_ELEMENTS
    if len(model.loads) > MAX_COMPARED_LOADS:
        model = model.model_copy(update={"mesh": model.mesh.replace(symmetry="off")})
    ground = discretize(model, max(0, math.ceil(math.log2(ratio) / 2)), loaded=False).ground
    if not isinstance(ground, Column):
        ground.first_column()
