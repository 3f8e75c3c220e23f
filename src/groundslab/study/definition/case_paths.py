"""Keys of a case by their paths, such as `ground.layers[1].E`: their types, their values, cases with other values."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from groundslab.model.model import Model
from groundslab.schema.base import Section
from groundslab.schema.fields import Factors, FieldType, ListOf, Number
from groundslab.schema.issues import FieldError, RelativeIssue
from groundslab.schema.wording import describe, listed, one_of, quote, suggestion

_STEP = re.compile(r'\.?(?:(?P<name>[A-Za-z_][\w-]*)|"(?P<quoted>(?:[^"\\]|\\.)*)")|\[(?P<number>[0-9]{1,6})\]')

#: A step of a path: a key, or a position counted from 0.
Step = str | int


@dataclass(frozen=True, slots=True)
class Place:
    """A key of a case: its path as written, the steps to it, its type, its value (None if not given)."""

    path: str
    steps: tuple[Step, ...]
    key: FieldType
    value: Any = field(compare=False)


def steps_of(path: str) -> tuple[Step, ...]:
    """Return the steps of a path such as ``ground.layers[1].E``; raises FieldError."""
    steps: list[Step] = []
    position = 0
    while position < len(path):
        match = _STEP.match(path, position)
        first = position == 0
        if not match or (first and path[0] in ".[") or match["number"] == "0":
            raise path_error(path, 'a path such as "ground.layers[1].E"', "positions count from 1")
        if not first and match["number"] is None and path[position] != ".":
            raise path_error(path, 'a path such as "ground.layers[1].E"', "keys are separated by dots")
        if match["number"] is not None:
            steps.append(int(match["number"]) - 1)
        else:
            quoted = match["quoted"]
            steps.append(match["name"] if quoted is None else re.sub(r"\\(.)", r"\1", quoted))
        position = match.end()
    if not steps:
        raise path_error(path, 'a path such as "ground.layers[1].E"')
    return tuple(steps)


def path_error(path: str, expected: str, hint: str = "") -> FieldError:
    """Return the error for a path that leads to no key that can vary."""
    return FieldError(RelativeIssue((), describe(path), expected, hint))


def place_of(model: Model, path: str) -> Place:
    """Return the key of a case that a path leads to; raises FieldError if it leads to none with a value."""
    steps = steps_of(path)
    part: Section = model
    walked = ""
    left = list(steps)
    while left:
        name = left.pop(0)
        fields = [key for key, info in type(part).model_fields.items() if info.type or info.sections.parts]
        where = f"{walked} has" if walked else "the case has"
        if not isinstance(name, str) or name not in fields:
            if name in type(part).model_fields:
                raise path_error(path, f"a key that {where} a value for", f"{quote(str(name))} says which kind it is")
            shown = f"[{name + 1}]" if isinstance(name, int) else quote(name)
            hint = suggestion(name, fields)
            raise path_error(path, f"a key that {where}: {one_of(fields)}", hint or f"{shown} is none of them")
        info = type(part).model_fields[name]
        walked += f".{name}" if walked else name
        key = info.type
        if key is not None:
            return Place(path, steps, *_within(key, getattr(part, name), left, path, walked))
        held = getattr(part, name)
        if info.sections.many:
            if not left or not isinstance(left[0], int):
                count = f"{walked} is a list of {len(held)}"
                raise path_error(path, f"a position after {walked}, such as {walked}[1]", count)
            number = left.pop(0)
            assert isinstance(number, int)
            if number >= len(held):
                raise path_error(path, f"{walked}[1] to {walked}[{len(held)}]" if held else f"a case with {walked}")
            held = held[number]
            walked += f"[{number + 1}]"
        if held is None:
            raise path_error(path, f"a case with {walked}", "the case does not have it")
        part = held
    keys = [key for key, info in type(part).model_fields.items() if info.type]
    raise path_error(path, f"a key of {walked}: {one_of(keys)}", f"{walked} holds keys, not a value")


def _within(key: FieldType, held: Any, left: list[Step], path: str, walked: str) -> tuple[FieldType, Any]:
    """Return type and value within a list or a table of factors; those of the key itself if no step is left."""
    while left:
        step = left.pop(0)
        if isinstance(key, ListOf) and isinstance(step, int) and held is not None and step < len(held):
            key, held = key.each, held[step]
            walked += f"[{step + 1}]"
        elif isinstance(key, Factors) and isinstance(step, str):
            names = [name for name, _ in held]
            if step not in names:
                raise path_error(path, f"a name in {walked}: {one_of(names)}", suggestion(step, names))
            key, held = Number("", "factor"), dict(held)[step]
        else:
            raise path_error(path, f"a path that ends with {walked}, or a place within it", "there is no such place")
    if isinstance(key, Factors):
        names = [f"{walked}.{name}" for name, _ in held]
        raise path_error(path, f"one of the factors: {listed(map(quote, names))}")
    return key, held


def with_values(model: Model, values: Mapping[Place, Any]) -> Model:
    """Return a case with other values at some places, checked again; raises InputError with all issues."""
    return Model(**_replace(model, [(place.steps, value) for place, value in values.items()])) if values else model


def _replace(held: Any, changes: Sequence[tuple[tuple[Step, ...], Any]]) -> Any:
    """Return a part, list or table of factors with the changes made, as data to be checked."""
    if not changes[0][0]:
        return changes[-1][1]
    by_step: dict[Step, list[tuple[tuple[Step, ...], Any]]] = {}
    for steps, value in changes:
        by_step.setdefault(steps[0], []).append((steps[1:], value))
    if isinstance(held, Section):
        return {**dict(held), **{step: _replace(getattr(held, str(step)), below) for step, below in by_step.items()}}
    if all(isinstance(step, str) for step in by_step):
        return tuple((name, _replace(value, by_step[name]) if name in by_step else value) for name, value in held)
    return [_replace(item, by_step[n]) if n in by_step else item for n, item in enumerate(held)]
