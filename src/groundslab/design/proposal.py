"""Bars and links that are proposed for a slab."""

from __future__ import annotations

from dataclasses import replace

from groundslab.design.bars.proposal.propose import BarProposal, propose_in_layers
from groundslab.design.checks.one_way_shear.proposal import shear_links
from groundslab.messages import Message
from groundslab.model.design.detailing import allowed_bars
from groundslab.model.design.shear_links import ShearLinks
from groundslab.results.results import Results
from groundslab.schema.issues import require


def propose_bars(results: Results) -> BarProposal:
    """Propose bars for a slab: a base in each layer and zones of additional bars, with little steel.

    What bending and the minimum require at the points of the mesh in ultimate combinations is covered everywhere, the
    minimum also where a face may be in tension on another mesh, with the shift of moments and the anchorage of the
    zones' bars; where the case limits crack widths, these too. The bars are those that ``reinforcement.proposal``
    allows; those that the case has are not looked at.

    Parameters
    ----------
    results : Results
        The results of all combinations of a case with reinforcement.

    Returns
    -------
    BarProposal
        The case with the bars, to be written, checked and drawn as any other, and the steel.

    Raises
    ------
    InputError
        If the case has no reinforcement or no ultimate combination, or if no bars that are allowed are enough.

    References
    ----------
    EN 1992-1-1 8.4, 8.7, 9.2.1.3; ACI 318-19 25.4.2, 25.5.2, 7.7.3.3.

    Examples
    --------
    >>> import groundslab
    >>> proposal = groundslab.propose_bars(groundslab.solve(groundslab.load("case.toml")))
    >>> groundslab.write_bars(proposal.model, "bars.dxf")
    """
    require(results, Results, name="results")
    proposal = propose_in_layers(results)
    allowed = allowed_bars(proposal.reinforcement.proposal, results.model.units)
    asked = list(shear_links(replace(results, model=proposal.model), allowed.link_diameters, allowed.rounding))
    links = tuple(rectangle for rectangle in asked if isinstance(rectangle, ShearLinks))
    remarks = (*proposal.remarks, *(why for why in asked if isinstance(why, Message)))
    steel = proposal.reinforcement.replace(shear_links=links)
    return replace(proposal, model=proposal.model.model_copy(update={"reinforcement": steel}), remarks=remarks)
