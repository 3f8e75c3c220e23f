"""Is punching of pads judged, and right? Sizes of pads, columns and depths in three codes beside a short program.

    python bench/pads.py            # some minutes

Square and oblong pads with square, oblong and round columns in the middle, beside it and at an edge, on springs and so
stiff that the pressure is linear. All are judged by all codes. Where the perimeters lie on the pad all around, demand
and resistance are compared with `verification/analytic_pads`, which follows the clauses and shares nothing with the
design. Counts and the largest differences are printed and go to bench/pads.json.
"""

from __future__ import annotations

import argparse
import json
import math
from collections import Counter
from collections.abc import Iterator
from itertools import product
from pathlib import Path
from typing import Any

import groundslab as gs
from groundslab.design.codes.en1992_2023.checks.punching_demand import column_demands
from groundslab.design.rules.check import DesignCheck
from groundslab.model.model import Model
from groundslab.verification.analytic_pads import pad_by_aci318, pad_by_en1992_2004, pad_by_en1992_2023

RESULTS = Path(__file__).parent / "pads.json"
LENGTHS, WIDTHS, DEPTHS = (
    (1.2, 1.6, 2.0, 2.4, 3.0, 4.0, 6.0),
    (0.2, 0.3, 0.4, 0.6, 0.9, 1.2),
    (0.3, 0.4, 0.5, 0.7, 0.85, 1.2),
)
#: Length over width of pad and column (0: round), and the eccentricity over the pad's length; 0.5: at an edge.
SHAPES = {
    "centered": (1.0, 1.0, 0.0), "eccentric": (1.0, 1.0, 0.1), "oblong": (1.5, 2.0, 0.0), "round": (1.0, 0.0, 0.0),
    "at an edge": (1.0, 1.0, 0.5),
}  # fmt: skip
CODES = {"EN 1992-1-1": pad_by_en1992_2004, "EN 1992-1-1:2023": pad_by_en1992_2023, "ACI 318": pad_by_aci318}
#: How far perimeters and what counts inside reach, over the effective depth.
REACH = {"EN 1992-1-1": 2.0, "EN 1992-1-1:2023": 0.67, "ACI 318": 0.5}
#: Axes of the bars [m], their ratio both ways, strength and a stress around the column that no pad fails by [MPa].
AXIS, RATIO, F_CK, STRESS = 0.06, 0.004, 25.0, 0.25
#: The ground [Pa/m], and E h^3 over K L^4: the pressure is linear but for less than 1e-3 of it.
K, STIFF = 20e6, 1e3


def model_of(code: str, pad: dict[str, float], h: float) -> Model:
    """Return a rigid pad with a column whose force is given."""
    d, E = h - AXIS, STIFF * K * max(pad["L_x"], pad["L_y"]) ** 4 / h**3
    bars = {"diameter": 2 * math.sqrt(RATIO * d * 0.1 / math.pi), "spacing": 0.1}
    layers = ("bottom_x", "bottom_y", "top_x", "top_y")
    section = {"width_x": pad["c_x"], "width_y": pad["c_y"]} if pad["c_y"] else {"diameter": pad["c_x"]}
    return Model(
        plate={"length_x": pad["L_x"], "length_y": pad["L_y"], "thickness": h, "E": E, "nu": 0.0},
        ground={"kind": "winkler", "k": K},
        columns=[{"name": "C", "x": pad["e"], "y": 0.0, **section}],
        cases=[{"name": "G"}],
        loads=[{"kind": "point", "case": "G", "column": "C", "P": pad["P"] * 1e6}],
        combinations=[{"name": "U", "limit_state": "ultimate", "factors": {"G": 1.0}}],
        reinforcement={"code": code, "f_ck": F_CK * 1e6, "f_yk": 500e6, "bottom": [AXIS, AXIS], "top": [AXIS, AXIS],
                       **dict.fromkeys(layers, bars)},
        mesh={"counts": (6, 6)},
    )  # fmt: skip


def pads() -> Iterator[tuple[str, dict[str, float], float]]:
    """Yield shape, pad and thickness of those that could be built: the column takes half of a side at most."""
    for (shape, (oblong, column, share)), L, c, h in product(SHAPES.items(), LENGTHS, WIDTHS, DEPTHS):
        c_y = c / column if column else 0.0
        L_x, L_y = L * oblong, L
        if c > L / 2 or 2 * h > L:
            continue
        e = share * L_x if share < 0.5 else (L_x - c) / 2
        P = STRESS * (4 * c + math.pi * (h - AXIS)) * (h - AXIS)
        yield shape, {"L_x": L_x, "L_y": L_y, "c_x": c, "c_y": c_y, "e": e, "P": P}, h


def around(code: str, pad: dict[str, float], depth: float) -> bool:
    """Return whether perimeters of a code run all around the column: none to an edge or a corner is shorter.

    By EN 1992-1-1 those that govern are nearer than half of 2 d, and at the face a corner has u_0 of setbacks and 3 d.
    """
    a, c_y = REACH[code] * depth, pad["c_y"] or pad["c_x"]
    room_x, room_y = (pad["L_x"] - pad["c_x"]) / 2 - abs(pad["e"]), (pad["L_y"] - c_y) / 2
    if 2 * (pad["c_x"] + c_y) > room_x + room_y + 3 * depth:
        return False
    near = a / 2 if a > depth else a
    around_corner = 2.0 if code == "ACI 318" else math.pi / 2  # its corners are square
    corner = room_x + pad["c_x"] + room_y + c_y + around_corner * near
    closed = 2 * (pad["c_x"] + c_y) + 4 * around_corner * near if pad["c_y"] else math.pi * (pad["c_x"] + 2 * near)
    return min(room_x, room_y) > a and corner > closed and (not pad["e"] or room_x > c_y / 2 + 2 * a)


def punching(checks: tuple[DesignCheck, ...]) -> list[DesignCheck]:
    """Return the checks of punching, the one around the column first."""
    those = [check for check in checks if "punching" in check.name or "two-way" in check.name]
    return sorted(those, key=lambda check: "face" in check.name)


def compared(made: list[DesignCheck], hand: dict[str, float]) -> Iterator[tuple[str, float, float]]:
    """Yield what is compared, its value and that by hand.

    By EN 1992-1-1 it is the ratio, as it has a flat top over the distance from the face, and the two at the face.
    """
    numbers = [(check.demand or 0.0, check.resistance or 1.0) for check in made]
    if "at the face" in hand:
        yield "used", numbers[0][0] / numbers[0][1], hand["used"]
        yield "demand", numbers[1][0], hand["at the face"]
        yield "resistance", numbers[1][1], hand["v_Rd,max"]
    else:
        yield from zip(("demand", "resistance"), numbers[0], hand.values(), strict=False)


def main() -> None:
    """Run the sweep."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--every", type=int, default=1, help="only each so manieth pad")
    every = parser.parse_args().every
    counts: dict[str, Counter[str]] = {code: Counter() for code in CODES}
    worst: dict[str, dict[str, Any]] = {
        code: dict.fromkeys(("used", "demand", "resistance"), (0.0, "")) for code in CODES
    }
    for number, (shape, pad, h) in enumerate(pads()):
        if number % every:
            continue
        for code, by_hand in CODES.items():
            results = gs.solve(model_of(code, pad, h))
            made = punching(gs.check_design(results).checks)
            about = f"{shape} {pad} h {h:g}"
            judged = [check for check in made if check.unjudged is None]
            one_way = judged and judged[0].demand is None
            counts[code]["one-way shear" if one_way else "judged" if len(judged) == len(made) else "not judged"] += 1
            if len(judged) < len(made):
                print("NOT JUDGED", code, about, [check.words for check in made])
            if one_way or not around(code, pad, h - AXIS):
                continue
            given = pad | ({"a_p": column_demands(results)[0]["U", "C"].a_p} if code == "EN 1992-1-1:2023" else {})
            hand = by_hand(d=h - AXIS, f_ck=F_CK, rho=RATIO, **given)
            counts[code]["compared"] += 1
            for what, value, expected in compared(made, hand):
                difference = abs(value / expected - 1)
                worst[code][what] = max(
                    worst[code][what], (difference, f"{about}: {value:.5g}, by hand {expected:.5g}")
                )
    answer = {code: {"counts": dict(counts[code]), "largest differences": worst[code]} for code in CODES}
    print(json.dumps(answer, indent=1))
    if every == 1:
        RESULTS.write_text(json.dumps(answer, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
