"""Bars that are laid: in one layer all over the slab, in zones of further bars, and as welded mesh."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

from groundslab.model.shapes import Shape
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Choice, ListOf, Quantity, Text
from groundslab.schema.issues import RelativeIssue, field_error
from groundslab.schema.ranges import Range
from groundslab.schema.section_fields import Table
from groundslab.schema.wording import listed, quote
from groundslab.unit_systems import BAR_SIZES

#: Bars, and how far apart they are at least (EN 1992-1-1 8.2(2): 20 mm between them).
BAR, APART = Range(at_least=4e-3, at_most=0.06), Range(at_least=0.02)

#: A layer of bars: the face that it is near, and the axis that its bars run along.
Layer = Literal["bottom_x", "bottom_y", "top_x", "top_y"]

#: Welded meshes with the same wires both ways (BS 4483: A, DIN 488-4: Q): diameter and distance of the wires [m]. The
#: number in a name is their area [mm2/m].
MESHES: dict[str, tuple[float, float]] = {
    "A142": (0.006, 0.2), "A193": (0.007, 0.2), "A252": (0.008, 0.2), "A393": (0.010, 0.2),
    "Q188A": (0.006, 0.15), "Q257A": (0.007, 0.15), "Q335A": (0.008, 0.15), "Q424A": (0.009, 0.15),
    "Q524A": (0.010, 0.15),
}  # fmt: skip
MeshName = Literal["A142", "A193", "A252", "A393", "Q188A", "Q257A", "Q335A", "Q424A", "Q524A"]
OTHER_MESH = "give the wires of any other mesh by diameter and spacing"


@dataclass(frozen=True)
class Diameter(Quantity):
    """A diameter of bars: a length, or the number of a size by ASTM A615, such as "#5"."""

    dimension: str = "length"
    symbol: str = "phi"
    meaning: str = ""
    range: Range = BAR
    words: tuple[str, ...] = tuple(BAR_SIZES)
    example: str = "16 mm"

    def read(self, value: Any, from_file: bool) -> float:
        """Return the diameter [m]; raises FieldError."""
        if isinstance(value, str) and value.startswith("#") and value not in BAR_SIZES:
            raise field_error(value, self.expected(), f"there are {listed(BAR_SIZES, 'and')}")
        bars = super().read(value, from_file)
        return BAR_SIZES[bars] if isinstance(bars, str) else bars

    def write(self, value: float | str) -> str:
        """Return the number of a size where it has one, else the length."""
        return super().write(next((name for name, size in BAR_SIZES.items() if size == value), value))

    def expected(self) -> str:
        """Return an example of each."""
        return 'a length such as "16 mm", or a size such as "#5"'

    def type_text(self) -> str:
        """Return an example of each for the table of keys."""
        return 'length (`"16 mm"`) or size (`"#5"`)'


class Bars(Section):
    """Bars of one layer, all over the slab."""

    diameter: Annotated[float, Diameter(meaning="diameter of the bars")]
    spacing: Annotated[float, Quantity("length", "s", "from axis to axis", APART, example="150 mm")]


def bars_of_mesh(mesh: str) -> Bars:
    """Return the wires of a welded mesh in one direction."""
    diameter, spacing = MESHES[mesh]
    return Bars(diameter=diameter, spacing=spacing)


def _check_bars_or_mesh(
    layers: tuple[str, ...], diameter: float | None, spacing: float | None, mesh: str | None
) -> Iterator[RelativeIssue]:
    if mesh is None:
        for name, value in (("diameter", diameter), ("spacing", spacing)):
            if value is None:
                yield RelativeIssue((name,), "nothing", "diameter and spacing, or mesh")
        return
    if diameter is not None or spacing is not None:
        yield RelativeIssue(("mesh",), "a mesh together with diameter or spacing", "one of them")
    alone = [layer for layer in layers if layer.replace("_x", "_y") not in layers or layer[:-1] + "x" not in layers]
    if alone:
        yield RelativeIssue(("layers",), quote(alone[0]), "both layers of a face, as a mesh has wires both ways")


class BarZone(Section):
    """Further bars in a part of the plan, between those of the layer; where zones overlap their bars add up."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_bars_or_mesh,)

    name: Annotated[str, Text("name of the zone")]
    shape: Annotated[Shape, Table("where; what reaches over the plate's edge is cut off")]
    layers: Annotated[tuple[Layer, ...], ListOf(Choice(Layer, ""), "", "layers of the bars", unique=True)]
    diameter: Annotated[float | None, Diameter(meaning="diameter of the bars")] = None
    spacing: Annotated[
        float | None, Quantity("length", "s", "of these bars, center to center", APART, example="150 mm")
    ] = None
    mesh: Annotated[
        MeshName | None,
        Choice(MeshName, "welded mesh in both layers of a face, instead of diameter and spacing", OTHER_MESH),
    ] = None

    @property
    def bars(self) -> Bars:
        """Return the bars of the zone in each of its layers."""
        if self.mesh is not None:
            return bars_of_mesh(self.mesh)
        assert self.diameter is not None
        assert self.spacing is not None
        return Bars(diameter=self.diameter, spacing=self.spacing)
