"""What can be kept of a variant: fields of the plate, and figures of the whole; how they are taken from results."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from groundslab.errors import InputError, Issue
from groundslab.results.fields import LINE_FORCE, PLATE_FIELDS
from groundslab.results.results import Combined, Results

if TYPE_CHECKING:
    from groundslab.arrays import Array

#: The dimension of each unit in PLATE_FIELDS.
_DIMENSION = {
    "mm": "length", "mrad": "slope", "kPa": "pressure", "kNm/m": "moment per length", "kN/m": "force per length",
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Kept:
    """Something that can be kept: its name, its dimension (empty for a pure number), what it means."""

    name: str
    dimension: str
    meaning: str


def _of_plate(name: str) -> Kept:
    field = PLATE_FIELDS[name]
    return Kept(name.replace("_", " "), _DIMENSION[field.unit], field.meaning)


_LINE_FORCE = LINE_FORCE.replace("_", " ")
_MOMENT = "moment per length"
_STEEL = "area per length"

#: Fields, by name: ``take`` says what of them is kept.
FIELDS: dict[str, Kept] = {
    kept.name: kept
    for kept in (
        *map(_of_plate, PLATE_FIELDS),
        Kept("shear", "force per length", "transverse shear force in its own direction, never negative"),
        Kept("principal moment 1", _MOMENT, "larger principal moment"),
        Kept("principal moment 2", _MOMENT, "smaller principal moment"),
        Kept("tensile stress", "pressure", "largest tension by bending at either face, 6 m / t^2"),
        Kept("design moment bottom x", _MOMENT, "Wood's moment for bars along x at the bottom, never negative"),
        Kept("design moment bottom y", _MOMENT, "the same along y"),
        Kept("design moment top x", _MOMENT, "the same along x at the top, never positive"),
        Kept("design moment top y", _MOMENT, "the same along y at the top"),
        Kept("reinforcement bottom x", _STEEL, "bars along x at the bottom by EN 1992-1-1, infinite where the concrete "
             "is too weak, over the ultimate combinations; the case needs [reinforcement]"),
        Kept("reinforcement bottom y", _STEEL, "the same along y"),
        Kept("reinforcement top x", _STEEL, "the same along x at the top"),
        Kept("reinforcement top y", _STEEL, "the same along y at the top"),
        Kept("reinforcement", _STEEL, "the largest of these four"),
    )
}  # fmt: skip

#: Fields that the thickness of the plate is part of.
_OF_THICKNESS = {name for name in FIELDS if name.startswith("reinforcement")} | {"tensile stress"}

#: Figures of the whole plate, by name.
FIGURES: dict[str, Kept] = {
    kept.name: kept
    for kept in (
        Kept("load", "force", "sum of the loads"),
        Kept("reaction", "force", "sum of the reactions of ground and supports"),
        Kept("settlement difference", "length", "largest settlement less the smallest"),
        Kept("in contact", "", "share of the plate's area that rests on the ground"),
        Kept("tilt", "slope", "largest slope of the plane that fits the settlement best"),
        Kept("tilt x", "slope", "its slope along x, positive where the side of larger x is lower"),
        Kept("tilt y", "slope", "its slope along y"),
        Kept("deflection", "length", "deflection of the largest size from that plane, positive downwards"),
        Kept("support force", "force", "force of the support named by support, upwards positive"),
        Kept("k0", "pressure per length", "stiffness of a layer against compression that the analysis ended with"),
        Kept("k1", "pressure times length", "stiffness of a layer against shear"),
        Kept("gamma", "", "decay of the mode over the depth; none if the ground has no such mode"),
        Kept("margin effect", "", "largest change of the settlement when the margin of infinite ground is wider, "
         "over the largest settlement; none if the ground is not infinite"),
    )
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Output:
    """A result that is kept of each variant."""

    name: str
    of: str  # in FIELDS or FIGURES
    take: Take | None
    x: float | None
    y: float | None
    combination: str  # empty: all of them
    support: str
    layer: int | None

    @property
    def dimension(self) -> str:
        """Return the dimension, as `units` knows it; empty for a pure number."""
        return (FIELDS.get(self.of) or FIGURES[self.of]).dimension

    @property
    def unit(self) -> str:
        """Return the SI unit, empty for a pure number."""
        from groundslab.units import DIMENSIONS

        return DIMENSIONS[self.dimension].si if self.dimension else ""

    @property
    def is_steel(self) -> bool:
        """Return whether it is required reinforcement, for which only ultimate combinations count."""
        return self.of.startswith("reinforcement")

    @property
    def everywhere(self) -> bool:
        """Return whether the whole field is kept."""
        return self.take == "everywhere"


def figure_of(output: Output, combined: Combined, wanted: Sequence[str]) -> float | None:
    """Return the one number that is kept of a variant, in SI units; None if a combination that it needs has none.

    `wanted` are the names of the combinations that it is of. Of several the worst one's is taken: the largest of the
    largest, the smallest of the smallest, else the one of the largest size.
    """
    if not all(name in combined.results for name in wanted):
        return None
    figures = [_figure(output, combined.results[name]) for name in wanted]
    there = [figure for figure in figures if figure is not None]
    if len(there) < len(figures):
        return None
    if output.take == "largest":
        return max(there)
    return min(there) if output.take == "smallest" else max(there, key=abs)


def whole_of(output: Output, combined: Combined, wanted: Sequence[str]) -> Array | None:
    """Return the whole field that is kept of a variant (n,), in SI units; None if a combination has no results.

    Of several combinations each node has the value of the largest size, with its sign.
    """
    if not all(name in combined.results for name in wanted):
        return None
    return _largest_size(np.stack([field_of(combined.results[name], output.of) for name in wanted]))


def _largest_size(fields: Array) -> Array:
    """Return at each node the value of the largest size of several fields (c, n), with its sign: (n,)."""
    worst: Array = np.take_along_axis(fields, np.argmax(np.abs(fields), axis=0)[None], axis=0)[0]
    return worst


def _figure(output: Output, results: Results) -> float | None:
    """Return the one number that is kept of a combination's results."""
    if output.of in FIGURES:
        return _FIGURE[output.of](results, output)
    if output.take == "at":
        return _at(results, output)
    values, weights = field_of(results, output.of), results.plate.area
    if output.of == _LINE_FORCE:
        on_edge = results.plate.edge_length > 0
        values, weights = values[on_edge], results.plate.edge_length[on_edge]
    if output.take == "mean":
        return float(values @ weights / weights.sum())
    return float(values.max() if output.take == "largest" else values.min())


def field_of(results: Results, name: str) -> Array:
    """Return a field of FIELDS at the plate's nodes (n,), in SI units."""
    fields = {each: getattr(results.plate, each) for each in PLATE_FIELDS}
    thickness = results.elements.at_nodes(results.plate)[0] if name in _OF_THICKNESS else np.zeros(0)
    return _made(results, name, fields, thickness)


def _at(results: Results, output: Output) -> float:
    """Return a field at a place; what is made of moments is made there, as it has kinks between the nodes."""
    from groundslab.fem.mesh import Mesh, locate
    from groundslab.fem.shape_functions import q9

    plate = results.plate
    assert output.x is not None
    assert output.y is not None
    (element,), local = locate(Mesh(plate.nodes, plate.elements), np.array([[output.x, output.y]]))
    if element < 0:
        raise InputError([Issue(output.name, f"({output.x:g}, {output.y:g}) m", "a point on the plate")])
    weights = q9(local)[0]
    fields = {name: weights @ getattr(plate, name)[plate.elements[element]] for name in PLATE_FIELDS}
    return float(_made(results, output.of, fields, results.elements.thickness[[element]])[0])


def _made(results: Results, name: str, fields: dict[str, Array], thickness: Array) -> Array:
    """Return a field of FIELDS (n,) from the plate's own (n,), all in SI units."""
    from groundslab.design.design_moments import principal_moments, wood_armer

    plain = name.removesuffix(" inside").replace(" ", "_")
    if plain in PLATE_FIELDS:
        return fields[plain]
    if name == "shear":
        return np.hypot(fields["shear_x"], fields["shear_y"])
    moments = fields["moment_x"], fields["moment_y"], fields["moment_xy"]
    if name.startswith("principal"):
        principal = principal_moments(*moments)
        return principal.m_1 if name.endswith("1") else principal.m_2
    if name == "tensile stress":
        principal = principal_moments(*moments)
        # linear over the thickness: at the bottom by the larger moment, at the top by the smaller one
        stress: Array = 6 * np.maximum(np.maximum(principal.m_1, -principal.m_2), 0.0) / thickness**2
        return stress
    design = wood_armer(*moments)
    if name.startswith("design"):
        values: Array = getattr(design, name.removeprefix("design moment ").replace(" ", "_"))
        return values
    return _steel(results, name, design, thickness)


def _steel(results: Results, name: str, design: Any, thickness: Array) -> Array:
    """Return required areas of bars (n,) [m2/m] for design moments (n,)."""
    from groundslab.design.reinforcement import Axes, slab
    from groundslab.design.tables.reinforcement import materials

    steel = results.model.reinforcement
    assert steel is not None
    concrete, bars = materials(steel)
    found = slab(design, thickness, Axes(*steel.bottom, *steel.top), concrete, bars)
    layers = {layer: getattr(found, layer) for layer in ("bottom_x", "bottom_y", "top_x", "top_y")}
    wanted = name.removeprefix("reinforcement").strip().replace(" ", "_")
    area: Array = layers[wanted] if wanted else np.max(list(layers.values()), axis=0)
    return area


def _tilt(attribute: str) -> Callable[[Results, Output], float | None]:
    def figure(results: Results, output: Output) -> float | None:  # noqa: ARG001
        from groundslab.design.tilt import tilt

        return float(getattr(tilt(results.plate), attribute))

    return figure


def _layer(attribute: str) -> Callable[[Results, Output], float | None]:
    def figure(results: Results, output: Output) -> float | None:
        values = getattr(results.constants, attribute)
        number = output.layer or 1
        return float(values[number - 1]) if number <= len(values) else None

    return figure


def _support_force(results: Results, output: Output) -> float | None:
    found = [support.total for support in results.supports if support.name == output.support]
    return found[0] if found else None


_FIGURE: dict[str, Callable[[Results, Output], float | None]] = {
    "load": lambda results, _: results.certificate.load,
    "reaction": lambda results, _: results.certificate.reaction,
    "settlement difference": lambda results, _: float(np.ptp(results.plate.settlement)),
    "in contact": lambda results, _: results.plate.contact_share,
    "tilt": _tilt("tilt"),
    "tilt x": _tilt("tilt_x"),
    "tilt y": _tilt("tilt_y"),
    "deflection": _tilt("deflection"),
    "support force": _support_force,
    "k0": _layer("k0"),
    "k1": _layer("k1"),
    "gamma": lambda results, _: results.constants.gamma,
    "margin effect": lambda results, _: results.certificate.margin_effect,
}


Take = Literal["largest", "smallest", "mean", "at", "everywhere"]
