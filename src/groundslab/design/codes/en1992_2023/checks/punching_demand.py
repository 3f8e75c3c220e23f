"""What punches at columns, piles and zones in ultimate combinations by EN 1992-1-1:2023 8.4, at d_v / 2 from them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import partial

import numpy as np

from groundslab.arrays import Array, made_once, made_once_by
from groundslab.design.codes.en1992_2023 import punching as en1992
from groundslab.design.codes.en1992_2023.checks.critical_sections import AVERAGED, CriticalSection, critical_section
from groundslab.design.codes.en1992_2023.materials import Concrete
from groundslab.design.codes.en1992_2023.materials_of_case import materials
from groundslab.design.codes.en1992_2023.shear import minimum_resistance
from groundslab.design.demands import perimeter_loads
from groundslab.design.demands.by_plate import plate_under
from groundslab.design.demands.line_properties import total_length
from groundslab.design.demands.perimeter_loads import (
    CaseInside,
    MomentParts,
    PerimeterLoads,
    Places,
    PunchingForce,
    PunchingShear,
)
from groundslab.design.demands.perimeter_shear import PerimeterShear, contraflexure
from groundslab.design.demands.perimeters import SketchedPerimeter
from groundslab.design.demands.zones.thicker_zones import zone_forces
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.demand_errors import error_of, scaled
from groundslab.design.rules.punching import Demands
from groundslab.design.rules.punching_beta import (
    beta_by_sectors,
    beta_of,
    betas_by_sectors,
    sector_pieces,
)
from groundslab.design.rules.wall_ends import WallSite
from groundslab.model.design.laid_bars import PunchingBars
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.model import Model
from groundslab.results.plate_result import PlateResult
from groundslab.results.results import CombinationResult, Results

#: Another column nearer to the perimeter than so many d_v whose force is so large a share of V_Ed asks for the forces
#: of the analysis themselves (8.4.2(8)).
NEAR, LARGE = 3.0, 0.2


@dataclass(frozen=True, slots=True)
class Punching:
    """The demand on the critical section of a column, pile or end of a wall that pushes in one combination."""

    name: str
    combination: str
    limit_state: str
    force: float  # that pushes [N]
    d: float  # d_v [m]
    b_05: float  # [m]
    b_0: float  # [m]
    k_pb: float
    ratio: float  # of bars in tension that counts
    a_pd: float  # d_v, or less where contraflexure is near [m]
    a_p: float  # mean distance of contraflexure; inf if it is far [m]
    V_Ed: float  # force that punches, less what relieves it without links [N]
    V_links: float  # the same with links, of which the pressure up to the perimeter relieves [N]
    beta_e: float | None  # None where nothing pushes
    tau_Ed: float  # that counts without links [Pa]
    of_analysis: float | None  # by shear forces along the perimeter [Pa]
    tau_Rd_c: float  # [Pa]
    tau_min: float  # [Pa]
    pressure: float  # contact pressure up to 0.67 d_v [N]
    edge: float  # line force along the plate's edge there [N]
    others: float  # other loads there [N]
    supported: bool  # whether another support acts inside: in V_Ed is what it adds, not what it takes off
    place: tuple[float, float]  # [m]
    error: Callable[[], float | None] = field(repr=False, compare=False)  # of the share used, as one of tau_Ed [Pa]
    section: CriticalSection | None = None  # of a column or pile
    eccentricities: tuple[float, float] = (0.0, 0.0)  # along the section's axes [m]; moments where nothing pushes [N m]
    turned: float = 0.0  # what these moments add to V_Ed [N]
    concentrated: bool = False  # whether a large force acts close by
    pulls: bool = False  # whether a column pulls up, or a pile down
    way: str = "code"  # how beta_e is found
    bars: PunchingBars | None = None  # that are laid
    parts: MomentParts | None = field(default=None, repr=False, compare=False)  # of moments along the section's axes
    inside_links: tuple[float, float] = (0.0, 0.0)  # other loads and pressure up to the perimeter [N]
    gradient_length: float = 0.0  # of the perimeter at d_v / 2 that k_pb is of, not less in thinner slab [m]
    inside: float = 0.0  # area up to 0.67 d_v from the face [m2]
    cases: tuple[CaseInside, ...] = field(default=(), repr=False, compare=False)  # what load cases have there
    cases_links: tuple[CaseInside, ...] = field(default=(), repr=False, compare=False)  # and up to the perimeter
    wall: WallSite | None = field(default=None, repr=False, compare=False)  # of an end or a corner of walls
    other_betas: Callable[[], Mapping[str, float]] = field(default=dict, repr=False, compare=False)  # by other ways

    @property
    def sketch(self) -> SketchedPerimeter | None:
        """Return the critical section."""
        if self.wall is not None:
            return self.wall.sketch(en1992.DISTANCE * self.d)
        return None if self.section is None else self.section.sketch

    @property
    def resistance(self) -> float:
        """Return the stress that needs no links [Pa]: tau_Rd,c, or tau_Rdc,min (8.4.1(2))."""
        return max(self.tau_Rd_c, self.tau_min)

    @property
    def used(self) -> float:
        """Return tau_Ed over what needs no links."""
        return self.tau_Ed / self.resistance

    @property
    def tau_links(self) -> float:
        """Return tau_Ed of a slab with links [Pa]."""
        raised = self.V_links + self.turned if self.beta_e is None else self.beta_e * self.V_links
        by_force = raised / (self.b_05 * self.d)
        return max(by_force, self.of_analysis or 0.0) if self.concentrated else by_force


@made_once_by(lambda results, model: (results.plate.nodes, model))
def _sections(results: CombinationResult, model: Model) -> Places[CriticalSection | str]:  # noqa: ARG001
    """Return those of the columns and piles of a model, or why there is none, as they are added."""
    return {}


@made_once
def column_demands(combined: Results) -> Demands[Punching]:
    """Return the demands at columns."""
    return _of_kind(combined, perimeter_loads.punching_columns(combined.solved_model))


@made_once
def pile_demands(combined: Results) -> Demands[Punching]:
    """Return the demands over piles."""
    return _of_kind(combined, perimeter_loads.punching_piles(combined.model))


@made_once
def zone_demands(combined: Results) -> Demands[Punching]:
    """Return the demands around thicker zones with columns on them."""
    return _demands(combined, zone_forces(combined), perimeter_loads.punching_columns(combined.solved_model))


def _of_kind(combined: Results, forces: tuple[PunchingForce, ...]) -> Demands[Punching]:
    """Return the demands of columns, or of piles."""
    return _demands(combined, forces, forces)


def _demands(
    combined: Results, forces: tuple[PunchingForce, ...], others: tuple[PunchingForce, ...]
) -> Demands[Punching]:
    """Return the demands of forces that punch the plate; others may act close to them."""
    model, steel = combined.model, combined.model.reinforcement
    demands: dict[tuple[str, str], Punching] = {}
    missing: dict[str, str] = {}
    if steel is None:
        return Demands()
    results = ultimate_results(combined)
    make = partial(critical_section, steel=steel)
    for punching, section, pushing in perimeter_loads.pushing_forces(results, forces, model, (_sections, make)):
        if isinstance(section, str):
            missing[punching.name] = section
            continue
        for result in pushing:
            demand = _demand(result, section, (punching, others), steel)
            perimeter_loads.add_worse(
                demands, (result.combination, punching.name), demand, lambda punched: punched.used
            )
    return Demands(demands, missing)


def _demand(
    results: CombinationResult,
    section: CriticalSection,
    forces: tuple[PunchingForce, tuple[PunchingForce, ...]],
    steel: Reinforcement,
) -> Punching:
    """Return the demand on a critical section in a combination; forces are its own, and those that may act close by."""
    punching, others = forces
    concrete, bars = materials(steel, results.limit_state)
    shear = _shear(results, section.relieved, section, punching, steel)
    (beta_e, e_or_M, turned), way = _beta(results, section, punching, shear, steel)
    concentrated = _concentrated(results, section, punching, others, shear.V)
    a_p = _contraflexure(results, section, punching)
    linked = _shear(results, section.inside, section, punching, steel)
    tau_min = float(minimum_resistance(concrete, bars, section.d))
    stress = partial(_stress, section=section, punching=punching, steel=steel, concentrated=concentrated)
    resistance = partial(_without_links, section=section, punching=punching, concrete=concrete)
    tau_Rd_c = resistance(results)
    least = max(tau_Rd_c, tau_min)
    used = partial(_used, stress=stress, resistance=resistance, tau_min=tau_min)
    return Punching(
        name=punching.name,
        combination=results.combination,
        limit_state=results.limit_state,
        force=float(punching.pushing(results)[0]),
        d=section.d,
        b_05=section.b_05,
        b_0=section.b_0,
        k_pb=section.k_pb,
        ratio=section.ratio,
        bars=section.bars,
        parts=shear.parts.along(section.axes),
        inside=section.relieved.size,
        cases=shear.cases,
        cases_links=linked.cases,
        gradient_length=total_length(section.legs),
        a_pd=en1992.depth_by_contraflexure(a_p, section.d),
        a_p=a_p,
        V_Ed=shear.V,
        V_links=linked.V,
        inside_links=(linked.others, linked.pressure),
        beta_e=beta_e,
        tau_Ed=stress(results),
        of_analysis=_of_analysis(results, section, punching),
        tau_Rd_c=tau_Rd_c,
        tau_min=tau_min,
        pressure=shear.pressure,
        edge=shear.edge,
        others=shear.others,
        supported=shear.supported,
        place=punching.place,
        error=lambda: scaled(error_of(results, used), least),
        section=section,
        eccentricities=e_or_M,
        turned=turned,
        concentrated=concentrated,
        pulls=punching.pulls,
        way=way,
        other_betas=lambda: _other_betas(results, section, punching, steel),
    )


def _without_links(
    mesh: CombinationResult, section: CriticalSection, punching: PunchingForce, concrete: Concrete
) -> float:
    """Return tau_Rd,c [Pa] of a mesh."""
    a_pd = en1992.depth_by_contraflexure(_contraflexure(mesh, section, punching), section.d)
    return en1992.resistance_without_links(concrete, section.k_pb, section.ratio, a_pd)


def _used(
    mesh: CombinationResult,
    stress: Callable[[CombinationResult], float],
    resistance: Callable[[CombinationResult], float],
    tau_min: float,
) -> float:
    """Return which part of the resistance without links the stress is; contraflexure has an error, too."""
    return stress(mesh) / max(resistance(mesh), tau_min)


def _shear(
    results: CombinationResult,
    inside: PerimeterLoads,
    section: CriticalSection,
    punching: PunchingForce,
    steel: Reinforcement,
) -> PunchingShear:
    """Return what punches in a combination, with what acts inside."""
    return perimeter_loads.punching_shear(
        results, inside, punching, section.center, edge_relieves=steel.line_force_relieves
    )


def _beta(
    results: CombinationResult,
    section: CriticalSection,
    punching: PunchingForce,
    shear: PunchingShear,
    steel: Reinforcement,
) -> tuple[tuple[float | None, tuple[float, float], float], str]:
    """Return beta_e as the case asks for it, the rest as by moments, and how it was found."""
    by_moments = _beta_by_moments(results, section, punching, shear)
    way = beta_of(results.solved_model, steel, punching)
    if by_moments[0] is None or way == "code":
        return by_moments, "code"
    if way == "sectors":
        beta = beta_by_sectors(*_sectors(results, section, punching), sign=-1.0 if punching.from_below else 1.0)
        return (by_moments, "code") if beta is None else ((beta, *by_moments[1:]), way)
    assert isinstance(way, float)  # constants are refused
    return (way, *by_moments[1:]), "given"


def _sectors(
    results: CombinationResult, section: CriticalSection, punching: PunchingForce
) -> tuple[tuple[PerimeterShear, ...], PlateResult, Array, Array]:
    """Return what shear forces in sectors of a section are read from: its pieces, the plate, its center and axis."""
    plate = plate_under(results, *punching.place)
    pieces = sector_pieces(plate, section.legs, section.line_center, section.d)
    return pieces, plate, section.place, section.course.frame[0]


def _other_betas(
    results: CombinationResult, section: CriticalSection, punching: PunchingForce, steel: Reinforcement
) -> dict[str, float]:
    """Return beta_e by moments, and by numbers of sectors."""
    shear = _shear(results, section.relieved, section, punching, steel)
    by_moments = _beta_by_moments(results, section, punching, shear)[0]
    by_sectors = betas_by_sectors(*_sectors(results, section, punching), sign=-1.0 if punching.from_below else 1.0)
    return by_sectors if by_moments is None else {"code": by_moments, **by_sectors}


def _beta_by_moments(
    results: CombinationResult, section: CriticalSection, punching: PunchingForce, shear: PunchingShear
) -> tuple[float | None, tuple[float, float], float]:
    """Return beta_e, and how far the support's force, by its own moments, acts from the perimeter's center [m].

    That is along the section's axes. Of a zone, on which walls and other loads stand besides its columns, it is the
    force of all inside. Where no force acts, or none is left inside, beta_e has no value: then the moments of all
    inside along the axes [N m], and what they add to V_Ed [N], which (beta_e - 1) V_Ed would be.
    """
    pushing, shape = punching.pushing(results), section.course.shape
    if shear.V <= 0 or perimeter_loads.only_turns(pushing):
        first, second = map(float, section.axes @ shear.moments)
        return None, (first, second), en1992.turned(en1992.eccentricity(shape, first, second), *section.widths)
    if punching.at_zone:
        away = shear.moments / shear.V
    else:
        away = np.array(punching.place) + pushing[1:] / pushing[0] - section.center
    first, second = map(float, section.axes @ away)
    return en1992.beta(en1992.eccentricity(shape, first, second), *section.widths), (first, second), 0.0


def _stress(
    results: CombinationResult,
    section: CriticalSection,
    punching: PunchingForce,
    steel: Reinforcement,
    *,
    concentrated: bool,
) -> float:
    """Return tau_Ed [Pa]: beta_e V_Ed / (b_0.5 d_v), and that of the analysis if a large force acts close by."""
    shear = _shear(results, section.relieved, section, punching, steel)
    (beta_e, _, turned), _ = _beta(results, section, punching, shear, steel)
    by_force = (shear.V + turned if beta_e is None else beta_e * shear.V) / (section.b_05 * section.d)
    return max(by_force, _of_analysis(results, section, punching) or 0.0) if concentrated else by_force


def _of_analysis(results: CombinationResult, section: CriticalSection, punching: PunchingForce) -> float | None:
    """Return tau_Ed by shear forces along the perimeter, averaged over 2 d_v [Pa] (formula 8.93); None off the mesh."""
    plate = plate_under(results, *punching.place)
    shear = section.shear_on(plate)
    sign = -1.0 if punching.from_below else 1.0
    return None if shear is None else shear.largest_mean(plate, AVERAGED * section.d, sign) / section.d


def _contraflexure(results: CombinationResult, section: CriticalSection, punching: PunchingForce) -> float:
    """Return a_p [m], the mean distance of contraflexure from the support along both axes of bars (formula 8.98).

    inf at edges and corners: from where it is measured there, Figure 8.21 a), was not read; and of thicker zones.
    """
    if section.course.shape != "closed" or punching.at_zone:
        return float("inf")
    sign = -1.0 if punching.from_below else 1.0
    plate = plate_under(results, *punching.place)
    along_x, along_y = contraflexure(section.lines_on(plate), plate, sign)
    return max(float(np.sqrt(along_x * along_y)), section.d)


def _concentrated(
    results: CombinationResult,
    section: CriticalSection,
    punching: PunchingForce,
    others: tuple[PunchingForce, ...],
    V: float,
) -> bool:
    """Return whether another column or pile with a large force stands close to the perimeter."""
    inside = section.line.inside
    return V > 0 and any(
        abs(float(other.pushing(results)[0])) >= LARGE * V
        and other.footprint.footprint().distance(inside) < NEAR * section.d
        for other in others
        if other.key != punching.key and not set(other.columns) & set(punching.columns)
    )
