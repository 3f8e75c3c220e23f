"""Exceptions raised by groundslab."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal


class GroundslabError(Exception):
    """Base of all exceptions that groundslab raises on purpose."""


class EditedFilesKept(UserWarning):
    """Files that groundslab wrote and somebody edited were to be replaced; they are kept under another name."""


@dataclass(frozen=True, slots=True)
class Edit:
    """An edit of a description at a path, indices from 0: set a value, add one to a list, remove or rename a key."""

    op: Literal["set", "add", "remove", "rename"]
    path: tuple[str | int, ...]
    value: Any = None


@dataclass(frozen=True, slots=True)
class Repair:
    """A way to repair an issue: in words, and as edits."""

    label: str
    edits: tuple[Edit, ...]


@dataclass(frozen=True, slots=True)
class Issue:
    """One issue of an input.

    Attributes
    ----------
    location : str
        Where it is, such as "ground.layers[2].E".
    found : str
        What is there.
    expected : str
        What is expected there.
    hint : str
        How to correct it, where that is known.
    repairs : tuple of Repair
        Edits that correct it, to choose from, where they are known.
    """

    location: str
    found: str
    expected: str
    hint: str = ""
    repairs: tuple[Repair, ...] = field(default=(), compare=False, repr=False)

    def __str__(self) -> str:
        """Return the issue on one line."""
        line = f"{self.location}: found {self.found}, expected {self.expected}"
        return f"{line}; {self.hint}" if self.hint else line


class InputError(GroundslabError):
    """An input cannot be used.

    Parameters
    ----------
    issues : sequence of Issue
        Everything that is wrong with it; kept as a tuple under this name.
    """

    def __init__(self, issues: Sequence[Issue]) -> None:
        self.issues = tuple(issues)
        super().__init__(self.issues)

    def __str__(self) -> str:
        """Return all issues, one a line."""
        return "\n".join(str(issue) for issue in self.issues)


class NoEquilibrium(GroundslabError):
    """The foundation fails: ground pressure and supports cannot balance the loads; the message says which and why.

    This is a result, not a gap of the program: the slab lifts, topples, or has more load than its limits allow.
    """


class NeutralEquilibrium(NoEquilibrium):
    """The foundation fails: the loads are balanced, yet nothing holds the plate; the message says how it can move."""


class NoResult(GroundslabError):
    """No result that could be certified was computed; this says nothing about the foundation."""


class IllConditioned(NoResult):
    """Stiffnesses differ by more than double precision allows; the message says which, and what to change."""


class SingularMatrix(NoResult):
    """A matrix that should be positive definite is not."""


class NotCertified(NoResult):
    """A result fails its certificate.

    Parameters
    ----------
    results : CombinationResult
        The results all the same, to be inspected, not to be used; kept under this name.
    """

    ROUNDING = (
        "rounding dominates where stiffnesses differ by ten digits or more: bring the stiffness of plate "
        "(thickness and E), supports and ground closer together"
    )

    def __init__(self, results: Any) -> None:
        self.results = results
        super().__init__(results)

    def __str__(self) -> str:
        """Return which figures of the certificate are too large, and what to do about the ground beyond."""
        certificate = self.results.certificate
        large = certificate.too_large()
        margin = large.pop("margin_effect", None)
        said = []
        if large:
            figures = ", ".join(f"{name} {value:.1e}" for name, value in large.items())
            said.append(f"the result does not satisfy the equations: {figures}")
            if large.keys() <= {"residual", "force_balance", "moment_balance"}:
                said.append(self.ROUNDING)
        if margin is not None:
            said.append(
                f"the meshed ground beyond the plate is too narrow or too coarse: with more of it settlements change "
                f"by {margin:.2g} of the largest one, at most {certificate.MARGIN_TOLERANCE:g} is allowed; increase "
                f"beyond.width or reduce mesh.size"
            )
        return f"{'; '.join(said)}; it must not be used"


class CertificateWithdrawn(NoResult):
    """Saved results or rows are not as groundslab wrote them, so that their certificate holds no more.

    Parameters
    ----------
    folder : str
        The folder.
    changed : sequence of str
        What of it was changed since; kept as a tuple under this name.
    """

    #: So many are named.
    MOST = 5

    def __init__(self, folder: str, changed: Sequence[str]) -> None:
        self.folder, self.changed = folder, tuple(changed)
        super().__init__(folder, self.changed)

    def __str__(self) -> str:
        """Return on one line what was changed, and what to do."""
        more = len(self.changed) - self.MOST
        named = ", ".join(self.changed[: self.MOST]) + (f" and {more} more" if more > 0 else "")
        return (
            f"certificate withdrawn: {named} in {self.folder} changed since groundslab wrote it (SHA-256); restore "
            f"what was written, or solve again"
        )


@dataclass(eq=False)
class NotConverged(NoResult):
    """An iteration ended without converging.

    Parameters
    ----------
    what : str
        Name of the iteration.
    history : sequence
        One entry for each step.
    last : mapping of str to array
        Arrays of the last iterate.
    """

    what: str
    history: Sequence[Any]
    last: Mapping[str, Any] = field(repr=False)

    def __post_init__(self) -> None:
        """Pass the fields to Exception, so that the error can be pickled."""
        super().__init__(self.what, self.history, self.last)

    def __str__(self) -> str:
        """Return a message with the process that did not converge and its last steps."""
        tail = "\n".join(f"  {step}" for step in self.history[-5:])
        return f"{self.what} did not converge in {len(self.history)} steps; the last of them:\n{tail}"
