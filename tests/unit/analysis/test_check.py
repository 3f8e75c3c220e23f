"""What keeps a sound description from being solved is reported by `check` already."""

from __future__ import annotations

import time
from typing import Any

import pytest

from groundslab.analysis.check import check
from groundslab.analysis.driver import solve
from groundslab.case.casefile import to_toml
from groundslab.cli import main
from groundslab.errors import InputError
from groundslab.model.model import Model

PLATE = {"length_x": 6, "length_y": 4, "thickness": 0.25, "E": 30e9, "nu": 0.2}
SOIL = {"E": 2e7, "nu": 0.3, "thickness": 2}


def case(**changes: Any) -> dict[str, Any]:
    """Return a sound description with some parts changed."""
    return {
        "plate": PLATE,
        "ground": {"kind": "winkler", "k": 2e7},
        "loads": [{"kind": "uniform", "q": 1e4}],
        "mesh": {"size": 0.5},
        **changes,
    }


def line(y: float, **more: Any) -> dict[str, Any]:
    """Return a rigid support along x."""
    return {"kind": "line", "points": [(-3, y), (3, y)], **more}


ACROSS = {"kind": "line", "points": [(1, -2), (1, 2)]}


@pytest.mark.parametrize(
    ("changes", "where", "found"),
    [
        ({"supports": [line(0), {**ACROSS, "acts": "in compression"}]}, "supports[2]", "a rigid support that meets"),
        ({"supports": [line(0), {"kind": "point", "x": 1, "y": 0, "acts": "in tension"}]}, "supports[2]", "a rigid"),
        ({"supports": [line(0, name="a"), ACROSS],
          "loads": [{"kind": "uniform", "q": 1e4}, {"kind": "settlement", "support": "a", "w": 0.01}]},
         "supports[2]", "which acts or settles otherwise"),
        # (2.27) as printed is negative for a modulus that grows with the square of the depth
        ({"ground": {"kind": "vlasov", "gamma": 1.0, "formulas": "as printed",
                     "layers": [{**SOIL, "E": 1e7, "E_bottom": 1e8, "variation": "quadratic"}]}},
         "ground.formulas", '"as printed"'),
        ({"ground": {"kind": "vlasov", "formulas": "as printed",
                     "layers": [{**SOIL, "E": 1e7, "E_bottom": 1e8, "variation": "quadratic"}]}},
         "ground.formulas", '"as printed"'),
    ],
)  # fmt: skip
def test_refused_by_check_and_by_solve(changes: dict[str, Any], where: str, found: str) -> None:
    """What the arrays of the problem cannot be made of is refused in the same words before and in solving."""
    model = Model(**case(**changes))
    reported = []
    for work in (check, solve):
        with pytest.raises(InputError) as error:
            work(model)
        reported.append(error.value.issues)
    assert reported[0] == reported[1]
    assert reported[0][0].location == where
    assert found in reported[0][0].found


@pytest.mark.parametrize(
    ("changes", "where"),
    [
        ({"loads": [{"kind": "uniform", "q": 0}, {"kind": "point", "P": 0, "x": 0, "y": 0},
                    {"kind": "temperature", "difference": 0}, {"kind": "line", "q": 0, "points": [(0, 0), (1, 0)]}]},
         "loads"),
        ({"plate": {"outline": {"kind": "circle", "radius": 3}, "support": "hinged", "thickness": 0.3, "E": 3e10,
                    "nu": 0.2}}, "plate.support"),
        ({"plate": {"outline": {"kind": "polygon", "points": [(0, 0), (6, 0), (0, 4)]}, "support": "hinged",
                    "thickness": 0.3, "E": 3e10, "nu": 0.2}}, "plate.support"),
        ({"reinforcement": {"f_ck": 1e8, "f_yk": 5e8, "bottom": [0.04, 0.05], "top": [0.04, 0.05]}},
         "reinforcement.f_ck"),
        ({"reinforcement": {"f_ck": 3e7, "f_yk": 7e8, "bottom": [0.04, 0.05], "top": [0.04, 0.05]}},
         "reinforcement.f_yk"),
    ],
)  # fmt: skip
def test_refused_by_the_model(changes: dict[str, Any], where: str) -> None:
    """What a description alone says cannot be solved or designed is a issue of the description."""
    with pytest.raises(InputError) as error:
        Model(**case(**changes))
    assert [issue.location for issue in error.value.issues] == [where]


def test_moduli_between_boreholes_stay_positive() -> None:
    """A modulus that falls at one borehole and rises at another is positive everywhere between: no reason to refuse.

    Top and bottom are interpolated each by itself; with the top and the change it was below zero between these.
    """
    layers = [{**SOIL, "E": 1e8, "E_bottom": 1e6}, {**SOIL, "E": 1e6, "E_bottom": 1e8}, {**SOIL, "E": 2e7}]
    places = [(-6, 0), (6, 0), (0, 5)]
    holes = [{"x": x, "y": y, "layers": [layer]} for (x, y), layer in zip(places, layers, strict=True)]
    soil = {"kind": "layered", "coupling": "consistent", "layers": [SOIL]}
    model = Model(**case(ground=soil, boreholes=holes))
    check(model)
    assert solve(model).certificate.holds


def test_check_of_a_large_mesh_is_quick() -> None:
    """What takes millions of elements to solve is looked into on a coarser mesh."""
    model = Model(**case(mesh={"size": 0.004}, supports=[line(0), {**ACROSS, "acts": "in compression"}]))
    start = time.process_time()
    with pytest.raises(InputError, match="a rigid support that meets"):
        check(model)
    assert time.process_time() - start < 10


def test_command_refuses_what_solve_refuses(tmp_path: Any, capsys: pytest.CaptureFixture[str]) -> None:
    """The command check ends with 2 and the same words as solve, where it said fine before."""
    path = tmp_path / "case.toml"
    path.write_text(to_toml(Model(**case(supports=[line(0), {**ACROSS, "acts": "in compression"}]))), "utf-8")
    said = []
    for command in ("check", "solve"):
        assert main.main([command, str(path)]) == 2
        said.append(capsys.readouterr().err)
    assert said[0] == said[1]
    assert "rigid support" in said[0]
