"""Reading of building models in child processes."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from groundslab.case.ifc import IfcCase, read_ifc
from groundslab.workbench.checking.file_reader import FileKind, FileReader


class BuildingReader(FileReader):
    """Reads one building at a time, each in a process of its own, which then ends."""

    kind = FileKind(
        "a building", "an IFC 4 file", "export the storey of the slab alone",
        "export it again from the building's program", ("shapely", "ifcopenshell", "ifcopenshell.geom"), 120.0,
        4_000_000_000,
    )  # fmt: skip

    def convert(self, path: str | Path, slab: str, origin: Literal["own", "center"], align: bool = False) -> IfcCase:
        """Return the case of a slab of a building; raises InputError."""
        case: IfcCase = self.call(read_ifc, str(path), slab, origin, align)
        return case
