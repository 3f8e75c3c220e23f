"""Results in another language."""

from __future__ import annotations

from dataclasses import replace

from groundslab.languages import Language
from groundslab.results.results import Results


def in_language(results: Results, language: Language) -> Results:
    """Return results of a case that asks for a language."""
    project = {} if results.model.project is None else results.model.project.model_dump()
    model = results.model.replace(project={**project, "language": language})
    placed = results.solved_model.replace(project={**project, "language": language})
    kept = {name: replace(each, model=model, solved_model=placed) for name, each in results.results.items()}
    return replace(results, model=model, results=kept)
