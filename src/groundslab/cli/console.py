"""What commands say, and the codes with which they end."""

from __future__ import annotations

import os
import sys
from contextlib import suppress
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from groundslab.errors import InputError

FINE, NO_RESULT, WRONG_INPUT, INTERRUPTED = 0, 1, 2, 130


def say(text: str) -> None:
    """Print a message to standard error, if that takes it: what else there is to do counts more."""
    with suppress(OSError):
        print(text, file=sys.stderr, flush=True)


def answer(text: str) -> None:
    """Print to standard output; a reader that went away early is no failure."""
    try:
        print(text, flush=True)
    except BrokenPipeError:
        close_output()
    except OSError:
        close_output()
        raise


def close_output() -> None:
    """Let what is still to be printed vanish, so that Python does not complain at its end."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def in_blocks(error: InputError) -> str:
    """Return the faults of an input as blocks of lines."""
    count = len(error.issues)
    blocks = [f"error: {count} fault{'s' if count != 1 else ''} in the input"]
    for issue in error.issues:
        lines = [("got", issue.found), ("expected", issue.expected), ("mend", issue.hint)]
        blocks.append("\n".join([f"  {issue.location}", *(f"    {word:<9} {text}" for word, text in lines if text)]))
    return "\n\n".join(blocks)
