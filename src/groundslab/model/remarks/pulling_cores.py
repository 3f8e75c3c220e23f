"""Cores whose walls pull at the slab: where stress by moments is larger than that by the force."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from groundslab.messages import Message, Name
from groundslab.model.loads.core_loads import CoreLoad
from groundslab.model.loads.load_cases import Combination
from groundslab.model.structure.cores import section_of
from groundslab.schema.wording import quote
from groundslab.units import show

if TYPE_CHECKING:
    from groundslab.model.model import Model

#: A part of the largest force per length that is less than this is rounding.
ROUNDING = 1e-9


def pulling_cores(model: Model, combinations: Sequence[Combination]) -> Iterator[tuple[int, Message]]:
    """Yield the positions of cores that pull by their own loads in combinations, with words on the strongest pull."""
    for number, core in enumerate(model.cores):
        loads = [load for load in model.loads if isinstance(load, CoreLoad) and load.core == core.name]
        if not loads:
            continue
        section = section_of(core, model.walls, model.every_plate)
        pulls = list[tuple[float, str, str]]()
        for combination in combinations:
            factors = dict(combination.factors)
            terms = [factors.get(load.case, 0.0) * np.array([load.P, load.M_x, load.M_y]) for load in loads]
            P, *M = sum(terms, np.zeros(3)).tolist()
            ends = [(min(q), part.wall) for part, q in section.line_forces(P, M)]
            q, wall = min(ends)
            if q < -ROUNDING * max(abs(P), *map(abs, M)):
                pulls.append((q, combination.name, wall))
        if pulls:
            q, name, wall = min(pulls)
            yield (
                number,
                Message(
                    "core {core} pulls at the slab in {some} of {many} combinations by its own loads: in {combination} "
                    "with {force} at an end of wall {wall}",
                    core=quote(core.name),
                    some=len(pulls),
                    many=len(combinations),
                    combination=Name(name),
                    force=show(-q, "force per length"),
                    wall=quote(wall),
                ),
            )
