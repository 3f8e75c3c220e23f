"""Reading of drawings in child processes, as they come from others and may take any time and memory."""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

from groundslab.errors import InputError, Issue
from groundslab.geometry.plan import Place
from groundslab.workbench.checking.bounded_process import MEMORY, BoundedProcess, CallFailure, MemoryLimit, TimeLimit

#: Time in which a drawing must be read [s].
READ_LIMIT = 30.0


@dataclass(frozen=True, slots=True)
class ConvertedDrawing:
    """The text of a case made from a drawing, the report of what was read and what was left, its origin [m]."""

    text: str
    report: str
    origin: tuple[float, float]


class DrawingReader:
    """Reads one drawing at a time, each in a process of its own, which then ends."""

    def __init__(self, seconds: float = READ_LIMIT, memory: int = MEMORY) -> None:
        self._seconds, self._memory = seconds, memory
        self._lock = threading.Lock()

    def survey(self, path: Path) -> dict[str, Any]:
        """Return the unit and the layers of a drawing as data for the page; raises InputError."""
        layers: dict[str, Any] = self._call(survey_drawing, path)
        return layers

    def convert(
        self, path: Path, layers: Mapping[str, str], unit: str | None, centered: bool, gap: str
    ) -> ConvertedDrawing:
        """Return the case that a drawing's layers describe, gaps up to a length closed; raises InputError."""
        made: ConvertedDrawing = self._call(convert_drawing, path, dict(layers), unit, centered, gap)
        return made

    def _call(self, function: Callable[..., Any], path: Path, *arguments: Any) -> Any:
        if path.suffix.lower() != ".dxf":
            raise InputError([Issue(str(path), f'"{path.suffix}"', 'a name that ends with ".dxf"')])
        with self._lock:
            caller = BoundedProcess(load_libraries, self._memory)
            try:
                return caller.call(function, str(path), *arguments, seconds=self._seconds)
            except CallFailure as error:
                raise InputError([_explain_failure(path, error)]) from None
            except InputError:
                raise
            except Exception as error:  # of any kind, as what is damaged may be anything
                hint = "save it again in the CAD program"
                issue = Issue(str(path), f"a damaged DXF file ({type(error).__name__}: {error})", "a DXF drawing", hint)
                raise InputError([issue]) from None
            finally:
                caller.close()


def _explain_failure(path: Path, error: CallFailure) -> Issue:
    """Return the issue with a drawing that could not be read."""
    found = f"a drawing that cannot be read ({error})"
    if isinstance(error, TimeLimit):
        found = f"a drawing that takes {error} to read"
    elif isinstance(error, MemoryLimit):
        found = f"a drawing that takes too much memory to read ({error})"
    return Issue(str(path), found, "a smaller one", "save only the layers that are needed in a separate file")


def load_libraries() -> None:
    """Load what reading needs, before memory is limited."""
    with suppress(ImportError):  # an issue of the reading itself
        for name in ("ezdxf.filemanagement", "shapely", "groundslab.case.dxf.survey"):
            import_module(name)


def survey_drawing(path: str) -> dict[str, Any]:
    """Return the unit and the layers of a drawing as data for the page, places as flat lists [m]."""
    from groundslab.case.dxf.survey import survey

    content = survey(path)
    layers = [
        {
            "name": layer.name,
            "role": layer.role,
            "hidden": layer.hidden,
            "kinds": dict(layer.kinds.most_common()),
            "lines": list(map(_flatten, layer.lines)),
            "curves": list(map(_flatten, layer.curves)),
            "points": _flatten(layer.points),
        }
        for layer in content.layers
    ]
    return {"unit": content.unit, "scale": content.scale, "layers": layers, "remarks": list(content.remarks)}


def _flatten(points: Sequence[Place]) -> list[float]:
    return [value for point in points for value in point]


def convert_drawing(
    path: str, layers: Mapping[str, str], unit: str | None, centered: bool, gap: str
) -> ConvertedDrawing:
    """Return the case that a drawing's layers describe."""
    from groundslab.case import dxf

    drawing = dxf.read(path, layers, unit, dxf.parse_gap(gap))
    if centered:
        drawing = dxf.center(drawing)
    return ConvertedDrawing(dxf.to_case(drawing, Path(path).stem), dxf.report_text(drawing), drawing.origin)
