"""Reading of building models in child processes."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Any, Literal

from groundslab.exchange.ifc import IfcCase, list_slabs, read_ifc
from groundslab.workbench.checking.file_reader import FileKind, FileReader


class BuildingReader(FileReader):
    """Reads one building at a time, each in a process of its own, which then ends."""

    kind = FileKind(
        "a building", "an IFC 2x3 or IFC 4 file", "export the storey of the slab alone",
        "export it again from the building's program", ("shapely", "ifcopenshell", "ifcopenshell.geom"), 120.0,
        4_000_000_000,
    )  # fmt: skip

    def survey(self, path: Path) -> list[dict[str, Any]]:
        """Return the slabs of a building as data for the page; raises InputError."""
        slabs: list[dict[str, Any]] = self.call(survey_slabs, path)
        return slabs

    def convert(self, path: str | Path, slab: str, origin: Literal["own", "center"], align: bool = False) -> IfcCase:
        """Return the case of a slab of a building; raises InputError."""
        case: IfcCase = self.call(read_ifc, str(path), slab, origin, align)
        return case


def survey_slabs(path: Path) -> list[dict[str, Any]]:
    """Return the slabs of a building as data for the page."""
    return [asdict(slab) for slab in list_slabs(path)]
