"""Slabs from IFC files, which programs for buildings exchange: geometry alone."""

from groundslab.case.ifc.reader import IfcCase, read_ifc

__all__ = ["IfcCase", "read_ifc"]
