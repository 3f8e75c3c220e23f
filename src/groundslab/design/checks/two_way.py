"""Two-way shear by ACI 318-19 22.6 of the columns of a case, at d / 2 from their faces."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.aci318 import punching as aci318
from groundslab.design.aci318.materials import PHI_SHEAR
from groundslab.design.checks.check import DesignCheck, Status
from groundslab.design.tables import reinforcement
from groundslab.design.tables.two_way import TwoWay, strength, two_way
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the check of two-way shear over all ultimate combinations."""
    steel = combined.model.reinforcement
    assert steel is not None
    found, missing = two_way(combined)
    judged = [each for each in found.values() if not each.supported]
    unjudged = sorted({each.column for each in found.values() if each.supported} | missing.keys())
    if judged:
        yield _worst(max(judged, key=lambda each: each.v_u / strength(each, steel)), steel)
    elif not unjudged:
        yield DesignCheck("two-way shear", "no failure found", "no column pushes down")
    if unjudged:
        names = ", ".join(unjudged[:5]) + (" ..." if len(unjudged) > 5 else "")
        words = f"not judged, for a support inside or no critical section on the plate: columns {names}"
        yield DesignCheck("two-way shear of some columns", "attention", words)


def _worst(demand: TwoWay, steel: Reinforcement) -> DesignCheck:
    """Return the check of the column that is used most."""
    v_u, resistance = max(demand.v_u, 0.0), strength(demand, steel)
    words = (
        f'{demand.column} in "{demand.combination}": v_u {v_u / 1e6:.3g} MPa on b_o {demand.b_o:.2f} m is '
        f"{v_u / resistance:.3g} times phi v_c {resistance / 1e6:.3g} MPa (22.6.5.2)"
    )
    status: Status = "no failure found"
    if v_u > resistance:
        concrete, bars = reinforcement.aci318_materials(steel)
        most = PHI_SHEAR * aci318.most_with_links(concrete)
        thin = demand.d < aci318.LEAST_DEPTH
        status = "fails" if v_u > most or thin else "attention"
        per_meter = aci318.links(v_u, demand.d, demand.b_o, concrete, bars)
        words += (
            f"; no stirrups help, which bear {most / 1e6:.3g} MPa at most (22.6.6.3)" if v_u > most
            else "; too thin for stirrups (22.6.7.1)" if thin
            else f"; stirrups of A_v/s {per_meter * 1e4:.3g} cm2/m are needed around it (22.6.7.2)"
        )  # fmt: skip
    return DesignCheck(
        "two-way shear", status, words, of=demand.column, demand=v_u / 1e6, resistance=resistance / 1e6, unit="MPa",
        clause="ACI 318-19 22.6.5.2, 8.4.4.2", combination=demand.combination, place=demand.place,
    )  # fmt: skip
