"""Bars that are laid by ACI 318-19: how far apart, for cracks, for shrinkage and temperature, and their cover."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.aci318.bending import LEAST, minimum
from groundslab.design.codes.aci318.materials_of_case import materials
from groundslab.design.rules.bar_checks import ROUNDING, check_clear, check_cover, check_spacing, cover_steps, covers
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.design.rules.check import DesignCheck
from groundslab.design.rules.combinations import solved_results
from groundslab.messages import Message
from groundslab.model.design.laid_bars import LaidBars, axis_of, bars_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import LAYERS, place_of
from groundslab.results.results import Results
from groundslab.unit_systems import INCH, KIP, System

_MM, _CM2 = 1e3, 1e4
#: The formula of `crack_spacing`, in mm, with stresses in MPa and covers in m.
FORMULAS = {"s_max": "min({0:g} * {2:g} / f_s - 2.5 * 1000 * c_c, {1:g} * {2:g} / f_s)"}
#: Its lengths [mm] and stress [MPa] in 318M, and in the edition in inches: 15 in, 12 in, 40,000 psi.
CRACKS: Mapping[System, tuple[float, float, float]] = MappingProxyType(
    {"SI": (380.0, 300.0, 280.0), "US": (381.0, 304.8, round(40 * KIP / INCH**2 / 1e6, 4))}
)
#: Bars are no farther apart than so many thicknesses, but so much [m] in any case, and so much [m] at most.
SPACING = (2.0, 0.0, 0.45)
#: Clear distance of bars: the least [m], the factor of the aggregate's size, and nothing more.
CLEAR = (0.025, 4 / 3, 0.0)
#: Covers [m] of ACI 318-19 Table 20.5.1.3.1, in 318M and in inches: cast against the ground; otherwise in contact with
#: it, of bars from No. 6 (19 mm) on and of thinner ones; of slabs not exposed.
COVERS: Mapping[System, tuple[float, float, float, float]] = MappingProxyType(
    {"SI": (0.075, 0.050, 0.038, 0.019), "US": (3 * INCH, 2 * INCH, 1.5 * INCH, 0.75 * INCH)}
)
#: Diameter [m] from which bars are thick in that table.
THICK = 0.019


def checks(combined: Results, steel: Reinforcement, laid: dict[str, LaidBars]) -> Iterator[DesignCheck]:
    """Yield the checks of bars that are laid, by layer."""
    yield check_spacing(solved_results(combined)[0], laid, SPACING, "ACI 318-19", "8.7.2.2")
    yield check_clear(steel, laid, CLEAR, "ACI 318-19", "25.2.1")
    yield _cracks(steel, laid, combined.model.units)
    yield _shrinkage(combined, laid)
    yield _cover(steel, combined.model.units)


def _cracks(steel: Reinforcement, laid: dict[str, LaidBars], units: System) -> DesignCheck:
    """Return whether bars are near enough to each other to distribute cracks (24.3.2), at two thirds of f_y.

    ACI 318 asks it of slabs that are reinforced in one direction (24.3.1), so that others need attention only.
    """
    f_s = crack_stress(steel)
    allowed = {
        layer: crack_spacing(f_s, axis_of(steel, layer) - bars.diameter / 2, units) for layer, bars in laid.items()
    }
    layer = max(laid, key=lambda name: float((laid[name].spacing / allowed[name]).max()))
    node = int(np.argmax(laid[layer].spacing / allowed[layer]))
    spacing, most = float(laid[layer].spacing[node]) * _MM, float(allowed[layer][node]) * _MM
    holds, name = spacing <= most, layer.replace("_", " ")
    cover = axis_of(steel, layer) - float(laid[layer].diameter[node]) / 2
    return DesignCheck(
        "distance of bars for cracks",
        "no failure found" if holds else "attention",
        Message(
            "{name}: {spacing:.4g (mm)} {sign} {most:.4g mm}, at f_s {f_s:.4g MPa} (24.3.2), which is asked "
            "of slabs that are reinforced in one direction (24.3.1)",
            name=name,
            spacing=spacing,
            sign="<=" if holds else ">",
            most=most,
            f_s=f_s / MEGA,
        ),
        of=name,
        demand=spacing,
        resistance=most,
        unit="mm",
        clause="ACI 318-19 24.3.2",
        steps=(
            Step("specified yield strength", "f_y", materials(steel)[1].f_y / MEGA, "MPa", clause="20.2.2"),
            Step("stress of the bars", "f_s", f_s / MEGA, "MPa", "2 / 3 * f_y", "24.3.2.1"),
            Step("cover of the bars", "c_c", cover, "m"),
            Step("largest distance", "s_max", most, "mm", FORMULAS["s_max"].format(*CRACKS[units]), "Table 24.3.2"),
            Step("distance of the bars", "s", spacing, "mm"),
            Step("share used", "eta", spacing / most, "", "s / s_max"),
        ),
    )


def crack_stress(steel: Reinforcement) -> float:
    """Return f_s [Pa] that distances of bars are for, two thirds of f_y (24.3.2.1)."""
    return 2 / 3 * materials(steel)[1].f_y


def crack_spacing(f_s: float, cover: Array, units: System) -> Array:
    """Return the largest distance (n,) [m] of bars at a stress f_s [Pa] and covers (n,) [m], Table 24.3.2.

    It is that of the edition in the units.
    """
    first, second, stress = CRACKS[units]
    stressed = stress * MEGA / f_s
    return np.minimum(first / _MM * stressed - 2.5 * cover, second / _MM * stressed)


def _shrinkage(combined: Results, laid: dict[str, LaidBars]) -> DesignCheck:
    """Return whether both faces together have the bars for shrinkage and temperature in each direction (24.4.3.2)."""
    results = solved_results(combined)[0]
    thickness = results.elements.at_nodes(results.plate)[0]
    least = minimum(thickness, thickness)
    areas = {axis: laid[f"bottom_{axis}"].area + laid[f"top_{axis}"].area for axis in "xy"}
    axis = max(areas, key=lambda name: float((least / areas[name]).max()))
    node = int(np.argmax(least / areas[axis]))
    demand, resistance = float(least[node]) * _CM2, float(areas[axis][node]) * _CM2
    holds = demand <= resistance
    x, y = place_of(results.plate.nodes, node)
    return DesignCheck(
        "bars for shrinkage and temperature",
        "no failure found" if holds else "fails",
        Message(
            "along {axis}: {demand:.4g (cm2/m)} {sign} {resistance:.4g cm2/m} of both faces at {place:.3f m} "
            "(24.4.3.2)",
            axis=axis,
            demand=demand,
            sign="<=" if holds else ">",
            resistance=resistance,
            place=(x, y),
        ),
        of=Message("along {axis}", axis=axis),
        demand=demand,
        resistance=resistance,
        unit="cm2/m",
        clause="ACI 318-19 24.4.3.2",
        place=(x, y),
        steps=(
            Step("thickness", "h", float(thickness[node]), "m"),
            Step("least area of both faces", "A_min", demand, "cm2/m", f"{LEAST:g} * h * 10000", "24.4.3.2"),
            Step("area of the bars that are laid", "A_s", resistance, "cm2/m"),
            Step("share used", "eta", demand / resistance, "", "A_min / A_s"),
        ),
    )


def least_cover(layer: str, diameter: float, units: System) -> float:
    """Return the cover [m] that a bar of a layer needs, formed or on blinding, the top not exposed."""
    _, thick, thin, inside = COVERS[units]
    if layer.startswith("top"):
        return inside
    return thin if diameter < THICK else thick


def _cover(steel: Reinforcement, units: System) -> DesignCheck:
    """Return whether the cover is that of Table 20.5.1.3.1: at the bottom in contact with ground, at the top inside."""
    least = {layer: [least_cover(layer, bars.diameter, units) for bars in bars_of(steel, layer)] for layer in LAYERS}
    where = "formed or on blinding, the top not exposed (Table 20.5.1.3.1)"

    def why(layer: str, diameter: float) -> Iterator[Step]:
        where = "in contact with the ground" if layer.startswith("bottom") else "not exposed"
        return _least_cover_step(least_cover(layer, diameter, units), where)

    check = check_cover(steel, least, where, "ACI 318-19 20.5.1.3.1", why)
    against_ground = COVERS[units][0]
    bottom, layer, position = min((c, layer, n) for layer, c, n in covers(steel) if layer.startswith("bottom"))
    if check.status == "fails" or bottom >= against_ground - ROUNDING:
        return check
    diameter = bars_of(steel, layer)[position].diameter
    why_more = _least_cover_step(against_ground, "cast against the ground")
    words = Message(
        "bottom: {bottom:.4g mm}; cast against the ground it needs {against_ground:.4g mm}",
        bottom=bottom * _MM,
        against_ground=against_ground * _MM,
    )
    return replace(
        check,
        status="attention",
        words=Message("{text} (Table 20.5.1.3.1)", text=words),
        of="bottom",
        demand=bottom * _MM,
        resistance=against_ground * _MM,
        steps=tuple(cover_steps(bottom, diameter, against_ground, why_more)),
    )


def _least_cover_step(cover: float, where: str) -> Iterator[Step]:
    """Yield the cover [m] that the table asks for."""
    yield Step(Message("least cover, {where}", where=where), "c_nom", cover * _MM, "mm", clause="Table 20.5.1.3.1")
