"""Restraint of a slab's shortening, which may crack it all through."""

from __future__ import annotations

from typing import Annotated

from groundslab.schema.base import Section
from groundslab.schema.fields import Quantity
from groundslab.schema.ranges import Range

#: Tensile strengths of concrete [Pa].
TENSILE = Range(at_least=1e5, at_most=1e7)


class Restraint(Section):
    """Shortening by shrinkage and cooling that ground or building restrain: cracks through the whole thickness."""

    f_ct_eff: Annotated[
        float | None,
        Quantity(
            "pressure",
            "f_ct,eff",
            "tensile strength of the concrete when cracks are first expected; f_ctm by default",
            TENSILE,
            example="2.6 MPa",
        ),
    ] = None
