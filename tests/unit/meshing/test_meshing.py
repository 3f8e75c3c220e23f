"""Meshes of plans: areas, arcs, conformity, what must be a node, quality, and how the mesher says no."""

from __future__ import annotations

import builtins
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from groundslab import meshing
from groundslab.errors import InputError, Issue
from groundslab.fem.hanging import find_hanging
from groundslab.fem.mesh import sides_on_boundary
from groundslab.geometry.plan import Plan, Ring, circle, rectangle
from groundslab.geometry.regions import GROUND
from groundslab.meshing import adaptable, mesh, quality, unstructured
from groundslab.meshing.backends import Maker, with_gmsh
from groundslab.meshing.cells import Cells
from groundslab.meshing.gmsh import session
from groundslab.meshing.grid import rectilinear
from helpers.plans import ALL, FREE, GRIDS, MAKERS, OBLIQUE, SIDES, areas, boundary, holds, meshed, needs_gmsh

each_maker = pytest.mark.parametrize("maker", MAKERS)


@pytest.mark.slow
@pytest.mark.parametrize(("plan", "maker"), ALL)
def test_mesh_is_whole(plan: Plan, maker: Maker | None) -> None:
    """Areas are right, sides and their middles are shared by two elements, no node is double or unused."""
    result = meshed(plan, maker)
    straight = all(ring.straight for ring in plan.rings().values())
    wanted = plan.area if plan.beyond is None else plan.beyond.area
    shift = 1e-10 * (np.abs(result.nodes).max() / plan.extent) + 1e-12
    assert areas(result).sum() == pytest.approx(wanted, rel=shift if straight else 1e-4)
    assert areas(result)[result.section >= 0].sum() == pytest.approx(plan.area, rel=shift if straight else 1e-4)
    assert (areas(result) > 0).all()
    sides = result.elements[:, SIDES].reshape(-1, 3)
    ends = np.sort(sides[:, :2], axis=1)
    assert max(Counter(map(tuple, ends.tolist())).values()) == 2
    assert len(np.unique(ends, axis=0)) == len(np.unique(np.sort(sides, axis=1), axis=0)) == len(np.unique(sides[:, 2]))
    assert set(result.elements.ravel().tolist()) == set(range(len(result.nodes)))
    near = np.round(result.nodes / (1e-8 * plan.extent))
    assert len(np.unique(near, axis=0)) == len(result.nodes)
    # nodes and elements of a plane region with holes: V - E + F = 1 - holes
    holes = 0 if plan.beyond is not None else len(plan.openings)
    corners = len(np.unique(result.elements[:, :4]))
    assert corners - len(np.unique(ends, axis=0)) + len(result.elements) == 1 - holes


@pytest.mark.slow
@pytest.mark.parametrize(("plan", "maker"), ALL)
def test_what_is_asked_for_is_a_node(plan: Plan, maker: Maker | None) -> None:
    """Corners, points and ends of lines are nodes; along lines there are sides of elements."""
    result = meshed(plan, maker)
    assert all(holds(result, point) for point in plan.outline.points + plan.points)
    assert all(holds(result, point) for ring in plan.openings for point in ring.points)
    for line in plan.line_segments():
        on_it = np.flatnonzero(line.distance(result.nodes) <= 1e-9)
        sides = result.elements[:, SIDES].reshape(-1, 3)
        along = np.unique(np.sort(sides[np.isin(sides, on_it).all(axis=1)], axis=1), axis=0)
        ends = result.nodes[along[:, :]]
        length = np.ptp(ends, axis=1)
        assert np.hypot(length[:, 0], length[:, 1]).sum() == pytest.approx(line.length)


@pytest.mark.slow
@pytest.mark.parametrize(("plan", "maker"), ALL)
def test_elements_are_good(plan: Plan, maker: Maker | None) -> None:
    """No scaled Jacobian is below 0.35, and the quality names the worst place."""
    result = meshed(plan, maker)
    assert result.quality.worst > 0.35
    assert result.quality.median > 0.9
    assert holds(result, result.quality.worst_place)


@pytest.mark.slow
@each_maker
def test_all_boundary_nodes_lie_on_the_circles(maker: Maker) -> None:
    """Corner and midside nodes on arcs are exactly there; so the area is right to the fourth order."""
    result = meshed(FREE["ring"], maker)
    outer = np.linalg.norm(result.nodes - [0, 0], axis=1)[boundary(result)]
    inner = np.linalg.norm(result.nodes - [1.5, 0.5], axis=1)[boundary(result)]
    off = np.minimum(np.abs(outer / 5 - 1), np.abs(inner / 1.2 - 1))
    assert off.max() < 1e-12
    assert (np.abs(outer / 5 - 1) < 1e-12).sum() > 40
    coarse, fine = (
        areas(mesh(FREE["circle"], size, maker=maker)).sum() / FREE["circle"].area - 1 for size in (0.5, 0.25)
    )
    assert abs(fine) < abs(coarse) / 10


@pytest.mark.slow
@each_maker
def test_sections_have_their_areas(maker: Maker) -> None:
    """Zones are met exactly: where they overlap the last counts, and openings are taken off."""
    result = meshed(FREE["zones"], maker)
    import shapely

    first, second = circle((5, 4), 2).polygon(1e-7), rectangle(0, 6, 0, 2.5).polygon(1)
    plate = OBLIQUE.polygon(1)
    opening = circle((5, 4), 1).polygon(1e-7)
    wanted = {1: first - second - opening, 2: second & plate}
    for number, shape in wanted.items():
        assert areas(result)[result.section == number].sum() == pytest.approx(shapely.area(shape), rel=1e-4)
    ground = meshed(FREE["ground"], maker)
    assert set(ground.section.tolist()) == {GROUND, 0, 2}


@pytest.mark.slow
@each_maker
def test_elements_follow_what_is_small_and_grow_outside(maker: Maker) -> None:
    """Elements are small at a small opening, near the wanted size elsewhere, and large on the ground far away."""
    result = mesh(FREE["small opening"], 0.5, maker=maker)
    side = np.sqrt(areas(result))
    away = np.linalg.norm(result.nodes[result.elements[:, 8]] - [3, 3], axis=1)
    assert side[away < 0.2].max() < 0.12
    assert 0.3 < np.median(side[away > 3]) < 0.6
    ground = mesh(FREE["ground"], 0.5, maker=maker)
    side = np.sqrt(areas(ground))
    away = np.linalg.norm(ground.nodes[ground.elements[:, 8]], axis=1)
    assert np.median(side[away > 13]) > 1.5 * np.median(side[(away > 3) & (away < 5)])
    slow = mesh(FREE["ground"], 0.5, beyond_growth=100.0, maker=maker)
    assert len(slow.elements) > 1.5 * len(ground.elements)


@pytest.mark.slow
@each_maker
@pytest.mark.parametrize("name", ["zones", "ground"])
def test_the_same_plan_gives_the_same_mesh(name: str, maker: Maker) -> None:
    """Twice the same, to the last bit, whatever was meshed between."""
    first = mesh(FREE[name], 0.4, maker=maker)
    mesh(FREE["circle"], 1.0, maker=maker)
    again = mesh(FREE[name], 0.4, maker=maker)
    np.testing.assert_array_equal(first.nodes, again.nodes)
    np.testing.assert_array_equal(first.elements, again.elements)


@needs_gmsh
def test_a_session_of_the_caller_is_left_alone() -> None:
    """Who uses Gmsh already keeps model and options; else it is left as if never used."""
    import gmsh

    mesh(FREE["circle"], 1.0, maker=with_gmsh)
    assert not gmsh.isInitialized()
    gmsh.initialize([], False, False, False)
    try:
        gmsh.model.add("mine")
        gmsh.option.setNumber("Mesh.Algorithm", 5)
        mesh(FREE["circle"], 1.0, maker=with_gmsh)
        assert gmsh.model.getCurrent() == "mine"
        assert gmsh.option.getNumber("Mesh.Algorithm") == 5
    finally:
        gmsh.finalize()


@pytest.mark.slow
@each_maker
def test_rectilinear_plans_can_be_meshed_freely(maker: Maker) -> None:
    """The free mesher takes what the grid takes, with the same areas."""
    plan = GRIDS["L with ground"]
    result = unstructured(plan, 0.5, maker=maker)
    assert areas(result)[result.section == 1].sum() == pytest.approx(15, rel=1e-9)
    assert areas(result)[result.section >= 0].sum() == pytest.approx(plan.area, rel=1e-9)


def test_grid_is_graded() -> None:
    """No side exceeds the size, neighbours of lines are similar, and outside the plate elements grow."""
    plan = Plan(rectangle(0, 10, 0, 8), (rectangle(4.0, 4.1, 3, 5),), beyond=rectangle(-40, 10, -3, 8))
    result = rectilinear(plan, 0.7)
    assert (result.section == GROUND).any()
    lines = np.unique(result.nodes[result.elements[:, :4], 0])
    steps = np.diff(lines)
    assert steps[lines[:-1] >= 0].max() <= 0.7 * (1 + 1e-9)
    assert steps[0] > 3
    ratio = steps[1:] / steps[:-1]
    assert max(ratio.max(), 1 / ratio.min()) < 2.5
    plain = rectilinear(Plan(rectangle(0, 10, 0, 8)), 0.7)
    assert len(plain.elements) == 15 * 12
    assert np.ptp(np.diff(np.unique(plain.nodes[:, 0]))) < 1e-14


def test_quality_of_known_elements() -> None:
    """A rectangle has 1, a parallelogram the sine of its angle, an element turned inside out less than 0."""
    corner = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])

    def nine(corner: np.ndarray) -> np.ndarray:
        return np.vstack([corner, (corner + np.roll(corner, -1, axis=0)) / 2, corner.mean(axis=0)])[None]

    assert quality(nine(corner * [5, 0.1])).worst == pytest.approx(1)
    assert quality(nine(corner @ np.array([[1, 0], [np.cos(0.7), np.sin(0.7)]]))).worst == pytest.approx(np.sin(0.7))
    assert quality(nine(corner * [1, -1])).worst == pytest.approx(-1)
    crooked = nine(corner)
    crooked[0, 4] = [0.9, -1]
    assert quality(crooked).worst < 0


@pytest.mark.parametrize("size", [0.0, -1.0, np.nan, np.inf, 1e-9])
def test_sizes_that_make_no_mesh(size: float) -> None:
    """A size must be positive and leave a number of elements that a computer can hold."""
    with pytest.raises(InputError, match=r"mesh\.size"):
        mesh(GRIDS["L with opening"], size)


def test_wrong_plans_are_refused() -> None:
    """Faults of the plan are raised before anything is meshed."""
    with pytest.raises(InputError, match="crosses or touches itself"):
        mesh(Plan(Ring(((0, 0), (2, 2), (2, 0), (0, 2)))), 0.1)
    with pytest.raises(InputError, match="oblique"):
        rectilinear(FREE["circle"], 0.1)
    with pytest.raises(InputError, match="beyond_growth"):
        mesh(GRIDS["L with ground"], 0.5, beyond_growth=0.0)


@pytest.mark.parametrize(
    ("error", "said"),
    [
        (ModuleNotFoundError("no"), r"^mesh: found a plan with oblique edges or arcs, expected Gmsh or Netgen"),
        (OSError("libGLU.so.1"), r"a Gmsh that cannot be loaded \(libGLU.so.1\).*libglu1-mesa"),
    ],
)
def test_without_meshers_it_says_what_to_install(error: Exception, said: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Without both packages their extras are named, and the system's libraries for Gmsh; grids need neither."""
    load = builtins.__import__

    def without(name: str, *rest: Any) -> Any:
        if name == "gmsh":
            raise error
        if name.startswith("netgen"):
            raise ModuleNotFoundError(name)
        return load(name, *rest)

    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(InputError, match=said) as refused:
        mesh(FREE["circle"], 0.5)
    assert "groundslab[mesh]" in str(refused.value)
    assert "groundslab[netgen]" in str(refused.value)
    assert len(mesh(GRIDS["L with opening"], 0.5).elements) > 100


@needs_gmsh
def test_what_gmsh_says_becomes_our_error() -> None:
    """An exception of Gmsh is an error of the input, and the session is closed all the same."""
    import gmsh

    with pytest.raises(InputError, match="Gmsh refuses"), session() as opened:
        opened.model.occ.addPlaneSurface([99])
    assert not gmsh.isInitialized()


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="signals of this kind are POSIX")
@pytest.mark.parametrize("thread", [False, True], ids=["main thread", "another thread"])
def test_a_broken_pipe_stays_an_error(thread: bool) -> None:
    """After a session of Gmsh, which sets the signal itself, writing to nobody is an error, not the program's end."""
    pytest.importorskip("gmsh")
    program = (
        "import os, threading\nfrom groundslab.meshing import gmsh as backend\n"
        "def use():\n    with backend.session():\n        pass\n"
        + ("t = threading.Thread(target=use)\nt.start()\nt.join()\n" if thread else "use()\n")
        + "a, b = os.pipe()\nos.close(a)\n"
        "try:\n    os.write(b, b'x')\nexcept BrokenPipeError:\n    print('still here')\n"
    )
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert (run.returncode, run.stdout) == (0, "still here\n")


@pytest.mark.parametrize("maker", [None, *MAKERS])
def test_smaller_elements_in_places(maker: Maker | None) -> None:
    """Elements near a place have the size there, others far from it the one of all; between them they grow."""
    plan = Plan(rectangle(0, 8, 0, 6)) if maker is None else Plan(circle((4, 3), 3))
    local = np.array([(4.0 + dx, 3.0 + dy) for dx in (-0.1, 0.0, 0.1) for dy in (-0.1, 0.0, 0.1)]), np.full(9, 0.1)
    result = mesh(plan, 0.8, maker=maker, local=local)
    middle, side = result.nodes[result.elements[:, 8]], np.sqrt(areas(result))
    distance = np.hypot(*(middle - [4.0, 3.0]).T)
    assert side[distance.argmin()] < 0.15
    assert side.max() > 0.4
    assert (side < 1.5 * (0.1 + 0.5 * distance)).all()


def test_few_elements_are_cut_for_small_places() -> None:
    """No line runs through the whole plan for them, and from one element to the next no side is halved twice."""
    plan = Plan(rectangle(0, 20, 0, 20))
    places = np.random.default_rng(1).uniform(1, 19, (12, 2))
    found = mesh(plan, 1.0, local=(places, np.full(12, 0.05)))
    assert len(found.elements) < 400 + 12 * 5 * 3 * 16
    assert quality(found.nodes[found.elements]).worst == pytest.approx(1.0)
    hanging = find_hanging(found.elements)
    assert len(hanging)
    ends, middles = found.nodes[hanging[:, [1, 3]]].mean(axis=1), found.nodes[hanging[:, 2]]
    np.testing.assert_allclose(ends, middles, atol=1e-12)
    np.testing.assert_allclose(found.nodes[hanging[:, 1:3]].mean(axis=1), found.nodes[hanging[:, 0]], atol=1e-12)
    assert not np.isin(hanging[:, 0], found.elements[:, :4]).any()


def test_a_plan_that_the_maker_refuses_has_a_grid(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where everything runs along x and y; where it does not, the refusal is told."""

    def refuse(*_: object) -> Iterator[Cells]:
        raise InputError([Issue("plan", "a plan", "another one")])
        yield

    monkeypatch.setattr(meshing, "choose", lambda: refuse)
    monkeypatch.setattr(meshing, "available", lambda: True)
    found = adaptable(Plan(rectangle(0, 4, 0, 3)), 1.0, 1.0, None)
    assert len(found.elements) == 12
    with pytest.raises(InputError, match="another one"):
        adaptable(Plan(circle((0, 0), 3)), 1.0, 1.0, None)


@pytest.mark.parametrize("maker", MAKERS)
def test_nodes_on_the_rim_are_exactly_there(maker: Maker) -> None:
    """Where ground beyond ends, further ground begins, and what is found there may not hang on rounding."""
    rng = np.random.default_rng(3)
    for width in rng.uniform(1, 4, 5):
        rim = rectangle(-width, 12 + width, -width, 9 + width)
        result = unstructured(Plan(OBLIQUE, beyond=rim), 1.5, maker=maker)
        sides = result.nodes[sides_on_boundary(result.elements)]
        on_rim = [
            (sides[:, :, axis] == value).all(axis=1) for axis, value in zip((0, 0, 1, 1), rim.bounds, strict=True)
        ]
        assert np.any(on_rim, axis=0).all()


@needs_gmsh
def test_what_gmsh_yields_last_are_triangles() -> None:
    """They can be used where quadrilaterals are turned inside out."""
    *_, last = with_gmsh(Plan(OBLIQUE), 1.0, (np.zeros((0, 2)), np.zeros(0)), 5.0)
    assert len(last.quadrilaterals) == 0
    assert len(last.triangles) > 20

    def alone(*_: Any) -> Iterator[Cells]:
        yield last

    assert unstructured(Plan(OBLIQUE), 1.0, maker=alone).quality.worst > 0.3
