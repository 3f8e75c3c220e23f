"""Beams by ACI 318-19 beyond what they share with slabs: least bars (9.6.1.2), links, torsion, flanges.

    A_s >= max(0.25 (f'c)^(1/2), 1.4 MPa) / f_y b_w d,    f'c in MPa

f_y is at most 550 MPa there, and b_w the lesser of 2 b_w and the flange's width where the flange is in tension, which
is asked of statically determinate beams alone (9.6.1.2). Across the plane between a web and its flange, for which there
is no other rule where both are cast at once, bars act by shear friction (22.9): A_vf = V_u / (phi mu f_y) with mu =
1.4, f_y at most 413.6 MPa (Table 20.2.2.4(a)), and V_u <= phi min(0.2 f'c, 3.3 MPa + 0.08 f'c, 11 MPa) A_c (Table
22.9.4.4).

Links carry shear (22.5.8.5.3) and, above phi T_th, torsion with struts of 45 degrees (22.7), of which A_cp, p_cp are
those of the web and A_oh, p_h those within the axes of its bars, less than within its links, which is safe:

    T_th = 0.083 (f'c)^(1/2) A_cp^2 / p_cp, four times that as it cracks                   Tables 22.7.4.1, 22.7.5.1
    A_t / s = T_u / (2 phi 0.85 A_oh f_yt),  A_l = A_t / s p_h f_yt / f_y                  22.7.6.1
    A_v / s + 2 A_t / s >= max(0.0623 (f'c)^(1/2), 0.35 MPa) b_w / f_yt                    9.6.4.2
    A_l >= 0.42 (f'c)^(1/2) A_cp / f_y - max(A_t / s, 0.172 MPa b_w / f_yt) p_h f_yt / f_y 9.6.4.3
    (V_u / (b_w d))^2 + (T_u p_h / (1.7 A_oh^2))^2 <= (phi (0.166 + 0.66) (f'c)^(1/2))^2   22.7.7.1

f_y and f_yt are at most 413.6 MPa (20.2.2.4). A beam that is released from torsion gets what its cracking leaves,
phi T_cr (22.7.3.2).
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.design.codes.aci318 import shear
from groundslab.design.codes.aci318.materials import FORMULAS, MOST_F_YT, PHI_SHEAR
from groundslab.design.codes.aci318.materials_of_case import materials
from groundslab.design.rules.bending_steps import CM2
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.design.rules.design_code import TensionZone
from groundslab.design.rules.webs import ALL_LEGS, Flange, Web, WebNeed, force_steps
from groundslab.model.design.reinforcement import Reinforcement

_MPA = 1e6
#: V_s over (f'c)^(1/2) b_w d from which links are half as far apart, and how far they are at most [m] (9.7.6.2.2).
SHARP, FARTHEST = 0.33, 0.6
#: The largest f_y that counts in the least bars [Pa].
MOST_F_Y = 550 * _MPA
#: Friction of concrete cast at once (Table 22.9.4.2), and the largest f_y of bars across (Table 20.2.2.4(a)) [Pa].
MU, MOST_F_Y_FRICTION = 1.4, MOST_F_YT
#: Torsion over (f'c)^(1/2) A_cp^2 / p_cp that is neglected, and that cracks (Tables 22.7.4.1(a), 22.7.5.1(a)).
NEGLECTED, CRACKS = 0.083, 0.3322
#: A_o over A_oh (22.7.6.1.1), and bars along over (f'c)^(1/2) A_cp / f_y (9.6.4.3).
TUBE, CRACK_BARS = 0.85, 0.42


def minimum(steel: Reinforcement, _: str, zone: TensionZone) -> Array:
    """Return the least bars (k,) [m2]."""
    concrete, bars = materials(steel)
    ratio = max(0.25 * concrete.root, 1.4 * _MPA) / min(bars.f_y, MOST_F_Y)
    return np.asarray(ratio * min(2 * zone.web, zone.face) * zone.d)


def minimum_steps(steel: Reinforcement, limit_state: str, zone: TensionZone) -> Iterator[Step]:
    """Yield the calculation of the least bars at one place."""
    concrete, bars = materials(steel)
    yield Step("root of the strength as it counts", "r", concrete.root / MEGA, "MPa", clause="22.5.3.1")
    yield Step("yield strength that counts", "f_y,min", min(bars.f_y, MOST_F_Y) / MEGA, "MPa", clause="9.6.1.2")
    yield Step("width of the web, or of a flange in tension up to twice that", "b_min",
               min(2 * zone.web, zone.face), "m", clause="9.6.1.2")  # fmt: skip
    least = float(minimum(steel, limit_state, zone)[0]) * CM2
    yield Step("least bars", "A_min", least, "cm2", "max(0.25 * r, 1.4) / f_y,min * b_min * d * 10000", "9.6.1.2")


def cracks(_: Reinforcement) -> str:
    """Return what of the cracks of beams is not designed."""
    return (
        "bars of beams are not laid: that they are near enough to each other (24.3.2), and that those of a flange in "
        "tension lie within the lesser of its effective width and a tenth of the clear span (24.3.4), is not checked"
    )


def flange_steps(steel: Reinforcement, limit_state: str, flange: Flange) -> Iterator[Step]:
    """Yield the calculation from the stress between web and flange to the bars across at one place."""
    concrete, bars = materials(steel)
    limit, stress = flange_limit(steel, limit_state), float(flange.stress[0])
    yield Step("specified strength of the concrete", "f_c'", concrete.f_c / MEGA, "MPa", clause="19.2.1.1")
    yield Step("strength reduction factor", "phi", PHI_SHEAR, clause="Table 21.2.1")
    formula = "phi * min(0.2 * f_c', 3.3 + 0.08 * f_c', 11)"
    yield Step("most that friction bears", "tau_max", limit / MEGA, "MPa", formula, "Table 22.9.4.4")
    yield Step("share used", "eta", stress / limit, "", "tau / tau_max", "22.9.4.4")
    if stress > limit:
        return
    yield Step("friction of concrete cast at once", "mu", MU, clause="Table 22.9.4.2")
    yield Step("strength of bars", "f_y", min(bars.f_y, MOST_F_Y_FRICTION) / MEGA, "MPa", clause="20.2.2.4")
    area = float(flange_bars(steel, limit_state, flange.stress, flange.compressed)[0] * flange.h[0]) * CM2
    formula = "tau / (phi * mu * f_y) * h_f * 10000"
    yield Step("bars across the rib, both faces together", "a_sf", area, "cm2/m", formula, "22.9.4.2")


def flange_bars(steel: Reinforcement, limit_state: str, stress: Array, _compressed: Flags) -> Array:
    """Return bars across the web over the flange's thickness (n,) [m2/m per m], 22.9.4.2; inf where none help."""
    _, bars = materials(steel)
    needed = stress / (PHI_SHEAR * MU * min(bars.f_y, MOST_F_Y_FRICTION))
    return np.where(stress > flange_limit(steel, limit_state), np.inf, needed)


def flange_limit(steel: Reinforcement, _: str) -> float:
    """Return the largest shear stress between web and flange [Pa], Table 22.9.4.4."""
    f_c = materials(steel)[0].f_c
    return PHI_SHEAR * min(0.2 * f_c, 3.3 * _MPA + 0.08 * f_c, 11 * _MPA)


def web(steel: Reinforcement, _: str, webs: Web) -> WebNeed:
    """Return the links and the bars along the beam that webs (k,) need."""
    concrete, bars = materials(steel)
    b, d, f_yt, f_y = webs.b, webs.d, bars.f_yt, min(bars.f_y, MOST_F_YT)
    A_cp, A_oh, p_h = _areas(webs)
    T = PHI_SHEAR * CRACKS * concrete.root * A_cp**2 / (2 * (b + webs.h)) if webs.released else webs.T
    T = np.where(_threshold(steel, webs) < T, T, 0.0)
    twist, unknown = np.divide(T, A_oh, out=np.zeros(len(T)), where=A_oh > 0), (T > 0) & (A_oh <= 0)
    most = PHI_SHEAR * (shear.WITH_LINKS + shear.BY_LINKS) * concrete.root
    around = np.divide(twist * p_h, 1.7 * A_oh, out=np.zeros(len(T)), where=A_oh > 0)
    used = np.where(unknown, np.inf, np.hypot(webs.V / (b * d), around) / most)
    of_shear = np.maximum(webs.V / PHI_SHEAR / b - shear.WITH_LINKS * concrete.root * d, 0.0) / (f_yt * d) * b
    leg = twist / (2 * PHI_SHEAR * TUBE * f_yt)
    along = leg * p_h * f_yt / f_y
    least = np.full(len(T), max(0.0623 * concrete.root, 0.35 * _MPA) / f_yt * b)
    least_along = CRACK_BARS * concrete.root * A_cp / f_y - np.maximum(leg, 0.172 * _MPA * b / f_yt) * p_h * f_yt / f_y
    least_along = np.where(T > 0, np.maximum(least_along, 0.0), 0.0)
    links, along = np.maximum(of_shear + 2 * leg, least), np.maximum(along, least_along)
    links, along = (np.where(used > 1, np.inf, values) for values in (links, along))
    return WebNeed(links, least, along, least_along, used, T, np.where(used > 1, 0.0, 2 * leg))


def link_distances(steel: Reinforcement, _: str, webs: Web, _used: Array) -> tuple[Array, Array]:
    """Return how far links, and legs across, may be from each other (k,) [m]: Table 9.7.6.2.2, 9.7.6.3.3."""
    concrete, p_h = materials(steel)[0], _areas(webs)[2]
    of_links = webs.V / PHI_SHEAR - shear.WITH_LINKS * concrete.root * webs.b * webs.d
    half = np.where(of_links > SHARP * concrete.root * webs.b * webs.d, 0.5, 1.0)
    along, across = half * np.minimum(webs.d / 2, FARTHEST), half * np.minimum(webs.d, FARTHEST)
    of_torsion = np.minimum(p_h / 8, FARTHEST / 2)
    return np.where(_threshold(steel, webs) < webs.T, np.minimum(along, of_torsion), along), across


def distance_steps(steel: Reinforcement, limit_state: str, webs: Web, _: Web) -> tuple[list[Step], list[Step]]:
    """Return the calculations of how far links, and legs across, may be from each other in one web."""
    concrete, p_h, T_th = materials(steel)[0], float(_areas(webs)[2][0]), float(_threshold(steel, webs)[0])
    along, across = link_distances(steel, limit_state, webs, np.zeros(1))
    of_links = float(webs.V[0]) / PHI_SHEAR - shear.WITH_LINKS * concrete.root * webs.b * float(webs.d[0])
    sharp = of_links > SHARP * concrete.root * webs.b * float(webs.d[0])
    steps = [
        *force_steps(webs, ("V_u", "T_u")),
        Step("specified strength of the concrete", "f_c'", concrete.f_c / MEGA, "MPa", clause="19.2.1.1"),
        Step("its root as it counts", "r", concrete.root / MEGA, "MPa", FORMULAS["root"], "22.5.3.1, 22.7.2.1"),
        Step("strength reduction factor", "phi", PHI_SHEAR, clause="Table 21.2.1"),
        Step("force that links carry", "V_s", of_links / MEGA, "MN",
             f"V_u / phi - {shear.WITH_LINKS:g} * r * b_w * d", "22.5.10.5"),
        Step("force beyond which they are half as far apart", "V_s,lim",
             SHARP * concrete.root * webs.b * float(webs.d[0]) / MEGA, "MN", f"{SHARP:g} * r * b_w * d", "9.7.6.2.2"),
    ]  # fmt: skip
    half, clause = "0.5 * " if sharp else "", "Table 9.7.6.2.2"
    of_legs = Step("largest distance of legs", "s_t,max", float(across[0]), "m", f"{half}min(d, {FARTHEST:g})", clause)
    formula, twisted = f"{half}min(d / 2, {FARTHEST:g})", []
    if webs.T[0] > T_th:
        twisted = [
            Step("distance of the bars' axis from the face", "a_1", webs.axis, "m"),
            Step("their length", "p_h", p_h, "m", "2 * (b_w + h - 4 * a_1)", "22.7.6.1"),
        ]
        formula, clause = f"min({formula}, p_h / 8, {FARTHEST / 2:g})", f"{clause}, 9.7.6.3.3"
    most = Step("largest distance of links", "s_max", float(along[0]), "m", formula, clause)
    return [*steps, *twisted, most], [*steps, of_legs]


def _areas(webs: Web) -> tuple[Array, Array, Array]:
    """Return A_cp and A_oh (k,) [m2], and p_h (k,) [m], of webs; A_oh ends at the bars' axes, within the links."""
    b, h = np.maximum(webs.b - 2 * webs.axis, 0.0), np.maximum(webs.h - 2 * webs.axis, 0.0)
    return webs.b * webs.h, b * h, 2 * (b + h)


def _threshold(steel: Reinforcement, webs: Web) -> Array:
    """Return phi T_th (k,) [N m], below which torsion is neglected (22.7.1.1, Table 22.7.4.1(a))."""
    A_cp = webs.b * webs.h
    return np.asarray(PHI_SHEAR * NEGLECTED * materials(steel)[0].root * A_cp**2 / (2 * (webs.b + webs.h)))


def web_steps(steel: Reinforcement, limit_state: str, webs: Web) -> Iterator[Step]:
    """Yield the calculation of links and bars along the beam at one web."""
    concrete, bars = materials(steel)
    need, (A_cp, A_oh, p_h) = web(steel, limit_state, webs), _areas(webs)
    f_y, twisted = min(bars.f_y, MOST_F_YT), bool(need.torsion[0] > 0)
    yield from force_steps(webs, ("V_u", "T_u"))
    yield Step("specified strength of the concrete", "f_c'", concrete.f_c / MEGA, "MPa", clause="19.2.1.1")
    yield Step("its root as it counts", "r", concrete.root / MEGA, "MPa", FORMULAS["root"], "22.5.3.1, 22.7.2.1")
    yield Step("strength reduction factor", "phi", PHI_SHEAR, clause="Table 21.2.1")
    yield Step("area of the web", "A_cp", float(A_cp[0]), "m2", "b_w * h", "22.7.4.1")
    yield Step("its circumference", "p_cp", 2 * (webs.b + float(webs.h[0])), "m", "2 * (b_w + h)", "22.7.4.1")
    threshold = float(_threshold(steel, webs)[0]) / MEGA
    formula = f"phi * {NEGLECTED:g} * r * A_cp^2 / p_cp"
    yield Step("torsional moment that is neglected", "T_th", threshold, "MNm", formula, "22.7.1.1, Table 22.7.4.1(a)")
    if webs.released:
        formula = f"phi * {CRACKS:g} * r * A_cp^2 / p_cp"
        yield Step(
            "torsional moment of compatibility", "T_u", float(need.torsion[0]) / MEGA, "MNm", formula, "22.7.3.2"
        )
    used = "V_u / (b_w * d)"
    if twisted:
        yield Step("distance of the bars' axis from the face", "a_1", webs.axis, "m")
        formula = "(b_w - 2 * a_1) * (h - 2 * a_1)"
        yield Step("area within closed links, at least", "A_oh", float(A_oh[0]), "m2", formula, "22.7.6.1.1")
        yield Step("their length", "p_h", float(p_h[0]), "m", "2 * (b_w + h - 4 * a_1)", "22.7.6.1")
        used = f"sqrt(({used})^2 + (T_u * p_h / (1.7 * A_oh^2))^2)"
    clause = "22.7.7.1" if twisted else "22.5.1.2"
    formula = f"{used} / (phi * {shear.WITH_LINKS + shear.BY_LINKS:g} * r)"
    yield Step("share used of the concrete", "eta", float(need.used[0]), "", formula, clause)
    if np.isinf(need.links[0]):
        return
    yield Step("strength of links that counts", "f_yt", bars.f_yt / MEGA, "MPa", clause="20.2.2.4")
    least = float(need.least_links[0]) * CM2
    yield Step(
        "least links", "a_v,min", least, "cm2/m", "max(0.0623 * r, 0.35) / f_yt * b_w * 10000", "9.6.3.4, 9.6.4.2"
    )
    links = f"max(V_u / phi - {shear.WITH_LINKS:g} * r * b_w * d, 0) / (f_yt * d) * 10000"
    if twisted:
        leg = float(need.torsion[0] / (2 * PHI_SHEAR * TUBE * A_oh[0] * bars.f_yt)) * CM2
        formula = f"T_u / (2 * phi * {TUBE:g} * A_oh * f_yt) * 10000"
        yield Step("one leg of closed links for torsion", "a_t", leg, "cm2/m", formula, "22.7.6.1(a), 45 degrees")
        links += " + 2 * a_t"
    clause = "22.5.8.5.3" + ("; 9.5.4.3" if twisted else "")
    yield Step(ALL_LEGS, "a_v", float(need.links[0]) * CM2, "cm2/m", f"max({links}, a_v,min)", clause)
    if twisted:
        yield Step("strength of bars along the beam", "f_y", f_y / MEGA, "MPa", clause="20.2.2.4")
        formula = f"{CRACK_BARS:g} * r * A_cp / f_y * 10000 - max(a_t, 0.172 * b_w / f_yt * 10000) * p_h * f_yt / f_y"
        least = float(need.least_along[0]) * CM2
        yield Step("least bars along the beam", "A_l,min", least, "cm2", f"max({formula}, 0)", "9.6.4.3")
        formula, along = "max(a_t * p_h * f_yt / f_y, A_l,min)", float(need.along[0]) * CM2
        yield Step("bars along the beam for torsion", "A_l", along, "cm2", formula, "22.7.6.1(b), 9.6.4.3")
