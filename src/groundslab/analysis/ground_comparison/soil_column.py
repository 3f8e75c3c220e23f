"""The one column of soil that grounds are compared on, and the grounds that follow from it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from groundslab.errors import InputError, Issue
from groundslab.messages import Message, Name
from groundslab.model.ground import (
    AnyGround,
    ConstrainedModulus,
    Continuum,
    HalfSpace,
    SoilLayer,
    Vlasov,
    carry_shear,
)
from groundslab.model.loads.load_types import presses_ground
from groundslab.model.model import Model
from groundslab.model.settings import Beyond
from groundslab.model.varying_ground import Borehole
from groundslab.schema.wording import quote

#: Grounds that need a base have one so deep in a half-space, in lengths of the plate's shorter side.
BASE_DEPTH = 2.0
#: Every ground that carries shear goes on beyond the plate, as the continuum does.
BEYOND = Beyond(kind="infinite")


@dataclass(frozen=True, slots=True)
class SoilColumn:
    """The ground as described, its layers, what lies below them, and what a reader must know about the choice."""

    given: AnyGround
    layers: tuple[SoilLayer, ...]
    half_space: HalfSpace | None
    base: float  # how deep below the layers a half-space is cut off where it must end [m]
    notes: tuple[str, ...]

    @property
    def finite_layers(self) -> tuple[SoilLayer, ...]:
        """Return the layers, of a half-space the part above the base."""
        if self.half_space is None:
            return self.layers
        return (*self.layers, SoilLayer(E=self.half_space.E, nu=self.half_space.nu, thickness=self.base))


def _make_constrained(soil: SoilColumn) -> ConstrainedModulus:
    """Return the layers compressed by Boussinesq's stresses, with relief and limit depth where they are described."""
    if isinstance(soil.given, ConstrainedModulus):
        return soil.given.replace(layers=soil.finite_layers)
    return ConstrainedModulus(layers=soil.finite_layers)


#: Grounds beside the continuum that follow from the soil by their kinds, in the order in which they are shown.
FROM_SOIL: dict[str, Callable[[SoilColumn], AnyGround]] = {
    "constrained modulus": _make_constrained,
    "vlasov": lambda soil: Vlasov(layers=soil.finite_layers),
}


def find_soil(model: Model) -> SoilColumn:
    """Return the column of soil of a model; raises InputError if its ground is not given by layers of soil."""
    if model.soil_zones:
        hint = "compare each zone in a separate case, with its ground as [ground]"
        raise InputError([Issue("soil_zones", "zones of other soil", "the same layers everywhere", hint)])
    ground, notes = model.ground, list[str]()
    layers: Sequence[Any] = getattr(ground, "layers", ())
    half_space = ground.half_space if isinstance(ground, Continuum) else None
    base = BASE_DEPTH * max(min(plate.sides) for plate in model.every_plate)
    if model.boreholes:
        hole, name = _middle_borehole(model)
        layers = [layer for layer in hole.layers if layer.thickness]
        notes.append(
            Message(
                "All grounds have the layers of {name} everywhere, the borehole nearest to the plate's middle.",
                name=Name(name),
            )
        )
    if not all(isinstance(layer, SoilLayer) for layer in layers) or not (layers or half_space):
        no_layers = Message("{name} without layers of soil", name=quote(ground.kind))
        hint = 'such as kind = "continuum"; springs alone do not define a continuum'
        raise InputError([Issue("ground", no_layers, "layers given by E, nu and thickness", hint)])
    if half_space is not None:
        notes.append(
            Message(
                "The continuum has a half-space below its layers. Other layered grounds need a base: they end "
                "{base:g m} below these, {base_depth:g} times the plate's shorter side.",
                base=base,
                base_depth=BASE_DEPTH,
            )
        )
    if any(map(presses_ground, model.loads)):
        notes.append("Loads off the plate have no effect on springs, and act on the other grounds only.")
    # sublayers belong to the consistent coupling alone
    plain = tuple(layer.model_copy(update={"sublayers": 1}) for layer in layers)
    return SoilColumn(ground, plain, half_space, base, tuple(notes))


def _middle_borehole(model: Model) -> tuple[Borehole, str]:
    """Return the borehole nearest to the plate's middle, and what it is called."""
    x0, x1, y0, y1 = model.plate.bounds
    middle = (x0 + x1) / 2, (y0 + y1) / 2
    number, hole = min(
        enumerate(model.boreholes, 1), key=lambda numbered: math.dist((numbered[1].x, numbered[1].y), middle)
    )
    return hole, hole.name or f"boreholes[{number}]"


def on_continuum(model: Model, soil: SoilColumn) -> Model:
    """Return a model on the continuum of a column of soil; raises InputError if it cannot be one."""
    keys = {"layers": soil.layers, "half_space": soil.half_space, "cell": getattr(soil.given, "cell", None)}
    # described by keys, so that issues name them as the case does
    ground = {"kind": "continuum"} | {name: value for name, value in keys.items() if value is not None}
    return model.replace(ground=ground, beyond=BEYOND, boreholes=())


def on_ground(model: Model, ground: AnyGround) -> Model:
    """Return a model on another ground, without the loads beside the plate where these have no effect."""
    loads = model.loads if any(carry_shear(ground)) else tuple(load for load in model.loads if not presses_ground(load))
    return model.model_copy(update={"ground": ground, "beyond": BEYOND, "loads": loads})
