"""Links in a part of a slab against one-way shear, that are given."""

from __future__ import annotations

import math
from typing import Annotated

from groundslab.model.design.bars import Diameter
from groundslab.model.shapes import Shape
from groundslab.schema.base import Section
from groundslab.schema.fields import Quantity, Text
from groundslab.schema.ranges import Range
from groundslab.schema.section_fields import Table

#: From one leg to the next [m].
SPACING = Range(above=0, at_most=2.0)


class ShearLinks(Section):
    """Vertical legs in a grid along x and y, in a part of the plan."""

    name: Annotated[str, Text("name of these links")]
    shape: Annotated[Shape, Table("where they stand")]
    diameter: Annotated[float, Diameter(symbol="phi_w", meaning="diameter of the legs", example="10 mm")]
    spacing_x: Annotated[float, Quantity("length", "s_x", "distance of the legs along x", SPACING, example="200 mm")]
    spacing_y: Annotated[float, Quantity("length", "s_y", "distance of the legs along y", SPACING, example="200 mm")]

    @property
    def area(self) -> float:
        """Return the area of the legs over that of the plan [m2/m2]."""
        return math.pi * self.diameter**2 / 4 / (self.spacing_x * self.spacing_y)

    @property
    def apart(self) -> float:
        """Return the larger distance of legs [m]."""
        return max(self.spacing_x, self.spacing_y)
