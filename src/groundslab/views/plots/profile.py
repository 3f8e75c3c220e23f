"""The ground as columns of layers: what each is made of, and the constants that an analysis found for it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from groundslab.discretize.ground import layer_of, sublayers, winkler_modulus
from groundslab.fem.foundation import Layer
from groundslab.model.ground import InterfaceLayer, Layered, Pasternak, SoilLayer, Vlasov, Winkler
from groundslab.results import soil_profile

if TYPE_CHECKING:
    from groundslab.arrays import Array
    from groundslab.model.ground import AnyGround
    from groundslab.model.model import Model
    from groundslab.views.plots.request import Drawn


@dataclass(frozen=True, slots=True)
class Stratum:
    """A layer as it is drawn and listed; what is not known of it is None."""

    thickness: float | None  # [m]
    E: tuple[Array, Array] | None  # relative depths and moduli there [Pa]
    nu: float | None
    k0: tuple[float, ...]  # [Pa/m], of its parts or in different combinations; empty if it has none of its own
    k1: tuple[float, ...]  # [Pa m]


@dataclass(frozen=True, slots=True)
class Found:
    """What follows from the gamma of one combination."""

    name: str  # of the combination
    gamma: float
    k0: Array  # [Pa/m], (1,) or one of each layer (L,)
    k1: Array  # [Pa m]
    z: Array | None  # depths [m] and the mode there, if the ground has one over its whole depth
    psi: Array | None


@dataclass(frozen=True, slots=True)
class Profile:
    """The ground at one place: its name, its layers from the top downwards, what the combinations found."""

    name: str
    strata: tuple[Stratum, ...]
    found: tuple[Found, ...]

    @property
    def depth(self) -> float | None:
        """Return the depth of the rigid base [m], None if it is not known."""
        known = [stratum.thickness for stratum in self.strata if stratum.thickness is not None]
        return sum(known) if len(known) == len(self.strata) else None


def profiles_of(model: Model, drawn: Sequence[Drawn]) -> list[Profile]:
    """Return the ground of each borehole, of the ground and its zones, or the one that is everywhere."""
    kinds: list[AnyGround] = [model.ground, *(zone.ground for zone in model.soil_zones)]
    if model.boreholes:
        kinds = [model.ground] * len(model.boreholes)
    given = [hole.layers for hole in model.boreholes] or [getattr(ground, "layers", ()) for ground in kinds]
    columns = zip(*(soil_profile.profiles_of(each.results) for each in drawn), strict=True)
    profiles = []
    for ground, layers, column in zip(kinds, given, columns, strict=True):
        found = tuple(_found(each, own) for each, own in zip(drawn, column, strict=True) if own.gamma is not None)
        if len(found) > 1 and len({each.gamma for each in found}) == 1:
            found = (replace(found[0], name="all combinations"),)
        profiles.append(Profile(column[0].name, _strata(model, ground, layers, found), found))
    return profiles


def _found(drawn: Drawn, column: soil_profile.Profile) -> Found:
    """Return what one combination found of a column of soil."""
    assert column.gamma is not None
    k0, k1 = np.array(column.k0), np.array(column.k1)
    z, psi = (column.z, column.psi) if len(column.z) else (None, None)
    return Found(drawn.name, column.gamma, k0, k1, z, psi)


def _strata(
    model: Model, ground: AnyGround, layers: Sequence[SoilLayer | InterfaceLayer], found: Sequence[Found]
) -> tuple[Stratum, ...]:
    """Return the layers of a described ground."""
    if isinstance(ground, Winkler):
        soil = ground.selvadurai
        E = None if soil is None else (np.array([0.0, 1.0]), np.array([soil.E, soil.E]))
        return (Stratum(None if soil is None else soil.depth, E, None, (winkler_modulus(ground, model),), ()),)
    if isinstance(ground, Pasternak):
        return (Stratum(None, None, None, (ground.k0,), (ground.k1,)),)
    assert isinstance(ground, Vlasov | Layered)
    strata = []
    for number, layer in enumerate(layers):
        if isinstance(layer, InterfaceLayer):
            strata.append(Stratum(None, None, None, (layer.k0,), (layer.k1,)))
            continue
        own = layer_of(layer)
        k0, k1 = _own_constants(ground, own, number, found)
        s = np.linspace(0, 1, 41 if any(own.moduli[1:]) else 2)
        strata.append(Stratum(layer.thickness, (s, own.E(s)), layer.nu, k0, k1))
    return tuple(strata)


def _own_constants(
    ground: Vlasov | Layered, layer: Layer, number: int, found: Sequence[Found]
) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Return k0 and k1 of a layer of a stack: of its sublayers, or in each combination; nothing for Vlasov's ground."""
    if isinstance(ground, Vlasov):
        return (), ()
    if ground.coupling == "interface":
        return tuple(float(each.k0[number]) for each in found), tuple(float(each.k1[number]) for each in found)
    alike = ground.replace(layers=(ground.layers[number],))
    k0, k1 = zip(*(part.stiffnesses for part in sublayers(alike, (layer,))), strict=True)
    return tuple(map(float, k0)), tuple(map(float, k1))
