"""Check a model without solving it."""

from __future__ import annotations

import math

from groundslab.discretize.discretize import discretize
from groundslab.errors import NoEquilibrium
from groundslab.fem.foundation import Column
from groundslab.fem.problem import Problem
from groundslab.model.combinations import as_solved, case_factors, list_combinations
from groundslab.model.consistency import estimate_elements
from groundslab.model.model import Model
from groundslab.model.plan_origin import move_to_center
from groundslab.schema.issues import require
from groundslab.solvers import factorization
from groundslab.solvers.equilibrium import require_equilibrium

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
    require(model, Model, name="model")
    if model.analysis.solver != "auto":
        factorization.choose(model.analysis.solver)
    ground = _discretize(as_solved(move_to_center(model)), loaded=False).ground
    if not isinstance(ground, Column):
        ground.first_column()


def find_unbalanced(model: Model) -> dict[str, NoEquilibrium]:
    """Return why the foundation fails, by the names of the combinations that nothing balances, before any is solved.

    Nothing is looked for where there are more than MAX_COMPARED_LOADS loads. That a balanced plate can still move, as
    `NeutralEquilibrium` says, shows only in a solution.
    """
    placed = as_solved(move_to_center(model))
    unbalanced: dict[str, NoEquilibrium] = {}
    if len(placed.loads) > MAX_COMPARED_LOADS:
        return unbalanced
    problem = _discretize(placed, loaded=True)
    for combination in list_combinations(placed):
        try:
            require_equilibrium(problem.combine(case_factors(placed, combination)))
        except NoEquilibrium as error:
            unbalanced[combination.name] = error.with_traceback(None)
    return unbalanced


def _discretize(model: Model, loaded: bool) -> Problem:
    """Return the arrays of a model on a mesh of not more than about MAX_CHECKED_ELEMENTS elements."""
    ratio = estimate_elements(model.plate, model.plates, model.mesh) / MAX_CHECKED_ELEMENTS
    if len(model.loads) > MAX_COMPARED_LOADS:
        model = model.model_copy(update={"mesh": model.mesh.replace(symmetry="off")})
    return discretize(model, max(0, math.ceil(math.log2(ratio) / 2)), loaded=loaded)
