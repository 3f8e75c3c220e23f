"""Results of an analysis: one combination of loads, and all combinations of a model."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, replace
from html import escape
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from groundslab.arrays import Array, freeze, made_once
from groundslab.errors import GroundslabError, InputError, Issue, NoEquilibrium, NotCertified
from groundslab.fem.parts.mesh_plan import MeshPlan
from groundslab.messages import Message, words_in
from groundslab.results.fields import PLATE_FIELDS
from groundslab.results.plate_result import ElementResult, GroundResult, PlateResult
from groundslab.results.records import (
    BaseResult,
    BeamResult,
    Certificate,
    Constants,
    JointResult,
    LargestValues,
    MeshHistory,
    Step,
    SupportResult,
    WallLimit,
)
from groundslab.schema.issues import require
from groundslab.schema.wording import listed, quote
from groundslab.unit_systems import System, in_system
from groundslab.units import format_number

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from groundslab.model.loads.load_cases import Combination
    from groundslab.model.model import Model

Part = TypeVar("Part")

#: A printed summary lists at most so many combinations.
MOST_LISTED = 12


@dataclass(frozen=True, slots=True)
class Increment:
    """The state under a share of the load.

    Attributes
    ----------
    share : float
        Share of the load, settlements of supports included.
    plate : PlateResult
        The plate.
    elements : ElementResult
        The plate's elements.
    ground : GroundResult
        The ground.
    """

    share: float
    plate: PlateResult
    elements: ElementResult
    ground: GroundResult


class OnlyPart(Generic[Part]):
    """A part of the results of the only combination, as `CombinationResult` documents it."""

    def __set_name__(self, owner: type[Results], name: str) -> None:
        """Keep the part's name."""
        self.name = name

    def __get__(self, results: Results, owner: type[Results]) -> Part:
        """Return the part, raising as `Results.only` does; of the class, which has no results, this object."""
        part: Part = self if results is None else getattr(results.only, self.name)
        return part


@dataclass(frozen=True, slots=True, weakref_slot=True)
class Comparison:
    """What elements twice as large give, at the nodes of the finer mesh, and the discretization error in energy.

    Attributes
    ----------
    plate : PlateResult
        The plate.
    elements : ElementResult
        The plate's elements.
    ground : GroundResult
        The ground.
    supports : tuple of SupportResult
        What the supports carry, at nodes of the coarser mesh.
    constants : Constants
        The ground's constants that the coarser mesh ended with.
    energy_error : float
        The error of the finer mesh in the energy norm, over that of its solution.
    reduction : float
        That error over the one of the coarser mesh, at least a half on an elastic continuum.
    joints : tuple of JointResult
        What the joints carry, at nodes of the coarser mesh.
    beams : tuple of BeamResult
        The section forces of the beams, at nodes of the coarser mesh.
    bases : tuple of BaseResult
        What the building above does.
    moment_reduction, shear_reduction : (n,) array of float or None
        By what the parts of moments and of shear forces in that error fell in the elements that meet at each node of
        the plate.
    """

    plate: PlateResult
    elements: ElementResult
    ground: GroundResult
    supports: tuple[SupportResult, ...]
    constants: Constants
    energy_error: float
    reduction: float
    joints: tuple[JointResult, ...] = ()
    beams: tuple[BeamResult, ...] = ()
    bases: tuple[BaseResult, ...] = ()
    moment_reduction: Array | None = None
    shear_reduction: Array | None = None


@dataclass(frozen=True, slots=True, weakref_slot=True, repr=False)
class CombinationResult:
    """Results of one combination of loads, with the model that they belong to.

    Attributes
    ----------
    model : Model
        The case as written.
    solved_model : Model
        The case as solved: patterns are point loads, cases that move are cases at each position, and the combinations
        are those that were solved. It is `model` itself where nothing is to be placed.
    plate : PlateResult
        The plate: mesh and nodal fields.
    elements : ElementResult
        The plate's elements.
    ground : GroundResult
        The ground, under the plate and beyond it.
    constants : Constants
        The ground's constants that the analysis ended with.
    certificate : Certificate
        How well equilibrium and contact conditions are satisfied.
    steps : tuple of Step
        The convergence history.
    solver : str
        Name of the solver of linear systems.
    unknowns : int
        Number of unknowns that were solved for.
    mesh_plan : MeshPlan
        What the mesher decided: symmetry, borders that the mesh follows, whether there is a coarser mesh.
    combination, limit_state : str
        Name and limit state of the combination.
    factors : tuple of (str, float)
        Factors of the load cases; empty if the model has no load cases.
    supports : tuple of SupportResult
        What the supports carry.
    joints : tuple of JointResult
        What the joints between plates carry.
    beams : tuple of BeamResult
        The section forces of the beams.
    bases : tuple of BaseResult
        How the bases of the building above move, and what that changes of their loads.
    increments : tuple of Increment
        The states under smaller shares of the load, if it was applied in increments.
    comparison : Comparison or None
        What elements twice as large give, by which discretization errors are estimated.
    largest : LargestValues or None
        The largest values over all combinations, against which these errors are judged; None before all are solved.
    mesh_history : MeshHistory or None
        The meshes that were made for the accuracy; None where the case says which mesh.
    wall_limits : tuple of (float, tuple of (str, float, float))
        Extremes of fields of the plate with none and all of its walls' stiffness, if they were asked for.
    """

    model: Model
    solved_model: Model
    plate: PlateResult
    elements: ElementResult
    ground: GroundResult
    constants: Constants
    certificate: Certificate
    steps: tuple[Step, ...]
    solver: str
    unknowns: int
    mesh_plan: MeshPlan
    combination: str
    limit_state: str
    factors: tuple[tuple[str, float], ...]
    supports: tuple[SupportResult, ...]
    joints: tuple[JointResult, ...] = ()
    beams: tuple[BeamResult, ...] = ()
    bases: tuple[BaseResult, ...] = ()
    increments: tuple[Increment, ...] = ()
    comparison: Comparison | None = None
    largest: LargestValues | None = None
    mesh_history: MeshHistory | None = None
    wall_limits: tuple[WallLimit, ...] = ()

    def __post_init__(self) -> None:
        """Make all arrays read-only: what is printed, saved and certified is what was solved."""
        freeze(self)

    def __reduce__(self) -> tuple[type[CombinationResult], tuple[Any, ...]]:
        """Return how a copy is made, whose arrays are read-only too: pickles do not say so of arrays."""
        return type(self), tuple(getattr(self, field.name) for field in fields(self))

    @property
    def symmetry(self) -> tuple[bool, bool]:
        """Whether symmetry along x, and along y, was used."""
        return self.mesh_plan.symmetry

    @property
    def provisional(self) -> bool:
        """Whether the mesh was still to be refined for the accuracy."""
        return self.mesh_history is not None and self.mesh_history.end == "provisional"

    @property
    @made_once
    def coarser(self) -> CombinationResult | None:
        """The results on elements twice as large, their fields at the nodes of this mesh."""
        if (other := self.comparison) is None:
            return None
        return replace(
            self,
            plate=other.plate,
            elements=other.elements,
            ground=other.ground,
            supports=other.supports,
            joints=other.joints,
            beams=other.beams,
            bases=other.bases,
            constants=other.constants,
            increments=(),
            comparison=None,
        )

    if TYPE_CHECKING:

        def plot(self, *fields: str, **options: Any) -> Figure:
            """Draw the results; `views.methods` has it."""

    def __repr__(self) -> str:
        """Return the first figures on one line."""
        settlement, contact, verdict = _figures(self)
        return f"{self.combination} ({self.limit_state}): w <= {settlement}, {contact} % in contact, {verdict}"


@dataclass(frozen=True, slots=True, weakref_slot=True, repr=False)
class Results(Mapping[str, CombinationResult]):
    """Results of all combinations of a model, perhaps one: a mapping from the names of those that were solved.

    Of a model with one combination the parts that `CombinationResult` documents are at hand, too: `plate`, `elements`,
    `ground`, `constants`, `certificate`, `supports`, `increments` and `steps`. With several, asking for one of them
    raises InputError, which names the combinations.

    Attributes
    ----------
    model : Model
        The case as written; `solved_model` is the case as solved.
    combinations : tuple of Combination
        All combinations, solved or not.
    results : dict of str to CombinationResult
        Certified results by the name of their combination.
    refused : dict of str to GroundslabError
        Why the other combinations have no certified results: `NoEquilibrium` where the foundation fails, `NoResult`
        where none was computed.

    Examples
    --------
    >>> list(results)
    ['all loads']
    >>> results["all loads"].certificate.holds
    True
    >>> f"{results.plate.settlement.max():.4f} m"
    '0.0030 m'
    """

    model: Model
    combinations: tuple[Combination, ...]
    results: dict[str, CombinationResult]
    refused: dict[str, GroundslabError]

    def __getitem__(self, combination: str) -> CombinationResult:
        """Return the results of a combination; raises the reason if it has none."""
        if combination in self.refused:
            raise self.refused[combination]
        if combination not in self.results:
            names = listed([quote(item.name) for item in self.combinations])
            raise KeyError(f"no combination {quote(combination)}; there is {names}")
        return self.results[combination]

    @property
    def without_equilibrium(self) -> dict[str, NoEquilibrium]:
        """The combinations in which the foundation fails, as nothing balances the loads, and why, by their names."""
        return {name: error for name, error in self.refused.items() if isinstance(error, NoEquilibrium)}

    @property
    def unsolved(self) -> dict[str, GroundslabError]:
        """The combinations for which no certified result was computed, and why, by their names."""
        return {name: error for name, error in self.refused.items() if not isinstance(error, NoEquilibrium)}

    def __iter__(self) -> Iterator[str]:
        """Iterate over the names of the combinations that were solved."""
        return iter(self.results)

    def __len__(self) -> int:
        """Return how many combinations were solved."""
        return len(self.results)

    def __contains__(self, combination: object) -> bool:
        """Return whether a combination of that name was solved."""
        return combination in self.results

    @property
    def provisional(self) -> bool:
        """Whether the mesh was still to be refined for the accuracy."""
        return any(result.provisional for result in self.results.values())

    @property
    def solved_model(self) -> Model:
        """The case as solved, as `CombinationResult` documents it."""
        from groundslab.model.combinations import as_solved

        uncertified = [error.results for error in self.refused.values() if isinstance(error, NotCertified)]
        results = [*self.results.values(), *uncertified]
        return results[0].solved_model if results else as_solved(self.model)

    @property
    def only(self) -> CombinationResult:
        """The results of the only combination; InputError if there are several."""
        if len(self.combinations) != 1:
            names = listed([quote(combination.name) for combination in self.combinations])
            hint = f"choose one by its name, such as results[{quote(self.combinations[0].name)}]"
            raise InputError([Issue("results", f"combinations {names}", "a model with one combination", hint)])
        return self[self.combinations[0].name]

    plate = OnlyPart[PlateResult]()
    elements = OnlyPart[ElementResult]()
    ground = OnlyPart[GroundResult]()
    constants = OnlyPart[Constants]()
    certificate = OnlyPart[Certificate]()
    supports = OnlyPart[tuple[SupportResult, ...]]()
    increments = OnlyPart[tuple[Increment, ...]]()
    steps = OnlyPart[tuple[Step, ...]]()
    if TYPE_CHECKING:

        def plot(self, *fields: str, **options: Any) -> Figure:
            """Draw the results; `views.methods` has it."""

    def __repr__(self) -> str:
        """Return the title and the first figures of each combination, one a line."""
        count = len(self.combinations)
        what = "Provisional results" if self.provisional else "Results"
        head = f"{what} of {quote(self.model.title)}: {count} combination{'' if count == 1 else 's'}"
        lines = [
            repr(self.results[combination.name])
            if combination.name in self.results
            else f"{combination.name}: {self._reason(combination.name)}"
            for combination in self.combinations[:MOST_LISTED]
        ]
        more = [f"... {count - MOST_LISTED} more"] if count > MOST_LISTED else []
        return "\n  ".join([head, *lines, *more])

    def _repr_html_(self) -> str:
        """Return the first figures of each combination as a table for notebooks."""
        heads = ("combination", "limit state", "largest settlement", "area in contact [%]", "certificate")
        rows = [f"<th>{'</th><th>'.join(heads)}</th>"]
        for combination in self.combinations:
            result = self.results.get(combination.name)
            figures = ("", "", self._reason(combination.name)) if result is None else _figures(result)
            rows.append(
                "".join(f"<td>{escape(text)}</td>" for text in (combination.name, combination.limit_state, *figures))
            )
        table = "".join(f"<tr>{row}</tr>" for row in rows)
        return f"<table><caption>{escape(self.model.title)}</caption>{table}</table>"

    def _reason(self, combination: str) -> str:
        """Return why a combination has no certified results, on one line."""
        return refusal_words(self.refused[combination], self.model.units)


def refusal_words(error: GroundslabError, units: System = "SI") -> str:
    """Return why a combination has no certified results, on one line: the foundation fails, or it is not solved."""
    kind, reason = "FOUNDATION FAILS" if isinstance(error, NoEquilibrium) else "not solved", str(error)
    reason = reason if isinstance(reason, Message) else " ".join(reason.split())
    return Message("{kind}: {reason}", kind=kind, reason=words_in(reason, units))


def _figures(results: CombinationResult) -> tuple[str, str, str]:
    """Return largest settlement with its unit, area in contact [%] and verdict of the certificate as texts."""
    unit = in_system(PLATE_FIELDS["settlement"].display, results.model.units)
    settlement = f"{format_number(results.plate.settlement.max() * unit.scale, 4, trim=True)} {unit.name}"
    contact = format_number(100 * results.plate.contact_share, 4, trim=True)
    return settlement, contact, "certified" if results.certificate.holds else "NOT CERTIFIED"


def why_no_start(results: Results, model: Model) -> str:
    """Return in words why the refinement of a model cannot go on from results, "" where it can."""
    if results.model != model:
        return "results of another case"
    return "" if results.provisional else "results that are not provisional"


def results_of(results: CombinationResult | Results) -> Results:
    """Return the results of one combination as those of all there are, and those of all as they are."""
    from groundslab.model.loads.load_cases import Combination

    require(results, Results, CombinationResult, name="results")
    if isinstance(results, Results):
        return results
    about = {"name": results.combination, "limit_state": results.limit_state}
    combination = Combination(**about, factors=dict(results.factors) or {"": 1.0})
    holds = results.certificate.holds
    solved = {combination.name: results} if holds else {}
    return Results(results.model, (combination,), solved, {} if holds else {combination.name: NotCertified(results)})
