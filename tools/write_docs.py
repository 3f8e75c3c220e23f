"""Writes the parts of docs/ that follow from the code: keys, commands, JSON schemas, the diagram of imports."""

from __future__ import annotations

import argparse
import json
import tempfile
from pathlib import Path
from typing import Any

from annex_tables import table_of_actions, tables
from compare_generations import table as generations
from draw_imports import diagram

from groundslab.cli import main
from groundslab.model.model import docs_table, json_schema
from groundslab.study.definition import schema
from groundslab.views.interface import shapes
from groundslab.workbench.events import Hub
from groundslab.workbench.server.public import openapi
from groundslab.workbench.server.routes import create_app
from groundslab.workbench.server.security import Tickets
from groundslab.workbench.server.session import Session
from groundslab.workbench.solver.thread import Solver

DOCS = Path(__file__).resolve().parent.parent / "docs"


def contents() -> dict[Path, str]:
    """Return what each of the files should hold."""
    return {
        DOCS / "annexes.md": _page("annexes.md", annexes=tables(), actions=table_of_actions()),
        DOCS / "architecture.md": _page("architecture.md", imports=diagram()),
        DOCS / "commands.md": _page("commands.md", commands=commands_text()),
        DOCS / "input.md": _page("input.md", keys=docs_table()),
        DOCS / "groundslab.schema.json": json.dumps(json_schema(), indent=2) + "\n",
        DOCS / "study.md": _page("study.md", keys=schema.docs_table(), kept=schema.outputs_table()),
        DOCS / "study.schema.json": json.dumps(schema.json_schema(), indent=2) + "\n",
    }


def interface() -> dict[Path, str]:
    """Return what the schemas for other programs should hold, whose wording depends on the libraries' versions."""
    made = {f"{name}.schema.json": shapes.json_schema(name) for name in shapes.DOCUMENTS}
    made["openapi.json"] = interface_of_server()
    return {DOCS / "interface" / name: json.dumps(schema, indent=2) + "\n" for name, schema in made.items()}


def interface_of_server() -> dict[str, Any]:
    """Return the description of the workbench's public routes."""
    hub = Hub()
    with tempfile.TemporaryDirectory(prefix="groundslab-") as state:
        session = Session(hub, Solver(hub.publish, prepare=None), Path(state), "")
        try:
            return openapi(create_app(session, Tickets(), 0, "").app)
        finally:
            session.close()


def solved() -> dict[Path, str]:
    """Return what the files should hold whose parts take a solution."""
    name = "howto/two_generations.md"
    return {DOCS / name: _page(name, comparison=generations())}


def commands_text() -> str:
    """Return what each command of the command line understands."""
    (commands,) = (each for each in main._parser()._actions if isinstance(each, argparse._SubParsersAction))
    parts = []
    for name, command in commands.choices.items():
        own = [action for action in command._actions if action.dest != "help"]
        rows = [(_words(action), (action.help or "").replace("<", "&lt;")) for action in own]
        usage = " ".join(["groundslab", name, *(_words(each, short=True) for each in own)])
        table = ["| argument | meaning |", "|---|---|", *(f"| `{words}` | {text} |" for words, text in rows)]
        parts.append("\n".join([f"## {name}", "", command.description or "", "", "```", usage, "```", ""]))
        parts[-1] += "\n".join(["", *table, ""] if rows else []) + (f"\n{command.epilog}\n" if command.epilog else "")
    return "\n".join(parts)


def _words(action: argparse.Action, short: bool = False) -> str:
    """Return an argument as one writes it; `short` as part of a command's usage."""
    value = "" if action.nargs == 0 else str(action.metavar or action.dest.upper())
    words = f"{action.option_strings[0]} {value}".rstrip() if action.option_strings else value
    repeated = "..." if short and action.nargs in ("*", "+") else ""
    return f"[{words}{repeated}]" if short and not action.required else words + repeated


def _page(name: str, **parts: str) -> str:
    """Return a page with the parts between its marks replaced."""
    text = (DOCS / name).read_text(encoding="utf-8")
    for part, content in parts.items():
        begin, end = f"<!-- {part}: begin -->", f"<!-- {part}: end -->"
        before, after = text.split(begin)[0], text.split(end)[1]
        text = f"{before}{begin}\n\n{content}\n{end}{after}"
    return text


if __name__ == "__main__":
    for path, text in {**contents(), **interface(), **solved()}.items():
        path.write_text(text, encoding="utf-8")
        print(path)
