"""The one column of soil that grounds are compared on, and the grounds that follow from it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from groundslab.errors import InputError, Issue
from groundslab.model.ground import AnyGround, Continuum, HalfSpace, SoilLayer, Vlasov
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
    """Layers of soil from the top downwards, what lies below them, and what a reader must know about the choice."""

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


#: Grounds beside the continuum that follow from the soil by their kinds, in the order in which they are shown.
FROM_SOIL: dict[str, Callable[[SoilColumn], AnyGround]] = {
    "vlasov": lambda soil: Vlasov(layers=soil.finite_layers),
}


def find_soil(model: Model) -> SoilColumn:
    """Return the column of soil of a model; raises InputError if its ground is not given by layers of soil."""
    if model.soil_zones:
        hint = "compare each zone in a case of its own, with its ground as [ground]"
        raise InputError([Issue("soil_zones", "zones of other soil", "the same layers everywhere", hint)])
    ground, notes = model.ground, list[str]()
    layers: Sequence[Any] = getattr(ground, "layers", ())
    half_space = ground.half_space if isinstance(ground, Continuum) else None
    base = BASE_DEPTH * min(model.plate.sides)
    if model.boreholes:
        hole, name = _middle_borehole(model)
        layers = hole.layers
        notes.append(f"All grounds have the layers of {name} everywhere, the borehole nearest to the plate's middle.")
    if not all(isinstance(layer, SoilLayer) for layer in layers) or not (layers or half_space):
        found = f"{quote(ground.kind)} without layers of soil"
        hint = 'such as kind = "continuum"; from springs alone no continuum follows'
        raise InputError([Issue("ground", found, "layers given by E, nu and thickness", hint)])
    if half_space is not None:
        notes.append(
            f"The continuum has a half-space below its layers. Vlasov's ground needs a base: it ends {base:g} m below "
            f"them, {BASE_DEPTH:g} times the plate's shorter side."
        )
    # sublayers belong to the consistent coupling alone
    return SoilColumn(
        tuple(layer.model_copy(update={"sublayers": 1}) for layer in layers), half_space, base, tuple(notes)
    )


def _middle_borehole(model: Model) -> tuple[Borehole, str]:
    """Return the borehole nearest to the plate's middle, and what it is called."""
    x0, x1, y0, y1 = model.plate.bounds
    middle = (x0 + x1) / 2, (y0 + y1) / 2
    number, hole = min(enumerate(model.boreholes, 1), key=lambda each: math.dist((each[1].x, each[1].y), middle))
    return hole, hole.name or f"boreholes[{number}]"


def on_continuum(model: Model, soil: SoilColumn) -> Model:
    """Return a model on the continuum of a column of soil; raises InputError if it cannot be one."""
    cell = model.ground.cell if isinstance(model.ground, Continuum) else None
    given = {"layers": soil.layers, "half_space": soil.half_space, "cell": cell}
    # described by keys, so that issues name them as the case does
    ground = {"kind": "continuum"} | {name: value for name, value in given.items() if value is not None}
    return model.replace(ground=ground, beyond=BEYOND, boreholes=())
