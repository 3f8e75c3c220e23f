"""From a description to arrays: loads, supports, symmetry, edges of the ground, and constants that vary in plan."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.sparse import csr_array

from groundslab.analysis.driver import solve
from groundslab.discretize import ground as rooms
from groundslab.discretize.discretize import discretize
from groundslab.discretize.symmetry import symmetries
from groundslab.errors import InputError
from groundslab.fem.foundation import Column, interface_stack, single
from groundslab.fem.load_vectors import nodal_area
from groundslab.fem.mesh import Mesh as NodeMesh
from groundslab.fem.problem import BETA_X, BETA_Y, TOP, Problem, W
from groundslab.fem.system import build_system, stiffness
from groundslab.fem.vlasov import Soil
from groundslab.model.ground import InterfaceLayer, Layered, Pasternak, Selvadurai, SoilLayer, Vlasov, Winkler
from groundslab.model.loads.load_types import PatchLoad, PointLoad, UniformLoad
from groundslab.model.model import Model
from groundslab.model.plate import Edges, Plate
from groundslab.model.settings import Beyond, Contact, Mesh
from groundslab.model.varying_ground import GapPoint, Void
from helpers.examples import examples
from helpers.plans import needs_gmsh

LX, LY = 6.0, 4.0
ELEMENTS = ["mitc9", "q9", "heterosis"]


def model(loads: list[Any] | None = None, **keys: Any) -> Model:
    """Return a plate of 6 x 4 m; keys go to the part that has them."""
    return Model(
        plate=Plate(
            length_x=LX, length_y=LY, thickness=0.2, E=30e9, nu=0.2,
            element=keys.pop("element", "q9"), edges=keys.pop("edges", Edges()),
        ),
        ground=keys.pop("ground", Pasternak(k0=30e6, k1=20e6)),
        beyond=keys.pop("beyond", Beyond()),
        loads=loads or [UniformLoad(q=1e3)],
        mesh=Mesh(counts=keys.pop("counts", (5, 3)), symmetry=keys.pop("symmetry", "off")),
        contact=Contact(**keys),
    )  # fmt: skip


def line_integrals(lines: np.ndarray, start: float, end: float) -> np.ndarray:
    """Return int of each nodal quadratic (2 i + 1,) over start .. end by antiderivatives of polynomials."""
    out = np.zeros(2 * len(lines) - 1)
    for i, (a, b) in enumerate(pairwise(lines)):
        low, high = max(a, start), min(b, end)
        if high <= low:
            continue
        middle = (a + b) / 2
        nodes = [a, middle, b]
        for k in range(3):
            others = [n for j, n in enumerate(nodes) if j != k]
            polynomial = np.poly1d(others, r=True) / np.prod([nodes[k] - o for o in others])
            whole = polynomial.integ()
            out[2 * i + k] += whole(high) - whole(low)
    return out


def lines(mesh: NodeMesh, axis: int) -> np.ndarray:
    """Return the lines between a grid's elements, from its corner nodes."""
    return np.unique(mesh.nodes[mesh.elements[:, :4], axis])


PATCHES = {
    "across borders": ((-1.7, 2.3), (-0.5, 1.9)),
    "smaller than an element": ((0.1, 0.4), (0.2, 0.25)),
    "one element": ((-0.6, 0.6), (-2 / 3, 2 / 3)),
    "on a border": ((-0.8, -0.4), (0.5, 0.9)),
    "at a corner": ((2.0, 3.0), (1.5, 2.0)),
    "all": ((-3.0, 3.0), (-2.0, 2.0)),
    "a line almost": ((1.0, 1.0 + 1e-6), (-2.0, 2.0)),
}


@pytest.mark.parametrize(("x", "y"), PATCHES.values(), ids=PATCHES.keys())
def test_patch_loads_are_integrated_exactly(x: tuple[float, float], y: tuple[float, float]) -> None:
    """Nodal forces are q int N over the patch, wherever it cuts elements: products of exact line integrals."""
    problem = discretize(model([PatchLoad(q=7.0, x=x, y=y)]))
    wanted = (
        7.0 * np.outer(line_integrals(lines(problem.mesh, 1), *y), line_integrals(lines(problem.mesh, 0), *x)).ravel()
    )
    np.testing.assert_allclose(problem.load[:, W], wanted, atol=1e-13)
    assert not problem.load[:, 1:].any()


def resultant(problem: Problem) -> np.ndarray:
    """Return sum F, sum F x, sum F y of the nodal loads."""
    F = problem.load[:, W]
    return np.array([F.sum(), F @ problem.mesh.nodes[:, 0], F @ problem.mesh.nodes[:, 1]])


@pytest.mark.parametrize("element", ELEMENTS)
@pytest.mark.parametrize(
    "beyond", [Beyond(), Beyond(kind="margin", width=2.0), Beyond(kind="infinite", sides=("right",))]
)
def test_force_and_moments_of_all_loads(element: str, beyond: Beyond) -> None:
    """The nodal loads have the force and both moments of the loads described, with ground beyond and without."""
    loads = [
        UniformLoad(q=1e3),
        PatchLoad(q=5e3, x=(-1.7, 2.3), y=(-0.5, 1.9)),
        PointLoad(P=2e3, x=1.23, y=-1.11),
        PointLoad(P=-3e2, x=3.0, y=2.0),
    ]
    patch = 5e3 * 4.0 * 2.4
    wanted = [
        24e3 + patch + 2e3 - 3e2,
        patch * 0.3 + 2e3 * 1.23 - 3e2 * 3.0,
        patch * 0.7 - 2e3 * 1.11 - 3e2 * 2.0,
    ]
    problem = discretize(model(loads, element=element, beyond=beyond))
    np.testing.assert_allclose(resultant(problem), wanted, rtol=1e-12)


@pytest.mark.parametrize("element", ELEMENTS)
def test_nothing_is_loaded_that_has_no_unknown(element: str) -> None:
    """Every loaded w exists: where the centre hangs on its element's other nodes its share has gone to them."""
    problem = discretize(model([UniformLoad(q=1.0), PointLoad(P=5.0, x=0.1, y=0.2)], element=element))
    loaded = problem.load[:, W] != 0
    assert (problem.unknown[loaded, W] >= 0).all()
    assert (problem.unknown[problem.mesh.elements[:, 8], W] >= 0).all() == (element == "q9")


@pytest.mark.parametrize(("x", "y"), [(3.0, 2.0), (-3.0, -2.0), (3.0, 0.3), (-0.6, 2.0), (0.6, 2 / 3), (0.0, 0.0)])
def test_point_loads_at_edges_corners_and_nodes(x: float, y: float) -> None:
    """At edges, corners and lines between elements a point load is counted once and stays in its place."""
    problem = discretize(model([PointLoad(P=11.0, x=x, y=y)]))
    np.testing.assert_allclose(resultant(problem), [11.0, 11.0 * x, 11.0 * y], atol=1e-12)


def test_point_load_at_a_node_loads_that_node_alone() -> None:
    """N is one at its own node: no force elsewhere."""
    problem = discretize(model([PointLoad(P=11.0, x=3.0, y=2.0)]))
    corner = (problem.mesh.nodes == [3.0, 2.0]).all(axis=1)
    np.testing.assert_allclose(problem.load[:, W], np.where(corner, 11.0, 0.0), atol=1e-13)


@pytest.mark.parametrize(
    ("loads", "share"),
    [
        ([PointLoad(P=8.0, x=0, y=0)], 2.0),
        ([PointLoad(P=8.0, x=1, y=0), PointLoad(P=8.0, x=-1, y=0)], 4.0),
        ([PointLoad(P=8.0, x=0, y=1.5), PointLoad(P=8.0, x=0, y=-1.5)], 4.0),
        ([PointLoad(P=8.0, x=sx, y=sy) for sx in (1, -1) for sy in (1, -1)], 8.0),
        ([PatchLoad(q=2.0, x=(-1, 1), y=(-0.5, 0.5))], 1.0),
        ([PatchLoad(q=2.0, x=(1, 2), y=(-0.5, 0.5)), PatchLoad(q=2.0, x=(-2, -1), y=(-0.5, 0.5))], 1.0),
        ([UniformLoad(q=1.0)], 6.0),
    ],
)
def test_a_quarter_carries_its_share(loads: list[Any], share: float) -> None:
    """On lines of symmetry a point load is halved, or quartered at the centre; a patch is cut."""
    problem = discretize(model(loads, counts=(6, 4), symmetry="auto"))
    assert problem.symmetry == (True, True)
    assert problem.load[:, W].sum() == pytest.approx(share)
    assert (problem.mesh.nodes >= 0).all()


def test_half_of_the_plate() -> None:
    """Symmetric about one axis alone: half the mesh, half the load, the other axis whole."""
    loads = [PointLoad(P=8.0, x=0, y=1.0), PatchLoad(q=1.0, x=(-1, 1), y=(0, 2))]
    problem = discretize(model(loads, counts=(6, 4), symmetry="auto"))
    assert problem.symmetry == (True, False)
    assert problem.load[:, W].sum() == pytest.approx(4.0 + 2.0)
    assert problem.mesh.nodes.min(axis=0) == pytest.approx([0.0, -2.0])


def test_loads_that_are_all_zero_are_an_error() -> None:
    """Nothing to compute is said at once."""
    with pytest.raises(InputError, match="all zero"):
        discretize(model([UniformLoad(q=0.0)]))


BOTH = (True, True)
ASYMMETRIES: dict[str, tuple[dict[str, Any], tuple[bool, bool]]] = {
    "nothing": ({}, BOTH),
    "left support": ({"edges": Edges(left="hinged")}, (False, True)),
    "left and right differ": ({"edges": Edges(left="hinged", right="soft")}, (False, True)),
    "left and right alike": ({"edges": Edges(left="clamped", right="clamped", top="soft")}, (True, False)),
    "ground beyond on one side": ({"beyond": Beyond(kind="margin", width=1.0, sides=("top",))}, (True, False)),
    "ground beyond on two": ({"beyond": Beyond(kind="margin", width=1.0, sides=("top", "bottom"))}, BOTH),
    "ground beyond around a corner": ({"beyond": Beyond(kind="infinite", sides=("left", "top"))}, (False, False)),
    "odd count along x": ({"counts": (5, 4)}, (False, True)),
    "odd count along y": ({"counts": (4, 5)}, (True, False)),
    "patch aside in x": ({"loads": [PatchLoad(q=1.0, x=(-1, 2), y=(-1, 1))]}, (False, True)),
    "patch aside in y": ({"loads": [PatchLoad(q=1.0, x=(-1, 1), y=(-1, 1.001))]}, (True, False)),
    "pair of patches": (
        {"loads": [PatchLoad(q=1.0, x=(1, 2), y=(0, 1)), PatchLoad(q=1.0, x=(-2, -1), y=(0, 1))]},
        (True, False),
    ),
    "pair of patches of different size of load": (
        {"loads": [PatchLoad(q=1.0, x=(1, 2), y=(-1, 1)), PatchLoad(q=1.1, x=(-2, -1), y=(-1, 1))]},
        (False, True),
    ),
    "point aside": ({"loads": [PointLoad(P=1.0, x=0.5, y=0.0)]}, (False, True)),
    "points crosswise": (
        {"loads": [PointLoad(P=1.0, x=1.0, y=1.0), PointLoad(P=1.0, x=-1.0, y=-1.0)]},
        (False, False),
    ),
    "three of four points": (
        {"loads": [PointLoad(P=1.0, x=a, y=b) for a, b in ((1, 1), (-1, 1), (1, -1))]},
        (False, False),
    ),
    "one point doubled": (
        {"loads": [PointLoad(P=1.0, x=a, y=0.0) for a in (1, 1, -1)]},
        (False, True),
    ),
    "void aside": ({"voids": [Void(depth=0.01, x=(0, 1), y=(-1, 1))]}, (False, True)),
    "voids of different depth": (
        {"voids": [Void(depth=0.01, x=(1, 2), y=(-1, 1)), Void(depth=0.02, x=(-2, -1), y=(-1, 1))]},
        (False, True),
    ),
    "void in the middle": ({"voids": [Void(depth=0.01, x=(-1, 1), y=(-1, 1))]}, BOTH),
}


@pytest.mark.parametrize(("keys", "wanted"), ASYMMETRIES.values(), ids=ASYMMETRIES.keys())
def test_symmetry_is_found_exactly_where_it_is(keys: dict[str, Any], wanted: tuple[bool, bool]) -> None:
    """Every part of the description can break each of the two symmetries, and none is broken without need."""
    keys = {"counts": (4, 4), **keys}
    assert symmetries(model(keys.pop("loads", None), symmetry="auto", **keys)) == wanted


def test_symmetry_can_be_switched_off() -> None:
    """With symmetry off the whole plate is meshed although it is symmetric."""
    assert symmetries(model(counts=(4, 4), symmetry="off")) == (False, False)


def test_a_size_is_never_exceeded() -> None:
    """Elements are no longer than asked, whether whole or half sides are divided."""
    for symmetry in ("auto", "off"):
        described = model(symmetry=symmetry).model_copy(update={"mesh": Mesh(size=0.7, symmetry=symmetry)})
        mesh = discretize(described).mesh
        for axis in (0, 1):
            assert np.diff(lines(mesh, axis)).max() <= 0.7 * (1 + 1e-12)
            assert np.diff(lines(mesh, axis)).max() > 0.55


def test_coarser_meshes_halve_the_counts() -> None:
    """Each level of the nested iteration has half the elements, rounded up, on the same plate."""
    described = model(counts=(13, 8))
    for level, counts in enumerate([(13, 8), (7, 4), (4, 2), (2, 1)]):
        mesh = discretize(described, level).mesh
        assert (len(lines(mesh, 0)) - 1, len(lines(mesh, 1)) - 1) == counts
        assert (mesh.nodes[:, 0].min(), mesh.nodes[:, 0].max()) == (-3.0, 3.0)


SUPPORTS = {
    "free": (False, False, False),
    "soft": (True, False, False),
    "hinged": (True, False, True),
    "clamped": (True, True, True),
}


@pytest.mark.parametrize("kind", SUPPORTS)
@pytest.mark.parametrize("side", ["left", "right", "bottom", "top"])
def test_supports_hold_what_they_say(side: str, kind: str) -> None:
    """Soft holds w, hinged also the rotation along the edge, clamped both rotations; nothing else is touched."""
    problem = discretize(model(edges=Edges(**{side: kind})))
    axis, place = {"left": (0, -3.0), "right": (0, 3.0), "bottom": (1, -2.0), "top": (1, 2.0)}[side]
    on_edge = problem.mesh.nodes[:, axis] == place
    holds_w, holds_normal, holds_along = SUPPORTS[kind]
    fields = {W: holds_w, BETA_X + axis: holds_normal, BETA_X + 1 - axis: holds_along}
    for field, held in fields.items():
        np.testing.assert_array_equal(problem.unknown[:, field] < 0, on_edge & held)
    assert (problem.unknown[:, TOP] >= 0).all()


def test_lines_of_symmetry_hold_the_normal_rotation() -> None:
    """On x = 0 beta_x vanishes, on y = 0 beta_y, and nothing else is held."""
    problem = discretize(model(counts=(6, 4), symmetry="auto"))
    x, y = problem.mesh.nodes.T
    np.testing.assert_array_equal(problem.unknown[:, BETA_X] < 0, x == 0)
    np.testing.assert_array_equal(problem.unknown[:, BETA_Y] < 0, y == 0)
    assert (problem.unknown[:, [W, TOP]] >= 0).all()


def test_unknowns_are_numbered_once_each() -> None:
    """Numbers run from 0 without a hole or a repetition; plate unknowns exist under the plate alone."""
    problem = discretize(model(beyond=Beyond(kind="margin", width=1.5), element="mitc9"))
    numbers = np.sort(problem.unknown[problem.unknown >= 0])
    np.testing.assert_array_equal(numbers, np.arange(len(numbers)))
    under = np.zeros(len(problem.mesh.nodes), dtype=bool)
    under[problem.plate.nodes] = True
    inside = (np.abs(problem.mesh.nodes) <= [3.0, 2.0]).all(axis=1)
    np.testing.assert_array_equal(under, inside)
    assert (problem.unknown[~under, :TOP] < 0).all()
    assert (problem.unknown[:, TOP] >= 0).all()


def test_glued_plates_have_no_gaps() -> None:
    """With a ground that can pull the gap is no unknown under the plate, while the ground beyond keeps its own."""
    problem = discretize(model(tensionless=False, beyond=Beyond(kind="margin", width=1.5)))
    under = np.zeros(len(problem.mesh.nodes), dtype=bool)
    under[problem.plate.nodes] = True
    np.testing.assert_array_equal(problem.unknown[:, TOP] < 0, under)
    assert not (problem.contact.bearing.field == TOP).any()


STACK = Layered(coupling="interface", layers=[InterfaceLayer(k0=30e6, k1=20e6), InterfaceLayer(k0=60e6, k1=10e6)])


@pytest.mark.parametrize("edge", ["free", "fixed"])
def test_margin_with_a_free_or_a_fixed_edge(edge: str) -> None:
    """The mesh reaches as far as asked on the sides asked; a fixed outer edge holds all surfaces, a free one none."""
    beyond = Beyond(kind="margin", width=1.5, edge=edge, sides=("left", "top"))
    problem = discretize(model(ground=STACK, beyond=beyond))
    low, high = problem.mesh.nodes.min(axis=0), problem.mesh.nodes.max(axis=0)
    np.testing.assert_allclose([low, high], [[-4.5, -2.0], [3.0, 3.5]])
    x, y = problem.mesh.nodes.T
    outer = (x == low[0]) | (y == high[1])
    for field in (TOP, TOP + 1):
        np.testing.assert_array_equal(problem.unknown[:, field] < 0, outer & (edge == "fixed"))
    assert len(problem.edges) == 0
    assert len(problem.corners) == 0


@pytest.mark.parametrize(
    ("sides", "symmetry", "length", "corners"),
    [
        (("left", "right", "bottom", "top"), "off", 2 * (8 + 6), 4),
        (("left", "right", "bottom", "top"), "auto", 4 + 3, 1),
        (("left", "right"), "off", 2 * 4, 0),
        (("left", "right"), "auto", 2, 0),
        (("left", "top"), "off", 5 + 7, 1),
        (("right", "top", "bottom"), "off", 6 + 7 + 7, 2),
    ],
)
def test_infinite_edges(sides: tuple[str, ...], symmetry: str, length: float, corners: int) -> None:
    """Tails stand all along the outer sides asked, with quarter planes between two, not on lines of symmetry."""
    problem = discretize(
        model(counts=(6, 4), symmetry=symmetry, beyond=Beyond(kind="infinite", width=1.0, sides=sides))
    )
    ends = problem.mesh.nodes[problem.edges]
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    assert lengths.sum() == pytest.approx(length)
    assert len(problem.corners) == corners
    np.testing.assert_allclose(ends[:, 2], (ends[:, 0] + ends[:, 1]) / 2, atol=1e-14)
    low, high = problem.mesh.nodes.min(axis=0), problem.mesh.nodes.max(axis=0)
    assert ((ends == low) | (ends == high)).any(axis=2).all()
    at_corner = problem.mesh.nodes[problem.corners]
    assert ((at_corner == low) | (at_corner == high)).all()


def test_width_of_infinite_ground_is_a_decay_length() -> None:
    """Without a width the mesh goes one decay length sqrt(k1/k0) beyond the plate."""
    problem = discretize(model(ground=Pasternak(k0=30e6, k1=20e6), beyond=Beyond(kind="infinite")))
    assert problem.mesh.nodes[:, 0].max() == pytest.approx(3.0 + np.sqrt(2 / 3))
    wider = discretize(model(ground=Pasternak(k0=30e6, k1=20e6), beyond=Beyond(kind="infinite")), margin=2.0)
    assert wider.mesh.nodes[:, 0].max() == pytest.approx(3.0 + 2 * np.sqrt(2 / 3))


@pytest.mark.parametrize("order", [1, -1])
def test_initial_gap_is_the_uniform_one_and_the_deepest_void(order: int) -> None:
    """Voids add to the uniform gap; where two overlap the deeper one counts; no gap beyond the plate.

    A node on the edge of a void has the least gap of what meets there.
    """
    voids = [Void(depth=0.02, x=(-1, 2), y=(-1, 1)), Void(depth=0.05, x=(1, 3), y=(0, 2))][::order]
    problem = discretize(model(gap=0.01, voids=voids, beyond=Beyond(kind="margin", width=1.0), counts=(6, 4)))
    for (x, y), gap in zip(problem.mesh.nodes, problem.contact.initial_gap, strict=True):
        wanted = 0.0
        if abs(x) <= 3 and abs(y) <= 2:
            around = [(x + i * 1e-6, y + j * 1e-6) for i in (-1, 1) for j in (-1, 1)]
            wanted = 0.01 + min(
                max(0.02 * (-1 <= u <= 2 and -1 <= v <= 1), 0.05 * (1 <= u <= 3 and 0 <= v <= 2))
                for u, v in around
                if abs(u) <= 3 and abs(v) <= 2
            )
        assert gap == pytest.approx(wanted)


def test_nodal_areas_are_those_of_the_plate() -> None:
    """The nodes' shares add up to the plate's area, corners getting a 36th of an element, centres 16/36."""
    problem = discretize(model(beyond=Beyond(kind="margin", width=1.0)))
    area = nodal_area(problem.mesh, problem.plate.elements)
    assert area.sum() == pytest.approx(LX * LY)
    one = LX * LY / 15
    elements = problem.mesh.elements[problem.plate.elements]
    np.testing.assert_allclose(area[elements[:, 8]], one * 16 / 36)
    corner = (problem.mesh.nodes == [3.0, 2.0]).all(axis=1)
    np.testing.assert_allclose(area[corner], one / 36)


@pytest.mark.parametrize(("E", "k"), [(38.22e6, 9.4990e6), (19.11e6, 4.7495e6)])
def test_selvadurais_modulus(E: float, k: float) -> None:
    """(3.1) gives the k0 published in Table 3 of the paper for a plate of 5 m on 10 m of soil, to its digits."""
    described = Model(
        plate=Plate(length_x=4.0, length_y=5.0, thickness=0.2, E=30e9, nu=0.2),
        ground=Winkler(selvadurai=Selvadurai(E=E, depth=10.0)),
        loads=[UniformLoad(q=1.0)],
    )
    assert isinstance(described.ground, Winkler)
    assert described.ground.modulus(max(described.plate.sides)) == pytest.approx(k, abs=60.0)


def test_ground_becomes_column_or_soil() -> None:
    """Constants give a column, moduli give soil in the way that fits, with E(z) as described."""
    layer = SoilLayer(E=40e6, E_bottom=100e6, nu=0.3, thickness=5.0)
    curved = SoilLayer(E=40e6, E_bottom=100e6, variation="quadratic", nu=0.3, thickness=5.0)
    plain = SoilLayer(E=40e6, nu=0.3, thickness=5.0)
    assert [rooms.layer_of(one).moduli for one in (layer, curved, plain)] == [
        (40e6, 60e6, 0.0),
        (40e6, 0.0, 60e6),
        (40e6, 0.0, 0.0),
    ]
    ways = {
        "sinh": Vlasov(layers=[layer]),
        "profile": Vlasov(layers=[layer, plain]),
        "interface": Layered(coupling="interface", layers=[layer, plain]),
    }
    for way, ground in ways.items():
        found = rooms.ground_of(model(ground=ground))
        assert isinstance(found, Soil)
        assert found.way == way
    column = rooms.ground_of(model(ground=STACK))
    assert isinstance(column, Column)
    wanted = interface_stack(np.array([30e6, 60e6]), np.array([20e6, 10e6]))
    np.testing.assert_array_equal(column.A0, wanted.A0)
    np.testing.assert_array_equal(column.A1, wanted.A1)


def test_sublayers_are_the_parts_of_their_layer() -> None:
    """A layer with sublayers gives as many layers with E continuous from one to the next."""
    ground = Layered(
        coupling="consistent",
        layers=[
            SoilLayer(E=40e6, E_bottom=100e6, nu=0.3, thickness=6.0, sublayers=3),
            SoilLayer(E=20e6, nu=0.2, thickness=1.0),
        ],
    )
    parts = rooms.sublayers(ground, tuple(rooms.layer_of(layer) for layer in ground.layers))
    assert [part.thickness for part in parts] == pytest.approx([2.0, 2.0, 2.0, 1.0])
    ends = [(float(part.E(np.array(0.0))), float(part.E(np.array(1.0)))) for part in parts]
    np.testing.assert_allclose(ends, [(40e6, 60e6), (60e6, 80e6), (80e6, 100e6), (20e6, 20e6)])


def dense(problem: Problem, column: Column) -> np.ndarray:
    """Return the full stiffness matrix of a problem on a column."""
    s = build_system(problem)
    data = stiffness(s, column).data
    upper = csr_array((data, s.pattern.indices, s.pattern.indptr), shape=(s.pattern.size, s.pattern.size)).toarray()
    return upper + np.triu(upper, 1).T


@pytest.mark.slow
@settings(max_examples=examples(6), derandomize=True, deadline=None)
@given(
    element=st.sampled_from(ELEMENTS),
    layers=st.integers(1, 2),
    tensionless=st.booleans(),
    seed=st.integers(0, 1000),
)
def test_constants_that_vary_in_plan(element: str, layers: int, tensionless: bool, seed: int) -> None:
    """k0 and k1 given by elements equal the uniform ones where they are equal, and add up element by element.

    The matrix is linear in the column: the sum over elements of the matrices with one element's ground alone is the
    matrix of all, once the plate's own part is counted once.
    """
    rng = np.random.default_rng(seed)
    described = model(
        ground=STACK if layers == 2 else Pasternak(k0=30e6, k1=20e6),
        element=element,
        tensionless=tensionless,
        counts=(3, 2),
        beyond=Beyond(kind="margin", width=1.0, sides=("right",)),
    )
    problem = discretize(described)
    m = len(problem.mesh.elements)
    k0, k1 = rng.uniform(1, 9, layers) * 1e7, rng.uniform(1, 9, layers) * 1e7

    def column(by_element: np.ndarray) -> Column:
        return interface_stack(by_element[:, None] * k0, by_element[:, None] * k1)

    uniform = dense(problem, interface_stack(k0, k1))
    scale = np.abs(uniform).max()
    np.testing.assert_allclose(dense(problem, column(np.ones(m))), uniform, atol=1e-12 * scale)

    factor = rng.uniform(0.2, 3.0, m)
    varying = dense(problem, column(factor))
    assert np.abs(varying - uniform).max() > 1e-3 * 1e7
    plate_alone = dense(problem, interface_stack(0 * k0, 0 * k1))
    parts = sum(f * (dense(problem, column(np.eye(m)[e])) - plate_alone) for e, f in enumerate(factor))
    np.testing.assert_allclose(varying, plate_alone + parts, atol=1e-11 * scale)


def test_energy_of_ground_that_varies_in_plan() -> None:
    """For w = 1 the ground's energy is that of k0 on each element's area, for w = x^2 that of k1 on the slope."""
    problem = discretize(model(tensionless=False, counts=(3, 2)))
    k0 = np.array([1.0, 2.0, 3.0, 5.0, 8.0, 13.0]) * 1e6
    k1 = np.array([7.0, 1.0, 4.0, 2.0, 9.0, 3.0]) * 1e6
    A = dense(problem, single(k0, k1)) - dense(problem, single(np.zeros(6), 0.0))
    u = np.zeros(len(A))
    u[problem.unknown[:, W]] = 1.0
    assert u @ A @ u == pytest.approx(k0.sum() * LX * LY / 6, rel=1e-9)
    # w = x^2: int k1 (2 x)^2 over elements 2 m long and wide
    B = dense(problem, single(np.zeros(6), k1)) - dense(problem, single(np.zeros(6), 0.0))
    u[problem.unknown[:, W]] = problem.mesh.nodes[:, 0] ** 2
    centre = problem.mesh.nodes[problem.mesh.elements[:, 8], 0]
    wanted = (k1 * 4 * (4.0 * centre**2 + 2.0 * 2.0**3 / 12)).sum()
    assert u @ B @ u == pytest.approx(wanted, rel=1e-9)


@pytest.mark.parametrize("off", [0.0, 1e-17, -1e-17, 1e-10, -1e-10])
def test_a_point_load_on_a_line_of_symmetry_up_to_rounding(off: float) -> None:
    """A coordinate that rounding has put beside the line of symmetry neither doubles nor drops the load."""
    for place in ({"x": off, "y": 0.0}, {"x": 0.0, "y": off}):
        problem = discretize(model([PointLoad(P=8.0, **place)], counts=(6, 4), symmetry="auto"))
        assert problem.symmetry == (True, True)
        assert problem.load[:, W].sum() == pytest.approx(2.0)


@pytest.mark.slow
@pytest.mark.parametrize("symmetry", ["auto", "off"])
def test_nodes_on_the_edge_of_a_void_bear(symmetry: str) -> None:
    """Nodes on the edge of a void have the gap outside, however their coordinates and those of the void are rounded."""
    for n in range(4, 34, 2):
        for k in range(1, n // 2):
            edge = k * 6.0 / n
            void = Void(depth=0.01, x=(-edge, edge), y=(-1, 1))
            problem = discretize(model(voids=[void], counts=(n, 4), symmetry=symmetry))
            x, y = np.abs(problem.mesh.nodes).T
            inside = (x < edge - 1e-6) & (y < 1 - 1e-6)
            np.testing.assert_array_equal(problem.contact.initial_gap > 0, inside)


def test_measured_gaps_lie_on_top_of_the_uniform_one() -> None:
    """With two measured gaps the initial gap grows linearly, beyond them too; the uniform gap is added."""
    known = [GapPoint(x=-2.0, y=0.0, gap=1e-3), GapPoint(x=2.0, y=0.0, gap=5e-3)]
    problem = discretize(model(gap=2e-3, gaps=known, counts=(6, 4)))
    along = np.flatnonzero(np.abs(problem.mesh.nodes[:, 1]) < 1e-12)
    x = problem.mesh.nodes[along, 0]
    np.testing.assert_allclose(problem.contact.initial_gap[along], 2e-3 + 3e-3 + 1e-3 * x, atol=1e-12)


def test_gaps_measured_on_a_plane_are_that_plane() -> None:
    """A plate whose ground slopes away evenly settles onto the slope without bending: w = q / k + gap everywhere."""
    plane = [(x, y, 1.8e-3 + 2e-4 * x + 1e-4 * y) for x in (-3.0, 3.0) for y in (-2.0, 2.0)]
    known = [GapPoint(x=x, y=y, gap=gap) for x, y, gap in plane]
    results = solve(model([UniformLoad(q=2e4)], gaps=known, ground=Winkler(k=2e7), counts=(12, 8)))
    x, y = results.plate.nodes.T
    np.testing.assert_allclose(results.plate.settlement, 1e-3 + 1.8e-3 + 2e-4 * x + 1e-4 * y, rtol=1e-6)
    assert results.plate.settlement.max() == pytest.approx(3.6e-3, rel=1e-6)


def test_a_rigid_plate_takes_up_a_measured_gap() -> None:
    """One measured gap holds everywhere: the plate settles by it and by q / k."""
    parts = {"gaps": [GapPoint(x=1.0, y=1.0, gap=3e-3)], "ground": Winkler(k=1e7), "counts": (4, 4)}
    settlement = solve(model([UniformLoad(q=1e4)], **parts)).plate.settlement
    np.testing.assert_allclose(settlement, 3e-3 + 1e-3, rtol=1e-9)


@needs_gmsh
def test_infinite_edges_of_a_mesh_that_is_no_grid() -> None:
    """All around a plate with an oblique edge, whatever rounding its mesh comes with."""
    outline = {"kind": "polygon", "points": [(0, 0), (7, 0), (8, 3), (5, 6), (0, 6)]}
    for width in (1.3, 1.7, 2.9):
        plate = {"outline": outline, "thickness": 0.4, "E": 30e9, "nu": 0.2}
        beyond = Beyond(kind="infinite", width=width)
        problem = discretize(model().replace(plate=plate, mesh={"size": 1.0}, beyond=beyond))
        ends = problem.mesh.nodes[problem.edges]
        assert np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum() == pytest.approx(2 * (8 + 6 + 4 * width))
        assert len(problem.corners) == 4
