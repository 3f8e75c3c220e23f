"""Case files: TOML with units to a Model and back, and a file to start from."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

from groundslab.case.building_file import with_matrix
from groundslab.errors import InputError, Issue
from groundslab.model.model import Model
from groundslab.schema.base import Section
from groundslab.schema.section_fields import Field
from groundslab.schema.wording import describe, quote

LARGEST = 10_000_000  # bytes of a file
MOST_KEYS = 10  # joined by dots; those of a case are five at most, and tomllib's time grows with their square
_KEY = r"""(?:[\w-]++|"(?:[^"\\\n]|\\.)*+"|'[^'\n]*+')"""
_DOTTED = re.compile(rf"{_KEY}(?:[ \t]*+\.[ \t]*+{_KEY})*+")
_PLACE = re.compile(r"\s*\(at (?:line (\d+), column (\d+)|end of document)\)$")
_BARE_UNIT = re.compile(r"=\s*[-+0-9.eE]+\s*[A-Za-zµμ]")


def load(path: str | Path) -> Model:
    """Read a model from a case file.

    Parameters
    ----------
    path : str or pathlib.Path
        The case file (TOML).

    Returns
    -------
    Model
        The model.

    Raises
    ------
    InputError
        If the file cannot be read or describes no model; it lists all issues.

    Examples
    --------
    >>> import groundslab
    >>> groundslab.load(folder / "case.toml").plate.thickness
    0.3
    """
    return from_table(tables(read(path), str(path)), Path(path).parent)


def read(path: str | Path) -> str:
    """Return the text of a TOML file; raises InputError if it cannot be read."""
    try:
        with Path(path).open("rb") as file:
            content = file.read(LARGEST + 1)
    except FileNotFoundError:
        raise _unreadable(path, "no file of that name") from None
    except IsADirectoryError:
        raise _unreadable(path, "a directory") from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise _unreadable(path, f"a file that cannot be read ({reason})") from None
    if len(content) > LARGEST:
        raise _unreadable(path, "a larger file", f"a TOML file of at most {LARGEST // 1_000_000} MB")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        where = f"{path}, line {line}"
        raise InputError([Issue(where, "bytes that are not UTF-8", "UTF-8 text", "save it as UTF-8")]) from None


def loads(text: str, name: str = "the text") -> Model:
    """Return the Model that a text describes; ``name`` stands for the file in messages."""
    return from_table(tables(text, name))


def tables(text: str, name: str = "the text") -> dict[str, Any]:
    """Return the tables of a TOML text; ``name`` stands for the file in messages; raises InputError."""
    if len(text) > LARGEST:
        raise _unreadable(name, "a longer text", f"at most {LARGEST:,} characters")
    _require_short_keys(text, name)
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InputError([_syntax(text, name, str(error))]) from None
    except RecursionError:
        raise _unreadable(name, "lists or tables nested too deeply", "the tables of an input file") from None
    except ValueError as error:  # such as a number of very many digits
        raise _unreadable(name, f"a value that cannot be read ({error})", "TOML") from None


def _require_short_keys(text: str, name: str) -> None:
    """Raise InputError for keys of very many parts, wherever they stand; what a text says is not understood yet."""
    for match in _DOTTED.finditer(text):
        if match.end() - match.start() > MOST_KEYS and (parts := match.group().count(".")) > MOST_KEYS:
            line = text.count("\n", 0, match.start()) + 1
            dotted_key = f"{parts + 1} names joined by dots"
            raise InputError(
                [Issue(f"{name}, line {line}", dotted_key, f"at most {MOST_KEYS}, as the tables of a file need")]
            )


def from_table(data: dict[str, Any], folder: Path | None = None) -> Model:
    """Return the Model that the tables of a case file, already parsed, describe.

    The folder is that of the case, beside which the file of a building's matrix may be.
    """
    return Model.model_validate(data if folder is None else with_matrix(data, folder), from_file=True)


def to_toml(part: Section) -> str:
    """Return a Model as an input file that ``loads`` turns into an equal Model; defaults are left out."""
    return "\n".join(_lines(part, "")).strip() + "\n"


def lines_of(parts: Mapping[str, Any], kind: type[Section]) -> list[str]:
    """Return the lines of a file with some parts of a section of a kind, such as a Model; others are left out."""
    part = object.__new__(kind)
    vars(part).update(kind.field_defaults, **parts, _given=frozenset(parts))
    fields = {name: field for name, field in kind.model_fields.items() if name in parts}
    return list(_lines(part, "", fields))


def _unreadable(path: str | Path, found: str, expected: str = "a TOML file") -> InputError:
    return InputError([Issue(str(path), found, expected)])


def _syntax(text: str, name: str, message: str) -> Issue:
    """Return the fault in the TOML, from tomllib's message, which ends with the place."""
    lines = text.split("\n")
    place = _PLACE.search(message)
    line, column = (int(place[1]), int(place[2])) if place and place[1] else (len(lines), len(lines[-1]) + 1)
    content = lines[line - 1].strip() if line <= len(lines) else ""
    hint = _PLACE.sub("", message)
    if _BARE_UNIT.search(content):
        hint = 'put number and unit in quotes, as in thickness = "200 mm"'
    return Issue(f"{name}, line {line}, column {column}", describe(content) if content else "nothing", "TOML", hint)


def _lines(part: Section, path: str, fields: Mapping[str, Field] | None = None) -> Iterator[str]:
    """Yield the lines of a part: its values, then the parts in it; all of its fields, or some."""
    tables: list[tuple[str, Section]] = []
    following = {key for name, keys in part.follow.items() if getattr(part, name) for key in keys}
    for name, field in (fields or type(part).model_fields).items():
        if name in following:
            continue
        value: Any = getattr(part, name)
        key = field.type
        inner = field.sections
        below = f"{path}.{name}" if path else name
        if inner.many:
            tables += [(f"[[{below}]]", section) for section in value]
        elif inner.parts:
            if value is not None and (field.required or value != field.default):
                tables.append((f"[{below}]", value))
        elif key is None:
            yield f"{name} = {quote(value)}"
        elif value is not None and (field.required or value != field.default) and name in part.model_fields_set:
            yield f"{name} = {key.write(value)}"
    for heading, inner_part in tables:
        yield ""
        yield heading
        yield from _lines(inner_part, heading.strip("[]"))


@cache
def starter() -> str:
    """Return a commented input file to start from."""
    return Path(__file__).with_name("starter.toml").read_text(encoding="utf-8")
