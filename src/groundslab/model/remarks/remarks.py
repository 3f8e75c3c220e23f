"""Remarks on a case that is right and yet may not say what was meant: above all, loads that act nowhere.

Nothing is left out for being dominated: contact makes the response nonlinear, so that a combination with less load can
govern. Only one of the same limit state with the same factors repeats another.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from groundslab.messages import Message, Name, counted, joined, quantity, series
from groundslab.model.combinations import list_combinations
from groundslab.model.loads.annexes import is_unknown
from groundslab.model.loads.clipping import find_clipped_loads
from groundslab.model.loads.load_cases import SERVICEABILITY, Combination, LimitState
from groundslab.model.loads.load_types import SelfWeight
from groundslab.model.loads.patterns import Vehicle, absent_forces
from groundslab.model.plates.region import get_plate_region
from groundslab.model.remarks.case_use import CaseUse, case_uses
from groundslab.model.remarks.grade_beams import as_toml, find_strips
from groundslab.model.remarks.pits import pit_remarks
from groundslab.model.remarks.pulling_cores import pulling_cores
from groundslab.model.remarks.resultants import case_forces
from groundslab.model.remarks.unusual import unusual_quantities
from groundslab.model.structure.columns import overlapping_columns
from groundslab.model.structure.spans import spans_of
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.wording import quote
from groundslab.units import show

if TYPE_CHECKING:
    from groundslab.model.model import Model

#: What cases of variable actions are called.
VARIABLE = re.compile(r"(Q|live|imposed|variable|traffic|wind|snow)([ _-]?loads?)?[ _-]?\d*", re.IGNORECASE)
#: Boreholes further off the plates than this share of their longer side are remarked on.
FAR_BOREHOLE = 0.1
#: A slab is at least so many times as wide as it is thick (EN 1992-1-1 5.3.1(4)); what is narrower and whose area is so
#: many times that of a square as wide consists of strips.
WIDE, LONG = 5.0, 4.0
#: So many combinations that repeat others are named.
MOST_NAMED = 3


@dataclass(frozen=True, slots=True)
class Remark:
    """A remark on a place of the case file.

    Attributes
    ----------
    path : tuple of str or int
        Keys and positions (from 0) of what it is on.
    words : str
        The remark.
    doubtful : bool
        Whether no design should pass before somebody has looked at it.
    of : str
        The load case or pattern that it is on, if any.
    """

    path: tuple[str | int, ...]
    words: str
    doubtful: bool = False
    of: str = ""

    @property
    def location(self) -> str:
        """Return the place as errors write it, positions counted from 1."""
        return RelativeIssue(self.path, "", "").issue("").location


def find_remarks(model: Model, combinations: Sequence[Combination] | None = None) -> tuple[Remark, ...]:
    """Return the remarks on a model: loads that act in no combination, and what else may not say what was meant.

    Parameters
    ----------
    model : Model
        The case as written.
    combinations : sequence of Combination, optional
        What is solved of it; made of the model if it is not known yet.

    Returns
    -------
    tuple of Remark
        The remarks; none where there is nothing to remark on.

    See Also
    --------
    check : Validate a model without solving it.

    Examples
    --------
    >>> import groundslab
    >>> groundslab.find_remarks(model)
    ()
    """
    combinations = list_combinations(model) if combinations is None else combinations
    uses = case_uses(model, combinations)
    return (
        *_on_cases(model, uses),
        *_on_limit_states(uses, combinations),
        *_on_cases_by_themselves(model, uses),
        *_on_columns(model),
        *_on_spans(model),
        *_on_clipped_loads(model),
        *(Remark(("cores", number), words) for number, words in pulling_cores(model, combinations)),
        *_on_patterns(model),
        *_on_moves(model),
        *_on_boreholes(model),
        *_on_strips(model),
        *(Remark(*remark) for remark in pit_remarks(model)),
        *(Remark(*unusual) for unusual in unusual_quantities(model)),
        *_on_repeated(model, uses, combinations),
        *_on_combine(model, uses, combinations),
        *_on_annex(model),
        *_on_names(model, uses),
        *_on_self_weight(model),
        *_on_uplift(model, uses, combinations),
    )


def _on_annex(model: Model) -> Iterator[Remark]:
    """Yield that combinations have the recommended values, where those of the annex were not found."""
    annex = None if model.combine is None else model.combine.annex
    if model.combine is not None and model.combine.expression != "ACI 318" and is_unknown(annex):
        words = Message(
            "psi and partial factors of the annex of {annex} to EN 1990 were not found: the recommended ones are taken",
            annex=str(annex),
        )
        yield Remark(("combine",), words)


def _on_cases(model: Model, uses: Sequence[CaseUse]) -> Iterator[Remark]:
    """Yield the cases without loads, and those that act in no combination, with their vertical force."""
    unused = [use for use in uses if not use.acting]
    forces = case_forces(model) if unused else {}
    for position, use in enumerate(uses):
        place, name = ("cases", position), use.case.name
        if use.empty:
            yield Remark(place, Message("case {name} has no loads", name=quote(name)), doubtful=True, of=name)
        elif use in unused:
            unnamed = "case {name} acts in no combination: {loads} left out{force}"
            named = "case {name} has the factor 0 wherever it is named: {loads} left out{force}"
            force = _force(forces[name]) if forces.get(name) else ""
            template = named if use.named else unnamed
            words = Message(template, name=quote(name), loads=_loads(use), force=force)
            yield Remark(place, words, doubtful=True, of=name)


def _force(force: float) -> Message:
    """Return a force [N] in brackets."""
    number, _, unit = show(force, "force").partition(" ")
    return Message(" ({force})", force=quantity(float(number), unit, ".5g"))


def _loads(use: CaseUse) -> str:
    """Return the loads of a case in words, with the verb that goes with them."""
    if not use.loads:
        return "its horizontal force is"
    return "its load is" if use.loads == 1 else Message("its {loads} loads are", loads=use.loads)


#: Limit states that are judged together, and what their combinations are called.
_FAMILIES: tuple[tuple[str, tuple[LimitState, ...]], ...] = (
    ("ultimate combination", ("ultimate",)), ("serviceability combination", SERVICEABILITY),
)  # fmt: skip


def _on_limit_states(uses: Sequence[CaseUse], combinations: Sequence[Combination]) -> Iterator[Remark]:
    """Yield the cases that act in some combinations, but in none that is ultimate, or in none of serviceability.

    A variable case may have no part in serviceability, as with psi_2 = 0; accidental and seismic ones have none.
    """
    limit_states = {combination.limit_state for combination in combinations}
    for words, states in _FAMILIES:
        if not limit_states & set(states):
            continue
        for position, use in enumerate(uses):
            name, action = use.case.name, use.case.action
            acting = {part.limit_state for part in use.acting}
            if use.empty or not acting or acting & set(states) or action not in ("permanent", "variable"):
                continue
            doubtful = action == "permanent" or "ultimate" in states
            text = Message("case {name} acts in no {text}", name=quote(name), text=words)
            yield Remark(("cases", position), text, doubtful, name)


def _on_cases_by_themselves(model: Model, uses: Sequence[CaseUse]) -> Iterator[Remark]:
    """Yield that no cases act together, where nothing combines them; doubtful where anything is checked then."""
    loaded = [use for use in uses if not use.empty]
    if model.combinations or model.combine is not None or len(loaded) < 2:
        return
    checked = any(part is not None for part in (model.limits, model.soil_strength, model.floor))
    words = "each case is solved by itself: without [[combinations]] or [combine] no two of them act together"
    yield Remark(("cases",), words, doubtful=checked)


def _on_columns(model: Model) -> Iterator[Remark]:
    """Yield the columns that stand in each other."""
    for words in overlapping_columns(model.columns):
        yield Remark(("columns",), words)


def _on_strips(model: Model) -> Iterator[Remark]:
    """Yield the remark that a slab consists of strips none of which is designed as a beam."""
    from shapely import get_parts, maximum_inscribed_circle

    if model.reinforcement is None or any(strip.design == "beam" for strip in model.output.strips):
        return
    region = get_plate_region(model.plate, model.plates)
    thickest = max(plate.thickness for plate in model.every_plate)
    for part in get_parts(region.area):
        width = 2 * maximum_inscribed_circle(part, tolerance=0.01 * thickest).length
        if width <= WIDE * thickest and part.area >= LONG * width**2:
            words: str = Message(
                "the slab is nowhere wider than {width:.3g m}, {times:.2g} times its thickness: strips that bend as "
                'beams; those in output.strips with design = "beam" are designed as such',
                width=width, times=width / thickest,
            )  # fmt: skip
            if strips := find_strips(model):
                words = Message("{text}; to be pasted at the end of the case: {entries}", text=words,
                                entries=Name(f"\n\n{as_toml(strips)}"))  # fmt: skip
            yield Remark(("plate",), words)
            return


def _on_spans(model: Model) -> Iterator[Remark]:
    """Yield the beams and walls that span openings of the plate: what they do there."""
    stiff = [number for number, wall in enumerate(model.walls) if wall.height is not None]
    for number, (beam, wall) in enumerate(zip(model.members, model.wall_of_members, strict=True)):
        lengths = [show(end - start, "length") for start, end in spans_of(beam, model.plate, model.plates)]
        if lengths:
            place = ("beams", number) if wall < 0 else ("walls", stiff[wall])
            what = (
                Message("beam {name}", name=quote(beam.name))
                if wall < 0
                else Message("wall {name}", name=quote(model.walls[stiff[wall]].name))
            )
            openings = "an opening" if len(lengths) == 1 else "openings"
            words = Message(
                "{what} spans {openings} of the plate, {widths} wide",
                what=what,
                openings=openings,
                widths=", ".join(lengths),
            )
            yield Remark(place, Message("{text}: what acts on it there goes to both edges", text=words))


def _on_clipped_loads(model: Model) -> Iterator[Remark]:
    """Yield the loads of which a part does not act."""
    for clipped in find_clipped_loads(model.plate, model.loads, model.plates, model.walls, model.spans):
        yield Remark(("loads", clipped.number - 1), clipped.words())


def _on_patterns(model: Model) -> Iterator[Remark]:
    """Yield the patterns that no move places, and the paths on which forces stand beside the plate."""
    placed = {move.pattern for move in model.moves}
    for position, pattern in enumerate(model.patterns):
        if pattern.name not in placed:
            unplaced = Message(
                "pattern {name} is not placed by any move: its forces are left out", name=quote(pattern.name)
            )
            yield Remark(("patterns", position), unplaced, doubtful=True, of=pattern.name)
    for position, words in absent_forces(model.plate, model.patterns, model.moves, model.plates):
        yield Remark(("moves", position), words)


def _on_moves(model: Model) -> Iterator[Remark]:
    """Yield the vehicles, and other patterns on paths, in permanent cases, where [combine] tells them apart."""
    if model.combine is None:
        return
    actions = {case.name: case.action for case in model.cases}
    vehicles = {pattern.name for pattern in model.patterns if isinstance(pattern, Vehicle)}
    for position, move in enumerate(model.moves):
        if (move.travels or move.pattern in vehicles) and actions.get(move.case) == "permanent":
            pattern, case = quote(move.pattern), quote(move.case)
            words = Message(
                'pattern {pattern} moves in case {case}, which is permanent; a moving load is "variable"',
                pattern=pattern,
                case=case,
            )
            yield Remark(("moves", position), words, doubtful="ultimate" in model.combine.sets, of=move.case)


def _on_boreholes(model: Model) -> Iterator[Remark]:
    """Yield the boreholes far off the plates, as where the origin or a unit was mistaken."""
    if not model.boreholes:
        return
    from shapely import Point

    area = get_plate_region(model.plate, model.plates).area
    for position, hole in enumerate(model.boreholes):
        off = area.distance(Point(hole.x, hole.y))
        if off > FAR_BOREHOLE * max(model.sides):
            name = quote(hole.name) if hole.name else str(position + 1)
            distance = show(off, "length")
            yield Remark(
                ("boreholes", position),
                Message("borehole {name} is {distance} off the plate", name=Name(name), distance=distance),
            )


def _on_repeated(model: Model, uses: Sequence[CaseUse], combinations: Sequence[Combination]) -> Iterator[Remark]:
    """Yield that combinations of one limit state have the same factors of all cases that are not empty."""
    empty = {use.case.name for use in uses if use.empty}
    first: dict[tuple[LimitState, frozenset[tuple[str, float]]], str] = {}
    repeated: dict[str, str] = {}
    for combination in combinations:
        factors = frozenset((name, factor) for name, factor in combination.factors if factor and name not in empty)
        first_name = first.setdefault((combination.limit_state, factors), combination.name)
        if first_name != combination.name:
            repeated[combination.name] = first_name
    if repeated:
        pairs = [
            Message("{name} is the same as {other}", name=quote(name), other=quote(first_name))
            for name, first_name in repeated.items()
        ]
        more = Message(" and {number} more", number=len(pairs) - MOST_NAMED) if len(pairs) > MOST_NAMED else ""
        key = "combinations" if model.combinations else "combine" if model.combine is not None else "cases"
        yield Remark(
            (key,),
            Message("combinations with the same factors: {pairs}{more}", pairs=joined(pairs[:MOST_NAMED]), more=more),
        )


def _on_combine(model: Model, uses: Sequence[CaseUse], combinations: Sequence[Combination]) -> Iterator[Remark]:
    """Yield that no case is variable, so that live loads would have the factor of dead ones; and sets of nothing.

    It matters in ultimate combinations, where the factors differ. Equilibrium and uplift may be of permanent actions
    alone, as under ground water.
    """
    if model.combine is None:
        return
    states = {combination.limit_state for combination in combinations}
    for state in (state for state in model.combine.sets if state not in states):
        yield Remark(
            ("combine", "sets"),
            Message("{name} yields no combination: all its factors are 0", name=quote(state)),
            doubtful=True,
        )
    loaded = [use.case for use in uses if not use.empty]
    if set(model.combine.sets) <= {"equilibrium", "uplift"} or any(case.action == "variable" for case in model.cases):
        return
    permanent = [quote(case.name) for case in loaded if case.action == "permanent"]
    if permanent:
        words = counted(
            len(permanent),
            'no case is variable: {cases} is combined as permanent; a live load needs action = "variable"',
            'no case is variable: {cases} are combined as permanent; a live load needs action = "variable"',
            cases=series(permanent),
        )
        yield Remark(("combine",), words, doubtful="ultimate" in model.combine.sets)


def _on_names(model: Model, uses: Sequence[CaseUse]) -> Iterator[Remark]:
    """Yield the permanent cases beside variable ones with names of live loads, where [combine] tells them apart.

    A case that states no action is permanent.
    """
    if model.combine is None or not any(case.action == "variable" for case in model.cases):
        return
    for position, use in enumerate(uses):
        case = use.case
        if case.action == "permanent" and not use.empty and VARIABLE.fullmatch(case.name):
            words = Message('case {name} is permanent, the default; a live load is "variable"', name=quote(case.name))
            yield Remark(("cases", position), words, doubtful="ultimate" in model.combine.sets, of=case.name)


def _on_self_weight(model: Model) -> Iterator[Remark]:
    """Yield the self-weights in cases that are not permanent, where [combine] gives them the factors of live loads.

    Such a weight has 1.5 and psi, and is absent wherever the live load is (EN 1990 4.1.1: self-weight is permanent).
    """
    if model.combine is None:
        return
    actions = {case.name: case.action for case in model.cases}
    for position, load in enumerate(model.loads):
        action = actions.get(load.case, "permanent")
        if isinstance(load, SelfWeight) and action != "permanent":
            words = Message(
                "self-weight is permanent, but acts in case {name}, which is {action}",
                name=quote(load.case),
                action=action,
            )
            yield Remark(("loads", position), words, doubtful=True, of=load.case)


def _on_uplift(model: Model, uses: Sequence[CaseUse], combinations: Sequence[Combination]) -> Iterator[Remark]:
    """Yield that nothing acts upwards in the combinations of uplift, and cases upwards that take no part in them."""
    if not any(combination.limit_state == "uplift" for combination in combinations):
        return
    lifting = {case for case, force in case_forces(model).items() if force < 0}
    inside = {use.case.name for use in uses if any(part.limit_state == "uplift" for part in use.acting)}
    if not lifting & inside:
        key = "combine" if model.combine is not None and "uplift" in model.combine.sets else "combinations"
        words = "nothing acts upwards in the uplift combinations; water pressure from below is a load with q below 0"
        yield Remark((key,), words, doubtful=True)
    for position, use in enumerate(uses):
        case = use.case
        if case.name in lifting - inside and case.action != "seismic":
            hint = "; [combine] makes none with accidental actions, [[combinations]] can list one"
            words = Message("case {name} acts upwards, but in no uplift combination", name=quote(case.name))
            words += hint if case.action == "accidental" else ""
            yield Remark(("cases", position), words, doubtful=True, of=case.name)
