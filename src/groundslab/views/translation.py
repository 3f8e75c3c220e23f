"""Texts of results in the language that a case asks for."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from groundslab.arrays import made_once
from groundslab.languages import Translator, translator
from groundslab.messages import Name, words_in
from groundslab.model.names import names_of
from groundslab.results.results import CombinationResult, Results
from groundslab.views.tables.result_tables import tables_of
from groundslab.views.tables.table import WORDS, Column, Table

if TYPE_CHECKING:
    from groundslab.model.model import Model


@made_once
def translator_of(results: CombinationResult | Results) -> Translator:
    """Return what translates texts into the language of a case, whose names stay as they are."""
    model = results.model
    if model.language == "en":
        return str
    project = () if model.project is None else model.project
    project_texts = [model.title, *(str(value) for key, value in project if key not in ("units", "language"))]
    cases = (*names_of(model), *names_of(results.solved_model))  # whose cases may have moved
    several = (
        [combination.name for combination in results.combinations]
        if isinstance(results, Results)
        else [results.combination]
    )
    return translator(model.language, [*project_texts, *cases, *several])


@made_once
def words_of(model: Model) -> Translator:
    """Return what writes texts in the units and the language of a case, as names that nothing changes any more."""
    names = frozenset(names_of(model))
    translate = translator(model.language, names)
    return lambda text: Name(translate(words_in(text, model.units)))


def translated_tables(combined: Results) -> Iterator[Table]:
    """Yield the tables of results in the language of the case: titles, headings, notes and sentences."""
    translate = translator_of(combined)
    for table in tables_of(combined):
        yield translate_table(table, translate)


def translate_table(table: Table, translate: Translator) -> Table:
    """Return a table with title, headings, notes and sentences in another language; all else in it stays."""
    if translate is str:
        return table
    columns = tuple(_translate_column(column, translate) for column in table.columns)
    return replace(table, title=translate(table.title), columns=columns, notes=tuple(map(translate, table.notes)))


def _translate_column(column: Column, translate: Translator) -> Column:
    words = column.name in WORDS
    values = tuple(translate(value) if words and isinstance(value, str) else value for value in column.values)
    return replace(column, name=translate(column.name), values=values)
