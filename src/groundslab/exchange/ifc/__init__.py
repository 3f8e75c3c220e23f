"""Slabs from IFC files, which programs for buildings exchange: geometry alone."""

from groundslab.exchange.ifc.reader import IfcCase, list_slabs, read_ifc

__all__ = ["IfcCase", "list_slabs", "read_ifc"]
