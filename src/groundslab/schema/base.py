"""The base of all parts of a description: checked between fields as well, and all faults told at once."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache, lru_cache
from typing import Annotated, Any, ClassVar, Self, get_args, get_origin

from pydantic import (
    BaseModel,
    ConfigDict,
    TypeAdapter,
    ValidationError,
    ValidationInfo,
    model_validator,
)
from pydantic.fields import FieldInfo
from pydantic.functional_validators import ModelWrapValidatorHandler

from groundslab.errors import InputError
from groundslab.schema.fields import MOST_ISSUES, FieldType, is_from_file
from groundslab.schema.issues import FieldError, RelativeIssue
from groundslab.schema.wording import describe, listed, quote, suggestion

MOST_KEYS = 1000  # of one table; those that are too many are not named one by one


@dataclass(frozen=True, slots=True)
class Table:
    """Says in the ``Annotated`` of a field that holds other parts (or the tag of a kind) what it means.

    Of a list of parts, how many there may be at most.
    """

    meaning: str
    most: int = 1000


@dataclass(frozen=True, slots=True)
class Nested:
    """Which parts a field may hold, one or a list of them; empty ``parts`` for a field that holds a value."""

    parts: tuple[type[Section], ...]
    many: bool


def nested(field: FieldInfo) -> Nested:
    """Return the parts that a field may hold."""
    found: list[type[Section]] = []
    many = False

    def walk(annotation: Any) -> None:
        nonlocal many
        many = many or get_origin(annotation) is tuple
        if isinstance(annotation, type) and issubclass(annotation, Section):
            found.append(annotation)
        elif get_origin(annotation) is Annotated:
            walk(get_args(annotation)[0])
        else:
            for argument in get_args(annotation):
                walk(argument)

    walk(field.annotation)
    return Nested(tuple(found), many and bool(found))


def key_of(field: FieldInfo) -> FieldType | None:
    """Return the kind of key that a field states, None for one that holds parts or a tag."""
    return next((item for item in field.metadata if isinstance(item, FieldType)), None)


def most_of(field: FieldInfo) -> int | None:
    """Return how many parts a field may hold, None for one that holds no list of parts."""
    return next((item.most for item in field.metadata if isinstance(item, Table) and nested(field).many), None)


def meaning_of(field: FieldInfo) -> str:
    """Return what a field means."""
    return next((item.meaning for item in field.metadata if isinstance(item, FieldType | Table)), "")


#: A check names in its parameters the fields that it needs, and yields findings; ``given`` are the keys set.
Check = Callable[..., Iterator[RelativeIssue]]


class Section(BaseModel):
    """The base of all parts of a description: frozen, no unknown keys, all faults at once as InputError."""

    model_config = ConfigDict(frozen=True, extra="forbid", arbitrary_types_allowed=False)

    checks: ClassVar[tuple[Check, ...]] = ()

    def __init__(self, **data: Any) -> None:
        """Check the data; raises InputError with all faults."""
        try:
            super().__init__(**data)
        except ValidationError as error:
            refused = self._input_error(error)
        else:
            return
        # raised out here it does not carry pydantic's error with all of the data along as its context
        raise refused

    # so that pydantic does not call __init__ for a part within a part, whose faults must reach the outer one
    __init__.__pydantic_base_init__ = True  # type: ignore[attr-defined]

    @classmethod
    def model_validate(cls, obj: Any, **options: Any) -> Self:
        """Return the part that ``obj`` describes; raises InputError with all faults."""
        try:
            return super().model_validate(obj, **options)
        except ValidationError as error:
            refused = cls._input_error(error)
        raise refused

    def replace(self, **changes: Any) -> Self:
        """Return the part with some fields changed, checked anew; None takes away what is given for a field."""
        return type(self)(**{name: value for name, value in {**dict(self), **changes}.items() if value is not None})

    @classmethod
    def root(cls) -> str:
        """Return what the paths of faults start with when the part is built on its own."""
        return cls.__name__

    @classmethod
    def _input_error(cls, error: ValidationError) -> InputError:
        relative_issues = _translate(cls, error)
        return InputError([relative.issue(cls.root()) for relative in relative_issues])

    @model_validator(mode="wrap")
    @classmethod
    def _all_at_once(cls, data: Any, handler: ModelWrapValidatorHandler[Self], info: ValidationInfo) -> Self:
        """Run the checks between fields even where some fields are wrong: those that need only sound ones."""
        if isinstance(data, cls):
            return handler(data)
        # of a list far too long nothing else is said, as all that could be takes long to find
        if too_long := _too_long(cls, data):
            raise FieldError(*too_long)
        made, relative_issues = None, []
        try:
            made = handler(data)
        except ValidationError as error:
            relative_issues = _translate(cls, error)
            if not isinstance(data, Mapping):
                raise FieldError(*relative_issues) from None
            sound = _sound(cls, data, {str(line["loc"][0]) for line in _lines(error) if line["loc"]}, info.context)
        else:
            sound = dict(made)
        from_file = is_from_file(info.context)
        fields = cls.model_fields
        sound["given"] = {
            name
            for name in data
            if name in fields and (from_file or name not in sound or sound[name] != fields[name].default)
        }
        for check in cls.checks:
            needs = _needs(check)
            if sound.keys() >= needs:
                relative_issues += check(**{name: sound[name] for name in needs})
        if made is None or relative_issues:
            raise FieldError(*_first(relative_issues))
        return made


def kind_of(value: Any) -> str | None:
    """Return the kind that a table or a part says it is, for unions of parts; None if it does not say."""
    kind = value.get("kind") if isinstance(value, Mapping) else getattr(value, "kind", None)
    # a kind that is no text is not handed on: pydantic would print it, however deep it is nested
    return kind if isinstance(kind, str) else None


@cache
def _needs(check: Check) -> frozenset[str]:
    """Return the names of the fields that a check needs."""
    return frozenset(inspect.signature(check).parameters)


def _too_long(cls: type[Section], data: Any) -> list[RelativeIssue]:
    """Return which lists of parts hold too many of them, or that there are too many keys."""
    if not isinstance(data, Mapping):
        return []
    if len(data) > MOST_KEYS:
        return [RelativeIssue((), f"a table of {len(data)} keys", f"some of {', '.join(cls.model_fields)}")]
    given = {name: data[name] for name in _most_of_lists(cls) if isinstance(data.get(name), list | tuple)}
    most = _most_of_lists(cls)
    return [
        RelativeIssue((name,), describe(value), f"at most {most[name]}") for name, value in given.items()
        if len(value) > most[name]
    ]  # fmt: skip


@cache
def _most_of_lists(cls: type[Section]) -> dict[str, int]:
    """Return how many parts each list of a part may hold."""
    return {name: most for name, field in cls.model_fields.items() if (most := most_of(field)) is not None}


def _lines(error: ValidationError) -> list[Any]:
    return error.errors(include_url=False)


def _sound(cls: type[Section], data: Mapping[Any, Any], broken: set[str], context: Any) -> dict[str, Any]:
    """Return the fields that are right although others of the same part are wrong."""
    sound = {}
    for name, field in cls.model_fields.items():
        if name in broken:
            continue
        if name not in data:
            sound[name] = field.get_default(call_default_factory=True)
        else:
            try:
                sound[name] = _adapter(cls, name).validate_python(data[name], context=context)
            except ValidationError:  # pragma: no cover - it was right a moment ago
                continue
    return sound


@lru_cache(maxsize=512)
def _adapter(cls: type[Section], name: str) -> TypeAdapter[Any]:
    field = cls.model_fields[name]
    annotation: Any = Annotated[field.annotation, field]
    return TypeAdapter(annotation)


def _translate(cls: type[Section], error: ValidationError) -> list[RelativeIssue]:
    """Return pydantic's errors of one part as findings."""
    relative_issues: list[RelativeIssue] = []
    # pydantic calls a list too short as well when none of its entries is right
    lines = [line for line in _lines(error) if line["type"] != "too_short" or not line["input"]]
    for line in lines[:MOST_ISSUES]:
        # below a field's name only positions are ours; the words are the tags of unions
        head, tail = line["loc"][:1], line["loc"][1:]
        place = (*head, *(step for step in tail if isinstance(step, int)))
        cause = line.get("ctx", {}).get("error")
        if isinstance(cause, FieldError):
            relative_issues += [relative.below(place) for relative in cause.relative_issues]
        else:
            relative_issues.append(_finding(cls, place, line))
    if len(lines) > MOST_ISSUES:
        relative_issues.append(RelativeIssue((), f"{len(lines)} faults", f"at most {MOST_ISSUES} of them to be told"))
    return relative_issues


def _first(relative_issues: list[RelativeIssue]) -> list[RelativeIssue]:
    """Return as many findings as can be told of one part, and that there are more."""
    if len(relative_issues) <= MOST_ISSUES + 1:  # of what it holds, so many have been told already
        return relative_issues
    more = RelativeIssue((), f"{len(relative_issues)} faults", f"at most {MOST_ISSUES} of them to be told")
    return [*relative_issues[:MOST_ISSUES], more]


def _no_table(place: tuple[str | int, ...], value: object) -> RelativeIssue:
    listed_once = isinstance(value, list) and not (place and isinstance(place[-1], int))
    return RelativeIssue(
        place, describe(value), "a table of keys", "write single brackets: [...]" if listed_once else ""
    )


def _finding(cls: type[Section], place: tuple[str | int, ...], line: Any) -> RelativeIssue:
    """Return one of pydantic's own errors as a finding."""
    kind, value = line["type"], line["input"]
    if kind in ("extra_forbidden", "invalid_key"):
        known = list(cls.model_fields)
        meant = suggestion(place[0], known)
        return RelativeIssue(tuple(map(str, place)), "an unknown key", f"one of {', '.join(known)}", meant)
    field = cls.model_fields.get(str(place[0])) if place else None
    if field is None:
        return _no_table(place, value)
    inner = nested(field)
    if kind in ("missing", "too_short"):
        key = key_of(field)
        table = "at least one table" if inner.many else "a table"
        if not cls.root():
            table += f" [[{place[0]}]]" if inner.many else f" [{place[0]}]"
        return RelativeIssue(place, describe(None if kind == "missing" else value), key.expected() if key else table)
    if kind in ("union_tag_invalid", "union_tag_not_found") and isinstance(value, Mapping):
        tags = [str(part.model_fields["kind"].default) for part in inner.parts if "kind" in part.model_fields]
        given = value.get("kind")
        return RelativeIssue((*place, "kind"), describe(given), listed(map(quote, tags)), suggestion(given, tags))
    if inner.many and len(place) == 1:
        hint = "write double brackets: [[...]]" if isinstance(value, Mapping) else ""
        return RelativeIssue(place, describe(value), "a list of tables", hint)
    if inner.parts:
        return _no_table(place, value)
    if kind == "literal_error":
        return RelativeIssue(place, describe(value), line["ctx"]["expected"].replace("'", '"'))
    return RelativeIssue(place, describe(value), line["msg"])
