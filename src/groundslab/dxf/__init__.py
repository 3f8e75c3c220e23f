"""Drawings: outline, openings, zones, columns and loads from the layers of a DXF file."""

from groundslab.dxf.case import to_case
from groundslab.dxf.curves import Curve
from groundslab.dxf.drawing import AreaMark, Drawing, LineMark, PointMark, ReportLine
from groundslab.dxf.layers import Layers
from groundslab.dxf.reading import read
from groundslab.dxf.report import report_text

__all__ = [
    "AreaMark",
    "Curve",
    "Drawing",
    "Layers",
    "LineMark",
    "PointMark",
    "ReportLine",
    "read",
    "report_text",
    "to_case",
]
