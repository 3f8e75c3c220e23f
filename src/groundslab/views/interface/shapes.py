"""The shapes of the documents for other programs, from which their JSON schemas are made.

Documents may have further keys in a later release of the same version of the interface; the schemas allow them.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal, NotRequired, TypeAlias

from pydantic import Field, TypeAdapter
from typing_extensions import TypedDict  # comes with pydantic, which asks for it before Python 3.12

from groundslab.design.rules.check import Status
from groundslab.model.loads.load_cases import LimitState
from groundslab.results.records import MeshEnd

#: x and y in meters.
Place: TypeAlias = Annotated[list[float], Field(min_length=2, max_length=2)]


class Header(TypedDict):
    """What every document begins with: the program, its release, the version of this interface."""

    program: Literal["groundslab"]
    version: str
    format: int


class Quantity(TypedDict):
    """A number with a dimension in an SI unit: its discretization error, its place, whether it is a mean around it."""

    value: float
    unit: str
    error: NotRequired[float]
    place: NotRequired[Place]
    singular: NotRequired[Literal[True]]


class Judged(TypedDict):
    """A figure with the tolerance that it is held to."""

    value: float
    tolerance: float
    ok: bool
    place: NotRequired[Place]


class Extreme(TypedDict):
    """The extreme of a figure over the combinations, and the one in which it is; no unit of ratios and counts."""

    value: float
    unit: NotRequired[str]
    error: NotRequired[float]
    place: NotRequired[Place]
    singular: NotRequired[Literal[True]]
    tolerance: NotRequired[float]
    ok: NotRequired[bool]
    combination: str


#: Figures by their keys; those without a dimension stand for themselves, `notes` are sentences.
Section: TypeAlias = dict[str, Quantity | Judged | list[str] | float | str | None]
#: Extremes of figures by their keys; `notes` are sentences.
Extremes: TypeAlias = dict[str, Extreme | list[str]]


class CalculationStep(TypedDict):
    """A step of a calculation that can be followed by hand: a quantity, and the formula that gives it."""

    words: str
    symbol: str
    value: float
    unit: str
    formula: str
    clause: str


class Unjudged(TypedDict):
    """A way in which checks end without a verdict, and what the engineer is to do."""

    name: str
    do: str


class SwitchedOff(TypedDict):
    """Why a check is switched off, and how it would have ended."""

    reason: str
    status: Status


class Name(TypedDict):
    """A text that is the same in all languages and units: the name of a thing of a case, a clause."""

    name: str


class Message(TypedDict):
    """A template with named holes, as in "{beam}: {M:.4g kNm}", and what fills them: numbers in the hole's unit."""

    template: str
    values: dict[str, Any]  # a number, a place, or a text by its parts


class TextsInARow(TypedDict):
    """Texts one after another, with a mark between."""

    mark: str
    texts: list[Any]  # each by its parts


#: A text by its parts.
Text: TypeAlias = str | Name | Message | TextsInARow


class Check(TypedDict):
    """A design check at its governing place; `utilization` is null without numbers and where nothing resists.

    `message` has what `words` say as values.
    """

    name: str
    status: Status
    verdict: str
    words: str
    message: Text
    of: str
    demand: float | None
    resistance: float | None
    unit: str
    least: bool
    clause: str
    combination: str
    place: Place | None
    foundation: bool
    error: float | None
    utilization: float | None
    between: list[float | None] | None
    steps: list[CalculationStep]
    unjudged: Unjudged | None
    off: SwitchedOff | None


class Design(TypedDict):
    """All checks, the worst first; the status is the worst of them."""

    status: Status
    headline: str
    checks: list[Check]


class Acting(TypedDict):
    """In how many combinations of a limit state a case acts, of all there are, and its factors."""

    combinations: int
    total: int
    least: float
    greatest: float


class LoadCase(TypedDict):
    """A load case: its action, its number of loads, where it acts by limit state."""

    name: str
    action: str
    loads: int
    acting: dict[LimitState, Acting]


class CaseSum(TypedDict):
    """Vertical force of a case without factors, downwards positive, and moments about the middle of the plan."""

    F: Quantity
    M_x: Quantity
    M_y: Quantity


class CheckedCase(LoadCase):
    """A load case of a case file, with the sum of its loads."""

    sum: CaseSum


class Combination(TypedDict):
    """A combination of load cases and their factors."""

    name: str
    limit_state: LimitState
    factors: dict[str, float]


class Constants(TypedDict):
    """The constants of the ground that an analysis ended with, of layers from the top downwards."""

    k0: list[Quantity]
    k1: list[Quantity]
    gamma: float | None
    gamma_iterations: int
    decay: float | None
    limit_depth: float | None


class Step(TypedDict):
    """A step of the iteration for load, gamma and contact."""

    unknowns: int
    increment: int
    gamma: float | None
    iteration: int
    in_contact: int
    changed: int
    finest: bool


class MeshHistory(TypedDict):
    """The meshes that were made for an accuracy, and why the last one was not refined."""

    unknowns: list[int]
    end: MeshEnd
    needed: int | None


class Refusal(TypedDict):
    """Why a combination has no certified result; `NoEquilibrium` and `NeutralEquilibrium` say that it fails."""

    error: str
    reason: str
    what: NotRequired[str]
    history: NotRequired[list[Any]]


class Figures(TypedDict, total=False):
    """The figures of one combination by section; without a result there are none."""

    settlement: Section
    contact: Section
    section_forces: Section
    supports: Section
    cracking: Section
    discretization: Section
    constants: Constants
    history: list[Step]
    mesh_history: MeshHistory | None


class SolvedCombination(Figures):
    """A combination among several: its figures, or why it is refused, and its folder."""

    name: str
    limit_state: LimitState
    factors: dict[str, float]
    certified: bool
    refused: NotRequired[Refusal]
    folder: NotRequired[str]
    certificate: NotRequired[Section]


class Environment(TypedDict):
    """What wrote the results: versions of Python, NumPy, SciPy and MKL, threads of the solver, commit where known."""

    versions: dict[str, str]
    threads: int
    commit: NotRequired[str]


class Summary(Header, Figures):
    """The summary of results: `groundslab solve --json`, and summary.json in a folder of results.

    The figures of an only combination stand at the top. Of several, or where an only one is refused, `combinations` has
    those of each, `extremes` and `certificate` what governs.
    """

    environment: NotRequired[Environment]
    title: str
    certified: bool
    provisional: bool
    design: Design
    cases: list[LoadCase]
    remarks: list[str]
    plate: NotRequired[Section]
    mesh: NotRequired[Section]
    ground: NotRequired[Section]
    cut_loads: NotRequired[Section]
    certificate: Section | Extremes
    combination: NotRequired[str]
    limit_state: NotRequired[LimitState]
    extremes: NotRequired[dict[str, Extremes]]
    combinations: NotRequired[list[SolvedCombination]]
    files: list[str]
    checksums: NotRequired[dict[str, str]]


class InputIssue(TypedDict):
    """An issue of an input: where it is, what is there, what is expected, how to correct it where that is known."""

    location: str
    found: str
    expected: str
    hint: str


class CheckedFile(Header):
    """The check of a case or study file: `groundslab check --json`. All keys after `issues` are of correct files."""

    file: str
    status: Literal["fine", "no equilibrium", "wrong input"]
    issues: list[InputIssue]
    kind: NotRequired[Literal["case", "study"]]
    title: NotRequired[str]
    ground: NotRequired[str]
    plates: NotRequired[int]
    loads: NotRequired[int]
    cases: NotRequired[list[CheckedCase]]
    combinations: NotRequired[list[Combination]]
    without_equilibrium: NotRequired[dict[str, str]]
    remarks: NotRequired[list[str]]
    description: NotRequired[list[str]]


class Results(Header):
    """Which results they are: their title, whether all are certified, whether the mesh is still to be refined."""

    title: str
    certified: bool
    provisional: bool


class DesignOfResults(Results):
    """The design checks of results, as the summary has them."""

    design: Design


class Column(TypedDict):
    """A column of a table; one of discretization errors names the column whose values have them."""

    name: str
    unit: str
    error_of: str
    values: list[float | str | None]


class Table(TypedDict):
    """A table column by column, with what a reader must know about it."""

    name: str
    title: str
    columns: list[Column]
    notes: list[str]


class Tables(Results):
    """Tables of results in the units that the case asks for: `groundslab tables --json`."""

    units: Literal["SI", "US"]
    tables: list[Table]


class Reason(TypedDict):
    """The kind and message of an error, all issues of an input, what did not converge and how."""

    kind: str
    message: str
    issues: list[InputIssue]
    what: NotRequired[str]
    history: NotRequired[list[Any]]


class Error(Header):
    """Why there is no other document, wherever `--json` is given."""

    error: Reason


#: Documents by the names of their schemas.
DOCUMENTS: dict[str, type[Header]] = {
    "check": CheckedFile, "summary": Summary, "design": DesignOfResults, "tables": Tables, "error": Error,
}  # fmt: skip


def json_schema(name: str) -> dict[str, Any]:
    """Return the JSON schema of a document in DOCUMENTS."""
    schema = TypeAdapter(DOCUMENTS[name]).json_schema(mode="serialization")
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}
