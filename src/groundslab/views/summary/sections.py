"""The main figures of one combination in sections of rows, for the terminal, JSON, the report and the workbench."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from operator import attrgetter, itemgetter
from typing import TYPE_CHECKING

import numpy as np

from groundslab.accuracy.judgment import judge
from groundslab.accuracy.mesh_statistics import POOR, mesh_statistics
from groundslab.accuracy.values import error_of_largest, estimate_error
from groundslab.results.contact_zone import EDGE_NOTE, goes_below_zero, has_line_force, require_finite
from groundslab.results.fields import PLATE_FIELDS, extreme
from groundslab.units import UNITS, Unit

if TYPE_CHECKING:
    from groundslab.arrays import Array
    from groundslab.model.model import Model
    from groundslab.results.record import Certificate
    from groundslab.results.results import CombinationResult, Results, SupportResult

#: Of loads that are cut off at the plate's edge so many are shown.
MOST_CUT = 12
#: Figures below this share of the largest of their unit are rounding.
NOTHING = 1e-9
#: Of more supports than these only the extremes are shown.
MOST_SUPPORTS = 12


#: What is said of borders that the mesh does not follow.
CROSSED = (
    "An element across the border of a soil zone or void takes the mean of the ground in it, by area; of a void in "
    "ground with shear it takes all or nothing. With mesh.size instead of mesh.counts the mesh follows borders that "
    "are not finer than a thousandth of the plan."
)

#: What is said of a mesh with poor elements.
CROOKED = (
    f"An element has a scaled Jacobian below {POOR:g} (1 is a rectangle): near it results are less accurate. Make "
    "mesh.size smaller, or leave out details of the outline there that do not matter."
)

#: What the figures of the certificate mean, in words.
CERTIFICATE_WORDS = {
    "residual": "force left over at a node",
    "force_balance": "loads against reactions",
    "moment_balance": "moments of loads and reactions",
    "ground_balance": "contact against ground's forces",
    "worst_gap": "plate inside the ground (gap < 0)",
    "worst_pressure": "ground pulls (pressure < 0)",
    "worst_product": "pressure across an open gap",
    "gamma_change": "last change of gamma",
    "margin_effect": "effect of a wider margin of ground",
}


@dataclass(frozen=True, slots=True)
class Row:
    """One line of the summary: a value in SI, or a plain number, or words, and its place on the plate."""

    key: str
    label: str
    value: float | int | bool | str
    unit: Unit | None = None
    symbol: str = ""
    place: tuple[float, float] | None = None  # [m]
    tolerance: float | None = None
    ok: bool | None = None
    error: float | None = None  # estimated discretization error, in SI
    values: Array | None = field(default=None, compare=False, repr=False)  # (n,), the value is the largest of these


@dataclass(frozen=True, slots=True)
class SummarySection:
    """Some lines of the summary under one heading; the notes say what a reader must know about them."""

    key: str
    title: str
    rows: tuple[Row, ...]
    notes: tuple[str, ...] = ()


def summary(results: CombinationResult) -> list[SummarySection]:
    """Return the sections of the summary, in the order in which they are shown."""
    require_finite(results)
    return [*description(results), *figures(results), certificate_section(results.certificate)]


def description(results: CombinationResult) -> list[SummarySection]:
    """Return what was analyzed: plate, mesh, ground, and loads that were cut off at the plate's edge."""
    return [_plate(results), mesh_section(results), description_of_ground(results), *cut_loads(results.model)]


def figures(results: CombinationResult) -> list[SummarySection]:
    """Return what came out: settlement, contact, what supports carry, section forces, with discretization errors."""
    supports = [_supports(results)] if results.supports else []
    found = [_settlement(results), _contact(results), *supports, _section_forces(results)]
    if results.coarser is None:
        return found
    coarser = {(section.key, row.key): row for section in figures(results.coarser) for row in section.rows}
    found = [
        replace(each, rows=tuple(_with_error(row, coarser.get((each.key, row.key)), results) for row in each.rows))
        for each in found
    ]
    return [*found, _discretization(results)]


def _with_error(row: Row, coarser: Row | None, results: CombinationResult) -> Row:
    """Return a figure with its discretization error, if the next coarser mesh has one to compare."""
    if coarser is None or row.unit is None or isinstance(row.value, str) or isinstance(coarser.value, str):
        return row
    assert results.comparison is not None
    if row.values is None or coarser.values is None:
        return replace(row, error=estimate_error(row.value, coarser.value, results.comparison))
    return replace(row, error=error_of_largest(row.values, coarser.values, results.comparison))


def _discretization(results: CombinationResult) -> SummarySection:
    """Return the discretization error in energy, and the largest of the values that are judged."""
    assert results.comparison is not None
    rows = [Row("energy", "error in energy norm", results.comparison.energy_error, UNITS["%"])]
    judged = judge(results)
    if judged:
        rows.append(
            Row("largest_error", f"largest error, {judged[0].label}", judged[0].share, UNITS["%"], "", judged[0].place)
        )
    notes = _not_judged(results)
    if judged and judged[0].share > results.model.mesh.largest_error:
        notes = (
            *notes,
            f"The mesh is too coarse for errors of {100 * results.model.mesh.largest_error:g} % (mesh.accuracy): "
            f"{_remedy(results.model)} Errors are estimated from the same analysis on elements twice as large.",
        )
    return SummarySection("discretization", "Discretization error", tuple(rows), notes)


def _not_judged(results: CombinationResult) -> tuple[str, ...]:
    """Return in words which values are not among those that are judged, nothing where all are."""
    from groundslab.accuracy.singularities import find_limits

    limits = find_limits(results.model, results.plate.nodes, results.plate.in_contact)
    words = {
        "moments and shear forces where they have no limit as elements become smaller": limits.moments,
        "shear forces around footprints": limits.shear_forces | ~limits.moments,
        "pressures where they jump": limits.pressures | ~limits.shear_forces,
    }
    left_out = [text for text, judged in words.items() if not judged.all()]
    return (f"Not judged within a thickness: {'; '.join(left_out)}.",) if left_out else ()


def _remedy(model: Model) -> str:
    """Return what makes the errors smaller."""
    if model.mesh.adaptive:
        return "it was refined until this error fell no more, or as far as the bounds on unknowns and meshes allow."
    return "make mesh.size smaller, or leave it out and give mesh.accuracy."


def coarse_words(combined: Results) -> str:
    """Return in words that the mesh is too coarse for the accuracy asked for, or "" where it is not."""
    from groundslab.accuracy.resolution import find_unresolved

    remedy = _remedy(combined.model)
    for results in combined.values():
        small = find_unresolved(results)
        if small is not None:
            loads = f"{small.count} loads" if small.count > 1 else "a load"
            return (
                f"The mesh is too coarse for the footprint of {loads}: {small.footprint:.3g} m in elements of "
                f"{small.element:.3g} m. Moments and shear forces there are too small. {remedy.capitalize()}"
            )
    judged = [each for results in combined.values() for each in judge(results)[:1]]
    worst = max(judged, key=attrgetter("share"), default=None)
    if worst is None or worst.share <= combined.model.mesh.largest_error:
        return ""
    return (
        f"The mesh is too coarse: the largest discretization error is {100 * worst.share:.2g} % ({worst.label}), more "
        f"than {100 * combined.model.mesh.largest_error:g} %. {remedy.capitalize()}"
    )


def certified_words(count: int) -> str:
    """Return in words what a certificate of so many results says, and what it does not say."""
    which = f"The results of all {count} combinations are" if count > 1 else "The result is"
    return (
        f"{which} certified: equilibrium and contact conditions are satisfied on this mesh. "
        "This is no approval of the design."
    )


def _plate(results: CombinationResult) -> SummarySection:
    """Return the plate as it was analyzed."""
    plate, edges = results.model.plate, results.model.plate.edges
    edges_text = [
        f"{side} {kind}" for side in ("left", "right", "bottom", "top") if (kind := getattr(edges, side)) != "free"
    ]
    rows = (
        Row("length_x", "length along x", plate.sides[0], UNITS["m"]),
        Row("length_y", "length along y", plate.sides[1], UNITS["m"]),
        Row("area", "area", float(results.plate.area.sum()), UNITS["m2"]),
        Row("thickness", "thickness", plate.thickness, UNITS["m"], "t"),
        Row("E", "Young's modulus", plate.E, UNITS["MPa"], "E"),
        Row("nu", "Poisson's ratio", plate.nu, None, "nu"),
        Row("supports", "supported edges", ", ".join(edges_text) or "none"),
    )
    borders = _borders(results)
    return SummarySection("plate", "Plate", rows + borders, (CROSSED,) if borders else ())


def mesh_section(results: CombinationResult) -> SummarySection:
    """Return the elements on the plate, their sizes and quality, and the unknowns that were solved for."""
    mesh = mesh_statistics(results)
    directions = [name for name, used in zip("xy", results.symmetry, strict=True) if used]
    rows = (
        Row("element", "element", results.model.plate.element),
        Row("elements", "elements on the plate", mesh.elements),
        Row("smallest_side", "smallest element, root of its area", mesh.smallest, UNITS["m"], "", mesh.smallest_place),
        Row("largest_side", "largest element, root of its area", mesh.largest, UNITS["m"], "", mesh.largest_place),
        Row("worst_quality", "worst scaled Jacobian", round(mesh.worst_quality, 4), None, "", mesh.worst_place),
        Row("mean_quality", "mean scaled Jacobian", round(mesh.mean_quality, 4)),
        Row("unknowns", "unknowns that were solved for", mesh.unknowns),
        Row("symmetry", "symmetry used along", " and ".join(directions) or "none"),
        Row("solver", "solver", results.solver),
    )
    return SummarySection("mesh", "Mesh", rows, (CROOKED,) if mesh.worst_quality < POOR else ())


def description_of_ground(results: CombinationResult) -> SummarySection:
    """Return the kind of ground and the constants that the analysis ended with, layer by layer."""
    constants = results.constants
    several = len(constants.k0) > 1
    rows = [Row("kind", "model", results.model.ground.kind)]
    if results.model.beyond.kind != "none" and not results.model.ground_reaches:
        rows.append(Row("beyond", "beyond the plate", "no effect, as the ground carries no shear"))
    k0, k1 = (UNITS["MPa/m"], "compression", constants.k0), (UNITS["MPa m"], "shear", constants.k1)
    for name, (unit, meaning, values) in {"k0": k0, "k1": k1}.items():
        for number, value in enumerate(values, 1):
            key, where = (f"{name}_{number}", f", layer {number}") if several else (name, "")
            rows.append(Row(key, meaning + where, value, unit, key))
    if constants.gamma is not None:
        rows.append(Row("gamma", "decay of the mode", constants.gamma, None, "gamma"))
        rows.append(Row("gamma_iterations", "iterations for gamma", constants.gamma_iterations))
    return SummarySection("ground", "Ground", tuple(rows))


def _borders(results: CombinationResult) -> tuple[Row, ...]:
    """Return the areas of soil zones and voids whose borders the mesh does not follow."""
    from groundslab.results.soil_profile import crossed_borders

    words = {"drawn": "{} as drawn", "meshed": "{} on the mesh", "crossed": "elements across the border of {}"}
    return tuple(
        Row(f"{each.name}.{key}", label.format(each.name), getattr(each, key), UNITS["m2"])
        for each in crossed_borders(results)
        for key, label in words.items()
    )


def cut_loads(model: Model) -> list[SummarySection]:
    """Return what of the loads lies off the plate and does not act, nothing where all of them act."""
    from groundslab.model.loads.clipping import find_clipped_loads

    clipped = find_clipped_loads(model.plate, model.loads)
    if not clipped:
        return []
    rows = []
    for each in clipped[:MOST_CUT]:
        name = f"loads[{each.number}]" + (f" {each.name}" if each.name else "")
        rows.append(Row(f"share_{each.number}", f"{name}, off the plate", each.share, UNITS["%"]))
        rows.append(Row(f"force_{each.number}", f"{name}, does not act", each.force, UNITS["kN"]))
    if len(clipped) > MOST_CUT:
        rows.append(Row("more", "further loads that are cut off", len(clipped) - MOST_CUT))
    rows.append(Row("sum_of_forces", "all that does not act", sum(each.force for each in clipped), UNITS["kN"]))
    note = "Areas and lines act where they lie on the plate. Forces without the factors of combinations."
    return [SummarySection("cut_loads", "Loads cut off at the edge of the plate", tuple(rows), (note,))]


def _extreme(name: str, key: str, label: str, nodes: Array, values: Array, sign: int, symbol: str = "{}") -> Row:
    """Return the largest (sign 1) or smallest (sign -1) of values (n,) of a field with its place."""
    about = PLATE_FIELDS[name]
    value, place = extreme(nodes, values, sign)
    return Row(key, label, value, about.display, symbol.format(about.symbol), place, values=sign * values)


def _settlement(results: CombinationResult) -> SummarySection:
    """Return the largest and the smallest settlement; a smallest one below zero is called uplift."""
    nodes, w = results.plate.nodes, results.plate.settlement
    rows = [_extreme("settlement", "largest", "largest settlement", nodes, w, 1)]
    if goes_below_zero(w):
        rows.append(_extreme("settlement", "largest_uplift", "largest uplift", nodes, -w, 1, "-{}"))
    else:
        rows.append(_extreme("settlement", "smallest", "smallest settlement", nodes, w, -1))
    return SummarySection("settlement", "Settlement", tuple(rows))


def _contact(results: CombinationResult) -> SummarySection:
    """Return how much of the plate rests on the ground, the largest gap and the pressures."""
    plate = results.plate
    gap = _extreme("gap", "largest_gap", "largest gap", plate.nodes, plate.gap, 1)
    rows = [
        Row("share", "plate's area in contact", plate.contact_share, UNITS["%"]),
        gap if gap.value else replace(gap, place=None),
        *_pressures(plate.nodes, plate.pressure, "pressure"),
    ]
    notes: tuple[str, ...] = ()
    if has_line_force(results):
        on_edge = plate.edge_length > 0
        rows += _pressures(plate.nodes[on_edge], plate.line_force[on_edge], "line_force", "edge line force")
        notes = (EDGE_NOTE,)
    return SummarySection("contact", "Contact", tuple(rows), notes)


def _pressures(nodes: Array, values: Array, name: str, words: str = "pressure") -> list[Row]:
    """Return the largest of the pressures or line forces at nodes, and the largest tension if the ground pulls."""
    rows = [_extreme(name, f"largest_{name}", f"largest {words}", nodes, values, 1)]
    if goes_below_zero(values):
        key, label = "largest_tension", "largest tension"
        if name != "pressure":
            key, label = f"largest_pulling_{name}", f"largest {words} that pulls"
        rows.append(_extreme(name, key, label, nodes, -values, 1, "-{}"))
    return rows


def _section_forces(results: CombinationResult) -> SummarySection:
    """Return the extreme moments and shear forces with their places."""
    plate, model = results.plate, results.model
    rows = [
        _extreme(name, f"{kind}_{name}", f"{kind} moment", plate.nodes, getattr(plate, name), sign)
        for name in ("moment_x", "moment_y")
        for kind, sign in (("largest", 1), ("smallest", -1))
    ]
    for name, words in (("moment_xy", "twisting moment"), ("shear_x", "shear force"), ("shear_y", "shear force")):
        sizes = np.abs(getattr(plate, name))
        rows.append(_extreme(name, f"largest_{name}", f"largest {words}", plate.nodes, sizes, 1, "|{}|"))
    notes: tuple[str, ...] = ()
    loads = [load.on(model.columns) for load in model.loads if load.kind == "point"]
    if any(load.width_x is None and load.diameter is None for load in loads):
        notes = (
            "Under a point load moments and shear forces grow without limit as the mesh is refined: on a thick plate "
            "they are singular. Give it a footprint (width_x and width_y, or diameter).",
        )
    if any(support.kind == "point" for support in model.supports):
        notes += ("At a point support moments and shear forces grow without limit as the mesh is refined.",)
    return SummarySection("section_forces", "Moments and shear forces", tuple(rows), notes)


def _supports(results: CombinationResult) -> SummarySection:
    """Return what the supports carry: each of a few, else the largest and the smallest force and their sum."""
    totals = [(support.total, support) for support in results.supports if len(support.nodes)]
    rows = [
        Row(f"force_{number}", f"force of {support.name}", total, UNITS["kN"], "", _middle(support))
        for number, (total, support) in enumerate(totals, start=1)
    ]
    if len(totals) > MOST_SUPPORTS:
        (low, least), (high, most) = min(totals, key=itemgetter(0)), max(totals, key=itemgetter(0))
        rows = [
            Row("largest_force", f"largest force, of {most.name}", high, UNITS["kN"], "", _middle(most)),
            Row("smallest_force", f"smallest force, of {least.name}", low, UNITS["kN"], "", _middle(least)),
        ]
    rows.append(Row("sum_of_forces", "all supports together", sum(total for total, _ in totals), UNITS["kN"]))
    return SummarySection("supports", "Supports: forces, upwards positive", tuple(rows))


def _middle(support: SupportResult) -> tuple[float, float]:
    """Return the middle of a support's nodes [m]."""
    x, y = support.nodes.mean(axis=0)
    return float(x), float(y)


def certificate_section(certificate: Certificate) -> SummarySection:
    """Return the figures that say how well equilibrium and contact conditions are satisfied, each with its verdict."""
    rows = [
        Row("load", "sum of the loads", certificate.load, UNITS["kN"]),
        Row("reaction", "sum of the reactions", certificate.reaction, UNITS["kN"]),
    ]
    limits = certificate.limits()
    for name, value in certificate.limited().items():
        limit = limits[name]
        rows.append(Row(name, CERTIFICATE_WORDS[name], value, tolerance=limit, ok=bool(value <= limit)))
    notes: tuple[str, ...] = ()
    if "margin_effect" in certificate.too_large():
        notes = (
            "The meshed ground beyond the plate is too narrow or too coarse: make beyond.width larger or mesh.size "
            "smaller.",
        )
    return SummarySection("certificate", "Certificate", tuple(rows), notes)
