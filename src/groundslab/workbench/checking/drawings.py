"""Reading of drawings in child processes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from groundslab.errors import InputError, Issue
from groundslab.geometry.plan import Place
from groundslab.messages import Message, Name, quoted
from groundslab.workbench.checking.file_reader import ENDING, FileKind, FileReader


@dataclass(frozen=True, slots=True)
class ConvertedDrawing:
    """The text of a case made from a drawing, the report of what was read and what was left, its origin [m]."""

    text: str
    report: str
    origin: tuple[float, float]


class DrawingReader(FileReader):
    """Reads one drawing at a time, each in a process of its own, which then ends."""

    kind = FileKind(
        "a drawing", "a DXF drawing", "save only the layers that are needed in a separate file",
        "save it again in the CAD program", ("ezdxf.filemanagement", "shapely", "groundslab.exchange.dxf.survey"), 30.0,
    )  # fmt: skip

    def survey(self, path: Path) -> dict[str, Any]:
        """Return the unit and the layers of a drawing as data for the page; raises InputError."""
        layers: dict[str, Any] = self._call(survey_drawing, path)
        return layers

    def convert(
        self, path: Path, layers: Mapping[str, str], unit: str | None, centered: bool, gap: str, union: bool
    ) -> ConvertedDrawing:
        """Return the case of a drawing's layers, gaps up to a length closed, outlines joined; raises InputError."""
        converted: ConvertedDrawing = self._call(convert_drawing, path, dict(layers), unit, centered, gap, union)
        return converted

    def _call(self, function: Callable[..., Any], path: Path, *arguments: Any) -> Any:
        if path.suffix.lower() != ".dxf":
            raise InputError([Issue(str(path), quoted([path.suffix]), Message(ENDING, ending=Name(".dxf")))])
        return self.call(function, str(path), *arguments)


def survey_drawing(path: str) -> dict[str, Any]:
    """Return the unit and the layers of a drawing as data for the page, places as flat lists [m]."""
    from groundslab.exchange.dxf.survey import survey

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
    path: str, layers: Mapping[str, str], unit: str | None, centered: bool, gap: str, union: bool = False
) -> ConvertedDrawing:
    """Return the case that a drawing's layers describe."""
    from groundslab.exchange import dxf

    drawing = dxf.read(path, layers, unit, dxf.parse_gap(gap), union)
    if centered:
        drawing = dxf.center(drawing)
    return ConvertedDrawing(dxf.to_case(drawing, Path(path).stem), dxf.report_text(drawing), drawing.origin)
