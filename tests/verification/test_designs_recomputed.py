"""Designs by four codes followed on paper by a second program: every number agrees, or is an input by its name."""

from __future__ import annotations

from typing import Any

import pytest

from groundslab.views.interface.documents import tables_to_json
from helpers.second_program import ACI, DE, EN, SECOND, follow
from helpers.signed_slab import signed_slab
from helpers.solve_once import solve_once

EUROCODE: dict[str, Any] = {"concrete": "C30/37", "steel": "B500B", "w_max": 0.3e-3}
CODES: dict[str, dict[str, Any]] = {
    EN: EUROCODE,
    DE: EUROCODE | {"annex": "Germany"},
    SECOND: EUROCODE | {"code": SECOND},
    ACI: {"code": ACI, "f_ck": 30e6, "f_yk": 420e6},
}
#: Sheets that each code has: bars, shear, punching at all columns and at a wall's end, distances, limits.
SHEETS = {"bending", "one-way shear", "punching", "punching at walls' ends", "walls", "cover", "pressure", "tilt"}


@pytest.mark.slow
@pytest.mark.parametrize("code", CODES)
def test_a_second_program_follows_the_design(code: str) -> None:
    """By the clauses as they are written there, from what is printed; no number is without an origin on paper."""
    lines = list(follow(tables_to_json(solve_once(signed_slab(CODES[code])), ["calculations"]), code))
    wrong = [line for line in lines if not line.agrees]
    assert not wrong
    assert {line.check for line in lines} >= SHEETS
    assert {line.of for line in lines if line.check == "punching"} == {"M", "E", "C", "R"}
    assert sum(line.origin == "computed" for line in lines) > 220
    assert sum(line.origin == "sketch" for line in lines) < len(lines) / 12


@pytest.mark.parametrize(("symbol", "by"), [("beta", 1.001), ("A_s", 0.999), ("u", 1.001)])
def test_a_wrong_number_is_seen(symbol: str, by: float) -> None:
    """A number that is off by a thousandth is found, and one without an origin."""
    document = tables_to_json(solve_once(signed_slab(CODES[EN])), ["calculations"])
    columns = {column["name"]: column["values"] for column in document["tables"][0]["columns"]}
    row = next(n for n, each in enumerate(columns["symbol"]) if each == symbol and columns["formula"][n])
    columns["value"][row] *= by
    columns["symbol"][-1] = "unheard of"
    assert {line.symbol for line in follow(document, EN) if not line.agrees} >= {symbol, "unheard of"}
