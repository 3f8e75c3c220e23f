"""A slab on the elastic continuum and on simpler models of the same ground, side by side."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from groundslab.analysis.driver import Variants
from groundslab.analysis.ground_comparison.figures import (
    CURVE_FIELDS,
    FIGURES,
    Place,
    axis_places,
    curve,
    figures_of,
    gauss_points,
    rms_differences,
    sample,
)
from groundslab.analysis.ground_comparison.fit import FITTED, fit
from groundslab.analysis.ground_comparison.soil_column import FROM_SOIL, SoilColumn, find_soil, on_continuum, on_ground
from groundslab.errors import InputError, Issue
from groundslab.messages import Message, quoted
from groundslab.model.combinations import list_combinations, place_patterns
from groundslab.model.ground import Ground, Pasternak, Winkler
from groundslab.model.loads.load_cases import Combination
from groundslab.model.model import Model
from groundslab.results.fields import extreme
from groundslab.results.records import Constants
from groundslab.results.results import CombinationResult, Results
from groundslab.schema.issues import require
from groundslab.schema.wording import one_of, quote, suggestion

#: A figure below this share of the largest of its unit on the continuum has no difference in percent.
NOTHING = 0.05
UNDETERMINED = "The slab is so stiff that its settlement hardly distinguishes two constants."


@dataclass(frozen=True, slots=True)
class ComparedGround:
    """A slab on one model of the ground.

    Attributes
    ----------
    ground : Continuum, ConstrainedModulus, Vlasov, Pasternak or Winkler
        The ground, as `Model.ground` takes it.
    fitted : bool
        Whether its constants are those with which the slab settles most like on the continuum.
    constants : dict of str to float
        Its constants by name: k [Pa/m] of springs, k0 [Pa/m], k1 [Pa m] and gamma [1] of other grounds that have them.
    figures : dict of str to float
        Figures of the slab by name, in SI units: "largest_settlement", "largest_moment_x", "contact_share", ...
    rms : dict of str to float
        The root of the mean square over the plate of the difference to the continuum, as a share of the continuum's
        largest value; of "settlement", "moment_x" and "moment_y".
    curves : dict of str to dict
        Fields along the lines of the comparison by axis, "x" or "y", and name, in SI units; None beside the plate.
    """

    ground: Ground
    fitted: bool
    constants: dict[str, float]
    figures: dict[str, float]
    rms: dict[str, float]
    curves: dict[str, dict[str, tuple[float | None, ...]]]

    @property
    def name(self) -> str:
        """The kind of the ground."""
        return self.ground.kind


@dataclass(frozen=True, slots=True)
class GroundComparison:
    """A slab on the elastic continuum and on simpler models of the same ground.

    Attributes
    ----------
    model : Model
        The model that was given.
    combination, limit_state : str
        Name and limit state of the combination that is compared.
    place : tuple of float
        Where the slab settles most on the continuum [m].
    lines : dict of str to tuple of float
        Coordinates of the samples along x and along y through that place [m], by axis.
    grounds : tuple of ComparedGround
        The grounds, the continuum first.
    notes : tuple of str
        What a reader must know about them.
    without_equilibrium : tuple of str
        Names of the combinations in which the foundation fails, as nothing balances the loads.
    """

    model: Model
    combination: str
    limit_state: str
    place: Place
    lines: dict[str, tuple[float, ...]]
    grounds: tuple[ComparedGround, ...]
    notes: tuple[str, ...]
    without_equilibrium: tuple[str, ...] = ()

    def __getitem__(self, name: str) -> ComparedGround:
        """Return the slab on a kind of ground; KeyError if there is none."""
        for ground in self.grounds:
            if ground.name == name:
                return ground
        raise KeyError(name)

    def difference(self, name: str, figure: str) -> float | None:
        """Return the difference of a figure to that on the continuum, as a share of the latter.

        Parameters
        ----------
        name : str
            Kind of the ground.
        figure : str
            Name of the figure.

        Returns
        -------
        float or None
            The difference; None where the figure is next to nothing on the continuum, less than a twentieth of the
            largest of its unit.
        """
        reference, unit = self.grounds[0].figures, FIGURES[figure].unit
        largest = max(abs(value) for other, value in reference.items() if FIGURES[other].unit == unit)
        if abs(reference[figure]) <= NOTHING * largest:
            return None
        return (self[name].figures[figure] - reference[figure]) / abs(reference[figure])


def compare_grounds(
    model: Model, combination: str | None = None, on_begin: Callable[[str], None] | None = None
) -> GroundComparison:
    """Solve a slab on the elastic continuum and on simpler models of its ground, and compare them.

    From the layers of soil follow the continuum, with the layers bonded, the layers compressed by the stresses of a
    homogeneous half-space over their constrained moduli, and Vlasov's ground, with the decay iterated and the ground
    going on beyond the plate. The constants of Pasternak's ground and of Winkler's springs are those with which the
    slab settles most like on the continuum: the integral of the squared difference is least. Loads, contact and the
    size of elements are the same for all.

    Parameters
    ----------
    model : Model
        The model. Its ground has layers given by E, nu and thickness: "continuum", "constrained modulus", "vlasov" or
        "layered". Of boreholes the one nearest to the plate's middle counts.
    combination : str, optional
        Name of the combination to compare; by default the one with the largest settlement on the continuum.
    on_begin : callable, optional
        Called with the kind of each ground before it is solved or fitted.

    Returns
    -------
    GroundComparison
        The figures of all grounds, their differences to the continuum, and the constants that were fitted.

    Raises
    ------
    InputError
        If the ground has no layers of soil or varies by zones, or if there is no such combination.
    GroundslabError
        If there is no certified result on one of the grounds; see `solve`.

    Examples
    --------
    >>> import groundslab
    >>> comparison = groundslab.compare_grounds(groundslab.load("case.toml"))
    >>> springs = comparison["winkler"].ground
    """
    require(model, Model, name="model")
    report = on_begin or (lambda _: None)
    soil = find_soil(model)
    base = on_continuum(model, soil)
    if combination is not None:
        base = _with_only(base, _find_combination(model, combination))
    report("continuum")
    variants = Variants(base)
    continuum = _deepest(variants.base)
    only = _with_only(base, next(entry for entry in variants.base.combinations if entry.name == continuum.combination))
    from_soil = _solve_from_soil(variants, only, soil, report)
    fitted, notes = _solve_fitted(variants, only, continuum, from_soil["vlasov"].constants, report)
    solved = {"continuum": continuum} | from_soil | fitted
    lost = tuple(variants.base.without_equilibrium)
    if names := quoted(lost, len(lost)):
        notes.append(Message("FOUNDATION FAILS: no equilibrium on the continuum in {listed}.", listed=names))
    if names := quoted(variants.base.unsolved, len(variants.base.unsolved)):
        notes.append(Message("Left aside, without a certified result on the continuum: {names}.", names=names))
    comparison = _compare(model, solved, (*_notes(base, continuum.limit_state), *notes, *soil.notes))
    return replace(comparison, without_equilibrium=lost)


def _solve_from_soil(
    variants: Variants, model: Model, soil: SoilColumn, report: Callable[[str], None]
) -> dict[str, CombinationResult]:
    """Return the results on the grounds that follow from the soil, by their kinds."""
    solved = {}
    for kind, make in FROM_SOIL.items():
        report(kind)
        solved[kind] = variants.solve_combinations(on_ground(model, make(soil))).only
    return solved


def _solve_fitted(
    variants: Variants, model: Model, continuum: CombinationResult, start: Constants, report: Callable[[str], None]
) -> tuple[dict[str, CombinationResult], list[str]]:
    """Return the results on the grounds that are fitted, by their kinds, and notes on the fit."""
    samples = gauss_points(continuum.plate)
    settlement = sample(continuum.plate, "settlement", samples.places)
    solved: dict[str, CombinationResult] = {}
    notes: list[str] = []
    for kind in FITTED:
        report(kind)
        ground, determined = fit(kind, model, (*start.k0, *start.k1), samples, settlement)
        if not determined:
            notes.append(
                Message(
                    "{undetermined} {capitalize}: others fit nearly as well.",
                    undetermined=UNDETERMINED,
                    capitalize=kind.capitalize(),
                )
            )
        solved[kind] = variants.solve_combinations(on_ground(model, ground)).only
    return solved, notes


def _with_only(model: Model, combination: Combination) -> Model:
    """Return a model with one combination alone."""
    changes = {"combinations": (combination,) if model.cases else (), "combine": None}
    return place_patterns(model).model_copy(update=changes)


def _find_combination(model: Model, name: str) -> Combination:
    """Return the combination of a name; raises InputError if there is none."""
    by_name = {combination.name: combination for combination in list_combinations(model)}
    if name not in by_name:
        names = list(by_name)
        raise InputError([Issue("combination", quote(name), one_of(names), suggestion(name, names))])
    return by_name[name]


def _deepest(results: Results) -> CombinationResult:
    """Return the combination with the largest settlement; raises a reason if none has a result.

    That the foundation fails comes before what was not solved.
    """
    if not results.results:
        raise next(iter([*results.without_equilibrium.values(), *results.refused.values()]))
    return max(results.values(), key=lambda result: float(result.plate.settlement.max()))


def _compare(model: Model, solved: dict[str, CombinationResult], notes: tuple[str, ...]) -> GroundComparison:
    """Return the comparison of results by the kind of their ground."""
    continuum = solved["continuum"]
    plate, samples = continuum.plate, gauss_points(continuum.plate)
    place = extreme(plate.nodes, plate.settlement, 1)[1]
    lines = axis_places(plate, place)
    grounds = tuple(
        ComparedGround(
            results.model.ground,
            kind in FITTED,
            _constants(results),
            figures_of(results.plate),
            rms_differences(results.plate, plate, samples),
            {
                axis: {field: curve(results.plate, field, places) for field in CURVE_FIELDS}
                for axis, places in lines.items()
            },
        )
        for kind, results in solved.items()
    )
    along = {axis: tuple(places[:, "xy".index(axis)].tolist()) for axis, places in lines.items()}
    about = continuum.combination, continuum.limit_state
    return GroundComparison(model, *about, place, along, grounds, notes)


def _constants(results: CombinationResult) -> dict[str, float]:
    """Return the constants of a ground before it softens: those given, else those that the analysis ended with."""
    ground = results.model.ground
    if isinstance(ground, Winkler):
        return {"k": ground.k} if ground.k is not None else {}
    if isinstance(ground, Pasternak):
        return {"k0": ground.k0, "k1": ground.k1}
    constants, softening = results.constants, _softening(results.model, results.limit_state)
    if len(constants.k0) != 1 or constants.gamma is None:
        return {}
    return {"k0": constants.k0[0] / softening, "k1": constants.k1[0] / softening, "gamma": constants.gamma}


def _softening(model: Model, limit_state: str) -> float:
    """Return the factor on the ground's stiffness under loads that last, 1 in other limit states."""
    return model.long_term.stiffness if model.long_term is not None and model.lasts(limit_state) else 1.0


def _notes(model: Model, limit_state: str) -> tuple[str, ...]:
    """Return what holds for every comparison, and how the ground is under loads that last."""
    softening = _softening(model, limit_state)
    softer = (
        Message(
            "All grounds are those under loads that last, {softening:g} times as stiff as their constants say.",
            softening=softening,
        ),
    )
    mesh = (
        "The mesh was refined for the continuum; elements of the same sizes were taken for all grounds. Constants were "
        "fitted on the first mesh."
        if model.mesh.adaptive
        else "Elements are of the same size on all grounds."
    )
    return (
        Message("{mesh} Ground that carries shear extends infinitely beyond the plate.", mesh=mesh),
        "Constants of Pasternak's ground and of springs are those with which this slab under these loads settles most "
        "like on the continuum, by least squares over its area. They hold for no other slab or load.",
        "The continuum's pressure grows without a limit towards the plate's edges: its largest value depends on the "
        "mesh, that which is exceeded on 5 % of the area hardly does. Grounds that carry shear also push by line "
        "forces along the edges, which are not in the pressure.",
        *(softer if softening != 1 else ()),
    )
