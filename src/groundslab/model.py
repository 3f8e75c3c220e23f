"""The description of a problem: plate, ground, loads and how to compute, as the input file says it.

Attributes are named as the keys of the file and hold SI units. Every part can be built from Python too, with
floats in SI units or text with units; what is wrong is told all at once as InputError. Positions in the paths
of faults count from 1, as people count ``[[loads]]`` and ``[[ground.layers]]`` in a file.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field

from groundslab import reference
from groundslab.actions import (
    AreaLoad,
    LineLoad,
    Load,
    PatchLoad,
    PointLoad,
    SelfWeight,
    UniformLoad,
    Void,
    loads_on_plate,
    voids_on_plate,
)  # fmt: skip
from groundslab.findings import Finding, describe, listed, quote
from groundslab.keys import Choice, Flag, Quantity, Range, Several, Text, Whole
from groundslab.outline import Circle, Polygon, Rectangle
from groundslab.schema import Check, Part, Table
from groundslab.slab import Edges, Plate, Zone
from groundslab.soil import (
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

__all__ = [
    "Analysis", "AreaLoad", "Beyond", "Circle", "Contact", "Edges", "InterfaceLayer", "Layered", "LineLoad", "Mesh",
    "Model", "Pasternak", "PatchLoad", "Plate", "PointLoad", "Polygon", "Rectangle", "SelfWeight", "Selvadurai",
    "SoilLayer", "UniformLoad", "Vlasov", "Void", "Winkler", "Zone", "docs_table", "json_schema",
]  # fmt: skip

MOST_ELEMENTS = 4_000_000  # in all surfaces; nobody wants to fill the memory by a typing error
SHORT_SIDE_ELEMENTS = 24  # where the mesh is not described

Reach = Literal["none", "margin", "infinite"]
OuterEdge = Literal["free", "fixed"]
Side = Literal["left", "right", "bottom", "top"]
Symmetry = Literal["auto", "off"]
Solver = Literal["auto", "pardiso", "superlu"]

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
    """The ground beyond the plate."""

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
            "width of the meshed strip; needed for a margin, chosen by default if infinite",
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


class Contact(Part):
    """Contact between plate and ground."""

    checks: ClassVar[tuple[Check, ...]] = (_gap_may_open, _void_may_open)

    tensionless: Annotated[bool, Flag("whether the plate may lift off")] = True
    gap: Annotated[float, Quantity("length", "g_0", "initial gap everywhere under the plate", Range(at_least=0))] = 0.0
    voids: Annotated[
        tuple[Void, ...], Table("rectangles with a further gap; the deeper one counts where they overlap")
    ] = ()


def _one_size(size: float | None, counts: tuple[int, int] | None) -> Iterator[Finding]:
    if size is not None and counts is not None:
        yield Finding((), "both size and counts", "at most one of size and counts")


class Mesh(Part):
    """The mesh of the plate; without size and counts the shorter side has 24 elements."""

    checks: ClassVar[tuple[Check, ...]] = (_one_size,)

    size: Annotated[float | None, Quantity("length", "h", "largest side of an element", POSITIVE)] = None
    counts: Annotated[tuple[int, int] | None, Several(Whole(""), "n_x, n_y", "elements over the whole plate", 2)] = None
    symmetry: Annotated[
        Symmetry, Choice(Symmetry, "whether a half or a quarter is computed where all is symmetric")
    ] = "auto"


class Analysis(Part):
    """How the equations are solved."""

    increments: Annotated[int, Whole("steps in which the load is applied; the result does not depend on it")] = 1
    solver: Annotated[Solver, Choice(Solver, "direct solver; auto takes pardiso where it is installed")] = "auto"
    nested: Annotated[bool, Flag("start the contact zone from coarser meshes")] = True
    max_iterations: Annotated[int, Whole("most contact steps on one mesh")] = 200


def _plate_elements(plate: Plate, mesh: Mesh) -> float:
    """Return about how many elements the whole plate has."""
    if mesh.counts is not None:
        return mesh.counts[0] * mesh.counts[1]
    x, y = plate.sides
    size = mesh.size if mesh.size is not None else min(x, y) / SHORT_SIDE_ELEMENTS
    return max(1.0, x / size) * max(1.0, y / size)


def _few_elements(plate: Plate, mesh: Mesh) -> Iterator[Finding]:
    total = _plate_elements(plate, mesh)
    if total > MOST_ELEMENTS:
        key = ("counts",) if mesh.counts is not None else ("size",) if mesh.size is not None else ()
        yield Finding(("mesh", *key), f"about {total:.3g} elements", f"at most {MOST_ELEMENTS:,} elements")


def _few_in_all_surfaces(plate: Plate, mesh: Mesh, ground: AnyGround) -> Iterator[Finding]:
    if isinstance(ground, Layered):
        surfaces = sum(layer.sublayers if isinstance(layer, SoilLayer) else 1 for layer in ground.layers)
        on_plate = _plate_elements(plate, mesh)
        if on_plate <= MOST_ELEMENTS < on_plate * surfaces:
            got = f"{surfaces} layers and sublayers on about {on_plate:.3g} elements"
            yield Finding(("ground", "layers"), got, f"at most {MOST_ELEMENTS:,} for the product of both")


def _ground_reaches(ground: AnyGround, beyond: Beyond) -> Iterator[Finding]:
    if beyond.kind == "none":
        return
    place, got = ("beyond", "kind"), f'"{beyond.kind}"'
    if isinstance(ground, Winkler):
        yield Finding(place, got, '"none": springs do not reach beyond the plate', 'ground.kind is "winkler"')
    elif beyond.kind == "infinite" and isinstance(ground, Pasternak) and ground.k1 == 0:
        yield Finding(place, got, '"none" or "margin": without shear the ground ends with the plate', "ground.k1 is 0")
    elif beyond.kind == "infinite" and isinstance(ground, Layered):
        dull = [n for n, layer in enumerate(ground.layers, 1) if isinstance(layer, InterfaceLayer) and layer.k1 == 0]
        if dull:
            names = listed((f"ground.layers[{n}].k1" for n in dull), "and")
            mend = f"{names} {'is' if len(dull) == 1 else 'are'} 0"
            yield Finding(place, got, '"none" or "margin": without shear a layer ends with the plate', mend)


def _voids_on_plate(plate: Plate, contact: Contact) -> Iterator[Finding]:
    return voids_on_plate(plate, contact.voids)


def _counts_fit(plate: Plate, mesh: Mesh) -> Iterator[Finding]:
    if mesh.counts is not None and not plate.plain:
        yield Finding(("mesh", "counts"), "counts", "a size", "counts are for a rectangle without openings and zones")


class Model(Part):
    """The whole description of a problem."""

    checks: ClassVar[tuple[Check, ...]] = (
        _ground_reaches,
        loads_on_plate,
        _voids_on_plate,
        _few_elements,
        _few_in_all_surfaces,
        _counts_fit,
    )

    title: Annotated[str, Text("title of the problem")] = ""
    plate: Annotated[Plate, Table("the plate")]
    ground: Annotated[Ground, Table("the ground under the plate")]
    beyond: Annotated[Beyond, Table("the ground beyond the plate")] = Beyond()
    contact: Annotated[Contact, Table("contact between plate and ground")] = Contact()
    loads: Annotated[tuple[Load, ...], Field(min_length=1), Table("the loads, at least one")]
    mesh: Annotated[Mesh, Table("the mesh; 24 elements over the shorter side by default")] = Mesh()
    analysis: Annotated[Analysis, Table("how the equations are solved")] = Analysis()

    @classmethod
    def root(cls) -> str:
        """Return nothing: paths of faults start with the section."""
        return ""


def json_schema() -> dict[str, Any]:
    """Return the JSON schema of the input file, for editors."""
    return reference.json_schema(Model, "groundslab input file")


def docs_table() -> str:
    """Return all keys of the input file as Markdown, one table per section and kind."""
    return reference.docs_table(Model)
