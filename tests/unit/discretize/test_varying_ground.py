"""Ground that varies over the plan, by element: which columns, their modes, their tails."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from groundslab.analysis.driver import solve
from groundslab.discretize.discretize import discretize
from groundslab.discretize.ground import ground_under, grounds_of, layer_of
from groundslab.discretize.symmetry import symmetries
from groundslab.errors import InputError
from groundslab.fem.foundation import Column, Layer, consistent_stack, edge_decay
from groundslab.fem.system import edge_decays
from groundslab.fem.vlasov import Soil, parameters, parameters_as_printed, profile, profiles
from groundslab.model.ground import ConstrainedModulus, InterfaceLayer, Layered, Pasternak, SoilLayer, Vlasov, Winkler
from groundslab.model.loads.load_types import UniformLoad
from groundslab.model.model import Model
from groundslab.model.plate import Plate
from groundslab.model.settings import Beyond, Contact, Mesh
from groundslab.model.shapes import Circle, Rectangle
from groundslab.model.varying_ground import Borehole, GapPoint, SoilZone

PLATE = Plate(length_x=6.0, length_y=4.0, thickness=0.25, E=30e9, nu=0.2)
SOFT = SoilLayer(E=30e6, E_bottom=50e6, nu=0.4, thickness=3.0)
STIFF = SoilLayer(E=90e6, nu=0.25, thickness=4.0)


def model(**keys: Any) -> Model:
    """Return a plate of 6 x 4 m in 6 x 4 elements."""
    return Model(**{"plate": PLATE, "loads": [UniformLoad(q=1e4)], "mesh": Mesh(counts=(6, 4)), **keys})


def ground(described: Model) -> Soil | Column:
    """Return the ground that an analysis of the description works on."""
    return discretize(described).ground


def box(x0: float, x1: float) -> Rectangle:
    """Return a rectangle from x0 to x1 that is wider than the plate."""
    return Rectangle(x=(x0, x1), y=(-50.0, 50.0))


def many(rng: np.random.Generator, c: int) -> Layer:
    """Return a layer over c columns."""
    moduli = rng.uniform(20, 50, c), rng.uniform(-10, 30, c), rng.uniform(-5, 30, c)
    return Layer(rng.uniform(1, 5, c), moduli, rng.uniform(0, 0.45, c))


def one(layer: Layer, i: int) -> Layer:
    """Return the layer of one column."""
    c0, c1, c2 = (float(np.asarray(c)[i]) for c in layer.moduli)
    return Layer(float(np.asarray(layer.thickness)[i]), (c0, c1, c2), float(np.asarray(layer.nu)[i]))


@pytest.mark.parametrize("formula", [parameters, parameters_as_printed])
def test_formulas_hold_column_by_column(formula: Any) -> None:
    """k0 and k1 of many columns, each with its gamma, are those of each by itself; linear beside quadratic E."""
    rng = np.random.default_rng(1)
    layer, gamma = many(rng, 40), rng.uniform(0.01, 6, 40)
    layer = Layer(layer.thickness, (*layer.moduli[:2], np.where(np.arange(40) % 2, 0.0, layer.moduli[2])), layer.nu)
    each = np.array([formula(one(layer, i), float(gamma[i])) for i in range(40)]).T
    np.testing.assert_allclose(np.array(formula(layer, gamma)), each, rtol=1e-13)


@pytest.mark.slow
def test_modes_of_many_columns_are_those_of_each() -> None:
    """Columns whose chains stand in one matrix do not feel each other: k0 and k1 are those of single profiles."""
    rng = np.random.default_rng(2)
    layers, decay2 = tuple(many(rng, 1100) for _ in range(3)), rng.uniform(0, 3, 1100)
    k0, k1 = profiles(layers, decay2)
    for i in (0, 1, 500, 1023, 1024, 1099):
        alone = profile(tuple(one(layer, i) for layer in layers), float(decay2[i]))
        assert (k0[i], k1[i]) == pytest.approx((alone.k0, alone.k1), rel=1e-6)


@pytest.mark.parametrize("decay2", [0.0, 1e-6, 1e-4, 0.1, 2.0, 30.0])
def test_layers_of_one_modulus_have_a_closed_form(decay2: float) -> None:
    """Where E does not vary in a layer, k0 and k1 are those of finite elements, beside others where it does."""
    rng = np.random.default_rng(4)
    layers = tuple(
        Layer(each.thickness, (each.moduli[0], *(np.where(even, 0.0, c) for c in each.moduli[1:])), each.nu)
        for each, even in ((many(rng, 4), np.array(which)) for which in ([1, 1, 0, 1], [1, 0, 1, 0], [1, 1, 0, 0]))
    )
    k0, k1 = profiles(layers, np.full(4, decay2))
    for i in range(4):
        alone = profile(tuple(one(layer, i) for layer in layers), decay2)
        assert (k0[i], k1[i]) == pytest.approx((alone.k0, alone.k1), rel=1e-6)


def test_stacks_and_tails_of_many_columns_are_those_of_each() -> None:
    """Consistent stacks, and the infinite ground beside them, are found for all columns as for each."""
    rng = np.random.default_rng(3)
    layers = [many(rng, 5) for _ in range(3)]
    columns = consistent_stack(layers)
    found = edge_decay(columns)
    for i in range(5):
        column = consistent_stack([one(layer, i) for layer in layers])
        np.testing.assert_allclose(columns.A0[i], column.A0, rtol=1e-14)
        np.testing.assert_allclose(columns.A1[i], column.A1, rtol=1e-14)
        alone = edge_decay(column)
        for name in ("spring", "slope", "corner", "decay"):
            np.testing.assert_allclose(getattr(found, name)[i], getattr(alone, name), rtol=1e-12)
        for mine, wanted in zip(found.square_integrals(), alone.square_integrals(), strict=True):
            np.testing.assert_allclose(mine[i], wanted, rtol=1e-10)


def test_elements_across_a_border_have_the_mean_by_area() -> None:
    """On a grid that is asked for, each element has the ground of every zone by the share of its area in it.

    Where zones overlap the last one counts. The circle covers a quarter of pi of the element around its centre.
    """
    zones = [
        SoilZone(shape=box(-0.75, 50.0), ground=Winkler(k=2e7)),
        SoilZone(shape=Circle(centre=(2.5, 1.5), radius=0.5), ground=Winkler(k=3e7)),
    ]
    found = ground(model(ground=Winkler(k=1e7), soil_zones=zones))
    assert isinstance(found, Column)
    k = found.A0[:, 0, 0].reshape(4, 6)
    wanted = np.full((4, 6), 1e7)
    wanted[:, 2] = 1.75e7
    wanted[:, 3:] = 2e7
    wanted[3, 5] = 2e7 + np.pi / 4 * 1e7
    np.testing.assert_allclose(k, wanted, rtol=1e-5)
    assert not found.A1.any()


def test_zones_reach_beyond_the_plate() -> None:
    """Elements of the ground beyond the plate have the ground of their zone, and edges and corners continue it."""
    zone = SoilZone(shape=box(0.0, 50.0), ground=Pasternak(k0=8e7, k1=1e7))
    described = model(ground=Pasternak(k0=2e7, k1=1e7), soil_zones=[zone], beyond=Beyond(kind="infinite"))
    problem = discretize(described)
    assert isinstance(problem.ground, Column)
    right = problem.mesh.nodes[problem.mesh.elements[:, 8], 0] > 0
    np.testing.assert_array_equal(problem.ground.A0[:, 0, 0], np.where(right, 8e7, 2e7))
    edges, corners = edge_decays(problem, problem.ground)
    for found, nodes in ((edges, problem.edges[:, 2]), (corners, problem.corners)):
        at = problem.mesh.nodes[nodes, 0] > 0
        assert at.any()
        assert not at.all()
        np.testing.assert_allclose(found.decay[:, 0], np.where(at, np.sqrt(8.0), np.sqrt(2.0)), rtol=1e-14)
    # the meshed strip is as wide as the widest ground needs: the decay length of the softer one
    assert problem.mesh.nodes[:, 0].max() == pytest.approx(3.0 + 1 / np.sqrt(2.0))


def test_layers_between_boreholes() -> None:
    """Thickness, E, E_bottom and nu are linear between two boreholes, and each element has those of its centre."""
    holes = [Borehole(x=-3.0, y=0.0, layers=[SOFT]), Borehole(x=3.0, y=0.0, layers=[STIFF])]
    plate = PLATE.replace(length_y=1e-6)
    found = ground(model(ground=Vlasov(layers=[SOFT]), boreholes=holes, plate=plate, mesh=Mesh(counts=(6, 1))))
    assert isinstance(found, Soil)
    assert found.parts is not None
    np.testing.assert_array_equal(found.parts.area_fraction, 1.0)
    (layer,) = found.layers
    part = (np.arange(6) + 0.5) / 6
    for given, a, b in (
        (layer.thickness, 3.0, 4.0),
        (layer.moduli[0], 30e6, 90e6),
        (layer.moduli[0] + layer.moduli[1] + layer.moduli[2], 50e6, 90e6),
        (layer.nu, 0.4, 0.25),
    ):
        np.testing.assert_allclose(np.asarray(given)[found.parts.column], a + part * (b - a), rtol=1e-9)
    np.testing.assert_allclose(found.area_fraction, 1 / 6)


@pytest.mark.parametrize("coupling", ["vlasov", "interface", "consistent"])
def test_one_borehole_is_uniform_ground(coupling: Any) -> None:
    """One borehole gives its layers everywhere, with the rules and sublayers of [ground]; no arrays by element."""
    other = SoilLayer(E=1e6, nu=0.0, thickness=1.0)
    if coupling == "vlasov":
        rules: Any = Vlasov(layers=[other, other])
        wanted: Any = Vlasov(layers=[SOFT, STIFF])
    else:
        sub = {"sublayers": 3} if coupling == "consistent" else {}
        rules = Layered(coupling=coupling, layers=[other.replace(**sub), other])
        wanted = Layered(coupling=coupling, layers=[SOFT.replace(**sub), STIFF])
    found = ground(model(ground=rules, boreholes=[Borehole(x=9.0, y=9.0, layers=[SOFT, STIFF])]))
    uniform = ground(model(ground=wanted))
    if isinstance(found, Soil):
        assert found == uniform
    else:
        assert isinstance(uniform, Column)
        np.testing.assert_array_equal(found.A0, uniform.A0)
        np.testing.assert_array_equal(found.A1, uniform.A1)


def test_gamma_is_the_mean_of_the_columns() -> None:
    """A decay of the settlement gives each column the gamma of (2.23), and their mean over the plate; and back."""
    zones = [SoilZone(shape=box(1.0, 50.0), ground=Vlasov(layers=[STIFF]))]
    found = ground(model(ground=Vlasov(layers=[SOFT]), soil_zones=zones))
    assert isinstance(found, Soil)
    each = [uniform.gamma_of(0.2) for uniform in grounds_of(model(ground=Vlasov(layers=[SOFT]), soil_zones=zones))]
    mean = (4 * each[0] + 2 * each[1]) / 6
    assert found.gamma_of(0.2) == pytest.approx(mean, rel=1e-14)
    np.testing.assert_allclose(sorted(found.gammas(mean)), sorted(each), rtol=1e-14)  # type: ignore[arg-type]


def test_a_given_gamma_is_that_of_every_column() -> None:
    """With gamma given, each zone has the k0 and k1 that it would have by itself."""
    zones = [SoilZone(shape=box(0.0, 50.0), ground=Vlasov(layers=[STIFF], gamma=1.4))]
    described = model(ground=Vlasov(layers=[SOFT], gamma=1.4), soil_zones=zones)
    found = ground(described)
    assert isinstance(found, Soil)
    k0 = found.column(1.4).A0[:, 0, 0].reshape(4, 6)
    left, right = (each.column(1.4).A0[0, 0] for each in grounds_of(described) if isinstance(each, Soil))
    np.testing.assert_allclose(k0, np.repeat([[left, right]], 3, axis=1).repeat(4, axis=0), rtol=1e-14)


def test_misprints_that_give_no_ground_are_told_for_the_column() -> None:
    """Formulas "as printed" that give a negative k1 in one zone name k0 and k1 of that zone."""
    steep = SoilLayer(E=1e6, E_bottom=500e6, variation="quadratic", nu=0.2, thickness=20.0)
    printed = {"gamma": 0.8, "formulas": "as printed"}
    zones = [SoilZone(shape=box(0.0, 50.0), ground=Vlasov(layers=[steep], **printed))]
    found = ground(model(ground=Vlasov(layers=[STIFF], **printed), soil_zones=zones))
    assert isinstance(found, Soil)
    k0, k1 = parameters_as_printed(layer_of(steep), 0.8)
    assert k1 < 0
    with pytest.raises(InputError) as reported:
        found.column(0.8)
    assert f"k0 = {np.array([k0])} Pa/m and k1 = {np.array([k1])} Pa m" in str(reported.value)


def test_nothing_between_boreholes_leaves_their_range() -> None:
    """Where the interpolation would overshoot, even below zero, the nearest known value counts; all is solved."""
    thin, thick = (SoilLayer(E=3e7, nu=0.3, thickness=h) for h in (0.01, 9.0))
    at = [(-3.0, 0.0, thin), (-2.9, 0.3, thick), (3.0, 1.0, thin), (0.0, -2.0, thin), (-3.0, 2.0, thick)]
    holes = [Borehole(x=x, y=y, layers=[STIFF, layer]) for x, y, layer in at]
    ground = discretize(model(ground=Vlasov(layers=[STIFF, thin]), boreholes=holes)).ground
    assert isinstance(ground, Soil)
    thickness = np.asarray(ground.layers[1].thickness)
    assert thickness.min() == 0.01
    assert 0.01 < np.median(thickness) < thickness.max() <= 9.0


@pytest.mark.parametrize(
    "keys",
    [
        {"soil_zones": [SoilZone(shape=box(-1.0, 1.0), ground=Vlasov(layers=[STIFF]))]},
        {"boreholes": [Borehole(x=0.0, y=0.0, layers=[STIFF])]},
        {"contact": Contact(gaps=[GapPoint(x=0.0, y=0.0, gap=0.01)])},
    ],
)
def test_varying_ground_is_solved_as_a_whole(keys: dict[str, Any]) -> None:
    """No mirror is looked for where ground or gap vary over the plan."""
    assert symmetries(model(ground=Vlasov(layers=[SOFT]))) == (True, True)
    assert symmetries(model(ground=Vlasov(layers=[SOFT]), **keys)) == (False, False)


def test_zones_that_cannot_be_joined() -> None:
    """Zones with another kind, number of layers or mode, and zones without shear beside infinite ground, are issues."""
    two = Layered(coupling="interface", layers=[InterfaceLayer(k0=1e7, k1=1e6), InterfaceLayer(k0=1e7, k1=0)])
    for base, other, beyond, where in (
        (Winkler(k=1e7), Pasternak(k0=1e7, k1=1e6), "none", ""),
        (Vlasov(layers=[SOFT]), Vlasov(layers=[SOFT, STIFF]), "none", ""),
        (Vlasov(layers=[SOFT], mode="sinh"), Vlasov(layers=[SOFT], mode="profile"), "none", ""),
        (Pasternak(k0=1e7, k1=1e6), Pasternak(k0=1e7, k1=0), "infinite", ".k1"),
        (two.replace(layers=[two.layers[0]] * 2), two, "infinite", ".layers[2].k1"),
    ):
        with pytest.raises(InputError) as reported:
            model(ground=base, soil_zones=[SoilZone(shape=box(0, 1), ground=other)], beyond=Beyond(kind=beyond))
        assert [issue.location for issue in reported.value.issues] == [f"soil_zones[1].ground{where}"]


def test_boreholes_that_do_not_match() -> None:
    """Layers that are missing, two boreholes at one place, and boreholes in ground without layers are issues."""
    hole = Borehole(x=1.0, y=0.0, layers=[SOFT])
    layers = Vlasov(layers=[SOFT, STIFF])
    for base, holes, where in (
        (layers, [hole], ["boreholes[1].layers"]),
        (Vlasov(layers=[SOFT]), [hole, hole], ["boreholes[2]"]),
        (Winkler(k=1e7), [hole], ["boreholes"]),
    ):
        with pytest.raises(InputError) as reported:
            model(ground=base, boreholes=holes)
        assert [issue.location for issue in reported.value.issues] == where


def test_ground_under_follows_the_mesh() -> None:
    """Finer meshes have columns of their own, so that the steps between elements shrink with them."""
    holes = [Borehole(x=-9.0, y=0.0, layers=[SOFT]), Borehole(x=9.0, y=0.0, layers=[STIFF])]
    steps = []
    for counts in ((6, 4), (12, 8), (24, 16)):
        described = model(
            ground=Layered(coupling="consistent", layers=[SOFT]), boreholes=holes, mesh=Mesh(counts=counts)
        )
        problem = discretize(described)
        found = ground_under(described, problem.mesh, problem.plate.elements, {})[0]
        assert isinstance(found, Column)
        rows = found.A0[:, 0, 0].reshape(counts[1], counts[0])
        steps.append(np.abs(np.diff(rows, axis=1)).max())
    assert all(fine < 0.6 * coarse for coarse, fine in pairwise(steps))


PEAT = SoilLayer(E=1e6, nu=0.35, thickness=1.0)
SAND = SoilLayer(E=40e6, nu=0.3, thickness=8.0)


@pytest.mark.parametrize(
    "stack",
    [Vlasov(layers=(PEAT, SAND)), Layered(coupling="interface", layers=(PEAT, SAND)),
     Layered(coupling="consistent", layers=(PEAT, SAND)), ConstrainedModulus(layers=(PEAT, SAND))],
    ids=["vlasov", "interface", "consistent", "constrained modulus"],
)  # fmt: skip
def test_a_layer_that_is_missing_at_a_borehole(stack: Any) -> None:
    """With 0 m it is not there: the settlement is that of the stack without it.

    By hand, of a pressure of 10 kPa that is the same everywhere on ground that ends with the plate:
    10 kPa x 9 m / (40 MPa x 0.7 / (1.3 x 0.4)) = 1.6714 mm; stresses that spread are compared with the stack itself.
    """
    thick = SAND.replace(thickness=9.0)
    hole = Borehole(x=0.0, y=0.0, layers=(PEAT.replace(thickness=0.0), thick))
    without, missing = (
        solve(model(ground=found, boreholes=holes)).plate.settlement
        for found, holes in ((stack.replace(layers=(thick,)), ()), (stack, (hole,)))
    )
    assert missing == pytest.approx(without, rel=1e-6)
    if stack.kind != "constrained modulus":
        assert missing == pytest.approx(1e4 * 9 / (40e6 * 0.7 / (1.3 * 0.4)), rel=1e-5)


def test_a_layer_pinches_out_between_boreholes() -> None:
    """Peat of 1 m at one end, none at the other: in between it is as thick as the distance from the latter over 6.

    k of each element in one dimension, by hand: 1 / (h_1 / M_1 + h_2 / M_2), M = E (1 - nu) / ((1 + nu)(1 - 2 nu)).
    """
    holes = (
        Borehole(x=-3.0, y=0.0, layers=(PEAT, SAND)),
        Borehole(x=3.0, y=0.0, layers=(PEAT.replace(thickness=0.0), SAND.replace(thickness=9.0))),
    )
    stack = Vlasov(layers=(PEAT, SAND), gamma=1e-6)
    found = discretize(model(ground=stack, boreholes=holes, mesh=Mesh(counts=(24, 5))))
    column = found.ground
    assert isinstance(column, Soil)
    assert column.parts is not None
    x = found.mesh.nodes[found.mesh.elements[:, 8], 0]
    in_middle = np.abs(found.mesh.nodes[found.mesh.elements[:, 8], 1]) < 1e-9
    peat = np.asarray(column.layers[0].thickness)[column.parts.column]
    assert peat[in_middle] == pytest.approx((3 - x[in_middle]) / 6, rel=1e-9)
    M_1, M_2 = (E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) for E, nu in ((1e6, 0.35), (40e6, 0.3)))
    k0 = profiles(column.layers, np.zeros(len(np.asarray(column.layers[0].thickness))))[0][column.parts.column]
    assert k0 == pytest.approx(1 / (peat / M_1 + (9 - peat) / M_2), rel=1e-6)


def test_layers_of_no_thickness_are_for_boreholes_alone() -> None:
    """In [ground] and with all layers at a borehole they are refused."""
    none = PEAT.replace(thickness=0.0)
    with pytest.raises(InputError, match=r"layers\[1\].thickness: found 0 m, expected more than 0 m"):
        Vlasov(layers=(none, SAND))
    with pytest.raises(InputError, match="layers of 0 m"):
        Borehole(x=0.0, y=0.0, layers=(none, none))
