"""Reference of the input: the fields of sections as JSON schema for editors and as Markdown for people."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from groundslab import units
from groundslab.schema.base import Section
from groundslab.schema.fields import FieldType, ListOf, Quantity
from groundslab.schema.section_fields import Field


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


def _part_schema(part: type[Section], definitions: dict[str, Any]) -> dict[str, Any]:
    properties = {name: _field_schema(field, definitions) for name, field in part.model_fields.items()}
    for (key, value), names in part.only_if.items():
        for name in names:
            properties[name] = {**properties[name], "x-only-if": {key: value}}
    # the tag of a kind is required in a file, although Python knows it from the class
    required = [name for name, field in part.model_fields.items() if field.required or field.is_tag]
    # keys that follow from another one are not required where that is given
    either = {
        name: missing for name, keys in part.follow.items() if (missing := [key for key in keys if key in required])
    }
    required = [name for name in required if not any(name in keys for keys in either.values())]
    choices = [{"anyOf": [{"required": keys}, {"required": [name]}]} for name, keys in either.items()]
    return {
        "type": "object",
        "description": part.summary(),
        "properties": properties,
        "additionalProperties": False,
        **({"required": required} if required else {}),
        **({"allOf": choices} if choices else {}),
    }


def _field_schema(field: Field, definitions: dict[str, Any]) -> dict[str, Any]:
    key, about = field.type, field.meaning
    if key is not None:
        named = f"{key.symbol}: {about}" if key.symbol else about
        symbol = {"x-symbol": key.symbol} if key.symbol else {}
        return {"description": named, **key.json_schema(), **symbol, **_default_schema(field, key)}
    if field.is_tag:
        return {"description": about, "const": field.default}
    inner = field.sections
    for part in inner.parts:
        if part.__name__ not in definitions:
            definitions[part.__name__] = {}  # reserved, so that it is not entered twice
            definitions[part.__name__] = _part_schema(part, definitions)
    references = [{"$ref": f"#/definitions/{part.__name__}"} for part in inner.parts]
    item = references[0] if len(references) == 1 else {"oneOf": references}
    if inner.many:
        least = {"minItems": 1} if field.required else {}
        return {"description": about, "type": "array", "items": item, **least, "maxItems": field.most}
    return {"description": about, "allOf": [item]} if len(references) == 1 else {"description": about, **item}


def _default_schema(field: Field, key: FieldType) -> dict[str, Any]:
    default = field.default
    if field.required or default is None:
        return {}
    return {"default": _written(key, default)}


def _written(key: FieldType, value: Any) -> Any:
    """Return a value as a file has it, quantities in usual units where these say the same."""
    if isinstance(key, ListOf) and isinstance(value, tuple):
        return [_written(key.each, item) for item in value]
    if not isinstance(key, Quantity) or isinstance(value, str):
        return value
    shown = units.show(value, key.dimension)
    return shown if units.parse(shown, key.dimension) == value else units.write(value, key.dimension)


def _tables(part: type[Section], path: str, kind: str, about: str) -> Iterator[str]:
    """Yield the lines of the table of a part's keys, then those of the parts in it."""
    fields = part.model_fields
    rows = [(name, field) for name, field in fields.items() if not field.sections.parts]
    yield f"### {_heading(path, kind)}\n"
    if about:
        yield f"{about[0].upper()}{about[1:]}.\n"
    yield "| key | symbol | type, dimension | range | default | meaning |\n|---|---|---|---|---|---|"
    yield from (_row(f"{path}.{name}".lstrip("."), field) for name, field in rows)
    yield ""
    for name, field in fields.items():
        inner = field.sections
        below = f"{path}.{name}".lstrip(".") + ("[]" if inner.many else "")
        for section in inner.parts:
            tag = next((field for field in section.model_fields.values() if field.is_tag), None)
            which = f"given by {', '.join(_needed(section))}" if len(inner.parts) > 1 and not tag else ""
            names = (kind if path else "", f'kind = "{tag.default}"' if tag else "", which)
            meaning = tag.meaning if tag else field.meaning
            meaning += f" (at most {field.most:,} in the list)" if inner.many else ""
            yield from _tables(section, below, ", ".join(filter(None, names)), meaning)


def _needed(part: type[Section]) -> list[str]:
    return [name for name, field in part.model_fields.items() if field.required]


def _heading(path: str, kind: str) -> str:
    if not path:
        return "At the top of the file"
    *outer, last = path.split(".")
    name = ".".join((*outer, last.removesuffix("[]"))).replace("[]", "")
    table = f"`[[{name}]]`" if last.endswith("[]") else f"`[{name}]`"
    return f"{table} {kind}".strip()


def _row(path: str, field: Field) -> str:
    key = field.type
    if key is None:
        return f'| `{path}` |  | `"{field.default}"` |  | needed | says which kind it is |'
    default = field.default
    value = "needed" if field.required else "" if default in (None, "") else f"`{_short(key, default)}`"
    symbol = key.symbol and f"`{key.symbol}`"
    cells = f"`{path}`", symbol, key.type_text(), key.range_text(), value, key.meaning
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def _short(key: FieldType, default: Any) -> str:
    written = key.write(default)
    return f"{default:.4g}" if isinstance(default, float) and not written.startswith('"') else written
