"""Base class of all sections of a model: checks between fields, and all issues reported at once."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator, Mapping, Set
from dataclasses import FrozenInstanceError
from functools import cache, partial
from typing import TYPE_CHECKING, Any, ClassVar, Self

from groundslab.errors import InputError, Issue, Repair
from groundslab.schema.fields import MOST_ISSUES, as_plain
from groundslab.schema.issues import FieldError, RelativeIssue
from groundslab.schema.repairs import remove, rename_key, set_value, use_nearest
from groundslab.schema.section_fields import Field, SectionType, sections_by_kind, summary_of
from groundslab.schema.wording import describe, find_nearest, listed, quote, suggestion, with_article

if TYPE_CHECKING:
    from pydantic import GetCoreSchemaHandler
    from pydantic_core import CoreSchema

MOST_KEYS = 1000  # of one table; of more they are not named one by one
#: A check has the fields that it needs as parameters, and yields issues; ``given`` are the keys that were set.
Check = Callable[..., Iterator[RelativeIssue]]


class Section(metaclass=SectionType):
    """A section of a model: immutable, without unknown keys, its issues reported at once as InputError."""

    constraints: ClassVar[tuple[Check, ...]] = ()
    #: Keys that follow from another one where that is given: files need them then no more, and leave them out.
    follow: ClassVar[Mapping[str, tuple[str, ...]]] = {}
    #: Keys that mean something only where another one has a value: pages offer them there alone.
    only_if: ClassVar[Mapping[tuple[str, str], tuple[str, ...]]] = {}

    def __init__(self, *unnamed: Any, **data: Any) -> None:
        """Validate the data; raises InputError with all issues."""
        if unnamed:
            name, keys = type(self).__name__, [key for key in type(self).model_fields if key != "kind"]
            pairs = zip(keys, map(describe, unnamed), strict=False)
            hint = f"write {name}({', '.join(f'{key}={value}' for key, value in pairs)}), if that is what is meant"
            raise InputError([Issue(name, f"{len(unnamed)} values without names", "values by name", hint)])
        section = self._read_or_refuse(data, from_file=False)
        vars(self).update(vars(section))

    @classmethod
    def summary(cls) -> str:
        """Return the first paragraph of the docstring."""
        return summary_of(cls)

    @classmethod
    def model_validate(cls, obj: Any, *, from_file: bool = False) -> Self:
        """Return the section that ``obj`` describes; raises InputError with all issues.

        In files units are mandatory, and a key without effect is an issue.
        """
        return cls._read_or_refuse(obj, from_file)

    @classmethod
    def _read_or_refuse(cls, data: Any, from_file: bool) -> Self:
        """Return the section that data describe; raises InputError with all issues."""
        try:
            return cls.read(data, from_file)
        except FieldError as error:
            refused = InputError([relative.issue(cls.root()) for relative in error.relative_issues])
        # raised here, it does not keep the other error with all of the data as its context
        raise refused

    @classmethod
    def complete(cls, data: Mapping[Any, Any]) -> Mapping[Any, Any]:
        """Return the keys that are given with those that follow from them."""
        return data

    @classmethod
    def derive(cls, values: dict[str, Any], named: Set[Any]) -> dict[str, Any]:  # noqa: ARG003
        """Return the values of fields, with those that follow from others in place of defaults; some were named."""
        return values

    @classmethod
    def read(cls, data: Any, from_file: bool) -> Self:
        """Return the section that data describe, or are; raises FieldError.

        The checks between fields run even where some fields are wrong: those that need valid ones only.
        """
        if type(data) is cls:
            return data
        if isinstance(data, cls):
            subclass = f"a subclass, {type(data).__name__}, of {cls.__name__}"
            hint = "what a subclass computes would be solved, but be in no file: give the keys their values instead"
            raise FieldError(RelativeIssue((), subclass, f"{with_article(cls.__name__)} itself", hint))
        if not isinstance(data, Mapping):
            raise FieldError(_not_a_table((), data))
        # of a list far too long nothing else is said, as all that could be takes long to find
        if too_long := _too_long(cls, data):
            raise FieldError(*too_long)
        named = data.keys()
        data, fields = cls.complete(data), cls.model_fields
        faults: list[list[RelativeIssue]] = []
        sound: dict[str, Any] = {}
        for name, field in fields.items():
            if name not in data:
                if field.required:
                    faults.append([_none_given(cls, name, None)])
                else:
                    sound[name] = field.default
                continue
            before = len(faults)
            value = _read_field(cls, name, data[name], from_file, faults)
            if len(faults) == before:
                sound[name] = value
        faults += [[_unknown_key(cls, key, data)] for key in data if key not in fields]
        relative_issues = [issue for fault in faults[:MOST_ISSUES] for issue in fault]
        if len(faults) > MOST_ISSUES:
            relative_issues.append(_too_many_issues(len(faults)))
        given = {
            name
            for name in data
            if name in fields and (from_file or name not in sound or sound[name] != fields[name].default)
        }
        sound = cls.derive(sound, named)
        names = sound.keys() | {"given"}
        for check in cls.constraints:
            needs = _needs(check)
            if names >= needs:
                relative_issues += check(**{name: given if name == "given" else sound[name] for name in needs})
        relative_issues = _say_what_follows(cls, data, relative_issues)
        if relative_issues:
            raise FieldError(*_limit_issues(relative_issues))
        return cls._of(sound, named)

    @classmethod
    def _of(cls, values: Mapping[str, Any], keys: Any) -> Self:
        """Return a section with values of all fields, of which some were given."""
        section = object.__new__(cls)
        vars(section).update(values, _given=frozenset(keys))
        return section

    def replace(self, **changes: Any) -> Self:
        """Return a copy with some fields changed, validated again; a place that is changed follows no axes any more.

        Parameters
        ----------
        **changes
            New values by field name; None resets a field to its default.

        Raises
        ------
        InputError
            With all issues of the changed section.
        """
        left = dict.fromkeys(name for name, keys in self.follow.items() if changes.keys() & set(keys))
        named = {name: value for name, value in self if name in self.model_fields_set}
        values = {**named, **left, **changes}
        return type(self)(**{name: value for name, value in values.items() if value is not None})

    def with_derived(self, values: Mapping[str, Any]) -> Self:
        """Return a copy with values that follow from other sections where none are given: still none is given."""
        new = {name: value for name, value in values.items() if name not in self.model_fields_set}
        if all(getattr(self, name) == value for name, value in new.items()):
            return self
        copied = self.model_copy()
        vars(copied).update(new)
        return copied

    def model_copy(self, *, update: Mapping[str, Any] | None = None) -> Self:
        """Return a copy with some fields changed, unchecked."""
        copied = object.__new__(type(self))
        vars(copied).update(vars(self))
        if update:
            vars(copied).update(update, _given=self.model_fields_set | update.keys())
        return copied

    @property
    def model_fields_set(self) -> frozenset[str]:
        """Return the keys that were given."""
        keys: frozenset[str] = vars(self)["_given"]
        return keys

    def model_dump(self) -> dict[str, Any]:
        """Return the values of all fields in SI units, those of sections in it as such tables too."""
        return {name: _dump(value) for name, value in self}

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Let pydantic read and write sections within values of its own."""
        from pydantic_core import core_schema

        written = core_schema.plain_serializer_function_ser_schema(cls.model_dump)
        return core_schema.no_info_plain_validator_function(partial(cls.read, from_file=False), serialization=written)

    @classmethod
    def root(cls) -> str:
        """Return the start of the paths of issues when the section is built by itself."""
        return cls.__name__

    def __iter__(self) -> Iterator[tuple[str, Any]]:
        """Yield each field's name and value."""
        values = vars(self)
        return ((name, values[name]) for name in type(self).field_defaults)

    def __eq__(self, other: object) -> bool:
        """Whether another section is of the same class and has the same values."""
        if type(self) is not type(other):
            return NotImplemented
        mine, others = vars(self), vars(other)
        return self is other or all(mine[name] == others[name] for name in type(self).field_defaults)

    def __hash__(self) -> int:
        """Return a hash of class and values."""
        return hash((type(self), *(value for _, value in self)))

    def __repr__(self) -> str:
        """Return how the section is made."""
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in self)})"

    def __setattr__(self, name: str, value: Any) -> None:
        """Refuse: sections are immutable."""
        raise FrozenInstanceError(f"cannot assign to field {name!r}")

    def __delattr__(self, name: str) -> None:
        """Refuse: sections are immutable."""
        raise FrozenInstanceError(f"cannot delete field {name!r}")


def _dump(value: Any) -> Any:
    """Return a value with its sections as tables."""
    if isinstance(value, Section):
        return value.model_dump()
    return tuple(map(_dump, value)) if isinstance(value, tuple) else value


def _read_field(cls: type[Section], name: str, value: Any, from_file: bool, faults: list[list[RelativeIssue]]) -> Any:
    """Return the value of a field, or add its faults, one with all issues for each value or section that is wrong."""
    field, value = cls.model_fields[name], as_plain(value)
    if value is None and field.optional:
        return None
    if not field.sections.many:
        try:
            return _read_one(field, value, from_file)
        except FieldError as error:
            faults.append([relative.below((name,)) for relative in error.relative_issues])
            return None
    if not isinstance(value, list | tuple):
        faults.append([_not_a_list(name, value)])
        return None
    if not value and field.required:
        faults.append([_none_given(cls, name, value)])
    kept = []
    for position, item in enumerate(value):
        try:
            kept.append(_read_one(field, item, from_file))
        except FieldError as error:
            faults.append([relative.below((name, position)) for relative in error.relative_issues])
    return tuple(kept)


def _read_one(field: Field, value: Any, from_file: bool) -> Any:
    """Return a value of a field, or one of its sections; raises FieldError."""
    if field.type is not None:
        return field.type.read(value, from_file)
    parts = field.sections.parts
    if not parts:
        if not isinstance(value, str) or value != field.default:
            raise FieldError(RelativeIssue((), describe(value), quote(field.default)))
        return value
    part = parts[0] if field.by_kind is None else field.by_kind.choose(value, parts)
    if part is None:
        raise FieldError(_no_kind(parts, value))
    return part.read(value, from_file)


def _say_what_follows(
    cls: type[Section], data: Mapping[Any, Any], relative_issues: list[RelativeIssue]
) -> list[RelativeIssue]:
    """Return issues with one for each key whose keys that follow are lacking, instead of theirs."""
    alone = {name: keys for name, keys in cls.follow.items() if data.get(name) and not data.keys() & set(keys)}
    lacking = {key for keys in alone.values() for key in keys}
    others = [issue for issue in relative_issues if not lacking.intersection(issue.place[:1])]
    hint = f"it is found in a model alone: give the model a dict of these keys instead of a {cls.__name__}"
    return others + [
        RelativeIssue((name,), f"{describe(data[name])} without a model", listed(keys, "and"), hint)
        for name, keys in alone.items()
    ]


@cache
def _needs(check: Check) -> frozenset[str]:
    """Return the names of the fields that a check needs."""
    return frozenset(inspect.signature(check).parameters)


def _too_long(cls: type[Section], data: Mapping[Any, Any]) -> list[RelativeIssue]:
    """Return issues of lists with too many sections, or of a table with too many keys."""
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
    return {name: most for name, field in cls.model_fields.items() if (most := field.most) is not None}


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


def _not_a_list(name: str, value: object) -> RelativeIssue:
    """Return the issue of a value that should be a list of tables."""
    hint = "write double brackets: [[...]]" if isinstance(value, Mapping) else ""
    repairs: tuple[Repair, ...] = ()
    if isinstance(value, Mapping) and all(isinstance(entry, str | int | float) for entry in value.values()):
        repairs = (set_value((name,), [dict(value)], "make it a list"),)
    return RelativeIssue((name,), describe(value), "a list of tables", hint, repairs)


def _none_given(cls: type[Section], name: str, value: object) -> RelativeIssue:
    """Return the issue of a field that must be given and is not, or is an empty list."""
    field = cls.model_fields[name]
    if field.type is not None:
        return RelativeIssue((name,), describe(value), field.type.expected())
    many = field.sections.many
    header = "" if cls.root() else f" [[{name}]]" if many else f" [{name}]"
    return RelativeIssue((name,), describe(value), ("at least one table" if many else "a table") + header)


def _unknown_key(cls: type[Section], key: Any, data: Mapping[Any, Any]) -> RelativeIssue:
    """Return the issue of a key that a section does not have."""
    keys = list(cls.model_fields)
    place = (str(key),)
    nearest = find_nearest(key, keys)
    renames = () if nearest is None or nearest in data else (rename_key(place, nearest),)
    repairs = (*renames, remove(place)) if place[0] in data else ()
    return RelativeIssue(place, "an unknown key", f"one of {', '.join(keys)}", suggestion(key, keys), repairs)


def _no_kind(parts: tuple[type[Section], ...], value: Any) -> RelativeIssue:
    """Return the issue of a table, or of anything else, that is of none of the kinds of a union."""
    if not isinstance(value, Mapping):
        return _not_a_table((), value)
    tags = list(sections_by_kind(parts))
    kind = value.get("kind")
    hint, repairs = suggestion(kind, tags), use_nearest(("kind",), kind, tags)
    return RelativeIssue(("kind",), describe(kind), listed(map(quote, tags)), hint, repairs)
