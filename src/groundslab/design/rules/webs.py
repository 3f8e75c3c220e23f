"""Webs of beams under shear and torsion: what they carry, and what they need."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.design.rules.calculation import MEGA, Step

#: What the links that a web needs are called.
ALL_LEGS = "links, all legs together"


class Web(NamedTuple):
    """Webs (k,) of a beam, from face to face of rib and flange, and what they carry."""

    V: Array  # (k,): shear force, >= 0 [N]
    T: Array  # (k,): torsional moment, >= 0 [N m]
    b: float  # width [m]
    h: Array  # (k,): height [m]
    d: Array  # (k,): effective depth [m]
    axis: float  # distance of the longitudinal bars' axes from the faces [m]
    released: bool = False  # whether the beam is taken to resist no torsion, as only compatibility twists it

    def at(self, place: int) -> Web:
        """Return the web at one place alone."""
        one_place = slice(place, place + 1)
        return self._replace(V=self.V[one_place], T=self.T[one_place], h=self.h[one_place], d=self.d[one_place])


class Flange(NamedTuple):
    """The shear between a web and its flange at places (k,)."""

    V: Array  # (k,): shear force of the section, >= 0 [N]
    z: Array  # (k,): lever arm [m]
    share: Array  # (k,): of the flange, on the side that has more of it
    h: Array  # (k,): thickness of the flange [m]
    compressed: Flags  # (k,)

    @property
    def stress(self) -> Array:
        """Return the shear stress (k,) [Pa]."""
        return self.V / self.z * self.share / self.h

    def at(self, place: int) -> Flange:
        """Return the flange at one place alone."""
        one_place = slice(place, place + 1)
        return Flange(
            self.V[one_place], self.z[one_place], self.share[one_place], self.h[one_place], self.compressed[one_place]
        )

    def steps(self) -> Iterator[Step]:
        """Yield the calculation of the stress at one place."""
        yield Step("shear force of the section", "V", float(self.V[0]) / MEGA, "MN")
        yield Step("lever arm", "z", float(self.z[0]), "m")
        yield Step("share of the flange on its larger side", "k_f", float(self.share[0]))
        yield Step("thickness of the flange", "h_f", float(self.h[0]), "m")
        stress = float(self.stress[0]) / MEGA
        yield Step("shear stress between web and flange", "tau", stress, "MPa", "V / z * k_f / h_f")


class WebNeed(NamedTuple):
    """What webs (k,) need; inf where the concrete is too weak for any."""

    links: Array  # (k,): vertical links, all their legs together, closed where there is torsion [m2/m]
    least_links: Array  # (k,) [m2/m]
    along: Array  # (k,): bars along the beam for torsion, spread over its circumference [m2]
    least_along: Array  # (k,) [m2]
    used: Array  # (k,): of what the concrete bears, by shear and torsion together
    torsion: Array  # (k,): torsional moment that counts [N m]
    closed: Array  # (k,): of the links, what both outer legs need for torsion; more legs do not help them [m2/m]

    def links_of(self, legs: Integers) -> Array:
        """Return the links (k,) [m2/m] with numbers of legs (k,), of which the outer ones bear torsion."""
        return np.asarray(self.links + (legs / 2 - 1) * self.closed)


def force_steps(web: Web, symbols: tuple[str, str]) -> Iterator[Step]:
    """Yield shear force, torsional moment and section of one web, by the symbols of both."""
    yield Step("shear force of the section", symbols[0], float(web.V[0]) / MEGA, "MN")
    if not web.released:
        yield Step("torsional moment of the section", symbols[1], float(web.T[0]) / MEGA, "MNm")
    yield Step("width of the web", "b_w", web.b, "m")
    yield Step("height with the flange", "h", float(web.h[0]), "m")
    yield Step("effective depth", "d", float(web.d[0]), "m")
