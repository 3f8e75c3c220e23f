"""Reactions as forces and moments on columns and walls, with the signs of groundslab, and as loads."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal

from groundslab import units
from groundslab.case.numbers import format_number
from groundslab.exchange.reactions.matching import CHORD, Frame, Matched
from groundslab.exchange.reactions.table import ZERO, Reaction, ReactionTable
from groundslab.geometry.plan import Place
from groundslab.model.loads.lines import LineLoad, LineMoment
from groundslab.model.loads.load_types import PointLoad
from groundslab.model.model import Model
from groundslab.model.reactions import Reactions
from groundslab.model.structure.walls import Wall
from groundslab.schema.wording import listed

#: Kind of load, column or wall, and load case: of each there is one imported load.
Key = tuple[str, str, str]
#: Digits of loads along walls, which are computed.
DIGITS = 12
#: Moments on walls below this share of force times length are rounding.
ROUNDING = 1e-9


@dataclass(frozen=True, slots=True)
class Force:
    """Force and moments of a support: numbers of the table's units, or [N], [N m]; signs of groundslab."""

    P: Decimal
    M_x: Decimal
    M_y: Decimal


def to_force(reaction: Reaction, reading: Reactions) -> Force:
    """Return the force and the moments on the slab that a reaction stands for, in the table's units.

    In right-handed axes x, y, z a force F_z at (x, y) has the moments M_x = y F_z about x and M_y = -x F_z about y.
    If a positive F_z presses, P = F_z, and its moments here are M_x = sum P x, which is -M_y of the table, and
    M_y = sum P y, which is M_x of the table. If it lifts, all three change their signs. So it does not matter whether
    z points up or down, or whether a table states what acts on the structure or on the slab.
    """
    sign = 1 if reading.positive == "presses" else -1
    P = sign * reaction.F_z
    if reading.moments == "as here":
        M_x, M_y = reaction.M_x, reaction.M_y
    else:
        turn = sign if reading.moments == "about axes" else -sign
        M_x, M_y = -turn * reaction.M_y, turn * reaction.M_x
    return Force(P + ZERO, M_x + ZERO, (-M_y if reading.mirrored else M_y) + ZERO)


def signs_in_words(reading: Reactions) -> str:
    """Return what the signs of a table mean, such as "P = F_z, M_x = -M_y of the table, M_y = M_x of the table"."""
    example = Reaction(0, "", "", None, Decimal(1), Decimal(2), Decimal(3))
    force = to_force(example, reading)
    words = {Decimal(1): "F_z", Decimal(2): "M_x of the table", Decimal(3): "M_y of the table"}
    values = {"P": force.P, "M_x": force.M_x, "M_y": force.M_y}
    return ", ".join(f"{name} = {'-' * (value < 0)}{words[abs(value)]}" for name, value in values.items())


@dataclass(frozen=True, slots=True)
class _Axis:
    """The straight axis of a wall: its middle [m], its direction, its length [m]."""

    middle: Place
    direction: Place
    length: float

    def along(self, force: Force) -> float:
        """Return the moment that presses the wall's end down."""
        return float(force.M_x) * self.direction[0] + float(force.M_y) * self.direction[1]

    def across(self, force: Force) -> float:
        """Return the moment that presses the side to the left of the wall down."""
        return float(force.M_y) * self.direction[0] - float(force.M_x) * self.direction[1]

    def way(self, place: Place) -> float:
        """Return how far along the wall from its middle a place is [m]."""
        dx, dy = place[0] - self.middle[0], place[1] - self.middle[1]
        return dx * self.direction[0] + dy * self.direction[1]


def _straight(wall: Wall) -> _Axis | None:
    """Return the axis of a straight wall, None of others."""
    if wall.curved or wall.shape is not None or len(wall.line) != 2:
        return None
    (x0, y0), (x1, y1) = wall.line
    length = math.hypot(x1 - x0, y1 - y0)
    return _Axis(((x0 + x1) / 2, (y0 + y1) / 2), ((x1 - x0) / length, (y1 - y0) / length), length)


@dataclass(frozen=True, slots=True)
class Transfer:
    """Reactions that are taken, and what they stand for: supports matched, load cases by their names in the table."""

    reactions: Sequence[Reaction]
    matched: Matched
    cases: Mapping[str, str]
    table: ReactionTable
    frame: Frame
    reading: Reactions


def make_loads(transfer: Transfer, model: Model) -> tuple[dict[Key, dict[str, str]], list[str]]:
    """Return loads as tables of a case, and remarks on what they leave out.

    Several supports of one column or wall are added up. On a straight wall the force is distributed linearly, so that
    its moment about the middle is that of the supports; a column takes forces where it stands.

    Parameters
    ----------
    transfer : Transfer
        The reactions, with the table's units and signs.
    model : Model
        The case with its walls.
    """
    walls = {wall.name: wall for wall in model.placed_walls}
    groups: dict[tuple[str, str], list[Reaction]] = defaultdict(list)
    for reaction in transfer.reactions:
        groups[transfer.matched.on[reaction.support], transfer.cases[reaction.case]].append(reaction)
    loads: dict[Key, dict[str, str]] = {}
    bent = dict[str, None]()
    for (name, case), group in groups.items():
        forces = [to_force(reaction, transfer.reading) for reaction in group]
        source = ", ".join(dict.fromkeys(reaction.support for reaction in group))
        if name in walls:
            tables = dict(_line(forces, group, walls[name], transfer))
            if _straight(walls[name]) is None and any(force.M_x or force.M_y for force in forces):
                bent[name] = None
        else:
            tables = dict(_point(name, forces, transfer.table))
        for kind, values in tables.items():
            loads[kind, name, case] = {"kind": kind, "case": case, **values, "source": source}
    remarks = [f"moments on walls that are not straight are left out: {listed(bent, 'and')}"] if bent else []
    return loads, remarks


def _point(name: str, forces: Iterable[Force], table: ReactionTable) -> Iterator[tuple[str, dict[str, str]]]:
    """Yield force and moments of a load on a column, unless all are 0."""
    totals = [sum(column, ZERO) for column in zip(*((force.P, force.M_x, force.M_y) for force in forces), strict=True)]
    if any(totals):
        moments = dict(zip(("M_x", "M_y"), totals[1:], strict=True))
        values = {key: f"{format_number(moment)} {table.moment}" for key, moment in moments.items() if moment}
        yield "point", {"column": name, "P": f"{format_number(totals[0])} {table.force}", **values}


def _line(
    forces: Sequence[Force], group: Sequence[Reaction], wall: Wall, transfer: Transfer
) -> Iterator[tuple[str, dict[str, str]]]:
    """Yield the force per length of a load on a wall, and the moment per length."""
    table, axis, L = transfer.table, _straight(wall), wall.length
    size = units.parse(f"1 {table.force}", "force")
    turning = units.parse(f"1 {table.moment}", "moment") if table.moment else 0.0
    P = size * float(sum((force.P for force in forces), ZERO))
    along = across = 0.0
    if axis is not None:
        along = turning * sum(map(axis.along, forces))
        across = turning * sum(map(axis.across, forces))
        elsewhere = {moved.support for moved in transfer.matched.moved}
        for force, reaction in zip(forces, group, strict=True):
            place = transfer.frame.place(reaction)
            if place is not None and reaction.support not in elsewhere:
                along += size * float(force.P) * axis.way(place)
    # q = P / L + 12 M s / L^3, with s from the middle, has the force P and the moment M
    start, end = _per_length((P / L - 6 * along / L**2, P / L + 6 * along / L**2), table, "force")
    if abs(along) > ROUNDING * abs(P) * L:
        yield "line", {"wall": wall.name, "q": start, "q_end": end}
    elif P:
        yield "line", {"wall": wall.name, "q": start}
    if abs(across) > ROUNDING * abs(P) * L:
        yield "line moment", {"wall": wall.name, "m": _per_length((across / L,), table, "moment")[0]}


def _per_length(values: Iterable[float], table: ReactionTable, dimension: str) -> list[str]:
    """Return forces [N/m] or moments [N m/m] per length in the table's units."""
    length = table.per or table.length or ("ft" if table.force in ("kip", "lbf") else "m")
    unit = f"{table.force}/{length}" if dimension == "force" else f"{table.moment}/{length}"
    size = units.parse(f"1 {unit}", f"{dimension} per length")
    return [f"{value / size + 0.0:.{DIGITS}g} {unit}" for value in values]


@dataclass(frozen=True, slots=True)
class Resultant:
    """What was imported onto a column or wall in one load case, about its middle; or the sum of a case.

    Attributes
    ----------
    P : float
        Force, downwards positive [N].
    M_x, M_y : float
        Moments that press the side of larger x, or of larger y, down [N m].
    """

    P: float = 0.0
    M_x: float = 0.0
    M_y: float = 0.0


def _add(resultant: Resultant, P: float, M_x: float, M_y: float) -> Resultant:
    """Return the sum with another force and its moments."""
    return Resultant(resultant.P + P, resultant.M_x + M_x, resultant.M_y + M_y)


def resultants(model: Model) -> dict[tuple[str, str], Resultant]:
    """Return what the imported loads of a model are together, by column or wall, and load case."""
    axes = {wall.name: (_straight(wall), wall.length) for wall in model.placed_walls}
    totals: dict[tuple[str, str], Resultant] = {}
    for load in model.loads:
        if not isinstance(load, PointLoad | LineLoad | LineMoment) or not load.source:
            continue
        name = load.column if isinstance(load, PointLoad) else load.wall
        force = (0.0, 0.0, 0.0)
        if isinstance(load, PointLoad):
            force = (load.P, load.M_x, load.M_y)
        elif name in axes:
            axis, L = axes[name]
            tx, ty = (0.0, 0.0) if axis is None else axis.direction
            if isinstance(load, LineLoad):
                end = load.q if load.q_end is None else load.q_end
                along = (end - load.q) * L**2 / 12
                force = ((load.q + end) / 2 * L, along * tx, along * ty)
            else:
                force = (0.0, -load.m * L * ty, load.m * L * tx)
        key = (name, load.case)
        totals[key] = _add(totals.get(key, Resultant()), *force)
    return totals


def middles(model: Model) -> dict[str, Place]:
    """Return the centers of columns and the middles of walls by name [m]."""
    places = {column.name: (column.x, column.y) for column in model.columns}
    for wall in model.placed_walls:
        middle = wall.to_shapely(CHORD).centroid
        places.setdefault(wall.name, (float(middle.x), float(middle.y)))
    return places
