"""The slab that is read from a building: which one it is, its outline, material and what lies in it."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NoReturn

from groundslab.errors import InputError, Issue
from groundslab.exchange.saf.reading.context import ReadContext, RowFault, Vector, cross, dot, text, texts, word
from groundslab.exchange.saf.reading.geometry import CLOSE, Edge, make_edges, to_ring
from groundslab.exchange.saf.reading.workbook import Row
from groundslab.exchange.saf.units import GRAVITY
from groundslab.geometry.plan import FLAT, Place
from groundslab.schema.wording import describe, one_of

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: Poisson's ratio of uncracked concrete (EN 1992-1-1 3.1.3(4)), and its weight per mass (EN 1991-1-1 Table A.1).
NU, UNIT_WEIGHT = 0.2, 25e3
#: Thermal expansion of concrete (EN 1992-1-1 3.1.3(5)), and more than any building material has [1/K].
EXPANSION, MOST_EXPANSION = 1e-5, 1e-3
#: G of isotropic materials, E / (2 (1 + nu)), and that of a file may differ by this part of it.
SHEAR = 0.02
#: So much beyond the edges of the slab is still on it [m].
BESIDE = 1e-6


@dataclass(frozen=True, slots=True)
class Material:
    """A material: E [Pa], nu, weight per volume [N/m3], quality as the file names it, thermal expansion [1/K]."""

    E: float
    nu: float
    unit_weight: float
    quality: str
    expansion: float


@dataclass(slots=True)
class Slab:
    """The slab that is read: its row, height [m], edges, material and thickness [m]; what lies in it by name."""

    row: Row
    height: float
    edges: tuple[Edge, ...]
    material: Material
    thickness: float
    openings: dict[str, tuple[Edge, ...]] = field(default_factory=dict)
    regions: dict[str, tuple[Edge, ...]] = field(default_factory=dict)
    internal: dict[str, tuple[Edge, ...]] = field(default_factory=dict)
    ribs: dict[str, tuple[Edge, ...]] = field(default_factory=dict)
    #: The edge on which each wall stands, with its number in the wall.
    walls: dict[str, tuple[int, Edge]] = field(default_factory=dict)
    #: Names of the columns that are taken by their places.
    columns: dict[str, Place] = field(default_factory=dict)
    plan: BaseGeometry | None = None

    @property
    def name(self) -> str:
        """Return its name."""
        return self.row.name

    @property
    def area(self) -> BaseGeometry:
        """Return the slab without its openings, arcs as chords; kept once all openings are known."""
        from shapely import make_valid

        if self.plan is None:
            size = max(max(abs(x), abs(y)) for edge in self.edges for x, y in edge.points)
            chord = FLAT * max(size, 1.0)
            # curves that cross themselves are issues of the plate
            self.plan = make_valid(to_ring(self.edges).polygon(chord))
            for opening in self.openings.values():
                self.plan = self.plan.difference(make_valid(to_ring(opening).polygon(chord)))
        return self.plan

    def holds(self, place: Place) -> bool:
        """Return whether a place lies on the slab, not in an opening."""
        from shapely import Point

        return bool(self.area.distance(Point(place)) <= BESIDE + FLAT * math.hypot(*place))


@dataclass(frozen=True, slots=True)
class SlabInFile:
    """A slab of a file that may be read.

    Attributes
    ----------
    name : str
        Its name.
    height : float
        Height of its plane [m].
    sides : tuple of float
        Its extent along x and y of the plan [m].
    on_ground : bool
        Whether it has a surface support.
    """

    name: str
    height: float
    sides: tuple[float, float]
    on_ground: bool


def find_slabs(context: ReadContext) -> tuple[SlabInFile, ...]:
    """Return the slabs of a file: those on ground first, then from the lowest to the highest."""
    on_ground = {text(row, "2dmember") for row in context.rows("StructuralSurfaceConnection")}
    slabs = []
    for row, height, edges in _level_members(context):
        x, y = zip(*(place for edge in edges for place in edge.points), strict=True)
        sides = (max(x) - min(x), max(y) - min(y))
        slabs.append(SlabInFile(row.name, height, sides, row.name in on_ground))
    return tuple(sorted(slabs, key=lambda slab: (not slab.on_ground, slab.height)))


def choose_slab(context: ReadContext, name: str) -> Slab:
    """Return the slab of a name, or the only one on ground, or the only lowest one; raises InputError."""
    level = {row.name: (row, height, edges) for row, height, edges in _level_members(context)}
    if name:
        if name not in level:
            _refuse(context, f"no horizontal member {describe(name)}", level)
        chosen = [name]
    else:
        on_ground = {text(row, "2dmember") for row in context.rows("StructuralSurfaceConnection")}
        lowest = min((height for _, height, _ in level.values()), default=0.0)
        chosen = [candidate for candidate in level if candidate in on_ground]
        chosen = chosen or [candidate for candidate, (_, height, _) in level.items() if height <= lowest + CLOSE]
        if len(chosen) != 1:
            _refuse(context, f"{len(chosen) or 'no'} slabs to choose from", level)
    row, height, edges = level[chosen[0]]
    with context.reading(row):
        slab = Slab(row, height, edges, read_material(context, row), read_thickness(context, row))
        for edge in edges:
            _note_remark(context, row, edge)
        _note_others(context, row)
        context.take(row, "plate")
        return slab
    raise InputError(context.issues)


def _note_others(context: ReadContext, row: Row) -> None:
    """Note what a slab says of itself that is not taken."""
    eccentric = any(context.number(row, key, "size", 0.0) for key in ("analysiszeccentricity", "eccentricityez"))
    if eccentric or word(row, "systemplaneat", default="centre") not in ("centre", "center"):
        context.note(row, "its plane, taken to be the slab's middle plane: loads and supports act there")
    if (behavior := word(row, "behaviorinanalysis", default="isotropic")) != "isotropic":
        context.note(row, f"a behavior that is {behavior}, taken as isotropic")


def _refuse(context: ReadContext, found: str, level: dict[str, tuple[Row, float, tuple[Edge, ...]]]) -> NoReturn:
    """Raise InputError with the slabs that there are."""
    slabs = [f"{name} at {height:.4g} m" for name, (_, height, _) in level.items()]
    expected = f"the name of a slab: {one_of(slabs)}" if slabs else "a horizontal surface member"
    raise InputError([*context.issues, Issue(f"{context.path}, sheet StructuralSurfaceMember", found, expected)])


def _level_members(context: ReadContext) -> list[tuple[Row, float, tuple[Edge, ...]]]:
    """Return the horizontal members that can be read, with their heights and edges."""
    members, faults = [], list[RowFault]()
    for row in context.rows("StructuralSurfaceMember"):
        try:
            edges = read_edges(context, row, closed=True)
        except RowFault as fault:
            faults.append(fault)  # elsewhere in the building it does not matter
            continue
        height = edges[0].places[0][2]
        if row.name and all(edge.level(height) for edge in edges):
            members.append((row, height, edges))
    if faults and not members:
        where = f"{context.path}, sheet StructuralSurfaceMember, {faults[0].column}"
        context.add(Issue(where, faults[0].found, faults[0].expected, faults[0].hint))
    return members


def read_edges(context: ReadContext, row: Row, closed: bool) -> tuple[Edge, ...]:
    """Return the edges of a member through its nodes; raises RowFault."""
    places = [context.node(name) for name in texts(row, "nodes")]
    return make_edges(places, texts(row, "edges") or texts(row, "segments"), closed)


def read_part(context: ReadContext, row: Row, slab: Slab, closed: bool) -> tuple[Edge, ...]:
    """Return the edges of what lies in the slab; raises RowFault if it does not."""
    edges = read_edges(context, row, closed)
    if not all(edge.level(slab.height) for edge in edges):
        raise RowFault("nodes", "nodes off the slab's plane", f"nodes at the height of {slab.name}")
    for edge in edges:
        _note_remark(context, row, edge)
    return edges


def _note_remark(context: ReadContext, row: Row, edge: Edge) -> None:
    if edge.remark:
        context.note(row, edge.remark)


def read_thickness(context: ReadContext, row: Row) -> float:
    """Return the thickness of a member [m]; of one that varies the mean of its values, with a note."""
    kind = word(row, "thicknesstype", default="constant")
    if kind == "constant":
        thickness = context.number(row, "thickness", "size")
    else:
        values = [part.rpartition(":")[2] for part in texts(row, "thickness")]
        sizes = [context.number(Row(row.sheet, row.number, {"thickness": value}, row.units), "thickness", "size")
                 for value in values]  # fmt: skip
        if not sizes:
            raise RowFault("thickness", "nothing", "a thickness")
        thickness = sum(sizes) / len(sizes)
        context.note(row, f"a thickness that is {kind}, taken as its mean of {thickness:g} m")
    if thickness <= 0:
        raise RowFault("thickness", describe(text(row, "thickness")), "more than 0")
    return thickness


def read_material(context: ReadContext, row: Row) -> Material:
    """Return the material that a row names; what it does not say follows from codes, with a note."""
    name = text(row, "material").split(";")[0].strip()
    material = next((candidate for candidate in context.rows("StructuralMaterial") if candidate.name == name), None)
    if material is None:
        raise RowFault("material", f"the material {describe(name)}", "one of sheet StructuralMaterial")
    with context.reading(material):
        return _read_material(context, material)
    raise InputError(context.issues)


def _read_material(context: ReadContext, row: Row) -> Material:
    """Return the material of a row."""
    quality = text(row, "quality")
    E = context.number(row, "emodulus", "modulus", 0.0)
    if E <= 0:
        strength = re.match(r"C\s*(\d{1,3})\s*/\s*\d{2,3}", quality)
        if not strength:
            raise RowFault("emodulus", "no modulus of elasticity", "a value above 0 MPa, or a quality such as C30/37")
        # EN 1992-1-1 Table 3.1: E_cm = 22 (f_cm / 10)^0.3 GPa with f_cm = f_ck + 8 MPa
        E = 22e9 * ((float(strength[1]) + 8) / 10) ** 0.3
        context.note(row, f"no E modulus, taken as {E / 1e9:.4g} GPa, E_cm of {quality} by EN 1992-1-1 Table 3.1")
    nu, G = context.number(row, "poissoncoefficient", "number", -1.0), context.number(row, "gmodulus", "modulus", 0.0)
    if not 0 <= nu < 0.5:
        ratio = text(row, "poissoncoefficient")
        shear = E / (2 * G) - 1 if G > 0 and not ratio else -1.0
        nu = shear if 0 <= shear < 0.5 else NU
        context.note(row, f"Poisson's ratio {ratio or 'not given'}, taken as {nu:.4g}")
    elif G > 0 and abs(G * 2 * (1 + nu) / E - 1) > SHEAR:
        said = f"E {E / 1e9:.4g} GPa, G {G / 1e9:.4g} GPa and Poisson's ratio {nu:.4g}"
        context.note(row, f"{said}, where E / (2 (1 + nu)) is {E / (2 * (1 + nu)) / 1e9:.4g} GPa: G is not taken")
    mass = context.number(row, "unitmass", "mass", 0.0)
    if mass <= 0:
        context.note(row, f"no unit mass, taken as {UNIT_WEIGHT / 1e3:g} kN/m3")
    weight = float(f"{mass * GRAVITY:.12g}") if mass > 0 else UNIT_WEIGHT
    expansion = context.number(row, "thermalexpansion", "expansion", EXPANSION)
    if not 0 < expansion <= MOST_EXPANSION:
        context.note(row, f"a thermal expansion of {expansion:g} 1/K, taken as {EXPANSION:g} 1/K")
        expansion = EXPANSION
    return Material(E, nu, weight, quality, expansion)


def slab_axes(context: ReadContext, slab: Slab) -> tuple[Vector, Vector, Vector]:
    """Return the local axes of the slab in plan x, plan y and up: z is that of the file's vertical axis."""
    z = (0.0, 0.0, context.upwards)
    row = slab.row
    local = (context.number(row, "coordinatex", "number", 1.0), context.number(row, "coordinatey", "number", 0.0),
             context.number(row, "coordinatez", "number", 0.0))  # fmt: skip
    vector = tuple(dot(local, axis) for axis in context.axes)
    length = math.hypot(vector[0], vector[1])
    first = (vector[0] / length, vector[1] / length, 0.0) if length > 0 else (1.0, 0.0, 0.0)
    if word(row, "lcstype").startswith("y"):
        first = cross(first, z)
    angle = context.number(row, "lcsrotation", "angle", 0.0)
    second = cross(z, first)
    c, s = math.cos(angle), math.sin(angle)
    x = (c * first[0] + s * second[0], c * first[1] + s * second[1], 0.0)
    return x, cross(z, x), z
