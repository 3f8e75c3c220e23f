"""Whether checks hang on the line force along the plate's edge, which only some models of the ground have.

Its size follows from k1, the ground's stiffness against shear, which is known less well than k0. A continuum has a rise
of the pressure towards the edge in its place, springs have nothing: where it carries much, the model decides.
"""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.checks.limit_steps import of_strip
from groundslab.design.demands.edge_strip import line_force_share, strip_of, strip_width
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.design.rules.check import DesignCheck
from groundslab.design.rules.combinations import solved_results
from groundslab.design.rules.demand_errors import error_of, scaled
from groundslab.messages import Message, Name
from groundslab.results.results import CombinationResult, Results

#: Share of the ground's force above which the edge's line force is named.
MOST = 0.10


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield how much the line force carries in the combination where its share is largest, where that is much."""
    model = combined.model
    pressed = model.limits is not None and model.limits.pressure is not None
    results = solved_results(combined)
    if not results or (model.reinforcement is None and model.soil_strength is None and not pressed):
        return
    worst = max(results, key=line_force_share)
    share = line_force_share(worst)
    if share <= MOST:
        return
    relieves = model.reinforcement is not None and model.reinforcement.line_force_relieves
    effect = (
        "it relieves shear and punching there, as the case specifies"
        if relieves
        else "it relieves neither shear nor punching, and counts as pressure on that strip"
    )
    words = Message(
        '{share:.3g} % of the load in "{combination}" reaches the ground as a line force along the edge, which stands '
        "for a rise of the pressure within {strip_width:.3g m} of it and follows from k1; {effect}; solve the slab on "
        "a continuum, too (compare-ground), and keep the worse",
        share=100 * share,
        combination=Name(worst.combination),
        strip_width=strip_width(worst),
        effect=effect,
    )
    yield DesignCheck(
        "edge line force", "attention", words, demand=100 * share, resistance=100 * MOST, unit="%",
        steps=tuple(_steps(worst)), combination=worst.combination,
        error=scaled(error_of(worst, line_force_share), 100.0),
    )  # fmt: skip


def _steps(results: CombinationResult) -> Iterator[Step]:
    """Yield the share of the ground's force that is line force, and the strip that it stands for."""
    plate = results.plate
    along, force = float(plate.line_force @ plate.edge_length), float(plate.contact_force.sum())
    yield Step("line force along all edges, by integration along them", "F_e", along / MEGA, "MN")
    yield Step("force on the ground, by integration of pressure and line force", "F", force / MEGA, "MN")
    yield Step("share of the line force", "s_e", 100 * along / force, "%", "100 * F_e / F")
    yield from of_strip(strip_of(results))
    yield Step("largest share that is not named", "s_lim", 100 * MOST, "%")
    yield Step("share used", "eta", along / force / MOST, "", "s_e / s_lim")
