"""The command mcp: what it understands, and what it does."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from groundslab.cli.console import EXIT_OK
from groundslab.errors import InputError, Issue
from groundslab.optional import import_optional

if TYPE_CHECKING:
    import argparse


def describe(command: argparse.ArgumentParser) -> None:
    """Add what the command mcp understands."""
    command.epilog = (
        "A client of the Model Context Protocol starts the command and talks to it on standard input and output. Its "
        "tools check, solve, checks, tables and plot read and write nothing outside the folder."
    )
    command.add_argument("folder", metavar="FOLDER", help="folder with the cases, in which results are written")


def run(options: argparse.Namespace) -> int:
    """Serve a folder until standard input ends."""
    folder = Path(os.path.realpath(options.folder))
    if not folder.is_dir():
        raise InputError([Issue("FOLDER", str(options.folder), "a folder that exists")])
    import_optional("mcp", "which talks to clients of the Model Context Protocol", "mcp")
    from groundslab.workbench.assistants.server import serve

    serve(folder)
    return EXIT_OK
