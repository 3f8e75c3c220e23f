"""The slab of an industrial floor as formulas know it: its thinnest part on springs, and what its concrete bears."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.design.codes.en1992_2004.materials import CONCRETE_CLASSES, Concrete, Steel
from groundslab.design.codes.floors import resistance, strips, yield_lines
from groundslab.discretize.ground import grounds_of
from groundslab.fem.foundation import Column
from groundslab.messages import Message
from groundslab.model.design.floors import ACI360Floor, AnyFloor, TR34Floor
from groundslab.model.ground import ContinuousGround
from groundslab.model.model import Model

#: Effective depth over thickness where there is no mesh, as TR34 has it.
FIBER_DEPTH = 0.75


@dataclass(frozen=True, slots=True)
class Slab:
    """What the formulas know of a floor: E [Pa], h [m], nu, k [Pa/m]; whether k stands for an elastic continuum."""

    E: float
    h: float
    nu: float
    k: float
    equivalent: bool = False

    @property
    def l(self) -> float:  # noqa: E743  the field's letter
        """Return the radius of relative stiffness [m]."""
        return yield_lines.relative_stiffness_radius(self.E, self.h, self.nu, self.k)

    @property
    def springs(self) -> str:
        """Return the note on k after a clause, empty where the ground itself has a k."""
        return (
            Message(", with k = {k:.3g MPa/m} equivalent to the continuum", k=self.k / 1e6) if self.equivalent else ""
        )

    @property
    def lam(self) -> float:
        """Return lambda [1/m] of a strip."""
        return strips.characteristic(self.E, self.h, self.k)


def slab_of(model: Model) -> Slab:
    """Return the slab that the formulas use for a model: its thinnest part on its softest ground."""
    plate = model.plate
    h = min([plate.thickness, *(zone.thickness for zone in plate.zones if zone.thickness is not None)])
    grounds = [ground if isinstance(ground, Column) else ground.first_column() for ground in grounds_of(model)]
    k = min(1 / float(np.linalg.inv(column.A0)[0, 0]) for column in grounds)
    return Slab(plate.E, h, plate.nu, k, isinstance(model.ground, ContinuousGround))


def concrete_of(floor: TR34Floor) -> Concrete:
    """Return the concrete of a floor by TR34."""
    f_ck = floor.f_ck if floor.concrete is None else CONCRETE_CLASSES[floor.concrete] * 1e6
    assert f_ck is not None
    return Concrete(f_ck, floor.gamma_c)


def sagging_moment(floor: TR34Floor, concrete: Concrete, h: float) -> float:
    """Return M_p [N m/m]: of fibers or a mesh; plain concrete has none once it has cracked."""
    if floor.f_R1 is not None and floor.f_R4 is not None:
        return resistance.fiber_moment(floor.f_R1, floor.f_R4, h, concrete.gamma_c)
    if floor.mesh_area is not None and floor.mesh_axis is not None:
        return resistance.mesh_moment(floor.mesh_area, h - floor.mesh_axis, Steel(floor.f_yk, floor.gamma_s))
    return 0.0


def effective_depth(floor: TR34Floor, h: float) -> float:
    """Return the effective depth [m] for punching of a floor h [m] thick."""
    return FIBER_DEPTH * h if floor.mesh_axis is None else h - floor.mesh_axis


def allowed_stress(floor: ACI360Floor) -> float:
    """Return the allowed flexural stress [Pa]: f_r / SF, or as repetitions allow; f_r R_e,3 of fiber concrete."""
    ratio = max(1 / floor.safety_factor, floor.R_e3 or 0.0)
    if floor.repetitions is not None:
        ratio = min(ratio, resistance.allowed_ratio(floor.repetitions))
    return floor.f_r * min(ratio, 1.0)


def friction_stress(floor: AnyFloor) -> float:
    """Return the tension [Pa] that friction adds where shrinkage is restrained."""
    if floor.friction is None or floor.joint_spacing is None:
        return 0.0
    return resistance.restraint_stress(floor.friction, floor.unit_weight, floor.joint_spacing)
