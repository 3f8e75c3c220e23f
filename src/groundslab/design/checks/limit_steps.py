"""Settlements, tilt and pressures against the limits of a case, step by step, as they can be followed by hand.

Every value is that of the check, in its unit of display.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.arrays import Array
from groundslab.design.demands.edge_strip import Strip
from groundslab.design.demands.tilt import AreaMeans, Sag
from groundslab.design.rules.calculation import Step
from groundslab.messages import Message, Name
from groundslab.results.fields import place_of
from groundslab.results.plate_result import PlateResult

_MM, _K = 1e3, 1e3
#: What a limit is compared with, as the last step before it calls it: its symbol by the keys of [limits].
SYMBOLS = {
    "settlement": "w_max", "uplift": "u_max", "differential_settlement": "Delta_w", "tilt": "omega",
    "angular_distortion": "beta", "deflection": "Delta_l", "pressure": "p_max", "mean_pressure": "p_m",
    "contact_share": "a",
}  # fmt: skip


def of_settlement(w: float) -> Iterator[Step]:
    """Yield the largest settlement w [m] of the slab."""
    yield Step("settlement at the place", "w", w * _MM, "mm")
    yield Step("settlement that counts", "w_max", max(w, 0.0) * _MM, "mm", "max(w, 0)")


def of_uplift(w: float) -> Iterator[Step]:
    """Yield the largest uplift, w [m] being the settlement there."""
    yield Step("settlement at the place", "w", w * _MM, "mm")
    yield Step("uplift", "u_max", max(-w, 0.0) * _MM, "mm", "max(-1 * w, 0)")


def of_difference(plate: PlateResult) -> Iterator[Step]:
    """Yield the largest less the smallest settlement of a plate."""
    w = plate.settlement
    most, least = int(np.argmax(w)), int(np.argmin(w))
    yield Step(Message("largest settlement{at}", at=_at(plate.nodes, most)), "w_1", float(w[most]) * _MM, "mm")
    yield Step(Message("smallest settlement{at}", at=_at(plate.nodes, least)), "w_2", float(w[least]) * _MM, "mm")
    yield Step("difference", "Delta_w", float(np.ptp(w)) * _MM, "mm", "w_1 - w_2")


def _at(nodes: Array, node: int) -> str:
    """Return where a node is, in words."""
    x, y = place_of(nodes, node)
    return Message(", at {place:.3f m}", place=(x, y))


def of_tilt(means: AreaMeans, slope: tuple[float, float]) -> Iterator[Step]:
    """Yield the slope of the plane that fits the settlements best, with its slopes along x and y."""
    yield from _plane(means, slope)
    yield Step("slope of the plane", "omega", float(np.hypot(*slope)) * _MM, "mm/m", "sqrt(omega_x^2 + omega_y^2)")


def _plane(means: AreaMeans, slope: tuple[float, float]) -> Iterator[Step]:
    """Yield the slopes along x and y of the plane that fits the settlements best, by least squares over the area."""
    (S_xx, S_xy), (_, S_yy) = means.S.tolist()
    S_xw, S_yw = (means.s * _MM).tolist()
    yield Step("mean over the area of (x - x_c)^2, x_c and y_c being its center", "S_xx", S_xx, "m2")
    yield Step("mean of (y - y_c)^2", "S_yy", S_yy, "m2")
    yield Step("mean of (x - x_c) (y - y_c)", "S_xy", S_xy, "m2")
    yield Step("mean of (x - x_c) w", "S_xw", S_xw, "mm m")
    yield Step("mean of (y - y_c) w", "S_yw", S_yw, "mm m")
    of_x = "(S_yy * S_xw - S_xy * S_yw) / (S_xx * S_yy - S_xy^2)"
    of_y = "(S_xx * S_yw - S_xy * S_xw) / (S_xx * S_yy - S_xy^2)"
    yield Step("slope along x of the plane that fits best", "omega_x", slope[0] * _MM, "mm/m", of_x)
    yield Step("slope along y of the plane that fits best", "omega_y", slope[1] * _MM, "mm/m", of_y)


def of_distortion(
    means: AreaMeans, slope: tuple[float, float], ends: dict[str, tuple[float, float, float]]
) -> Iterator[Step]:
    """Yield the angular distortion between two columns, given their x, y and settlements [m] by their names."""
    yield from _plane(means, slope)
    for n, (name, (x, y, w)) in enumerate(ends.items(), 1):
        yield Step(Message("x of {name}", name=Name(name)), f"x_{n}", x, "m")
        yield Step(Message("y of {name}", name=Name(name)), f"y_{n}", y, "m")
        yield Step(Message("settlement at {name}", name=Name(name)), f"w_{n}", w * _MM, "mm")
    (x_1, y_1, w_1), (x_2, y_2, w_2) = ends.values()
    off = w_2 - w_1 - (slope[0] * (x_2 - x_1) + slope[1] * (y_2 - y_1))
    of_plane = "w_2 - w_1 - (omega_x * (x_2 - x_1) + omega_y * (y_2 - y_1))"
    yield Step("difference in settlement without the tilt", "Delta_w", off * _MM, "mm", of_plane)
    length = float(np.hypot(x_2 - x_1, y_2 - y_1))
    yield Step("distance", "l", length, "m", "sqrt((x_2 - x_1)^2 + (y_2 - y_1)^2)")
    clause = "EN 1997-1 annex H"
    yield Step("angular distortion", "beta", abs(off) / length * _MM, "mm/m", "abs(Delta_w) / l", clause)


def of_sag(sag: Sag) -> Iterator[Step]:
    """Yield the deflection ratio between two columns."""
    (first, second), (w_1, w_2, w) = sag.names, sag.settlements
    yield Step(Message("settlement at {first}", first=first), "w_1", w_1 * _MM, "mm")
    yield Step(Message("settlement at {second}", second=second), "w_2", w_2 * _MM, "mm")
    yield Step("distance", "l", sag.length, "m")
    yield Step(Message("place between both, as a share of the way from {first}", first=first), "xi", sag.along)
    yield Step("settlement there", "w", w * _MM, "mm")
    line = (1 - sag.along) * w_1 + sag.along * w_2
    yield Step("settlement of the straight line there", "w_l", line * _MM, "mm", "(1 - xi) * w_1 + xi * w_2")
    clause = "EN 1997-1 annex H"
    yield Step("deflection over the distance", "Delta_l", sag.ratio * _MM, "mm/m", "abs(w - w_l) / l", clause)


def of_pressure(p: float, edge: tuple[float, Strip] | None = None) -> Iterator[Step]:
    """Yield the largest pressure: p [Pa] under the plate and, of an edge, its line force [N/m] over a strip.

    Where two edges meet, the line force is the sum of both.
    """
    yield Step("pressure under the plate", "p", p / _K, "kPa")
    if edge is None:
        yield Step("pressure that counts", "p_max", p / _K, "kPa", "p")
        return
    f, strip = edge
    yield Step("line force along the edge beside the place, of both edges at a corner", "f", f / _K, "kN/m")
    yield from of_strip(strip)
    b = strip.width
    yield Step("pressure that counts", "p_max", (p + f / b) / _K, "kPa", "p + f / b")


def of_strip(strip: Strip) -> Iterator[Step]:
    """Yield the width of the strip beside the plate's edge that a line force is spread over."""
    if len(strip.k0) == 1:
        yield Step("stiffness of the springs", "k_0", strip.k0[0] / 1e6, "MPa/m")
        yield Step("shear stiffness of the ground", "k_1", strip.k1[0] / 1e6, "MPa m")
        yield Step("how far the ground's surface takes to die out", "L", strip.decay, "m", "sqrt(k_1 / k_0)")
    else:
        for n, (k0, k1) in enumerate(zip(strip.k0, strip.k1, strict=True), 1):
            yield Step(Message("stiffness of the springs of layer {n}", n=n), f"k_0,{n}", k0 / 1e6, "MPa/m")
            yield Step(Message("shear stiffness of layer {n}", n=n), f"k_1,{n}", k1 / 1e6, "MPa m")
        words = "how far the surface of the ground of these layers takes to die out, the slowest way of their stack"
        yield Step(words, "L", strip.decay, "m")
    yield Step("farthest place of the plate from its edge", "l", strip.farthest, "m")
    yield Step("width of the strip that it is spread over", "b", strip.width, "m", "min(L, l)")


def of_mean_pressure(R: float, area: float, share: float) -> Iterator[Step]:
    """Yield the mean pressure of a force on the ground R [N], the plate's area [m2] and the share in contact."""
    yield Step("force on the ground", "R", R / _K, "kN")
    yield Step("area of the plate", "A", area, "m2")
    yield Step("share of it that is in contact", "c", share)
    yield Step("area in contact", "A'", share * area, "m2", "c * A")
    mean, formula = (R / (share * area), "R / A'") if share else (0.0, "")
    yield Step("mean pressure", "p_m", mean / _K, "kPa", formula)


def of_contact(area: float, contact: float) -> Iterator[Step]:
    """Yield the share of a plate's area [m2] that is in contact [m2]."""
    yield Step("area of the plate", "A", area, "m2")
    yield Step("area in contact", "A'", contact, "m2")
    yield Step("share in contact", "a", 1e2 * contact / area, "%", "100 * A' / A")


def against(key: str, value: float, limit: tuple[float, str], error: float | None, *, least: bool) -> Iterator[Step]:
    """Yield a limit of the case with its unit, the share used, and the share within the error of the value, if any."""
    symbol, (most, unit) = SYMBOLS[key], limit
    name = f"{symbol}_lim" if "_" not in symbol else f"{symbol},lim"
    yield Step("limit of the case", name, most, unit)
    if not least:
        yield Step("share used", "eta", value / most, "", f"{symbol} / {name}")
    elif value > 0:
        yield Step("share used", "eta", most / value, "", f"{name} / {symbol}")
    if error is None:
        return
    size = abs(error)
    yield Step("estimated error of the mesh", "e", size, unit)
    if not least:
        yield Step("share used within the error", "eta_e", (value + size) / most, "", f"({symbol} + e) / {name}")
    elif value > size:
        yield Step("share used within the error", "eta_e", most / (value - size), "", f"{name} / ({symbol} - e)")
