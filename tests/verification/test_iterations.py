"""The number of contact iterations: small on the finest mesh however fine it is, where a cold start's grows with it."""

from __future__ import annotations

import pytest

from groundslab.analysis.driver import solve
from groundslab.model.ground import Pasternak, Winkler
from groundslab.model.loads.load_types import PatchLoad
from groundslab.model.model import Model
from groundslab.model.plate import Plate
from groundslab.model.settings import Analysis, Mesh

pytestmark = pytest.mark.slow

GROUNDS = {"winkler": Winkler(k=20e6), "pasternak": Pasternak(k0=32.7862e6, k1=20.660e6)}


def _iterations(ground, refinement, *, nested):
    """Return the contact iterations on the finest mesh of the paper's first plate."""
    model = Model(
        plate=Plate(length_x=9.6, length_y=7.2, thickness=0.2, E=23e9, nu=0.17),
        ground=ground,
        loads=[PatchLoad(q=1e6, x=(-1.2, 1.2), y=(-1.2, 1.2))],
        mesh=Mesh(counts=(16 * refinement, 12 * refinement)),
        analysis=Analysis(nested=nested),
    )
    return max(step.iteration for step in solve(model).steps if step.finest)


@pytest.mark.parametrize("refinement", [1, 3, 6])
@pytest.mark.parametrize("ground", GROUNDS)
def test_nested_iteration_needs_three_steps_at_most(ground, refinement):
    """Started from the forecast, the finest mesh needs three contact iterations or fewer at any refinement."""
    assert _iterations(GROUNDS[ground], refinement, nested=True) <= 3


def test_a_cold_start_needs_more_steps_the_finer_the_mesh():
    """Without nesting, a shear layer's front moves about one node in a step: twice the elements, many more steps."""
    coarse, fine = (_iterations(GROUNDS["pasternak"], n, nested=False) for n in (3, 6))
    assert fine > 1.5 * coarse > 15
