"""Development and lap splices of deformed bars in tension by ACI 318-19 25.4.2 and 25.5.2, in SI units.

    l_d  = f_y psi_t psi_e psi_g / (2.07 lambda (f'c)^(1/2)) d_b    No. 19 and smaller    Table 25.4.2.3
         = f_y psi_t psi_e psi_g / (1.66 lambda (f'c)^(1/2)) d_b    No. 22 and larger
    l_st = 1.3 l_d                                                  class B               Table 25.5.2.1

neither less than 12 in. (25.4.2.1, 25.5.2.1). Those are the lengths of bars at least 2 d_b clear of each other with a
cover of d_b or more; all others have 1.5 times as much. psi_t = 1.3 of bars with more than 300 mm of fresh concrete
below, psi_e = 1 (uncoated), psi_g = 1, 1.15 and 1.3 up to 420, 550 and 690 MPa (Table 25.4.2.5), lambda = 1;
(f'c)^(1/2) counts up to 8.3 MPa (25.4.1.4).
"""

from __future__ import annotations

from groundslab.design.codes.aci318.materials import Concrete, Steel

_MPA = 1e6
#: Divisors of f_y / (f'c)^(1/2) [MPa^(1/2)] of thin and thick bars, and the diameter [m] up to which they are thin.
THIN, THICK, THIN_BAR = 2.07, 1.66, 0.0191
#: Factor of bars that are closer or have less cover.
CLOSE = 1.5
#: psi_t, and the fresh concrete below [m] beyond which it counts.
TOP, TOP_DEPTH = 1.3, 0.300
#: psi_g by the largest f_y [Pa].
GRADES = ((420 * _MPA, 1.0), (550 * _MPA, 1.15), (690 * _MPA, 1.3))
#: A class B splice over l_d; the least lengths [m].
CLASS_B, LEAST = 1.3, 0.3048
#: What counts as rounding of a length [m].
ROUNDING = 1e-9


def development_length(
    concrete: Concrete, steel: Steel, diameter: float, *, cover: float, clear: float, below: float
) -> float:
    """Return l_d [m] of a straight bar with cover, clear distance and fresh concrete below, all in meters."""
    return max(_length(concrete, steel, diameter, cover, clear, below), LEAST)


def splice_length(
    concrete: Concrete, steel: Steel, diameter: float, *, cover: float, clear: float, below: float
) -> float:
    """Return the length [m] of a class B lap splice; all in meters."""
    return max(CLASS_B * _length(concrete, steel, diameter, cover, clear, below), LEAST)


def _length(concrete: Concrete, steel: Steel, diameter: float, cover: float, clear: float, below: float) -> float:
    """Return l_d [m] without its least value."""
    divisor, psi_g, psi_t, close = factors(steel, diameter, cover, clear, below)
    return steel.f_y * psi_t * psi_g * close / (divisor * concrete.root) * diameter


def factors(
    steel: Steel, diameter: float, cover: float, clear: float, below: float
) -> tuple[float, float, float, float]:
    """Return the divisor of the diameter, psi_g, psi_t, and the factor of bars that are close; lengths in meters."""
    divisor = THIN if diameter <= THIN_BAR + ROUNDING else THICK
    psi_g = next((factor for most, factor in GRADES if steel.f_y <= most), GRADES[-1][1])
    psi_t = TOP if below > TOP_DEPTH + ROUNDING else 1.0
    roomy = clear >= 2 * diameter - ROUNDING and cover >= diameter - ROUNDING
    return divisor, psi_g, psi_t, 1.0 if roomy else CLOSE
