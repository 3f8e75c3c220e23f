"""Sections of members of the frame above: rectangles, circles, and others by their properties."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, Literal

from groundslab.model.ground import POSITIVE
from groundslab.model.structure.beams import SHEAR_SHARE, TORSION_CONSTANT, torsion_constant
from groundslab.schema.base import Section
from groundslab.schema.fields import Quantity
from groundslab.schema.section_fields import Table

#: The shear area of a circle over its area (Cowper 1966 for nu = 0).
CIRCLE_SHEAR_SHARE = 6 / 7


@dataclass(frozen=True, slots=True)
class MemberProperties:
    """What bends, twists, shears and stretches: beams sideways and vertically, columns along their first axis, then."""

    A: float  # [m2]
    I: tuple[float, float]  # [m4]: for displacements along width, along height  # noqa: E741
    J: float  # [m4]
    A_v: float  # [m2]: area that carries shear, inf where nothing gives


class RectangularMember(Section):
    """A rectangle: of a beam width and height, of a column what it measures along x and along y."""

    kind: Annotated[Literal["rectangle"], Table("a rectangle")] = "rectangle"
    width: Annotated[float, Quantity("length", "b", "width of a beam; of a column along x", POSITIVE, example="0.3 m")]
    height: Annotated[
        float, Quantity("length", "h", "height of a beam; of a column its width along y", POSITIVE, example="0.5 m")
    ]

    @property
    def properties(self) -> MemberProperties:
        """Return area and second moments."""
        b, h = self.width, self.height
        return MemberProperties(b * h, (h * b**3 / 12, b * h**3 / 12), torsion_constant(b, h), SHEAR_SHARE * b * h)


class CircularMember(Section):
    """A circle."""

    kind: Annotated[Literal["circle"], Table("a circle")] = "circle"
    diameter: Annotated[float, Quantity("length", "d", "diameter", POSITIVE, example="0.4 m")]

    @property
    def properties(self) -> MemberProperties:
        """Return area and second moments."""
        A, second = math.pi * self.diameter**2 / 4, math.pi * self.diameter**4 / 64
        return MemberProperties(A, (second, second), 2 * second, CIRCLE_SHEAR_SHARE * A)


class GivenMember(Section):
    """A section of which the properties are given, such as of steel."""

    kind: Annotated[Literal["properties"], Table("a section of which the properties are given, such as of steel")] = (
        "properties"
    )
    area: Annotated[float, Quantity("area", "A", "area", POSITIVE, example="0.15 m^2")]
    second_moment: Annotated[
        float,
        Quantity(
            "second moment of area",
            "I",
            "for bending of a beam in a vertical plane, of a column along y",
            POSITIVE,
            example="0.003 m^4",
        ),
    ]
    second_moment_across: Annotated[
        float | None,
        Quantity(
            "second moment of area",
            "I_z",
            "for bending of a beam sideways, of a column along x; by default the same",
            POSITIVE,
            example="0.003 m^4",
        ),
    ] = None
    torsion_constant: Annotated[float, TORSION_CONSTANT] = 0.0
    shear_area: Annotated[
        float | None,
        Quantity("area", "A_v", "area that carries shear; by default nothing gives way", POSITIVE, example="0.15 m^2"),
    ] = None

    @property
    def properties(self) -> MemberProperties:
        """Return area and second moments."""
        across = self.second_moment if self.second_moment_across is None else self.second_moment_across
        A_v = math.inf if self.shear_area is None else self.shear_area
        return MemberProperties(self.area, (across, self.second_moment), self.torsion_constant, A_v)


MemberSection = RectangularMember | CircularMember | GivenMember
