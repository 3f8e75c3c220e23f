"""Fields of bars over the plate: what each layer needs over all ultimate combinations, beside what is laid."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array
from groundslab.design.laid_bars import laid_bars
from groundslab.design.tables import reinforcement
from groundslab.results.fields import BAR_FIELDS, LAYERS
from groundslab.results.results import Results


def bar_fields(combined: Results) -> dict[str, Array]:
    """Return the fields of BAR_FIELDS (n,) at the plate's nodes that there are, in SI units.

    Areas are inf where the concrete is too weak for any reinforcement. Without bars that are laid there is only what is
    required, without ultimate combinations nothing.
    """
    steel, results = combined.model.reinforcement, reinforcement.ultimate_results(combined)
    if steel is None or not results:
        return {}
    found, fields = reinforcement.required_areas(steel, results), dict[str, Array]()
    for layer in LAYERS:
        required = fields[f"required_{layer}"] = reinforcement.largest_areas(found, layer)[0]
        if steel.laid:
            provided = fields[f"provided_{layer}"] = laid_bars(steel, layer, results[0].plate.nodes).area
            fields[f"utilisation_{layer}"] = required / provided
            fields[f"missing_{layer}"] = np.maximum(required - provided, 0.0)
    return {name: fields[name] for name in BAR_FIELDS if name in fields}
