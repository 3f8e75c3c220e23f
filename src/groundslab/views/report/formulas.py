"""Formulas of calculations set as they are written by hand: fractions, roots, powers, indices."""

from __future__ import annotations

import ast
import re
from typing import TYPE_CHECKING

from groundslab.design.rules.calculation import CONSTANTS, FUNCTIONS, SYMBOL
from groundslab.views.report.table_layout import split_symbol

if TYPE_CHECKING:
    from collections.abc import Callable

#: What stands in a formula beside signs: a number, which may have a power of ten, or a symbol.
_ATOM = re.compile(rf"(?P<number>\d+(?:\.\d+)?(?:e[-+]?\d+)?)|(?P<symbol>{SYMBOL.pattern})")
#: How tightly the operators of a formula bind, and what is no operator.
SUM, PRODUCT, POWER, ATOM = range(4)
_BINDS = {ast.Add: SUM, ast.Sub: SUM, ast.Mult: PRODUCT, ast.Div: PRODUCT, ast.Pow: POWER}


def set_formula(formula: str, point: str = ".") -> str:
    """Return a formula such as "C * (f_ck / 2)^(1/3)" in the mathematical notation of Typst.

    Numbers have the decimal point of a language; where it is a comma, arguments stand between semicolons. What is no
    formula is set as it is.
    """
    atoms: list[re.Match[str]] = []

    def keep(match: re.Match[str]) -> str:
        if match["symbol"] in FUNCTIONS:
            return match[0]
        atoms.append(match)
        return f"_{len(atoms) - 1}_"

    try:
        tree = ast.parse(_ATOM.sub(keep, formula).replace("^", "**"), mode="eval")
        return _set(tree.body, lambda number: _set_atom(atoms[number], point), "," if point == "." else ";")
    except (SyntaxError, ValueError):
        return _quoted(formula)


def _set_atom(match: re.Match[str], point: str) -> str:
    """Return a number, or a symbol with its index below."""
    if number := match["number"]:
        digits, _, exponent = number.partition("e")
        written = _quoted(digits.replace(".", point))
        return f"{written} dot 10^{_quoted(str(int(exponent)).replace('-', '−'))}" if exponent else written
    symbol = match["symbol"]
    return _quoted("π") if symbol in CONSTANTS else _set_symbol(symbol)


def _set_symbol(symbol: str) -> str:
    """Return a symbol with its index below; one such as nu_f_cd is a factor before a symbol that has an index."""
    if symbol.count("_") > 1:
        factor, _, rest = symbol.partition("_")
        return f"{_set_symbol(factor)} thin {_set_symbol(rest)}"
    stem, primes = symbol.rstrip("'"), "'" * symbol.count("'")
    base, _, index = stem.partition("_")
    ((letter, _), *_) = split_symbol(base)
    # a letter is slanted as a variable, several are a word
    written = f"italic({_quoted(letter)})"
    below = f"_{_quoted(index)}" if index else ""
    return f"{written}{primes}{below}"


def _set(node: ast.expr, atom: Callable[[int], str], comma: str) -> str:
    """Return a part of a formula."""

    def part(inner: ast.expr, least: int) -> str:
        written = _set(inner, atom, comma)
        return f"lr(({written}))" if _strength(inner) < least else written

    match node:
        case ast.Name(id=name):
            return atom(int(name.strip("_")))
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return f"−{part(operand, PRODUCT)}"
        case ast.BinOp(left=left, op=ast.Add(), right=right):
            return f"{part(left, SUM)} + {part(right, SUM)}"
        case ast.BinOp(left=left, op=ast.Sub(), right=right):
            return f"{part(left, SUM)} − {part(right, PRODUCT)}"
        case ast.BinOp(left=left, op=ast.Mult(), right=right):
            return f"{part(left, PRODUCT)} dot {part(right, PRODUCT)}"
        case ast.BinOp(op=ast.Div()):
            above, below = _fraction(node)
            under = " dot ".join(part(factor, PRODUCT if len(below) > 1 else SUM) for factor in below)
            return f"frac({_set(above, atom, comma)}, {under})"
        case ast.BinOp(left=left, op=ast.Pow(), right=right):
            return f"{part(left, ATOM)}^({_exponent(right, atom, comma)})"
        case ast.Call(func=ast.Name(id=name), args=args):
            return _called(name, [_set(argument, atom, comma) for argument in args], comma)
    raise ValueError(ast.dump(node))


def _called(name: str, args: list[str], comma: str) -> str:
    """Return a function of arguments."""
    if name == "sqrt":
        return f"sqrt({args[0]})"
    if name == "abs":
        return f"abs({args[0]})"
    separator = f" {_quoted(comma)} thick "
    return f"op({_quoted(name)}) lr(({separator.join(args)}))"


def _fraction(node: ast.expr) -> tuple[ast.expr, list[ast.expr]]:
    """Return what stands above the line of a / b / c, and what below it."""
    below: list[ast.expr] = []
    while isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div):
        below.insert(0, node.right)
        node = node.left
    return node, below


def _exponent(node: ast.expr, atom: Callable[[int], str], comma: str) -> str:
    """Return an exponent; a fraction of two atoms in it stays on one line."""
    match node:
        case ast.BinOp(left=ast.Name() as above, op=ast.Div(), right=ast.Name() as below):
            return f'{_set(above, atom, comma)} "/" {_set(below, atom, comma)}'
    return _set(node, atom, comma)


def _strength(node: ast.expr) -> int:
    """Return how tightly the outermost operator of a part binds; a fraction's line binds as brackets do."""
    if isinstance(node, ast.BinOp):
        return POWER if isinstance(node.op, ast.Div) else _BINDS[type(node.op)]
    return SUM if isinstance(node, ast.UnaryOp) else ATOM


def _quoted(text: str) -> str:
    """Return a text as it stands."""
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'
