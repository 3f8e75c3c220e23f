"""Moments and shear forces that a slab is designed for: principal ones, and Wood's for bars along x and y."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.results.fields import DIRECTION, LAYERS, PLATE_FIELDS, PRINCIPAL
from groundslab.results.plate_result import PlateResult


@dataclass(frozen=True, slots=True)
class Principal:
    """Principal moments (n,) [N m/m], m_1 >= m_2, and the direction [rad] of the strips that m_1 bends, from x."""

    m_1: Array
    m_2: Array
    direction: Array


@dataclass(frozen=True, slots=True)
class DesignMoments:
    """Moments (n,) [N m/m] for reinforcement along x and y: at the bottom >= 0, at the top <= 0."""

    bottom_x: Array
    bottom_y: Array
    top_x: Array
    top_y: Array


def principal_moments(m_x: Array, m_y: Array, m_xy: Array) -> Principal:
    """Return the principal moments of bending and twisting moments (n,), by Mohr's circle."""
    middle, radius = (m_x + m_y) / 2, np.hypot((m_x - m_y) / 2, m_xy)
    return Principal(middle + radius, middle - radius, np.arctan2(2 * m_xy, m_x - m_y) / 2)


def wood_armer(m_x: Array, m_y: Array, m_xy: Array) -> DesignMoments:
    """Return the design moments of bending and twisting moments (n,), sagging positive (Wood 1968, Armer 1968).

    The least m_x* + m_y* with m_x* cos^2 + m_y* sin^2 at least the bending moment in every direction, and neither of
    them negative at the bottom; at the top the same with all signs turned.
    """
    m_x, m_y, m_xy = (np.asarray(moment, dtype=float) for moment in (m_x, m_y, m_xy))
    bottom_x, bottom_y = _bottom(m_x, m_y, m_xy)
    top_x, top_y = _bottom(-m_x, -m_y, m_xy)
    return DesignMoments(bottom_x, bottom_y, -top_x, -top_y)


def _bottom(m_x: Array, m_y: Array, m_xy: Array) -> tuple[Array, Array]:
    """Return m_x* and m_y* >= 0 (n,) for the bottom."""
    twist = np.abs(m_xy)
    x, y = m_x + twist, m_y + twist
    # where one of them would be negative it is none, and the other grows by the twist that is left to it alone
    only_y, only_x = x < 0, y < 0
    alone_y = m_y + np.divide(m_xy**2, np.abs(m_x), out=np.zeros_like(x), where=only_y)
    alone_x = m_x + np.divide(m_xy**2, np.abs(m_y), out=np.zeros_like(y), where=only_x)
    star_x = np.where(only_y, 0.0, np.where(only_x, np.maximum(alone_x, 0.0), x))
    star_y = np.where(only_x, 0.0, np.where(only_y, np.maximum(alone_y, 0.0), y))
    return star_x, star_y


def fields_of(plate: PlateResult) -> dict[str, Array]:
    """Return the nodal fields of a plate by name, (n,) each, in SI units."""
    return {name: getattr(plate, name) for name in PLATE_FIELDS}


def design_moments(plate: PlateResult) -> DesignMoments:
    """Return Wood's design moments at the plate's nodes."""
    return wood_armer(plate.moment_x, plate.moment_y, plate.moment_xy)


def derive_fields(fields: Mapping[str, Array]) -> dict[str, Array]:
    """Return all quantities of POINT_FIELDS and RANGED_FIELDS (n,) from the plate's fields (n,), all in SI units."""
    moments = fields["moment_x"], fields["moment_y"], fields["moment_xy"]
    principal, design = principal_moments(*moments), wood_armer(*moments)
    derived = {name: getattr(principal, name) for name in PRINCIPAL | DIRECTION}
    return {**fields, **derived, **{name: getattr(design, name) for name in LAYERS}}


def derive_field(fields: Mapping[str, Array], name: str) -> Array:
    """Return a quantity of POINT_FIELDS or RANGED_FIELDS (n,) from the plate's fields (n,), all in SI units."""
    if name in PLATE_FIELDS:
        return fields[name]
    moments = fields["moment_x"], fields["moment_y"], fields["moment_xy"]
    values: Array = getattr(wood_armer(*moments) if name in LAYERS else principal_moments(*moments), name)
    return values


def principal_shear(q_x: Array, q_y: Array) -> tuple[Array, Array]:
    """Return the largest shear force of any direction (n,) [N/m], and the share cos^2 of its direction along x (n,).

    q_n = q_x cos + q_y sin is largest for the direction of the vector (q_x, q_y) itself.
    """
    size = np.hypot(q_x, q_y)
    return size, np.divide(q_x, size, out=np.full_like(size, np.sqrt(0.5)), where=size > 0) ** 2


def ratio_along(share: Array, rho_x: Array, rho_y: Array) -> Array:
    """Return the ratio of bars (n,) that counts in a direction with cos^2 = share between bars along x and y.

    rho_l = rho_x cos^4 + rho_y sin^4 (EN 1992-2 Annex LL (LL.123)), the stiffness of a net of bars in a direction.
    """
    return np.asarray(rho_x * share**2 + rho_y * (1 - share) ** 2)
