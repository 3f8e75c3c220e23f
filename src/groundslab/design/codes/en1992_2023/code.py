"""EN 1992-1-1:2023 as a design code."""

from __future__ import annotations

from groundslab.design.codes.en1992_2023 import beams, bending, shear, walls
from groundslab.design.codes.en1992_2023.checks import (
    bars,
    bending_steps,
    critical_sections,
    one_way_shear,
    punching,
    punching_columns,
    punching_demand,
    punching_steps,
    wall_ends,
)
from groundslab.design.codes.en1992_2023.checks.remarks import remarks
from groundslab.design.codes.en1992_2023.materials_of_case import materials
from groundslab.design.rules.bending import BendingRule
from groundslab.design.rules.design_code import (
    BeamRule,
    Clauses,
    DesignCode,
    FlangeRule,
    PunchingRule,
    ShearRule,
    ShearWords,
    WallRule,
)
from groundslab.design.rules.wide_beam import cuts_from_edge_to_edge
from groundslab.model.design.reinforcement import Reinforcement


def _bending(steel: Reinforcement, limit_state: str) -> BendingRule:
    """Return how sections of the case find their bars in a limit state."""
    return bending.rule(*materials(steel, limit_state))


EN1992_2023 = DesignCode(
    name="EN 1992-1-1:2023",
    clauses=Clauses(bars="8.1, 12.2(2)", least_bars="12.2(2)", held_bars="12.3"),
    bending=_bending,
    bars_by_steps=bending_steps.steps,
    shear=ShearRule(
        words=ShearWords(
            "v_Ed", "v_Rd,c = tau_Rd,c z", "8.2.2", "8.2.3", "8.2.3, 8.44", "8.2.2, 8.2.3", "8.2.3", "12.4.2(2)"
        ),
        resistance=one_way_shear.resistance,
        links=one_way_shear.links,
        steps=one_way_shear.steps,
        most_ratio=shear.MOST_BARS,
        reach=one_way_shear.reach,
        cuts=cuts_from_edge_to_edge,
        least_thickness=punching.LEAST_WITH_LINKS,
        struts_at_faces=True,
    ),
    punching=PunchingRule(
        demands={
            "column": punching_demand.column_demands,
            "pile": punching_demand.pile_demands,
            "zone": punching_demand.zone_demands,
            "wall end": wall_ends.wall_demands,
        },
        used=punching.used,
        heads=punching_columns.heads,
        cells=punching_columns.cells,
        notes=punching_columns.notes,
        aspects=punching.aspects,
        cut=critical_sections.CUT,
        beyond_faces=0.5,
        steps=punching_steps.steps,
        extremes=(("tau_Ed", "MPa"), ("tau_Ed / tau_Rd,c", "")),
        with_errors=("V_Ed", "tau_Ed", "tau_Ed / tau_Rd,c"),
        links=punching.links,
        depth="d_v",
    ),
    beams=BeamRule(
        minimum=beams.minimum,
        bars_by_steps=bending_steps.tension,
        minimum_by_steps=beams.minimum_steps,
        web=beams.web,
        web_steps=beams.web_steps,
        clauses="8.1, 12.2(2)",
        web_clauses="8.2.3, 8.3, 12.4",
        struts_at_faces=True,
        flange=FlangeRule(beams.flange_bars, beams.flange_limit, "8.2.5", beams.flange_steps),
        cracks=beams.cracks,
    ),
    walls=WallRule(None, walls.most, walls.steps, "8.2.3, 8.44"),
    bars=bars.checks,
    remarks=remarks,
)
