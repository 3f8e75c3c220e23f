"""The described ground as the kernels know it: columns of constants, or soil whose constants follow from gamma."""

from __future__ import annotations

import math

import numpy as np

from groundslab.ground import Column, Layer, consistent_stack, interface_stack, single
from groundslab.model import Layered, Model, Pasternak, SoilLayer, Vlasov, Winkler
from groundslab.vlasov import Soil


def layer_of(layer: SoilLayer) -> Layer:
    """Return the kernel's layer of a described one."""
    bottom = layer.E if layer.E_bottom is None else layer.E_bottom
    change = bottom - layer.E
    moduli = (layer.E, change, 0.0) if layer.variation == "linear" else (layer.E, 0.0, change)
    return Layer(layer.thickness, moduli, layer.nu)


def ground_of(model: Model) -> Soil | Column:
    """Return the ground: a column of constants, or soil whose constants follow from gamma."""
    ground = model.ground
    if isinstance(ground, Winkler):
        return single(winkler_modulus(model), 0.0)
    if isinstance(ground, Pasternak):
        return single(ground.k0, ground.k1)
    printed = ground.formulas == "as printed"
    gamma = None if ground.gamma == "iterate" else float(ground.gamma)
    if isinstance(ground, Vlasov):
        layers = tuple(layer_of(layer) for layer in ground.layers)
        by_profile = ground.mode == "profile" or (ground.mode == "auto" and len(layers) > 1)
        return Soil(layers, "profile" if by_profile else "sinh", printed, gamma)
    return _layered(ground, printed, gamma)


def _layered(ground: Layered, printed: bool, gamma: float | None) -> Soil | Column:
    if ground.coupling == "consistent":
        return consistent_stack(consistent_parts(ground))
    soil = [layer for layer in ground.layers if isinstance(layer, SoilLayer)]
    if soil:
        return Soil(tuple(layer_of(layer) for layer in soil), "interface", printed, gamma)
    given = [layer for layer in ground.layers if not isinstance(layer, SoilLayer)]
    return interface_stack(np.array([layer.k0 for layer in given]), np.array([layer.k1 for layer in given]))


def consistent_parts(ground: Layered) -> list[Layer]:
    """Return the layers of a consistent stack, each split into its sublayers."""
    soil = [layer for layer in ground.layers if isinstance(layer, SoilLayer)]
    return [part for layer in soil for part in layer_of(layer).split(layer.sublayers)]


def winkler_modulus(model: Model) -> float:
    """Return k [Pa/m], given or by Selvadurai's k = 2 E / (a ln(1 + 2 H / a)) with a the longer side (paper (3.1))."""
    ground = model.ground
    assert isinstance(ground, Winkler)
    if ground.k is not None:
        return ground.k
    assert ground.selvadurai is not None
    a = max(model.plate.sides)
    return 2 * ground.selvadurai.E / (a * math.log(1 + 2 * ground.selvadurai.depth / a))


def surfaces_of(ground: Soil | Column) -> int:
    """Return the number of surfaces of the ground that can settle."""
    if isinstance(ground, Column):
        return ground.surfaces
    return len(ground.layers) if ground.way == "interface" else 1
