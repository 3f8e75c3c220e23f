"""Reference of the input: the fields of sections as JSON schema for editors and as Markdown for people."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from pydantic.fields import FieldInfo

from groundslab.schema.base import Section, get_field_type, get_meaning, get_most_sections, get_sections
from groundslab.schema.fields import FieldType


def json_schema(root: type[Section], title: str) -> dict[str, Any]:
    """Return the JSON schema (draft 7) of a file that describes ``root``."""
    definitions: dict[str, Any] = {}
    top = _part_schema(root, definitions)
    return {
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": title,
        **top,
        "definitions": dict(sorted(definitions.items())),
    }


def docs_table(root: type[Section]) -> str:
    """Return all keys below ``root`` as Markdown, one table per section and kind."""
    return "\n".join(_tables(root, "", "", "")).strip() + "\n"


def default_of(field: FieldInfo) -> Any:
    """Return a field's default, None if there is none."""
    return None if field.is_required() else field.get_default(call_default_factory=True)


def _part_schema(part: type[Section], definitions: dict[str, Any]) -> dict[str, Any]:
    properties = {name: _field_schema(field, definitions) for name, field in part.model_fields.items()}
    # the tag of a kind is required in a file, although Python knows it from the class
    required = [name for name, field in part.model_fields.items() if field.is_required() or _is_tag(field)]
    return {
        "type": "object",
        "description": part.summary(),
        "properties": properties,
        "additionalProperties": False,
        **({"required": required} if required else {}),
    }


def _field_schema(field: FieldInfo, definitions: dict[str, Any]) -> dict[str, Any]:
    key, about = get_field_type(field), get_meaning(field)
    if key is not None:
        named = f"{key.symbol}: {about}" if key.symbol else about
        symbol = {"x-symbol": key.symbol} if key.symbol else {}
        return {"description": named, **key.json_schema(), **symbol, **_default_schema(field, key)}
    if _is_tag(field):
        return {"description": about, "const": field.default}
    inner = get_sections(field)
    for part in inner.parts:
        if part.__name__ not in definitions:
            definitions[part.__name__] = {}  # reserved, so that it is not entered twice
            definitions[part.__name__] = _part_schema(part, definitions)
    references = [{"$ref": f"#/definitions/{part.__name__}"} for part in inner.parts]
    one = references[0] if len(references) == 1 else {"oneOf": references}
    if inner.many:
        least = {"minItems": 1} if field.is_required() else {}
        return {"description": about, "type": "array", "items": one, **least, "maxItems": get_most_sections(field)}
    return {"description": about, "allOf": [one]} if len(references) == 1 else {"description": about, **one}


def _default_schema(field: FieldInfo, key: FieldType) -> dict[str, Any]:
    default = default_of(field)
    if default is None:
        return {}
    written = key.write(default)
    # a quantity's default is text in a file
    return {"default": written.strip('"') if isinstance(default, float) and written.startswith('"') else default}


def _is_tag(field: FieldInfo) -> bool:
    """Whether a field only says of which kind its part is."""
    return get_field_type(field) is None and not get_sections(field).parts


def _tables(part: type[Section], path: str, kind: str, about: str) -> Iterator[str]:
    """Yield the lines of the table of a part's keys, then those of the parts in it."""
    fields = part.model_fields
    rows = [(name, field) for name, field in fields.items() if not get_sections(field).parts]
    yield f"### {_heading(path, kind)}\n"
    if about:
        yield f"{about[0].upper()}{about[1:]}.\n"
    yield "| key | symbol | type, dimension | range | default | meaning |\n|---|---|---|---|---|---|"
    yield from (_row(f"{path}.{name}".lstrip("."), field) for name, field in rows)
    yield ""
    for name, field in fields.items():
        inner = get_sections(field)
        below = f"{path}.{name}".lstrip(".") + ("[]" if inner.many else "")
        for section in inner.parts:
            tag = next((field for field in section.model_fields.values() if _is_tag(field)), None)
            which = f"given by {', '.join(_needed(section))}" if len(inner.parts) > 1 and not tag else ""
            names = (kind if path else "", f'kind = "{tag.default}"' if tag else "", which)
            meaning = get_meaning(tag) if tag else get_meaning(field)
            meaning += f" (at most {get_most_sections(field):,} in the list)" if inner.many else ""
            yield from _tables(section, below, ", ".join(filter(None, names)), meaning)


def _needed(part: type[Section]) -> list[str]:
    return [name for name, field in part.model_fields.items() if field.is_required()]


def _heading(path: str, kind: str) -> str:
    if not path:
        return "At the top of the file"
    *outer, last = path.split(".")
    name = ".".join((*outer, last.removesuffix("[]"))).replace("[]", "")
    table = f"`[[{name}]]`" if last.endswith("[]") else f"`[{name}]`"
    return f"{table} {kind}".strip()


def _row(path: str, field: FieldInfo) -> str:
    key = get_field_type(field)
    if key is None:
        return f'| `{path}` |  | `"{field.default}"` |  | needed | says which kind it is |'
    default = default_of(field)
    value = "needed" if field.is_required() else "" if default in (None, "") else f"`{_short(key, default)}`"
    symbol = key.symbol and f"`{key.symbol}`"
    cells = f"`{path}`", symbol, key.type_text(), key.range_text(), value, key.meaning
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def _short(key: FieldType, default: Any) -> str:
    written = key.write(default)
    return f"{default:.4g}" if isinstance(default, float) and not written.startswith('"') else written
