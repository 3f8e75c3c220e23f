"""Hypothesis strategies for descriptions that are right, small enough to be solved in the blink of an eye."""

from __future__ import annotations

from typing import Any

from hypothesis import strategies as st

from groundslab.keys import Choice, Flag, Text
from groundslab.model import (
    Analysis,
    Beyond,
    Contact,
    Edges,
    InterfaceLayer,
    Layered,
    Mesh,
    Model,
    Pasternak,
    PatchLoad,
    Plate,
    PointLoad,
    Selvadurai,
    SoilLayer,
    UniformLoad,
    Vlasov,
    Void,
    Winkler,
)
from groundslab.schema import Part, key_of

MODULI_OF_SOIL = st.floats(5e6, 2e8)
STIFFNESSES = st.floats(5e6, 2e8)  # k0 [Pa/m]
SHEAR_STIFFNESSES = st.floats(1e5, 1e8)  # k1 [Pa m]
POISSON = st.just(0) | st.floats(0.0, 0.45)
GAMMAS = st.just("iterate") | st.floats(0.3, 5.0)


def any_of(part: type[Part], name: str) -> st.SearchStrategy[Any]:
    """Return all values of a key that is a choice, a flag or a text, from what the key says itself."""
    key = key_of(part.model_fields[name])
    if isinstance(key, Choice):
        return st.sampled_from(key.words)
    if isinstance(key, Flag):
        return st.booleans()
    assert isinstance(key, Text)
    return st.text(st.characters(exclude_categories=["Cs"]), max_size=12)


def edges() -> st.SearchStrategy[Edges]:
    """Return supports of any kind, mostly none."""
    any_edges = st.builds(Edges, **{side: any_of(Edges, side) for side in Edges.model_fields})
    return st.just(Edges()) | any_edges


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


def _vlasov() -> st.SearchStrategy[Vlasov]:
    formulas = any_of(Vlasov, "formulas")
    one = st.builds(
        Vlasov, layers=_lists(soil_layers(), 1), gamma=GAMMAS, mode=any_of(Vlasov, "mode"), formulas=formulas
    )
    several = st.builds(Vlasov, layers=_lists(soil_layers()), gamma=GAMMAS, mode=st.sampled_from(["auto", "profile"]))
    return one | several


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


@st.composite
def beyonds(draw: st.DrawFn, ground: Winkler | Pasternak | Vlasov | Layered) -> Beyond:
    """Return what may lie beyond the plate on the given ground."""
    kinds = ["none"]
    if not isinstance(ground, Winkler):
        kinds.append("margin")
        if not isinstance(ground, Pasternak) or ground.k1 > 0:
            kinds.append("infinite")
    kind = draw(st.sampled_from(kinds))
    sides = draw(st.lists(st.sampled_from(["left", "right", "bottom", "top"]), min_size=1, unique=True))
    if kind == "none":
        return Beyond()
    if kind == "infinite":
        return Beyond(kind=kind, sides=sides, width=draw(st.none() | st.floats(0.5, 10.0)))
    return Beyond(kind=kind, sides=sides, width=draw(st.floats(0.5, 10.0)), edge=draw(any_of(Beyond, "edge")))


@st.composite
def extents(draw: st.DrawFn, length: float) -> tuple[float, float]:
    """Return start and end of a stretch of a side of the plate."""
    start = draw(st.sampled_from([-0.5, -0.25]) | st.floats(-0.5, 0.4))
    end = draw(st.sampled_from([0.5, start + 0.1]) | st.floats(start + 0.05, 0.5))
    return start * length, min(end, 0.5) * length


def contacts(plate: Plate) -> st.SearchStrategy[Contact]:
    """Return contact with and without tension, gap and voids."""
    voids = st.builds(Void, depth=st.floats(1e-4, 1e-2), x=extents(plate.length_x), y=extents(plate.length_y))
    return (
        st.just(Contact())
        | st.just(Contact(tensionless=False))
        | st.builds(Contact, gap=st.just(0) | st.floats(0.0, 1e-2), voids=st.lists(voids, max_size=2))
    )


def loads(plate: Plate) -> st.SearchStrategy[list[UniformLoad | PatchLoad | PointLoad]]:
    """Return loads that all press downwards, so that there is always an equilibrium."""
    x, y = plate.length_x, plate.length_y
    name = st.just("") | any_of(PointLoad, "name")
    fraction = st.sampled_from([-0.5, 0.0, 0.5]) | st.floats(-0.5, 0.5)
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


def analyses() -> st.SearchStrategy[Analysis]:
    """Return ways to solve, the solver left to the program or the one that is installed everywhere."""
    return st.builds(
        Analysis,
        increments=st.integers(1, 3),
        solver=st.sampled_from(["auto", "superlu"]),
        nested=any_of(Analysis, "nested"),
        max_iterations=st.just(200) | st.integers(100, 300),
    )


@st.composite
def models(draw: st.DrawFn) -> Model:
    """Return whole descriptions."""
    plate, ground = draw(plates()), draw(grounds())
    return Model(
        title=draw(any_of(Model, "title")),
        plate=plate,
        ground=ground,
        beyond=draw(beyonds(ground)),
        contact=draw(contacts(plate)),
        loads=draw(loads(plate)),
        mesh=draw(meshes(plate)),
        analysis=draw(analyses()),
    )
