"""The check of a case or study file as a document for other programs."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from groundslab.case import casefile
from groundslab.errors import InputError
from groundslab.views.interface import documents


def check_file(path: Path, name: str) -> dict[str, Any]:
    """Return the check of a case file, or of a study file with its case, which the document calls by a name."""
    try:
        tables = casefile.tables(casefile.read(path), name)
        if "sampling" in tables:
            from groundslab import study

            return documents.check_study(study.describe_file(path), name)
        return documents.check_case(casefile.from_table(tables, path.parent), name)
    except InputError as error:
        return documents.refuse_case(error, name)
