"""Which keys of a case say nothing in it, because its code, combinations or mesh have no use for them.

The report leaves them out where the case does not give them: a design by ACI 318 has no factors of EN 1990.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from groundslab.model.design.reinforcement import keys_of_other_codes
from groundslab.model.loads.load_cases import Combine

if TYPE_CHECKING:
    from groundslab.model.model import Model


def keys_without_use(model: Model) -> dict[str, frozenset[str]]:
    """Return the keys that have no effect, by the section of the case."""
    unused = {"cases": frozenset[str]() if _takes_psi(model.combine) else frozenset({"psi_0", "psi_1", "psi_2"})}
    if not model.mesh.adaptive:
        unused["mesh"] = frozenset({"max_unknowns"})
    if model.combine is not None:
        unused["combine"] = frozenset(_of_combine(model.combine))
    if model.reinforcement is not None:
        unused["reinforcement"] = frozenset(keys_of_other_codes(model.reinforcement.code))
    return unused


def _takes_psi(combine: Combine | None) -> bool:
    """Return whether any combinations are made by EN 1990, with the cases' psi."""
    by_aci318 = {"ultimate", "seismic", "characteristic"}
    return combine is not None and (combine.expression != "ACI 318" or not by_aci318 >= {*combine.sets})


def _of_combine(combine: Combine) -> set[str]:
    """Return the keys of automatic combinations that the sets asked for do not take."""
    sets, unused = set(combine.sets), set[str]()
    if combine.expression == "ACI 318" or "ultimate" not in sets:
        unused |= {"permanent", "variable", "xi", "separate"}
    if combine.expression != "6.10a and 6.10b":
        unused.add("xi")
    unused |= {state for state in ("equilibrium", "uplift") if state not in sets}
    if "accidental" not in sets:
        unused.add("accidental_leader")
    return unused
