"""Results that can be kept of a variant: fields of the plate and scalars, and how they are taken from results."""

from __future__ import annotations

from collections.abc import Sequence
from operator import itemgetter
from typing import TYPE_CHECKING, Annotated, Literal, NamedTuple

import numpy as np

from groundslab.accuracy.values import error_of_contact_share, error_of_largest, estimate_error
from groundslab.design.demands.by_plate import results_by_plate
from groundslab.design.demands.design_moments import DesignMoments, derive_field, fields_of
from groundslab.design.demands.tilt import largest_tilt
from groundslab.errors import InputError, Issue
from groundslab.geometry.plan import format_place
from groundslab.results.fields import LAYERS, PLATE_FIELDS, RANGED_FIELDS
from groundslab.results.results import CombinationResult, Results
from groundslab.schema.base import Section
from groundslab.schema.fields import Choice, FieldType, Integer, Number, Quantity, Text
from groundslab.schema.ranges import Range
from groundslab.units import DIMENSIONS

if TYPE_CHECKING:
    from groundslab.arrays import Array

Statistic = Literal["largest", "smallest", "mean", "at", "everywhere"]


class OutputQuantity(NamedTuple):
    """A quantity that can be kept: its dimension (empty for a pure number), its meaning."""

    dimension: str
    meaning: str


#: Names of fields in the table of results, by their names in studies.
_RESULT_FIELDS = {name.replace("_", " "): name for name in PLATE_FIELDS}
_RESULT_FIELDS |= {"principal moment 1": "m_1", "principal moment 2": "m_2"}
_RESULT_FIELDS |= {f"design moment {name.replace('_', ' ')}": name for name in LAYERS}
_STEEL = "area per length"

#: Depths below the plate.
DEPTH = Range(at_least=0)
#: Fields, by name.
FIELDS: dict[str, OutputQuantity] = {
    **{
        name: OutputQuantity(RANGED_FIELDS[field].dimension, RANGED_FIELDS[field].meaning)
        for name, field in _RESULT_FIELDS.items()
    },
    "shear": OutputQuantity("force per length", "transverse shear force in its own direction, never negative"),
    "tensile stress": OutputQuantity("pressure", "largest tension by bending at either face, 6 m / t^2"),
    "reinforcement bottom x": OutputQuantity(_STEEL, "bars along x at the bottom by the code of the case and the "
        "moments that its checks are for, infinite where the concrete is too weak, over the ultimate combinations; the "
        "case needs [reinforcement]"),
    "reinforcement bottom y": OutputQuantity(_STEEL, "the same along y"),
    "reinforcement top x": OutputQuantity(_STEEL, "the same along x at the top"),
    "reinforcement top y": OutputQuantity(_STEEL, "the same along y at the top"),
    "reinforcement": OutputQuantity(_STEEL, "the largest of these four"),
}  # fmt: skip

#: Fields that depend on the thickness of the plate.
_STEEL_FIELDS = {name for name in FIELDS if name.startswith("reinforcement")}
_NEEDS_THICKNESS = _STEEL_FIELDS | {"tensile stress"}

#: Quantities of the whole plate, by name.
SCALARS: dict[str, OutputQuantity] = {
    "load": OutputQuantity("force", "sum of the loads"),
    "reaction": OutputQuantity("force", "sum of the reactions of ground and supports"),
    "settlement difference": OutputQuantity("length", "largest settlement less the smallest"),
    "in contact": OutputQuantity("", "share of the plate's area that rests on the ground"),
    "tilt": OutputQuantity("slope", "largest slope of the plane that fits the settlement best"),
    "tilt x": OutputQuantity("slope", "its slope along x, positive where the side of larger x is lower"),
    "tilt y": OutputQuantity("slope", "its slope along y"),
    "deflection": OutputQuantity("length", "deflection of the largest size from that plane, positive downwards"),
    "support force": OutputQuantity("force", "force of the support named by support, upwards positive"),
    "k0": OutputQuantity("pressure per length", "final stiffness of a layer against compression"),
    "k1": OutputQuantity("pressure times length", "stiffness of a layer against shear"),
    "gamma": OutputQuantity("", "decay of the mode over the depth; none if the ground has no such mode"),
    "soil settlement": OutputQuantity("length", "settlement at x, y and the depth z of a continuum"),
    "soil stress": OutputQuantity("pressure", "vertical stress there, without the soil's own weight"),
    "margin effect": OutputQuantity("", "largest change of the settlement when the margin of infinite ground is "
        "wider, over the largest settlement; none if the ground is not infinite"),
}  # fmt: skip

#: Of these, those in the depth of the ground, and those of a ground of columns.
SOIL, CONSTANTS = ("soil settlement", "soil stress"), ("k0", "k1", "gamma")

#: What is exact on any mesh, is told of the finer mesh alone, or is a measure of another error.
_WITHOUT_ERROR = {"load", "reaction", *CONSTANTS, "margin effect"}


class RequestedOutput(Section):
    """A result to be kept of each variant."""

    name: Annotated[str, Text("its name; by default made from its contents")] = ""
    of: Annotated[str, Text("a field of the plate or a figure, see below")]
    take: Annotated[
        Statistic | None,
        Choice(Statistic, "what to take of a field: its largest or smallest value, its mean over the area, the "
               "value at a place, or all nodal values"),
    ] = None  # fmt: skip
    x: Annotated[float | None, Quantity("length", "x", "place, for at and in the ground")] = None
    y: Annotated[float | None, Quantity("length", "y", "place, for at and in the ground")] = None
    z: Annotated[
        float | None, Quantity("length", "z", "depth below the plate, for soil settlement and soil stress", DEPTH)
    ] = None
    combination: Annotated[str, Text("its combination; by default all of them, of which the worst counts")] = ""
    support: Annotated[str, Text("name of the support, for support force")] = ""
    layer: Annotated[int | None, Integer("layer of the ground from the top, for k0 and k1")] = None

    @property
    def column(self) -> str:
        """Return its name in the study and its table."""
        if self.name:
            return self.name
        words = [self.take or "", self.of]
        if self.take == "at":
            words = [self.of, "" if self.x is None or self.y is None else f"at {format_place((self.x, self.y))} m"]
        if self.take == "everywhere":
            words = [self.of, "everywhere"]
        if self.of.replace("_", " ") in SOIL and None not in (self.x, self.y, self.z):
            words.append(f"at ({self.x:g}, {self.y:g}, {self.z:g}) m")
        words += [f"of {self.support}" if self.support else "", f"of layer {self.layer}" if self.layer else ""]
        words.append(f"under {self.combination}" if self.combination else "")
        return " ".join(filter(None, words))

    @property
    def dimension(self) -> str:
        """Return the dimension, as `units` knows it; empty for a pure number."""
        return (FIELDS.get(self.of) or SCALARS[self.of]).dimension

    @property
    def unit(self) -> str:
        """Return the SI unit, empty for a pure number."""
        return DIMENSIONS[self.dimension].si if self.dimension else ""

    @property
    def key(self) -> FieldType:
        """Return the type of a bound of it in a study file."""
        return Quantity(self.dimension, "", "") if self.dimension else Number("", "")

    @property
    def is_steel(self) -> bool:
        """Return whether it is required reinforcement, for which only ultimate combinations count."""
        return self.of.startswith("reinforcement")

    @property
    def everywhere(self) -> bool:
        """Return whether all nodal values of the field are kept."""
        return self.take == "everywhere"


def scalar_of(output: RequestedOutput, combined: Results, names: Sequence[str]) -> float | None:
    """Return the number that is kept of a variant, in SI units; None if a combination that it needs has none.

    `names` are the combinations that it is of. Of several the worst one's is taken: the largest of the largest, the
    smallest of the smallest, else the one of the largest size.
    """
    return _governing(output, combined, names)[0]


def error_of(output: RequestedOutput, combined: Results, names: Sequence[str]) -> tuple[float, float] | None:
    """Return the number that is kept of a case and its discretization error, in SI units; None if it has none.

    Of several combinations the error is that of the worst one's value.
    """
    value, name = _governing(output, combined, names)
    results = combined.results.get(name)
    coarser = None if results is None or output.of in _WITHOUT_ERROR else results.coarser
    other = None if coarser is None else _scalar(output, coarser)
    if value is None or other is None or not np.isfinite([value, other]).all():
        return None
    assert results is not None
    assert coarser is not None
    assert results.comparison is not None
    if output.take in ("largest", "smallest"):
        sign = 1 if output.take == "largest" else -1
        values, before = (sign * _nodal_values(output, combination)[0] for combination in (results, coarser))
        return value, error_of_largest(results, _RESULT_FIELDS.get(output.of, output.of), values, before)
    if output.of == "in contact":
        return value, error_of_contact_share(results) or 0.0
    # places of the largest size may differ between both meshes, and with them the sign
    sizes = (abs(value), abs(other)) if output.of == "deflection" else (value, other)
    return value, estimate_error(*sizes, results.comparison)


def _governing(output: RequestedOutput, combined: Results, names: Sequence[str]) -> tuple[float | None, str]:
    """Return the number that is kept of a variant and the combination that it is of; None if one has no results."""
    values = [_scalar(output, combined.results[name]) if name in combined.results else None for name in names]
    pairs = [(value, name) for value, name in zip(values, names, strict=True) if value is not None]
    if len(pairs) < len(values):
        return None, ""
    if output.take == "largest":
        return max(pairs, key=itemgetter(0))
    if output.take == "smallest":
        return min(pairs, key=itemgetter(0))
    return max(pairs, key=lambda pair: abs(pair[0]))


def nodal_values_of(output: RequestedOutput, combined: Results, names: Sequence[str]) -> Array | None:
    """Return the nodal values that are kept of a variant (n,), in SI units; None if a combination has no results.

    Of several combinations each node has the value of the largest size, with its sign.
    """
    if not all(name in combined.results for name in names):
        return None
    values = np.stack([field_of(combined.results[name], output.of) for name in names])
    worst: Array = np.take_along_axis(values, np.argmax(np.abs(values), axis=0)[None], axis=0)[0]
    return worst


def _scalar(output: RequestedOutput, results: CombinationResult) -> float | None:
    """Return the number that is kept of a combination's results."""
    if output.of in SCALARS:
        return _scalar_quantity(output, results)
    if output.take == "at":
        return _value_at(results, output)
    values, weights = _nodal_values(output, results)
    if output.take == "mean":
        return float(values @ weights / weights.sum())
    return float(values.max() if output.take == "largest" else values.min())


def _nodal_values(output: RequestedOutput, results: CombinationResult) -> tuple[Array, Array]:
    """Return a field at the plate's nodes where it is, and the areas [m2] or lengths [m] of the edge of each, (n,)."""
    values, weights = field_of(results, output.of), results.plate.area
    if output.of == "line force":
        on_edge = results.plate.edge_length > 0
        values, weights = values[on_edge], results.plate.edge_length[on_edge]
    return values, weights


def _scalar_quantity(output: RequestedOutput, results: CombinationResult) -> float | None:
    """Return one of SCALARS of a combination's results."""
    certificate, constants = results.certificate, results.constants
    match output.of:
        case "load" | "reaction" | "margin effect":
            value: float | None = getattr(certificate, output.of.replace(" ", "_"))
            return value
        case "settlement difference":
            return max(float(np.ptp(plate.settlement)) for plate in results_by_plate(results).values())
        case "in contact":
            return results.plate.contact_share
        case "support force":
            return next((support.total for support in results.supports if support.name == output.support), None)
        case "soil settlement" | "soil stress":
            return _in_depth(output, results)
        case "gamma":
            return constants.gamma
        case "k0" | "k1":
            return dict(enumerate(map(float, getattr(constants, output.of)), 1)).get(output.layer or 1)
    return float(getattr(largest_tilt(results), output.of.replace(" ", "_")))


def _in_depth(output: RequestedOutput, results: CombinationResult) -> float | None:
    """Return settlement [m] or vertical stress [Pa] in the depth of a continuum, None on other ground."""
    ground, (x, y, z) = results.ground, (output.x, output.y, output.z)
    if ground.cells is None or x is None or y is None or z is None:
        return None
    return float((ground.settlement_at if output.of == "soil settlement" else ground.stress_at)(x, y, z))


def field_of(results: CombinationResult, name: str) -> Array:
    """Return a field of FIELDS at the plate's nodes (n,), in SI units."""
    thickness = results.elements.at_nodes(results.plate)[0] if name in _NEEDS_THICKNESS else np.zeros(0)
    if name in _STEEL_FIELDS:
        return _required_bars(results, name, _design_moments(results), thickness)
    return _derive(name, fields_of(results.plate), thickness)


def _value_at(results: CombinationResult, output: RequestedOutput) -> float:
    """Return a field at a point; what derives from moments is computed there, as it has kinks between the nodes."""
    from groundslab.fem.mesh import Mesh, locate
    from groundslab.fem.shape_functions import q9_values

    plate = results.plate
    assert output.x is not None
    assert output.y is not None
    (element,), local = locate(Mesh(plate.nodes, plate.elements), np.array([[output.x, output.y]]))
    if element < 0:
        raise InputError([Issue(output.name, f"({output.x:g}, {output.y:g}) m", "a point on the plate")])
    weights, nodes, thickness = q9_values(local), plate.elements[element], results.elements.thickness[[element]]
    if output.of in _STEEL_FIELDS:
        moments = _design_moments(results)
        at_point = DesignMoments(**{layer: weights @ getattr(moments, layer)[nodes] for layer in LAYERS})
        return float(_required_bars(results, output.of, at_point, thickness)[0])
    fields = {name: weights @ getattr(plate, name)[nodes] for name in PLATE_FIELDS}
    return float(_derive(output.of, fields, thickness)[0])


def _derive(name: str, fields: dict[str, Array], thickness: Array) -> Array:
    """Return a field of FIELDS (n,) from the plate's own fields (n,), all in SI units."""
    if name in _RESULT_FIELDS:
        return derive_field(fields, _RESULT_FIELDS[name])
    if name == "shear":
        return np.hypot(fields["shear_x"], fields["shear_y"])
    # the tensile stress, linear over the thickness: at the bottom by the larger moment, at the top by the smaller one
    moment = np.maximum(derive_field(fields, "m_1"), -derive_field(fields, "m_2"))
    stress: Array = 6 * np.maximum(moment, 0.0) / thickness**2
    return stress


def _design_moments(results: CombinationResult) -> DesignMoments:
    """Return the design moments (n,) [N m/m] that the checks of the case's bars are for, averaged as it says."""
    from groundslab.design.demands.support_moments import bar_moments

    steel = results.model.reinforcement
    assert steel is not None
    return bar_moments(results, steel)


def _required_bars(results: CombinationResult, name: str, moments: DesignMoments, thickness: Array) -> Array:
    """Return required areas of bars (n,) [m2/m] for design moments (n,)."""
    from groundslab.design.bars.required_bars import areas_for

    steel = results.model.reinforcement
    assert steel is not None
    reinforcement = areas_for(moments, thickness, steel, results.limit_state)
    layers = {layer: getattr(reinforcement, layer) for layer in LAYERS}
    wanted = name.removeprefix("reinforcement").strip().replace(" ", "_")
    area: Array = layers[wanted] if wanted else np.max(list(layers.values()), axis=0)
    return area
