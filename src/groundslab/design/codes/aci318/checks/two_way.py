"""Two-way shear by ACI 318-19 22.6 at columns, over piles, around zones and at ends of walls, at d / 2 from faces."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from groundslab.design.codes.aci318 import punching as aci318
from groundslab.design.codes.aci318.checks.two_way_demand import (
    CUT,
    TwoWay,
    pile_two_way,
    strength,
    two_way,
    zone_two_way,
)
from groundslab.design.codes.aci318.checks.wall_ends import wall_two_way
from groundslab.design.codes.aci318.materials import PHI_SHEAR
from groundslab.design.codes.aci318.materials_of_case import materials
from groundslab.design.demands.perimeter_loads import punching_piles
from groundslab.design.demands.zones.thicker_zones import NONE, zone_forces
from groundslab.design.rules.check import DesignCheck, Status
from groundslab.design.rules.demand_errors import error_of_ratio, scaled
from groundslab.design.rules.punching import judged, with_the_rest, with_way
from groundslab.design.rules.wall_ends import NO_WALL, loaded_ends
from groundslab.messages import Message, Name
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the check of two-way shear over all ultimate combinations."""
    steel = combined.model.reinforcement
    assert steel is not None
    if combined.model.columns:
        yield from _checks(steel, two_way(combined), "two-way shear", ("column", "no column pushes or pulls"))
    if punching_piles(combined.model):
        yield from _checks(
            steel, pile_two_way(combined), "two-way shear over piles", ("pile", "no pile pushes or pulls")
        )
    if zone_forces(combined):
        yield from _checks(steel, zone_two_way(combined), "two-way shear around thicker zones", ("thicker zone", NONE))
    if loaded_ends(combined.model):
        yield from _checks(steel, (wall_two_way(combined), {}), "two-way shear at walls' ends", ("wall end", NO_WALL))


def _checks(
    steel: Reinforcement,
    demands: tuple[Mapping[tuple[str, str], TwoWay], Mapping[str, str]],
    name: str,
    pushing: tuple[str, str],
) -> Iterator[DesignCheck]:
    """Yield the check of columns, piles or zones, and which of them it leaves out."""
    known, missing = demands
    one, none = pushing
    those, supported = judged(known.values(), lambda demand: demand.v_u / strength(demand, steel))
    check = with_way(_worst(those, steel, name), known) if those else None
    yield from with_the_rest(check, name, (f"{one}s", none, CUT), supported, missing)


def _worst(demands: list[TwoWay], steel: Reinforcement, name: str) -> DesignCheck:
    """Return the check of the column or pile that is used most."""
    demand = max(demands, key=lambda each: each.v_u / strength(each, steel))
    beside = [each for each in demands if each.combination == demand.combination]
    error = error_of_ratio((each.v_u, strength(each, steel), each.error) for each in beside)
    v_u, resistance = max(demand.v_u, 0.0), strength(demand, steel)
    words = Message(
        '{name} in "{combination}": v_u {v_u:.3g MPa} on b_o {b_o:.2f m} is {v_u_2:.3g} times phi v_c '
        "{resistance:.3g MPa} (22.6.5.2)",
        name=Name(demand.name),
        combination=Name(demand.combination),
        v_u=v_u / 1e6,
        b_o=demand.b_o,
        v_u_2=v_u / resistance,
        resistance=resistance / 1e6,
    )
    status: Status = "no failure found"
    if v_u > resistance:
        concrete, bars = materials(steel)
        most = PHI_SHEAR * aci318.most_with_links(concrete)
        thin = demand.d < aci318.LEAST_DEPTH
        status = "fails" if v_u > most or thin else "attention"
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
