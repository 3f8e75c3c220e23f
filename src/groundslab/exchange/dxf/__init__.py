"""Drawings: outline, openings, zones, columns and loads from the layers of a DXF file."""

from groundslab.exchange.dxf.case_template import to_case
from groundslab.exchange.dxf.classify import align, remark_on_column, strip_of
from groundslab.exchange.dxf.document import Layers
from groundslab.exchange.dxf.drawing import Drawing, LineMark, center
from groundslab.exchange.dxf.reader import parse_gap, read
from groundslab.exchange.dxf.report import report_text

__all__ = [
    "Drawing", "Layers", "LineMark", "align", "center", "parse_gap", "read", "remark_on_column",
    "report_text", "strip_of", "to_case",
]  # fmt: skip
