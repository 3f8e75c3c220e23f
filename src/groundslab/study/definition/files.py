"""Reads a study file and the case file that it names."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from groundslab import units
from groundslab.case import casefile
from groundslab.errors import InputError, Issue
from groundslab.model.model import Model
from groundslab.schema.fields import FieldType, ListOf, Number, Quantity
from groundslab.study.definition.distributions import AMOUNTS
from groundslab.study.definition.schema import StudyFile
from groundslab.study.definition.setup import Setup, setup_of


@dataclass(frozen=True, eq=False)
class StudyInput:
    """A study and its case: the texts of both files and what they describe."""

    study_text: str
    case_text: str
    setup: Setup

    @property
    def checksums(self) -> dict[str, str]:
        """Return the SHA-256 of both texts in UTF-8, as about.json calls them."""
        texts = {"study_sha256": self.study_text, "case_sha256": self.case_text}
        return {name: hashlib.sha256(text.encode()).hexdigest() for name, text in texts.items()}


def read(path: str | Path, case: Model | str | Path | None = None) -> StudyInput:
    """Return a study file with its case, or another one; raises InputError with all issues of both."""
    text = casefile.read(path)
    tables = casefile.tables(text, str(path))
    file, model, case_text = None, None, ""
    issues: list[Issue] = []
    try:
        file = StudyFile.model_validate(tables, from_file=True)
    except InputError as error:
        issues += error.issues
    if case is None and isinstance(tables.get("case"), str):
        case = Path(path).parent / tables["case"]
    if case is not None:
        try:
            model, case_text = _load_case(case)
        except InputError as error:
            issues += error.issues
    if file is None or model is None:
        raise InputError(issues)
    return StudyInput(text, case_text, setup_of(file, model))


def resolve(file: StudyFile, case: Model | str | Path | None = None) -> StudyInput:
    """Return a study described in Python, as if it had been read: numbers without units are in SI units.

    The case is a model or a file; by default the file that the description names, relative to the working folder.
    """
    model, case_text = _load_case(file.case if case is None else case)
    setup = setup_of(file, model, from_file=False)
    return StudyInput(casefile.to_toml(_with_units(file, setup)), case_text, setup)


def _load_case(case: Model | str | Path) -> tuple[Model, str]:
    """Return a case and its text; raises InputError with the file's name in each location."""
    if isinstance(case, Model):
        return case, casefile.to_toml(case)
    name = str(case)
    text = ""
    try:
        text = casefile.read(case)
        tables = casefile.tables(text, name)
        model = casefile.from_table(tables, Path(case).parent)
        # the matrix of a building from a file beside the case becomes a part of it
        return model, casefile.to_toml(model) if "file" in tables.get("building", {}) else text
    except InputError as error:
        raise InputError(
            [
                issue if issue.location.startswith(name) else replace(issue, location=f"{name}: {issue.location}")
                for issue in error.issues
            ]
        ) from None


def _with_units(file: StudyFile, setup: Setup) -> StudyFile:
    """Return a study with units in all amounts, so that its text can be read."""
    vary = []
    for quantity, variable in zip(file.vary, setup.variables, strict=True):
        key: FieldType = Number("", "") if quantity.times else variable.place.key
        values = None if quantity.values is None else tuple(_write_unit(key, value) for value in quantity.values)
        distribution = quantity.distribution
        if distribution is not None:
            amounts = {name: getattr(distribution, name, None) for name in AMOUNTS}
            texts = {name: _write_unit(key, value) for name, value in amounts.items() if value is not None}
            distribution = distribution.replace(**texts)
        vary.append(quantity.replace(values=values, distribution=distribution))
    limits = []
    for limit in file.limit_state:
        key = next(output.key for output in setup.outputs if output.name == limit.keep)
        bounds = {name: value for name in ("at_most", "at_least") if (value := getattr(limit, name)) is not None}
        limits.append(limit.replace(**{name: _write_unit(key, value) for name, value in bounds.items()}))
    return file.replace(vary=tuple(vary), limit_state=tuple(limits))


def _write_unit(key: FieldType, value: Any) -> Any:
    """Return a value of a key with its unit; what is text already stays as it is."""
    if isinstance(key, Quantity) and not isinstance(value, str):
        return units.write(float(value), key.dimension)
    if isinstance(key, ListOf):
        return tuple(_write_unit(key.each, item) for item in value)
    return value
