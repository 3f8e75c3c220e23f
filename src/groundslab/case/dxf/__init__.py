"""Drawings: outline, openings, zones, columns and loads from the layers of a DXF file."""

from groundslab.case.dxf.case_template import to_case
from groundslab.case.dxf.classify import align, remark_on_column, strip_of
from groundslab.case.dxf.document import Layers
from groundslab.case.dxf.drawing import Drawing, LineMark, center
from groundslab.case.dxf.reader import parse_gap, read
from groundslab.case.dxf.report import report_text

__all__ = [
    "Drawing", "Layers", "LineMark", "align", "center", "parse_gap", "read", "remark_on_column",
    "report_text", "strip_of", "to_case",
]  # fmt: skip
