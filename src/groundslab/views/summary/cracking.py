"""What the summary says of a slab that has cracked: how much of it, and how soft it is at worst."""

from __future__ import annotations

from typing import TYPE_CHECKING

from groundslab.fem.shape_functions import areas
from groundslab.messages import Message
from groundslab.results.fields import ELEMENT_FIELDS, STIFFNESS, extreme
from groundslab.units import UNITS
from groundslab.views.summary.rows import Row, SummarySection
from groundslab.views.tables.quantities import nodal_values

if TYPE_CHECKING:
    from groundslab.results.results import CombinationResult

#: An element that is softer than this share of its uncracked stiffness has cracked.
CRACKED = 1 - 1e-6


def cracking_sections(results: CombinationResult) -> list[SummarySection]:
    """Return how far the slab has cracked, nothing in combinations without cracks."""
    cracking, ratio = results.model.cracking, results.elements.stiffness_ratio
    if cracking is None or ratio is None or results.limit_state not in cracking.limit_states:
        return []
    plate, about = results.plate, ELEMENT_FIELDS[STIFFNESS]
    least, place = extreme(plate.nodes, nodal_values(results, STIFFNESS) / about.scale, -1)
    area = areas(plate.nodes[plate.elements])
    share = float(area[ratio < CRACKED].sum() / area.sum())
    rows = (
        Row("share", "cracked share of the plate's area", share, UNITS["%"]),
        Row("smallest", "smallest share of uncracked stiffness", least, about.display, about.symbol, place),
    )
    note = Message(
        "Settlements, moments and pressures of this combination are those of the cracked slab, by EN 1992-1-1 7.4.3 "
        "with the bars provided, phi = {creep:g}, loads of {duration} duration.",
        creep=cracking.creep,
        duration=cracking.duration,
    )
    return [SummarySection("cracking", "Cracked stiffness", rows, (note,))]
