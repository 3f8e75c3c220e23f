"""What bears the slab without being known: point supports without a size, and edges of the plate that are held.

Punching over a support without a diameter cannot be checked. Supported edges have no limit, and the analysis keeps no
force of theirs: what they carry is the rest of the loads. Where that pulls the plate down, or the loads' resultant does
not lie over the plate, no check sees what holds it.
"""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.basis.check import HELD_EDGE, DesignCheck, not_judged, some
from groundslab.design.basis.combinations import solved_results
from groundslab.design.checks.equilibrium import lies_under
from groundslab.design.demands.loads.column_loads import acting_inside, factored_sums
from groundslab.design.demands.perimeters import outline
from groundslab.design.demands.support_forces import NOTHING
from groundslab.model.loads.load_cases import SERVICEABILITY
from groundslab.model.model import Model
from groundslab.model.plate import Edges
from groundslab.model.supports import LineSupport
from groundslab.results.results import CombinationResult, Results

PUNCHING, HELD = "punching over supports", "edges that hold down"


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield which supports have no size, that supported edges are not checked, and how much they hold down."""
    model = combined.model
    bare = [
        support.name or f"support {number}"
        for number, support in enumerate(model.supports, start=1)
        if not isinstance(support, LineSupport) and support.diameter is None
    ]
    if bare and model.reinforcement is not None:
        words = f"punching over {some(bare)} is not checked, as they have no diameter"
        yield DesignCheck(PUNCHING, "not checked", words)
    if not _has_held_edges(model):
        return
    results = [result for result in solved_results(combined) if result.limit_state not in SERVICEABILITY]
    pulls = [(-_carried_by_edges(result), result) for result in results]
    pull, worst = max(pulls, key=lambda each: each[0], default=(0.0, None))
    if worst is not None and pull > NOTHING * abs(worst.certificate.load):
        words = f'supported edges hold the plate down with {pull / 1e3:.4g} kN in "{worst.combination}"'
        yield not_judged(HELD, HELD_EDGE, words, combination=worst.combination)
    elif tilting := [result.combination for result in results if _tilts_without_edges(result)]:
        words = f"without its supported edges the plate tilts in {some(tilting)}"
        yield not_judged(HELD, HELD_EDGE, words, combination=tilting[0])
    else:
        yield DesignCheck(HELD, "not checked", "what supported edges of the plate carry is not checked")


def _has_held_edges(model: Model) -> bool:
    """Return whether any edge of the plate is supported."""
    return model.plate.support != "free" or model.plate.edges != Edges()


def _carried_by_edges(results: CombinationResult) -> float:
    """Return what the plate's edges push up [N]: what neither ground nor supports carry of the loads."""
    ground = float(results.plate.contact_force.sum())
    return results.certificate.load - ground - sum(support.total for support in results.supports)


def _tilts_without_edges(results: CombinationResult) -> bool:
    """Return whether the loads' resultant does not lie over the plate, so that pressure under it cannot balance it."""
    under = outline(results.plate).convex_hull
    sums = factored_sums(results, acting_inside(results, under, ()))
    return not lies_under(under, sums, abs(results.certificate.load))
