"""The building above: a frame on columns and walls, or its stiffness between them as another program condensed it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

import numpy as np

from groundslab.geometry.plan import Place
from groundslab.model.ground import POISSON, POSITIVE, AnyGround, ContinuousGround
from groundslab.model.plate import Plate
from groundslab.model.plates.other_plates import AnyPlate, FurtherPlate, list_plates
from groundslab.model.structure.beams import STIFFNESS
from groundslab.model.structure.columns import Column
from groundslab.model.structure.frame_members import MemberSection
from groundslab.model.structure.walls import Wall, place_walls
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Boolean, Choice, Integer, ListOf, Number, Quantity, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.repairs import remove, use_nearest
from groundslab.schema.section_fields import ByKind, Table
from groundslab.schema.wording import describe, one_of, quote, suggestion

if TYPE_CHECKING:
    from shapely import Polygon

    from groundslab.arrays import Array


#: A matrix is symmetric, and takes no forces when all that it stands on moves as a whole, but for this share of it:
#: the digits of a printed one.
DIGITS = 1e-3
#: Bases stand in a row if they are off it by less than this share of its length.
IN_A_ROW = 1e-6
#: Arcs of footprints as chords so far off [m] do where only their middles count.
ROUGH = 1e-3
#: More storeys and members than these are a slip of the pen.
MOST_STOREYS, MOST_BASES = 200, 300

ForceUnit = Literal["N", "kN", "MN"]
NEWTONS: dict[ForceUnit, float] = {"N": 1.0, "kN": 1e3, "MN": 1e6}


STOREYS = ListOf(Integer("", at_most=MOST_STOREYS), "", "storeys, counted from 1 upwards; by default all", unique=True)
NAMES = Text("")


class BuildingColumns(Section):
    """Columns of the frame whose section differs from what stands on the plate."""

    names: Annotated[tuple[str, ...], ListOf(NAMES, "", "columns that have it", unique=True)]
    storeys: Annotated[tuple[int, ...] | None, STOREYS] = None
    section: Annotated[MemberSection, ByKind(), Table("the section")]


class BuildingBeams(Section):
    """Beams of the frame from column to column, on top of storeys."""

    through: Annotated[
        tuple[str, ...], ListOf(NAMES, "", "columns and walls that they join, from each to the next one", least=2)
    ]
    storeys: Annotated[tuple[int, ...] | None, STOREYS] = None
    section: Annotated[MemberSection, ByKind(), Table("the section")]


def _check_file(file: str, matrix: tuple[tuple[float, ...], ...]) -> Iterator[RelativeIssue]:
    """Find a file that was not read, as reading puts nodes and matrix in its place."""
    if file:
        hint = "only a case that is read from a folder can name a file there"
        hint = "the matrix is given already" if matrix else hint
        yield RelativeIssue(("file",), quote(file), "nodes and matrix in the case itself", hint, (remove(("file",)),))


def _check_kind(
    storeys: tuple[float, ...],
    beams: tuple[BuildingBeams, ...],
    E: float | None,
    nodes: tuple[str, ...],
    file: str,
    given: set[str],
) -> Iterator[RelativeIssue]:
    """Find a building that is given as a frame and as a matrix, or as neither."""
    of_frame: tuple[str, ...] = ("storeys", "E", "nu", "rigid_floors", "columns", "beams")
    frame = [key for key in of_frame if key in given]
    if nodes or file or "matrix" in given:
        for key in frame:
            key_with_matrix, hint = f"{key} together with a matrix", "the matrix is all of the building's stiffness"
            yield RelativeIssue((key,), key_with_matrix, "a frame or a matrix", hint, (remove((key,)),))
        return
    if "unit" in given:
        yield RelativeIssue(("unit",), "unit without a matrix", "nodes and their matrix")
    words = {"storeys": "heights of the frame's storeys", "E": "Young's modulus of the frame",
             "beams": "beams that join columns"}  # fmt: skip
    needed: dict[str, object] = {"storeys": storeys, "E": E, "beams": beams}
    for key, value in needed.items():
        if not value:
            hint = "" if frame else "or nodes, matrix and unit, as another program has condensed them"
            yield RelativeIssue((key,), "nothing", words[key], hint)


def _check_storeys(
    storeys: tuple[float, ...], columns: tuple[BuildingColumns, ...], beams: tuple[BuildingBeams, ...]
) -> Iterator[RelativeIssue]:
    """Find storeys that are not there, and beams that start where they end."""
    members: list[tuple[str, int, BuildingColumns | BuildingBeams]] = []
    members += [("columns", number, group) for number, group in enumerate(columns)]
    members += [("beams", number, group) for number, group in enumerate(beams)]
    for key, number, member in members:
        for position, storey in enumerate(member.storeys or ()):
            if storey > len(storeys) > 0:
                yield RelativeIssue((key, number, "storeys", position), f"{storey}", f"at most {len(storeys)}")
    joined = {name for beam in beams for name in beam.through}
    columns_between = set[tuple[str, int]]()
    for number, of_building in enumerate(columns):
        for position, name in enumerate(of_building.names):
            place = ("columns", number, "names", position)
            both = {(name, storey) for storey in of_building.storeys or range(1, len(storeys) + 1)}
            if beams and name not in joined:
                yield RelativeIssue(place, f"{quote(name)}, which no beam joins", "a column of the frame")
            elif both & columns_between:
                yield RelativeIssue(place, f"{quote(name)} with a second section", "one section in each storey")
            columns_between |= both
    for number, beam in enumerate(beams):
        for position, (lower, other) in enumerate(pairwise(beam.through)):
            if lower == other:
                place = ("beams", number, "through", position + 1)
                yield RelativeIssue(place, f"{quote(lower)} twice", "the column at the other end")


def _check_matrix(
    nodes: tuple[str, ...], matrix: tuple[tuple[float, ...], ...], unit: str | None
) -> Iterator[RelativeIssue]:
    """Find a matrix that does not fit its nodes, or is not symmetric or not positive."""
    if not (nodes or matrix):
        return
    words = {"nodes": "the columns and walls that its rows belong to", "matrix": "its rows", "unit": one_of([*NEWTONS])}
    needed: dict[str, object] = {"nodes": nodes, "matrix": matrix, "unit": unit}
    for key, value in needed.items():
        if not value:
            yield RelativeIssue((key,), "nothing", words[key])
    if not nodes or not matrix:
        return
    n, rows = len(nodes), len(matrix)
    if rows not in (n, 3 * n):
        expected = f"{n} rows for settlements alone, or {3 * n} for settlement and two slopes of each of {n} nodes"
        yield RelativeIssue(("matrix",), f"{rows} rows", expected)
        return
    for number, row in enumerate(matrix):
        if len(row) != rows:
            yield RelativeIssue(("matrix", number), f"{len(row)} numbers", f"{rows}, as there are rows")
            return
    K = np.array(matrix)
    largest = np.abs(K).max()
    if largest == 0:
        yield RelativeIssue(("matrix",), "zeros alone", "stiffnesses")
        return
    off = np.abs(K - K.T)
    if off.max() > DIGITS * largest:
        i, j = divmod(int(off.argmax()), rows)
        pair = f"{matrix[i][j]!r} in row {i + 1}, column {j + 1}, and {matrix[j][i]!r} in row {j + 1}, column {i + 1}"
        yield RelativeIssue(("matrix", i, j), pair, "a symmetric matrix", "what A does to B, B does to A")
        return
    # forces and moments alike: each by the largest that resists a motion of its kind
    kind = np.tile(np.minimum(np.arange(rows // n), 1), n)
    sizes = np.array([np.abs(K[np.ix_(kind == which, kind == which)]).max(initial=0.0) or largest for which in (0, 1)])
    scale = np.sqrt(sizes)[kind]
    least = float(np.linalg.eigvalsh((K + K.T) / 2 / np.outer(scale, scale))[0])
    if least < -DIGITS:
        gain = f"a matrix that is not positive: some motion gains {-least:.3g} of the largest resistance of its kind"
        hint = "are forces downwards positive like settlements, and moments like slopes?"
        yield RelativeIssue(("matrix",), gain, "a matrix that resists every motion or lets it be", hint)


class Building(Section):
    """The stiffness of the building above, which joins the settlements of columns and walls.

    Loads are the forces of the building on a base that does not move. What the slab's settlements change of them
    follows from the stiffness.
    """

    constraints: ClassVar[tuple[Check, ...]] = (_check_file, _check_kind, _check_storeys, _check_matrix)

    storeys: Annotated[
        tuple[float, ...], ListOf(Quantity("length", "h", "", POSITIVE, example="3 m"), "h",
                                  "heights of the storeys, from the lowest one upwards", most=MOST_STOREYS),
    ] = ()  # fmt: skip
    E: Annotated[
        float | None, Quantity("pressure", "E", "Young's modulus of the frame", POSITIVE, example="30 GPa")
    ] = None
    nu: Annotated[float, Number("nu", "Poisson's ratio of the frame", POISSON)] = 0.2
    stiffness: Annotated[float, STIFFNESS] = 1.0
    rigid_floors: Annotated[
        bool, Boolean("whether floors hold their columns and walls together, as plates that are rigid in their planes")
    ] = True
    columns: Annotated[
        tuple[BuildingColumns, ...],
        Table("columns whose section in the frame is another than their footprint on the plate"),
    ] = ()
    beams: Annotated[tuple[BuildingBeams, ...], Table("beams of the frame")] = ()
    nodes: Annotated[
        tuple[str, ...],
        ListOf(NAMES, "", "columns and walls between which a matrix is given", most=MOST_BASES, unique=True, least=0),
    ] = ()
    matrix: Annotated[
        tuple[tuple[float, ...], ...],
        ListOf(
            ListOf(Number("", ""), "", "", most=3 * MOST_BASES),
            "K",
            "stiffness between them: rows of settlements alone, or of settlement, slope along x and slope along y of "
            "each node in turn",
            most=3 * MOST_BASES,
            least=0,
        ),
    ] = ()
    file: Annotated[
        str,
        Text("CSV file beside the case that nodes and matrix are read from: names in its first line, then the rows"),
    ] = ""
    unit: Annotated[ForceUnit | None, Choice(ForceUnit, "unit of forces in the matrix, with lengths in m", "")] = None

    @property
    def names(self) -> tuple[str, ...]:
        """Return the columns and walls that it joins, in their order."""
        return self.nodes or tuple(dict.fromkeys(name for beam in self.beams for name in beam.through))

    @property
    def K(self) -> Array:
        """Return the given matrix times its share of stiffness, in N and m, exactly symmetric."""
        assert self.unit is not None
        K = self.stiffness * NEWTONS[self.unit] * np.array(self.matrix)
        mean: Array = (K + K.T) / 2
        return mean


@dataclass(frozen=True, slots=True)
class Base:
    """Where a building stands on the plate: the middle of a column or a wall, and what lies under it."""

    name: str
    place: Place
    footprint: Polygon
    column: Column | None = None
    wall: Wall | None = None

    def arm(self, way: Array) -> Array:
        """Return the way (2,) from the middle to where a beam starts that goes on by a way (2,) from the middle.

        On a wall that is the place of its axis that is nearest to where it goes.
        """
        if self.wall is None:
            return np.zeros(2)
        edge = self.wall.edges[0]
        half = np.subtract(edge.end, edge.start) / 2
        offset: Array = np.clip(half @ way / (half @ half), -1.0, 1.0) * half
        return offset


def bases(
    building: Building, columns: Sequence[Column], walls: Sequence[Wall], plates: Sequence[AnyPlate], chord: float
) -> tuple[Base, ...]:
    """Return where a building stands, arcs of footprints as chords at most so far off [m]."""
    by_name = {column.name: column for column in columns}
    standing = {
        wall.name: wall for wall in place_walls([wall for wall in walls if wall.name in building.names], plates)
    }
    supports = []
    for name in building.names:
        if name in by_name:
            column = by_name[name]
            supports.append(Base(name, (column.x, column.y), column.ring().polygon(chord), column=column))
        elif name in standing:
            area = standing[name].area(chord)
            supports.append(Base(name, (area.centroid.x, area.centroid.y), area, wall=standing[name]))
    return tuple(supports)


def check_building(
    building: Building | None,
    columns: tuple[Column, ...],
    walls: tuple[Wall, ...],
    plate: Plate,
    plates: tuple[FurtherPlate, ...],
    ground: AnyGround,
    floor: object,
) -> Iterator[RelativeIssue]:
    """Find what a building names that is not there, or cannot be a part of it, and a matrix that holds to nothing."""
    if building is None:
        return
    if floor is not None:
        hint = "checks of a floor know its loads as they are given"
        yield RelativeIssue(("building",), "a building on an industrial floor", "no floor, or no building", hint)
    if plates and isinstance(ground, ContinuousGround):
        several_plates, hint = (
            f"a building on several plates on {quote(ground.kind)} ground",
            "Winkler, Pasternak, Vlasov and layered ground take several",
        )
        yield RelativeIssue(("building",), several_plates, "one plate", hint)
    every_plate = list_plates(plate, plates)
    unfit = [*_check_names(building, columns, place_walls(walls, every_plate))]
    yield from unfit
    if not unfit:
        every = bases(building, columns, walls, every_plate, ROUGH)
        yield from _check_balance(building, every) if building.matrix else _check_beams(building, every)


def _check_names(building: Building, columns: tuple[Column, ...], walls: tuple[Wall, ...]) -> Iterator[RelativeIssue]:
    """Find names of no column and no wall, of two, and of walls, with their axes, that cannot be members of a frame."""
    if len(building.names) > MOST_BASES:
        too_many = f"beams through {len(building.names)} columns and walls"
        yield RelativeIssue(("building", "beams"), too_many, f"at most {MOST_BASES}")
        return
    of_columns, of_walls = [column.name for column in columns], {wall.name: wall for wall in walls}
    every = [*of_columns, *of_walls]
    named: list[tuple[tuple[str | int, ...], str, list[str]]] = []
    named += [(("nodes", position), name, every) for position, name in enumerate(building.nodes)]
    named += [(("beams", number, "through", position), name, every)
              for number, beam in enumerate(building.beams) for position, name in enumerate(beam.through)]  # fmt: skip
    named += [(("columns", number, "names", position), name, of_columns)
              for number, kind in enumerate(building.columns) for position, name in enumerate(kind.names)]  # fmt: skip
    for place, name, known_names in named:
        where = ("building", *place)
        if name not in known_names:
            expected = one_of(known_names) if known_names else "a column or wall of the case"
            yield RelativeIssue(
                where, describe(name), expected, suggestion(name, known_names), use_nearest(where, name, known_names)
            )
        elif name in of_columns and name in of_walls:
            yield RelativeIssue(where, f"{quote(name)}, a column and a wall", "a name that only one of them has")
        elif name in of_walls and of_walls[name].doors:
            expected, hint = "a wall without doors", "its parts between doors are walls by themselves"
            yield RelativeIssue(where, f"wall {quote(name)}, which has openings", expected, hint)
        elif name in of_walls and not building.nodes and (reason := _why_no_member(of_walls[name])):
            yield RelativeIssue(where, f"wall {quote(name)}, {reason[0]}", reason[1])


def _why_no_member(wall: Wall) -> tuple[str, str] | None:
    """Return why a wall, with its axis, cannot be a member of a frame, and what could be."""
    if wall.height is not None:
        return "which has a height", "a wall without a height, as its stiffness would count twice"
    if len(wall.edges) > 1 or not wall.edges[0].straight:
        return "which bends", "a straight wall; the parts of others are walls by themselves"
    return None


def _storeys(building: Building, member: BuildingColumns | BuildingBeams) -> tuple[int, ...]:
    """Return the storeys of a member."""
    return member.storeys or tuple(range(1, len(building.storeys) + 1))


def _check_beams(building: Building, every: tuple[Base, ...]) -> Iterator[RelativeIssue]:
    """Find beams without a length between what they join."""
    at = {base.name: base for base in every}
    beams_between = set[tuple[frozenset[str], int]]()
    for number, beam in enumerate(building.beams):
        for position, (first, other) in enumerate(pairwise(beam.through)):
            if first not in at or other not in at:
                continue
            place = ("building", "beams", number, "through", position + 1)
            between = {(frozenset((first, other)), storey) for storey in _storeys(building, beam)}
            if between & beams_between:
                second_beam = f"a second beam between {quote(first)} and {quote(other)}"
                yield RelativeIssue(place, second_beam, "one beam on each storey", "one section may stand for both")
            beams_between |= between
            way = np.subtract(at[other].place, at[first].place)
            free = way + at[other].arm(-way) - at[first].arm(way) if way.any() else way
            if not free @ way > 0:
                no_length = f"no length from {quote(first)} to {quote(other)}"
                hint = "one of them stands where the other one does"
                yield RelativeIssue(place, no_length, "a beam", hint)


def _check_balance(building: Building, every: tuple[Base, ...]) -> Iterator[RelativeIssue]:
    """Find a matrix that resists a motion of everything it stands on together: that would be held by something else."""
    if len(every) < len(building.nodes):
        return
    K, motions = building.K, motions_of(every, len(building.matrix) // len(building.nodes))
    words = ("settling as a whole", "tilting along x", "tilting along y")
    for way, motion in zip(words, motions.T, strict=True):
        if np.abs(motion).max() <= IN_A_ROW * np.abs(motions).max():
            continue  # bases in a row that only settle are not moved by a tilt across it
        size = np.abs(K) @ np.abs(motion)
        if (off := np.abs(K @ motion)).max() > DIGITS * size.max():
            resists = f"a matrix that resists {way}, with {off.max() / size.max():.3g} of what parts of it resist"
            hint = "bases must be free to turn, or their slopes be in the matrix; nothing but the slab may hold it"
            yield RelativeIssue(("building", "matrix"), resists, "one that no motion of all its nodes together strains",
                                hint)  # fmt: skip
            return


def motions_of(every: Sequence[Base], unknowns: int) -> Array:
    """Return what settling as a whole and tilting along x and along y do to bases, (unknowns bases, 3).

    Of each base settlement and both slopes, or the settlement alone. Tilts are about the middle of all bases.
    """
    places = np.array([base.place for base in every])
    x, y = (places - places.mean(axis=0)).T
    of_bases = np.zeros((len(every), 3, 3))
    of_bases[:, 0] = np.column_stack([np.ones_like(x), x, y])
    of_bases[:, 1, 1] = of_bases[:, 2, 2] = 1.0
    motions: Array = of_bases[:, :unknowns].reshape(-1, 3)
    return motions


def frame_lines(building: Building | None, bases: Sequence[Base]) -> tuple[tuple[Place, ...], ...]:
    """Return the places [m] that each of the building's beams runs through in plan, from base to base.

    A beam begins on a wall where a frame has it.
    """
    by_name = {base.name: base for base in bases}
    lines = []
    for beams in building.beams if building else ():
        line: list[Place] = []
        for first, other in pairwise(by_name[name] for name in beams.through):
            way = np.subtract(other.place, first.place)
            ends = (first.place + first.arm(way), other.place + other.arm(-way))
            line += [(float(x), float(y)) for x, y in ends]
        lines.append(tuple(dict.fromkeys(line)))
    return tuple(lines)
