"""The command line as a program, ``groundslab`` and ``python -m groundslab``: its streams, and Ctrl-C at any time.

Libraries that are interrupted while they are imported make other errors of that, or print it. So an interrupt is noted
here, before anything else is imported.
"""

from __future__ import annotations

import gc
import os
import signal
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from types import FrameType, TracebackType

INTERRUPTED = 130


def main() -> int:
    """Run one command and return its exit code: 130 if it was interrupted, whatever became of that on the way."""
    interrupts: list[int] = []
    hook = sys.excepthook

    def note(number: int, frame: FrameType | None) -> None:
        interrupts.append(number)
        signal.default_int_handler(number, frame)

    def show(kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        if not interrupts:
            hook(kind, error, trace)

    # imports make a hundred thousand objects and hardly any garbage
    gc.set_threshold(200_000)
    # no plugin of pydantic is used here, and looking for one reads what every installed package says of itself
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")
    try:
        # a shell that runs a program in the background has it ignore Ctrl-C
        if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
            signal.signal(signal.SIGINT, note)
        sys.excepthook = show
        open_missing_streams()
        from groundslab.cli.main import main as run

        code = run()
    except SystemExit:
        raise
    except BaseException:
        if not interrupts:
            raise
        code = INTERRUPTED
        print("interrupted", file=sys.stderr)
    if interrupts and code != 0:
        code = INTERRUPTED
    if signal.getsignal(signal.SIGINT) is note:
        # nothing is left to be cleared up
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    # the interpreter's last search for garbage would take as long as importing NumPy
    gc.freeze()
    return code


def open_missing_streams() -> None:
    """Open the null device for standard streams that are closed, so that no other file gets their numbers."""
    for number, name in enumerate(("stdin", "stdout", "stderr")):
        try:
            os.fstat(number)
        except OSError:
            # the lowest number that is free
            os.set_inheritable(os.open(os.devnull, os.O_RDWR), True)
        if getattr(sys, name) is None:
            setattr(sys, name, open(number, "w" if number else "r", encoding="utf-8", closefd=False))  # noqa: SIM115


if __name__ == "__main__":
    sys.exit(main())
