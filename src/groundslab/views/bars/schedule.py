"""The bending schedule as a file of its own: CSV or a workbook, in the units and the language of the case."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, get_args

from groundslab.languages import LANGUAGES, translator
from groundslab.model.names import names_of
from groundslab.storage.ownership import LONGEST_HEADER
from groundslab.unit_systems import System
from groundslab.views.tables.bending_schedule import HEADS, NAME, TITLE, bending_schedule
from groundslab.views.tables.table import Table, in_units, table_of
from groundslab.views.translation import translate_table

if TYPE_CHECKING:
    from collections.abc import Sequence

    from groundslab.design.rules.punching_links.layout import LinkLayout
    from groundslab.model.model import Model


def schedule_of(model: Model, links: Sequence[LinkLayout]) -> Table:
    """Return the bending schedule in the units and the language of a case."""
    translate = translator(model.language, [model.title, *names_of(model)])
    return translate_table(in_units(bending_schedule(model, links), model.units), translate)


def is_schedule(path: Path) -> bool:
    """Return whether a file begins as a bending schedule of groundslab does, in any language and units."""
    with path.open("rb") as file:
        return file.readline(LONGEST_HEADER) in _first_lines()


@cache
def _first_lines() -> frozenset[bytes]:
    """Return the first lines of bending schedules."""
    empty = table_of(NAME, TITLE, HEADS, ())
    return frozenset(
        translate_table(in_units(empty, units), translator(language)).csv().encode()
        for language in LANGUAGES
        for units in get_args(System)
    )
