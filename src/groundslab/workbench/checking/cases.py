"""The load cases of a model and its combinations as the page shows them: sums, and a matrix of factors."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from groundslab.model.combinations import list_unmoved
from groundslab.model.loads.patterns import position_names
from groundslab.model.remarks.case_use import case_uses
from groundslab.model.remarks.resultants import case_sums, middle
from groundslab.unit_systems import in_system
from groundslab.units import UNITS
from groundslab.views.scene.plan import MAGNITUDES

if TYPE_CHECKING:
    from collections.abc import Sequence

    from groundslab.model.loads.load_cases import Combination
    from groundslab.model.model import Model


def cases_to_json(model: Model, combinations: Sequence[Combination]) -> dict[str, Any]:
    """Return the cases of a model with their sums, and the combinations that it does not list itself.

    Parameters
    ----------
    model : Model
        The case as written.
    combinations : sequence of Combination
        All that is solved of it.

    Returns
    -------
    dict
        ``about`` and ``length``: the place that moments are about and its unit; ``force`` and ``moment``: units of the
        sums; ``cases``: name, F, M_x and M_y, whether the case acts in any combination, and the names of its positions
        if it moves, at each of which combinations with it are solved; ``made``: name, limit state, rule and factors by
        case of the combinations that the program makes.
    """
    length, force, moment = (
        in_system(unit, model.units) for unit in (UNITS["m"], MAGNITUDES["force"], MAGNITUDES["moment"])
    )
    sums, positions = case_sums(model), position_names(model.moves)

    def case(name: str, acts: bool) -> dict[str, Any]:
        total = sums[name]
        return {
            "name": name,
            "F": total.F * force.scale,
            "M_x": total.M_x * moment.scale,
            "M_y": total.M_y * moment.scale,
            "acts": acts,
            "positions": list(positions.get(name, ())),
        }

    generated = list_unmoved(model)[len(model.combinations) :] if model.cases else ()
    return {
        "about": [value * length.scale for value in middle(model)],
        "length": length.name,
        "force": force.name,
        "moment": moment.name,
        "cases": [case(use.case.name, bool(use.acting)) for use in case_uses(model, combinations)],
        "made": [
            {
                "name": combination.name,
                "limit_state": combination.limit_state,
                "rule": combination.rule,
                "factors": dict(combination.factors),
            }
            for combination in generated
        ],
    }
