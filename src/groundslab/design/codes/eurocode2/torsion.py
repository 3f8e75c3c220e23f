"""Torsion of rectangular webs by a thin-walled tube, as both generations of EN 1992-1-1 have it.

    t_ef = max(A / u, 2 a),  A_k = (b - t_ef) (h - t_ef),  u_k = 2 (b + h - 2 t_ef)      6.3.2(1); 2023: 8.3.3
    tau_t = T_Ed / (2 A_k t_ef)                                                          6.26; 2023: 8.79

A = b h and u = 2 (b + h) are those of the whole rectangle, a is the distance of the longitudinal bars' axes from the
faces. A flange beside the web is not counted on, which is on the safe side; what the slab resists is its own twisting
moment.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.design.rules.webs import Web


@dataclass(frozen=True, slots=True)
class Tube:
    """The walls (k,) that carry torsion: thickness t_ef [m], area A_k [m2] and length u_k [m] of their middle."""

    wall: Array
    area: Array
    length: Array

    @classmethod
    def of(cls, web: Web) -> Tube:
        """Return the tube of a web; one that is too narrow for its bars encloses nothing."""
        b, h = web.b, web.h
        wall = np.maximum(b * h / (2 * (b + h)), 2 * web.axis)
        wide, high = np.maximum(b - wall, 0.0), np.maximum(h - wall, 0.0)
        return cls(wall, wide * high, 2 * (wide + high))

    def stress(self, T: Array) -> Array:
        """Return the shear stress (k,) [Pa] of torsional moments T >= 0 (k,) [N m]; inf where nothing is enclosed."""
        enclosed = 2 * self.area * self.wall
        return np.divide(T, enclosed, out=np.where(T > 0, np.inf, 0.0), where=enclosed > 0)


#: The formulas of a tube, with moments in MN m, stresses in MPa and lengths in m.
FORMULAS = {
    "t_ef": "max(b_w * h / (2 * (b_w + h)), 2 * a_1)",
    "A_k": "(b_w - t_ef) * (h - t_ef)",
    "u_k": "2 * (b_w + h - 2 * t_ef)",
    "tau_t": "T_Ed / (2 * A_k * t_ef)",
}


def steps(web: Web, clauses: tuple[str, str]) -> Iterator[Step]:
    """Yield the calculation of the stress in the tube of one web, clauses being those of the tube and of the stress."""
    tube = Tube.of(web)
    yield Step("distance of the bars' axis from the face", "a_1", web.axis, "m")
    yield Step(
        "thickness of the walls that carry torsion", "t_ef", float(tube.wall[0]), "m", FORMULAS["t_ef"], clauses[0]
    )
    yield Step("area within their middle", "A_k", float(tube.area[0]), "m2", FORMULAS["A_k"], clauses[0])
    yield Step("length of their middle", "u_k", float(tube.length[0]), "m", FORMULAS["u_k"], clauses[0])
    tau = float(tube.stress(web.T)[0]) / MEGA
    yield Step("shear stress of torsion", "tau_t", tau, "MPa", FORMULAS["tau_t"], clauses[1])
