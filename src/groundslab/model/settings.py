"""Settings of an analysis: ground beyond the plate, contact, mesh, solver."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from groundslab.errors import Repair
from groundslab.model.ground import POSITIVE
from groundslab.model.shapes import Shape
from groundslab.model.varying_ground import GapPoint, Void, check_gap_points
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Boolean, Choice, Integer, ListOf, Quantity
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.ranges import Range
from groundslab.schema.repairs import remove, set_value
from groundslab.schema.section_fields import Table
from groundslab.schema.wording import describe, quote

Reach = Literal["none", "margin", "infinite"]
OuterEdge = Literal["free", "fixed"]
Side = Literal["left", "right", "bottom", "top"]
Symmetry = Literal["auto", "off"]
Solver = Literal["auto", "pardiso", "cholmod", "superlu", "mumps"]


Accuracy = Literal["draft", "normal", "strict"]

#: Of what the mesh is allowed to be off, and what the words for it mean.
SHARE = Range(at_least=1e-4, at_most=0.5)
ACCURACIES: dict[str, float] = {"draft": 0.15, "normal": 0.05, "strict": 0.02}
#: A refined mesh has at most so many unknowns by default; and the most that may be asked for, with which the factor
#: takes about 45 GB.
MOST_UNKNOWNS = 300_000
LARGEST_BOUND = 10_000_000
SIDES: tuple[Side, ...] = ("left", "right", "bottom", "top")


def _check_width(kind: str, width: float | None) -> Iterator[RelativeIssue]:
    if kind == "margin" and width is None:
        yield RelativeIssue(("width",), "nothing", 'a length such as "5 m", as kind is "margin"')
    if kind == "none" and width is not None:
        hint, margin = 'kind = "margin" has a width', set_value(("kind",), "margin")
        repairs = (remove(("width",)), margin)
        yield RelativeIssue(("width",), f"{width!r} m", 'no width, as kind is "none"', hint, repairs)


def _check_edge(kind: str, edge: str, given: set[str]) -> Iterator[RelativeIssue]:
    if kind != "margin" and "edge" in given:
        hint, repairs = 'kind = "margin" has an outer edge', (remove(("edge",)),)
        yield RelativeIssue(("edge",), quote(edge), f'no edge, as kind is "{kind}"', hint, repairs)


class Beyond(Section):
    """The ground beyond the plate; without effect where the ground carries no shear, as springs do not reach there."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_width, _check_edge)

    kind: Annotated[
        Reach,
        Choice(Reach, "none: the ground ends at the plate's edge; margin: a strip of ground; infinite: no end"),
    ] = "none"
    width: Annotated[
        float | None,
        Quantity(
            "length",
            "b",
            "width of the meshed strip; needed for a margin; if infinite, by default the ground's decay length, and a "
            "width is refused if widening it changes settlements by more than 1 %",
            POSITIVE,
            example="5 m",
        ),
    ] = None
    edge: Annotated[OuterEdge, Choice(OuterEdge, "outer edge of a margin")] = "free"
    sides: Annotated[
        tuple[Side, ...],
        ListOf(Choice(Side, ""), "", "sides of the plate with ground beyond them", unique=True),
    ] = SIDES


def _without(key: str) -> tuple[Repair, ...]:
    """Return the repairs of a key that is for plates which may lift off, where none may."""
    return remove((key,)), set_value(("tensionless",), True)


def _check_gap(tensionless: bool, gap: float) -> Iterator[RelativeIssue]:
    if not tensionless and gap > 0:
        yield RelativeIssue(("gap",), f"{gap!r} m", "no gap, as tensionless is false", repairs=_without("gap"))


def _check_voids(tensionless: bool, voids: tuple[Void, ...]) -> Iterator[RelativeIssue]:
    if not tensionless and voids:
        yield RelativeIssue(("voids",), describe(voids), "no voids, as tensionless is false", repairs=_without("voids"))


def _check_gaps(tensionless: bool, gaps: tuple[GapPoint, ...]) -> Iterator[RelativeIssue]:
    if not tensionless and gaps:
        yield RelativeIssue(("gaps",), describe(gaps), "no gaps, as tensionless is false", repairs=_without("gaps"))


def _check_limit_pressure(tensionless: bool, limit_pressure: float | None) -> Iterator[RelativeIssue]:
    if not tensionless and limit_pressure is not None:
        expected, repairs = "no limit, as tensionless is false", _without("limit_pressure")
        yield RelativeIssue(("limit_pressure",), f"{limit_pressure!r} Pa", expected, repairs=repairs)


class Contact(Section):
    """Contact between plate and ground."""

    constraints: ClassVar[tuple[Check, ...]] = (
        _check_gap,
        _check_voids,
        _check_gaps,
        check_gap_points,
        _check_limit_pressure,
    )

    tensionless: Annotated[bool, Boolean("whether the plate may lift off")] = True
    gap: Annotated[
        float, Quantity("length", "g_0", "initial gap everywhere under the plate", Range(at_least=0), example="5 mm")
    ] = 0.0
    voids: Annotated[
        tuple[Void, ...], Table("parts with a further gap, or none to reach; the deeper counts where they overlap")
    ] = ()
    gaps: Annotated[
        tuple[GapPoint, ...],
        Table("measured gaps, further to gap, a smooth surface between them; a plane stays a plane", 2000),
    ] = ()
    limit_pressure: Annotated[
        float | None,
        Quantity(
            "pressure",
            "p_max",
            "pressure at which the ground yields, no limit by default; line forces along the plate's edges do not "
            "count, but loads may not exceed this pressure over the whole plate",
            POSITIVE,
            example="400 kPa",
        ),
    ] = None


class Refinement(Section):
    """A part of the plan with smaller elements."""

    shape: Annotated[Shape, Table("where")]
    size: Annotated[float, Quantity("length", "h", "largest side of an element there", POSITIVE, example="0.5 m")]


def _check_size(
    size: float | None, counts: tuple[int, int] | None, refine: tuple[Refinement, ...]
) -> Iterator[RelativeIssue]:
    if size is not None and counts is not None:
        repairs = (remove(("counts",)), remove(("size",)))
        yield RelativeIssue((), "both size and counts", "at most one of size and counts", repairs=repairs)
    if refine and counts is not None:
        hint = "give a size instead of counts"
        yield RelativeIssue(("refine",), "refine together with counts", "no refine", hint, (remove(("refine",)),))


def _check_max_unknowns(
    size: float | None, counts: tuple[int, int] | None, max_unknowns: int, given: set[str]
) -> Iterator[RelativeIssue]:
    if "max_unknowns" in given and (size is not None or counts is not None):
        name = "size" if size is not None else "counts"
        expected = f"no max_unknowns, as {name} says what the mesh is"
        repairs = (remove(("max_unknowns",)), remove((name,)))
        yield RelativeIssue(("max_unknowns",), str(max_unknowns), expected, repairs=repairs)


class Mesh(Section):
    """The mesh of the plate; without size and counts it is refined until the results are accurate enough."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_size, _check_max_unknowns)

    size: Annotated[
        float | None,
        Quantity("length", "h", "largest side of an element; smaller at edges where needed", POSITIVE, example="0.5 m"),
    ] = None
    counts: Annotated[
        tuple[int, int] | None,
        ListOf(Integer("", at_most=100_000), "n_x, n_y", "elements over the whole plate", 2, members=("n_x", "n_y")),
    ] = None
    accuracy: Annotated[
        float | Accuracy,
        Quantity(
            "share",
            "",
            "largest discretization error that a value may have without a warning: draft is 15 %, normal 5 %, strict "
            "2 %; without size and counts the mesh is refined until errors are below it",
            SHARE,
            tuple(ACCURACIES),
            example="5 %",
        ),
    ] = "normal"
    max_unknowns: Annotated[
        int,
        Integer("unknowns of a mesh beyond which it is not refined for the accuracy", 1000, LARGEST_BOUND),
    ] = MOST_UNKNOWNS
    refine: Annotated[tuple[Refinement, ...], Table("parts of the plan with smaller elements", 1000)] = ()
    symmetry: Annotated[
        Symmetry, Choice(Symmetry, "whether a half or a quarter is computed if everything is symmetric")
    ] = "auto"

    @property
    def adaptive(self) -> bool:
        """Whether the mesh is refined where its errors are largest."""
        return self.size is None and self.counts is None

    @property
    def largest_error(self) -> float:
        """The largest discretization error that a value may have without a warning."""
        return ACCURACIES[self.accuracy] if isinstance(self.accuracy, str) else self.accuracy


class Analysis(Section):
    """How the equations are solved."""

    increments: Annotated[
        int, Integer("steps in which the load is applied; the result does not depend on it", at_most=1000)
    ] = 1
    solver: Annotated[
        Solver,
        Choice(
            Solver,
            "direct solver; auto takes the first one installed, mumps is for many processes",
        ),
    ] = "auto"
    nested: Annotated[bool, Boolean("start the contact zone from coarser meshes")] = True
    max_iterations: Annotated[int, Integer("most contact steps on one mesh", at_most=10_000)] = 200
