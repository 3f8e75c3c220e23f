"""Blocks of code and commands on pages that are no notebooks run as they stand there."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import numpy as np
import pytest

import groundslab
from groundslab.case import casefile
from groundslab.cli import main
from groundslab.model.combinations import list_combinations
from groundslab.model.loads.acting import LineForce
from groundslab.model.reactions import Reactions
from helpers.paths import DOCS, EXAMPLES


def blocks(page: str, language: str) -> list[str]:
    """Return the fenced blocks of a page."""
    return re.findall(
        rf"^```{language}\n(.*?)^```$", (DOCS / page).read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL
    )


@pytest.fixture(scope="module")
def raft(tmp_path_factory: pytest.TempPathFactory) -> tuple[groundslab.Results, Path]:
    """Return the raft of the examples under two loads on elements of 2 m, and the folder with its results."""
    whole = groundslab.load(EXAMPLES / "l_raft.toml")
    combinations = [each for each in whole.combinations if each.name in ("ULS live", "ULS wind")]
    model = whole.replace(mesh={"size": 2.0}, combinations=combinations)
    folder = tmp_path_factory.mktemp("pages")
    results = groundslab.solve(model)
    for name in ("raft-results", "before-results"):
        groundslab.save_results(results, folder / name)
    return results, folder


def run(text: str, **names: object) -> dict[str, object]:
    """Run a block of Python with some names known."""
    exec(compile(text, "page", "exec"), names)
    return names


def test_cases_of_the_page_on_input_load(tmp_path: Path) -> None:
    """The smallest case loads, and with each of the other blocks put behind it."""
    smallest, *others = blocks("input.md", "toml")
    assert len(others) == 18
    askew, *others = others
    assert casefile.loads(f"{smallest}\n{askew}").columns[0].angle == -20.556
    shapes, wall, outer, stairs, stiff, beams, frame, matrix, pit, hung, *others = others
    checks, aci, cracks, combinations, moves, floor, table = others
    assert len(casefile.loads(f"{smallest}\n{shapes}").loads) == 5
    core = casefile.loads(f"{smallest}\n{wall}")
    assert core.acting[-1][1] == LineForce(core.walls[0].edges, q=(250e3, 250e3), width=0.3)
    by_core = [shape for _, shape in casefile.loads(f"{smallest}\n{stairs}").acting if isinstance(shape, LineForce)]
    assert sum(line.length * sum(line.q) / 2 for line in by_core) == pytest.approx(2.4e6)
    assert len(by_core) == 4
    (around,) = casefile.loads(f"{smallest}\n{outer}").placed_walls
    assert around.closed
    assert len(casefile.loads(f"{smallest}\n{beams}").beams) == 5
    (zone,) = casefile.loads(f"{smallest}\n{pit}").plate.zones
    assert (zone.level, zone.wall) == (-1.3, 0.3)
    (column,) = casefile.loads(f"{smallest}\n{hung}").columns
    assert (column.x, column.y) == (-0.5, 1.0)
    assert len(casefile.loads(f"{smallest}\n{stiff}").members) == 3
    columns = "".join(
        f'[[columns]]\nname = "A{n}"\nx = "{2 * n - 4} m"\ny = "0 m"\nwidth_x = "0.4 m"\nwidth_y = "0.4 m"\n'
        for n in (1, 2, 3)
    )
    above = casefile.loads(f"{smallest}\n{columns}\n{frame}").building
    assert above is not None
    assert above.names == ("A1", "A2", "A3")
    (tmp_path / "frame.csv").write_text("A1,A2,A3\n1,-2,1\n-2,4,-2\n1,-2,1\n")
    (tmp_path / "case.toml").write_text(f"{smallest}\n{columns}\n{matrix}")
    assert casefile.load(tmp_path / "case.toml").building is not None
    named = smallest.replace('q = "10 kPa"', 'q = "10 kPa"\ncase = "design loads"')
    assert len(casefile.loads(f"{named}\n{combinations}").combinations) == 1
    assert casefile.loads(f"{named}\n{combinations}\n{checks}").limits is not None
    assert casefile.loads(f"{named}\n{combinations}\n{aci}").reinforcement is not None
    assert casefile.loads(f"{named}\n{combinations}\n{checks}\n{cracks}").cracking is not None
    assert casefile.loads(f"{named}\n{combinations}\n{floor}").floor is not None
    cases = "".join(f'[[cases]]\nname = "{name}"\n' for name in ("rack", "truck"))
    in_case = smallest.replace('q = "10 kPa"', 'q = "10 kPa"\ncase = "rack"')
    assert len(list_combinations(casefile.loads(f"{in_case}\n{cases}\n{moves}"))) == 1 + 14
    one = columns[: columns.index("[[columns]]", 1)].replace("A1", "A")
    read = casefile.loads(f"{in_case}\n{one}\n{cases.replace('truck', 'G')}\n{table}").reactions
    assert read is not None
    assert read == Reactions(
        file="reactions.csv",
        footprint=(0.4, 0.4),
        without_cases=("Wind",),
        cases=({"table": "DEAD", "case": "G"},),
        supports=({"table": "101", "on": "A"},),
    )


def test_python_of_the_page_on_input_is_its_case() -> None:
    """The model in Python is that of the case, and the stiffer one is thicker."""
    names = run(blocks("input.md", "python")[0])
    assert names["model"] == casefile.loads(blocks("input.md", "toml")[0])
    stiffer = names["stiffer"]
    assert isinstance(stiffer, groundslab.Model)
    assert stiffer.plate.thickness == 0.3


@pytest.mark.slow
def test_values_of_the_page_on_notation() -> None:
    """Values are taken at points, lines and rasters, with the shapes that the page states."""
    layer = groundslab.Layered(
        coupling="interface",
        layers=[groundslab.InterfaceLayer(k0=2e7, k1=1e7), groundslab.InterfaceLayer(k0=4e7, k1=2e7)],
    )
    results = groundslab.solve(
        groundslab.Model(
            plate={"length_x": 6, "length_y": 4, "thickness": 0.25, "E": 30e9, "nu": 0.2},
            ground=layer,
            loads=[{"kind": "uniform", "q": 1e4}],
            mesh={"counts": (6, 4)},
        )
    ).only
    (text,) = blocks("notation.md", "python")
    lines = [line for line in text.splitlines() if "value_at" in line]
    assert len(lines) == 4
    names: dict[str, object] = {"results": results, "np": np, "x": np.linspace(-3, 3, 61)}
    for line in lines:
        stated = re.search(r": \(([\d, ]+)\)$", line)
        value = np.asarray(eval(line.split("#")[0], names))
        assert stated is None or value.shape == tuple(int(n) for n in stated[1].split(",") if n.strip())


@pytest.mark.slow
def test_commands_of_the_page_on_plots(raft: tuple[groundslab.Results, Path], monkeypatch: pytest.MonkeyPatch) -> None:
    """Each command draws."""
    monkeypatch.chdir(raft[1])
    commands = [shlex.split(line, comments=True) for line in blocks("plots.md", "sh")[0].splitlines() if line]
    assert len(commands) == 12
    for command in commands:
        assert command[:2] == ["groundslab", "plot"]
        assert main.main(command[1:]) == 0, command
    assert (raft[1] / "bottom.svg").exists()
    assert (raft[1] / "plan.dxf").exists()


@pytest.mark.slow
def test_python_of_the_page_on_plots(raft: tuple[groundslab.Results, Path], monkeypatch: pytest.MonkeyPatch) -> None:
    """Each line draws."""
    combined, folder = raft
    monkeypatch.chdir(folder)
    run(
        blocks("plots.md", "python")[0], results=next(iter(combined.values())), combined=combined, groundslab=groundslab
    )
    assert (folder / "a.png").exists()
