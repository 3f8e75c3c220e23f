"""Hypothesis strategies for descriptions that are right, small enough to be solved in the blink of an eye."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any

from hypothesis import strategies as st

from groundslab.geometry.plan import get_bounds
from groundslab.model.design.bars import MESHES, Bars, BarZone
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.ground import InterfaceLayer, Layered, Pasternak, Selvadurai, SoilLayer, Vlasov, Winkler
from groundslab.model.loads.core_loads import CoreLoad
from groundslab.model.loads.lines import LineLoad, LineMoment
from groundslab.model.loads.load_cases import Combination, Combine, LoadCase, has_ultimate_combination
from groundslab.model.loads.load_types import (
    AreaLoad,
    PatchLoad,
    PointLoad,
    SelfWeight,
    SettlementLoad,
    ShrinkageLoad,
    TemperatureLoad,
    UniformLoad,
)
from groundslab.model.model import Model
from groundslab.model.outputs import Output, OutputLine, OutputPoint, OutputStrip
from groundslab.model.plate import Edges, Plate
from groundslab.model.settings import Analysis, Beyond, Contact, Mesh
from groundslab.model.shapes import Circle, Polygon, Rectangle
from groundslab.model.structure.beams import Beam, GivenSection, RectangularSection, RibSection
from groundslab.model.structure.columns import Column
from groundslab.model.structure.cores import Core
from groundslab.model.structure.walls import Wall, WallOpening
from groundslab.model.supports import LineSupport, PointSupport
from groundslab.model.varying_ground import Borehole, GapPoint, SoilZone, Void
from groundslab.schema.base import Section
from groundslab.schema.fields import Boolean, Choice, ListOf, Text


@cache
def numbers(low: float, high: float) -> st.SearchStrategy[float]:
    """Return numbers between two limits that are zero or clear of it: others that are nearly zero are refused."""
    return st.floats(low, high).map(lambda value: value if abs(value) > 1e-12 else 0.0)


@cache
def maybe(low: float, high: float) -> st.SearchStrategy[float | None]:
    """Return numbers between two limits, or none."""
    return st.none() | st.floats(low, high)


@cache
def zero_or(low: float, high: float) -> st.SearchStrategy[float]:
    """Return zero, or numbers between two limits."""
    return st.just(0) | st.floats(low, high)


MODULI_OF_SOIL = st.floats(5e6, 2e8)
STIFFNESSES = st.floats(5e6, 2e8)  # k0 [Pa/m]
SHEAR_STIFFNESSES = st.floats(1e5, 1e8)  # k1 [Pa m]
POISSON = st.just(0) | numbers(0.0, 0.45)
GAMMAS = st.just("iterate") | st.floats(0.3, 5.0)


@cache
def any_of(part: type[Section], name: str) -> st.SearchStrategy[Any]:
    """Return all values of a key that is a choice, a flag or a text, from what the key says itself."""
    key = part.model_fields[name].type
    if isinstance(key, Choice):
        return st.sampled_from(key.words)
    if isinstance(key, Boolean):
        return st.booleans()
    assert isinstance(key, Text)
    return st.text(st.characters(exclude_categories=["Cs"]), max_size=12)


@cache
def edges() -> st.SearchStrategy[Edges]:
    """Return supports of any kind, mostly none."""
    any_edges = st.builds(Edges, **{side: any_of(Edges, side) for side in Edges.model_fields})
    return st.just(Edges()) | any_edges


@cache
def plates() -> st.SearchStrategy[Plate]:
    """Return plates of a few metres, thin and thick."""
    return st.builds(
        Plate,
        length_x=st.floats(2.0, 12.0),
        length_y=st.floats(2.0, 12.0),
        thickness=st.floats(0.1, 1.0),
        E=st.floats(1e10, 4e10),
        nu=POISSON,
        shear_factor=st.just(5 / 6) | st.floats(0.5, 1.0),
        element=any_of(Plate, "element"),
        edges=edges(),
    )


@cache
def soil_layers(sublayers: int = 1) -> st.SearchStrategy[SoilLayer]:
    """Return layers given by elastic constants, with up to so many sublayers."""
    common = {
        "E": MODULI_OF_SOIL,
        "nu": POISSON,
        "thickness": st.floats(0.5, 8.0),
        "sublayers": st.integers(1, sublayers),
    }
    varying = st.builds(SoilLayer, E_bottom=MODULI_OF_SOIL, variation=any_of(SoilLayer, "variation"), **common)
    return st.builds(SoilLayer, **common) | varying


def _lists(items: st.SearchStrategy[Any], most: int = 3) -> st.SearchStrategy[list[Any]]:
    return st.lists(items, min_size=1, max_size=most)


@cache
def _vlasov() -> st.SearchStrategy[Vlasov]:
    formulas = any_of(Vlasov, "formulas")
    one = st.builds(
        Vlasov, layers=_lists(soil_layers(), 1), gamma=GAMMAS, mode=any_of(Vlasov, "mode"), formulas=formulas
    )
    several = st.builds(Vlasov, layers=_lists(soil_layers()), gamma=GAMMAS, mode=st.sampled_from(["auto", "profile"]))
    return one | several


@cache
def _layered() -> st.SearchStrategy[Layered]:
    by_k = st.builds(InterfaceLayer, k0=STIFFNESSES, k1=SHEAR_STIFFNESSES)
    return (
        st.builds(Layered, coupling=st.just("interface"), layers=_lists(by_k))
        | st.builds(
            Layered,
            coupling=st.just("interface"),
            layers=_lists(soil_layers()),
            gamma=GAMMAS,
            formulas=any_of(Layered, "formulas"),
        )
        | st.builds(Layered, coupling=st.just("consistent"), layers=_lists(soil_layers(sublayers=3), 2))
    )


@cache
def grounds() -> st.SearchStrategy[Winkler | Pasternak | Vlasov | Layered]:
    """Return grounds of every kind."""
    selvadurai = st.builds(Selvadurai, E=MODULI_OF_SOIL, depth=st.floats(1.0, 20.0))
    return (
        st.builds(Winkler, k=STIFFNESSES)
        | st.builds(Winkler, selvadurai=selvadurai)
        | st.builds(Pasternak, k0=STIFFNESSES, k1=st.just(0) | SHEAR_STIFFNESSES)
        | _vlasov()
        | _layered()
    )


@cache
@st.composite
def beyonds(draw: st.DrawFn) -> Beyond:
    """Return what may lie beyond the plate."""
    kind = draw(any_of(Beyond, "kind"))
    sides = draw(st.lists(st.sampled_from(["left", "right", "bottom", "top"]), min_size=1, unique=True))
    if kind == "none":
        return Beyond()
    if kind == "infinite":
        return Beyond(kind=kind, sides=sides, width=draw(maybe(0.5, 10.0)))
    return Beyond(kind=kind, sides=sides, width=draw(st.floats(0.5, 10.0)), edge=draw(any_of(Beyond, "edge")))


@st.composite
def extents(draw: st.DrawFn, length: float) -> tuple[float, float]:
    """Return start and end of a stretch of a side of the plate."""
    start = draw(st.sampled_from([-0.5, -0.25]) | numbers(-0.5, 0.4))
    end = draw(st.sampled_from([0.5, start + 0.1]) | numbers(start + 0.05, 0.5))
    return start * length, min(end, 0.5) * length


@st.composite
def whole_extents(draw: st.DrawFn, length: float) -> tuple[float, float]:
    """Return start and end of a stretch of a side in whole sixteenths of it, so that no part between is tiny."""
    start = draw(st.integers(0, 14))
    return (start / 16 - 0.5) * length, (draw(st.integers(start + 2, 16)) / 16 - 0.5) * length


def contacts(plate: Plate) -> st.SearchStrategy[Contact]:
    """Return contact with and without tension, gap and voids."""
    voids = st.builds(Void, depth=st.floats(1e-4, 1e-2), x=extents(plate.length_x), y=extents(plate.length_y))
    return (
        st.just(Contact())
        | st.just(Contact(tensionless=False))
        | st.builds(Contact, gap=st.just(0) | numbers(0.0, 1e-2), voids=st.lists(voids, max_size=2))
    )


def loads(plate: Plate) -> st.SearchStrategy[list[UniformLoad | PatchLoad | PointLoad]]:
    """Return loads that all press downwards, so that there is always an equilibrium."""
    x, y = plate.length_x, plate.length_y
    name = st.just("") | any_of(PointLoad, "name")
    fraction = st.sampled_from([-0.5, 0.0, 0.5]) | numbers(-0.5, 0.5)
    uniform = st.builds(UniformLoad, name=name, q=st.floats(1e3, 1e5))
    patch = st.builds(PatchLoad, name=name, q=st.floats(1e3, 1e6), x=extents(x), y=extents(y))
    point = st.builds(
        PointLoad,
        name=name,
        P=st.floats(1e3, 1e6),
        x=fraction.map(lambda value: value * x),
        y=fraction.map(lambda value: value * y),
    )
    return st.builds(lambda first, more: [first, *more], uniform, st.lists(patch | point, max_size=3))


def meshes(plate: Plate) -> st.SearchStrategy[Mesh]:
    """Return meshes of at most eight elements along the longer side."""
    longer = max(plate.length_x, plate.length_y)
    symmetry = any_of(Mesh, "symmetry")
    counts = st.tuples(st.integers(1, 8), st.integers(1, 8))
    sizes = st.floats(longer / 8, longer)
    return st.builds(Mesh, counts=counts, symmetry=symmetry) | st.builds(Mesh, size=sizes, symmetry=symmetry)


@cache
def analyses() -> st.SearchStrategy[Analysis]:
    """Return ways to solve, the solver left to the program or the one that is installed everywhere."""
    return st.builds(
        Analysis,
        increments=st.integers(1, 3),
        solver=st.sampled_from(["auto", "superlu"]),
        nested=any_of(Analysis, "nested"),
        max_iterations=st.just(200) | st.integers(100, 300),
    )


@cache
@st.composite
def models(draw: st.DrawFn) -> Model:
    """Return whole descriptions."""
    plate, ground = draw(plates()), draw(grounds())
    return Model(
        title=draw(any_of(Model, "title")),
        plate=plate,
        ground=ground,
        beyond=draw(beyonds()),
        contact=draw(contacts(plate)),
        loads=draw(loads(plate)),
        mesh=draw(meshes(plate)),
        analysis=draw(analyses()),
    )


# --- everything else that a description may hold ---------------------------------------------------------------------

NAMES = st.text(st.characters(exclude_categories=["Cs"]), min_size=1, max_size=12)
SHARES = st.integers(-100, 100).map(lambda number: number / 200)
EIGHTHS = st.integers(-4, 4)  # of a side of the plate: places that a coarse mesh can meet


def _unique_names(draw: st.DrawFn, count: int, letter: str, free: bool) -> list[str]:
    """Return names of which none comes twice: of any letters, or plain ones where they are to be read."""
    if free:
        return draw(st.lists(NAMES, min_size=count, max_size=count, unique=True))
    return [f"{letter}{number}" for number in range(1, count + 1)]


@st.composite
def point_supports(draw: st.DrawFn, plate: Plate, name: str) -> PointSupport:
    """Return supports at points, of every kind, on the eighths of a plate's sides."""
    acts = draw(any_of(PointSupport, "acts"))
    keys: dict[str, Any] = {"x": draw(EIGHTHS) / 8 * plate.length_x, "y": draw(EIGHTHS) / 8 * plate.length_y}
    if acts != "both ways":
        keys |= {"gap": draw(zero_or(1e-5, 5e-3)), "limit": draw(maybe(1e3, 1e6))}
    turn: dict[str, Any] = draw(
        st.sampled_from([{}, {}, {"rotation": "fixed"}])
        | st.builds(lambda k: {"rotational_stiffness": k}, st.floats(1e5, 1e9))
    )
    return PointSupport(name=name, acts=acts, stiffness=draw(maybe(1e6, 1e9)), **keys, **turn)


@st.composite
def line_supports(draw: st.DrawFn, plate: Plate, name: str) -> LineSupport:
    """Return supports along x, along y and round a corner, of every kind."""
    x, y = sorted(draw(st.tuples(EIGHTHS, EIGHTHS))), sorted(draw(st.tuples(EIGHTHS, EIGHTHS)))
    x[1] += (x[0] == x[1]) * (1 if x[1] < 4 else 0)
    x[0] -= x[0] == x[1]
    y[1] += (y[0] == y[1]) * (1 if y[1] < 4 else 0)
    y[0] -= y[0] == y[1]
    along = draw(st.sampled_from([[(x[0], y[0]), (x[1], y[0])], [(x[0], y[0]), (x[0], y[1])],
                                  [(x[0], y[0]), (x[1], y[0]), (x[1], y[1])]]))  # fmt: skip
    points = [(a / 8 * plate.length_x, b / 8 * plate.length_y) for a, b in along]
    acts, stiffness = draw(any_of(LineSupport, "acts")), draw(maybe(1e6, 1e9))
    keys: dict[str, Any] = {}
    if acts != "both ways":
        keys = {"gap": draw(zero_or(1e-5, 5e-3)), "limit": draw(maybe(1e3, 1e6))}
    elif stiffness is None:
        keys = {"rotation": draw(any_of(LineSupport, "rotation"))}
    return LineSupport(name=name, points=points, stiffness=stiffness, acts=acts, **keys)


@st.composite
def shapes(draw: st.DrawFn, plate: Plate, along: Callable[..., Any] = extents) -> Rectangle | Circle | Polygon:
    """Return shapes that lie on a plate, over stretches along its sides."""
    x, y = draw(along(plate.length_x)), draw(along(plate.length_y))
    kind = draw(st.sampled_from(["rectangle", "circle", "polygon"]))
    if kind == "rectangle":
        return Rectangle(x=x, y=y)
    if kind == "circle":
        radius = min(x[1] - x[0], y[1] - y[0]) / 2
        return Circle(centre=(sum(x) / 2, sum(y) / 2), radius=radius)
    if draw(st.booleans()):
        middle, radius = (sum(x) / 2, sum(y) / 2), min(x[1] - x[0], y[1] - y[0]) / 2
        ends = [(middle[0] - radius, middle[1]), (middle[0] + radius, middle[1])]
        return Polygon(points=ends, bulges=(1.0,))
    return Polygon(points=[(x[0], y[0]), (x[1], y[0]), (x[0], y[1])])


@st.composite
def columns(draw: st.DrawFn, plate: Plate, names: list[str]) -> list[Column]:
    """Return columns that stand on the plate, round and rectangular."""
    made = []
    for name in names:
        x, y = draw(numbers(-0.4, 0.4)) * plate.length_x, draw(numbers(-0.4, 0.4)) * plate.length_y
        size = st.floats(0.02, 0.19).map(lambda share: share * min(plate.sides))
        keys = draw(st.builds(lambda d: {"diameter": d}, size)
                    | st.builds(lambda a, b: {"width_x": a, "width_y": b}, size, size))  # fmt: skip
        made.append(Column(name=name, x=x, y=y, **keys))
    return made


@st.composite
def walls(draw: st.DrawFn, plate: Plate, names: list[str]) -> list[Wall]:
    """Return walls that stand on the plate: straight ones, with corners and arcs, around shapes, along edges."""
    made = []
    for name in names:
        thickness = draw(st.floats(0.005, 0.1)) * min(plate.sides)
        kind = draw(st.sampled_from(["points", "shape", "edge"]))
        if kind == "shape":
            made.append(Wall(name=name, thickness=thickness, shape=draw(shapes(plate, whole_extents))))
        elif kind == "edge":
            edge = draw(st.sampled_from(["all", "left", "right", "bottom", "top"]) | st.integers(1, 4))
            made.append(Wall(name=name, thickness=thickness, edge=edge))
        else:
            places = draw(st.lists(st.tuples(EIGHTHS, EIGHTHS), min_size=2, max_size=4, unique=True))
            closing = places[:1] if len(places) > 2 and draw(st.booleans()) else []
            points = [(x / 8 * plate.length_x, y / 8 * plate.length_y) for x, y in [*places, *closing]]
            bulges = draw(st.just([]) | st.lists(numbers(-1.0, 1.0), min_size=1, max_size=len(points) - 1))
            doors = []
            if len(points) == 2 and not bulges and draw(st.booleans()):
                length = math.dist(*points)
                doors = [WallOpening(start=0.3 * length, end=0.5 * length, height=draw(st.floats(0.1, 1.0)) * length)]
            wall = Wall(name=name, thickness=thickness, points=points, bulges=bulges, openings=doors)
            x0, x1, y0, y1 = get_bounds(wall.edges)
            inside = max(-x0, x1) <= plate.length_x / 2 and max(-y0, y1) <= plate.length_y / 2
            made.append(wall if inside else Wall(name=name, thickness=thickness, points=points))
    return made


@st.composite
def beams(draw: st.DrawFn, plate: Plate, names: list[str]) -> list[Beam]:
    """Return beams along x and y that lie on the plate and not on each other, along its edges too."""
    lines = draw(st.lists(st.tuples(st.booleans(), EIGHTHS), min_size=len(names), max_size=len(names), unique=True))
    made = []
    for name, (level, at) in zip(names, lines, strict=True):
        ends = draw(st.lists(EIGHTHS, min_size=2, max_size=2, unique=True))
        places = [(end, at) if level else (at, end) for end in ends]
        points = [(x / 8 * plate.length_x, y / 8 * plate.length_y) for x, y in places]
        width, height = (draw(st.floats(0.2, 1.0)) * plate.thickness * n for n in (2, 4))
        section = draw(
            st.sampled_from(
                [
                    RectangularSection(width=width, height=height),
                    RibSection(width=width, height=height, effective_width=4 * width),
                    RibSection(
                        width=width, height=height, eccentric=True, side=draw(st.sampled_from(["below", "above"]))
                    ),
                    GivenSection(second_moment=width * height**3, shear_area=width * height),
                    GivenSection(
                        second_moment=width * height**3,
                        shear_area=width * height,
                        area=width * height,
                        eccentricity=draw(st.sampled_from([-1.0, -0.5, 0.0, 0.5, 1.0])) * height,
                    ),
                ]
            )
        )
        made.append(Beam(name=name, points=points, section=section, E=draw(maybe(10e9, 210e9))))
    return made


@st.composite
def any_load(
    draw: st.DrawFn, plate: Plate, case: str, columns: list[Column], supports: list[Any], walls: list[Wall]
) -> Any:
    """Return a load of any kind, of either sign."""
    kinds = [
        "uniform",
        "patch",
        "area",
        "line",
        "line moment",
        "point",
        "footprint",
        "self weight",
        "temperature",
        "shrinkage",
    ]
    kinds += ["column"] * bool(columns) + ["settlement"] * bool(supports) + ["wall", "wall moment"] * bool(walls)
    kind = draw(st.sampled_from(kinds))
    size = min(plate.sides)
    keys: dict[str, Any] = {"case": case, "name": draw(st.just("") | any_of(PointLoad, "name"))}
    q = draw(st.floats(1e3, 2e5) | st.floats(-1e4, -1e2))
    inside_x, inside_y = (0.8 * draw(SHARES) * side for side in plate.sides)
    varying: dict[str, Any] = draw(st.just({}) | st.builds(
        lambda a, b, c: {"slope": (a * q / size, b * q / size), "about": (c, 0.0),
                         "bend": (c * q / size**2, 0.0, a * q / size**2)},
        SHARES, SHARES, SHARES))  # fmt: skip
    if kind == "uniform":
        return UniformLoad(q=q, **varying, **keys)
    if kind == "patch":
        return PatchLoad(q=q, x=draw(extents(plate.length_x)), y=draw(extents(plate.length_y)), **varying, **keys)
    if kind == "area":
        shape = draw(shapes(plate))
        holes = [Circle(centre=shape.centre, radius=shape.radius / 2)] if isinstance(shape, Circle) else []
        return AreaLoad(q=q, shape=shape, holes=draw(st.sampled_from([[], holes])), **varying, **keys)
    if kind in {"line", "line moment"}:
        far = tuple(draw(SHARES) * side for side in plate.sides)
        start = inside_x, inside_y
        if start == far:
            far = plate.length_x / 2, plate.length_y / 2
        bulges = draw(st.just(()) | st.tuples(numbers(-1.5, 1.5)))
        q_end = draw(st.none() | st.sampled_from([0.0, 2e4, -5e3]))
        if kind == "line moment":
            return LineMoment(m=q * size / 4, m_end=q_end, points=[start, far], bulges=bulges, **keys)
        return LineLoad(q=q, q_end=q_end, points=[start, far], bulges=bulges, **keys)
    if kind in {"wall", "wall moment"}:
        return draw(
            load_on_wall(draw(st.sampled_from(walls)), q, q * size / 4 if kind == "wall moment" else None, **keys)
        )
    moments = {"M_x": draw(st.just(0) | SHARES) * q * size / 2,
               "M_y": draw(st.just(0) | SHARES) * q * size / 2}  # fmt: skip
    if kind == "column":
        return PointLoad(P=q, column=draw(st.sampled_from(columns)).name, **moments, **keys)
    if kind == "point":
        return PointLoad(P=q, x=inside_x, y=inside_y, **moments, **keys)
    if kind == "footprint":
        width = draw(st.floats(0.02, 0.19)) * size
        foot = draw(st.sampled_from([{"diameter": width}, {"width_x": width, "width_y": width / 2}]))
        return PointLoad(P=q, x=inside_x, y=inside_y, **foot, **moments, **keys)
    if kind == "temperature":
        return TemperatureLoad(difference=60 * draw(SHARES), **keys)
    if kind == "shrinkage":
        return ShrinkageLoad(top=draw(SHARES) / 1000, bottom=draw(SHARES) / 1000, **keys)
    if kind == "settlement":
        return SettlementLoad(support=draw(st.sampled_from(supports)).name, w=draw(SHARES) / 100, **keys)
    return SelfWeight(unit_weight=25e3, **keys)


@st.composite
def load_on_wall(draw: st.DrawFn, wall: Wall, q: float, m: float | None, **keys: Any) -> LineLoad | LineMoment:
    """Return a force per length on a wall, or a moment if there is one; linear along it where it has ends."""
    closed = wall.shape is not None or wall.edge == "all"
    end = None if closed else draw(st.none() | st.sampled_from([0.0, 2e4, -5e3]))
    if m is not None:
        return LineMoment(m=m, m_end=end, wall=wall.name, **keys)
    return LineLoad(q=q, q_end=end, wall=wall.name, **keys)


@st.composite
def rich_contacts(draw: st.DrawFn, plate: Plate, whole: bool) -> Contact:
    """Return contact with voids of any shape, cavities, a limit of the pressure and, if whole, measured gaps.

    The mesh follows voids: they are as large as elements may be.
    """
    if draw(st.integers(0, 5)) == 0:
        return Contact(tensionless=False)
    depth = maybe(1e-4, 1e-2)
    x, y = whole_extents(plate.length_x), whole_extents(plate.length_y)
    void = st.builds(Void, depth=depth, x=x, y=y) | st.builds(Void, depth=depth, shape=shapes(plate, whole_extents))
    gap_point = st.builds(GapPoint, x=numbers(-5, 5), y=numbers(-5, 5), gap=numbers(-1e-3, 1e-2))
    return Contact(
        gap=draw(st.just(0) | numbers(0.0, 1e-2)),
        voids=draw(st.lists(void, max_size=2)),
        gaps=draw(st.lists(gap_point, max_size=3, unique_by=lambda point: (point.x, point.y))) if whole else (),
        limit_pressure=draw(maybe(2e4, 2e6)),
    )


@st.composite
def combinations(draw: st.DrawFn, cases: list[LoadCase], free: bool) -> list[Combination]:
    """Return combinations of cases, also such that take away from each other."""
    made = []
    for name in _unique_names(draw, draw(st.integers(0, 3)), "K", free):
        factors = {case.name: draw(st.sampled_from([1.0, 1.35, 1.5, 0.0, -0.5, 0.123]))
                   for case in cases if draw(st.booleans())}  # fmt: skip
        if not any(factors.values()):
            factors = {cases[0].name: 1.0}
        made.append(Combination(name=name, limit_state=draw(any_of(Combination, "limit_state")), factors=factors))
    return made


@cache
@st.composite
def load_cases(draw: st.DrawFn) -> list[LoadCase]:
    """Return up to three cases, the first one permanent."""
    made = []
    for name in _unique_names(draw, draw(st.integers(0, 3)), "case ", False):
        shares = sorted((draw(st.floats(0.1, 1)), draw(st.floats(0.1, 1))))
        action = draw(any_of(LoadCase, "action")) if made else "permanent"
        variable = action == "variable"
        keys = {"psi_0": draw(numbers(0, 1)), "psi_1": shares[1], "psi_2": shares[0]} if variable else {}
        group = draw(st.sampled_from(["", "wind"])) if variable else ""
        made.append(LoadCase(name=name, action=action, group=group, **keys))
    return made


def combines(cases: list[LoadCase]) -> st.SearchStrategy[Combine]:
    """Return automatic combinations of some limit states, of those that need an action of their own if it is there."""
    missing = {"accidental", "seismic"} - {case.action for case in cases}
    states = any_of_each(Combine, "sets").filter(lambda state: state not in missing)
    sets = st.lists(states, min_size=1, max_size=2, unique=True)
    return st.builds(Combine, sets=sets, permanent=st.sampled_from([(1.35, 1.0), (1.1, 0.9)]))


@cache
def any_of_each(part: type[Section], name: str) -> st.SearchStrategy[Any]:
    """Return all words of which a key holds a list."""
    key = part.model_fields[name].type
    assert isinstance(key, ListOf)
    assert isinstance(key.each, Choice)
    return st.sampled_from(key.each.words)


@st.composite
def outputs(draw: st.DrawFn, plate: Plate) -> Output:
    """Return points, lines and strips on the plate."""
    share = numbers(-0.5, 0.5)

    def place() -> tuple[float, float]:
        return draw(share) * plate.length_x, draw(share) * plate.length_y

    points = [OutputPoint(name=name, x=x, y=y) for name in _unique_names(draw, draw(st.integers(0, 2)), "", True)
              for x, y in [place()]]  # fmt: skip
    across = ((-plate.length_x / 2, 0.0), (plate.length_x, plate.length_y / 4))
    lines = [OutputLine(name=name, start=across[0], end=across[1]) for name in draw(st.lists(NAMES, max_size=1))]
    strips = [OutputStrip(name=name, start=across[0], end=across[1], width=draw(st.floats(0.1, 2.0)),
                          stations=draw(st.integers(2, 30))) for name in draw(st.lists(NAMES, max_size=1))]  # fmt: skip
    return Output(points=points, lines=lines, strips=strips)


@st.composite
def reinforcements(draw: st.DrawFn, plate: Plate) -> Reinforcement:
    """Return concrete, steel and bars that fit into the plate, by any code and annex, with zones where it is thick."""
    cover = st.floats(0.05, 0.45).map(lambda share: share * plate.thickness)
    axes = {"bottom": st.tuples(cover, cover), "top": st.tuples(cover, cover), "f_yk": st.floats(4e8, 6e8)}
    laid: dict[str, Any] = {}
    if 0.05 * plate.thickness > 6e-3 and draw(st.booleans()):
        bars = st.builds(Bars, diameter=st.floats(4e-3, 12e-3), spacing=st.floats(0.05, 0.5))
        laid = {name: draw(bars) for name in ("bottom_x", "bottom_y")} | {"top_mesh": draw(st.sampled_from([*MESHES]))}
        shape = Rectangle(x=(-plate.length_x / 2, 0.0), y=(0.0, plate.length_y))
        laid["zones"] = [BarZone(name=name, shape=shape, layers=("top_x",), diameter=8e-3, spacing=0.2)
                         for name in _unique_names(draw, draw(st.integers(0, 2)), "", True)]  # fmt: skip
    given = axes | {name: st.just(value) for name, value in laid.items()}
    by_en = st.builds(
        Reinforcement, f_ck=st.floats(12e6, 90e6), gamma_c=maybe(1.0, 2.0),
        gamma_s=maybe(1.0, 2.0), alpha_cc=maybe(0.5, 1.0),
        annex=any_of(Reinforcement, "annex"), **given,
    )  # fmt: skip
    size = st.booleans()
    by_aci = st.builds(Reinforcement, code=st.just("ACI 318"), f_ck=st.floats(17e6, 90e6), size_effect=size, **given)
    by_second = st.builds(
        Reinforcement, code=st.just("EN 1992-1-1:2023"), f_ck=st.floats(12e6, 90e6),
        gamma_v=maybe(1.0, 2.0), k_tc=maybe(0.5, 1.0),
        d_lower=maybe(0.008, 0.063), **given,
    )  # fmt: skip
    return draw(by_en | by_aci | by_second)


@st.composite
def varied_ground(draw: st.DrawFn, ground: Any, plate: Plate) -> dict[str, Any]:
    """Return zones of soil, or boreholes, that go with a ground; none for many."""
    if draw(st.booleans()):
        return {}
    soil = isinstance(ground, Vlasov | Layered) and all(isinstance(layer, SoilLayer) for layer in ground.layers)
    if soil and draw(st.booleans()) and not (isinstance(ground, Vlasov) and ground.formulas == "as printed"):
        places = st.tuples(numbers(-20, 20), numbers(-20, 20))
        holes = []
        for x, y in draw(st.lists(places, min_size=1, max_size=3, unique=True)):
            layers = [layer.replace(E=draw(MODULI_OF_SOIL), thickness=draw(st.floats(0.1, 9.0)), nu=draw(POISSON))
                      for layer in ground.layers]  # fmt: skip
            holes.append(Borehole(name=draw(st.just("") | NAMES), x=x, y=y, layers=layers))
        return {"boreholes": holes}
    return {"soil_zones": [SoilZone(shape=draw(shapes(plate)), ground=ground)]}


@st.composite
def rich_models(draw: st.DrawFn, whole: bool = False) -> Model:
    """Return descriptions with supports, columns, walls, cases and all kinds of loads; if whole, with every key."""
    plate, ground = draw(plates()), draw(grounds())
    if not whole and getattr(ground, "formulas", "exact") == "as printed":
        ground = ground.replace(formulas="exact")  # gamma need not converge with the misprints
    plate = plate.replace(thermal_expansion=draw(st.sampled_from([1e-5, 1.2e-5])))
    supports: list[Any] = [draw(point_supports(plate, name) | line_supports(plate, name))
                           for name in _unique_names(draw, draw(st.integers(0, 3)), "S", whole)]  # fmt: skip
    # supports may come so near to a beam that nothing between can be meshed
    ribs = [] if supports else draw(beams(plate, _unique_names(draw, draw(st.integers(0, 2)), "B", whole)))
    stand = draw(columns(plate, _unique_names(draw, draw(st.integers(0, 2)), "C", whole)))
    around = draw(walls(plate, _unique_names(draw, draw(st.integers(0, 2)), "W", whole)))
    cases = draw(load_cases())
    loads = [draw(any_load(plate, case, stand, supports, around))
             for case in [each.name for each in cases] or [""] for _ in range(draw(st.integers(1, 2)))]  # fmt: skip
    for wall in around:
        q, m = draw(st.floats(1e3, 2e5)), draw(st.none() | st.floats(-2e4, 2e4).filter(lambda m: abs(m) > 1))
        loads.append(draw(load_on_wall(wall, q, m, case=draw(st.sampled_from(cases)).name if cases else "")))
    # walls may lie on each other, of which cores share none
    straight = [wall for wall in around if wall.points and not wall.bulges][:1]
    cores = [Core(name=f"core {wall.name}", walls=[wall.name]) for wall in straight]
    for core in cores:
        case = draw(st.sampled_from(cases)).name if cases else ""
        loads.append(CoreLoad(core=core.name, P=draw(st.floats(1e3, 1e6)), case=case))
    # a weight, so that most of them can be balanced
    loads.insert(0, UniformLoad(q=draw(st.floats(1e3, 1e5)), case=cases[0].name if cases else ""))
    extra: dict[str, Any] = {}
    if whole:
        extra = {"output": draw(outputs(plate))} | draw(varied_ground(ground, plate))
    if cases:
        extra |= {"combinations": draw(combinations(cases, whole)), "combine": draw(st.none() | combines(cases))}
    if whole and has_ultimate_combination(tuple(extra.get("combinations", ())), extra.get("combine")):
        extra["reinforcement"] = draw(st.none() | reinforcements(plate))
    longer = max(plate.sides)
    mesh = Mesh(size=draw(st.floats(longer / 6, longer / 2))) if supports or ribs else draw(meshes(plate))
    return Model(
        plate=plate,
        ground=ground,
        beyond=draw(beyonds()),
        contact=draw(rich_contacts(plate, whole)),
        supports=supports,
        columns=stand,
        walls=around,
        cores=cores,
        beams=ribs,
        cases=cases,
        loads=loads,
        mesh=mesh,
        analysis=draw(analyses()) if whole else draw(analyses()).replace(max_iterations=400, solver="auto"),
        **extra,
    )
