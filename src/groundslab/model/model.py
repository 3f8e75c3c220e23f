"""The description of a problem: plate, ground, loads and how to compute, as the input file says it.

Attributes are named as the keys of the file and hold SI units. Every part can be built from Python too, with
floats in SI units or text with units; what is wrong is told all at once as InputError. Positions in the paths
of faults count from 1, as people count ``[[loads]]`` and ``[[ground.layers]]`` in a file.
"""

from __future__ import annotations

from typing import Annotated, Any, ClassVar

from pydantic import Field

from groundslab.model.columns import Column
from groundslab.model.consistency import (
    all_shear_or_none,
    columns_on_plate,
    combinations_have_cases,
    counts_fit,
    few_elements,
    few_in_all_surfaces,
    layers_shear,
    loads_have_cases,
    settlements_have_a_support,
    something_acts,
    supports_on_plate,
    voids_lie_on_plate,
)
from groundslab.model.ground import Ground
from groundslab.model.loads.clipping import loads_reach_plate
from groundslab.model.loads.en1990 import check_combine
from groundslab.model.loads.load_cases import Combination, Combine, LoadCase, check_design_combinations
from groundslab.model.loads.load_types import Load
from groundslab.model.loads.placement import loads_have_a_column, loads_on_plate
from groundslab.model.outputs import Output, Reinforcement, bars_within, output_on_plate
from groundslab.model.plate import Plate
from groundslab.model.settings import Analysis, Beyond, Contact, Mesh
from groundslab.model.supports import Support
from groundslab.model.varying_ground import Borehole, SoilZone, boreholes_match, depth_fits, zones_match, zones_near
from groundslab.schema import reference
from groundslab.schema.base import Check, Section, Table
from groundslab.schema.fields import Text


class Model(Section):
    """The whole description of a problem."""

    checks: ClassVar[tuple[Check, ...]] = (
        all_shear_or_none,
        something_acts,
        loads_on_plate,
        loads_reach_plate,
        voids_lie_on_plate,
        few_elements,
        few_in_all_surfaces,
        counts_fit,
        loads_have_cases,
        combinations_have_cases,
        check_combine,
        columns_on_plate,
        loads_have_a_column,
        supports_on_plate,
        settlements_have_a_support,
        zones_match,
        zones_near,
        depth_fits,
        boreholes_match,
        output_on_plate,
        bars_within,
        check_design_combinations,
    )

    title: Annotated[str, Text("title of the problem")] = ""
    plate: Annotated[Plate, Table("the plate")]
    ground: Annotated[Ground, Table("the ground under the plate")]
    beyond: Annotated[Beyond, Table("ground beyond the plate, without effect where it carries no shear")] = Beyond()
    contact: Annotated[Contact, Table("contact between plate and ground")] = Contact()
    soil_zones: Annotated[tuple[SoilZone, ...], Table("parts of the plan with other ground")] = ()
    boreholes: Annotated[tuple[Borehole, ...], Table("where the layers are known, to be interpolated between")] = ()
    supports: Annotated[tuple[Support, ...], Table("supports at points and along lines, beside the ground")] = ()
    columns: Annotated[
        tuple[Column, ...], Table("columns on the plate, which loads name; punching is checked", 10_000)
    ] = ()
    cases: Annotated[
        tuple[LoadCase, ...], Table("load cases; without any, all loads act together, without factors")
    ] = ()
    loads: Annotated[tuple[Load, ...], Field(min_length=1), Table("the loads, at least one", 200_000)]
    combinations: Annotated[
        tuple[Combination, ...], Table("what to solve; without any, each case by itself, or what combine makes")
    ] = ()
    combine: Annotated[Combine | None, Table("automatic combinations by EN 1990, beside those given")] = None
    output: Annotated[Output, Table("where values are listed")] = Output()
    reinforcement: Annotated[
        Reinforcement | None,
        Table("what reinforcement by EN 1992-1-1 is found for; needs ultimate combinations of loads"),
    ] = None
    mesh: Annotated[Mesh, Table("the mesh; 24 elements over the shorter side by default")] = Mesh()
    analysis: Annotated[Analysis, Table("how the equations are solved")] = Analysis()

    @classmethod
    def root(cls) -> str:
        """Return nothing: paths of faults start with the section."""
        return ""

    @property
    def ground_reaches(self) -> bool:
        """Return whether ground beyond the plate has an effect: there is some, and it carries shear."""
        grounds = (self.ground, *(zone.ground for zone in self.soil_zones))
        return self.beyond.kind != "none" and any(any(layers_shear(each)) for each in grounds)

    @property
    def plain(self) -> bool:
        """Return whether the plate is a plain rectangle whose mesh need not meet any support within it."""
        return self.plate.plain and not self.supports


def json_schema() -> dict[str, Any]:
    """Return the JSON schema of the input file, for editors."""
    return reference.json_schema(Model, "groundslab input file")


def docs_table() -> str:
    """Return all keys of the input file as Markdown, one table per section and kind."""
    return reference.docs_table(Model)
