"""Formulas as they are set: fractions, roots, powers, indices, functions, numbers."""

from __future__ import annotations

import pytest

from groundslab.views.report.formulas import set_formula


def plain(formula: str, point: str = ".") -> str:
    """Return a formula as it is set, without quotes and slants."""
    return set_formula(formula, point).replace("italic", "").replace('"', "")


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        ("a / b", "frac((a), (b))"),
        ("a / b / c", "frac((a), (b) dot (c))"),
        ("a / (b / c)", "frac((a), frac((b), (c)))"),
        ("a * b / (c + d) * e", "frac((a) dot (b), (c) + (d)) dot (e)"),
        ("a - (b - c)", "(a) − lr(((b) − (c)))"),
        ("a - b + c", "(a) − (b) + (c)"),
        ("(a + b) * c", "lr(((a) + (b))) dot (c)"),
        ("(a / b)^2", "lr((frac((a), (b))))^(2)"),
        ("f_ck^(1/3)", "(f)_ck^(1 / 3)"),
        ("sqrt(a^2 + b^2)", "sqrt((a)^(2) + (b)^(2))"),
        ("v_Rd,c * A'", "(v)_Rd,c dot (A)'"),
        ("max(a, 2)", "op(max) lr(((a) , thick 2))"),
        ("(-3.5) * a", "lr((−3.5)) dot (a)"),
        ("1.2e-05 * a", "1.2 dot 10^−5 dot (a)"),
        ("gamma_C * pi", "(γ)_C dot π"),
        ("Delta_c,dev + cot_max", "(Δ)_c,dev + (cot)_max"),
        ("t * nu_f_cd / 2", "frac((t) dot (ν) thin (f)_cd, 2)"),
    ],
)
def test_formula(formula: str, expected: str) -> None:
    """What stands above and below a line needs no brackets, what it multiplies does."""
    assert plain(formula) == expected


def test_commas_of_a_language() -> None:
    """Where the decimal point is a comma, arguments stand between semicolons."""
    assert plain("max(0.25 * a, 1.5)", ",") == "op(max) lr((0,25 dot (a) ; thick 1,5))"


def test_what_is_no_formula_stands_as_it_is() -> None:
    """Words and what a user may write stay a text."""
    assert set_formula('see "7 (b') == '"see \\"7 (b"'
    assert set_formula("") == '""'
