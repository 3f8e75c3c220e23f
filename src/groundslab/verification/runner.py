"""Published and analytic cases, held against what groundslab computes.

Cases are data (folder cases): models in the words of the input file, and rows that name a quantity of one of them, the
published digits or an exact formula, and how far off it may be. A row that deviates says by how much and why, and fails
if the deviation changes. A published number that cannot be right names its proof, which is computed each time. Each
row has a second number, our own, pinned in pinned.toml: a change within the tolerance is seen, too.
"""

from __future__ import annotations

import math
import tomllib
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from importlib import import_module
from importlib.resources import files
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab import units
from groundslab.accuracy.judgment import SIZES, JudgedValue, judged_values
from groundslab.accuracy.values import estimate_error, estimate_errors
from groundslab.analysis import driver
from groundslab.case import casefile
from groundslab.design.bars.beam_bars import beam_needs
from groundslab.design.bars.members import BeamMember
from groundslab.design.bars.wall_bars import wall_needs
from groundslab.design.checks import DesignCheck, check_design
from groundslab.discretize.ground import ground_of, varies
from groundslab.fem.vlasov import Soil
from groundslab.model.ground import SoilLayer
from groundslab.model.model import Model
from groundslab.results.fields import PLATE_FIELDS
from groundslab.results.results import CombinationResult, Results
from groundslab.verification.analytic import FORMULAS
from groundslab.verification.design_values import VALUES
from groundslab.verification.proofs import PROOFS

if TYPE_CHECKING:
    from rich.console import Console

#: A deviation that a case explains may change by this much before the row fails, in points of per cent.
DRIFT = 0.3
#: Rounding of a solution, over its value.
ROUNDING = 1e-11
#: Relative change of a row's pinned value at which it fails, on a grid of elements and on a mesh that a mesher made,
#: whose versions differ.
PINNED, PINNED_MESHED = 1e-5, 5e-3
#: What a file or a pipe gets: columns enough to show every row on a line of its own.
WIDTH = 120


@dataclass(frozen=True, slots=True)
class Outcome:
    """One row of a case: what was published, what was computed (in the row's unit), and the verdict on it.

    `error` is the discretization error of what was computed, None if none is known.
    """

    label: str
    published: str
    computed: float
    error: float | None
    difference: str
    verdict: str
    reason: str
    ok: bool


@dataclass(frozen=True, slots=True)
class Case:
    """A case as its file states it."""

    name: str
    group: str
    title: str
    source: str
    note: str
    needs: str
    models: Mapping[str, Mapping[str, Any]]
    rows: Sequence[Mapping[str, Any]]


def names() -> list[str]:
    """Return the names of all cases, and of the groups that they form."""
    cases = [load(name) for name in case_names()]
    return [*dict.fromkeys(case.group for case in cases), *(case.name for case in cases)]


def case_names() -> list[str]:
    """Return the names of all cases."""
    folder = files("groundslab.verification") / "cases"
    return sorted(entry.name.removesuffix(".toml") for entry in folder.iterdir() if entry.name.endswith(".toml"))


@cache
def load(name: str) -> Case:
    """Return a case by its name."""
    text = (files("groundslab.verification") / "cases" / f"{name}.toml").read_text(encoding="utf-8")
    table = tomllib.loads(text)
    about = {key: table.get(key, "") for key in ("group", "title", "source", "note", "needs")}
    return Case(name=name, models=table.get("models", {}), rows=table["rows"], **about)


@cache
def pinned() -> Mapping[str, Mapping[str, float]]:
    """Return our own values of all rows in the rows' units, by case and label; tools/pin_cases.py writes them."""
    return tomllib.loads((files("groundslab.verification") / "pinned.toml").read_text(encoding="utf-8"))


def run(wanted: Sequence[str], console: Console) -> bool:
    """Run cases or groups of them, print each row, and return whether all rows passed."""
    if not console.is_terminal:
        console.width = WIDTH
    chosen = [case for case in map(load, case_names()) if case.name in wanted or case.group in wanted]
    failed = 0
    for case in [case for case in chosen if not can_run(case)]:
        how = r"pip install 'groundslab\[mesh]' or 'groundslab\[netgen]'"
        console.print(f"{case.name}: SKIPPED, it needs {case.needs}: {how}\n", style="bold")
    chosen = [case for case in chosen if can_run(case)]
    for case in chosen:
        outcomes = list(outcomes_of(case))
        _print(case, outcomes, console)
        failed += sum(not outcome.ok for outcome in outcomes)
    cases = "1 case" if len(chosen) == 1 else f"{len(chosen)} cases"
    console.print(f"{cases}, {failed} FAILED" if failed else f"{cases}, every row passed", style="bold")
    return failed == 0


def can_run(case: Case) -> bool:
    """Return whether one of the optional packages that a case needs, if any, can be imported here."""
    return not case.needs or any(map(_can_be_imported, case.needs.split(" or ")))


def _can_be_imported(name: str) -> bool:
    try:
        return import_module(name) is not None
    except (ImportError, OSError, RuntimeError):  # Netgen refuses other Pythons with a RuntimeError
        return False


def outcomes_of(
    case: Case, solved: dict[tuple[str, tuple[int, ...]], CombinationResult] | None = None
) -> Iterator[Outcome]:
    """Yield the outcome of each row of a case; a model is solved once however many rows ask for it.

    Its results are kept in `solved`, by the model's name and the counts of its mesh, where a row gives them.
    """
    solved = {} if solved is None else solved

    def results_of(name: str, counts: Sequence[int] = ()) -> CombinationResult:
        key = name, tuple(counts)
        if key not in solved:
            solved[key] = driver.solve(model_of(case, name, counts)).only
        return solved[key]

    for row in case.rows:
        outcome = _outcome(case, row, results_of)
        # of a told error over a true one, both of which are small, digits depend on the mesh
        yield outcome if "judged" in row else _held_to_pin(case, outcome)


def model_of(case: Case, name: str, counts: Sequence[int] = ()) -> Model:
    """Return a model of a case, with other counts if given; `fit` finds the modulus of its layers first."""
    description = dict(case.models[name])
    fit = description.pop("fit", None)
    model = casefile.from_table(description)
    if counts:
        model = model.replace(mesh=model.mesh.replace(size=None, counts=tuple(counts)))
    return model if fit is None else _fitted(model, fit)


def _fitted(model: Model, fit: Mapping[str, Any]) -> Model:
    """Return the model with one modulus for all its layers, such that a settlement comes out as published."""
    target = float(fit["published"]) * units.parse(f"1 {fit['unit']}", "length")
    points: list[tuple[float, float]] = []
    E = model.ground.layers[0].E  # type: ignore[union-attr]
    while True:
        layers = [layer.replace(E=E) for layer in model.ground.layers if isinstance(layer, SoilLayer)]  # type: ignore[union-attr]
        model = model.replace(ground=model.ground.replace(layers=layers))
        w = driver.solve(model).plate.value_at("settlement", *fit["at"])
        points.append((math.log(E), math.log(w)))
        if abs(w / target - 1) < 1e-6:
            return model
        slope = -1.0
        if len(points) > 1:
            (x0, y0), (x1, y1) = points[-2:]
            slope = (y1 - y0) / (x1 - x0)
        E = math.exp(points[-1][0] + (math.log(target) - points[-1][1]) / slope)


#: Constants of the ground.
CONSTANTS = ("k0", "k1", "gamma")
#: Judged values that are no fields.
NOT_A_FIELD = {"contact share": "area in contact", "support": "force of supports"}

#: Nodal fields at places.
AT_NODES = ("moment_x", "moment_y")

Quantity = Callable[[CombinationResult, Mapping[str, Any]], float]


def _principal(results: CombinationResult, row: Mapping[str, Any], sign: float) -> float:
    """Return a principal moment at a row's place [N m/m]."""
    x, y, xy = (results.plate.value_at(f"moment_{name}", *row["at"]) for name in ("x", "y", "xy"))
    return float((x + y) / 2 + sign * math.hypot((x - y) / 2, xy))


def _of_beam(results: CombinationResult, row: Mapping[str, Any], name: str) -> float:
    """Return a section force of a row's beam at its way, of a rib that of the T [N m or N]."""
    number = next(number for number, beam in enumerate(results.beams) if beam.name == row["beam"])
    forces = BeamMember(results.model.members[number], number).forces(results)
    return float(np.interp(row["way"], forces.way, getattr(forces, name)))


def _alone(results: CombinationResult) -> Results:
    """Return the results of a combination as those of a model that has no others."""
    return Results(results.model, results.model.combinations, {results.combination: results}, {})


def _check(results: CombinationResult, row: Mapping[str, Any]) -> DesignCheck:
    """Return the design check that a row names."""
    return next(check for check in check_design(_alone(results)).checks if check.name == row["check"])


def _beam_need(results: CombinationResult, row: Mapping[str, Any]) -> float:
    """Return what a row's beam needs [m2 or m2/m], or the share used of its struts."""
    assert results.model.reinforcement is not None
    needs = beam_needs(_alone(results), results.model.reinforcement)
    return next(need.area for need in needs if (need.beam, need.what) == (row["beam"], row["what"]))


def _wall_need(results: CombinationResult, row: Mapping[str, Any]) -> float:
    """Return the size of what a row names of its wall: a force [N], or bars [m2/m]."""
    assert results.model.reinforcement is not None
    needs = wall_needs(_alone(results), results.model.reinforcement)
    return abs(next(float(getattr(need, row["what"])) for need in needs if need.wall == row["wall"]))


#: What a row may ask for: the dimension of its unit, and how to take it from the results; of a check in its own unit.
QUANTITIES: dict[str, tuple[str | None, Quantity]] = {
    "settlement": ("length", lambda r, row: r.plate.value_at("settlement", *row["at"])),
    "largest settlement": ("length", lambda r, _: float(r.plate.settlement.max())),
    "largest uplift": ("length", lambda r, _: float(-r.plate.settlement.min())),
    "ground settlement": ("length", lambda r, row: r.ground.value_at(*row["at"])),
    "soil stress": ("pressure", lambda r, row: float(r.ground.stress_at(*row["at"]))),
    "moment_x": ("force", lambda r, row: r.plate.value_at("moment_x", *row["at"])),
    "moment_y": ("force", lambda r, row: r.plate.value_at("moment_y", *row["at"])),
    "moment_1": ("force", lambda r, row: _principal(r, row, 1.0)),
    "moment_2": ("force", lambda r, row: _principal(r, row, -1.0)),
    "moment of a beam": ("moment", lambda r, row: _of_beam(r, row, "moment")),
    "shear force of a beam": ("force", lambda r, row: _of_beam(r, row, "shear")),
    "need of a beam": (None, _beam_need),
    "need of a wall": (None, _wall_need),
    "force of a support": ("force", lambda r, row: next(s.total for s in r.supports if s.name == row["support"])),
    "contact share": ("share", lambda r, _: r.plate.contact_share),
    "demand of a check": (None, lambda r, row: _check(r, row).demand or 0.0),
    "resistance of a check": (None, lambda r, row: _check(r, row).resistance or 0.0),
    "share of a check": (None, lambda r, row: _check(r, row).utilization or 0.0),
    "k0": ("pressure per length", lambda r, row: r.constants.k0[row.get("layer", 1) - 1]),
    "k1": ("pressure times length", lambda r, row: r.constants.k1[row.get("layer", 1) - 1]),
    "gamma": (None, lambda r, _: r.constants.gamma or 0.0),
}


def _held_to_pin(case: Case, outcome: Outcome) -> Outcome:
    """Return the outcome of a row, failed if its value is not the pinned one any more."""
    pin = pinned().get(case.name, {}).get(outcome.label)
    if pin is not None and math.isclose(outcome.computed, pin, rel_tol=PINNED_MESHED if case.needs else PINNED):
        return outcome
    why = "no value is pinned" if pin is None else f"our own number was {pin:.8g}"
    return replace(outcome, verdict="FAILED", ok=False, reason=f"{why}; tools/pin_cases.py pins the new one")


def _outcome(case: Case, row: Mapping[str, Any], results_of: Callable[..., CombinationResult]) -> Outcome:
    """Return the outcome of one row against its source."""
    if "orders" in row:
        return _order(row, results_of)
    if "judged" in row:
        return _told(row, results_of)
    computed = _computed(case, row, results_of) / _unit(row) * row.get("factor", 1.0)
    reference = float(row["published"]) if "published" in row else _exact(row) / _unit(row)
    published = row.get("published", f"{reference:.6g}")
    difference = computed - reference
    percent = 100 * difference / abs(reference)
    shown = f"{difference:+.2g} ({percent:+.2g} %)"
    verdict, reason = "agrees", row.get("why", "")
    if "proof" in row:
        proof = PROOFS[row["proof"]["kind"]](results_of, **{k: v for k, v in row["proof"].items() if k != "kind"})
        verdict, reason, ok = "cannot be right", proof.says, proof.holds
    elif "differs" in row:
        verdict, ok = "differs, as explained", abs(percent - float(row["differs"])) <= DRIFT
    else:
        tolerance = _tolerance(row, published)
        if not 0 < tolerance < abs(reference):
            fault = f"a tolerance of {tolerance} against {published} checks nothing"
            raise ValueError(f"{case.name}: {row['label']}: {fault}")
        ok = abs(difference) <= tolerance
    error = _error(row, results_of)
    return Outcome(row["label"], published, computed, error, shown, verdict if ok else "FAILED", reason, ok)


def _error(row: Mapping[str, Any], results_of: Callable[..., CombinationResult]) -> float | None:
    """Return the discretization error of a row's quantity in the row's unit, None if none is known."""
    if "value" in row or row["quantity"] in CONSTANTS:
        return None
    take, results = QUANTITIES[row["quantity"]][1], results_of(row["model"], row.get("counts", ()))
    if results.coarser is None or results.comparison is None:
        return None
    if row["quantity"] in AT_NODES:
        name, plate = row["quantity"], results.plate
        errors = estimate_errors(results, name, getattr(plate, name), getattr(results.coarser.plate, name))
        fields: dict[str, Any] = {name: errors}
        error = take(replace(results, plate=replace(plate, **fields)), row)
    else:
        error = estimate_error(take(results, row), take(results.coarser, row), results.comparison)
    return float(error / _unit(row) * abs(row.get("factor", 1.0)))


def _computed(case: Case, row: Mapping[str, Any], results_of: Callable[..., CombinationResult]) -> float:
    """Return the row's quantity in SI units; design codes, and k0 and k1 of a given gamma, need no solution."""
    if "value" in row:
        return float(VALUES[row["value"]][1](**row["of"]))
    if row["quantity"] in ("k0", "k1"):
        model = model_of(case, row["model"])
        ground = ground_of(model)
        if isinstance(ground, Soil) and ground.gamma is not None and not varies(model):
            return float(
                ground.layer_parameters(ground.gamma)[("k0", "k1").index(row["quantity"])][row.get("layer", 1) - 1]
            )
    return QUANTITIES[row["quantity"]][1](results_of(row["model"], row.get("counts", ())), row)


def _unit(row: Mapping[str, Any]) -> float:
    """Return the size of the row's unit in SI units."""
    dimension = VALUES[row["value"]][0] if "value" in row else QUANTITIES[row["quantity"]][0]
    return 1.0 if dimension is None else units.parse(f"1 {row['unit']}", dimension)


def _exact(row: Mapping[str, Any]) -> float:
    """Return the value of the row's formula in SI units."""
    arguments = dict(row["exact"])
    return FORMULAS[arguments.pop("formula")](**arguments)


def _tolerance(row: Mapping[str, Any], published: str) -> float:
    """Return how far off a row may be, in its unit: stated so, in per cent, or half a unit of the last digit."""
    stated = row["tolerance"]
    if stated == "digits":
        mantissa, _, exponent = published.lower().partition("e")
        half = 0.5 * 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))
        # a value may lie halfway between two such numbers, but for the rounding of its solution
        return half + ROUNDING * abs(float(published))
    number, _, unit = stated.partition(" ")
    return float(number) / 100 * abs(float(published)) if unit == "%" else float(number)


def _order(row: Mapping[str, Any], results_of: Callable[..., CombinationResult]) -> Outcome:
    """Return the observed order of convergence over the last two refinements of a row's meshes."""
    take, exact = QUANTITIES[row["quantity"]][1], _exact(row)
    errors = [abs(take(results_of(row["model"], counts), row) - exact) for counts in row["orders"]]
    orders = [math.log2(coarse / fine) for coarse, fine in pairwise(errors)]
    ok = orders[-1] >= row["at_least"]
    errors_shown = ", ".join(f"{error / abs(exact):.1e}" for error in errors)
    return Outcome(
        row["label"], f">= {row['at_least']}", orders[-1], None, "", "agrees" if ok else "FAILED",
        f"relative errors {errors_shown}", ok,
    )  # fmt: skip


def _told(row: Mapping[str, Any], results_of: Callable[..., CombinationResult]) -> Outcome:
    """Return the told error of a judged value over the true one."""
    value = _judged(results_of(row["model"]), row)
    exact = float(row["published"]) if "published" in row else _exact(row)
    true = abs(value.value - (abs(exact) if row["judged"] in SIZES else exact))
    low, high = row["told"]
    ratio = value.share / true
    ok = low <= ratio <= high
    shares = (100 * error / abs(value.value) for error in (true, value.share))
    said = "true {:.2g} %, told {:.2g} %".format(*shares)
    return Outcome(row["label"], f"{low} to {high}", ratio, None, said, "agrees" if ok else "FAILED", "", ok)


def _judged(results: CombinationResult, row: Mapping[str, Any]) -> JudgedValue:
    """Return the judged value of a row with its error [SI]: the first of its name, or the last, which is the least."""
    label = NOT_A_FIELD.get(row["judged"]) or PLATE_FIELDS[row["judged"]].label
    values = [value for _, value in judged_values(results) if value.label == label]
    return values[-1 if row.get("least") else 0]


def _print(case: Case, outcomes: Sequence[Outcome], console: Console) -> None:
    """Print a case: its rows as a table, each reason once below it."""
    from rich.box import SIMPLE
    from rich.table import Table
    from rich.text import Text

    reasons = list(dict.fromkeys(outcome.reason for outcome in outcomes if outcome.reason))
    table = Table(box=SIMPLE, title=Text(f"{case.name}: {case.title}"), title_justify="left", pad_edge=False)
    for name in ("row", "published", "computed", "mesh", "difference", "verdict"):
        table.add_column(name)
    for outcome in outcomes:
        mark = f" [{reasons.index(outcome.reason) + 1}]" if outcome.reason else ""
        style = "" if outcome.verdict == "agrees" else "bold red" if not outcome.ok else "yellow"
        computed = f"{outcome.computed:.6g}"
        error = "" if outcome.error is None else f"+-{outcome.error:.1g}"
        verdict = Text(outcome.verdict + mark, style=style)
        table.add_row(Text(outcome.label), outcome.published, computed, error, outcome.difference, verdict)
    console.print(Text(f"source: {case.source}"))
    console.print(table)
    for number, reason in enumerate(reasons, start=1):
        console.print(Text(f"[{number}] {reason}"))
    if case.note:
        console.print(Text(" ".join(case.note.split())))
    console.print()
