"""Checks of a design: each is a function from results to checks; what fails comes first in every view.

Another check is a function of CHECKS; its file names the clause of each check.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass

from groundslab.arrays import made_once
from groundslab.design.checks import (
    anchorage,
    beams,
    bearings,
    coarse_mesh,
    displacements,
    edge_force,
    equilibrium,
    fire,
    limits,
    model_limits,
    provided,
    strength,
)
from groundslab.design.checks.one_way_shear import shear
from groundslab.design.codes.en1997 import checks as en1997
from groundslab.design.codes.floors import checks as floors
from groundslab.design.codes.floors import dowel_checks
from groundslab.design.rules.check import ORDER, DesignCheck, Status, in_units, switched_off
from groundslab.messages import Message, Name, counted, joined, quoted
from groundslab.model.design.checks import CheckOff
from groundslab.model.remarks.remarks import find_remarks
from groundslab.results.results import Results
from groundslab.schema.issues import require

__all__ = ["CHECKS", "Design", "DesignCheck", "Status", "check_design"]


#: Parts of a case on which remarks are remarks on its loads.
LOADED = frozenset({"cases", "combinations", "combine", "loads", "moves", "patterns"})


def _left_out(combined: Results) -> Iterator[DesignCheck]:
    """Yield the remarks on loads, combinations and other input that leave a verdict in doubt."""
    for remark in find_remarks(combined.model, combined.combinations):
        if remark.doubtful:
            name = "loads" if remark.path[0] in LOADED else "input"
            yield DesignCheck(name, "attention", remark.words, of=remark.of)


#: All checks, in the order in which those of one status are listed.
CHECKS: tuple[Callable[[Results], Iterable[DesignCheck]], ...] = (
    strength.checks,
    shear.checks,
    provided.checks,
    beams.checks,
    anchorage.checks,
    fire.checks,
    floors.checks,
    dowel_checks.checks,
    en1997.checks,
    edge_force.checks,
    equilibrium.checks,
    model_limits.checks,
    bearings.checks,
    coarse_mesh.checks,
    displacements.checks,
    limits.checks,
    _left_out,
)

#: What no check looks at.
NOT_CHECKED, LAPS_NOT_CHECKED = "anchorage is not checked", "laps are not checked"


@dataclass(frozen=True, slots=True)
class Design:
    """All checks of a model's design, the failures first; none where nothing could be checked.

    Attributes
    ----------
    status : str
        The worst status of any check: "fails", "attention", "no failure found", or "not checked".
    headline : str
        The outcome in a sentence.
    checks : tuple of DesignCheck
        All checks.
    unchecked : str
        What no check looks at, in a sentence; empty where the headline says so.
    """

    status: Status
    headline: str
    checks: tuple[DesignCheck, ...] = ()
    unchecked: str = ""

    @property
    def open(self) -> tuple[DesignCheck, ...]:
        """Return the checks that fail or need attention."""
        return tuple(check for check in self.checks if check.status in ("fails", "attention"))

    @property
    def hanging(self) -> tuple[DesignCheck, ...]:
        """Return the checks whose verdicts hang on the discretization error."""
        return tuple(check for check in self.checks if check.hangs)


def check_design(combined: Results) -> Design:
    """Return the design checks of a model over its certified results.

    Parameters
    ----------
    combined : Results
        The results of all combinations.

    Returns
    -------
    Design
        The checks, those that fail first, with a headline. Without data to check anything by, none, and what is
        missing.

    Raises
    ------
    InputError
        If the materials are none that EN 1992-1-1 has rules for.

    Examples
    --------
    >>> import groundslab
    >>> groundslab.check_design(results).headline
    'Strength was not checked: the case has no [reinforcement].'
    """
    require(combined, Results, name="results")
    return _check_design(combined)


@made_once
def _check_design(combined: Results) -> Design:
    """Return the checks, which are made once of the same results."""
    off = combined.model.checks.off
    every = [in_units(check, combined.model.units) for find in CHECKS for check in find(combined)]
    checks = [switched_off(check, off) for check in every]
    checks += _off_in_vain(off, checks)
    listed = tuple(sorted((check for check in checks if check.status != "not checked"), key=_order))
    checked = [check for check in listed if check.off is None]
    unchecked = {check.name: check.words for check in checks if check.status == "not checked"}
    if "strength" not in unchecked:
        anchored = anchorage.NAME in [check.name for check in checks]
        unchecked = {"rest": LAPS_NOT_CHECKED if anchored else NOT_CHECKED, **unchecked}
    left = joined(unchecked.values(), "; ")
    sentence = Message("{text:capital}.", text=left)
    failing, doubtful = (sum(check.status == status for check in checked) for status in ("fails", "attention"))
    hanging = sum(check.hangs for check in checked)
    of_them = (
        counted(
            hanging,
            ", {count} hangs on the discretization error",
            ", {count} hang on the discretization error",
        )
        if hanging
        else ""
    )
    total = counted(len(checked), "{count} check", "{count} checks")
    left_open = _left_open(checked) + _off_words(listed)
    if failing:
        count = counted(failing, "{count} of {total} fails", "{count} of {total} fail", total=total)
        return Design("fails", _failure(checked[0], count + of_them) + left_open, listed, sentence)
    if doubtful:
        words = counted(
            doubtful,
            "DESIGN NEEDS ATTENTION: {count} of {total} needs it{of_them}.",
            "DESIGN NEEDS ATTENTION: {count} of {total} need it{of_them}.",
            total=total,
            of_them=of_them,
        )
        return Design("attention", words + left_open, listed, sentence)
    if checked:
        words = Message("No failure found in {total}{of_them}; {left}.", total=total, of_them=of_them, left=left)
        return Design("no failure found", words + left_open, listed)
    return Design("not checked", f"{left[:1].upper()}{left[1:]}." + left_open, listed)


def _left_open(checked: Sequence[DesignCheck]) -> str:
    """Return the sentence about checks that ended without a verdict, empty if all have one."""
    names = [check.name for check in checked if check.unjudged is not None]
    if not names:
        return ""
    kinds = joined(dict.fromkeys(names))
    return Message(" Not judged: {count} of {total} ({kinds}).", count=len(names), total=len(checked), kinds=kinds)


def _off_words(checks: Sequence[DesignCheck]) -> str:
    """Return the sentence about checks that are switched off, empty if none is."""
    off = [check for check in checks if check.off is not None]
    if not off:
        return ""
    names = joined([_of_what(check) for check in off])
    would_fail = sum(check.off is not None and check.off.status == "fails" for check in off)
    if would_fail:
        template = " Switched off: {count} of {total}, of which {failing} would fail ({names})."
        return Message(template, count=len(off), total=len(checks), failing=would_fail, names=names)
    return Message(" Switched off: {count} of {total} ({names}).", count=len(off), total=len(checks), names=names)


def _of_what(check: DesignCheck) -> str:
    """Return the name of a check, and what it is of."""
    return Message("{name} ({of})", name=check.name, of=Name(check.of)) if check.of else check.name


def _off_in_vain(off: Sequence[CheckOff], checks: Sequence[DesignCheck]) -> Iterator[DesignCheck]:
    """Yield what is switched off though no check has its name, or is of what it names."""
    for number, entry in enumerate(off, 1):
        covered = [check for check in checks if entry.covers(check.name, check.of)]
        if any(check.off is not None for check in covered):
            continue
        called = quoted([entry.check]) if not entry.of else joined([quoted([entry.check]), quoted([entry.of])])
        words = Message(
            "checks.off[{number}] switches nothing off: {called} is of the worst of several; leave of out",
            number=number, called=called,
        )  # fmt: skip
        if not covered:
            same = [check.of for check in checks if check.of and entry.replace(of=None).covers(check.name, "")]
            words = Message(
                "checks.off[{number}] switches nothing off: no check is called {called}; there are {names}",
                number=number, called=called,
                names=quoted(list(dict.fromkeys(same or [str(check.name) for check in checks])), 30),
            )  # fmt: skip
        yield DesignCheck("input", "attention", words)


def _failure(worst: DesignCheck, count: str) -> str:
    """Return the sentence about a design that fails; of what holds the slab the reason in full."""
    if worst.foundation:
        return Message("FOUNDATION FAILS ({count}): {name}: {text}.", count=count, name=worst.name, text=worst.words)
    used = worst.utilization
    times = (
        Message("{name}, {used:.3g} times its limit; ", name=worst.name, used=used)
        if used is not None and not worst.least
        else Message("{name}; ", name=worst.name)
    )
    return Message("DESIGN FAILS: {times}{count}.", times=times, count=count)


def _order(check: DesignCheck) -> tuple[int, bool, bool, float]:
    """Return where a check stands: by its status, failures of the foundation first, then the most used.

    A failure without a number comes before those with one, a check without a verdict before others to look at.
    """
    used = check.utilization
    status, fails = ORDER.index(check.status), check.status == "fails"
    return (
        status,
        not (fails and check.foundation),
        check.unjudged is None,
        -(float("inf") if used is None and fails else used or 0.0),
    )
