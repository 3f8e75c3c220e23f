"""What must hold on ground that varies over the plan: equilibrium, joins that are none, limits."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from groundslab.analysis.driver import solve
from groundslab.errors import GroundslabError, InputError
from groundslab.model.ground import InterfaceLayer, Layered, Pasternak, SoilLayer, Vlasov, Winkler
from groundslab.model.loads.load_types import PointLoad, UniformLoad
from groundslab.model.model import Model
from groundslab.model.plate import Plate
from groundslab.model.settings import Beyond, Contact, Mesh
from groundslab.model.shapes import Rectangle
from groundslab.model.varying_ground import Borehole, SoilZone
from helpers.examples import examples
from helpers.nodes import nodes_at
from helpers.strategies import MODULI_OF_SOIL, POISSON, models, numbers

pytestmark = pytest.mark.slow

PLATE = Plate(length_x=6.0, length_y=4.0, thickness=0.25, E=30e9, nu=0.2)
STIFF, SOFT = SoilLayer(E=90e6, nu=0.25, thickness=4.0), SoilLayer(E=30e6, E_bottom=50e6, nu=0.4, thickness=3.0)
GROUNDS = {
    "winkler": Winkler(k=20e6),
    "pasternak": Pasternak(k0=30e6, k1=20e6),
    "interface": Layered(
        coupling="interface", layers=[InterfaceLayer(k0=40e6, k1=15e6), InterfaceLayer(k0=60e6, k1=30e6)]
    ),
    "consistent": Layered(coupling="consistent", layers=[SOFT, STIFF]),
    "vlasov": Vlasov(layers=[SOFT]),
    "profile": Vlasov(layers=[SOFT, STIFF]),
    "interface of soil": Layered(coupling="interface", layers=[SOFT, STIFF]),
    "given gamma": Vlasov(layers=[STIFF], gamma=1.3),
}
EVERYWHERE = Rectangle(x=(-500.0, 500.0), y=(-500.0, 500.0))
LEFT = Rectangle(x=(-500.0, 0.0), y=(-500.0, 500.0))


def model(ground: Any, **keys: Any) -> Model:
    """Return a plate of 6 x 4 m in 6 x 4 elements under a load that lifts a corner, infinite ground beyond if any."""
    beyond = Beyond() if isinstance(ground, Winkler) else Beyond(kind="infinite")
    loads = [PointLoad(P=2e5, x=2.0, y=1.0), UniformLoad(q=1e4)]
    mesh = Mesh(counts=(6, 4), symmetry="off")
    return Model(**{"plate": PLATE, "ground": ground, "loads": loads, "mesh": mesh, "beyond": beyond, **keys})


def times(ground: Any, factor: float) -> Any:
    """Return the same ground, so many times as stiff."""
    if isinstance(ground, Winkler):
        return ground.replace(k=ground.k * factor)
    if isinstance(ground, Pasternak):
        return ground.replace(k0=ground.k0 * factor, k1=ground.k1 * factor)

    def layer(one: Any) -> Any:
        if isinstance(one, InterfaceLayer):
            return one.replace(k0=one.k0 * factor, k1=one.k1 * factor)
        return one.replace(E=one.E * factor, E_bottom=None if one.E_bottom is None else one.E_bottom * factor)

    return ground.replace(layers=[layer(one) for one in ground.layers])


@pytest.mark.parametrize("ground", GROUNDS.values(), ids=GROUNDS.keys())
def test_zones_of_the_same_soil_change_nothing(ground: Any) -> None:
    """Ground cut into zones of one soil gives the same digits; soil that differs by 1e-9 changes no more than that.

    On springs a node on the border of zones stands there for each side.
    """
    plain = solve(model(ground))
    cut = solve(model(ground, soil_zones=[SoilZone(shape=LEFT, ground=ground)]))
    same = nodes_at(cut.plate, plain.plate.nodes)
    np.testing.assert_array_equal(cut.plate.settlement[same], plain.plate.settlement)
    np.testing.assert_allclose(cut.plate.pressure[same], plain.plate.pressure, rtol=1e-12, atol=1e-9)
    assert cut.constants == plain.constants
    near = solve(model(ground, soil_zones=[SoilZone(shape=LEFT, ground=times(ground, 1 + 1e-9))]))
    scale = np.abs(plain.plate.settlement).max()
    same = nodes_at(near.plate, plain.plate.nodes)
    np.testing.assert_allclose(near.plate.settlement[same] / scale, plain.plate.settlement / scale, atol=1e-7)
    np.testing.assert_allclose(near.constants.k0, plain.constants.k0, rtol=1e-6)
    np.testing.assert_allclose(near.constants.k1, plain.constants.k1, rtol=1e-6)


@pytest.mark.parametrize("ground", GROUNDS.values(), ids=GROUNDS.keys())
def test_a_zone_over_all_is_the_ground(ground: Any) -> None:
    """A zone under and around the whole plate takes the place of [ground]."""
    whole = solve(model(times(ground, 0.4), soil_zones=[SoilZone(shape=EVERYWHERE, ground=ground)], beyond=Beyond()))
    plain = solve(model(ground, beyond=Beyond()))
    np.testing.assert_array_equal(whole.plate.settlement, plain.plate.settlement)


@pytest.mark.parametrize("ground", GROUNDS.values(), ids=GROUNDS.keys())
def test_a_plate_sinks_deeper_where_the_soil_is_softer(ground: Any) -> None:
    """With softer soil under its left half the plate sinks more there, and is certified; the mirror image is exact."""
    even = {"loads": [UniformLoad(q=1e4)]}
    soft = [SoilZone(shape=LEFT, ground=times(ground, 0.5))]
    half = solve(model(ground, soil_zones=soft, **even))
    plain = solve(model(ground, **even))
    assert half.certificate.ground_balance < 1e-9
    assert half.plate.value_at("settlement", -3.0, 0.0) > 1.3 * plain.plate.value_at("settlement", -3.0, 0.0)
    assert half.plate.value_at("settlement", -3.0, 0.0) > 1.2 * half.plate.value_at("settlement", 3.0, 0.0)
    mirrored = [SoilZone(shape=LEFT, ground=ground)]
    other = solve(model(times(ground, 0.5), soil_zones=mirrored, **even))
    for x, y in ((-3.0, 0.0), (-1.0, 2.0), (0.0, 0.0), (2.5, -1.5)):
        w = half.plate.value_at("settlement", x, y)
        assert other.plate.value_at("settlement", -x, y) == pytest.approx(w, rel=1e-7)


@pytest.mark.parametrize("name", ["consistent", "vlasov", "profile", "interface of soil"])
def test_boreholes_far_apart_hold_where_they_are(name: str) -> None:
    """A plate near one of two boreholes that are far apart settles as if that one held everywhere."""
    ground = GROUNDS[name]
    other = times(ground, 0.5)
    holes = [Borehole(x=0.0, y=0.0, layers=ground.layers), Borehole(x=1e6, y=0.0, layers=other.layers)]
    near, plain = solve(model(ground, boreholes=holes)), solve(model(ground))
    scale = plain.plate.settlement.max()
    np.testing.assert_allclose(near.plate.settlement / scale, plain.plate.settlement / scale, atol=2e-5)


@st.composite
def like(draw: st.DrawFn, layer: SoilLayer) -> SoilLayer:
    """Return a layer with other numbers, its modulus constant, linear or quadratic as that of the given one."""
    bottom = {} if layer.E_bottom is None else {"E_bottom": draw(MODULI_OF_SOIL)}
    return layer.replace(E=draw(MODULI_OF_SOIL), nu=draw(POISSON), thickness=draw(st.floats(0.5, 8.0)), **bottom)


@st.composite
def varying(draw: st.DrawFn) -> Model:
    """Return whole descriptions whose ground varies, by zones or between boreholes."""
    model = draw(models())
    ground = model.ground
    place = numbers(-10.0, 10.0)
    by_soil = isinstance(ground, Vlasov | Layered) and all(isinstance(layer, SoilLayer) for layer in ground.layers)
    if by_soil and getattr(ground, "formulas", "") == "exact" and draw(st.booleans()):
        places = draw(st.lists(st.tuples(place, place), min_size=1, max_size=5, unique=True))
        holes = [Borehole(x=x, y=y, layers=[draw(like(layer)) for layer in ground.layers]) for x, y in places]
        return model.replace(boreholes=holes)
    zones = []
    for factor in draw(st.lists(st.floats(0.1, 10.0), min_size=1, max_size=3)):
        x, y = sorted([draw(place), draw(place)]), sorted([draw(place), draw(place)])
        shape = Rectangle(x=(x[0], x[1] + 0.1), y=(y[0], y[1] + 0.1))
        soft = ground if isinstance(ground, Winkler) and ground.k is None else times(ground, factor)
        zones.append(SoilZone(shape=shape, ground=soft))
    return model.replace(soil_zones=zones)


@settings(
    max_examples=examples(30), deadline=None, derandomize=True, database=None, suppress_health_check=list(HealthCheck)
)
@given(varying())
def test_varying_ground_ends_in_a_certified_result_or_a_clear_error(model: Model) -> None:
    """Zones and boreholes anywhere, of any layers, neither crash nor warn nor give an uncertified result."""
    try:
        results = solve(model)
    except GroundslabError as error:
        said, results = str(error), None
    if results is None:
        assert len(said) > 20
    else:
        assert results.certificate.holds
        assert np.isfinite(results.plate.settlement).all()


@settings(max_examples=examples(25), deadline=None, derandomize=True, database=None)
@given(
    st.sampled_from(["consistent", "profile", "vlasov", "interface of soil", "given gamma"]),
    st.lists(
        st.tuples(numbers(-9, 9), numbers(-9, 9), st.floats(0.2, 5.0), st.floats(0.5, 2.0)),
        min_size=2,
        max_size=6,
        unique_by=lambda hole: hole[:2],
    ),
    st.sampled_from(["none", "infinite"]),
)
def test_boreholes_anywhere(name: str, places: list[tuple[float, float, float, float]], beyond: Any) -> None:
    """However boreholes lie and differ, the result is certified, unless a layer ends between them."""
    ground = GROUNDS[name]
    holes = [
        Borehole(
            x=x, y=y, layers=[each.replace(thickness=each.thickness * h) for each in times(ground, stiffness).layers]
        )
        for x, y, stiffness, h in places
    ]
    described = model(ground, boreholes=holes, beyond=Beyond(kind=beyond), mesh=Mesh(counts=(6, 4)))
    try:
        results = solve(described)
    except InputError as error:
        issues = error.issues
    else:
        assert results.certificate.holds
        return
    assert {issue.location for issue in issues} == {"boreholes"}


@settings(max_examples=examples(10), deadline=None, derandomize=True, database=None)
@given(st.floats(0.1, 10.0), st.floats(0.1, 10.0))
def test_stiffer_soil_anywhere_stores_less_work(left: float, right: float) -> None:
    """Glued to its ground, a plate under one force sinks less under it if any zone is made stiffer (Rayleigh)."""
    force = {"loads": [PointLoad(P=1e5, x=2.0, y=1.0)], "contact": Contact(tensionless=False)}

    def under_the_force(a: float, b: float) -> float:
        ground = times(GROUNDS["consistent"], b)
        zones = [SoilZone(shape=LEFT, ground=times(GROUNDS["consistent"], a))]
        solved = solve(model(ground, soil_zones=zones, beyond=Beyond(), **force))
        return solved.plate.value_at("settlement", 2.0, 1.0)

    w = under_the_force(left, right)
    assert under_the_force(1.5 * left, right) < w
    assert under_the_force(left, 1.5 * right) < w
