"""Bars that are laid by ACI 318-19: how far apart, and their cover."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from groundslab.design.basis.bar_checks import ROUNDING, check_cover, check_spacing, covers
from groundslab.design.basis.check import DesignCheck
from groundslab.design.basis.combinations import solved_results
from groundslab.model.design.laid_bars import LaidBars, bars_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import LAYERS
from groundslab.results.results import Results

_MM = 1e3
#: Bars are no farther apart than so many thicknesses, but so much [m] in any case, and so much [m] at most.
SPACING = (2.0, 0.0, 0.45)
#: Covers [m] of ACI 318-19 Table 20.5.1.3.1, the lesser of inches and of 318M: cast against the ground; otherwise in
#: contact with it, of bars from No. 6 (19 mm) on and of thinner ones; of slabs not exposed.
AGAINST_GROUND, _GROUND, _THIN, _INSIDE = 0.075, 0.050, 0.038, 0.019
#: Diameter [m] from which bars are thick in that table.
THICK = 0.019


def checks(combined: Results, steel: Reinforcement, laid: dict[str, LaidBars]) -> Iterator[DesignCheck]:
    """Yield the checks of bars that are laid, by layer."""
    yield check_spacing(solved_results(combined)[0], laid, SPACING, "ACI 318-19", "8.7.2.2")
    yield _cover(steel)


def least_cover(layer: str, diameter: float) -> float:
    """Return the cover [m] that a bar of a layer needs, formed or on blinding, the top not exposed."""
    if layer.startswith("top"):
        return _INSIDE
    return _THIN if diameter < THICK else _GROUND


def _cover(steel: Reinforcement) -> DesignCheck:
    """Return whether the cover is that of Table 20.5.1.3.1: at the bottom in contact with ground, at the top inside."""
    least = {layer: [least_cover(layer, bars.diameter) for bars in bars_of(steel, layer)] for layer in LAYERS}
    where = "formed or on blinding, the top not exposed (Table 20.5.1.3.1)"
    check = check_cover(steel, least, where, "ACI 318-19 20.5.1.3.1")
    bottom = min(cover for layer, cover, _ in covers(steel) if layer.startswith("bottom"))
    if check.status == "fails" or bottom >= AGAINST_GROUND - ROUNDING:
        return check
    words = f"bottom: {bottom * _MM:.4g} mm; cast against the ground it needs {AGAINST_GROUND * _MM:.4g} mm"
    return replace(
        check, status="attention", words=f"{words} (Table 20.5.1.3.1)", of="bottom", demand=bottom * _MM,
        resistance=AGAINST_GROUND * _MM,
    )  # fmt: skip
