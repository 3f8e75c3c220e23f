"""What `solve` refuses before it solves anything, `check` refuses too."""

from __future__ import annotations

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from groundslab.analysis.check import check
from groundslab.discretize.discretize import discretize
from groundslab.errors import InputError
from groundslab.model.model import Model
from helpers.examples import examples
from helpers.strategies import models, rich_models

FUZZ = settings(deadline=None, derandomize=True, database=None, suppress_health_check=list(HealthCheck))


def refusal(work: object, model: Model) -> set[str]:
    """Return the issues for which a model is refused, none if it is not."""
    try:
        work(model)  # type: ignore[operator]
    except InputError as error:
        return {issue.location for issue in error.issues}
    return set()


@pytest.mark.slow
@settings(FUZZ, max_examples=examples(30))
@given(st.one_of(models(), rich_models(), rich_models(whole=True)))
def test_what_is_refused_in_solving_is_refused_in_checking(model: Model) -> None:
    """Of random models of every kind, check names the same issues as the making of the arrays to be solved."""
    found = refusal(discretize, model)
    assert found <= refusal(check, model)
