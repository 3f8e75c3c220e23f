"""The ground as columns of layers: what each is made of, and the constants that an analysis found for it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from groundslab import vlasov
from groundslab.ground import Layer
from groundslab.mesh import Mesh
from groundslab.soil import InterfaceLayer, Layered, Pasternak, SoilLayer, Vlasov, Winkler
from groundslab.subsoil import ground_under, grounds_of, layer_of, sublayers, winkler_modulus
from groundslab.vlasov import Soil

if TYPE_CHECKING:
    from groundslab.model import Model
    from groundslab.plots.wish import Drawn
    from groundslab.results import Array, Results
    from groundslab.soil import AnyGround

#: Samples of psi where its formula is known.
SAMPLES = 81


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
    named: list[tuple[str, AnyGround, tuple[SoilLayer | InterfaceLayer, ...]]]
    if model.boreholes:
        named = [
            (hole.name or f"borehole {n}", model.ground, hole.layers) for n, hole in enumerate(model.boreholes, start=1)
        ]
    else:
        grounds = [("ground", model.ground), *((f"zone {n}", z.ground) for n, z in enumerate(model.soil_zones, 1))]
        named = [(name, ground, getattr(ground, "layers", ())) for name, ground in grounds]
    decays = [decay_squared_of(each.results) for each in drawn]
    profiles = []
    for (name, ground, layers), made in zip(named, grounds_of(model), strict=True):
        found: tuple[Found, ...] = ()
        if isinstance(made, Soil):
            found = tuple(_found(made, each, d2) for each, d2 in zip(drawn, decays, strict=True) if d2 is not None)
            if len(found) > 1 and len({each.gamma for each in found}) == 1:
                found = (replace(found[0], name="all combinations"),)
        profiles.append(Profile(name, _strata(model, ground, layers, found), found))
    return profiles


def decay_squared_of(results: Results) -> float | None:
    """Return int |grad w|^2 / int w^2 [1/m2] that the results' gamma belongs to (2.23); None without gamma."""
    gamma, plate = results.constants.gamma, results.plate
    if gamma is None:
        return None
    everywhere = np.arange(len(plate.elements))
    ground, _ = ground_under(results.model, Mesh(plate.nodes, plate.elements), everywhere, {})
    return (gamma / ground.gamma_of(1.0)) ** 2 if isinstance(ground, Soil) else None


def _found(soil: Soil, drawn: Drawn, decay2: float) -> Found:
    """Return what follows for one column of soil from the decay of a settlement."""
    gamma = soil.gamma_of(decay2) if soil.gamma is None else soil.gamma
    k0, k1 = soil.layer_parameters(gamma)
    if soil.way == "interface":
        return Found(drawn.name, gamma, k0, k1, None, None)
    if soil.way == "profile":
        # the decay that belongs to gamma, which may be given
        mode = vlasov.profile(soil.layers, (gamma / soil.gamma_of(1.0)) ** 2)
        return Found(drawn.name, gamma, k0, k1, mode.z, mode.psi)
    s = np.linspace(0, 1, SAMPLES)
    return Found(drawn.name, gamma, k0, k1, s * float(soil.depth), sinh_mode(gamma, s))


def sinh_mode(gamma: float, s: Array) -> Array:
    """Return psi = sinh(gamma (1 - s)) / sinh gamma (2.19) at relative depths s, without overflow; gamma >= 0."""
    if gamma == 0.0:
        return 1 - s
    psi: Array = np.exp(-gamma * s) * np.expm1(-2 * gamma * (1 - s)) / np.expm1(-2 * gamma)
    return psi


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
