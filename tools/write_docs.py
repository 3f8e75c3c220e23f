"""Write the generated parts of docs/: tables of keys in input.md and study.md, JSON schemas."""

from __future__ import annotations

import json
from pathlib import Path

from groundslab.model.model import docs_table, json_schema
from groundslab.study.definition import schema

DOCS = Path(__file__).resolve().parent.parent / "docs"


def contents() -> dict[Path, str]:
    """Return what each of the files should hold."""
    return {
        DOCS / "input.md": _page("input.md", keys=docs_table()),
        DOCS / "groundslab.schema.json": json.dumps(json_schema(), indent=2) + "\n",
        DOCS / "study.md": _page("study.md", keys=schema.docs_table(), kept=schema.kept_table()),
        DOCS / "study.schema.json": json.dumps(schema.json_schema(), indent=2) + "\n",
    }


def _page(name: str, **parts: str) -> str:
    """Return a page with the parts between its marks replaced."""
    text = (DOCS / name).read_text(encoding="utf-8")
    for part, content in parts.items():
        begin, end = f"<!-- {part}: begin -->", f"<!-- {part}: end -->"
        before, after = text.split(begin)[0], text.split(end)[1]
        text = f"{before}{begin}\n\n{content}\n{end}{after}"
    return text


if __name__ == "__main__":
    for path, text in contents().items():
        path.write_text(text, encoding="utf-8")
        print(path)
