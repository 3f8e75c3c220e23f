"""Parts of a model whose places are crossings of axes, such as `B/3`, found when the model is read."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any

from groundslab import units
from groundslab.geometry.plan import Place
from groundslab.messages import Name
from groundslab.model.axes.families import BETWEEN, AnyAxes, Axis, RayAxes, RingAxes, StraightAxes, crossings
from groundslab.schema.fields import ListOf, Text
from groundslab.schema.issues import FieldError, RelativeIssue
from groundslab.schema.repairs import remove
from groundslab.schema.section_fields import sections_by_kind
from groundslab.schema.wording import describe, one_of, suggestion

#: Lists of parts that may be attached to axes.
ATTACHABLE = ("columns", "walls", "beams", "supports", "loads")
#: Kinds of loads and supports that are at a point, and along a line.
AT_POINT, ALONG_LINE = ("point", "pile"), ("line", "line moment")
#: Places closer than this [m] are one.
SAME = 1e-6


@dataclass(frozen=True, slots=True)
class InvalidCrossing:
    """Stands for a reference to axes that cannot be followed, until the part that has it is read."""

    issues: tuple[RelativeIssue, ...]


@dataclass(frozen=True)
class Crossing(Text):
    """The names of two axes that cross, such as `B/3`."""

    def read(self, value: Any, from_file: bool) -> Name:
        """Return the text; raises FieldError if it names no crossing."""
        if isinstance(value, InvalidCrossing):
            raise FieldError(*value.issues)
        return super().read(value, from_file)


@dataclass(frozen=True)
class Crossings(ListOf):
    """Crossings of axes through which a line runs."""

    def read(self, value: Any, from_file: bool) -> tuple[Any, ...]:
        """Return the texts; raises FieldError if one of them names no crossing."""
        if isinstance(value, InvalidCrossing):
            raise FieldError(*value.issues)
        return super().read(value, from_file)


AtCrossing = Annotated[str, Crossing('axes that cross where it is, such as "B/3", instead of x and y')]
AtCrossings = Annotated[
    tuple[str, ...],
    Crossings(
        Text(""), "", 'crossings of axes that it runs through, such as ["A/1", "A/4"], instead of points', least=0
    ),
]


def attach_to_axes(data: Mapping[Any, Any]) -> Mapping[Any, Any]:
    """Return the tables of a model with the places of all parts that are attached to axes.

    Parameters
    ----------
    data : mapping
        Tables or sections of a model by their keys. Those with the key `at` get x and y, or points.

    Raises
    ------
    FieldError
        If axes to which something is attached are not valid themselves.
    """
    lists = {name: data.get(name) for name in ATTACHABLE}
    attached = {
        name: parts for name, parts in lists.items() if isinstance(parts, list | tuple) and any(map(_reference, parts))
    }
    if not attached:
        return data
    families = _read(data.get("axes", ()))
    if families is None:  # which the model says; nothing is wrong with the references
        return {**data, **{name: [_placed_anywhere(name, part) for part in parts] for name, parts in attached.items()}}
    axes = {axis.name: axis for family in families for axis in family.axes}
    return {**data, **{name: [_attach_one(name, part, axes) for part in parts] for name, parts in attached.items()}}


def _reference(part: Any) -> Any:
    """Return the crossings that a part names, None if it is attached to none."""
    at = part.get("at") if isinstance(part, Mapping) else getattr(part, "at", None)
    return at or None


def _read(families: Any) -> list[AnyAxes] | None:
    """Return the families of axes, None if the kind of one is not known; raises FieldError with all their issues."""
    kinds = sections_by_kind((StraightAxes, RayAxes, RingAxes))
    axes_read, issues = list[AnyAxes](), list[RelativeIssue]()
    for position, family in enumerate(families if isinstance(families, list | tuple) else ()):
        kind = family.get("kind") if isinstance(family, Mapping) else getattr(family, "kind", None)
        if not isinstance(kind, str) or kind not in kinds:
            return None
        try:
            axes_read.append(kinds[kind].read(family, from_file=False))
        except FieldError as error:
            issues += [issue.below(("axes", position)) for issue in error.relative_issues]
    if issues:
        raise FieldError(*issues)
    return axes_read


def _placed_anywhere(name: str, part: Any) -> Any:
    """Return a part with some place where its axes are not known, so that only these are at fault."""
    if _reference(part) is None or not isinstance(part, Mapping):
        return part
    is_point = name == "columns" or part.get("kind") in AT_POINT
    keys = _place_keys([(0.0, 0.0), (1.0, 0.0)], is_point)
    return {key: value for key, value in part.items() if key != "at"} | {k: _written(v) for k, v in keys.items()}


def _attach_one(name: str, part: Any, axes: Mapping[str, Axis]) -> Any:
    """Return a part that is attached to axes with its place, or with its issues if the reference is wrong."""
    at = _reference(part)
    if at is None:
        return part
    kind = part.get("kind") if isinstance(part, Mapping) else getattr(part, "kind", None)
    is_point = name == "columns" or kind in AT_POINT
    if not is_point and name in ("loads", "supports") and kind not in ALONG_LINE:
        return part  # it has no such key, which is said where it is read
    issues: tuple[RelativeIssue, ...] = ()
    places = list[Place]()
    try:
        places = [find_crossing(text, axes) for text in ((at,) if is_point else _texts(at))]
    except FieldError as error:
        issues = error.relative_issues
    keys = _place_keys(places or [(0.0, 0.0), (1.0, 0.0)], is_point)
    if not isinstance(part, Mapping):
        if not issues:
            return part.model_copy(update=keys)
        part = dict(part)
    else:
        issues = issues or tuple(_find_other_place(part, keys))
        keys = {key: _written(value) for key, value in keys.items()}
    return {**part, **keys, **({"at": InvalidCrossing(issues)} if issues else {})}


def _texts(at: Any) -> Sequence[Any]:
    """Return the crossings through which a line runs; raises FieldError if they are no list."""
    if not isinstance(at, list | tuple):
        raise FieldError(RelativeIssue((), describe(at), 'a list of crossings such as ["A/1", "A/4"]'))
    return at


def _place_keys(places: Sequence[Place], is_point: bool) -> dict[str, Any]:
    """Return the keys that say where a part is."""
    return {"x": places[0][0], "y": places[0][1]} if is_point else {"points": tuple(places)}


def _written(value: Any) -> Any:
    """Return a length, or a list of places, as files have them."""
    if isinstance(value, float):
        return units.write(value, "length")
    return [[units.write(length, "length") for length in place] for place in value]


def _find_other_place(part: Mapping[Any, Any], coordinates: Mapping[str, Any]) -> Iterator[RelativeIssue]:
    """Find a place that is given beside the axes, and is another one."""
    for key, value in coordinates.items():
        if key in part and not _is_same(part[key], value):
            hint = "the axes say where it is"
            yield RelativeIssue((), f"axes together with {key}", "one of them", hint, (remove((), label="remove at"),))
            return


def _is_same(entry: Any, value: Any) -> bool:
    """Whether a length or a list of places, as files or Python have them, is a value [m]."""
    if isinstance(value, float):
        try:
            length: float = units.parse(entry, "length") if isinstance(entry, str) else float(entry)
        except (TypeError, ValueError):
            return False
        return bool(abs(length - value) <= SAME)
    if not isinstance(entry, list | tuple) or len(entry) != len(value):
        return False
    return all(_is_same(part, other) for part, other in zip(entry, value, strict=True))


def find_crossing(text: Any, axes: Mapping[str, Axis]) -> Place:
    """Return where the axes cross that a text names [m]; raises FieldError if they do so nowhere, or twice."""
    expected = 'the names of two axes that cross, such as "B/3"'
    if not isinstance(text, str) or text.count(BETWEEN) != 1:
        raise FieldError(RelativeIssue((), describe(text), expected))
    names = [name.strip() for name in text.split(BETWEEN)]
    for name in names:
        if name not in axes:
            named = f"one of the axes {one_of(list(axes))}" if axes else "axes, and [[axes]] that says where they are"
            unknown_axis = f"{describe(text)}, and no axis {describe(name)}"
            raise FieldError(RelativeIssue((), unknown_axis, named, suggestion(name, axes)))
    places = crossings(axes[names[0]], axes[names[1]])
    if len(places) == 1:
        return places[0]
    meeting = "that cross at two places" if places else "that do not cross"
    hint = "rays cross rings once; give x and y" if places else ""
    raise FieldError(RelativeIssue((), f"{describe(text)}, axes {meeting}", expected, hint))


def name_of_crossing(place: Place, axes: Sequence[AnyAxes]) -> str:
    """Return the names of the axes that cross at a place, in the order of the axes; empty if none do."""
    near = [axis.name for family in axes for axis in family.axes if _runs_through(axis, place)]
    return BETWEEN.join(near[:2]) if len(near) > 1 else ""


def _runs_through(axis: Axis, place: Place) -> bool:
    """Whether an axis runs through a place."""
    dx, dy = place[0] - axis.place[0], place[1] - axis.place[1]
    if axis.direction is None:
        return abs(math.hypot(dx, dy) - axis.radius) <= SAME
    u, v = axis.direction
    return abs(dx * v - dy * u) <= SAME and (not axis.ray or dx * u + dy * v >= -SAME)
