"""Whatever is asked for in sound words ends in a certified result or a clear error."""

from __future__ import annotations

from hypothesis import HealthCheck, given, settings

from groundslab.analysis import solve
from groundslab.discretise import discretise
from groundslab.errors import GroundslabError
from groundslab.statics import require_equilibrium
from strategies import models


@settings(max_examples=250, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
@given(models())
def test_any_model_ends_in_a_certified_result_or_a_clear_error(model):
    """Of random models of all kinds none crashes, warns, or gives a result that does not fulfil the equations."""
    try:
        results = solve(model)
    except GroundslabError as error:
        said = str(error)
        results = None
    if results is None:
        assert len(said) > 20
    else:
        assert results.certificate.holds
        assert all(abs(value) < float("inf") for value in results.plate.settlement)


@settings(max_examples=60, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
@given(models())
def test_most_models_have_a_result(model):
    """An ordinary model, without misprinted formulas and with a load that can be balanced, does give a result."""
    if getattr(model.ground, "formulas", "exact") == "as printed":
        return
    try:
        require_equilibrium(discretise(model))
    except GroundslabError:
        return
    assert solve(model).certificate.holds
