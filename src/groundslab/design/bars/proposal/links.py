"""Links against punching that are proposed where results need them, by the code of the case."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from groundslab.arrays import Array, made_once
from groundslab.design.codes.registry import code_of
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.punching import forces_that_punch, punching_supports
from groundslab.design.rules.punching_links.layout import LinkLayout, lay_given_links, lay_links
from groundslab.model.design.detailing import allowed_bars
from groundslab.model.design.laid_bars import covers_of
from groundslab.results.fields import LAYERS
from groundslab.results.results import Results
from groundslab.schema.issues import require

#: So many times the bars that links ask for are laid: beside the border of where they count there may be fewer.
MARGIN = 1.03


@made_once
def punching_links(combined: Results) -> tuple[LinkLayout, ...]:
    """Return links in perimeters around each column, pile, zone and end of a wall that needs them, or has some.

    Those that the case gives are as given, with what the code asks of them. Of the others the diameter is that of
    ``reinforcement.proposal.link_diameters`` with the least steel; legs are as long as the
    covers of both faces leave of the thickness, and keep off edges and openings by the larger cover.

    Parameters
    ----------
    combined : Results
        The results of all combinations.

    Returns
    -------
    tuple of LinkLayout
        One for each, with the reason instead where links do not help or cannot be laid; none without reinforcement, or
        where concrete alone resists.

    References
    ----------
    EN 1992-1-1 6.4.5, 9.4.3; ACI 318-19 22.6.7, 8.7.6.

    Examples
    --------
    >>> import groundslab
    >>> for layout in groundslab.punching_links(groundslab.solve(groundslab.load("case.toml"))):
    ...     print(layout.name, layout.number, layout.diameter)
    """
    require(combined, Results, name="results")
    steel = combined.model.reinforcement
    rule = code_of(steel).punching if steel is not None else None
    if steel is None or rule is None or rule.links is None or not ultimate_results(combined):
        return ()
    covers = covers_of(steel)
    diameters = allowed_bars(steel.proposal, combined.model.units).link_diameters
    return tuple(
        lay_links(demand, diameters, covers)
        if (laid := steel.links_at(demand.name)) is None
        else lay_given_links(demand, laid, covers)
        for support in punching_supports(combined)
        for demand in rule.links(combined, steel, support, rule.demands_of(combined, support))
    )


class NeedsOfLinks(NamedTuple):
    """The bars (n,) [m2/m] by layer that links against punching ask for at nodes, and at what."""

    areas: dict[str, Array]
    of: tuple[str, ...]


def needs_of_links(combined: Results) -> NeedsOfLinks:
    """Return the bars with which links against punching suffice at columns and piles where they do not yet.

    With them v_Rd,c is as large as links need. There are none where no bars that count are enough.
    """
    steel = combined.model.reinforcement
    rule = code_of(steel).punching if steel is not None else None
    nodes = ultimate_results(combined)[0].plate.nodes
    areas, names = {layer: np.zeros(len(nodes)) for layer in LAYERS}, list[str]()
    if steel is None or rule is None or rule.bars_for_links is None:
        return NeedsOfLinks(areas, ())
    for support in (kind for kind in punching_supports(combined) if kind in ("column", "pile")):
        forces = {force.name: force for force in forces_that_punch(combined, support)}
        for asked in rule.bars_for_links(steel, support, rule.demands_of(combined, support)):
            x0, x1, y0, y1 = forces[asked.name].column.ring().bounds
            low, high = np.array([x0, y0]) - asked.reach, np.array([x1, y1]) + asked.reach
            near = ((nodes >= low) & (nodes <= high)).all(axis=1)
            for layer in (f"{asked.face}_x", f"{asked.face}_y"):
                areas[layer][near] = np.maximum(areas[layer][near], MARGIN * asked.area)
            names.append(asked.name)
    return NeedsOfLinks(areas, tuple(names))
