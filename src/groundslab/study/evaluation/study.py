"""A study in its folder, opened to read: its rows as a table, its fields as maps over the plan."""

from __future__ import annotations

import sqlite3
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab.errors import InputError, Issue
from groundslab.schema.wording import one_of, suggestion
from groundslab.study.definition import files
from groundslab.study.definition.setup import Setup, columns_of
from groundslab.study.evaluation.field_maps import moments
from groundslab.study.execution import store
from groundslab.study.execution.store import columns_in
from groundslab.study.execution.variant import split
from groundslab.study.sampling.designs import Sample, sample_of

if TYPE_CHECKING:
    import pandas as pd

    from groundslab.arrays import Array
    from groundslab.fem.mesh import Mesh


@dataclass(frozen=True, eq=False)
class Map:
    """A value at each node of the plate's mesh, over all solved variants: (n,), in SI units."""

    mesh: Mesh
    values: Array
    unit: str
    variants: int  # that it was made of


class Study:
    """A study in its folder. While it runs, what is there so far can be read."""

    def __init__(self, folder: str | Path) -> None:
        self.folder = Path(folder)
        #: What the folder says of itself: seed, versions, SHA-256 of both files, runs.
        self.about: dict[str, Any] = store.about(folder)
        self._read = files.read(self.folder / store.STUDY, self.folder / store.CASE)

    @property
    def setup(self) -> Setup:
        """Return variables, random fields, outputs, limits and the case."""
        return self._read.setup

    @property
    def title(self) -> str:
        """Return the study's title, or that of its case."""
        return self.setup.title or self.setup.model.title

    @cached_property
    def units(self) -> dict[str, str]:
        """Return the SI unit of each input and output by its column, empty for pure numbers and words."""
        return dict(columns_of(self.setup))

    @cached_property
    def sample(self) -> Sample:
        """Return all variants of the study, made anew from its seed."""
        return sample_of(self.setup)

    @property
    def count(self) -> int:
        """Return how many variants the study has, whether they have a row or not."""
        return self.setup.count

    def __len__(self) -> int:
        """Return how many variants have a row."""
        with self.opened_rows() as rows:
            return rows.count()

    def counts(self) -> dict[str, int]:
        """Return how many variants are solved, and how many failed for each reason."""
        with self.opened_rows() as rows:
            return rows.counts()

    def table(self) -> pd.DataFrame:
        """Return all rows that are there as a pandas.DataFrame, in SI units; its index is the variant's number.

        Columns: status ("solved" or "failed"), reason, message, seconds, then the inputs and the results that are one
        number by their names; what a failed variant lacks is NaN.
        """
        try:
            import pandas as pd
        except ImportError:
            expected = "pandas, which makes a DataFrame of a study's rows"
            raise InputError(
                [Issue("pandas", "nothing that can be imported", expected, "pip install groundslab[study]")]
            ) from None
        columns = columns_in(self.setup)
        names = [*store.FIXED, *columns.inputs, *columns.results]
        with self.opened_rows() as rows:
            frame = pd.DataFrame(rows.rows(names), columns=names).set_index("number")
        return frame.astype(dict.fromkeys(["seconds", *columns.results], float))

    def mishaps(self) -> dict[int, str]:
        """Return why variants have no row, by their numbers: what happened to the machine, not to the variant."""
        with self.opened_rows() as rows:
            return rows.mishaps()

    def runs(self) -> list[dict[str, Any]]:
        """Return when the study was run, and with which versions."""
        with self.opened_rows() as rows:
            return rows.runs()

    def blocks(self) -> dict[str, range]:
        """Return the numbers of the variants in each block of a saltelli sample: A, B, then each input's name."""
        n = self.setup.sampling.count
        if self.setup.sampling.kind != "saltelli" or n is None:
            raise InputError([Issue("sampling.kind", f'"{self.setup.sampling.kind}"', '"saltelli", which has blocks')])
        names = ["A", "B", *(each.name for each in self.setup.variables), *(each.name for each in self.setup.fields)]
        return {name: range(1 + i * n, 1 + (i + 1) * n) for i, name in enumerate(names)}

    def fields(self, name: str) -> Iterator[tuple[int, Array]]:
        """Yield number and nodal values (n,), in SI units, of a field kept everywhere, one variant after the other.

        All variants must have the same mesh, else InputError is raised.
        """
        self.mesh(name)
        with self.opened_rows() as rows:
            for number, _, values in rows.fields(self._column(name)):
                yield number, values

    def mesh(self, name: str) -> Mesh:
        """Return the mesh that a field kept everywhere is given on; InputError if there is none or more than one."""
        self._column(name)
        with self.opened_rows() as rows:
            meshes = rows.meshes()
        if len(meshes) != 1:
            found = (
                f"{len(meshes)} meshes, as what varies changes the mesh" if meshes else "no variant with a field yet"
            )
            raise InputError([Issue(name, found, "a field of all variants on one mesh")])
        return next(iter(meshes.values()))

    def map(self, name: str, what: str) -> Map:
        """Return mean, std or probability of uplift at each node, over the solved variants, of a field kept everywhere.

        `name` is the column's, or the field's, as in "settlement". The standard deviation is that of a sample (n - 1).
        Uplift is a settlement below zero, by more than rounding.
        """
        known = ("mean", "std", "probability of uplift")
        if what not in known:
            raise InputError([Issue("map", f'"{what}"', one_of(known), suggestion(what, known))])
        column = self._column(name)
        output = next(each for each in self.setup.outputs if each.name == column)
        if what == "probability of uplift" and output.of != "settlement":
            raise InputError([Issue("map", f"{output.of}", "settlement, which alone says where the plate lifts")])
        mesh = self.mesh(column)
        found = moments(values for _, values in self.fields(column))
        assert found is not None  # where there is a mesh there is a field
        if what == "mean":
            return Map(mesh, found.mean, output.unit, found.n)
        if what == "std":
            return Map(mesh, found.deviation, output.unit, found.n)
        return Map(mesh, found.below_zero, "", found.n)

    @contextmanager
    def opened_rows(self) -> Iterator[store.Store]:
        """Return the rows while they are read; raises InputError if they are damaged."""
        try:
            with store.Store(self.folder, columns_in(self.setup), read_only=True) as rows:
                yield rows
        except (sqlite3.Error, zlib.error) as error:
            expected, hint = "the rows that groundslab study wrote", "copy the folder back from where it is whole"
            raise InputError([Issue(str(self.folder / store.ROWS), str(error), expected, hint)]) from error

    def _column(self, name: str) -> str:
        """Return the column of a field kept everywhere, by its name or by what it is of."""
        whole = split(self.setup.outputs)[1]
        for output in whole:
            if output.name == name:
                return name
        of = [output.name for output in whole if output.of == name.replace("_", " ")]
        if len(of) == 1:
            return of[0]
        names = [output.name for output in whole]
        expected = one_of(names) if names else 'a study that keeps a field with take = "everywhere"'
        raise InputError([Issue("field", f'"{name}"', expected, suggestion(name, names))])


def open_study(folder: str | Path) -> Study:
    """Return a study in its folder, to be read; raises InputError if it is none."""
    return Study(folder)
