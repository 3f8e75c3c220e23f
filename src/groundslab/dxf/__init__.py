"""Drawings: outline, openings, zones, columns and point loads from the layers of a DXF file."""

from groundslab.dxf.case import to_case
from groundslab.dxf.curves import Curve
from groundslab.dxf.drawing import Drawing, PointMark, ReportLine
from groundslab.dxf.layers import Layers
from groundslab.dxf.reading import read
from groundslab.dxf.report import report_text

__all__ = ["Curve", "Drawing", "Layers", "PointMark", "ReportLine", "read", "report_text", "to_case"]
