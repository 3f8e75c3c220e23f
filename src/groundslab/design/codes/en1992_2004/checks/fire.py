"""Resistance to fire by the tabulated data of EN 1992-1-2:2004: a slab's thickness, and its bars' distance from faces.

Table 5.8 was read second hand, in two open programs that agree: PlaatBrandwerendheid.cs, by the Dutch edition, and a
service that designs continuous slabs, its FIRE_TABLE_5_8. The values of slabs that carry in one direction are taken,
whose distances are the larger ones. The thickness is needed to separate (E and I), not to carry (R): 5.7.1. Concrete
above C50/60 needs more (section 6), which is not known here: it is never shown to be enough.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from groundslab.design.codes.en1992_2004.materials_of_case import strengths
from groundslab.design.rules.calculation import Step
from groundslab.design.rules.check import DesignCheck
from groundslab.messages import Message
from groundslab.model.design.laid_bars import axis_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import place_of
from groundslab.results.results import CombinationResult

_MM = 1e3
#: By the minutes: the least thickness h_s and the least distance a of the bars' axes from the heated face [mm].
TABLE_5_8 = {30: (60, 10), 60: (80, 20), 90: (100, 30), 120: (120, 40), 180: (150, 55), 240: (175, 65)}
#: Faces that are heated, by where the fire is.
HEATED = {"above": ("top",), "below": ("bottom",), "both": ("top", "bottom")}
#: Lengths [mm] that differ by less are the same.
ROUNDING = 1e-6
#: Concrete that is stronger [Pa] is high strength concrete.
HIGH_STRENGTH = 50e6
_CLAUSE = "EN 1992-1-2 5.7.2, Table 5.8"


def checks(results: CombinationResult, steel: Reinforcement) -> Iterator[DesignCheck]:
    """Yield the checks of the case's class of resistance to fire, given any results."""
    if steel.fire is None:
        return
    criteria, minutes = steel.fire.split()
    h_s, a = TABLE_5_8[int(minutes)]
    fire_checks = [_axes(steel, float(a))]
    if criteria == "REI":
        fire_checks.append(_thickness(results, steel.fire, float(h_s)))
    strong = strengths(steel)[0] > HIGH_STRENGTH
    yield from (_of_high_strength(check) if strong else check for check in fire_checks)


def _axes(steel: Reinforcement, least: float) -> DesignCheck:
    """Return whether all bars lie at least so far [mm] from the faces that are heated."""
    layers = [f"{face}_{axis}" for face in HEATED[steel.fire_from] for axis in "xy"]
    layer = min(layers, key=lambda name: axis_of(steel, name))
    words = {"above": "from above", "below": "from below", "both": "from above and below"}[steel.fire_from]
    name, a = layer.replace("_", " "), axis_of(steel, layer) * _MM
    steps = (
        Step("distance of the bars' axis from the heated face", "a", a, "mm"),
        Step(
            Message("least distance, {fire}", fire=str(steel.fire)),
            "a_min",
            least,
            "mm",
            clause="EN 1992-1-2 Table 5.8",
        ),
        Step("share used", "eta", least / a, "", "a_min / a"),
    )
    return _compare(
        "bars' distance from fire",
        (a, least),
        Message("{fire}, fire {text}", fire=str(steel.fire), text=words),
        name,
        None,
        steps,
    )


def _thickness(results: CombinationResult, fire: str, least: float) -> DesignCheck:
    """Return whether the slab is at least so thick [mm]."""
    thickness = results.elements.at_nodes(results.plate)[0]
    node = int(thickness.argmin())
    h = float(thickness[node]) * _MM
    steps = (
        Step("least thickness of the slab", "h", h, "mm"),
        Step(
            Message("thickness that separates, {fire}", fire=str(fire)),
            "h_s",
            least,
            "mm",
            clause="EN 1992-1-2 Table 5.8",
        ),
        Step("share used", "eta", least / h, "", "h_s / h"),
    )
    place = place_of(results.plate.nodes, node)
    return _compare("thickness against fire", (h, least), fire, "", place, steps)


def _of_high_strength(check: DesignCheck) -> DesignCheck:
    """Return a check of concrete above C50/60: what the table asks for is not enough of it."""
    words = Message(
        "{text}; concrete above C50/60 needs more, which is not known here (EN 1992-1-2 section 6)", text=check.words
    )
    return replace(check, status="attention", words=words)


def _compare(
    name: str,
    values: tuple[float, float],
    what: str,
    of: str,
    place: tuple[float, float] | None,
    steps: tuple[Step, ...],
) -> DesignCheck:
    """Return the check of a length and the least one [mm]; where it is less, the table alone does not show enough."""
    value, least = values
    holds = value >= least - ROUNDING
    about = Message("{of}: ", of=of) if of else ""
    more = "" if holds else "; a calculation by EN 1992-1-2 4.2 or 4.3 may show what the table does not"
    return DesignCheck(
        name,
        "no failure found" if holds else "attention",
        about
        + Message(
            "{value:.4g (mm)} {sign} {least:.4g mm} for {what} (Table 5.8)",
            value=value,
            sign=">=" if holds else "<",
            least=least,
            what=what,
        )
        + more,
        of=of,
        demand=value,
        resistance=least,
        unit="mm",
        least=True,
        clause=_CLAUSE,
        place=place,
        steps=steps,
    )
