"""A study file and the case file that it names, read from the disk or from the folder of a study."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from groundslab import units
from groundslab.case import casefile
from groundslab.errors import InputError, Issue
from groundslab.model.model import Model
from groundslab.schema.fields import FROM_FILE, FieldType, ListOf, Number, Quantity
from groundslab.study.definition.distributions import AMOUNTS
from groundslab.study.definition.schema import StudyFile
from groundslab.study.definition.setup import Setup, setup_of


@dataclass(frozen=True, eq=False)
class Read:
    """Both files: their texts and what they describe."""

    study_text: str
    case_text: str
    setup: Setup

    @property
    def study_sha256(self) -> str:
        """Return the SHA-256 of the study file's text."""
        return sha256(self.study_text)

    @property
    def case_sha256(self) -> str:
        """Return the SHA-256 of the case file's text."""
        return sha256(self.case_text)


def sha256(text: str) -> str:
    """Return the SHA-256 of a text in UTF-8."""
    return hashlib.sha256(text.encode()).hexdigest()


def read(path: str | Path, case: Model | str | Path | None = None) -> Read:
    """Return a study file with its case, or another one; raises InputError with all faults of both."""
    text = casefile.read(path)
    name = str(path)
    issues: list[Issue] = []
    file, model, case_text = None, None, ""
    tables = casefile.tables(text, name)
    try:
        file = StudyFile.model_validate(tables, context=FROM_FILE)
    except InputError as error:
        issues += error.issues
    named = tables.get("case")
    where = Path(path).parent / named if isinstance(named, str) else None
    if isinstance(case, Model):
        model, case_text, where = case, casefile.to_toml(case), None
    elif case is not None:
        where = Path(case)
    if where is not None:
        try:
            case_text = casefile.read(where)
            model = casefile.loads(case_text, str(where))
        except InputError as error:
            issues += _of_case(error, where)
    if file is None or model is None:
        raise InputError(issues)
    return Read(text, case_text, setup_of(file, model))


def made(file: StudyFile, case: Model | str | Path | None = None) -> Read:
    """Return a study described in Python, as if it had been read: numbers without units are in SI units.

    The case is a model, or a file: the one named, or that which the description names from the working folder on.
    """
    if isinstance(case, Model):
        model, case_text = case, casefile.to_toml(case)
    else:
        where = Path(file.case if case is None else case)
        case_text = casefile.read(where)
        try:
            model = casefile.loads(case_text, str(where))
        except InputError as error:
            raise InputError(_of_case(error, where)) from None
    setup = setup_of(file, model, from_file=False)
    return Read(casefile.to_toml(_with_units(file, setup)), case_text, setup)


def _with_units(file: StudyFile, setup: Setup) -> StudyFile:
    """Return a study whose amounts all have units, so that its text can be read."""
    vary = []
    for each, variable in zip(file.vary, setup.variables, strict=True):
        key: FieldType = Number("", "") if each.times else variable.place.key
        values = None if each.values is None else tuple(_written(key, value) for value in each.values)
        distribution = each.distribution
        if distribution is not None:
            amounts = {name: getattr(distribution, name, None) for name in AMOUNTS}
            given = {name: _written(key, value) for name, value in amounts.items() if value is not None}
            distribution = distribution.replace(**given)
        vary.append(each.replace(values=values, distribution=distribution))
    limits = []
    for limit in file.limit_state:
        dimension = next(output.dimension for output in setup.outputs if output.name == limit.keep)
        key = Quantity(dimension, "", "") if dimension else Number("", "")
        given = {name: value for name in ("at_most", "at_least") if (value := getattr(limit, name)) is not None}
        limits.append(limit.replace(**{name: _written(key, value) for name, value in given.items()}))
    return file.replace(vary=tuple(vary), limit_state=tuple(limits))


def _written(key: FieldType, value: Any) -> Any:
    """Return a value of a key with its unit; what is text already stays as it is."""
    if isinstance(key, Quantity) and not isinstance(value, str):
        return units.write(float(value), key.dimension)
    if isinstance(key, ListOf):
        return tuple(_written(key.each, item) for item in value)
    return value


def _of_case(error: InputError, where: Path) -> list[Issue]:
    """Return the faults of the case with its file's name in each place."""
    named = str(where)
    return [
        issue
        if issue.location.startswith(named)
        else Issue(f"{named}: {issue.location}", issue.found, issue.expected, issue.hint)
        for issue in error.issues
    ]
