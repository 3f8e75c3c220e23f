"""The ground as it stands in depth: each described column of layers, with the mode in which it settled."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.discretize.ground import ground_under, grounds_of
from groundslab.fem.mesh import Mesh
from groundslab.fem.vlasov import Soil
from groundslab.model.ground import Layered, SoilLayer, Vlasov

if TYPE_CHECKING:
    from groundslab.arrays import Array
    from groundslab.model.ground import AnyGround
    from groundslab.model.model import Model
    from groundslab.results.results import Results


@dataclass(frozen=True, slots=True)
class Stratum:
    """A layer of soil: where it begins and ends below the plate [m], E at both ends [Pa], how it varies, nu."""

    top: float
    bottom: float
    E: float
    E_bottom: float
    variation: str
    nu: float


@dataclass(frozen=True, slots=True)
class Profile:
    """A described column of soil and what an analysis found of it.

    k0 [Pa/m] and k1 [Pa m] of each layer, or of all together if they settle in one mode: then psi (p,) at depths z (p,)
    [m], 1 at the top and 0 at the base, and its gamma. What there is not is empty, gamma None.
    """

    name: str
    strata: tuple[Stratum, ...]
    gamma: float | None
    k0: tuple[float, ...]
    k1: tuple[float, ...]
    z: Array
    psi: Array


def strata_of(layers: tuple[SoilLayer, ...]) -> tuple[Stratum, ...]:
    """Return described layers with their depths."""
    ends = np.cumsum([0.0, *(layer.thickness for layer in layers)])
    return tuple(
        Stratum(
            float(top),
            float(bottom),
            layer.E,
            layer.E if layer.E_bottom is None else layer.E_bottom,
            layer.variation,
            layer.nu,
        )
        for top, bottom, layer in zip(ends, ends[1:], layers, strict=False)
    )


def described(model: Model) -> list[tuple[str, tuple[SoilLayer, ...]]]:
    """Return name and layers of each described column: the boreholes, or the ground and then its zones.

    Ground that is not given by E, nu and thickness has no layers.
    """
    if model.boreholes:
        return [(hole.name or f"borehole {n}", hole.layers) for n, hole in enumerate(model.boreholes, 1)]
    grounds: list[tuple[str, AnyGround]] = [("ground", model.ground)]
    grounds += [(f"zone of soil {n}", zone.ground) for n, zone in enumerate(model.soil_zones, 1)]
    return [(name, _layers(ground)) for name, ground in grounds]


def profiles_of(results: Results) -> tuple[Profile, ...]:
    """Return each described column with the gamma, k0, k1 and mode that it has in one combination.

    All have the same decay of the settlement, int |grad w|^2 / int w^2, which is that of the mean gamma found;
    a given gamma is that of every column (docs/theory.md, ground that varies over the plan).
    """
    model, plate = results.model, results.plate
    columns = described(model)
    gamma = results.constants.gamma
    whole, _ = ground_under(model, Mesh(plate.nodes, plate.elements), np.arange(len(plate.elements)), {})
    if gamma is None or not isinstance(whole, Soil):
        known = len(columns) == 1
        k0, k1 = (results.constants.k0, results.constants.k1) if known else ((), ())
        return tuple(_without_mode(name, layers, k0, k1) for name, layers in columns)
    decay2 = (gamma / whole.gamma_of(1.0)) ** 2
    found = []
    for (name, layers), soil in zip(columns, grounds_of(model), strict=True):
        assert isinstance(soil, Soil)
        own = soil.gamma_of(decay2) if soil.gamma is None else soil.gamma
        k0, k1 = (tuple(map(float, values)) for values in soil.layer_parameters(own))
        mode = soil.mode(own)
        z, psi = (np.zeros(0), np.zeros(0)) if mode is None else (mode.z, mode.psi)
        found.append(Profile(name, strata_of(layers), own, k0, k1, z, psi))
    return tuple(found)


def _without_mode(name: str, layers: tuple[SoilLayer, ...], k0: tuple[float, ...], k1: tuple[float, ...]) -> Profile:
    return Profile(name, strata_of(layers), None, k0, k1, np.zeros(0), np.zeros(0))


def _layers(ground: AnyGround) -> tuple[SoilLayer, ...]:
    """Return the layers of a ground that are given by E, nu and thickness."""
    if not isinstance(ground, Vlasov | Layered):
        return ()
    return tuple(layer for layer in ground.layers if isinstance(layer, SoilLayer))
