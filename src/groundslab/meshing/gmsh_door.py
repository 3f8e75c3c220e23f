"""The one door to Gmsh: how it is found, set up, and left as it was."""

from __future__ import annotations

import ctypes
import os
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from groundslab.errors import InputError, Issue

#: What Gmsh's wheel wants to find on a bare Debian or Ubuntu.
SYSTEM_LIBRARIES = "libglu1-mesa libopengl0 libgl1 libxrender1 libxcursor1 libxft2 libxinerama1 libgomp1"
#: What Gmsh is set to while a session lasts.
OPTIONS = {
    "General.Terminal": 0,
    "General.AbortOnError": 2,
    "General.NumThreads": 1,
    "Geometry.OCCBoundsUseStl": 0,
    "Mesh.Algorithm": 8,
    "Mesh.ElementOrder": 1,
    "Mesh.MeshSizeExtendFromBoundary": 0,
    "Mesh.MeshSizeFromCurvature": 0,
    "Mesh.MeshSizeFromPoints": 0,
    "Mesh.MeshSizeMax": 1e22,
    "Mesh.MeshSizeMin": 0,
    "Mesh.RandomSeed": 1,
    "Mesh.RecombinationAlgorithm": 1,
    "Mesh.RecombineAll": 1,
    "Mesh.SubdivisionAlgorithm": 0,
}


@contextmanager
def session() -> Iterator[Any]:
    """Yield Gmsh with an empty model of our own; afterwards everything is as it was, whatever happened."""
    gmsh = load()
    ours = not gmsh.isInitialized()
    if ours:
        gmsh.initialize([], readConfigFiles=False, run=False, interruptible=False)
    _ignore_broken_pipes()
    before = {} if ours else {name: gmsh.option.getNumber(name) for name in OPTIONS}
    current = "" if ours else gmsh.model.getCurrent()
    try:
        for name, value in OPTIONS.items():
            gmsh.option.setNumber(name, value)
        gmsh.model.add("groundslab")
        yield gmsh
    except InputError:
        raise
    except Exception as refused:
        # Gmsh knows no other exception; what it says is for people
        raise InputError([Issue("plan", f"a plan that Gmsh refuses ({refused})", "one that can be meshed")]) from None
    finally:
        if ours:
            gmsh.finalize()
        else:
            gmsh.model.setCurrent("groundslab")
            gmsh.model.remove()
            gmsh.model.setCurrent(current)
            for name, value in before.items():
                gmsh.option.setNumber(name, value)


def _ignore_broken_pipes() -> None:
    """Let a broken pipe be an error again, as everywhere in Python: Gmsh lets it end the process without a word.

    Python still thinks that it ignores the signal, and only its main thread may set one: hence the C library.
    """
    if os.name == "posix" and signal.getsignal(signal.SIGPIPE) == signal.SIG_IGN:
        ctypes.CDLL(None).signal(signal.SIGPIPE, int(signal.SIG_IGN))


def load() -> Any:
    """Return the module gmsh, or raise what keeps it from being loaded."""
    import gmsh  # type: ignore[import-untyped,unused-ignore]

    return gmsh
