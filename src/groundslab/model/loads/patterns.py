"""Patterns of point loads: vehicles and racks, which stand at a place or move along a path.

A case that moves is solved at every position, as one case for each: on ground without tension no position follows from
others. What governs is the envelope over them, as over any combinations.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Annotated, ClassVar, Literal

from groundslab.errors import InputError
from groundslab.model.ground import POSITIVE
from groundslab.model.loads.en1990 import MOST_COMBINATIONS, make_combinations
from groundslab.model.loads.load_cases import Combination, Combine, LoadCase, check_case_names
from groundslab.model.loads.load_types import PointLoad
from groundslab.model.loads.placement import on_plate
from groundslab.model.plate import Plate
from groundslab.model.plates.other_plates import FurtherPlate
from groundslab.model.plates.region import PlateRegion
from groundslab.model.shapes import Place
from groundslab.model.structure.columns import TURN, check_footprint
from groundslab.model.structure.lines import NO_LENGTH
from groundslab.model.supports import check_names
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Integer, ListOf, Number, Quantity, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.ranges import Range
from groundslab.schema.repairs import remove, use_nearest
from groundslab.schema.section_fields import ByKind, Table
from groundslab.schema.wording import describe, one_of, suggestion

#: Patterns have no more forces than this, at all of their places together.
MOST_FORCES = 100_000
#: Steps are not smaller [m], so that positions with two decimals are told apart.
LEAST_STEP = 0.05
#: A position nearer than this to the path's end [m] is not told from it.
SAME_POSITION = 0.01
#: A rectangle that is turned by a right angle but for so much [rad] is a rectangle along x and y again.
SQUARE = 1e-9
#: Angles of turned rectangles have so many digits after the point [degrees], so that they have no noise of arctangents.
ANGLE_DIGITS = 9

Width = float | None
Offset = Quantity("length", "y", "", example="1.1 m")


class Wheel(Section):
    """A wheel of a vehicle, or any other force of a pattern."""

    constraints: ClassVar[tuple[Check, ...]] = (check_footprint,)

    P: Annotated[float, Quantity("force", "P", "force, downwards positive", example="40 kN")]
    x: Annotated[
        float, Quantity("length", "x", "distance ahead of the pattern's origin, in its direction", example="1.5 m")
    ] = 0.0
    y: Annotated[float, Quantity("length", "y", "distance to the left of the origin", example="1.5 m")] = 0.0
    width_x: Annotated[Width, Quantity("length", "c_x", "width along the direction", POSITIVE, example="200 mm")] = None
    width_y: Annotated[Width, Quantity("length", "c_y", "width across it", POSITIVE, example="200 mm")] = None
    diameter: Annotated[
        Width, Quantity("length", "d", "diameter, instead of both widths", POSITIVE, example="200 mm")
    ] = None


class Vehicle(Section):
    """A vehicle, or any other pattern of forces."""

    kind: Annotated[Literal["vehicle"], Table("forces at places relative to an origin")] = "vehicle"
    name: Annotated[str, Text("name of the pattern, used by moves")]
    wheels: Annotated[tuple[Wheel, ...], Table("its wheels", 100)]

    def forces(self) -> tuple[Wheel, ...]:
        """Return its forces."""
        return self.wheels


class Rack(Section):
    """A rack: frames one behind the other, each with the same legs."""

    constraints: ClassVar[tuple[Check, ...]] = (check_footprint,)

    kind: Annotated[Literal["rack"], Table("legs of racks, in frames one behind the other")] = "rack"
    name: Annotated[str, Text("name of the pattern, used by moves")]
    P: Annotated[float, Quantity("force", "P", "force of each leg, downwards positive", example="60 kN")]
    frames: Annotated[int, Integer("number of frames in the direction of the rack", at_least=1, at_most=200)] = 1
    bay: Annotated[float, Quantity("length", "b", "spacing of the frames", POSITIVE, example="2.7 m")] = 2.7
    rows: Annotated[
        tuple[float, ...],
        ListOf(Offset, "y", "distances of a frame's legs across the rack, to the left of its origin", most=100),
    ] = (0.0,)
    width_x: Annotated[
        Width, Quantity("length", "c_x", "width of a base plate along the rack", POSITIVE, example="100 mm")
    ] = None
    width_y: Annotated[Width, Quantity("length", "c_y", "width across it", POSITIVE, example="100 mm")] = None
    diameter: Annotated[
        Width, Quantity("length", "d", "diameter, instead of both widths", POSITIVE, example="100 mm")
    ] = None

    def forces(self) -> tuple[Wheel, ...]:
        """Return the forces of its legs, frame by frame."""
        leg = {"P": self.P, "width_x": self.width_x, "width_y": self.width_y, "diameter": self.diameter}
        return tuple(Wheel(x=frame * self.bay, y=y, **leg) for frame in range(self.frames) for y in self.rows)


AnyPattern = Vehicle | Rack
Pattern = Annotated[AnyPattern, ByKind()]


def _check_path(points: tuple[tuple[float, float], ...], step: float | None) -> Iterator[RelativeIssue]:
    for position, (a, b) in enumerate(pairwise(points), start=1):
        if math.dist(a, b) < NO_LENGTH:
            repeated = f"({b[0]!r}, {b[1]!r}) m twice"
            yield RelativeIssue(("points", position), repeated, "another place than the one before")
    if len(points) > 1 and step is None:
        yield RelativeIssue(("step",), "nothing", 'a step along the path such as "0.5 m"', "one point is a fixed place")
    elif len(points) == 1 and step is not None:
        expected, repairs = "no step if the pattern is at a single point", (remove(("step",)),)
        yield RelativeIssue(("step",), f"{step!r} m", expected, repairs=repairs)


class Move(Section):
    """Where a pattern stands, or the path along which it moves."""

    constraints: ClassVar[tuple[Check, ...]] = (_check_path,)

    name: Annotated[str, Text("name of the path, needed where a case has several")] = ""
    pattern: Annotated[str, Text("name of the pattern, one of [[patterns]]")]
    case: Annotated[str, Text("its load case; needed for a path")] = ""
    points: Annotated[
        tuple[tuple[float, float], ...],
        ListOf(Place, "x, y", "one place for the pattern's origin, or the points of its path"),
    ]
    step: Annotated[
        float | None,
        Quantity("length", "s", "spacing of the positions along the path", Range(at_least=LEAST_STEP), example="0.5 m"),
    ] = None
    turn: Annotated[
        float, Number("alpha", "angle of the pattern's direction in degrees, from x, or from the path", TURN)
    ] = 0.0

    @property
    def travels(self) -> bool:
        """Return whether there is a path."""
        return len(self.points) > 1


@dataclass(frozen=True, slots=True)
class Station:
    """A place of a pattern: distance along the path [m], its origin [m], its direction [rad] from x."""

    distance: float
    origin: tuple[float, float]
    angle: float


def stations(move: Move) -> tuple[Station, ...]:
    """Return the places of a move: at each step along its path, and at its end."""
    turn = math.radians(move.turn)
    if not move.travels:
        return (Station(0.0, move.points[0], turn),)
    lengths = [math.dist(a, b) for a, b in pairwise(move.points)]
    places, piece, before = [], 0, 0.0
    for distance in _distances(move, sum(lengths)):
        while distance >= before + lengths[piece] - NO_LENGTH and piece < len(lengths) - 1:
            before += lengths[piece]
            piece += 1
        (x0, y0), (x1, y1) = move.points[piece : piece + 2]
        share = (distance - before) / lengths[piece]
        origin = (x0 + share * (x1 - x0), y0 + share * (y1 - y0))
        places.append(Station(distance, origin, math.atan2(y1 - y0, x1 - x0) + turn))
    return tuple(places)


def _distances(move: Move, length: float) -> list[float]:
    """Return how far along a path of a length [m] its positions lie; the end replaces one that is as good as there."""
    assert move.step is not None
    count = math.floor(length / move.step)
    distances = [number * move.step for number in range(count + 1) if length - number * move.step > SAME_POSITION]
    return [*distances, length]


def position_name(move: Move, station: Station) -> str:
    """Return the name of the case at a position, as in "forklift at 3.50 m"."""
    return f"{move.case} at {station.distance:.2f} m" + (f" of {move.name}" if move.name else "")


def position_names(moves: tuple[Move, ...]) -> dict[str, tuple[str, ...]]:
    """Return the names of each moving case at its positions; on several paths it moves along one at a time."""
    names: dict[str, tuple[str, ...]] = {}
    for move in moves:
        if move.travels:
            here = tuple(position_name(move, station) for station in stations(move))
            names[move.case] = (*names.get(move.case, ()), *here)
    return names


def point_loads(pattern: AnyPattern, station: Station, case: str) -> tuple[PointLoad, ...]:
    """Return the loads of a pattern at a place, their footprints turned with it."""
    x, y = station.origin
    cos = math.cos(station.angle)
    sin = math.sin(station.angle)
    loads = []
    for force in pattern.forces():
        place = {"x": x + cos * force.x - sin * force.y, "y": y + sin * force.x + cos * force.y}
        loads.append(PointLoad(P=force.P, name=pattern.name, case=case, **place, **_footprint(force, cos, sin)))
    return tuple(loads)


def _footprint(force: Wheel, cos: float, sin: float) -> dict[str, float]:
    """Return the keys of a force's footprint in a direction."""
    if force.diameter is not None:
        return {"diameter": force.diameter}
    if force.width_x is None or force.width_y is None:
        return {}
    if abs(sin) < SQUARE:
        return {"width_x": force.width_x, "width_y": force.width_y}
    if abs(cos) < SQUARE:
        return {"width_x": force.width_y, "width_y": force.width_x}
    half_turns = math.remainder(math.degrees(math.atan2(sin, cos)), 180)  # after which a rectangle is the same
    return {"width_x": force.width_x, "width_y": force.width_y, "angle": round(half_turns, ANGLE_DIGITS)}


def loads_on_plate(covered: PlateRegion, loads: tuple[PointLoad, ...]) -> tuple[PointLoad, ...]:
    """Return the loads whose footprints lie on the plate entirely; the others stand on what is beside it."""
    return tuple(load for load in loads if not any(on_plate(covered, load, ())))


def absent_forces(
    plate: Plate, patterns: tuple[AnyPattern, ...], moves: tuple[Move, ...], plates: tuple[FurtherPlate, ...] = ()
) -> Iterator[tuple[int, str]]:
    """Yield the position in the list of each path on which forces stand beside the plate, and a remark on them."""
    by_name, covered = {pattern.name: pattern for pattern in patterns}, PlateRegion(plate, plates)
    for position, move in enumerate(moves):
        pattern, places = by_name[move.pattern], stations(move)
        beside = [
            len(pattern.forces()) - len(loads_on_plate(covered, point_loads(pattern, station, move.case)))
            for station in places
        ]
        if any(beside):
            where = f"at {sum(map(bool, beside))} of {len(places)} positions"
            forces = f"up to {max(beside)} of {len(pattern.forces())} forces are off the plate"
            yield position, f"moves[{position + 1}]: {forces} {where}"


def expand(
    combinations: tuple[Combination, ...], moves: tuple[Move, ...], fixed: frozenset[str]
) -> tuple[Combination, ...]:
    """Return the combinations at all positions of the cases in them that move; in fixed cases something stands, too."""
    names = position_names(moves)
    expanded = combinations
    for case, positions in names.items():
        expanded = tuple(
            position for combination in expanded for position in _at_positions(combination, case, positions, fixed)
        )
    return expanded


def _at_positions(
    combination: Combination, case: str, positions: tuple[str, ...], fixed: frozenset[str]
) -> Iterator[Combination]:
    """Yield a combination at all positions of a case, itself if the case takes no part."""
    if not any(name == case and factor for name, factor in combination.factors):
        yield combination
        return
    for position in positions:
        here = (case, position) if case in fixed else (position,)
        factors = tuple(
            (name, factor)
            for name_of_case, factor in combination.factors
            for name in (here if name_of_case == case else (name_of_case,))
        )
        name = position if combination.name == case else f"{combination.name}, {position}"
        yield combination.model_copy(update={"name": name, "factors": factors})


def check_patterns(
    plate: Plate,
    plates: tuple[FurtherPlate, ...],
    patterns: tuple[AnyPattern, ...],
    moves: tuple[Move, ...],
    cases: tuple[LoadCase, ...],
) -> Iterator[RelativeIssue]:
    """Find patterns without a unique name, moves of unknown patterns and cases, places off the plate."""
    yield from check_names("patterns", [pattern.name for pattern in patterns], needed=True)
    yield from check_case_names("moves", "case", [move.case for move in moves], cases)
    by_name, covered = {pattern.name: pattern for pattern in patterns}, PlateRegion(plate, plates)
    for number, move in enumerate(moves):
        if move.pattern not in by_name:
            expected = one_of(list(by_name)) if by_name else "a pattern, and [[patterns]] that says what it is"
            place, hint = ("moves", number, "pattern"), suggestion(move.pattern, list(by_name))
            repairs = use_nearest(place, move.pattern, by_name)
            yield RelativeIssue(place, describe(move.pattern), expected, hint, repairs)
            continue
        if move.travels and not cases:
            yield RelativeIssue(("moves", number, "case"), "a path without a case", "[[cases]], one of which moves")
        if _too_many(move) or _count_forces(by_name[move.pattern], move) > MOST_FORCES:
            continue
        yield from _check_places(covered, by_name[move.pattern], move, number)
    paths = [(move.case, move.name) for move in moves if move.travels]
    for number, move in enumerate(moves):
        if move.travels and paths.count((move.case, move.name)) > 1:
            same_paths = f"several paths of {describe(move.case)}"
            yield RelativeIssue(("moves", number, "name"), same_paths, "a unique name for each")


def _check_places(covered: PlateRegion, pattern: AnyPattern, move: Move, number: int) -> Iterator[RelativeIssue]:
    """Find a fixed place with a force off the plate, and positions on a path with none on it."""
    for station in stations(move):
        loads = point_loads(pattern, station, move.case)
        standing = loads_on_plate(covered, loads)
        if not standing or (not move.travels and len(standing) < len(loads)):
            where = f"at {station.distance:.2f} m of the path" if move.travels else "at its place"
            off_plate = f"{len(loads) - len(standing)} of {len(loads)} forces off the plate {where}"
            expected = "some on it, with their footprints" if move.travels else "all on it, with their footprints"
            yield RelativeIssue(("moves", number, "points"), off_plate, expected)
            return


def _count_forces(pattern: AnyPattern, move: Move) -> int:
    """Return how many forces a pattern has at all places of a move."""
    forces = len(pattern.wheels) if isinstance(pattern, Vehicle) else pattern.frames * len(pattern.rows)
    return forces * len(stations(move))


def _too_many(move: Move) -> bool:
    """Return whether a path has more positions than combinations can have."""
    if not move.travels or move.step is None:
        return False
    return sum(math.dist(a, b) for a, b in pairwise(move.points)) / move.step > MOST_COMBINATIONS


def check_positions(
    patterns: tuple[AnyPattern, ...],
    moves: tuple[Move, ...],
    cases: tuple[LoadCase, ...],
    combinations: tuple[Combination, ...],
    combine: Combine | None,
) -> Iterator[RelativeIssue]:
    """Find more than MOST_COMBINATIONS combinations at all positions, and more than MOST_FORCES forces."""
    by_name = {pattern.name: pattern for pattern in patterns}
    sound = [move for move in moves if move.pattern in by_name and not _too_many(move)]
    total = sum(_count_forces(by_name[move.pattern], move) for move in sound)
    if total > MOST_FORCES:
        expected = f"at most {MOST_FORCES:,} forces at all positions"
        yield RelativeIssue(("moves",), f"{total:,} forces at all positions", expected)
    travelling = [move for move in moves if move.travels]
    if not travelling or not cases:
        return
    expected = f"at most {MOST_COMBINATIONS} combinations at all positions"
    hint = "a larger step, a shorter path, or fewer combinations"
    if any(map(_too_many, travelling)):
        yield RelativeIssue(("moves",), "a path with more positions than that", expected, hint)
        return
    counts = {case: len(names) for case, names in position_names(moves).items()}
    total = _count(_listed(cases, combinations, combine), counts)
    if total > MOST_COMBINATIONS:
        yield RelativeIssue(("moves",), f"{total:,} combinations at all positions", expected, hint)


def _listed(
    cases: tuple[LoadCase, ...], combinations: tuple[Combination, ...], combine: Combine | None
) -> list[tuple[tuple[str, float], ...]]:
    """Return the factors of all combinations before positions; of automatic ones that cannot be made, none."""
    if not combinations and combine is None:
        return [((case.name, 1.0),) for case in cases]
    generated: tuple[Combination, ...] = ()
    if combine is not None:
        try:
            generated = make_combinations(combine, cases)
        except InputError:  # which its own check tells
            generated = ()
    return [combination.factors for combination in (*combinations, *generated)]


def _count(factors: list[tuple[tuple[str, float], ...]], positions: Mapping[str, int]) -> int:
    """Return how many combinations there are at all positions."""
    return sum(math.prod(positions.get(name, 1) for name, factor in pairs if factor) for pairs in factors)
