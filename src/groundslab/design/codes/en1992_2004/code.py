"""EN 1992-1-1 as a design code."""

from __future__ import annotations

from groundslab.design.codes.en1992_2004 import beams, bending, detailing, shear, walls
from groundslab.design.codes.en1992_2004.checks import (
    bars,
    bending_steps,
    fire,
    governing_perimeters,
    links,
    one_way_shear,
    punching,
    punching_columns,
    punching_steps,
    wall_ends,
)
from groundslab.design.codes.en1992_2004.checks.remarks import remarks
from groundslab.design.codes.en1992_2004.materials_of_case import materials
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


EN1992 = DesignCode(
    name="EN 1992-1-1",
    clauses=Clauses(bars="6.1, 9.2.1.1(1)", least_bars="9.2.1.1(1)", held_bars="9.2.1.2(3)"),
    bending=_bending,
    bars_by_steps=bending_steps.steps,
    shear=ShearRule(
        words=ShearWords(
            "v_Ed", "v_Rd,c", "6.2.2", "6.2.3", "6.2.3(3)", "6.2.2, 6.2.3", "6.2.1(8)", "9.3.2(1)", "9.3.2(4)"
        ),
        link_distance=one_way_shear.link_distance,
        resistance=one_way_shear.resistance,
        links=one_way_shear.links,
        steps=one_way_shear.steps,
        most_ratio=shear.MOST_BARS,
        reach=one_way_shear.reach,
        cuts=cuts_from_edge_to_edge,
        least_thickness=one_way_shear.LEAST_WITH_LINKS,
        struts_at_faces=True,
    ),
    punching=PunchingRule(
        demands={
            "column": governing_perimeters.column_demands,
            "pile": governing_perimeters.pile_demands,
            "zone": governing_perimeters.zone_demands,
            "wall end": wall_ends.wall_demands,
        },
        used=punching.used,
        heads=punching_columns.heads,
        cells=punching_columns.cells,
        notes=punching_columns.notes,
        aspects=punching.aspects,
        cut=governing_perimeters.CUT,
        steps=punching_steps.steps,
        extremes=(("v_Ed", "MPa"), ("v_Ed / v_Rd", ""), ("v_Ed at the face", "MPa")),
        with_errors=("V_Ed", "v_Ed", "v_Ed / v_Rd", "v_Ed at the face"),
        links=links.links,
        bars_for_links=punching.bars_for_links,
    ),
    beams=BeamRule(
        minimum=beams.minimum,
        bars_by_steps=bending_steps.tension,
        minimum_by_steps=beams.minimum_steps,
        web=beams.web,
        web_steps=beams.web_steps,
        clauses="6.1, 7.3.2(2), 9.2.1.1(1)",
        web_clauses="6.2.3, 6.3.2, 9.2.2(5)",
        struts_at_faces=True,
        flange=FlangeRule(beams.flange_bars, beams.flange_limit, "6.2.4", beams.flange_steps),
        cracks=beams.cracks,
        link_distances=beams.link_distances,
        distance_steps=beams.distance_steps,
        distance_clauses="9.2.2(6), (8), 9.2.3(3)",
    ),
    walls=WallRule(walls.least, walls.most, walls.steps, "6.9, 9.6.2, 9.6.3, 9.7"),
    bars=bars.checks,
    detailing=detailing.RULE,
    fire=fire.checks,
    remarks=remarks,
)
