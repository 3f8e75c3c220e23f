"""What floors resist, step by step: moments and stresses of the slab, pressures, line loads, restraint.

Every value is that of the check; formulas stand beside the functions that compute it.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.design.codes.en1992_2004.materials import Concrete, Steel
from groundslab.design.codes.floors import resistance, strips
from groundslab.design.codes.floors.acting_loads import LinePiece, Pressure
from groundslab.design.codes.floors.slab import Slab, concrete_of, friction_stress, sagging_moment
from groundslab.design.codes.floors.slab import allowed_stress as allowed_stress_of
from groundslab.design.codes.floors.yield_lines import FORMULAS as YIELD_LINES
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.messages import Message, Name
from groundslab.model.design.floors import ACI360Floor, AnyFloor, TR34Floor

#: From m2/m to cm2/m.
_CM2 = 1e4
#: Up to this strength [MPa] f_ctm is 0.3 f_ck^(2/3) (EN 1992-1-1 Table 3.1).
NORMAL = 50.0
SHARE = "share used"


def on_springs(slab: Slab) -> Iterator[Step]:
    """Yield stiffness and thickness of a slab, and the springs under it."""
    yield Step("modulus of elasticity of the slab", "E", slab.E / MEGA, "MPa")
    yield Step("thickness, where it is least", "h", slab.h, "m")
    words = "pressure on the ground over its settlement, where the ground is softest"
    yield Step(words, "k", slab.k / MEGA, "MPa/m")


def radius(slab: Slab) -> Iterator[Step]:
    """Yield the radius of relative stiffness of a slab on springs."""
    yield from on_springs(slab)
    yield Step("Poisson's ratio", "nu", slab.nu)
    yield Step("radius of relative stiffness", "l", slab.l, "m", YIELD_LINES["l"], "Westergaard 1926")


def tensile_strength(concrete: Concrete) -> Iterator[Step]:
    """Yield the strength of concrete, its partial factor and its mean tensile strength."""
    f_ck = concrete.f_ck / MEGA
    yield Step("strength of the concrete", "f_ck", f_ck, "MPa")
    yield Step("partial factor", "gamma_C", concrete.gamma_c)
    formula = "0.3 * f_ck^(2/3)" if f_ck <= NORMAL else ""
    yield Step("mean tensile strength", "f_ctm", concrete.f_ctm / MEGA, "MPa", formula, "EN 1992-1-1 Table 3.1")


def hogging(concrete: Concrete, h: float) -> Iterator[Step]:
    """Yield the moment M_n at which plain concrete cracks; the thickness h [m] stands before."""
    yield from tensile_strength(concrete)
    strength, formula = resistance.flexural_strength(concrete, h), resistance.FORMULAS["f_ctd,fl"]
    yield Step("flexural strength", "f_ctd,fl", strength / MEGA, "MPa", formula, "EN 1992-1-1 3.1.8(1)")
    M_n, words = resistance.plain_moment(concrete, h), "moment that the slab resists with tension at the top"
    yield Step(words, "M_n", M_n / MEGA, "MNm/m", resistance.FORMULAS["M_n"], "TR34")


def sagging(floor: TR34Floor, h: float) -> Iterator[Step]:
    """Yield the moment M_p of fibers or a mesh; the thickness h [m] and the concrete stand before."""
    formula = ""
    if floor.f_R1 is not None and floor.f_R4 is not None:
        yield Step("residual strength of fiber concrete at 0.5 mm (EN 14651)", "f_R1", floor.f_R1 / MEGA, "MPa")
        yield Step("residual strength of fiber concrete at 3.5 mm (EN 14651)", "f_R4", floor.f_R4 / MEGA, "MPa")
        formula = resistance.FORMULAS["M_p of fibers"]
    elif floor.mesh_area is not None:
        steel = Steel(floor.f_yk, floor.gamma_s)
        yield from mesh_depth(floor, h)
        yield Step("yield strength", "f_yk", steel.f_yk / MEGA, "MPa")
        yield Step("partial factor of the bars", "gamma_S", floor.gamma_s)
        yield Step("design yield strength", "f_yd", steel.f_yd / MEGA, "MPa", "f_yk / gamma_S")
        formula = resistance.FORMULAS["M_p of a mesh"]
    M_p = sagging_moment(floor, concrete_of(floor), h)
    words = "moment that the slab resists with tension at the bottom once it has cracked, none of plain concrete"
    yield Step(words, "M_p", M_p / MEGA, "MNm/m", formula, "TR34")


def mesh_depth(floor: TR34Floor, h: float) -> Iterator[Step]:
    """Yield the bars of a mesh and their effective depth in a slab h [m] thick."""
    assert floor.mesh_area is not None
    assert floor.mesh_axis is not None
    yield Step("bars at the bottom, the smaller amount of both directions", "A_s", floor.mesh_area * _CM2, "cm2/m")
    yield Step("bottom face to the axis of the inner bars", "d_1", floor.mesh_axis, "m")
    yield Step("effective depth", "d", h - floor.mesh_axis, "m", "h - d_1")


def _lambda(slab: Slab) -> Step:
    """Return the characteristic of a strip of a slab on springs."""
    return Step("characteristic of a strip on springs", "lambda", slab.lam, "1/m", strips.FORMULAS["lambda"],
                "Hetenyi 1946")  # fmt: skip


def line_load(floor: TR34Floor, slab: Slab, piece: LinePiece, *, at_edge: bool) -> Iterator[Step]:
    """Yield a line load against the one at which a slab cracks."""
    factor, q, away = piece.factor, piece.q, piece.away
    yield from on_springs(slab)
    yield from hogging(concrete_of(floor), slab.h)
    yield _lambda(slab)
    yield Step("distance of the line from the nearest edge", "e", away, "m")
    yield Step("distance within which a line is near an edge", "e_lim", strips.NEAR_EDGE / slab.lam, "m",
               f"{strips.NEAR_EDGE:g} / lambda")  # fmt: skip
    case = Name(piece.case)
    yield Step(Message("line load of {case}, where it is largest", case=case), "q_k", q / MEGA, "MN/m")
    yield Step(Message("factor of {case}", case=case), "gamma_F", factor)
    yield Step("line load", "q", factor * q / MEGA, "MN/m", "gamma_F * q_k")
    most = strips.line_load(resistance.plain_moment(concrete_of(floor), slab.h), slab.lam, at_edge)
    formula = strips.FORMULAS["at_edge" if at_edge else "inside"]
    yield Step("line load that the slab resists", "q_R", most / MEGA, "MN/m", formula, "TR34, Hetenyi 1946")
    yield Step(SHARE, "eta", factor * q / most, "", "q / q_R")


def pressure(floor: AnyFloor, slab: Slab, loads: Pressure, allowed: float) -> Iterator[Step]:
    """Yield a pressure against the one that may stand beside the worst aisle [Pa]."""
    yield from on_springs(slab)
    if isinstance(floor, TR34Floor):
        M = "M_n"
        yield from hogging(concrete_of(floor), slab.h)
    else:
        M = "M_a"
        yield from allowed_stress(floor)
        drag, formula = friction_stress(floor), "f_a * h^2 / 6"
        if drag:
            yield from friction(floor)
            formula = "max(0, f_a - sigma_f) * h^2 / 6"
        M_a = max(0.0, allowed_stress_of(floor) - drag) * slab.h**2 / 6
        yield Step("moment that makes the allowed stress", M, M_a / MEGA, "MNm/m", formula)
    yield _lambda(slab)
    terms = []
    if loads.own:
        case = Name(loads.case)
        yield Step(Message("pressure of {case}, where it is largest", case=case), "q_k", loads.q / MEGA, "MPa")
        yield Step(Message("factor of {case}", case=case), "gamma_F", loads.factor)
        terms.append("gamma_F * q_k")
    if loads.over:
        words = "largest pressures of other loads that it overlaps, with their factors"
        yield Step(words, "q_o", loads.over / MEGA, "MPa")
        terms.append("q_o")
    if loads.everywhere:
        words = "variable pressures on the whole plate, with their factors"
        yield Step(words, "q_w", loads.everywhere / MEGA, "MPa")
        terms.append("q_w")
    yield Step("pressure", "q", loads.total / MEGA, "MPa", " + ".join(terms))
    words, formula = "pressure that may stand beside any aisle", strips.FORMULAS["aisle"].replace("M_n", M)
    yield Step(words, "q_R", allowed / MEGA, "MPa", formula, "Hetenyi 1946")
    if allowed:
        yield Step(SHARE, "eta", loads.total / allowed, "", "q / q_R")


def friction(floor: AnyFloor) -> Iterator[Step]:
    """Yield the tension by friction midway between joints."""
    yield Step("coefficient of friction on the ground, for the restraint of shrinkage", "mu", floor.friction or 0.0)
    words = "unit weight of the concrete, for friction on the ground"
    yield Step(words, "gamma", floor.unit_weight / 1e3, "kN/m3")
    words = "spacing of joints that open, for the restraint of shrinkage"
    yield Step(words, "L", floor.joint_spacing or 0.0, "m")
    formula = resistance.FORMULAS["sigma_f"]
    yield Step("tension by friction, midway between joints", "sigma_f", friction_stress(floor) / MEGA, "MPa", formula)


def restraint(floor: AnyFloor) -> Iterator[Step]:
    """Yield the tension by friction against what the concrete bears."""
    yield from friction(floor)
    stress = friction_stress(floor)
    if isinstance(floor, TR34Floor):
        concrete = concrete_of(floor)
        yield from tensile_strength(concrete)
        strength, symbol = resistance.tensile_strength(concrete), "f_ctd"
        formula, clause = resistance.FORMULAS["f_ctd"], "EN 1992-1-1 3.1.6(2)P"
        yield Step("design tensile strength", symbol, strength / MEGA, "MPa", formula, clause)
    else:
        strength, symbol = allowed_stress_of(floor), "f_a"
        yield from allowed_stress(floor)
    yield Step(SHARE, "eta", stress / strength, "", f"sigma_f / {symbol}")


def allowed_stress(floor: ACI360Floor) -> Iterator[Step]:
    """Yield the allowed flexural stress."""
    yield Step("modulus of rupture of the concrete", "f_r", floor.f_r / MEGA, "MPa")
    yield Step("factor of safety", "SF", floor.safety_factor)
    terms = "1 / SF"
    if floor.R_e3 is not None:
        yield Step("residual strength of fiber concrete over f_r, for yield lines", "R_e,3", floor.R_e3)
        terms = "max(1 / SF, R_e,3)"
    N = floor.repetitions
    if N is not None:
        yield Step("load repetitions over the life of the floor, for fatigue", "N", N)
        few = resistance.allowed_repetitions(resistance.STRAIGHT) >= N
        formula = resistance.FORMULAS["r_N" if few else "r_N often"]
        words, clause = "stress over the modulus of rupture that may be repeated so often", "PCA 1984"
        yield Step(words, "r_N", resistance.allowed_ratio(N), "", formula, clause)
        terms = f"min({terms}, r_N, 1)"
    elif floor.R_e3 is not None:
        terms = f"min({terms}, 1)"
    formula = f"f_r * {terms}" if terms != "1 / SF" else "f_r / SF"
    stress = allowed_stress_of(floor)
    yield Step("allowed stress", "f_a", stress / MEGA, "MPa", formula, "ACI 360R-10 5.9, 7.2")


def stress(
    floor: ACI360Floor, moments: tuple[float, float, float], h: float, stress: float, face: str
) -> Iterator[Step]:
    """Yield the largest tension at a face [Pa] by m_x, m_y and m_xy [N m/m] there, in a slab h [m] thick."""
    for words, symbol, m in zip(
        ("moment along x there, positive with tension at the bottom",
         "moment along y there, positive with tension at the bottom", "twisting moment there"),
        ("m_x", "m_y", "m_xy"), moments, strict=True,
    ):  # fmt: skip
        yield Step(words, symbol, m / MEGA, "MNm/m")
    m_x, m_y, m_xy = moments
    root, mean = float(np.hypot((m_x - m_y) / 2, m_xy)), (m_x + m_y) / 2
    sign, m, words = ("+", mean + root, "larger principal moment") if face == "bottom" else (
        "-", mean - root, "smaller principal moment")  # fmt: skip
    formula = f"(m_x + m_y) / 2 {sign} sqrt(((m_x - m_y) / 2)^2 + m_xy^2)"
    yield Step(words, "m", m / MEGA, "MNm/m", formula)
    yield Step("thickness there", "h", h, "m")
    formula = "max(6 * m / h^2, 0)" if face == "bottom" else "max(-6 * m / h^2, 0)"
    yield Step("tension by bending", "sigma_m", (stress - friction_stress(floor)) / MEGA, "MPa", formula)
    symbol = "sigma_m"
    if friction_stress(floor):
        yield from friction(floor)
        symbol = "sigma"
        yield Step("tension", symbol, stress / MEGA, "MPa", "sigma_m + sigma_f")
    yield from allowed_stress(floor)
    yield Step(SHARE, "eta", stress / allowed_stress_of(floor), "", f"{symbol} / f_a")
