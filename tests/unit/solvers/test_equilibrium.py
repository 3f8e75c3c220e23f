"""Whether equilibrium is possible at all, against a linear program that looks for the pressures."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import linprog

from groundslab.analysis.driver import solve
from groundslab.discretize.discretize import discretize
from groundslab.errors import NeutralEquilibrium, NoEquilibrium
from groundslab.fem.problem import BETA_X
from groundslab.model.ground import Winkler
from groundslab.model.loads.load_types import PatchLoad, PointLoad, TemperatureLoad, UniformLoad
from groundslab.model.model import Model
from groundslab.model.plate import Edges, Plate
from groundslab.model.settings import Contact, Mesh
from groundslab.model.shapes import Circle
from groundslab.model.supports import PointSupport
from groundslab.solvers.equilibrium import require_equilibrium
from helpers.examples import examples

LX, LY = 6.0, 4.0


def model(loads: list[Any], edges: Edges | None = None, **keys: Any) -> Model:
    """Return a plate of 6 x 4 m on springs."""
    element = keys.pop("element", "mitc9")
    return Model(
        plate=Plate(length_x=LX, length_y=LY, thickness=0.2, E=30e9, nu=0.2, element=element, edges=edges or Edges()),
        ground=Winkler(k=20e6),
        loads=loads,
        mesh=Mesh(counts=keys.pop("counts", (4, 4)), symmetry=keys.pop("symmetry", "auto")),
        contact=Contact(**keys),
    )


def possible(described: Model) -> bool:
    """Return whether the module lets the model pass."""
    try:
        require_equilibrium(discretize(described))
    except NoEquilibrium:
        return False
    return True


def point(P: float, x: float, y: float) -> PointLoad:
    """Return a point load."""
    return PointLoad(P=P, x=x, y=y)


@pytest.mark.parametrize("element", ["mitc9", "q9", "heterosis"])
@pytest.mark.parametrize(
    ("x", "y", "allowed"),
    [
        (0, 0, True),
        (2.99, 0, True),
        (2.99, 1.99, True),
        (-2.999, 1.999, True),
        (3, 0, False),
        (3, 2, False),
        (0, -2, False),
    ],
)
def test_a_force_inside_stands_and_on_the_edge_topples(element: str, x: float, y: float, allowed: bool) -> None:
    """Pressure needs room on both sides of the resultant: within the plate it stands, right on its edge it does not."""
    assert possible(model([point(1e5, x, y)], element=element)) is allowed


def test_the_resultant_counts_not_each_load() -> None:
    """Two loads of which one pulls: the resultant decides, inside as well as far outside the plate."""
    assert possible(model([point(2e5, 2.0, 0), point(-1e5, 1.5, 1.0)]))
    assert not possible(model([point(2e5, 2.0, 0), point(-1e5, -2.0, 0)]))
    assert not possible(model([point(2e5, 1.0, 1.5), point(-1e5, -1.0, 0)]))


def test_uplift_is_told_apart_from_toppling() -> None:
    """A net pull is reported as such with the sum of the loads, an eccentric push with the place of the resultant."""
    with pytest.raises(NoEquilibrium, match=r"do not press the plate down.* -30 kN"):
        require_equilibrium(discretize(model([point(1e4, 0, 0), point(-4e4, 1, 1)])))
    with pytest.raises(NoEquilibrium, match=r"topple.* 10 kN acts at x = 5 m, y = 1 m"):
        require_equilibrium(discretize(model([point(2e4, 2, 0), point(-1e4, -1, -1)])))


def test_a_place_that_is_zero_but_for_rounding_is_zero() -> None:
    """0.1 + 0.2 - 0.3 is not quite 0 in a computer; the resultant of such loads acts at x = 0 m all the same."""
    loads = [point(1e4, 0.1, 1.5), point(1e4, 0.2, 1.5), point(1e4, -0.3, 1.5), point(-1e4, 0, -1.9)]
    with pytest.raises(NoEquilibrium, match=r"topple.* 20 kN acts at x = 0 m, y = 3\.2 m"):
        require_equilibrium(discretize(model(loads)))


def test_whole_loads_are_named_when_a_quarter_is_meshed() -> None:
    """The message gives the sum over the whole plate, not over the meshed part."""
    with pytest.raises(NoEquilibrium, match=r"-24 kN"):
        require_equilibrium(discretize(model([UniformLoad(q=-1e3)])))
    with pytest.raises(NoEquilibrium, match=r"-24 kN"):
        require_equilibrium(discretize(model([UniformLoad(q=-1e3)], symmetry="off")))


def test_balanced_pull_and_push_do_not_stand() -> None:
    """Loads that sum to zero leave nothing to press the plate down, with or without a moment."""
    assert not possible(model([point(1e5, 1, 0), point(-1e5, -1, 0)]))
    assert not possible(model([PatchLoad(q=1e3, x=(-1, 1), y=(-1, 1)), point(-4e3, 0, 0)]))


def test_glued_to_the_ground_everything_stands() -> None:
    """Ground that can pull holds any load."""
    assert possible(model([point(-1e5, 3.0, 2.0)], tensionless=False))


@pytest.mark.parametrize("support", ["clamped"])
def test_a_clamped_edge_holds_everything(support: str) -> None:
    """With no rigid motion left there is nothing to ask of the ground."""
    assert possible(model([point(-1e5, 2.9, 1.9)], Edges(left=support)))


@pytest.mark.parametrize("support", ["soft", "hinged"])
def test_moment_about_a_hinged_edge_decides(support: str) -> None:
    """Held along x = -3 the plate stands exactly if the loads press it down about that edge."""
    held = Edges(left=support)
    assert possible(model([point(1e5, 2.9, 0)], held))
    assert possible(model([point(1e5, 3.0, 2.0)], held))
    assert not possible(model([point(-1e5, 2.9, 0)], held))
    # 2 kN down at 1 m from the edge against 1 kN up at 3 m, then at 1.5 m
    assert not possible(model([point(2e3, -2, 0), point(-1e3, 0, 0)], held))
    assert possible(model([point(2e3, -2, 0), point(-1e3, -1.5, 0)], held))
    # net uplift is no matter as long as the moment is right
    assert possible(model([point(1e3, 3, 0), point(-3e3, -2.0, 0)], held))


def test_two_opposite_edges_hold_everything() -> None:
    """Supports on two edges leave no rigid motion."""
    assert possible(model([point(-1e5, 0, 0)], Edges(left="soft", right="soft")))
    assert possible(model([point(-1e5, 0, 0)], Edges(left="soft", bottom="soft")))


def supported(side: str, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Return which points lie on a side of the plate."""
    return {"left": x == -LX / 2, "right": x == LX / 2, "bottom": y == -LY / 2, "top": y == LY / 2}[side]


@pytest.mark.slow
@settings(max_examples=examples(40), derandomize=True, deadline=None)
@given(seed=st.integers(0, 100_000), side=st.sampled_from([None, "left", "right", "bottom", "top"]))
def test_decision_equals_a_linear_program(seed: int, side: str | None) -> None:
    """Random pushes and pulls: the plate stands exactly where pressures all greater than zero balance the loads.

    The program looks for forces at 5 x 5 points, free in sign on a supported edge, and makes the least one elsewhere
    as large as it can.
    """
    rng = np.random.default_rng(seed)
    P = rng.choice([1.0, 1.0, -0.7], 3) * rng.uniform(0.5, 2.0, 3)
    px, py = rng.uniform(-LX / 2, LX / 2, 3), rng.uniform(-LY / 2, LY / 2, 3)
    edges = Edges(**{side: "soft"}) if side else Edges()
    described = model([point(float(p), float(a), float(b)) for p, a, b in zip(P, px, py, strict=True)], edges)

    x, y = (a.ravel() for a in np.meshgrid(np.linspace(-LX / 2, LX / 2, 5), np.linspace(-LY / 2, LY / 2, 5)))
    held = supported(side, x, y) if side else np.zeros(25, dtype=bool)
    balance = np.column_stack([np.vstack([np.ones(25), x, y]), np.zeros(3)])
    wanted = [P.sum(), P @ px, P @ py]
    least = np.column_stack([-np.eye(25)[~held], np.ones((~held).sum())])
    bounds = [(None, None)] * 25 + [(None, 1.0)]
    found = linprog(np.r_[np.zeros(25), -1.0], least, np.zeros((~held).sum()), balance, wanted, bounds=bounds)
    assert found.status == 0
    assert possible(described) is bool(found.x[-1] > 1e-7)


@pytest.mark.parametrize("symmetry", ["auto", "off"])
def test_symmetry_makes_no_difference(symmetry: str) -> None:
    """The same verdicts whether a quarter, a half or the whole plate is meshed."""
    assert possible(model([point(1e5, 0, 0)], symmetry=symmetry))
    assert possible(model([point(1e5, 3, 0), point(1e5, -3, 0)], symmetry=symmetry))
    assert not possible(model([point(-1e5, 0, 0)], symmetry=symmetry))
    assert not possible(model([point(1e5, 0, 2)], symmetry=symmetry))
    assert possible(model([point(1e5, 0, 1.9)], symmetry=symmetry))
    assert possible(model([UniformLoad(q=1e3), PatchLoad(q=-1e3, x=(-2, 2), y=(-1, 1))], symmetry=symmetry))
    held = Edges(left="soft", right="soft")
    assert possible(model([point(-1e5, 0, 0)], held, symmetry=symmetry))


@pytest.mark.parametrize(("moment", "allowed"), [(2.9e5, True), (3.1e5, False), (-2.9e5, True), (-3.1e5, False)])
@pytest.mark.parametrize("axis", [0, 1])
def test_moments_at_nodes_shift_the_resultant(axis: int, moment: float, allowed: bool) -> None:
    """A force of 100 kN in the middle and a moment of the load itself: it stands while M / F stays on the plate."""
    problem = discretize(model([point(1e5, 0, 0)], symmetry="off"))
    load = problem.load.copy()
    load[7, BETA_X + axis] = moment * (1.0 if axis == 0 else LY / LX)
    turned = replace(problem, loading=replace(problem.loading, load=load))
    if allowed:
        require_equilibrium(turned)
    else:
        with pytest.raises(NoEquilibrium, match="topple"):
            require_equilibrium(turned)


@pytest.mark.parametrize("factor", [1e-9, 1.0, 1e12])
def test_size_of_forces_does_not_matter(factor: float) -> None:
    """The verdict depends on where loads act, not on their units."""
    assert possible(model([point(factor, 2.9, 1.9)]))
    assert not possible(model([point(factor, 3.0, 1.9)]))


def hung(supports: list[dict[str, Any]], loads: list[Any], **keys: Any) -> Model:
    """Return a plate of 6 x 4 m on springs and supports."""
    plate = Plate(length_x=LX, length_y=LY, thickness=0.25, E=30e9, nu=0.2)
    points = [PointSupport(**support) for support in supports]
    return Model(plate=plate, ground=Winkler(k=20e6), loads=loads, supports=points, mesh=Mesh(size=0.5), **keys)


def pile(x: float, y: float, acts: str, **keys: Any) -> dict[str, Any]:
    """Return a support at a point."""
    return {"x": x, "y": y, "acts": acts, **keys}


@pytest.mark.slow
@pytest.mark.parametrize("size", [0.6, 0.5, 0.4])
def test_a_plate_that_hangs_on_one_pile_can_rock_about_it(size: float) -> None:
    """Uplift pulls a circle straight up on the pile in its middle: no force keeps it from tilting, on any mesh."""
    pytest.importorskip("gmsh")
    plate = Plate(outline=Circle(centre=(0, 0), radius=3), thickness=0.25, E=30e9, nu=0.2)
    support = PointSupport(x=0, y=0, stiffness=50e6, acts="in tension")
    described = Model(
        plate=plate, ground=Winkler(k=20e6), loads=[UniformLoad(q=-2e3)], supports=[support], mesh=Mesh(size=size)
    )
    with pytest.raises(NeutralEquilibrium, match=r"can rock about the point \(0, 0\) m in every direction"):
        solve(described)


@pytest.mark.parametrize(
    ("places", "line"),
    [
        ([(2, 0), (-2, 0)], "y = 0 m"),
        ([(1, 1.5), (1, -1.5)], "x = 1 m"),
        ([(2, 1), (-2, -1)], r"y = 0 m \+ 0\.5 x"),
    ],
)
def test_a_plate_on_two_piles_over_a_gap_can_rock_about_their_line(places: list[Any], line: str) -> None:
    """Its self-weight rests on two piles, if need be by a load that has the resultant between them."""
    middle = np.mean(places, axis=0)
    weight = UniformLoad(q=1e3)
    loads: list[Any] = [weight]
    if middle.any():
        loads = [PointLoad(P=20e3, x=float(middle[0]), y=float(middle[1]))]
    described = hung([pile(x, y, "in compression") for x, y in places], loads, contact=Contact(gap=0.1))
    with pytest.raises(NeutralEquilibrium, match=f"can rock about the line {line}"):
        solve(described)


def test_three_piles_hold_the_plate() -> None:
    """The same weight on three piles that are not on one line has one solution: each pile's share by statics."""
    described = hung(
        [pile(2, 0, "in compression"), pile(-2, 1, "in compression"), pile(-2, -1, "in compression")],
        [UniformLoad(q=1e3)],
        contact=Contact(gap=0.1),
    )
    forces = [support.total for support in solve(described).supports]
    np.testing.assert_allclose(forces, [12e3, 6e3, 6e3], rtol=1e-9)


def test_limits_that_are_short_are_named() -> None:
    """50 kN of uplift on two anchors of 20 kN each; then one anchor too weak for where the uplift acts."""
    anchors = [pile(2, 0, "in tension", limit=20e3), pile(-2, 0, "in tension", limit=20e3)]
    with pytest.raises(NoEquilibrium, match=r"lift the plate by 50 kN.*40 kN.*supports\[1\].limit and supports\[2\]"):
        solve(hung(anchors, [UniformLoad(q=-50e3 / 24)]))
    uneven = [pile(2, 0, "in tension", limit=10e3), pile(-2, 0, "in tension", limit=90e3)]
    # a share s of 25 kN up at each end, the ground pushing up with G at x = -3, moments about the left anchor:
    # 4 m x 10 kN + 1 m x G = 4 m x 25 kN s, and 10 kN + 90 kN = 50 kN s + G, hence s = 14 / 15
    loads = [PointLoad(P=-25e3, x=2, y=0), PointLoad(P=-25e3, x=-2, y=0)]
    with pytest.raises(NoEquilibrium, match=r"93.33 % of them bring supports\[1\]\.limit and supports\[2\]"):
        solve(hung(uneven, loads))


def test_a_load_that_supports_take_up_to_the_limit_is_balanced() -> None:
    """Just below both limits there is a solution, and the anchors carry what statics says."""
    anchors = [pile(x, y, "in tension", limit=20e3) for x in (-2, 2) for y in (-1, 1)]
    found = solve(hung(anchors, [UniformLoad(q=-79e3 / 24)]))
    assert found.certificate.holds
    assert sum(support.total for support in found.supports) <= -79e3 * (1 - 1e-9)


def test_temperature_alone_presses_between_supports_that_pull_and_the_ground() -> None:
    """Its couples have no resultant: a plate that anchors hold down warps against them, without any other load."""
    anchors = [pile(x, y, "in tension") for x in (-2, 2) for y in (-1, 1)]
    found = solve(hung(anchors, [TemperatureLoad(difference=-10.0)]))
    assert found.certificate.holds
    assert found.plate.contact_share > 0
    with pytest.raises(NoEquilibrium):
        solve(hung([], [TemperatureLoad(difference=-10.0)]))


def test_rounding_beside_what_rigid_supports_carry_does_not_fail_the_certificate() -> None:
    """A support pushed up by 3.8 mm takes some MN from its neighbors: the ground's 1e-10 N beside that is rounding."""
    found = solve(
        Model(
            plate={
                "length_x": 2, "length_y": 2, "thickness": 0.6864307576422247, "E": 1e10, "nu": 0, "element": "mitc9",
                "edges": {"right": "hinged"},
            },
            ground={
                "kind": "layered",
                "coupling": "consistent",
                "layers": [
                    {"E": 81460065.19668013, "E_bottom": 5e6, "variation": "linear", "nu": 0, "thickness": 3.512}
                ],
            },
            supports=[{"kind": "point", "name": "S1", "x": 0, "y": 0}, {"kind": "point", "x": 0.75, "y": 0}],
            loads=[{"kind": "uniform", "q": 1e3}, {"kind": "settlement", "support": "S1", "w": -0.0038}],
            mesh={"size": 0.5637530794220673},
            analysis={"nested": False},
        )
    )  # fmt: skip
    assert found.certificate.holds
