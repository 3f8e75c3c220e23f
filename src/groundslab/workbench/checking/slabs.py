"""The slabs in files of other programs: SAF files and building models."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from groundslab.errors import InputError, Issue
from groundslab.messages import Message, Name, quoted
from groundslab.workbench.checking.buildings import BuildingReader
from groundslab.workbench.checking.saf import ConvertedSlab, SafReader

WORKBOOK, BUILDING = ".xlsx", ".ifc"


class SlabReader:
    """Reads slabs of either kind of file, which its name tells."""

    def __init__(self) -> None:
        self._saf, self._buildings = SafReader(), BuildingReader()

    def survey(self, path: Path) -> list[dict[str, Any]]:
        """Return the slabs of a file as data for the page, none if a workbook is another one; raises InputError."""
        return self._buildings.survey(path) if _is_building(path) else self._saf.survey(path)

    def convert(self, path: Path, slab: str, centered: bool, aligned: bool) -> ConvertedSlab:
        """Return the case that a slab of a file is; raises InputError.

        The plan of a building may be measured from the slab's middle, and be turned along x and y.
        """
        if _is_building(path):
            converted = self._buildings.convert(path, slab, "center" if centered else "own", aligned)
            return ConvertedSlab(converted.text, converted.report_text())
        if centered or aligned:
            raise InputError([Issue(str(path), "a SAF file whose plan is to be moved", "its own coordinates")])
        return self._saf.convert(path, slab)


def _is_building(path: Path) -> bool:
    """Return whether a file is a building model; raises InputError if it is no workbook either."""
    suffix = path.suffix.lower()
    if suffix not in (WORKBOOK, BUILDING):
        expected = Message('a name that ends with "{one}" or "{other}"', one=Name(WORKBOOK), other=Name(BUILDING))
        raise InputError([Issue(str(path), quoted([path.suffix]), expected)])
    return suffix == BUILDING
