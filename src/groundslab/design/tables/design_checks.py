"""What can be judged of the design by EN 1992-1-1 from the given data, in words: what fails comes first.

Only what fails whatever is built is called a failure. That nothing fails here is no approval: provided bars are not
known, and shear, crack widths, anchorage and the rest of punching are not looked at.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Literal

from groundslab.design import punching_resistance
from groundslab.design.tables import reinforcement
from groundslab.design.tables.punching import Demand, Demands, Stress, demands
from groundslab.model.outputs import Reinforcement
from groundslab.results.results import Results

Status = Literal["fails", "attention", "no failure found", "not checked"]

NOT_CHECKED = "shear, crack widths, anchorage and provided bars are not checked"


@dataclass(frozen=True, slots=True)
class DesignCheck:
    """One check: its name, how it ended, and the worst of it in words."""

    name: str
    status: Status
    words: str


@dataclass(frozen=True, slots=True)
class Design:
    """All checks of a model's design, the failures first; none where nothing could be checked."""

    status: Status
    headline: str
    checks: tuple[DesignCheck, ...] = ()

    @property
    def open(self) -> tuple[DesignCheck, ...]:
        """Return the checks that fail or need attention."""
        return tuple(each for each in self.checks if each.status in ("fails", "attention"))


def design_of(combined: Results) -> Design:
    """Return what can be judged of the design of a model, over the certified results of its ultimate combinations."""
    steel = combined.model.reinforcement
    if steel is None:
        return Design("not checked", "Strength was not checked: the case has no [reinforcement].")
    if not reinforcement.ultimate_results(combined):
        return Design("not checked", "DESIGN NOT CHECKED: no ultimate combination has a certified result.")
    order = ("fails", "attention", "no failure found")
    found = tuple(sorted(_checks(combined, steel), key=lambda each: order.index(each.status)))
    failing, doubtful = (sum(each.status == status for each in found) for status in order[:2])
    total = f"{len(found)} checks by EN 1992-1-1"
    if failing:
        return Design("fails", f"DESIGN FAILS: {failing} of {total} {_verb('fail', failing)}.", found)
    if doubtful:
        words = f"DESIGN NEEDS ATTENTION: {doubtful} of {total} {_verb('need', doubtful)} it."
        return Design("attention", words, found)
    return Design("no failure found", f"No failure found in {total}; {NOT_CHECKED}.", found)


def _verb(verb: str, count: int) -> str:
    """Return a verb that goes with a number of things."""
    return f"{verb}s" if count == 1 else verb


def _checks(combined: Results, steel: Reinforcement) -> Iterator[DesignCheck]:
    """Yield all checks."""
    needs = reinforcement.governing_needs(combined, steel)
    yield _bending(needs)
    yield _compression(needs)
    if combined.model.columns:
        punched = demands(combined)
        yield _face(steel, punched)
        yield _at_2d(steel, punched)
    missing = [
        each for each in combined.combinations if each.limit_state == "ultimate" and each.name in combined.refused
    ]
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
    limit = punching_resistance.max_resistance(reinforcement.materials(steel)[0])
    stresses = [(each, each.face, limit) for each in punched.found.values() if each.face is not None]
    return _punching("punching at the column's face", "v_Rd,max", stresses, punched, "fails", "6.4.5(3)")


def _at_2d(steel: Reinforcement, punched: Demands) -> DesignCheck:
    """Return whether punching at 2 d needs links, or exceeds what they can carry, whatever the other bars."""
    concrete, name = reinforcement.materials(steel)[0], "punching at 2 d"
    there = [(each, each.at_2d, punching_resistance.resistance_without_links(concrete, each.d))
             for each in punched.found.values() if each.at_2d is not None]  # fmt: skip
    most = [(each, stress, punching_resistance.K_MAX * v_Rd_c) for each, stress, v_Rd_c in there]
    with_links = _punching(name, "1.5 v_Rd,c with the most bars that count", most, punched, "fails", "6.4.5(1)")
    if with_links.status == "fails":
        return with_links
    limit = "v_Rd,c with the most bars that count"
    without = _punching(name, limit, there, punched, "attention", "6.4.4")
    needed = any(stress.v_Ed > v_Rd_c for _, stress, v_Rd_c in there if not stress.supported)
    return replace(without, words=f"punching reinforcement is needed at {without.words}") if needed else without


def _punching(
    name: str, limit: str, stresses: list[tuple[Demand, Stress, float]], punched: Demands, status: Status, clause: str
) -> DesignCheck:
    """Return whether any stress exceeds its limit, with the worst; a support inside leaves it open."""
    judged = [each for each in stresses if not each[1].supported]
    beyond = [each for each in judged if each[1].v_Ed > each[2]]
    if beyond:
        demand, stress, most = max(beyond, key=lambda each: each[1].v_Ed / each[2])
        columns = len({each[0].column for each in beyond})
        words = (
            f'{columns} column{"s" if columns > 1 else ""}; worst {demand.column} in "{demand.combination}": v_Ed '
            f"{stress.v_Ed / 1e6:.3g} MPa without beta, above {most / 1e6:.3g} MPa, {limit} ({clause})"
        )
        return DesignCheck(name, status, words)
    unjudged = sorted({each[0].column for each in stresses if each[1].supported} | punched.missing.keys())
    if unjudged:
        names = ", ".join(unjudged[:5]) + (" ..." if len(unjudged) > 5 else "")
        words = f"not judged, for a support inside or no perimeter on the plate: columns {names}"
        return DesignCheck(name, "attention", words)
    if not judged:
        return DesignCheck(name, "no failure found", "no column pushes down")
    used = max(stress.v_Ed / most for _, stress, most in judged)
    return DesignCheck(
        name, "no failure found", f"v_Ed without beta is at most {100 * max(used, 0.0):.3g} % of {limit}"
    )
