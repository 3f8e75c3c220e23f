"""Two-way shear by ACI 318-19 22.6 at columns, over piles, around zones and at ends of walls, at d / 2 from faces."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial

from groundslab.design.codes.aci318 import punching as aci318
from groundslab.design.codes.aci318.checks.laid_links import strength_as_laid, used_as_laid
from groundslab.design.codes.aci318.checks.two_way_demand import TwoWay, strength
from groundslab.design.codes.aci318.materials import PHI_SHEAR
from groundslab.design.codes.aci318.materials_of_case import materials
from groundslab.design.rules.calculation import Support
from groundslab.design.rules.check import DesignCheck, Status
from groundslab.design.rules.demand_errors import error_of_ratio, scaled
from groundslab.design.rules.punching import Aspect, Demands
from groundslab.messages import Clause, Message, Name
from groundslab.model.design.reinforcement import Reinforcement

#: What the checks are called.
NAMES: Mapping[Support, str] = {
    "column": "two-way shear",
    "pile": "two-way shear over piles",
    "zone": "two-way shear around thicker zones",
    "wall end": "two-way shear at walls' ends",
}


def aspects(support: Support, demands: Demands[TwoWay], steel: Reinforcement) -> Iterator[Aspect]:
    """Yield what is judged: the critical section at d / 2."""
    name = NAMES[support]
    used = partial(used_as_laid, steel=steel)
    yield Aspect(name, demands.found.values(), used, partial(_worst, steel=steel, name=name))


def _worst(demands: list[TwoWay], steel: Reinforcement, name: str) -> DesignCheck:
    """Return the check of the column or pile that is used most."""
    demand = max(demands, key=partial(used_as_laid, steel=steel))
    beside = [other for other in demands if other.combination == demand.combination]
    error = error_of_ratio((other.v_u, strength_as_laid(other, steel), other.error) for other in beside)
    v_u, resistance = max(demand.v_u, 0.0), strength_as_laid(demand, steel)
    linked = resistance > strength(demand, steel)
    words = Message(
        '{name} in "{combination}": v_u {v_u:.3g MPa} on b_o {b_o:.2f m} is {v_u_2:.3g} times {strength} '
        "{resistance:.3g MPa} ({clause})",
        name=Name(demand.name),
        combination=Name(demand.combination),
        v_u=v_u / 1e6,
        b_o=demand.b_o,
        v_u_2=v_u / resistance,
        strength="phi v_n with the links given," if linked else "phi v_c",
        resistance=resistance / 1e6,
        clause=Clause("22.6.6 to 22.6.8" if linked else "22.6.5.2"),
    )
    status: Status = "no failure found"
    if v_u > resistance and linked:
        status = "fails"
        words += "; more or thicker legs are needed"
    elif v_u > resistance:
        concrete, bars = materials(steel)
        most = PHI_SHEAR * aci318.most_with_links(concrete)
        thin = demand.d < aci318.LEAST_DEPTH
        status = "fails"
        per_meter = aci318.links(v_u, demand.d, demand.b_o, concrete, bars)
        words += (
            Message("; stirrups do not suffice, as they bear at most {most:.3g MPa} (22.6.6.3)", most=most / 1e6)
            if v_u > most
            else "; too thin for stirrups (22.6.7.1)"
            if thin
            else Message(
                "; stirrups of A_v/s {per_meter:.3g cm2/m} are needed around it (22.6.7.2)", per_meter=per_meter * 1e4
            )
        )
    return DesignCheck(
        name, status, words, of=demand.name, demand=v_u / 1e6, resistance=resistance / 1e6, unit="MPa",
        clause="ACI 318-19 22.6.5.2, 8.4.4.2", combination=demand.combination, place=demand.place,
        error=scaled(error, resistance / 1e6),
    )  # fmt: skip
