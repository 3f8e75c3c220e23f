"""Output of the commands, and their exit codes."""

from __future__ import annotations

import os
import sys
from contextlib import suppress
from typing import TYPE_CHECKING

from groundslab.schema.wording import printable

if TYPE_CHECKING:
    from groundslab.errors import InputError

#: White space that lays out what is printed.
LAYOUT = "\n\t"
EXIT_OK, EXIT_NO_RESULT, EXIT_WRONG_INPUT, EXIT_DESIGN_FAILS, EXIT_INTERRUPTED = 0, 1, 2, 3, 130


def print_stderr(text: str) -> None:
    """Print a message to standard error, in which no name is obeyed; errors in doing so are ignored."""
    with suppress(OSError):
        print(printable(text, keep=LAYOUT), file=sys.stderr, flush=True)


def print_stdout(text: str, *, styled: bool = False) -> None:
    """Print to standard output, in which no name is obeyed unless it is styled already; a closed pipe is no error."""
    try:
        print(text if styled else printable(text, keep=LAYOUT), flush=True)
    except BrokenPipeError:
        close_output()
    except OSError:
        close_output()
        raise


def close_output() -> None:
    """Discard further output, so that Python does not complain at its end."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def format_issues(error: InputError) -> str:
    """Return the issues of an input as blocks of lines."""
    count = len(error.issues)
    blocks = [f"error: {count} issue{'s' if count != 1 else ''} in the input"]
    for issue in error.issues:
        lines = [("found", issue.found), ("expected", issue.expected), ("hint", issue.hint)]
        blocks.append("\n".join([f"  {issue.location}", *(f"    {word:<9} {text}" for word, text in lines if text)]))
    return "\n\n".join(blocks)
