"""Punching by EN 1992-1-1:2023 8.4 of columns, piles, zones and walls' ends: without links, and the links needed."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial
from typing import NamedTuple

from groundslab.design.codes.en1992_2023 import punching as en1992
from groundslab.design.codes.en1992_2023.checks.punching_demand import Punching
from groundslab.design.codes.en1992_2023.materials_of_case import materials
from groundslab.design.rules.calculation import Support
from groundslab.design.rules.check import DesignCheck, Status, severity
from groundslab.design.rules.demand_errors import error_of_ratio, scaled
from groundslab.design.rules.punching import PUNCHING, Aspect, Demands
from groundslab.design.rules.punching_beta import WAYS
from groundslab.design.rules.punching_links.demand import LinkDemand
from groundslab.messages import Message, Name
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results

#: A slab with links is at least so thick [m] (12.4.2(2)).
LEAST_WITH_LINKS = 0.2
#: A single perimeter of links counts over this share of the effective depth.
APART = 0.75
#: Why no links are laid out.
NO_LAYOUT = "not laid out: the rules of EN 1992-1-1:2023 12.5.1 for perimeters and legs are not known here"


class LaidLinks(NamedTuple):
    """The links that are given around a perimeter."""

    A_sw: float  # of each perimeter, the least one [m2]
    s_r: float  # from one perimeter to the next [m]
    rho_w: float  # links per area of the plan
    eta: tuple[float, float]  # eta_c, eta_s
    tau_cs: float  # tau_Rd,cs [Pa]
    tau_max: float  # tau_Rd,max [Pa]


class LinksNeeded(NamedTuple):
    """What a slab needs where concrete alone does not resist."""

    tau_Ed: float  # [Pa]
    tau_max: float  # the most that links can carry [Pa]
    phi_w: float  # the diameter that is assumed [m]
    eta: tuple[float, float]  # eta_c, eta_s
    rho_w: float  # links per area of the plan
    b_out: float  # outer perimeter where they are needed no more [m]


def links_needed(demand: Punching, steel: Reinforcement, out: float) -> LinksNeeded:
    """Return the links of a demand whose outermost ones have the depth d_v,out [m].

    Their diameter is taken as the largest allowed, which counts least (8.106).
    """
    concrete, bars = materials(steel, demand.limit_state)
    tau_Ed, d = demand.tau_links, demand.d
    tau_max = en1992.system_factor(concrete, demand.b_0, d) * demand.tau_Rd_c
    eta_c = en1992.concrete_share(demand.tau_Rd_c, tau_Ed)
    phi_w = en1992.thickest_link(d)
    eta = eta_c, en1992.links_share(concrete.d_dg, d, phi_w, eta_c, demand.k_pb)
    rho_w = en1992.required_links(tau_Ed, demand.tau_Rd_c, eta, bars.f_yd)
    b_out = en1992.outer_perimeter(demand.b_05, d, out, eta_c)
    return LinksNeeded(tau_Ed, tau_max, phi_w, eta, rho_w, b_out)


def outermost_depth(demand: Punching, steel: Reinforcement) -> float:
    """Return d_v,out [m]: d_v less the cover of links at the compressed face, at most that of the bars' axes there."""
    return demand.section.out if demand.section is not None else demand.d - sum(steel.top_axes) / 2


def aspects(support: Support, demands: Demands[Punching], steel: Reinforcement) -> Iterator[Aspect]:
    """Yield what is judged: the critical section at d_v / 2."""
    worst = partial(_worst, steel=steel, name=PUNCHING[support])
    yield Aspect(PUNCHING[support], demands.found.values(), partial(as_laid, steel=steel), worst)


def laid_links(demand: Punching, steel: Reinforcement) -> LaidLinks | None:
    """Return what the links that are given do at the perimeter; None where none are.

    Their area over that of the plan is that of the perimeter with the fewest legs, over its distance from the next one
    and the control perimeter's length.
    """
    laid = steel.links_at(demand.name)
    if laid is None:
        return None
    concrete, bars = materials(steel, demand.limit_state)
    s_r = laid.apart or APART * demand.d
    rho_w = min(laid.areas) / (s_r * demand.b_05)
    eta_c = en1992.concrete_share(demand.tau_Rd_c, max(demand.tau_links, demand.tau_Rd_c))
    eta = eta_c, en1992.links_share(concrete.d_dg, demand.d, laid.diameter, eta_c, demand.k_pb)
    tau_max = en1992.system_factor(concrete, demand.b_0, demand.d) * demand.tau_Rd_c
    tau_cs = en1992.resistance_with_links(demand.tau_Rd_c, eta, rho_w, bars.f_yd)
    return LaidLinks(min(laid.areas), s_r, rho_w, eta, tau_cs, tau_max)


def as_laid(demand: Punching, steel: Reinforcement) -> float:
    """Return tau_Ed over what resists it, with the links that are given; over what needs none without them."""
    links = laid_links(demand, steel)
    if links is None or demand.used <= 1:
        return demand.used
    return demand.tau_links / min(links.tau_cs, links.tau_max)


def used(demand: Punching, _: Reinforcement | None = None) -> float:
    """Return tau_Ed over what needs no links."""
    return demand.used


def links(_: Results, __: Reinforcement, support: Support, demands: Demands[Punching]) -> Iterator[LinkDemand]:
    """Yield those that need links, each by the combination that needs most, and why these are not laid out."""
    worst: dict[str, Punching] = {}
    for demand in demands.found.values():
        least = worst[demand.name].used if demand.name in worst else 1.0
        if not demand.supported and demand.used > least:
            worst[demand.name] = demand
    for demand in worst.values():
        about = support, demand.name, demand.place, demand.combination, "EN 1992-1-1:2023 8.4.4"
        yield LinkDemand(*about, NO_LAYOUT, unknown=True)


def _worst(judged: list[Punching], steel: Reinforcement, name: str) -> DesignCheck:
    """Return the check of the one that links cannot help most, else of the one that ends worst and uses most."""
    share = partial(as_laid, steel=steel)
    failing = [demand for demand in judged if share(demand) > 1 and _beyond_links(demand, steel) > 1]
    demand = max(failing or judged, key=lambda punching: (severity(_status(punching, steel)), share(punching)))
    if share(demand) != demand.used:
        return _with_laid(demand, steel, name)
    beside = [punching for punching in judged if punching.combination == demand.combination]
    error = error_of_ratio((punching.tau_Ed, punching.resistance, punching.error) for punching in beside)
    which = (
        "the bars provided"
        if steel.laid
        else Message("bars of {most_bars:g} %, the most that count", most_bars=100 * en1992.MOST_BARS)
    )
    least = (
        " = tau_Rdc,min (8.4.1(2))"
        if demand.tau_min > demand.tau_Rd_c
        else Message(" = tau_Rd,c with {which} (8.4.3)", which=which)
    )
    words = Message(
        '{name} in "{combination}": tau_Ed {tau_Ed:.3g MPa} on b_0.5 {b_05:.2f m}, {moments}, is {used:.3g} '
        "times {resistance:.3g MPa}{least}",
        name=Name(demand.name),
        combination=Name(demand.combination),
        tau_Ed=demand.tau_Ed / 1e6,
        b_05=demand.b_05,
        moments=_with(demand),
        used=demand.used,
        resistance=demand.resistance / 1e6,
        least=least,
    )
    if demand.concentrated:
        words += "; tau_Ed is not less than by the shear forces of the analysis, as a large force is near (8.4.2(8))"
    status = _status(demand, steel)
    if status == "fails":
        words += _with_links(demand, steel)
    elif status == "attention":
        ratio = en1992.MOST_BARS * max(demand.tau_Ed / demand.tau_Rd_c, 0.0) ** 3
        words = Message(
            "needs bars in tension of {ratio:.2g} % of the section, and none are provided: {text}",
            ratio=100 * ratio,
            text=words,
        )
    return DesignCheck(
        name, status, words, of=demand.name, demand=max(demand.tau_Ed, 0.0) / 1e6, resistance=demand.resistance / 1e6,
        unit="MPa", clause="EN 1992-1-1:2023 8.4.1, 8.4.3, 8.4.4", combination=demand.combination, place=demand.place,
        error=scaled(error, demand.resistance / 1e6),
    )  # fmt: skip


def _status(demand: Punching, steel: Reinforcement) -> Status:
    """Return how a demand ends: distances of links are not known here, and bars in tension may not be laid."""
    if as_laid(demand, steel) > 1:
        return "fails"
    asks_for_bars = not steel.laid and demand.tau_Ed > demand.tau_min
    return "attention" if demand.used > 1 or asks_for_bars else "no failure found"


def _with_laid(demand: Punching, steel: Reinforcement, name: str) -> DesignCheck:
    """Return the check of a demand that needs links and has some; how they are laid is not known here."""
    links = laid_links(demand, steel)
    assert links is not None
    resistance = min(links.tau_cs, links.tau_max)
    holds = demand.tau_links <= resistance
    words = Message(
        '{name} in "{combination}": tau_Ed {tau_Ed:.3g MPa} {sign} {resistance:.3g MPa} = {which} with the links '
        "given; their distances (12.5.1) are not checked",
        name=Name(demand.name),
        combination=Name(demand.combination),
        tau_Ed=demand.tau_links / 1e6,
        sign="<=" if holds else ">",
        resistance=resistance / 1e6,
        which="tau_Rd,cs" if links.tau_cs < links.tau_max else "tau_Rd,max",
    )
    return DesignCheck(
        name, "attention" if holds else "fails", words, of=demand.name, demand=demand.tau_links / 1e6,
        resistance=resistance / 1e6, unit="MPa", clause="EN 1992-1-1:2023 8.4.4", combination=demand.combination,
        place=demand.place, error=scaled(demand.error(), 1e-6),
    )  # fmt: skip


def _with(demand: Punching) -> str:
    """Return in words how moments count."""
    if demand.beta_e is None:
        return "by moments"
    words = Message("with beta_e {beta_e:.2f}", beta_e=demand.beta_e)
    return words if demand.way == "code" else words + Message(" {way}", way=WAYS[demand.way])


def _beyond_links(demand: Punching, steel: Reinforcement) -> float:
    """Return the stress over the most that links can carry; inf where the slab is too thin for them."""
    if demand.section is not None and demand.section.thickness < LEAST_WITH_LINKS:
        return math.inf
    links = links_needed(demand, steel, outermost_depth(demand, steel))
    return links.tau_Ed / links.tau_max


def _with_links(demand: Punching, steel: Reinforcement) -> str:
    """Return the links that a demand needs, in words."""
    beyond = _beyond_links(demand, steel)
    if math.isinf(beyond):
        return "; the slab is too thin for links (12.4.2(2))"
    links = links_needed(demand, steel, outermost_depth(demand, steel))
    most = Message(
        "{tau_Ed:.3g MPa} with links is {beyond:.3g} times tau_Rd,max {tau_max:.3g MPa}",
        tau_Ed=links.tau_Ed / 1e6,
        beyond=beyond,
        tau_max=links.tau_max / 1e6,
    )
    if beyond > 1:
        return Message("; links do not suffice: {most} (8.4.4(5))", most=most)
    return Message(
        "; links of {rho_w:.3g cm2/m2} around it are needed, of {phi_w:.3g mm} or thinner (8.104), "
        "{most}, out to b_0.5,out {b_out:.2f m} (8.112); their spacing (12.5.1) is not checked",
        rho_w=links.rho_w * 1e4,
        phi_w=1e3 * links.phi_w,
        most=most,
        b_out=links.b_out,
    )
