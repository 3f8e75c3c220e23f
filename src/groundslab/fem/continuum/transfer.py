"""Bonded elastic layers under a pressure p cos(k x): how much their surfaces settle and what they carry.

With u = U(z) sin kx and w = W(z) cos kx, z downwards, the state (U, W, tau, sigma) of plane strain follows the linear
equations U' = k W + tau / mu, W' = (sigma - lambda k U) / (lambda + 2 mu), tau' = k sigma_x, sigma' = -k tau with
sigma_x = (lambda + 2 mu) k U + lambda W' (equilibrium and Hooke's law). Layer by layer, from below, a compliance takes
the tractions on a surface to its displacements; all wave numbers are one batch of small matrices.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array

#: Layers of less than this times 1 / k are crossed by a power series, which exponentials that cancel cannot spoil.
THIN = 0.5
#: The terms of that series: THIN^TERMS / TERMS! is below rounding.
TERMS = 16
#: Layers deeper than this times 1 / k do not feel the surface.
DEEP = 50.0


@dataclass(frozen=True, slots=True)
class ElasticLayer:
    """A homogeneous isotropic layer, or with infinite thickness the half-space below all layers."""

    E: float  # [Pa]
    nu: float
    thickness: float  # [m]

    @property
    def mu(self) -> float:
        """Return the shear modulus [Pa]."""
        return self.E / (2 * (1 + self.nu))

    @property
    def lame(self) -> float:
        """Return Lame's lambda [Pa]."""
        return self.E * self.nu / ((1 + self.nu) * (1 - 2 * self.nu))

    @property
    def oedometric(self) -> float:
        """Return the constrained modulus Ec = lambda + 2 mu [Pa]."""
        return self.lame + 2 * self.mu

    @property
    def half_space(self) -> float:
        """Return 2 (1 - nu^2) / E [1/Pa], k T(k) of a half-space of this soil (Boussinesq)."""
        return 2 * (1 - self.nu**2) / self.E


def surface_compliance(layers: Sequence[ElasticLayer], k: Array) -> Array:
    """Return T(k) (n,) [m/Pa], the settlement of the surface by a pressure of amplitude one and wave numbers k (n,).

    Parameters
    ----------
    layers : sequence of ElasticLayer
        From the top downwards. They lie on a rigid rough base, unless the last one is a half-space.
    k : (n,) array of float
        Wave numbers [1/m], above zero.

    Returns
    -------
    (n,) array of float
        T(k).
    """
    return compliances(layers, k)[0][:, 1, 1]


def compliances(layers: Sequence[ElasticLayer], k: Array) -> list[Array]:
    """Return for the top of each layer (U, W) by tractions (tau, sigma) that act on what lies below, (n, 2, 2) each.

    The tractions act in the directions of u and w. In k times displacements, they are those of a layer with k = 1.
    """
    k = np.asarray(k, dtype=float)
    matrices: list[Array] = []
    below = np.zeros((len(k), 2, 2))
    for layer in reversed(layers):
        if np.isinf(layer.thickness):
            below = np.broadcast_to(_half_space(layer), below.shape) / k[:, None, None]
        else:
            below = _cross(layer, k, below)
        matrices.append(below)
    return matrices[::-1]


def carry_down(layers: Sequence[ElasticLayer], k: Array) -> tuple[Array, Array]:
    """Return W [m/Pa] and sigma at the top of each layer, (layers, n) each, by a pressure of amplitude one.

    sigma is the vertical stress as a share of the pressure, compression positive. Where nothing arrives both are zero.
    """
    flexible = compliances(layers, k)
    traction = np.broadcast_to([0.0, 1.0], (len(k), 2))
    settlement, stress = [flexible[0][:, 1, 1]], [traction[:, 1]]
    for layer, below in zip(layers[:-1], flexible[1:], strict=True):
        u = _through(layer, np.asarray(k, dtype=float), below, (flexible[len(settlement) - 1] @ traction[..., None]))
        traction = np.linalg.solve(below, u)[..., 0]
        settlement.append(u[:, 1, 0])
        stress.append(traction[:, 1])
    return np.stack(settlement), np.stack(stress)


def _half_space(layer: ElasticLayer) -> Array:
    """Return k times (U, W) of a half-space by tractions (tau, sigma) on its surface, (2, 2)."""
    D, S = _decaying(layer, np.zeros(1))
    compliance: Array = D[0] @ np.linalg.inv(-S[0])
    return compliance


def _decaying(layer: ElasticLayer, kz: Array) -> tuple[Array, Array]:
    """Return (U, W) and (tau, sigma) / k of the two solutions that decay downwards, (n, 2, 2) each, without exp(-kz).

    (U, W) = (1, 1) and (kz, kappa + kz) with kappa = 3 - 4 nu.
    """
    kappa, ones = 3 - 4 * layer.nu, np.ones_like(kz)
    U, W = np.stack([ones, kz]), np.stack([ones, kappa + kz])
    dU, dW = np.stack([-ones, 1 - kz]), np.stack([-ones, 1 - kappa - kz])
    tau = layer.mu * (dU - W)
    sigma = layer.oedometric * dW + layer.lame * U
    return np.stack([U, W]).transpose(2, 0, 1), np.stack([tau, sigma]).transpose(2, 0, 1)


def _cross(layer: ElasticLayer, k: Array, below: Array) -> Array:
    """Return the compliance (n, 2, 2) of a layer's top, of that of its bottom."""
    thin = k * layer.thickness < THIN
    compliance = np.empty_like(below)
    compliance[thin] = _cross_thin(layer, k[thin], below[thin])
    Stt, Stb, Sbb = _stiffness(layer, k[~thin])
    inner = below[~thin] @ np.linalg.inv(Sbb @ below[~thin] + np.eye(2))
    compliance[~thin] = np.linalg.inv(Stt - Stb @ inner @ Stb.swapaxes(1, 2))
    return compliance


def _through(layer: ElasticLayer, k: Array, below: Array, u: Array) -> Array:
    """Return the displacements (n, 2, 1) of a layer's bottom by those of its top, with the compliance below."""
    thin = k * layer.thickness < THIN
    displacements = np.zeros_like(u)
    P = _propagator(layer, k[thin])
    inner = P[:, :2, :2] @ below[thin] + P[:, :2, 2:] @ _signed(k[thin])
    displacements[thin] = below[thin] @ np.linalg.solve(inner, u[thin])
    _, Stb, Sbb = _stiffness(layer, k[~thin])
    inner = below[~thin] @ np.linalg.inv(Sbb @ below[~thin] + np.eye(2))
    displacements[~thin] = -inner @ Stb.swapaxes(1, 2) @ u[~thin]
    return displacements


def _signed(k: Array) -> Array:
    """Return what makes state variables (tau, sigma) / k of tractions on what lies below, (n, 2, 2)."""
    return -np.eye(2) / k[:, None, None]


def _propagator(layer: ElasticLayer, k: Array) -> Array:
    """Return what takes the state (U, W, tau / k, sigma / k) from the bottom of a thin layer to its top, (n, 4, 4)."""
    mu, lame, Ec = layer.mu, layer.lame, layer.oedometric
    A = np.array(
        [
            [0.0, 1.0, 1 / mu, 0.0],
            [-lame / Ec, 0.0, 0.0, 1 / Ec],
            [Ec - lame**2 / Ec, 0.0, 0.0, lame / Ec],
            [0.0, 0.0, -1.0, 0.0],
        ]
    )
    step = -k[:, None, None] * layer.thickness * A
    P = term = np.broadcast_to(np.eye(4), (len(k), 4, 4))
    for n in range(1, TERMS + 1):
        term = term @ step / n
        P = P + term
    return P


def _cross_thin(layer: ElasticLayer, k: Array, below: Array) -> Array:
    """Return the compliance (n, 2, 2) of a thin layer's top by the series of its propagator."""
    P, signed = _propagator(layer, k), _signed(k)
    u = P[:, :2, :2] @ below + P[:, :2, 2:] @ signed
    t = P[:, 2:, :2] @ below + P[:, 2:, 2:] @ signed
    return u @ np.linalg.inv(-k[:, None, None] * t)


def _stiffness(layer: ElasticLayer, k: Array) -> tuple[Array, Array, Array]:
    """Return tractions on top and bottom of a layer by displacements of top and bottom: S_tt, S_tb, S_bb (n, 2, 2).

    Of its four solutions two decay downwards and two upwards: no exponential is above one.
    """
    kh = np.minimum(k * layer.thickness, DEEP)
    decay = np.exp(-kh)[:, None, None]
    (D0, T0), (Dh, Th) = _decaying(layer, np.zeros_like(kh)), _decaying(layer, kh)
    # seen from the bottom upwards u and sigma keep their signs, w and tau change them
    u, t = np.array([[1.0], [-1.0]]), np.array([[-1.0], [1.0]])
    D = np.block([[D0, u * Dh * decay], [Dh * decay, u * D0]])
    T = np.block([[-T0, -t * Th * decay], [Th * decay, t * T0]])
    S = k[:, None, None] * (T @ np.linalg.inv(D))
    return S[:, :2, :2], S[:, :2, 2:], S[:, 2:, 2:]
