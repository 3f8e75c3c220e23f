"""The pieces of a perimeter in a table: what each adds to the length, the center and the moduli of a calculation."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Set
from operator import attrgetter
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from groundslab.design.codes.en1992_2004.checks.punching_demand import OUTERMOST
from groundslab.design.rules.calculation import MEGA
from groundslab.design.rules.wall_ends import COUNTED
from groundslab.messages import Message
from groundslab.units import format_number
from groundslab.views.report.table_layout import Cell, TableHeader, TableLayout

if TYPE_CHECKING:
    from groundslab.arrays import Array
    from groundslab.design.demands.perimeter_pieces import Piece
    from groundslab.design.demands.perimeters import SketchedPerimeter

#: Titles of the tables of other perimeters, by what is told apart of them.
TITLES = {"": "", OUTERMOST: "Pieces of the outermost perimeter", COUNTED: "Pieces that count"}
#: Places are written to a tenth of a millimeter.
_PLACE = ".4f"
#: What the length that counts is called.
LENGTHS = ("u", "b_05", "b_o")
#: Sums below this share of their largest part are rounding.
_NOTHING = 1e-9


class _Column(NamedTuple):
    """A column: its head, what a piece has in it, and what all of them have."""

    head: TableHeader
    of: Callable[[Piece], str]
    all_of: Callable[[list[Piece]], str] = lambda _: ""


def tables_of_pieces(sketch: SketchedPerimeter, symbols: Set[str]) -> Iterator[TableLayout]:
    """Yield the table of the pieces of a perimeter, and of others that its sheet calls upon, by the sheet's symbols."""
    for ends, perimeter in (("", sketch), *sketch.further):
        columns = [*_columns(perimeter.pieces, symbols, ends)]
        if ends and not any(column.head.symbol for column in columns):
            continue  # the sheet has none of its sums
        yield _table(columns, perimeter.pieces, TITLES[ends])


def _table(columns: list[_Column], pieces: list[Piece], title: str) -> TableLayout:
    """Return the table of pieces, with what they are together in the last row if there are several."""
    number = TableHeader("piece", number=True)
    rows = [
        (Cell(str(n), "number"), *(Cell(column.of(piece), "number") for column in columns))
        for n, piece in enumerate(pieces, 1)
    ]
    rows.append((Cell("all"), *(Cell(column.all_of(pieces), "number") for column in columns)))
    return TableLayout(title, (number, *(column.head for column in columns)), tuple(rows))


def _columns(pieces: list[Piece], symbols: Set[str], ends: str) -> Iterator[_Column]:
    """Yield the columns: how each piece runs, how long it is, and what it adds to the sums that a sheet has."""
    if any(piece.radius is not None for piece in pieces):
        yield _Column(TableHeader("radius", "m", number=True), _radius)
    for words, at in (("from, along {n}", attrgetter("start")), ("to, along {n}", attrgetter("end"))):
        for n in (1, 2):
            yield _Column(TableHeader(Message(words, n=n), "m", number=True), _place(at, n - 1))
    if any(piece.share < 1 for piece in pieces):
        yield _Column(TableHeader("share that counts", number=True), lambda piece: format_number(piece.share))
    across = pieces[0].shear is not None
    length = next((name for name in _lengths(ends, across=across) if name in symbols), "")
    yield _sum(TableHeader("length", "m", number=True, symbol=length), lambda piece: piece.length)
    if across:
        force = next((name for name in ("V_Ed", "V_u") if name in symbols), "")
        yield _sum(TableHeader("part of", "MN", number=True, symbol=force), lambda piece: (piece.shear or 0.0) / MEGA)
    for n in (1, 2):
        if symbols & {f"{letter}_{n}{ends}" for letter in "exI"}:
            yield _center(n - 1)
    for letter, unit, part in (("W", "m2", _modulus), ("I", "m3", _second), ("l", "m", _along)):
        for n in (1, 2):
            if f"{letter}_{n}{ends}" in symbols and (letter != "l" or f"I_{n}{ends}" in symbols):
                head = TableHeader("part of", unit, number=True, symbol=f"{letter}_{n}")
                yield _sum(head, part(n - 1))
    if f"I_12{ends}" in symbols:
        for letter, unit, mixed in (
            ("I", "m3", lambda piece: float(piece.second[0, 1])),
            ("l", "m", lambda piece: float(piece.along[0, 1])),
        ):
            yield _sum(TableHeader("part of", unit, number=True, symbol=f"{letter}_12"), mixed)


def _lengths(ends: str, *, across: bool) -> tuple[str, ...]:
    """Return what the length may be called, that of all across which the slab's shear force is known before others."""
    if ends == OUTERMOST:
        return (f"u_{ends[1:]}",)
    return ("u_w", "b_w", *LENGTHS) if across else LENGTHS


def _sum(head: TableHeader, of: Callable[[Piece], float]) -> _Column:
    """Return a column whose parts add up."""

    def total(pieces: list[Piece]) -> str:
        parts = [of(piece) for piece in pieces]
        return _number(sum(parts), max(map(abs, parts)))

    return _Column(head, lambda piece: _number(of(piece), abs(of(piece))), total)


def _number(value: float, largest: float) -> str:
    """Return a number, or 0 where it is rounding of the largest one."""
    return format_number(value, fixed=(1e-4, 1e7)) if abs(value) > _NOTHING * largest else "0"


def _radius(piece: Piece) -> str:
    """Return the radius of an arc, nothing of a straight piece, and a word of a curve that has none."""
    if piece.radius is None:
        return ""
    return "curve" if np.isnan(piece.radius) else f"{piece.radius:{_PLACE}}"


def _place(at: Callable[[Piece], Array], axis: int) -> Callable[[Piece], str]:
    """Return what writes the place of a piece along an axis."""
    return lambda piece: _written(float(at(piece)[axis]))


def _written(place: float) -> str:
    """Return a place, of which rounding is no part."""
    return f"{round(place, 4) + 0.0:{_PLACE}}"


def _center(axis: int) -> _Column:
    """Return the column of centers along an axis."""

    def center(pieces: list[Piece]) -> str:
        lengths = np.array([piece.length for piece in pieces])
        return _written(float(lengths @ [piece.middle[axis] for piece in pieces] / lengths.sum()))

    head = TableHeader(Message("center, along {n}", n=axis + 1), "m", number=True)
    return _Column(head, lambda piece: _written(float(piece.middle[axis])), center)


def _modulus(axis: int) -> Callable[[Piece], float]:
    """Return what reads the modulus of a piece for moments along an axis."""
    return lambda piece: float(piece.moduli[axis])


def _second(axis: int) -> Callable[[Piece], float]:
    """Return what reads the second moment of a piece along an axis."""
    return lambda piece: float(piece.second[axis, axis])


def _along(axis: int) -> Callable[[Piece], float]:
    """Return what reads the integral of the square of a piece's cosine."""
    return lambda piece: float(piece.along[axis, axis])
