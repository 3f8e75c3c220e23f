"""Writes the parts of docs/ that follow from the code: the table of keys in input.md, and the JSON schema."""

from __future__ import annotations

import json
from pathlib import Path

from groundslab.model import docs_table, json_schema

DOCS = Path(__file__).resolve().parent.parent / "docs"
BEGIN, END = "<!-- keys: begin -->", "<!-- keys: end -->"


def contents() -> dict[Path, str]:
    """Return what each of the files should hold."""
    page = DOCS / "input.md"
    text = page.read_text(encoding="utf-8")
    before, after = text.split(BEGIN)[0], text.split(END)[1]
    schema = json.dumps(json_schema(), indent=2)
    return {
        page: f"{before}{BEGIN}\n\n{docs_table()}\n{END}{after}",
        DOCS / "groundslab.schema.json": schema + "\n",
    }


if __name__ == "__main__":
    for path, text in contents().items():
        path.write_text(text, encoding="utf-8")
        print(path)
