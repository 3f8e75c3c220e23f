"""What can be judged of the strength by EN 1992-1-1 from the given data.

Only what fails whatever is built is called a failure. That nothing fails here is no approval: provided bars are not
known, and anchorage is not looked at.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

from groundslab.design.checks.check import DesignCheck, Status
from groundslab.design.en1992 import punching as punching_resistance
from groundslab.design.laid_bars import punching_ratio
from groundslab.design.tables import reinforcement
from groundslab.design.tables.punching import Demand, Demands, Stress, demands
from groundslab.model.loads.load_cases import STRENGTH
from groundslab.model.model import Model
from groundslab.model.outputs import Reinforcement
from groundslab.results.results import Results

#: Radial distance of the perimeters of links over the effective depth, the largest that 9.4.3(1) allows.
LINK_SPACING = 0.75


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the checks of strength in the ultimate combinations."""
    steel = combined.model.reinforcement
    if steel is None:
        yield DesignCheck("strength", "not checked", "strength was not checked: the case has no [reinforcement]")
        return
    if not reinforcement.ultimate_results(combined):
        words = "DESIGN NOT CHECKED: no ultimate combination has a certified result"
        yield DesignCheck("strength", "not checked", words)
        return
    needs = reinforcement.governing_needs(combined, steel)
    yield _bending(needs)
    yield _compression(needs)
    if combined.model.columns:
        punched = demands(combined)
        yield _face(steel, punched)
        yield _within_2d(steel, punched, _ratios(combined.model, punched))
    missing = [each for each in combined.combinations if each.limit_state in STRENGTH and each.name in combined.refused]
    if missing:
        names = ", ".join(f'"{each.name}"' for each in missing[:5]) + (" ..." if len(missing) > 5 else "")
        words = f"without a certified result, and so not designed for: {names}"
        yield DesignCheck("ultimate combinations", "attention", words)
    if reinforcement.without_partial_factors(combined):
        yield DesignCheck("partial factors", "attention", reinforcement.UNFACTORED)


def _bending(needs: list[reinforcement.Need]) -> DesignCheck:
    """Return whether any reinforcement can carry the moments."""
    failing = [need for need in needs if need.governed_by == reinforcement.TOO_WEAK]
    if not failing:
        return DesignCheck("bending", "no failure found", "required reinforcement can be found everywhere")
    worst = max(failing, key=lambda need: need.fails)
    share = f"{100 * worst.fails:.3g} % of the plate's area"
    return DesignCheck("bending", "fails", f"the concrete is too weak for any reinforcement on {share}{_where(worst)}")


def _compression(needs: list[reinforcement.Need]) -> DesignCheck:
    """Return whether bars in compression are counted on."""
    name = "compression reinforcement"
    share = sum({need.section: need.links for need in needs}.values())
    if not share:
        return DesignCheck(name, "no failure found", "the concrete carries bending without bars in compression")
    words = f"bars in compression, held by links (9.2.1.2(3)), are needed on {100 * share:.3g} % of the plate's area"
    of_them = [need for need in needs if need.governed_by == reinforcement.COMPRESSION]
    return DesignCheck(name, "attention", words + (_where(max(of_them, key=lambda need: need.area)) if of_them else ""))


def _where(need: reinforcement.Need) -> str:
    """Return which layer it is about, and the moment that governs it."""
    assert need.place is not None
    assert need.moment is not None
    x, y = need.place
    part = f", {reinforcement.section_name(need.section)}" if need.section else ""
    return (
        f"; {need.layer.replace('_', ' ')}{part}: {need.moment / 1e3:.4g} kNm/m at ({x:.3f}, {y:.3f}) m"
        f' in "{need.combination}", thickness {need.thickness:g} m'
    )


def _face(steel: Reinforcement, punched: Demands) -> DesignCheck:
    """Return whether punching exceeds v_Rd,max at the face of any column (EN 1992-1-1 6.4.5(3))."""
    stresses = [
        (each, each.face, punching_resistance.max_resistance(reinforcement.materials(steel, each.limit_state)[0]))
        for each in punched.found.values()
        if each.face is not None
    ]
    return _punching("punching at the column's face", "v_Rd,max", stresses, punched, "fails", "6.4.5(3)")


def _within_2d(steel: Reinforcement, punched: Demands, ratios: Mapping[str, float]) -> DesignCheck:
    """Return whether punching within 2 d needs links, or exceeds what they can carry at 2 d.

    The ratios of bars are those that are laid at the bottom, or the most that count, whatever will be laid.
    """
    name, which = "punching within 2 d", "the bars that are laid" if steel.laid else "the most bars that count"
    most, there = [], []
    for each in punched.found.values():
        concrete, _ = reinforcement.materials(steel, each.limit_state)
        v_Rd_c = punching_resistance.resistance_without_links(concrete, each.d, ratios[each.column])
        there += [(each, stress, v_Rd_c * 2 * each.d / stress.distance) for stress in each.around]
        if each.around:
            outer = each.around[-1]
            most.append((each, outer, punching_resistance.K_MAX * v_Rd_c * 2 * each.d / outer.distance))
    with_links = _punching(name, f"1.5 v_Rd,c with {which}", most, punched, "fails", "6.4.5(1)")
    if with_links.status == "fails":
        return with_links
    without = _punching(name, f"v_Rd with {which}", there, punched, "attention", "6.4.4(2)")
    needing = [each for each in there if each[1].v_Ed > each[2] and not each[1].supported]
    if not needing:
        return without
    demand, stress, resistance = max(needing, key=lambda each: each[1].v_Ed / each[2])
    s_r, (_, bars) = LINK_SPACING * demand.d, reinforcement.materials(steel, demand.limit_state)
    A_sw = punching_resistance.links_per_perimeter(stress.v_Ed, resistance, stress.u, demand.d, s_r, bars.f_yd)
    words = (
        f"punching reinforcement is needed at {without.words}; there {A_sw * 1e4:.3g} cm2 of vertical links on each "
        f"perimeter, {s_r:.2f} m apart (6.4.5(1), 9.4.3)"
    )
    return replace(without, words=words)


def _ratios(model: Model, punched: Demands) -> dict[str, float]:
    """Return rho_l at each column of the bars that are laid at the bottom (6.4.4(1)), or the most that counts."""
    depths, steel = {each.column: each.d for each in punched.found.values()}, model.reinforcement
    if steel is None or not steel.laid:
        return dict.fromkeys(depths, punching_resistance.MOST_BARS)
    columns = {column.name: column for column in model.columns}
    return {name: punching_ratio(model, columns[name], d) for name, d in depths.items()}


def _at(stress: Stress, d: float) -> str:
    """Return where a perimeter runs."""
    return f" at {stress.distance / d:.2g} d" if stress.distance else ""


def _punching(
    name: str, limit: str, stresses: list[tuple[Demand, Stress, float]], punched: Demands, status: Status, clause: str
) -> DesignCheck:
    """Return whether any stress exceeds its limit, with the worst; a support inside leaves it open."""
    judged = [each for each in stresses if not each[1].supported]
    beyond = [each for each in judged if each[1].v_Ed > each[2]]
    numbers: dict[str, Any] = {}
    if judged:
        demand, stress, most = max(judged, key=lambda each: each[1].v_Ed / each[2])
        numbers = {
            "of": demand.column,
            "demand": max(stress.v_Ed, 0.0) / 1e6,
            "resistance": most / 1e6,
            "unit": "MPa",
            "clause": f"EN 1992-1-1 {clause}",
            "combination": demand.combination,
            "place": punched.places[demand.column],
        }
    if beyond:
        columns = len({each[0].column for each in beyond})
        words = (
            f'{columns} column{"s" if columns > 1 else ""}; worst {demand.column} in "{demand.combination}": v_Ed '
            f"{stress.v_Ed / 1e6:.3g} MPa{_at(stress, demand.d)}, with beta {stress.beta:.2f}, is "
            f"{stress.v_Ed / most:.3g} times {most / 1e6:.3g} MPa, {limit} ({clause})"
        )
        return DesignCheck(name, status, words, **numbers)
    unjudged = sorted({each[0].column for each in stresses if each[1].supported} | punched.missing.keys())
    if unjudged:
        names = ", ".join(unjudged[:5]) + (" ..." if len(unjudged) > 5 else "")
        words = f"not judged, for a support inside or no perimeter on the plate: columns {names}"
        return DesignCheck(name, "attention", words, **numbers)
    if not judged:
        return DesignCheck(name, "no failure found", "no column pushes down")
    used = max(stress.v_Ed / most for _, stress, most in judged)
    words = f"v_Ed is at most {100 * max(used, 0.0):.3g} % of {limit}, {demand.column}{_at(stress, demand.d)}"
    return DesignCheck(name, "no failure found", words, **numbers)
