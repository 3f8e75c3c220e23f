"""From described bars and concrete to the laws by which the plate's elements crack."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.discretize.nodal_loads import materials
from groundslab.fem import plate
from groundslab.fem.cracked_section import (
    STEEL_MODULUS,
    Bars,
    CrackedSections,
    cracked_section,
    mean_tensile_strength,
    uncracked_section,
)
from groundslab.model.design.laid_bars import laid_bars
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.model import Model

#: beta of 7.19 by the duration of the loads.
BETA = {"long": 0.5, "short": 1.0}


def cracked_sections(model: Model, section: Integers, centers: Array) -> CrackedSections | None:
    """Return how the plate's elements crack, with the bars at their centers; None if cracking is not asked for.

    section (m,) is the number of each element's section, by zones of thickness; centers are (m, 2) [m].
    """
    cracking, steel = model.cracking, model.reinforcement
    if cracking is None:
        return None
    assert steel is not None
    E, nu, h = np.array(materials(model))[section].T
    E = E / (1 + cracking.creep)  # 7.20
    n = STEEL_MODULUS / E
    f_ct = cracking.f_ct or mean_tensile_strength(_strength(steel))
    warp = cracking.shrinkage * n  # 7.21, times S / I
    B_I, shrinkage_I = (np.empty((len(h), 2)) for _ in range(2))
    B_II, M_cr, shrinkage = (np.empty((len(h), 2, 2)) for _ in range(3))
    for axis in (0, 1):
        bars = _bars(steel, axis, centers)
        z, second, first = uncracked_section(h, bars, n)
        B_I[:, axis], shrinkage_I[:, axis] = E * second, warp * first / second
        for face, (sign, far) in enumerate(((1, h - z), (-1, z))):
            M_cr[:, axis, face] = f_ct * second / far
            _, cracked, first = cracked_section(h, bars, n, top=sign < 0)
            B_II[:, axis, face] = E * cracked
            shrinkage[:, axis, face] = np.maximum(warp * first / cracked - sign * shrinkage_I[:, axis], 0.0)
    return CrackedSections(
        B_I=B_I,
        B_II=B_II,
        M_cr=M_cr,
        shrinkage_I=shrinkage_I,
        shrinkage=shrinkage,
        nu=nu,
        shear=np.array([plate.shear_rigidity(*part, model.plate.shear_factor) for part in zip(E, nu, h, strict=True)]),
        beta=np.full(len(h), BETA[cracking.duration]),
    )


def _bars(steel: Reinforcement, axis: int, places: Array) -> Bars:
    """Return the bars provided along x or y at places (m, 2) [m]; those of zones lie as deep as their layer."""
    below, above = (laid_bars(steel, f"{face}_{'xy'[axis]}", places).area for face in ("bottom", "top"))
    return Bars((below, above), (steel.bottom_axes[axis], steel.top_axes[axis]))


def _strength(steel: Reinforcement) -> float:
    """Return f_ck [Pa], which stands first in the name of a class."""
    if steel.f_ck is not None:
        return steel.f_ck
    assert steel.concrete is not None
    return float(steel.concrete[1:].split("/")[0]) * 1e6
