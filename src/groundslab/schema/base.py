"""Base class of all sections of a model: checks between fields, and all issues reported at once."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass
from functools import cache, lru_cache
from typing import Annotated, Any, ClassVar, Self, get_args, get_origin

from pydantic import (
    BaseModel,
    ConfigDict,
    GetCoreSchemaHandler,
    TypeAdapter,
    ValidationError,
    ValidationInfo,
    model_validator,
)
from pydantic.fields import FieldInfo
from pydantic.functional_validators import ModelWrapValidatorHandler
from pydantic_core import CoreSchema, core_schema

from groundslab.errors import InputError
from groundslab.schema.fields import MOST_ISSUES, FieldType, is_from_file
from groundslab.schema.issues import FieldError, RelativeIssue
from groundslab.schema.repairs import remove, rename_key, set_value, use_nearest
from groundslab.schema.wording import describe, find_nearest, listed, quote, suggestion

MOST_KEYS = 1000  # of one table; of more they are not named one by one


@dataclass(frozen=True, slots=True)
class Table:
    """Meaning of a field that holds sections, or the tag of a kind, in its ``Annotated``; and the most in a list."""

    meaning: str
    most: int = 1000


@dataclass(frozen=True, slots=True)
class NestedSections:
    """Sections that a field may hold, one or a list of them; none for a field that holds a value."""

    parts: tuple[type[Section], ...]
    many: bool


def get_sections(field: FieldInfo) -> NestedSections:
    """Return the sections that a field may hold."""
    sections: list[type[Section]] = []
    many = False

    def walk(annotation: Any) -> None:
        nonlocal many
        many = many or get_origin(annotation) is tuple
        if isinstance(annotation, type) and issubclass(annotation, Section):
            sections.append(annotation)
        elif get_origin(annotation) is Annotated:
            walk(get_args(annotation)[0])
        else:
            for argument in get_args(annotation):
                walk(argument)

    walk(field.annotation)
    return NestedSections(tuple(sections), many and bool(sections))


def get_field_type(field: FieldInfo) -> FieldType | None:
    """Return the type of a field that holds a value, None for one that holds sections or a tag."""
    return next((item for item in field.metadata if isinstance(item, FieldType)), None)


def get_most_sections(field: FieldInfo) -> int | None:
    """Return how many sections a field may hold, None for one that holds no list of sections."""
    return next((item.most for item in field.metadata if isinstance(item, Table) and get_sections(field).many), None)


def get_meaning(field: FieldInfo) -> str:
    """Return the meaning of a field."""
    return next((item.meaning for item in field.metadata if isinstance(item, FieldType | Table)), "")


#: A check has the fields that it needs as parameters, and yields issues; ``given`` are the keys that were set.
Check = Callable[..., Iterator[RelativeIssue]]


class Section(BaseModel):
    """A section of a model: immutable, without unknown keys, its issues reported at once as InputError."""

    model_config = ConfigDict(frozen=True, extra="forbid", arbitrary_types_allowed=False, defer_build=True)

    checks: ClassVar[tuple[Check, ...]] = ()

    def __init__(self, **data: Any) -> None:
        """Validate the data; raises InputError with all issues."""
        try:
            super().__init__(**data)
        except ValidationError as error:
            refused = self._input_error(error)
        else:
            return
        # raised here, it does not keep pydantic's error with all of the data as its context
        raise refused

    # so that pydantic does not call __init__ for a section within a section, whose issues belong to the outer one
    __init__.__pydantic_base_init__ = True  # type: ignore[attr-defined]

    @classmethod
    def __pydantic_init_subclass__(cls, **options: Any) -> None:
        """Add the fields to the docstring, as numpydoc writes parameters."""
        super().__pydantic_init_subclass__(**options)
        lines = []
        for name, field in cls.model_fields.items():
            key, inner = get_field_type(field), get_sections(field)
            kinds = listed(part.__name__ for part in inner.parts) if inner.parts else "str"
            kind = key.type_text().replace("`", "") if key else f"list of {kinds}" if inner.many else kinds
            within = f" ({key.range_text()})" if key and key.range_text() else ""
            lines += [
                f"{name} : {kind}{'' if field.is_required() else ', optional'}",
                f"    {get_meaning(field)}{within}",
            ]
        raises = ["", "Raises", "------", "InputError", "    With all issues of the input."]
        cls.__doc__ = "\n".join([cls.summary(), "", "Parameters", "----------", *lines, *raises])

    @classmethod
    def summary(cls) -> str:
        """Return the first paragraph of the docstring."""
        return (inspect.getdoc(cls) or "").split("\n\n")[0]

    @classmethod
    def model_validate(cls, obj: Any, **options: Any) -> Self:
        """Return the section that ``obj`` describes; raises InputError with all issues."""
        try:
            return super().model_validate(obj, **options)
        except ValidationError as error:
            refused = cls._input_error(error)
        raise refused

    def replace(self, **changes: Any) -> Self:
        """Return a copy with some fields changed, validated again.

        Parameters
        ----------
        **changes
            New values by field name; None resets a field to its default.

        Raises
        ------
        InputError
            With all issues of the changed section.
        """
        return type(self)(**{name: value for name, value in {**dict(self), **changes}.items() if value is not None})

    @classmethod
    def root(cls) -> str:
        """Return the start of the paths of issues when the section is built by itself."""
        return cls.__name__

    @classmethod
    def _input_error(cls, error: ValidationError) -> InputError:
        relative_issues = _translate(cls, error)
        return InputError([relative.issue(cls.root()) for relative in relative_issues])

    @model_validator(mode="wrap")
    @classmethod
    def _all_at_once(cls, data: Any, handler: ModelWrapValidatorHandler[Self], info: ValidationInfo) -> Self:
        """Run the checks between fields even where some fields are wrong: those that need valid ones only."""
        if isinstance(data, cls):
            return handler(data)
        # of a list far too long nothing else is said, as all that could be takes long to find
        if too_long := _too_long(cls, data):
            raise FieldError(*too_long)
        made, relative_issues = None, []
        try:
            made = handler(data)
        except ValidationError as error:
            relative_issues = _translate(cls, error, data if isinstance(data, Mapping) else ())
            if not isinstance(data, Mapping):
                raise FieldError(*relative_issues) from None
            broken = {str(line["loc"][0]) for line in error.errors(include_url=False) if line["loc"]}
            sound = _valid_fields(cls, data, broken, info.context)
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
            raise FieldError(*_limit_issues(relative_issues))
        return made


def get_kind(value: Any) -> str | None:
    """Return the kind that a table or a section states, for unions of sections; None if there is none."""
    kind = value.get("kind") if isinstance(value, Mapping) else getattr(value, "kind", None)
    # only text is returned: pydantic would print anything else, however deep it is nested
    return kind if isinstance(kind, str) else None


class ByKind:
    """Annotation of a union of sections, of which the kind that a table states says which one it is."""

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Let pydantic choose the section by its kind."""
        choices = {part.model_fields["kind"].default: handler.generate_schema(part) for part in get_args(source)}
        return core_schema.tagged_union_schema(choices, get_kind)


@cache
def _needs(check: Check) -> frozenset[str]:
    """Return the names of the fields that a check needs."""
    return frozenset(inspect.signature(check).parameters)


def _too_long(cls: type[Section], data: Any) -> list[RelativeIssue]:
    """Return issues of lists with too many sections, or of a table with too many keys."""
    if not isinstance(data, Mapping):
        return []
    if len(data) > MOST_KEYS:
        return [RelativeIssue((), f"a table of {len(data)} keys", f"some of {', '.join(cls.model_fields)}")]
    lists = ((name, data.get(name), most) for name, most in _most_of_lists(cls).items())
    return [
        RelativeIssue((name,), describe(value), f"at most {most}")
        for name, value, most in lists
        if isinstance(value, list | tuple) and len(value) > most
    ]


@cache
def _most_of_lists(cls: type[Section]) -> dict[str, int]:
    """Return how many sections each list of a section may hold."""
    return {name: most for name, field in cls.model_fields.items() if (most := get_most_sections(field)) is not None}


def _valid_fields(cls: type[Section], data: Mapping[Any, Any], broken: set[str], context: Any) -> dict[str, Any]:
    """Return the valid fields of a section of which others are wrong."""
    sound = {}
    for name, field in cls.model_fields.items():
        if name in broken:
            continue
        if name not in data:
            sound[name] = field.get_default(call_default_factory=True)
        else:
            try:
                sound[name] = _adapter(cls, name).validate_python(data[name], context=context)
            except ValidationError:  # pragma: no cover - it was valid a moment ago
                continue
    return sound


@lru_cache(maxsize=512)
def _adapter(cls: type[Section], name: str) -> TypeAdapter[Any]:
    field = cls.model_fields[name]
    annotation: Any = Annotated[field.annotation, field]
    return TypeAdapter(annotation)


def _translate(cls: type[Section], error: ValidationError, given: Collection[str] = ()) -> list[RelativeIssue]:
    """Return pydantic's errors of one section, in which some keys are given, as issues."""
    relative_issues: list[RelativeIssue] = []
    # pydantic calls a list too short as well when none of its entries is right
    lines = [line for line in error.errors(include_url=False) if line["type"] != "too_short" or not line["input"]]
    for line in lines[:MOST_ISSUES]:
        # below a field's name only positions belong to the path; names are the tags of unions
        head, tail = line["loc"][:1], line["loc"][1:]
        place = (*head, *(step for step in tail if isinstance(step, int)))
        cause = line.get("ctx", {}).get("error")
        if isinstance(cause, FieldError):
            relative_issues += [relative.below(place) for relative in cause.relative_issues]
        else:
            relative_issues.append(_to_issue(cls, place, line, given))
    if len(lines) > MOST_ISSUES:
        relative_issues.append(_too_many_issues(len(lines)))
    return relative_issues


def _limit_issues(relative_issues: list[RelativeIssue]) -> list[RelativeIssue]:
    """Return as many issues as are listed of one section, and that there are more."""
    if len(relative_issues) <= MOST_ISSUES + 1:  # those of a section within it are limited already
        return relative_issues
    return [*relative_issues[:MOST_ISSUES], _too_many_issues(len(relative_issues))]


def _too_many_issues(count: int) -> RelativeIssue:
    return RelativeIssue((), f"{count} issues", f"at most {MOST_ISSUES}, of which the first are listed")


def _not_a_table(place: tuple[str | int, ...], value: object) -> RelativeIssue:
    listed_once = isinstance(value, list) and not (place and isinstance(place[-1], int))
    return RelativeIssue(
        place, describe(value), "a table of keys", "write single brackets: [...]" if listed_once else ""
    )


def _to_issue(cls: type[Section], place: tuple[str | int, ...], line: Any, given: Collection[str]) -> RelativeIssue:
    """Return one of pydantic's own errors as an issue."""
    kind, value = line["type"], line["input"]
    if kind in ("extra_forbidden", "invalid_key"):
        known = list(cls.model_fields)
        own_place = tuple(map(str, place))
        meant = suggestion(place[0], known)
        nearest = find_nearest(place[0], known)
        renames = () if nearest is None or nearest in given else (rename_key(own_place, nearest),)
        repairs = (*renames, remove(own_place)) if own_place and own_place[0] in given else ()
        return RelativeIssue(own_place, "an unknown key", f"one of {', '.join(known)}", meant, repairs)
    field = cls.model_fields.get(str(place[0])) if place else None
    if field is None:
        return _not_a_table(place, value)
    inner = get_sections(field)
    if kind in ("missing", "too_short"):
        key = get_field_type(field)
        table = "at least one table" if inner.many else "a table"
        if not cls.root():
            table += f" [[{place[0]}]]" if inner.many else f" [{place[0]}]"
        return RelativeIssue(place, describe(None if kind == "missing" else value), key.expected() if key else table)
    if kind in ("union_tag_invalid", "union_tag_not_found") and isinstance(value, Mapping):
        tags = [str(part.model_fields["kind"].default) for part in inner.parts if "kind" in part.model_fields]
        given_kind = value.get("kind")
        tag_place = (*place, "kind")
        hint = suggestion(given_kind, tags)
        return RelativeIssue(
            tag_place, describe(given_kind), listed(map(quote, tags)), hint, use_nearest(tag_place, given_kind, tags)
        )
    if inner.many and len(place) == 1:
        hint = "write double brackets: [[...]]" if isinstance(value, Mapping) else ""
        is_flat = isinstance(value, Mapping) and all(isinstance(entry, str | int | float) for entry in value.values())
        repairs = (set_value(place, [dict(value)], "make it a list"),) if is_flat else ()
        return RelativeIssue(place, describe(value), "a list of tables", hint, repairs)
    if inner.parts:
        return _not_a_table(place, value)
    if kind == "literal_error":
        return RelativeIssue(place, describe(value), line["ctx"]["expected"].replace("'", '"'))
    return RelativeIssue(place, describe(value), line["msg"])
