"""The shapes that docs/interface promises of what the commands print as JSON."""

from __future__ import annotations

import json
from functools import cache
from typing import Any

import pytest
from tests.helpers.paths import DOCS


def closed(schema: Any) -> Any:
    """Return a schema that allows no other keys than those it names."""
    if isinstance(schema, list):
        return [closed(part) for part in schema]
    if not isinstance(schema, dict):
        return schema
    named = {"additionalProperties": False} if "properties" in schema else {}
    return {**named, **{key: closed(part) for key, part in schema.items()}}


def validate(document: dict[str, Any], name: str) -> None:
    """Fail if a document does not have a shape, or has a key that the shape does not name."""
    _validator(name).validate(document)


@cache
def _validator(name: str) -> Any:
    """Return what validates by a shape, which is one."""
    jsonschema = pytest.importorskip("jsonschema")  # it takes seconds to load
    schema = json.loads((DOCS / "interface" / f"{name}.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(closed(schema))
