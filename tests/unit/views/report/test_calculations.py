"""The chapter of calculations: formulas as they are written by hand, a sheet for each check."""

from __future__ import annotations

import pytest

from groundslab.views.report.calculations import Piece, build_sheets, split_formula, split_with_commas
from groundslab.views.tables.table import table_of

HEADS = (
    ("check", ""), ("of", ""), ("combination", ""), ("quantity", ""), ("symbol", ""), ("formula", ""),
    ("with numbers", ""), ("value", ""), ("unit", ""), ("clause", ""), ("x", "m"), ("y", "m"),
)  # fmt: skip


@pytest.mark.parametrize(
    ("formula", "pieces"),
    [
        ("h - a_1", [("h", "var"), (" \N{MINUS SIGN} ", ""), ("a", "var"), ("1", "sub")]),
        ("rho_l^(1/3)", [("ρ", "var"), ("l", "sub"), ("1/3", "sup")]),
        ("d^2 * 2", [("d", "var"), ("2", "sup"), (" · ", ""), ("2", "")]),
        ("sqrt(v_Rd,c)", [("√", ""), ("(", ""), ("v", "var"), ("Rd,c", "sub"), (")", "")]),
        ("-1.9e-06", [("\N{MINUS SIGN}", ""), ("1.9 \N{MULTIPLICATION SIGN} 10", ""), ("-6", "sup")]),
        ("omega", [("ω", "var")]),
        ("(1 - a)^m", [("(", ""), ("1", ""), (" \N{MINUS SIGN} ", ""), ("a", "var"), (")", ""), ("m", "sup")]),
    ],
)
def test_formulas_in_pieces(formula: str, pieces: list[Piece]) -> None:
    """Powers are raised, indices lowered, Greek letters are letters, and products have a dot."""
    assert split_formula(formula) == pieces


def test_formulas_with_decimal_commas() -> None:
    """Semicolons then part what stands in brackets, and commas of indices stay."""
    pieces = split_with_commas("max(0.26 * f_ctm, 1.5e-03) - v_Rd,c")
    assert "".join(text for text, _ in pieces) == "max(0,26 · fctm; 1,5 × 10-3) − vRd,c"


@pytest.mark.parametrize("formula", ["max(0.26 * f_ctm / f_yk, 0.0013) * d * 10000", "u_1 * (d + 2.5)^0.5", "0.0005"])
def test_pieces_lose_nothing(formula: str) -> None:
    """Put together, the pieces are the formula but for what is written otherwise."""
    plain = formula.translate(str.maketrans("", "", " ^_")).replace("*", "·")
    assert "".join(text for text, _ in split_formula(formula)).replace(" ", "") == plain


def test_each_check_has_a_sheet() -> None:
    """Rows of one check at one place in one combination are one sheet, in their order."""
    rows = [
        ["punching", "C1", "ULS 1", "effective depth", "d", "h - a", "0.3 - 0.05", 0.25, "m", "6.4.2", 1.5, -2.0],
        ["punching", "C1", "ULS 1", "share used", "eta", "", "", 0.5, "", "", 1.5, -2.0],
        ["punching", "C2", "ULS 1", "share used", "eta", "", "", 0.75, "", "", None, None],
    ]
    sheets = build_sheets(table_of("calculations", "Calculations", HEADS, rows, ()), "SI")
    assert list(sheets) == [("punching", "C1", "ULS 1"), ("punching", "C2", "ULS 1")]
    first, second = sheets.values()
    assert (first.title, second.title) == ("Punching, C1, ULS 1, at (1.5, \N{MINUS SIGN}2) m", "Punching, C2, ULS 1")
    assert [(line.symbol, line.value) for line in first.lines] == [("d", "0.25000"), ("eta", "0.50000")]
    assert [line.value for line in second.lines] == ["0.75000"]
