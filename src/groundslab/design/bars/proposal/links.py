"""Links against punching that are proposed where results need them, by the code of the case."""

from __future__ import annotations

from groundslab.arrays import made_once
from groundslab.design.codes.registry import code_of
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.punching import punching_supports
from groundslab.design.rules.punching_links.layout import LinkLayout, lay_given_links, lay_links
from groundslab.model.design.detailing import allowed_bars
from groundslab.model.design.laid_bars import covers_of
from groundslab.results.results import Results
from groundslab.schema.issues import require


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
        if (given := steel.links_at(demand.name)) is None
        else lay_given_links(demand, given, covers)
        for support in punching_supports(combined)
        for demand in rule.links(combined, steel, support, rule.demands_of(combined, support))
    )
