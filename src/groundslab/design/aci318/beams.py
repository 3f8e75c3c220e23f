"""Beams by ACI 318-19 beyond what they share with slabs: least bars (9.6.1.2) and links (22.5.8.5.3, 9.6.3.4).

    A_s >= max(0.25 (f'c)^(1/2), 1.4 MPa) / f_y b_w d,    f'c in MPa

f_y is at most 550 MPa there (9.6.1.2).
"""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array
from groundslab.design.aci318 import shear
from groundslab.design.aci318.case_materials import materials
from groundslab.model.design.reinforcement import Reinforcement

_MPA = 1e6
#: The largest f_y that counts in the least bars [Pa].
MOST_F_Y = 550 * _MPA


def minimum(steel: Reinforcement, _: str, d: float, __: float) -> float:
    """Return the least bars in tension over the width of the web [m], for a depth [m]."""
    concrete, bars = materials(steel)
    return max(0.25 * concrete.root, 1.4 * _MPA) / min(bars.f_y, MOST_F_Y) * d


def links(steel: Reinforcement, _: str, v: Array, d: float) -> Array:
    """Return links per area in plan (n,) [m2/m2] for shear forces over the width (n,) [N/m]; inf where none help."""
    concrete, bars = materials(steel)
    return np.array([shear.links(float(force), d, concrete, bars) for force in v])
