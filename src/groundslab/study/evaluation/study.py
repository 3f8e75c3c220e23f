"""A study in its folder: its rows as a table, its fields as maps over the plan."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab.errors import InputError, Issue
from groundslab.optional import import_optional
from groundslab.schema.issues import require
from groundslab.schema.wording import one_of, suggestion
from groundslab.study.definition.setup import column_units
from groundslab.study.evaluation.field_maps import moments
from groundslab.study.execution import store
from groundslab.study.sampling.designs import VariantList, list_variants

if TYPE_CHECKING:
    import pandas as pd

    from groundslab.arrays import Array
    from groundslab.fem.mesh import Mesh


@dataclass(frozen=True, eq=False)
class Map:
    """A statistic of a field over all solved variants.

    Attributes
    ----------
    mesh : Mesh
        The plate's mesh.
    values : ndarray, shape (n,)
        Value at each node, in SI units.
    unit : str
        SI unit; empty for probabilities.
    variants : int
        Number of variants that the statistic is of.
    """

    mesh: Mesh
    values: Array
    unit: str
    variants: int


class Study:
    """A study in its folder; the rows of a running study can be read, too.

    Parameters
    ----------
    folder : str or Path
        Folder of the study, `<study>-study` by default.

    Attributes
    ----------
    folder : Path
        Folder of the study.
    about : dict
        Seed, versions, and SHA-256 of the study file and its case.
    setup : Setup
        Variables, random fields, outputs, limit states and the case.

    Raises
    ------
    InputError
        If the folder is not that of a study, or its files are damaged.
    CertificateWithdrawn
        If its study, its case or a row was changed since groundslab wrote it, by its SHA-256.

    Examples
    --------
    >>> study = groundslab.open_study("slab-study")  # doctest: +SKIP
    >>> study.table()["largest settlement"].mean()  # doctest: +SKIP
    >>> study.map("settlement", "std").values  # doctest: +SKIP
    """

    def __init__(self, folder: str | Path) -> None:
        self.folder = Path(folder)
        self.about, study = store.read_unchanged(folder)
        self.setup = study.setup

    @property
    def title(self) -> str:
        """Title of the study, or of its case."""
        return self.setup.title or self.setup.model.title

    @cached_property
    def units(self) -> dict[str, str]:
        """SI unit of each input and output by its column, empty for pure numbers and words."""
        return dict(column_units(self.setup))

    @cached_property
    def variants(self) -> VariantList:
        """All variants of the study, from its seed."""
        return list_variants(self.setup)

    @property
    def count(self) -> int:
        """Number of variants of the study, with a row or without."""
        return self.setup.count

    def __len__(self) -> int:
        """Return the number of variants with a row."""
        with self.open_rows() as rows:
            return rows.count()

    def counts(self) -> dict[str, int]:
        """Count the variants by outcome.

        Returns
        -------
        dict of str to int
            Number of variants with status "solved", and of others by reason, the most frequent first.
        """
        with self.open_rows() as rows:
            return rows.counts()

    def table(self) -> pd.DataFrame:
        """Return all rows as a table.

        Returns
        -------
        pandas.DataFrame
            One row per variant, indexed by its number. Columns: status ("solved", "foundation fails" where nothing
            balances the loads, or "failed"), reason, message,
            seconds, then the inputs and the outputs that are one number by their names, in SI units; missing outputs of
            a variant that is not solved are NaN.

        Raises
        ------
        InputError
            If pandas is not installed, or the rows are damaged.
        """
        pd = import_optional("pandas", "which makes a DataFrame of a study's rows", "study")
        with self.open_rows() as rows:
            names, results = rows.columns.scalars, rows.columns.results
            frame = pd.DataFrame(rows.rows(names), columns=names).set_index("number")
        return frame.astype(dict.fromkeys(["seconds", *results], float))

    def discretization_errors(self) -> dict[str, tuple[float, float]]:
        """Return the discretization errors of the outputs in the case as it is, from which all variants start.

        Returns
        -------
        dict of str to (float, float)
            By output that is one number its value in the case and the error of that, in SI units. What has no error,
            such as a load, is left out; empty if the case has no results or no coarser mesh, or no row is there yet.
        """
        with self.open_rows() as rows:
            return rows.discretization()

    def worker_failures(self) -> dict[int, str]:
        """Return why variants have no row.

        Returns
        -------
        dict of int to str
            Last error by the number of the variant: an error of the machine, such as a killed worker, not of the
            variant, which would have a row with a reason.
        """
        with self.open_rows() as rows:
            return rows.worker_failures()

    def runs(self) -> list[dict[str, Any]]:
        """Return the runs of the study.

        Returns
        -------
        list of dict
            Time ("at") and package versions ("versions") of each run.
        """
        with self.open_rows() as rows:
            return rows.runs()

    def blocks(self) -> dict[str, range]:
        """Return the blocks of a Saltelli sample.

        Returns
        -------
        dict of str to range
            Numbers of the variants in A, in B, and in each mixture, by the name of the input that is taken from B.

        Raises
        ------
        InputError
            If the sampling is of another kind.
        """
        n = self.setup.sampling.count
        if self.setup.sampling.kind != "saltelli" or n is None:
            raise InputError([Issue("sampling.kind", f'"{self.setup.sampling.kind}"', '"saltelli", which has blocks')])
        names = [
            "A",
            "B",
            *(field.name for field in self.setup.variables),
            *(field.name for field in self.setup.fields),
        ]
        return {name: range(1 + i * n, 1 + (i + 1) * n) for i, name in enumerate(names)}

    def fields(self, name: str) -> Iterator[tuple[int, Array]]:
        """Iterate over the nodal values of a field in all variants, one variant at a time.

        Parameters
        ----------
        name : str
            Name of an output with ``take = "everywhere"``, or its field, such as "settlement".

        Yields
        ------
        number : int
            Number of the variant.
        values : ndarray, shape (n,)
            Nodal values, in SI units.

        Raises
        ------
        InputError
            If there is no such field, or not all variants have the same mesh.
        """
        self.mesh(name)
        with self.open_rows() as rows:
            for number, _, values in rows.fields(self._column(name)):
                yield number, values

    def mesh(self, name: str) -> Mesh:
        """Return the mesh of a field.

        Parameters
        ----------
        name : str
            Name of an output with ``take = "everywhere"``, or its field, such as "settlement".

        Returns
        -------
        Mesh
            The plate's mesh, the same in all variants.

        Raises
        ------
        InputError
            If there is no such field, or not all variants have the same mesh.
        """
        self._column(name)
        with self.open_rows() as rows:
            meshes = rows.meshes()
        if len(meshes) != 1:
            found = (
                f"{len(meshes)} meshes, as what varies changes the mesh" if meshes else "no variant with a field yet"
            )
            raise InputError([Issue(name, found, "a field of all variants on one mesh")])
        return next(iter(meshes.values()))

    def map(self, name: str, statistic: str) -> Map:
        """Return a statistic of a field at each node, over the solved variants.

        Parameters
        ----------
        name : str
            Name of an output with ``take = "everywhere"``, or its field, such as "settlement".
        statistic : {"mean", "std", "probability of uplift"}
            The standard deviation is that of a sample (n - 1). Uplift is a settlement below zero by more than
            rounding.

        Returns
        -------
        Map
            Values at the nodes of the plate's mesh.

        Raises
        ------
        InputError
            If there is no such field or statistic, or not all variants have the same mesh.
        """
        statistics = ("mean", "std", "probability of uplift")
        if statistic not in statistics:
            raise InputError([Issue("map", f'"{statistic}"', one_of(statistics), suggestion(statistic, statistics))])
        column = self._column(name)
        output = next(output for output in self.setup.outputs if output.name == column)
        if statistic == "probability of uplift" and output.of != "settlement":
            raise InputError([Issue("map", f"{output.of}", "settlement, the only field that shows uplift")])
        mesh = self.mesh(column)
        summary = moments(values for _, values in self.fields(column))
        assert summary is not None  # where there is a mesh there is a field
        values = {"mean": summary.mean, "std": summary.deviation}.get(statistic, summary.below_zero)
        return Map(mesh, values, output.unit if statistic in ("mean", "std") else "", summary.n)

    @contextmanager
    def open_rows(self) -> Iterator[store.Store]:
        """Open the rows for reading.

        Yields
        ------
        Store
            The rows; closed at the end of the with statement.

        Raises
        ------
        InputError
            If they are damaged.
        """
        with store.open_rows(self.folder, self.setup) as rows:
            yield rows

    def _column(self, name: str) -> str:
        """Return the column of a field with values at all nodes, by its name or its quantity."""
        outputs = self.setup.nodal_outputs
        names = [output.name for output in outputs]
        if name in names:
            return name
        of = [output.name for output in outputs if output.of == name.replace("_", " ")]
        if len(of) == 1:
            return of[0]
        expected = one_of(names) if names else 'a study that keeps a field with take = "everywhere"'
        raise InputError([Issue("field", f'"{name}"', expected, suggestion(name, names))])


def as_study(study: Study | str | Path) -> Study:
    """Return a study, opened if it is named by its folder."""
    require(study, Study, str, Path, name="study")
    return study if isinstance(study, Study) else Study(study)


def open_study(folder: str | Path) -> Study:
    """Open a study in its folder, for reading.

    Parameters
    ----------
    folder : str or Path
        Folder of the study, `<study>-study` by default.

    Returns
    -------
    Study
        Its rows, fields and statistics; of a running study, those so far.

    Raises
    ------
    InputError
        If the folder is not that of a study.
    CertificateWithdrawn
        If its study, its case or a row was changed since groundslab wrote it, by its SHA-256.

    Examples
    --------
    >>> study = groundslab.open_study("slab-study")  # doctest: +SKIP
    >>> study.counts()  # doctest: +SKIP
    {'solved': 100}
    """
    return Study(folder)
