"""The main figures of one combination in sections of rows, for the terminal, JSON, the report and the workbench."""

from __future__ import annotations

from dataclasses import replace
from operator import itemgetter
from typing import TYPE_CHECKING

import numpy as np

from groundslab.accuracy.mesh_statistics import POOR, mesh_statistics
from groundslab.arrays import made_once
from groundslab.messages import Label, Message, Name, counted, joined
from groundslab.model.remarks.singular_places import near_singular, notes_on_singular_places
from groundslab.results.contact_zone import CELLS_NOTE, EDGE_NOTE, goes_below_zero, has_line_force, require_finite
from groundslab.results.fields import PLATE_FIELDS, extreme, places_of
from groundslab.units import UNITS
from groundslab.views.summary.cracking import cracking_sections
from groundslab.views.summary.discretization import discretization_section, largest_error, unknown_words, with_error
from groundslab.views.summary.rows import Row, SummarySection, in_units

if TYPE_CHECKING:
    from groundslab.arrays import Array
    from groundslab.model.ground import SoilLayer
    from groundslab.model.model import Model
    from groundslab.model.plate import Plate
    from groundslab.results.records import SupportResult
    from groundslab.results.results import CombinationResult

#: Of loads that are cut off at the plate's edge so many are shown.
MOST_CUT = 12
#: Figures below this share of the largest of their unit are rounding.
NOTHING = 1e-9
#: Of more supports than these only the extremes are shown.
MOST_SUPPORTS = 12


#: What is said of borders that the mesh does not follow.
CROSSED = (
    "An element across the border of a soil zone or void takes the area-weighted mean of the ground in it; in ground "
    "with shear it is all void or not at all. With mesh.size instead of mesh.counts the mesh follows borders that "
    "are not finer than a thousandth of the plan."
)

#: What is said of a mesh with poor elements.
CROOKED = Message(
    "An element has a scaled Jacobian below {poor:g} (1 is a rectangle): near it results are less accurate. Reduce "
    "mesh.size, or omit details of the outline there that do not matter.",
    poor=POOR,
)

#: What is said of the slowest solver where it was not asked for.
SLOW = (
    "Only SuperLU is installed: a factorization takes five to ten times as long as with CHOLMOD, which pip install "
    "groundslab[cholmod] adds (under the GPL)."
)

#: What the figures of the certificate mean, in words.
CERTIFICATE_WORDS = {
    "residual": "residual force at a node",
    "force_balance": "loads against reactions",
    "moment_balance": "moments of loads and reactions",
    "ground_balance": "contact and ground forces",
    "worst_gap": "plate inside the ground (gap < 0)",
    "worst_pressure": "tension in the ground (p < 0)",
    "worst_product": "pressure across an open gap",
    "gamma_change": "last change of gamma",
    "margin_effect": "effect of a wider margin of ground",
    "section_law": "moments against cracked sections",
    "joint_mismatch": "steps across hinges and in the ground",
}
#: The same where cells of pressure bear the plate.
WORDS_OF_CELLS = {"ground_balance": "cells' forces against the plate's"}


def summary(results: CombinationResult) -> list[SummarySection]:
    """Return the sections of the summary, in the order in which they are shown."""
    require_finite(results)
    return [*description(results), *figures(results), certificate_section(results)]


def description(results: CombinationResult) -> list[SummarySection]:
    """Return the sections on the model: plate, mesh, ground, and loads cut off at the plate's edge."""
    plate, mesh, cut = _plate(results), mesh_section(results), cut_loads(results.model)
    units = results.model.units
    return [in_units(plate, units), in_units(mesh, units), description_of_ground(results),
            *(in_units(section, units) for section in cut)]  # fmt: skip


@made_once
def figures(results: CombinationResult) -> list[SummarySection]:
    """Return the sections on the results: settlement, contact, support and section forces, with their errors."""
    units = results.model.units
    return [in_units(section, units) for section in _figures(results)]


def _figures(results: CombinationResult) -> list[SummarySection]:
    supports = [_supports(results)] if results.supports else []
    listed = [_settlement(results), *cracking_sections(results), _contact(results), *supports, _section_forces(results)]
    if results.coarser is None:
        return listed
    coarser = {(section.key, row.key): row for section in _figures(results.coarser) for row in section.rows}
    listed = [
        replace(
            section, rows=tuple(with_error(row, coarser.get((section.key, row.key)), results) for row in section.rows)
        )
        for section in listed
    ]
    return [*listed, discretization_section(results)]


def certified_words(count: int) -> str:
    """Return in words what a certificate of so many results says, and what it does not say."""
    return counted(
        count,
        "The result is certified: equilibrium and contact conditions are satisfied on this mesh. "
        "This is not a design approval.",
        "The results of all {count} combinations are certified: equilibrium and contact conditions are satisfied on "
        "this mesh. This is not a design approval.",
    )


def _plate(results: CombinationResult) -> SummarySection:
    """Return the plate as it was analyzed, or all of several plates."""
    if results.model.plates:
        return _plates(results)
    plate = results.model.plate
    rows = (
        Row("length_x", "length along x", plate.sides[0], UNITS["m"]),
        Row("length_y", "length along y", plate.sides[1], UNITS["m"]),
        Row("area", "area", float(results.plate.area.sum()), UNITS["m2"]),
        Row("thickness", "thickness", plate.thickness, UNITS["m"], "t"),
        Row("E", "Young's modulus", plate.E, UNITS["MPa"], "E"),
        Row("nu", "Poisson's ratio", plate.nu, None, "nu"),
        _supported_edges(plate),
    )
    borders = _borders(results)
    return SummarySection("plate", "Plate", rows + borders, (CROSSED,) if borders else ())


def _plates(results: CombinationResult) -> SummarySection:
    """Return several plates as they were analyzed: what all of them make up, then one by one."""
    plates, (x, y) = results.model.every_plate, results.model.sides
    total = (
        Row("plates", "plates", len(plates)),
        Row("length_x", "all of them along x", x, UNITS["m"]),
        Row("length_y", "all of them along y", y, UNITS["m"]),
        Row("area", "area of all", float(results.plate.area.sum()), UNITS["m2"]),
    )
    one_by_one = tuple(
        Row(
            f"plate_{number}",
            plate.name or Message("plate {number}", number=number),
            Message(
                "{x:.6g (m)} x {y:.6g m}, t {t:.6g m}, E {E:.6g MPa}, nu {nu:.6g}",
                x=plate.sides[0],
                y=plate.sides[1],
                t=plate.thickness,
                E=plate.E / 1e6,
                nu=plate.nu,
            ),
        )
        for number, plate in enumerate(plates, 1)
    )
    borders = _borders(results)
    supported = _supported_edges(results.model.plate)
    rows = (*total, *one_by_one, *([] if supported.value == "none" else [supported]), *borders)
    return SummarySection("plate", "Plates", rows, (CROSSED,) if borders else ())


def _supported_edges(plate: Plate) -> Row:
    """Return which edges of a plate are supported."""
    sides = ("left", "right", "bottom", "top")
    words = [
        Message("{side} {kind}", side=side, kind=kind)
        for side in sides
        if (kind := getattr(plate.edges, side)) != "free"
    ]
    return Row("supports", "supported edges", joined(words) or "none")


def mesh_section(results: CombinationResult) -> SummarySection:
    """Return the elements on the plate, their sizes and quality, and the unknowns that were solved for."""
    mesh = mesh_statistics(results)
    directions = [name for name, used in zip("xy", results.symmetry, strict=True) if used]
    rows = (
        Row("element", "element", results.model.plate.element),
        Row("elements", "elements on the plate", mesh.elements),
        Row("smallest_side", "smallest element, sqrt(area)", mesh.smallest, UNITS["m"], "", mesh.smallest_place),
        Row("largest_side", "largest element, sqrt(area)", mesh.largest, UNITS["m"], "", mesh.largest_place),
        Row("worst_quality", "worst scaled Jacobian", round(mesh.worst_quality, 4), None, "", mesh.worst_place),
        Row("mean_quality", "mean scaled Jacobian", round(mesh.mean_quality, 4)),
        Row("unknowns", "unknowns", mesh.unknowns),
        Row("symmetry", "symmetry used along", joined(directions, " and ") or "none"),
        Row("solver", "solver", results.solver),
    )
    notes: list[str] = [CROOKED] if mesh.worst_quality < POOR else []
    if results.solver == "superlu" and results.model.analysis.solver == "auto":
        notes.append(SLOW)
    return SummarySection("mesh", "Mesh", rows, tuple(notes))


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
            key: str = name
            label: str = meaning
            if several:
                key = f"{name}_{number}"
                label = Message("{meaning}, layer {number}", meaning=meaning, number=number)
            rows.append(Row(key, label, value, unit, key))
    if constants.gamma is not None:
        rows.append(Row("gamma", "decay of the mode", constants.gamma, None, "gamma"))
        rows.append(Row("gamma_iterations", "iterations for gamma", constants.gamma_iterations))
    if constants.limit_depth is not None:
        rows.append(Row("limit_depth", "limit depth", constants.limit_depth, UNITS["m"]))
    if results.coarser is not None:
        coarser = {row.key: row for row in description_of_ground(results.coarser).rows}
        rows = [with_error(row, coarser.get(row.key), results) for row in rows]
    section = SummarySection("ground", "Ground", (rows[0], *_continuum(results), *rows[1:]))
    return in_units(section, results.model.units)


def _continuum(results: CombinationResult) -> tuple[Row, ...]:
    """Return the layers of an elastic continuum and its cells of pressure, nothing of other ground."""
    ground, cells = results.model.ground, results.ground.cells
    if cells is None:
        return ()
    layers: tuple[SoilLayer, ...] = getattr(ground, "layers", ())
    depth, below = sum(layer.thickness for layer in layers), "nothing settles"
    if cells.bonded:
        below = "rigid base" if getattr(ground, "half_space", None) is None else "half-space"
    words = "bonded elastic layers" if cells.bonded else "layers, under a half-space's stresses"
    return (
        Row("layers", words, len(layers)),
        *([Row("depth", "depth of the layers", depth, UNITS["m"])] if depth else []),
        Row("below", "below the layers", below),
        Row("beyond", "beyond the plate", "the same ground, infinite"),
        Row("cells", "cells of pressure under the plate", len(cells.force)),
        Row("cell_x", "side of a cell along x", float(cells.size[0]), UNITS["m"]),
        Row("cell_y", "side of a cell along y", float(cells.size[1]), UNITS["m"]),
    )


def _borders(results: CombinationResult) -> tuple[Row, ...]:
    """Return the areas of soil zones and voids whose borders the mesh does not follow."""
    from groundslab.results.soil_profile import crossed_borders

    words = {
        "drawn": "{name} as drawn", "meshed": "{name} on the mesh", "crossed": "elements across the border of {name}",
    }  # fmt: skip
    return tuple(
        Row(f"{border.name}.{key}", Message(label, name=Name(border.name)), getattr(border, key), UNITS["m2"])
        for border in crossed_borders(results)
        for key, label in words.items()
    )


def cut_loads(model: Model) -> list[SummarySection]:
    """Return the parts of loads that do not act, nothing where all of them act."""
    from groundslab.model.loads.clipping import find_clipped_loads

    clipped = find_clipped_loads(model.plate, model.loads, model.plates, model.walls, model.spans)
    if not clipped:
        return []
    rows = []
    for cut in clipped[:MOST_CUT]:
        name = Name(f"loads[{cut.number}]" + (f" {cut.name}" if cut.name else ""))
        rows.append(Row(f"share_{cut.number}", joined((name, cut.where)), cut.share, UNITS["%"]))
        rows.append(Row(f"force_{cut.number}", Message("{name}, without effect", name=name), cut.force, UNITS["kN"]))
    if len(clipped) > MOST_CUT:
        rows.append(Row("more", "more loads cut off", len(clipped) - MOST_CUT))
    rows.append(Row("sum_of_forces", "total without effect", sum(cut.force for cut in clipped), UNITS["kN"]))
    note = (
        "Area and line loads act where they lie on the plate, loads on the ground where they lie off it. Forces "
        "exclude the factors of combinations."
    )
    return [SummarySection("cut_loads", "Loads cut off at the edge of the plate", tuple(rows), (note,))]


def _extreme(name: str, key: str, label: str, nodes: Array, values: Array, sign: int, symbol: str = "{}") -> Row:
    """Return the largest (sign 1) or smallest (sign -1) of values (n,) of a field with its place."""
    about = PLATE_FIELDS[name]
    value, place = extreme(nodes, values, sign)
    return Row(key, label, value, about.display, symbol.format(about.symbol), place, values=sign * values, of=name)


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
    elif results.ground.cells is not None:
        notes = (CELLS_NOTE,)
    return SummarySection("contact", "Contact", tuple(rows), notes)


def _pressures(nodes: Array, values: Array, name: str, words: str = "pressure") -> list[Row]:
    """Return the largest of the pressures or line forces at nodes, and the largest tension if the ground pulls."""
    rows = [_extreme(name, f"largest_{name}", Message("largest {quantity}", quantity=words), nodes, values, 1)]
    if goes_below_zero(values):
        key, label = "largest_tension", "largest tension"
        if name != "pressure":
            key, label = f"largest_pulling_{name}", Message("largest tensile {quantity}", quantity=words)
        rows.append(_extreme(name, key, label, nodes, -values, 1, "-{}"))
    return rows


def _section_forces(results: CombinationResult) -> SummarySection:
    """Return the extreme moments and shear forces with their places."""
    plate = results.plate
    rows = [
        _extreme(name, f"{kind}_{name}", Label(f"{kind} moment"), plate.nodes, getattr(plate, name), sign)
        for name in ("moment_x", "moment_y")
        for kind, sign in (("largest", 1), ("smallest", -1))
    ]
    for name, words in (("moment_xy", "twisting moment"), ("shear_x", "shear force"), ("shear_y", "shear force")):
        sizes = np.abs(getattr(plate, name))
        rows.append(_extreme(name, f"largest_{name}", Label(f"largest {words}"), plate.nodes, sizes, 1, "|{}|"))
    if notes := notes_on_singular_places(results.solved_model, " (*)"):
        thickness = results.elements.at_nodes(plate)[0]
        nodes = near_singular(results.solved_model, plate.nodes, thickness).nonzero()[0]
        singular = {(x, y) for x, y in places_of(plate.nodes[nodes]).tolist()}
        rows = [replace(row, singular=row.place in singular) for row in rows]
    return SummarySection("section_forces", "Moments and shear forces", tuple(rows), notes)


def _supports(results: CombinationResult) -> SummarySection:
    """Return the support forces: each of a few, else the largest and the smallest and their sum."""
    totals = [(support.total, support) for support in results.supports if len(support.nodes)]
    rows = [
        Row(
            f"force_{number}",
            Message("force of {name}", name=Name(support.name)),
            total,
            UNITS["kN"],
            "",
            _middle(support),
        )
        for number, (total, support) in enumerate(totals, start=1)
    ]
    if len(totals) > MOST_SUPPORTS:
        (low, least), (high, most) = min(totals, key=itemgetter(0)), max(totals, key=itemgetter(0))
        rows = [
            Row(
                "largest_force",
                joined(("largest force", Message("of {name}", name=Name(most.name)))),
                high,
                UNITS["kN"],
                "",
                _middle(most),
            ),
            Row(
                "smallest_force",
                joined(("smallest force", Message("of {name}", name=Name(least.name)))),
                low,
                UNITS["kN"],
                "",
                _middle(least),
            ),
        ]
    rows.append(Row("sum_of_forces", "all supports together", sum(total for total, _ in totals), UNITS["kN"]))
    return SummarySection("supports", "Supports: forces, upwards positive", tuple(rows))


def _middle(support: SupportResult) -> tuple[float, float]:
    """Return the middle of a support's nodes [m]."""
    x, y = support.nodes.mean(axis=0)
    return float(x), float(y)


def certificate_section(results: CombinationResult) -> SummarySection:
    """Return the figures that say how well equilibrium and contact conditions are satisfied, each with its verdict.

    And how far the mesh is from its limit, beside what was asked for.
    """
    certificate = results.certificate
    rows = [
        Row("load", "sum of the loads", certificate.load, UNITS["kN"]),
        Row("reaction", "sum of the reactions", certificate.reaction, UNITS["kN"]),
    ]
    if certificate.ground_load:
        rows.append(Row("ground_load", "sum of the loads off the plate", certificate.ground_load, UNITS["kN"]))
    limits = certificate.limits()
    words = CERTIFICATE_WORDS if results.ground.cells is None else CERTIFICATE_WORDS | WORDS_OF_CELLS
    for name, value in certificate.limited().items():
        limit = limits[name]
        rows.append(Row(name, words[name], value, tolerance=limit, ok=bool(value <= limit)))
    notes: tuple[str, ...] = ()
    if "margin_effect" in certificate.too_large():
        notes = (
            "The meshed ground beyond the plate is too narrow or too coarse: increase beyond.width or reduce "
            "mesh.size.",
        )
    unknown = unknown_words(results)
    notes = (*notes, unknown) if unknown else notes
    section = SummarySection("certificate", "Certificate", (*rows, *largest_error(results)), notes)
    return in_units(section, results.model.units)
