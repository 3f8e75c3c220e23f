"""ACI 318-19 as a design code."""

from __future__ import annotations

from groundslab.design.codes.aci318 import beams, bending, detailing, walls
from groundslab.design.codes.aci318.checks import (
    bars,
    bending_steps,
    links,
    one_way_shear,
    two_way,
    two_way_columns,
    two_way_demand,
    two_way_steps,
    wall_ends,
)
from groundslab.design.codes.aci318.checks.remarks import remarks
from groundslab.design.codes.aci318.materials_of_case import materials
from groundslab.design.rules import wide_beam
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
from groundslab.model.design.reinforcement import Reinforcement

#: The largest ratio of bars that counts in one-way shear: ACI 318 has none, and this one is on the safe side.
MOST_BARS = 0.02


def _bending(steel: Reinforcement, _: str) -> BendingRule:
    """Return how sections of the case find their bars, in every limit state."""
    return bending.rule(*materials(steel))


ACI318 = DesignCode(
    name="ACI 318-19",
    clauses=Clauses(bars="22.3, 8.6.1.1", least_bars="8.6.1.1", held_bars="9.7.6.4"),
    bending=_bending,
    bars_by_steps=bending_steps.steps,
    shear=ShearRule(
        words=ShearWords(
            "v_u", "phi v_c", "22.5.5.1", "22.5.8.5.3", "22.5.1.2", "22.5.5.1", link_distance="7.7.5.1, 9.7.6.2.2"
        ),
        link_distance=one_way_shear.link_distance,
        resistance=one_way_shear.resistance,
        links=one_way_shear.links,
        steps=one_way_shear.steps,
        most_ratio=MOST_BARS,
        least_share=bending.LEAST,
        reach=one_way_shear.reach,
        beyond_links=0.5,  # 22.6.4.2
        cuts=wide_beam.cuts,
    ),
    punching=PunchingRule(
        demands={
            "column": two_way_demand.two_way,
            "pile": two_way_demand.pile_two_way,
            "zone": two_way_demand.zone_two_way,
            "wall end": wall_ends.wall_two_way,
        },
        used=two_way_demand.used,
        heads=two_way_columns.heads,
        cells=two_way_columns.cells,
        notes=two_way_columns.notes,
        aspects=two_way.aspects,
        cut=two_way_demand.CUT,
        beyond_faces=0.5,
        steps=two_way_steps.steps,
        extremes=(("v_u", "MPa"),),
        with_errors=("V_u", "v_u", "v_u / phi v_c"),
        links=links.links,
    ),
    beams=BeamRule(
        minimum=beams.minimum,
        bars_by_steps=bending_steps.tension,
        minimum_by_steps=beams.minimum_steps,
        web=beams.web,
        web_steps=beams.web_steps,
        clauses="22.3, 9.6.1.2",
        web_clauses="22.5, 22.7, 9.6.3.4, 9.6.4",
        struts_at_faces=False,
        flange=FlangeRule(beams.flange_bars, beams.flange_limit, "22.9", beams.flange_steps),
        cracks=beams.cracks,
        link_distances=beams.link_distances,
        distance_steps=beams.distance_steps,
        distance_clauses="9.7.6.2.2, 9.7.6.3.3",
    ),
    walls=WallRule(walls.least, walls.most, walls.steps, "9.9.2.1, 9.9.3.1"),
    bars=bars.checks,
    detailing=detailing.RULE,
    remarks=remarks,
)
