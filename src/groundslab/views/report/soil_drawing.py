"""The columns of soil as a drawing: layers to one scale of depth, with k0 and k1, and the mode psi(z) beside them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from groundslab.units import UNITS, Unit, format_number, show
from groundslab.views.report import svg

if TYPE_CHECKING:
    from markupsafe import Markup

    from groundslab.results.soil_profile import Profile, Stratum
    from groundslab.views.report.svg import Point

#: More columns than these are not drawn.
MOST = 6
#: What a column takes [px]: the layers themselves, the mode, words; the depth; what stands above and below.
LAYERS, MODE, WORDS, DEPTH, ABOVE, BELOW, AXIS = 46.0, 64.0, 150.0, 300.0, 40.0, 22.0, 44.0
#: Columns in one row.
IN_A_ROW = 3
LINE = 13.0


def soil_drawing(profiles: Sequence[Profile]) -> Markup | None:
    """Return the columns of soil, of many the first; nothing if there are no layers."""
    drawn = [profile for profile in profiles if profile.strata][:MOST]
    if not drawn:
        return None
    deepest = max(profile.strata[-1].bottom for profile in drawn)
    room = AXIS + LAYERS + MODE + WORDS
    rows = -(-len(drawn) // IN_A_ROW)
    high = ABOVE + DEPTH + BELOW + 3 * LINE
    parts: list[Markup] = []
    for n, profile in enumerate(drawn):
        x, y = room * (n % IN_A_ROW), high * (n // IN_A_ROW)
        parts += _column(profile, (x, y + ABOVE), DEPTH / deepest)
    return svg.drawing(room * min(len(drawn), IN_A_ROW), high * rows, "Columns of soil", *parts)


def _column(profile: Profile, at: Point, scale: float) -> Iterator[Markup]:
    """Yield one column: its name, depths, layers with their words, mode, constants."""
    x, top = at[0] + AXIS, at[1]
    base = top + profile.strata[-1].bottom * scale
    yield svg.text((x, top - 26), profile.name, "d-text d-strong")
    words = _apart([top + (layer.top + layer.bottom) / 2 * scale for layer in profile.strata], top + LINE)
    right = x + LAYERS + (MODE if len(profile.z) else 0.0)
    for n, (layer, y) in enumerate(zip(profile.strata, words, strict=True)):
        upper, lower = top + layer.top * scale, top + layer.bottom * scale
        yield svg.element("rect", x=x, y=upper, width=LAYERS, height=lower - upper, class_=f"d-layer d-layer-{n % 4}")
        yield svg.line((x - 4, lower), (x, lower), "d-thin")
        yield svg.path([(right, (upper + lower) / 2), (right + 8, y - 4), (right + 12, y - 4)], "d-leader")
        first, second = _words(layer, n + 1)
        yield svg.text((right + 15, y - 6), first)
        yield svg.text((right + 15, y - 6 + LINE), second, "d-text d-muted")
    for depth, y in zip(_depths(profile.strata), _depths_at(profile.strata, top, scale), strict=True):
        yield svg.text((x - 7, y + 4), f"{depth:.6g}", "d-text", "end")
    yield svg.text((x - 7, top - 8), "z [m]", "d-text d-muted", "end")
    yield svg.line((x - 8, top), (right, top), "d-surface")
    yield svg.line((x - 8, base), (x + LAYERS + 8, base), "d-rock")
    if len(profile.z):
        yield from _mode(profile, (x + LAYERS, top), scale)
    for n, line in enumerate(_constants(profile)):
        yield svg.text((x, base + BELOW - 4 + LINE * n), line, "d-text")


def _mode(profile: Profile, at: Point, scale: float) -> Iterator[Markup]:
    """Yield the mode from 0 at its axis, which is the right edge of the layers, to 1."""
    x, top = at
    wide = MODE - 12
    z = np.linspace(0.0, float(profile.z[-1]), 61)
    psi = np.interp(z, profile.z, profile.psi)
    curve = [(x + wide * float(value), top + float(depth) * scale) for depth, value in zip(z, psi, strict=True)]
    yield svg.path([(x, top), *curve, (x, top + float(z[-1]) * scale)], "d-mode-area", closed=True)
    yield svg.path(curve, "d-mode")
    yield svg.text((x + wide, top - 8), "1", "d-text d-muted", "middle")
    yield svg.text((x + 2, top - 8), "ψ(z)", "d-text d-of-section")


def _words(layer: Stratum, number_of: int) -> tuple[str, str]:
    """Return what is written beside a layer, on two lines."""
    modulus = show(layer.E, "pressure")
    if layer.E_bottom != layer.E:
        modulus += f" to {show(layer.E_bottom, 'pressure')}"
    varies = ", quadratic" if layer.variation == "quadratic" and layer.E_bottom != layer.E else ""
    return f"{number_of}: E = {modulus}{varies}", f"ν = {layer.nu:.6g}, h = {layer.bottom - layer.top:.6g} m"


def _constants(profile: Profile) -> Iterator[str]:
    """Yield gamma, k0 and k1 as lines; of layers that have their own only if they are few."""
    if profile.gamma is not None:
        yield f"γ = {format_number(profile.gamma)}"
    constants: tuple[tuple[str, tuple[float, ...], Unit], ...] = (
        ("k0", profile.k0, UNITS["MPa/m"]), ("k1", profile.k1, UNITS["MPa m"]),
    )  # fmt: skip
    for name, values, unit in constants:
        if 0 < len(values) <= 3:
            yield f"{name} = {', '.join(format_number(value * unit.scale) for value in values)} {unit.name}"


def _depths(strata: Sequence[Stratum]) -> list[float]:
    """Return the depths of the layers' ends [m]."""
    return [0.0, *(layer.bottom for layer in strata)]


def _depths_at(strata: Sequence[Stratum], top: float, scale: float) -> list[float]:
    """Return where the depths are written."""
    return _apart([top + depth * scale for depth in _depths(strata)], -np.inf, LINE - 2)


def _apart(wanted: Sequence[float], least: float, step: float = 2 * LINE + 2) -> list[float]:
    """Return places from the top downwards, each where it is wanted or a step below the one before."""
    found: list[float] = []
    for place in wanted:
        found.append(max(place, found[-1] + step if found else least))
    return found
