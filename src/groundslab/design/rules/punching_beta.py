"""How beta is found by which punching is larger than its mean: what the case asks for, and whether constants hold.

Constants are for structures whose lateral stability does not depend on frame action between slab and columns, with
adjacent spans that do not differ by more than a quarter of the longer one (EN 1992-1-1 6.4.3(6), EN 1992-1-1:2023
8.4.2(6)): the first the case states, the second follows from the places of columns or piles.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import atan2, pi

import numpy as np

from groundslab.arrays import Array
from groundslab.design.demands.line_properties import chains
from groundslab.design.demands.perimeter_loads import PunchingForce, punching_columns, punching_piles
from groundslab.design.demands.perimeter_shear import PerimeterShear, perimeter_shear
from groundslab.design.rules.calculation import Step
from groundslab.design.rules.check import DesignCheck, some
from groundslab.messages import Message
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.model import Model
from groundslab.model.structure.beta import Beta
from groundslab.results.plate_result import PlateResult
from groundslab.results.results import Results

#: By how much of the longer one adjacent spans may differ.
ALIKE = 0.25
#: Sectors of a perimeter that runs all around (three or four in each quadrant, DAfStb Heft 600).
SECTORS = 12
#: How many are tried besides, for the calculation.
TRIED = (8, 12, 16, 24)
#: Others are named where they differ from what is taken by more than this share.
DIFFERS = 0.20
#: Where sectors are described.
HEFT = "DAfStb Heft 600"
#: What each way is called.
WAYS = {"code": "by moments", "constant": "constant", "sectors": "by sectors", "given": "given"}


def beta_of(model: Model, steel: Reinforcement, punching: PunchingForce) -> Beta:
    """Return how beta of what punches is found: as the case says; by moments where constants do not hold."""
    asked = steel.beta if punching.at_zone else _asked(model, steel, punching)
    if asked == "constant" and (punching.at_zone or uneven_spans(model, punching)):
        return "code"
    return asked


def beta_in_steps(way: str, beta: float, symbol: str, clause: str) -> Step:
    """Return the step of a beta that does not follow from moments."""
    words, where = {
        "sectors": ("largest mean of a sector over the mean, of 12 of equal angle", HEFT),
        "constant": ("constant factor, braced, spans alike", clause),
    }.get(way, ("factor that the case gives", ""))
    return Step(words, symbol, beta, clause=where)


def other_betas_in_steps(
    way: str, beta: float, others: Mapping[str, float], symbol: str, clause: str
) -> Iterator[Step]:
    """Yield how a beta by sectors depends on their number, and others that differ by more than a share."""
    for name, value in others.items():
        if way == "sectors" and name.startswith("sectors"):
            _, count, *by = name.split()
            words = "factor by sectors of equal length" if by else "factor by sectors of equal angle"
            yield Step(words, f"{symbol}_{'l' if by else 'a'},{count}", value, clause=HEFT)
    named: dict[str, tuple[str, str, float | None]] = {
        "code": ("factor by moments, for comparison", "m", others.get("code")),
        "constant": ("constant factor, for comparison", "c", others.get("constant")),
        "sectors": ("factor by sectors, for comparison", "s", others.get(f"sectors {SECTORS}")),
    }
    for other, (words, letter, factor) in named.items():
        if other != way and factor is not None and abs(factor - beta) > DIFFERS * beta:
            yield Step(words, f"{symbol}_{letter}", factor, clause=clause)


def uneven_spans(model: Model, punching: PunchingForce) -> tuple[float, float] | None:
    """Return two adjacent spans [m] that differ too much, of those along x and along y to the next ones; else None.

    The next ones are of its own kind, within 45 degrees of an axis.
    """
    forces = punching_columns(model) if punching.support is None else punching_piles(model)
    others = np.array([force.place for force in forces if force.name != punching.name]).reshape(-1, 2)
    away = others - punching.place
    for axis in (0, 1):
        along, across = away[:, axis], abs(away[:, 1 - axis])
        spans = []
        for sign in (-1, 1):
            beside = sign * along
            beside = beside[(beside > 0) & (across <= beside)]
            spans += [float(beside.min())] if len(beside) else []
        if len(spans) == 2 and min(spans) < (1 - ALIKE) * max(spans):
            return min(spans), max(spans)
    return None


def check_constants(combined: Results, steel: Reinforcement) -> Iterator[DesignCheck]:
    """Yield that constants were asked for where they do not hold."""
    model = combined.solved_model
    forces = [*punching_columns(model), *punching_piles(model)]
    refused = {
        force.name: spans
        for force in forces
        if _asked(model, steel, force) == "constant" and (spans := uneven_spans(model, force)) is not None
    }
    if refused:
        low, high = next(iter(refused.values()))
        words = Message(
            "constants do not hold at {names}: adjacent spans of {low:.3g (m)} and {high:.3g m} differ by more than a "
            "quarter; beta by moments is taken there",
            names=some(list(refused)),
            low=low,
            high=high,
        )
        yield DesignCheck("constant beta", "attention", words, of=next(iter(refused)))


def _asked(model: Model, steel: Reinforcement, force: PunchingForce) -> Beta:
    """Return what the case asks for."""
    if force.support is None:
        for column in model.columns:
            if column.name == force.name and column.beta is not None:
                return column.beta
    return steel.beta


def sector_pieces(plate: PlateResult, legs: Array, inside: Array, d: float) -> tuple[PerimeterShear, ...]:
    """Return how shear forces across the parts of a perimeter's legs (l, 2, 2) around a place (2,) are read."""
    pieces = (perimeter_shear(plate, chain, inside, d) for chain in chains(legs))
    return tuple(piece for piece in pieces if piece is not None)


def betas_by_sectors(
    pieces: Sequence[PerimeterShear], plate: PlateResult, center: Array, axis: Array, *, sign: float
) -> dict[str, float]:
    """Return beta by numbers of sectors of equal angle and of equal length, by their names in calculations."""
    ways = {
        f"sectors {count}{' by length' * by_length}": beta_by_sectors(
            pieces, plate, center, axis, sign=sign, count=count, by_length=by_length
        )
        for count in TRIED
        for by_length in (False, True)
    }
    return {name: beta for name, beta in ways.items() if beta is not None}


def beta_by_sectors(
    pieces: Sequence[PerimeterShear],
    plate: PlateResult,
    center: Array,
    axis: Array,
    *,
    sign: float,
    count: int = SECTORS,
    by_length: bool = False,
) -> float | None:
    """Return the mean shear force of the governing sector over that of the whole perimeter; None where none pushes.

    Sectors are parts of the perimeter of equal angle seen from the center (2,), or of equal length; one that runs all
    around has a count of them, the first on both sides of an axis (2,), one that ends at edges so many fewer.
    """
    sums, lengths = list[float](), list[float]()
    for piece in pieces:
        v, ds = sign * piece.forces(plate), piece.ds
        offset = piece.middle - center
        angle = np.unwrap(np.arctan2(offset[:, 1], offset[:, 0]))
        span = 2 * pi if piece.closed else float(np.ptp(angle))
        number = count if piece.closed else max(1, round(count * span / (2 * pi)))
        if by_length:
            way = (np.cumsum(ds) - ds / 2) / ds.sum()
        elif piece.closed:
            way = ((angle - atan2(axis[1], axis[0]) + pi / number) / (2 * pi)) % 1.0
        else:
            way = (angle - angle.min()) / span if span > 0 else np.zeros(len(ds))
        sector = np.minimum((way * number).astype(int), number - 1)
        sums += np.bincount(sector, v * ds, minlength=number).tolist()
        lengths += np.bincount(sector, ds, minlength=number).tolist()
    total, length = sum(sums), sum(lengths)
    if not total > 0:
        return None
    return max(q / u for q, u in zip(sums, lengths, strict=True) if u > 0) / (total / length)
