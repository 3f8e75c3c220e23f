"""The model: plate, ground, loads and settings of the analysis, as in the input file.

Attributes are named as the keys of the file and hold SI units. Every section can be built in Python too, with
floats in SI units or text with units; InputError lists all issues at once. Positions in their paths count from 1.
"""

from __future__ import annotations

from collections.abc import Mapping, Set
from typing import Annotated, Any, ClassVar, Self

from groundslab.geometry.plan import Place, Ring, Segment
from groundslab.languages import Language
from groundslab.model import consistency, varying_ground
from groundslab.model.axes.crossings import attach_to_axes
from groundslab.model.axes.families import AxesFamily
from groundslab.model.cracking import Cracking
from groundslab.model.design.checks import Checks
from groundslab.model.design.floors import Floor
from groundslab.model.design.limits import Limits, SoilStrength
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.ground import Ground, carry_shear
from groundslab.model.loads.acting import Acting
from groundslab.model.loads.core_loads import CoreLoad
from groundslab.model.loads.lines import LineLoad, LineMoment
from groundslab.model.loads.load_cases import Combination, Combine, LoadCase
from groundslab.model.loads.load_types import AnyLoad, Load, PointLoad, SelfWeight
from groundslab.model.loads.patterns import Move, Pattern
from groundslab.model.loads.placement import weights_of, weights_of_pits
from groundslab.model.long_term import LongTerm, scale_stiffnesses
from groundslab.model.outputs import Output, Project, Report
from groundslab.model.plate import Plate
from groundslab.model.plates.joints import Joint
from groundslab.model.plates.other_plates import AnyPlate, FurtherPlate, bounds_of, list_plates
from groundslab.model.reactions import Reactions
from groundslab.model.settings import Analysis, Beyond, Contact, Mesh
from groundslab.model.structure.beams import Beam
from groundslab.model.structure.building import Building, bases, frame_lines
from groundslab.model.structure.columns import Column
from groundslab.model.structure.cores import Core, section_of
from groundslab.model.structure.members import as_beam, members_of, wall_of_members
from groundslab.model.structure.spans import Ways, spans_as_segments, spans_of
from groundslab.model.structure.walls import Wall, place_walls
from groundslab.model.supports import Support
from groundslab.schema import reference
from groundslab.schema.base import Check, Section
from groundslab.schema.fields import Text
from groundslab.schema.section_fields import Table
from groundslab.unit_systems import System


def _annex_of_actions(combine: Combine | None, reinforcement: Reinforcement | None) -> str:
    """Return the national annex of actions: that of automatic combinations, else that of the design."""
    if combine is not None and combine.annex is not None and "annex" in combine.model_fields_set:
        return combine.annex
    return "recommended" if reinforcement is None else reinforcement.annex


class Model(Section):
    """A model: plate, ground, loads, combinations, and settings of the analysis."""

    constraints: ClassVar[tuple[Check, ...]] = consistency.CHECKS

    title: Annotated[str, Text("title of the problem")] = ""
    project: Annotated[Project | None, Table("title block of the report")] = None
    report: Annotated[Report, Table("what the report holds")] = Report()
    plate: Annotated[Plate, Table("the plate")]
    plates: Annotated[tuple[FurtherPlate, ...], Table("further plates on the same ground", 100)] = ()
    joints: Annotated[tuple[Joint, ...], Table("joints between plates that share a line of their outlines", 1000)] = ()
    axes: Annotated[
        tuple[AxesFamily, ...],
        Table(
            "axes of the building, drawn in plans; columns, walls, beams, supports and loads may be attached to them",
            100,
        ),
    ] = ()
    ground: Annotated[Ground, Table("the ground under the plate")]
    beyond: Annotated[Beyond, Table("ground beyond the plate, without effect where it carries no shear")] = Beyond()
    contact: Annotated[Contact, Table("contact between plate and ground")] = Contact()
    soil_zones: Annotated[tuple[varying_ground.SoilZone, ...], Table("parts of the plan with other ground")] = ()
    boreholes: Annotated[
        tuple[varying_ground.Borehole, ...], Table("places where the layers are known, with interpolation between them")
    ] = ()
    supports: Annotated[
        tuple[Support, ...], Table("supports at points and along lines, in addition to the ground")
    ] = ()
    columns: Annotated[
        tuple[Column, ...], Table("columns on the plate, which loads name; punching is checked", 10_000)
    ] = ()
    walls: Annotated[
        tuple[Wall, ...],
        Table("walls on the plate, which loads name; shear is checked from their faces on, punching at ends", 10_000),
    ] = ()
    cores: Annotated[
        tuple[Core, ...], Table("cores of the building: walls over which their force and moments are distributed", 1000)
    ] = ()
    beams: Annotated[tuple[Beam, ...], Table("beams and ribs cast with the plate, which stiffen it", 1000)] = ()
    building: Annotated[
        Building | None, Table("stiffness of the building above, which joins the settlements of columns and walls")
    ] = None
    cases: Annotated[
        tuple[LoadCase, ...], Table("load cases; without any, all loads act together, without factors")
    ] = ()
    loads: Annotated[tuple[Load, ...], Table("the loads, at least one", 200_000)]
    reactions: Annotated[
        Reactions | None, Table("how loads were read from another program's table of reactions; kept for the next one")
    ] = None
    patterns: Annotated[tuple[Pattern, ...], Table("vehicles and racks, which moves place or take along paths")] = ()
    moves: Annotated[
        tuple[Move, ...], Table("where patterns are placed, and paths along which cases are solved at each position")
    ] = ()
    combinations: Annotated[
        tuple[Combination, ...],
        Table("combinations to solve; without any, each case by itself, or those generated by combine"),
    ] = ()
    combine: Annotated[
        Combine | None, Table("automatic combinations by EN 1990 or ACI 318, in addition to those given")
    ] = None
    output: Annotated[Output, Table("where values are listed")] = Output()
    reinforcement: Annotated[
        Reinforcement | None,
        Table("strength checks and reinforcement by EN 1992-1-1 or ACI 318; needs ultimate load combinations"),
    ] = None
    cracking: Annotated[
        Cracking | None, Table("cracked stiffness of the slab with its bars, in serviceability combinations")
    ] = None
    long_term: Annotated[LongTerm | None, Table("stiffness of the ground under long-term loads")] = None
    limits: Annotated[Limits | None, Table("limits for settlements, tilt and pressures")] = None
    soil_strength: Annotated[
        SoilStrength | None, Table("strength of the soil, for bearing resistance and sliding by EN 1997-1")
    ] = None
    checks: Annotated[Checks, Table("checks of the design that are switched off")] = Checks()
    floor: Annotated[Floor | None, Table("checks of an industrial floor, in addition to the elastic results")] = None
    mesh: Annotated[Mesh, Table("the mesh; made for an accuracy by default")] = Mesh()
    analysis: Annotated[Analysis, Table("how the equations are solved")] = Analysis()

    @classmethod
    def root(cls) -> str:
        """Return nothing: paths of issues start with the section."""
        return ""

    @classmethod
    def complete(cls, data: Mapping[Any, Any]) -> Mapping[Any, Any]:
        """Find the places of what is attached to axes."""
        return attach_to_axes(data)

    @classmethod
    def derive(cls, values: dict[str, Any], named: Set[Any]) -> dict[str, Any]:  # noqa: ARG003
        """Give cases and automatic combinations the national psi and partial factors that they do not give."""
        combine: Combine | None = values.get("combine")
        cases: tuple[LoadCase, ...] = values.get("cases", ())
        annex = _annex_of_actions(combine, values.get("reinforcement"))
        by_annex: dict[str, Any] = {"cases": tuple(case.by_annex(annex) for case in cases)} if cases else {}
        if combine is not None:
            by_annex["combine"] = combine.by_annex(annex)
        return {**values, **by_annex}

    @property
    def origin(self) -> tuple[float, float]:
        """Return where x = y = 0 lies in the plan that was given [m], see `plan_origin`; for messages."""
        origin: tuple[float, float] = vars(self).get("_origin", (0.0, 0.0))
        return origin

    def with_origin(self, origin: tuple[float, float]) -> Self:
        """Return the model, which has been moved, with its x = y = 0 at a place of the plan that was given [m]."""
        moved = self.model_copy()
        vars(moved)["_origin"] = origin
        return moved

    @property
    def units(self) -> System:
        """Return the units in which results are shown."""
        return "SI" if self.project is None else self.project.units

    @property
    def language(self) -> Language:
        """Return the language in which results are shown."""
        return "en" if self.project is None else self.project.language

    @property
    def ground_carries_shear(self) -> bool:
        """Return whether the ground carries shear in any layer anywhere."""
        grounds = (self.ground, *(zone.ground for zone in self.soil_zones))
        return any(any(carry_shear(ground)) for ground in grounds)

    @property
    def ground_reaches(self) -> bool:
        """Return whether ground beyond the plate has an effect: there is some, and it carries shear."""
        return self.beyond.kind != "none" and self.ground_carries_shear

    @property
    def plain(self) -> bool:
        """Return whether the plate is a plain rectangle without supports and beams that the mesh has to follow."""
        return self.plate.plain and not (self.supports or self.members or self.plates)

    @property
    def every_plate(self) -> tuple[AnyPlate, ...]:
        """Return the first plate and the further ones."""
        return list_plates(self.plate, self.plates)

    @property
    def placed_walls(self) -> tuple[Wall, ...]:
        """Return the walls with their axes, also those along edges of plates."""
        return place_walls(self.walls, self.every_plate)

    @property
    def members(self) -> tuple[Beam, ...]:
        """Return what stiffens the plate: beams, then the walls that have a height as deep beams."""
        return members_of(self.beams, self._stiff_walls, self.every_plate) if self._stiff_walls else self.beams

    @property
    def wall_of_members(self) -> tuple[int, ...]:
        """Return of which wall each member is a part, -1 of beams."""
        return wall_of_members(self.beams, self._stiff_walls, self.every_plate)

    @property
    def spans(self) -> tuple[Segment, ...]:
        """Return where members span openings of the plates."""
        return tuple(span for member in self.members for span in spans_as_segments(member, self.plate, self.plates))

    @property
    def spans_of_walls(self) -> dict[str, Ways]:
        """Return where walls with a height span openings of the plates, from way to way along each by its name [m]."""
        stiff = (wall for wall in self.placed_walls if wall.height is not None)
        by_name = {wall.name: spans_of(as_beam(wall), self.plate, self.plates) for wall in stiff}
        return {name: spans for name, spans in by_name.items() if spans}

    @property
    def building_lines(self) -> tuple[tuple[Place, ...], ...]:
        """Return the places that the beams of the building above run through in plan, from base to base [m]."""
        above = self.building
        standing = () if above is None else bases(above, self.columns, self.walls, self.every_plate, max(self.sides))
        return frame_lines(above, standing)

    @property
    def _stiff_walls(self) -> tuple[Wall, ...]:
        """Return the walls that have a height."""
        return tuple(wall for wall in self.walls if wall.height is not None)

    def shapes(self, load: AnyLoad) -> tuple[Acting, ...]:
        """Return the acting shapes of a load, at the place of its column, wall or core if it names one."""
        if isinstance(load, PointLoad):
            return load.on(self.columns).acts
        if isinstance(load, LineLoad | LineMoment) and load.wall:
            named = [wall for wall in self.walls if wall.name == load.wall]
            return load.acts_on(place_walls(named, self.every_plate))
        if isinstance(load, CoreLoad):
            core = next(core for core in self.cores if core.name == load.core)
            return load.acts_on(section_of(core, self.walls, self.every_plate))
        if isinstance(load, SelfWeight):
            beams = weights_of(self.beams, self.plate, self.plates, load) if load.beams else ()
            return *load.acts, *beams, *weights_of_pits(self.plate, self.plates, load)
        return load.acts

    @property
    def acting(self) -> tuple[tuple[AnyLoad, Acting], ...]:
        """Return the acting shapes, each with its load."""
        return tuple((load, shape) for load in self.loads for shape in self.shapes(load))

    def lasts(self, limit_state: str) -> bool:
        """Return whether the ground is that under lasting loads in a limit state."""
        return self.long_term is not None and limit_state in self.long_term.limit_states

    def with_lasting_ground(self) -> Self:
        """Return the model with its ground as it is under loads that last: all stiffnesses times one factor."""
        assert self.long_term is not None
        factor = self.long_term.stiffness
        described = {"soil_zones": self.soil_zones, "boreholes": self.boreholes}
        soft = {name: tuple(scale_stiffnesses(part, factor) for part in parts) for name, parts in described.items()}
        return self.model_copy(update={"ground": scale_stiffnesses(self.ground, factor), **soft})

    @property
    def zone_rings(self) -> tuple[Ring, ...]:
        """Return the borders of the soil zones, in their order."""
        return tuple(zone.shape.ring() for zone in self.soil_zones)

    @property
    def void_rings(self) -> tuple[Ring, ...]:
        """Return the borders of the voids, in their order."""
        return tuple(void.ring() for void in self.contact.voids)

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Return the rectangle x0, x1, y0, y1 around all plates [m]."""
        return bounds_of(self.plate, self.plates)

    @property
    def sides(self) -> tuple[float, float]:
        """Return the sides of the rectangle around all plates [m]."""
        x0, x1, y0, y1 = self.bounds
        return x1 - x0, y1 - y0


def json_schema() -> dict[str, Any]:
    """Return the JSON schema of the input file, for editors."""
    return reference.json_schema(Model, "groundslab input file")


def docs_table() -> str:
    """Return all keys of the input file as Markdown, one table per section and kind."""
    return reference.docs_table(Model)
