"""What stirrups and headed studs that are given carry by ACI 318-19 22.6.6 to 22.6.8: phi v_n of a critical section."""

from __future__ import annotations

from typing import NamedTuple

from groundslab.design.codes.aci318 import punching as aci318
from groundslab.design.codes.aci318.checks.two_way_demand import TwoWay, strength
from groundslab.design.codes.aci318.materials import PHI_SHEAR
from groundslab.design.codes.aci318.materials_of_case import materials
from groundslab.model.design.punching_links import PunchingLinks
from groundslab.model.design.reinforcement import Reinforcement


class LaidLinks(NamedTuple):
    """The links or studs around a critical section."""

    given: PunchingLinks
    A_v: float  # of each perimeter, the least one [m2]
    s: float  # from one perimeter to the next [m]
    v_c: float  # of the concrete beside them [Pa]
    v_s: float  # [Pa]
    most: float  # [Pa]

    @property
    def v_n(self) -> float:
        """Return the nominal strength [Pa]."""
        return min(self.v_c + self.v_s, self.most)


def laid_links(demand: TwoWay, steel: Reinforcement) -> LaidLinks | None:
    """Return what the links that are given do on a critical section; None where none are."""
    laid = steel.links_at(demand.name)
    if laid is None:
        return None
    (concrete, bars), d = materials(steel), demand.d
    A_v, s = min(laid.areas), laid.apart or aci318.STIRRUP_SPACING * d
    if laid.kind == "studs":
        v_c = aci318.with_studs(concrete, d, demand.b_o, demand.beta, demand.alpha_s)
        most = aci318.most_with_studs(concrete)
    else:
        v_c, most = aci318.with_links(concrete, d), aci318.most_with_links(concrete)
    return LaidLinks(laid, A_v, s, v_c, aci318.of_links(A_v, s, demand.b_o, bars), most)


def strength_as_laid(demand: TwoWay, steel: Reinforcement) -> float:
    """Return phi v_n [Pa] of a critical section with the links that are given, phi v_c where these add nothing."""
    without, links = strength(demand, steel), laid_links(demand, steel)
    return without if links is None else max(without, PHI_SHEAR * links.v_n)


def used_as_laid(demand: TwoWay, steel: Reinforcement) -> float:
    """Return v_u over phi v_n."""
    return demand.v_u / strength_as_laid(demand, steel)
