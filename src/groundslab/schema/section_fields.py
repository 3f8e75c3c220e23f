"""Fields of sections, as their annotations describe them, found out when they are first needed."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache, partial
from typing import Annotated, Any, Literal, TypeVar, get_args, get_origin, get_type_hints

from groundslab.schema.fields import FieldType
from groundslab.schema.wording import listed

#: The default of a field that must be given.
REQUIRED: Any = inspect.Parameter.empty
T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class Table:
    """Meaning of a field that holds sections, or the tag of a kind, in its ``Annotated``; and the most in a list."""

    meaning: str
    most: int = 1000


@dataclass(frozen=True, slots=True)
class ByKind:
    """Annotation of a union of sections: what a table or a section is called that says which one it is.

    That is the kind which it states, or what `kind_of` returns, the name of a class.
    """

    kind_of: Callable[[Any], str | None] | None = None

    def choose(self, value: Any, parts: tuple[type[Any], ...]) -> type[Any] | None:
        """Return the section that a value describes, or is, None if it says none of them."""
        if self.kind_of is not None:
            kind = self.kind_of(value)
            return next((part for part in parts if part.__name__ == kind), None)
        kind = _kind(value)
        return None if kind is None else sections_by_kind(parts).get(kind)


def _kind(value: Any) -> str | None:
    """Return the kind that a table or a section states, for unions of sections; None if there is none."""
    kind = value.get("kind") if isinstance(value, Mapping) else getattr(value, "kind", None)
    # only text is returned: anything else cannot be a kind, however deep it is nested
    return kind if isinstance(kind, str) else None


@cache
def sections_by_kind(parts: tuple[type[Any], ...]) -> dict[str, type[Any]]:
    """Return the sections of a union by their kinds."""
    return {part.kind: part for part in parts if hasattr(part, "kind")}


@dataclass(frozen=True, slots=True)
class NestedSections:
    """Sections that a field may hold, one or a list of them; none for a field that holds a value."""

    parts: tuple[type[Any], ...]
    many: bool


@dataclass(frozen=True, slots=True, eq=False)
class Field:
    """A field of a section: its default, whether it may be None, and what it holds: a value, sections, or a tag."""

    default: Any
    optional: bool
    type: FieldType | None
    sections: NestedSections
    table: Table | None
    by_kind: ByKind | None

    @property
    def required(self) -> bool:
        """Whether the field must be given."""
        return self.default is REQUIRED

    @property
    def meaning(self) -> str:
        """What the field means."""
        about = self.type or self.table
        return about.meaning if about is not None else ""

    @property
    def most(self) -> int | None:
        """How many sections the field may hold, None if it holds no list of sections."""
        return self.table.most if self.table is not None and self.sections.many else None

    @property
    def is_tag(self) -> bool:
        """Whether the field only says of which kind its section is."""
        return self.type is None and not self.sections.parts


def _field(annotation: Any, default: Any) -> Field:
    """Return what an annotation and a default say of a field."""
    metadata: list[Any] = []
    parts: list[type[Any]] = []
    many = False

    def walk(node: Any) -> None:
        nonlocal many
        origin = get_origin(node)
        if origin is Annotated:
            inner, *about = get_args(node)
            metadata.extend(about)
            walk(inner)
        elif isinstance(node, SectionType):
            parts.append(node)
        elif origin is not Literal:
            many = many or origin is tuple
            for argument in get_args(node):
                walk(argument)

    walk(annotation)
    bare = get_args(annotation)[0] if get_origin(annotation) is Annotated else annotation
    first = partial(_first, metadata)
    sections = NestedSections(tuple(parts), many and bool(parts))
    return Field(default, type(None) in get_args(bare), first(FieldType), sections, first(Table), first(ByKind))


def _first(items: list[Any], kind: type[T]) -> T | None:
    """Return the first of some items that is of a kind."""
    return next((item for item in items if isinstance(item, kind)), None)


class SectionType(type):
    """The class of sections: what their annotations say is found out when it is first needed, not at import."""

    field_defaults: dict[str, Any]

    def __init__(cls, name: str, bases: tuple[type, ...], namespace: dict[str, Any]) -> None:
        super().__init__(name, bases, namespace)
        cls.field_defaults = {
            key: vars(base).get(key, REQUIRED)
            for base in reversed(cls.__mro__)
            for key, annotation in inspect.get_annotations(base).items()
            if not str(annotation).startswith("ClassVar")
        }

    @property
    def model_fields(cls) -> dict[str, Field]:
        """Return the fields by their names."""
        return _fields(cls)

    @property
    def __doc__(cls) -> str | None:  # type: ignore[override]
        """Return the docstring with the fields in it, as numpydoc writes parameters."""
        return _docstring(cls)

    @property
    def __signature__(cls) -> inspect.Signature:
        """Return the signature of the constructor."""
        keyword = inspect.Parameter.KEYWORD_ONLY
        return inspect.Signature(
            [inspect.Parameter(name, keyword, default=default) for name, default in cls.field_defaults.items()]
        )


@cache
def _fields(cls: SectionType) -> dict[str, Field]:
    hints = get_type_hints(cls, include_extras=True)
    return {name: _field(hints[name], default) for name, default in cls.field_defaults.items()}


@cache
def _docstring(cls: SectionType) -> str:
    lines = []
    for name, field in cls.model_fields.items():
        key, inner = field.type, field.sections
        kinds = listed(part.__name__ for part in inner.parts) if inner.parts else "str"
        kind = key.type_text().replace("`", "") if key else f"list of {kinds}" if inner.many else kinds
        within = f" ({key.range_text()})" if key and key.range_text() else ""
        lines += [
            f"{name} : {kind}{'' if field.required else ', optional'}",
            f"    {field.meaning}{within}",
        ]
    raises = ["", "Raises", "------", "InputError", "    With all issues of the input."]
    return "\n".join([summary_of(cls), "", "Parameters", "----------", *lines, *raises])


def summary_of(cls: type) -> str:
    """Return the first paragraph of the docstring as it is written."""
    return inspect.cleandoc(vars(cls).get("__doc__") or "").split("\n\n")[0]
