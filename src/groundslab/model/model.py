"""The description of a problem: plate, ground, loads and how to compute, as the input file says it.

Attributes are named as the keys of the file and hold SI units. Every part can be built from Python too, with
floats in SI units or text with units; what is wrong is told all at once as InputError. Positions in the paths
of faults count from 1, as people count ``[[loads]]`` and ``[[ground.layers]]`` in a file.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from pydantic import Field

from groundslab.model.columns import Column
from groundslab.model.ground import (
    POSITIVE,
    AnyGround,
    Ground,
    InterfaceLayer,
    Layered,
    Pasternak,
    Selvadurai,
    SoilLayer,
    Vlasov,
    Winkler,
)
from groundslab.model.loads.clipping import loads_reach_plate
from groundslab.model.loads.load_cases import (
    Combination,
    Combine,
    LoadCase,
    combine_makes,
    design_has_loads,
    known_cases,
    known_factors,
)
from groundslab.model.loads.load_types import (  # fmt: skip
    AnyLoad,
    AreaLoad,
    Covered,
    LineLoad,
    Load,
    PatchLoad,
    PointLoad,
    SelfWeight,
    SettlementLoad,
    TemperatureLoad,
    UniformLoad,
    Void,
    loads_have_a_column,
    loads_on_plate,
    on_plate,
    voids_on_plate,
)
from groundslab.model.outputs import (
    Output,
    OutputLine,
    OutputPoint,
    OutputStrip,
    Reinforcement,
    bars_within,
    output_on_plate,
)
from groundslab.model.plate import Edges, Plate, Zone
from groundslab.model.shapes import Circle, Polygon, Rectangle
from groundslab.model.supports import (
    AnySupport,
    LineSupport,
    PointSupport,
    Support,
    lines_run,
    named_once,
    supports_far_off,
)
from groundslab.model.varying_ground import (
    Borehole,
    GapPoint,
    SoilZone,
    boreholes_match,
    depth_fits,
    gaps_apart,
    zones_match,
    zones_near,
)
from groundslab.schema import reference
from groundslab.schema.base import Check, Part, Table
from groundslab.schema.fields import Choice, Flag, Quantity, Several, Text, Whole
from groundslab.schema.issues import Finding, describe, one_of, quote, suggestion
from groundslab.schema.ranges import Range

__all__ = [
    "Analysis", "AreaLoad", "Beyond", "Borehole", "Circle", "Column", "Combination", "Combine", "Contact", "Edges",
    "GapPoint", "InterfaceLayer", "Layered", "LineLoad", "LineSupport", "LoadCase", "Mesh", "Model", "Output",
    "OutputLine", "OutputPoint", "OutputStrip", "Pasternak", "PatchLoad", "Plate", "PointLoad", "PointSupport",
    "Polygon", "Rectangle", "Reinforcement", "SelfWeight", "Selvadurai", "SettlementLoad", "SoilLayer", "SoilZone",
    "TemperatureLoad", "UniformLoad", "Vlasov", "Void", "Winkler", "Zone", "docs_table", "json_schema",
]  # fmt: skip

if TYPE_CHECKING:
    from groundslab.geometry.plan import Plan, Ring

MOST_ELEMENTS = 4_000_000  # in all surfaces; nobody wants to fill the memory by a typing error
MOST_SURFACES = 200  # each couples with all others at every node
SHORT_SIDE_ELEMENTS = 24  # where the mesh is not described

Reach = Literal["none", "margin", "infinite"]
OuterEdge = Literal["free", "fixed"]
Side = Literal["left", "right", "bottom", "top"]
Symmetry = Literal["auto", "off"]
Solver = Literal["auto", "pardiso", "superlu", "mumps"]

SIDES: tuple[Side, ...] = ("left", "right", "bottom", "top")


def _width_fits(kind: str, width: float | None) -> Iterator[Finding]:
    if kind == "margin" and width is None:
        yield Finding(("width",), "nothing", 'a length such as "5 m", as kind is "margin"')
    if kind == "none" and width is not None:
        yield Finding(("width",), f"{width!r} m", 'no width, as kind is "none"', 'kind = "margin" has a width')


def _edge_fits(kind: str, edge: str, given: set[str]) -> Iterator[Finding]:
    if kind != "margin" and "edge" in given:
        yield Finding(("edge",), quote(edge), f'no edge, as kind is "{kind}"', 'kind = "margin" has an outer edge')


class Beyond(Part):
    """The ground beyond the plate; without effect where the ground carries no shear, as springs do not reach there."""

    checks: ClassVar[tuple[Check, ...]] = (_width_fits, _edge_fits)

    kind: Annotated[
        Reach,
        Choice(Reach, "none: the ground ends with the plate; margin: a strip of ground; infinite: no end"),
    ] = "none"
    width: Annotated[
        float | None,
        Quantity(
            "length",
            "b",
            "width of the meshed strip; needed for a margin; if infinite, by default the length over which the ground "
            "dies out, and one whose widening changes settlements by more than 1 % is refused",
            POSITIVE,
        ),
    ] = None
    edge: Annotated[OuterEdge, Choice(OuterEdge, "outer edge of a margin")] = "free"
    sides: Annotated[
        tuple[Side, ...],
        Several(Choice(Side, ""), "", "sides of the plate with ground beyond them", unique=True),
    ] = SIDES


def _gap_may_open(tensionless: bool, gap: float) -> Iterator[Finding]:
    if not tensionless and gap > 0:
        yield Finding(("gap",), f"{gap!r} m", "no gap, as tensionless is false")


def _void_may_open(tensionless: bool, voids: tuple[Void, ...]) -> Iterator[Finding]:
    if not tensionless and voids:
        yield Finding(("voids",), describe(voids), "no voids, as tensionless is false")


def _gaps_may_open(tensionless: bool, gaps: tuple[GapPoint, ...]) -> Iterator[Finding]:
    if not tensionless and gaps:
        yield Finding(("gaps",), describe(gaps), "no gaps, as tensionless is false")


def _ground_may_yield(tensionless: bool, limit_pressure: float | None) -> Iterator[Finding]:
    if not tensionless and limit_pressure is not None:
        yield Finding(("limit_pressure",), f"{limit_pressure!r} Pa", "no limit, as tensionless is false")


class Contact(Part):
    """Contact between plate and ground."""

    checks: ClassVar[tuple[Check, ...]] = (
        _gap_may_open,
        _void_may_open,
        _gaps_may_open,
        gaps_apart,
        _ground_may_yield,
    )

    tensionless: Annotated[bool, Flag("whether the plate may lift off")] = True
    gap: Annotated[float, Quantity("length", "g_0", "initial gap everywhere under the plate", Range(at_least=0))] = 0.0
    voids: Annotated[
        tuple[Void, ...], Table("parts with a further gap, or none to reach; the deeper counts where they overlap")
    ] = ()
    gaps: Annotated[
        tuple[GapPoint, ...],
        Table("measured gaps, further to gap, a smooth surface between them; a plane stays a plane", 2000),
    ] = ()
    limit_pressure: Annotated[
        float | None,
        Quantity(
            "pressure",
            "p_max",
            "pressure at which the ground yields, no limit by default; line forces along the plate's "
            "edges are none, but loads may not exceed this pressure over all of the plate",
            POSITIVE,
        ),
    ] = None


def _one_size(size: float | None, counts: tuple[int, int] | None) -> Iterator[Finding]:
    if size is not None and counts is not None:
        yield Finding((), "both size and counts", "at most one of size and counts")


class Mesh(Part):
    """The mesh of the plate; without size and counts the shorter side has 24 elements."""

    checks: ClassVar[tuple[Check, ...]] = (_one_size,)

    size: Annotated[
        float | None,
        Quantity("length", "h", "largest side of an element; smaller at edges where needed", POSITIVE),
    ] = None
    counts: Annotated[
        tuple[int, int] | None, Several(Whole("", at_most=100_000), "n_x, n_y", "elements over the whole plate", 2)
    ] = None
    symmetry: Annotated[
        Symmetry, Choice(Symmetry, "whether a half or a quarter is computed where all is symmetric")
    ] = "auto"


class Analysis(Part):
    """How the equations are solved."""

    increments: Annotated[
        int, Whole("steps in which the load is applied; the result does not depend on it", at_most=1000)
    ] = 1
    solver: Annotated[
        Solver, Choice(Solver, "direct solver; auto takes pardiso where it is installed, mumps is for many processes")
    ] = "auto"
    nested: Annotated[bool, Flag("start the contact zone from coarser meshes")] = True
    max_iterations: Annotated[int, Whole("most contact steps on one mesh", at_most=10_000)] = 200


def plate_elements(plate: Plate, mesh: Mesh) -> float:
    """Return about how many elements the whole plate has."""
    if mesh.counts is not None:
        return mesh.counts[0] * mesh.counts[1]
    x, y = plate.sides
    size = mesh.size if mesh.size is not None else min(x, y) / SHORT_SIDE_ELEMENTS
    return max(1.0, x / size) * max(1.0, y / size)


def _few_elements(plate: Plate, mesh: Mesh) -> Iterator[Finding]:
    total = plate_elements(plate, mesh)
    if total > MOST_ELEMENTS:
        key = ("counts",) if mesh.counts is not None else ("size",) if mesh.size is not None else ()
        yield Finding(("mesh", *key), f"about {total:.3g} elements", f"at most {MOST_ELEMENTS:,} elements")


def _few_in_all_surfaces(plate: Plate, mesh: Mesh, ground: AnyGround) -> Iterator[Finding]:
    if isinstance(ground, Layered):
        surfaces = sum(layer.sublayers if isinstance(layer, SoilLayer) else 1 for layer in ground.layers)
        on_plate = plate_elements(plate, mesh)
        if surfaces > MOST_SURFACES:
            yield Finding(("ground", "layers"), f"{surfaces} layers and sublayers", f"at most {MOST_SURFACES}")
        elif on_plate <= MOST_ELEMENTS < on_plate * surfaces:
            got = f"{surfaces} layers and sublayers on about {on_plate:.3g} elements"
            yield Finding(("ground", "layers"), got, f"at most {MOST_ELEMENTS:,} for the product of both")


def _layers_shear(ground: AnyGround) -> list[bool]:
    """Return whether the layers of a ground carry shear, from the top downwards."""
    if isinstance(ground, Winkler):
        return [False]
    if isinstance(ground, Pasternak):
        return [ground.k1 > 0]
    return [not isinstance(layer, InterfaceLayer) or layer.k1 > 0 for layer in ground.layers]


def _all_shear_or_none(ground: AnyGround, soil_zones: tuple[SoilZone, ...], beyond: Beyond) -> Iterator[Finding]:
    """Find layers without shear beside others with it, where the ground beyond is infinite.

    Ground without any shear is the limit in which it ends with the plate; of such layers beneath or beside others no
    tail is known.
    """
    grounds = {("ground",): ground} | {("soil_zones", n, "ground"): zone.ground for n, zone in enumerate(soil_zones)}
    shears = {place: _layers_shear(each) for place, each in grounds.items()}
    if beyond.kind != "infinite" or not any(map(any, shears.values())):
        return
    for place, layers in shears.items():
        for number in (number for number, shear in enumerate(layers) if not shear):
            key = ("layers", number, "k1") if isinstance(grounds[place], Layered) else ("k1",)
            mend = 'beyond.kind = "margin" needs no shear'
            if isinstance(grounds[place], Winkler):
                continue  # of another kind than the rest, which is told elsewhere
            yield Finding((*place, *key), "0 N/m", "k1 above 0, as other ground has it and is infinite", mend)


def _voids_on_plate(plate: Plate, contact: Contact) -> Iterator[Finding]:
    return voids_on_plate(plate, contact.voids)


def _counts_fit(plate: Plate, mesh: Mesh, supports: tuple[AnySupport, ...]) -> Iterator[Finding]:
    if mesh.counts is not None and (supports or not plate.plain):
        mend = "counts are for a rectangle without openings, zones and supports"
        yield Finding(("mesh", "counts"), "counts", "a size", mend)


def _known_cases(loads: tuple[AnyLoad, ...], cases: tuple[LoadCase, ...]) -> Iterator[Finding]:
    yield from named_once("cases", [case.name for case in cases], needed=True)
    yield from known_cases("loads", "case", [load.case for load in loads], cases)


def _known_factors(combinations: tuple[Combination, ...], cases: tuple[LoadCase, ...]) -> Iterator[Finding]:
    yield from named_once("combinations", [each.name for each in combinations], needed=True)
    yield from known_factors(combinations, cases)


def _columns_on_plate(plate: Plate, columns: tuple[Column, ...]) -> Iterator[Finding]:
    yield from named_once("columns", [column.name for column in columns], needed=True)
    covered = Covered(plate)
    for position, column in enumerate(columns):
        yield from on_plate(covered, column, ("columns", position))


def _supports_on_plate(plate: Plate, supports: tuple[AnySupport, ...]) -> Iterator[Finding]:
    """Find supports that cannot be met by a mesh."""
    yield from lines_run(supports)
    yield from named_once("supports", [support.name for support in supports], needed=False)
    far = list(supports_far_off(plate, supports))
    yield from far
    if not supports or far or any(lines_run(supports)):
        return
    from groundslab.geometry.validity import faults

    points = [n for n, support in enumerate(supports) if isinstance(support, PointSupport)]
    lines = [n for n, support in enumerate(supports) if isinstance(support, LineSupport)]
    called = {f"plate.points[{n}]": number for n, number in enumerate(points, start=1)}
    called |= {f"plate.lines[{n}]": number for n, number in enumerate(lines, start=1)}
    for fault in faults(plan_of_plate(plate, supports)):
        met = next((name for name in called if name in fault.got), None)
        got = fault.got if met is None else fault.got.replace(met, f"supports[{called[met] + 1}]")
        if fault.where in called:
            yield Finding(("supports", called[fault.where]), got, fault.expected, fault.mend)
        elif met is not None:
            # what comes near or grazes another is told of the one or of the other; a zone meets a support, too
            got = fault.got.replace(met, fault.where)
            yield Finding(("supports", called[met]), got, fault.expected, fault.mend)


def plan_of_plate(plate: Plate, supports: tuple[AnySupport, ...], beyond: Ring | None = None) -> Plan:
    """Return the plan of a plate with its supports: zone i is section i."""
    from groundslab.geometry.plan import Plan

    return Plan(
        plate.ring(),
        tuple(shape.ring() for shape in plate.openings),
        tuple((zone.shape.ring(), number) for number, zone in enumerate(plate.zones, start=1)),
        beyond,
        tuple((support.x, support.y) for support in supports if isinstance(support, PointSupport)),
        tuple(support.points for support in supports if isinstance(support, LineSupport)),
    )


def _settlements_have_a_support(loads: tuple[AnyLoad, ...], supports: tuple[AnySupport, ...]) -> Iterator[Finding]:
    names = [support.name for support in supports if support.name]
    known = set(names)
    for position, load in enumerate(loads):
        if isinstance(load, SettlementLoad) and load.support not in known:
            expected = one_of(names) if names else "a support, and [[supports]] that says where it is"
            place = ("loads", position, "support")
            yield Finding(place, describe(load.support), expected, suggestion(load.support, names))


#: What a load may have that makes something act.
_ACTING = ("q", "q_end", "P", "M_x", "M_y", "unit_weight", "difference", "w", "slope", "bend")


def _something_acts(loads: tuple[AnyLoad, ...]) -> Iterator[Finding]:
    """Find loads that are all zero."""
    given = (getattr(load, name, None) for load in loads for name in _ACTING)
    if not any(any(value) if isinstance(value, tuple) else value for value in given):
        yield Finding(("loads",), "loads that are all zero", "at least one load that is not", "nothing would settle")


class Model(Part):
    """The whole description of a problem."""

    checks: ClassVar[tuple[Check, ...]] = (
        _all_shear_or_none,
        _something_acts,
        loads_on_plate,
        loads_reach_plate,
        _voids_on_plate,
        _few_elements,
        _few_in_all_surfaces,
        _counts_fit,
        _known_cases,
        _known_factors,
        combine_makes,
        _columns_on_plate,
        loads_have_a_column,
        _supports_on_plate,
        _settlements_have_a_support,
        zones_match,
        zones_near,
        depth_fits,
        boreholes_match,
        output_on_plate,
        bars_within,
        design_has_loads,
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
        return self.beyond.kind != "none" and any(any(_layers_shear(each)) for each in grounds)

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
