"""What lies below the surface: bonded elastic layers, or layers that settle by the stresses of a half-space."""

from __future__ import annotations

import functools
from collections.abc import Hashable
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from groundslab.arrays import Array
from groundslab.fem.continuum.kernels import SurfaceKernel, layered_kernel
from groundslab.fem.continuum.transfer import ElasticLayer, surface_compliance


class Medium(Hashable, Protocol):
    """Ground that is the same everywhere over the plan."""

    def compliance(self, k: Array) -> Array:
        """Return T(k) (n,) [m/Pa], the settlement by a pressure of amplitude one and wave numbers k (n,) [1/m]."""
        ...

    def kernel(self) -> SurfaceKernel:
        """Return the settlement by a unit force."""
        ...


@dataclass(frozen=True, slots=True)
class BondedLayers:
    """Elastic layers bonded to each other, from the top, on a rigid base unless the last one is a half-space."""

    layers: tuple[ElasticLayer, ...]

    def compliance(self, k: Array) -> Array:
        """Return T(k) (n,) [m/Pa]."""
        return surface_compliance(self.layers, k)

    def kernel(self) -> SurfaceKernel:
        """Return the settlement by a unit force."""
        return layered_kernel(self.layers)


@dataclass(frozen=True, slots=True)
class StressedLayers:
    """Layers that are compressed, without moving sideways, by the vertical stresses of a homogeneous half-space.

    Boussinesq's stress by a pressure cos kx is (1 + k z) exp(-k z) times it, by a unit force 3 z^3 / (2 pi R^5). Its
    integral from z downwards, (2 / k + z) exp(-k z) and (2 / R + z^2 / R^3) / (2 pi), is divided by the constrained
    modulus of each layer (DIN 4019). Nothing settles below the last one.
    """

    modulus: tuple[float, ...]  # [Pa]: constrained one of each layer, from the top
    thickness: tuple[float, ...]  # [m]

    def compliance(self, k: Array) -> Array:
        """Return T(k) (n,) [m/Pa]."""
        z = np.concatenate([[0.0], np.cumsum(self.thickness)])[:, None]
        # where k z is next to nothing the stress is the pressure
        small = np.minimum(k * z, 1e3)
        below = np.where(small > 1e-4, (2 / k + z) * np.exp(-small), 2 / k - z)
        compliance: Array = (-np.diff(below, axis=0) / np.array(self.modulus)[:, None]).sum(axis=0)
        return compliance

    def kernel(self) -> SurfaceKernel:
        """Return the settlement by a unit force."""
        flexible = np.append(1 / np.array(self.modulus), 0.0)
        steps, depths = np.diff(flexible), np.cumsum(self.thickness)

        def smooth(r: Array) -> Array:
            settlement = np.zeros(np.shape(r))
            for step, z in zip(steps, depths, strict=True):
                R = np.hypot(r, z)
                settlement += step * (2 / R + z**2 / R**3) / (2 * np.pi)
            return settlement

        return SurfaceKernel(2 * float(flexible[0]), smooth, float(depths[0]))


@functools.lru_cache(64)
def _compliances(medium: Medium) -> tuple[Array, Array]:
    """Return lengths l (n,) [m] from far below to far above those of slabs, and T(1 / l) (n,) [m/Pa]."""
    lengths = np.geomspace(1e-4, 1e5, 2000)
    return lengths, medium.compliance(1 / lengths)


def elastic_length(medium: Medium, D: float) -> float:
    """Return the length l [m] at which ground and a plate of bending rigidity D [N m] resist waves cos(x / l) alike.

    There 1 / T(1 / l) = D / l^4, which is smaller the longer the waves are.
    """
    lengths, T = _compliances(medium)
    ratio = np.log(D * T / lengths**4)
    return float(np.exp(np.interp(0.0, -ratio, np.log(lengths))))
