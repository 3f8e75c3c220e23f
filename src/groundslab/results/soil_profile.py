"""The ground as analyzed: each described column with the mode in which it settled; zones and voids on the mesh."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.discretize.ground import grounds_of
from groundslab.discretize.voids import VoidShares, share_voids
from groundslab.fem.shape_functions import areas
from groundslab.fem.vlasov import Soil
from groundslab.geometry.area_shares import shares
from groundslab.messages import Message
from groundslab.model.ground import ContinuousGround, Continuum, Layered, SoilLayer, Vlasov

if TYPE_CHECKING:
    from groundslab.arrays import Array, Flags
    from groundslab.model.ground import AnyGround
    from groundslab.model.model import Model
    from groundslab.results.results import CombinationResult


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
    below = [layer.E if layer.E_bottom is None else layer.E_bottom for layer in layers]
    return tuple(
        Stratum(float(top), float(bottom), layer.E, E_bottom, layer.variation, layer.nu)
        for top, bottom, E_bottom, layer in zip(ends[:-1], ends[1:], below, layers, strict=True)
    )


def list_columns(model: Model) -> list[tuple[str, tuple[SoilLayer, ...]]]:
    """Return name and layers of each described column: the boreholes, or the ground and then its zones.

    Ground that is not given by E, nu and thickness has no layers.
    """
    if model.boreholes:
        return [(hole.name or Message("borehole {n}", n=n), hole.layers) for n, hole in enumerate(model.boreholes, 1)]
    grounds: list[tuple[str, AnyGround]] = [("ground", model.ground)]
    grounds += [(Message("zone of soil {n}", n=n), zone.ground) for n, zone in enumerate(model.soil_zones, 1)]
    return [(name, _layers(ground)) for name, ground in grounds]


#: So many depths stand below a point, closer near the surface; beside these the borders of layers.
DEPTHS = 16
#: Without a base stresses are shown down to so many of the plate's shorter sides; no deeper than of its longer ones.
WIDTHS, LENGTHS = 2.0, 5.0


def profile_depths(model: Model) -> Array:
    """Return the depths (z,) [m] at which a continuum is listed, closer at the surface, with the borders of layers."""
    bottoms = np.cumsum([layer.thickness for layer in _layers(model.ground)])
    deepest = bottoms[-1] if len(bottoms) else 0.0
    if isinstance(model.ground, Continuum) and model.ground.half_space is not None:
        deepest = max(1.25 * deepest, WIDTHS * min(model.plate.sides))
    deepest = min(deepest, LENGTHS * max(model.plate.sides))
    depths = deepest * np.linspace(0.0, 1.0, DEPTHS + 1) ** 2
    depths_listed: Array = np.unique(np.concatenate([depths, bottoms[bottoms <= deepest]]))
    return depths_listed


def profiles_of(results: CombinationResult) -> tuple[Profile, ...]:
    """Return each described column with the gamma, k0, k1 and mode that it has in one combination.

    All have the same decay of the settlement; a given gamma is that of every column (docs/theory.md, ground that varies
    over the plan).
    """
    model, constants = results.model, results.constants
    if model.lasts(results.limit_state):
        model = model.with_lasting_ground()
    columns, soils = list_columns(model), [ground for ground in grounds_of(model) if isinstance(ground, Soil)]
    if constants.decay is None or len(soils) < len(columns):
        is_one = len(columns) == 1
        k0, k1 = (constants.k0, constants.k1) if is_one else ((), ())
        none = np.zeros(0)
        return tuple(Profile(name, strata_of(layers), None, k0, k1, none, none) for name, layers in columns)
    profiles = []
    for (name, layers), soil in zip(columns, soils, strict=True):
        gamma = soil.gamma_of(constants.decay**2) if soil.gamma is None else soil.gamma
        k0, k1 = (tuple(map(float, values)) for values in soil.layer_parameters(gamma))
        mode = soil.mode(gamma)
        z, psi = (np.zeros(0), np.zeros(0)) if mode is None else (mode.z, mode.psi)
        profiles.append(Profile(name, strata_of(layers), gamma, k0, k1, z, psi))
    return tuple(profiles)


def _layers(ground: AnyGround) -> tuple[SoilLayer, ...]:
    """Return the layers of a ground that are given by E, nu and thickness."""
    if not isinstance(ground, Vlasov | Layered | ContinuousGround):
        return ()
    return tuple(layer for layer in ground.layers if isinstance(layer, SoilLayer))


#: An element of which a region takes all or nothing but for this share is not across its border.
WHOLE = 1e-3


@dataclass(frozen=True, slots=True)
class Coverage:
    """The area of a soil zone or void that counts, where others lie over it not counted [m2]."""

    name: str  # as in the file: "soil_zones[1]"
    drawn: float
    meshed: float  # what the elements take for it
    crossed: float  # of elements that lie in it in part


def crossed_borders(results: CombinationResult) -> tuple[Coverage, ...]:
    """Return the soil zones and voids of which elements take a part, as their borders are no lines of the mesh."""
    model, mesh_plan = results.solved_model, results.mesh_plan
    if not model.soil_zones and not model.contact.voids:
        return ()
    xy = results.ground.nodes[results.ground.elements]
    by_zone = shares(xy, model.zone_rings, mesh_plan.followed_zones, max(model.sides))
    coverages = [_coverage("soil_zones", k, part, part, areas(xy)) for k, part in enumerate(by_zone.T[1:])]
    xy = results.plate.nodes[results.plate.elements]
    k1 = results.constants.k1
    voids = share_voids(model, xy, mesh_plan.followed_voids, steps=len(k1) == 1 and k1[0] == 0)
    coverages += [
        _coverage("contact.voids", k, drawn, meshed, areas(xy))
        for k, (drawn, meshed) in enumerate(zip(voids.drawn.T, _mesh_voids(voids).T, strict=True))
    ]
    return tuple(coverage for coverage in coverages if coverage.crossed > 0)


def _mesh_voids(voids: VoidShares) -> Array:
    """Return the share (mp, v) of each element that it takes for each void, those of one depth by their areas."""
    together = np.stack([voids.drawn[:, voids.of == k].sum(axis=1) for k in range(len(voids.depth))], axis=1)
    part = np.divide(voids.share, together, out=np.zeros_like(together), where=together > 0)
    meshed: Array = voids.drawn * part[:, voids.of]
    return meshed


def _coverage(section: str, number: int, drawn: Array, meshed: Array, area: Array) -> Coverage:
    across: Flags = (drawn > WHOLE) & (drawn < 1 - WHOLE)
    figures = (float(part @ area) for part in (drawn, meshed, across.astype(float)))
    return Coverage(f"{section}[{number + 1}]", *figures)
