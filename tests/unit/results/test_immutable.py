"""Solved results are what they were when they were certified: nobody can change their arrays or what was solved."""

from __future__ import annotations

import copy
import pickle
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np
import pytest

import groundslab
from groundslab.errors import InputError
from groundslab.results.results import Results

CASE = """
[plate]
length_x = "6 m"
length_y = "4 m"
thickness = "0.3 m"
E = "30 GPa"
nu = 0.2

[mesh]
size = "1 m"

[ground]
kind = "winkler"
k = "20 MN/m3"

[[beams]]
name = "rib"
points = [["-3 m", "0 m"], ["3 m", "0 m"]]
section = { kind = "rectangle", width = "0.3 m", height = "0.6 m" }

[[supports]]
kind = "point"
name = "pile"
x = "2 m"
y = "1 m"
stiffness = "50 MN/m"

[[cases]]
name = "G"

[[cases]]
name = "Q"

[[combinations]]
name = "one"
factors = { G = 1.0 }

[[combinations]]
name = "both"
factors = { G = 1.35, Q = 1.5 }

[[loads]]
kind = "area"
case = "G"
q = "10 kPa"
shape = { kind = "rectangle", x = ["-1 m", "1 m"], y = ["-1 m", "1 m"] }

[[loads]]
kind = "point"
case = "Q"
x = "1 m"
y = "0.5 m"
P = "100 kN"
"""


def arrays(value: Any, name: str = "") -> Iterator[tuple[str, Any]]:
    """Yield the arrays within a value by their paths."""
    if isinstance(value, np.ndarray):
        yield name, value
    elif isinstance(value, tuple):
        for number, each in enumerate(value):
            yield from arrays(each, f"{name}[{number}]")
    elif is_dataclass(value):
        for field in fields(value):
            yield from arrays(getattr(value, field.name), f"{name}.{field.name}")


@pytest.fixture(scope="module")
def results(tmp_path_factory: pytest.TempPathFactory) -> Results:
    """Return the results of two combinations on a slab with a rib and a pile."""
    path = tmp_path_factory.mktemp("case") / "slab.toml"
    path.write_text(CASE, encoding="utf-8")
    return groundslab.solve(groundslab.load(path))


def test_no_array_can_be_written_to(results: Results) -> None:
    """Arrays of plate, elements, ground, supports, beams and the coarser mesh are read-only, in copies too."""
    copies = [pickle.loads(pickle.dumps(results)), copy.deepcopy(results)]
    for each in (results, *copies):
        for name, one in each.items():
            found = dict(arrays(one, name))
            parts = (".plate.nodes", ".plate.settlement", ".elements.moment_x", ".ground.settlement")
            assert {f"{name}{part}" for part in parts} <= found.keys()
            assert any(".supports[0]" in path for path in found)
            assert any(".beams[0]" in path for path in found)
            assert any(".comparison.plate" in path for path in found)
            assert [path for path, array in found.items() if array.flags.writeable] == []


def test_scaled_settlements_are_new_ones(results: Results) -> None:
    """The slip of `w = plate.settlement; w *= 1000` is an error and changes nothing; `1000 * w` is a new array."""
    plate = results["both"].plate
    before = plate.settlement.copy()
    with pytest.raises(ValueError, match="read-only"):
        plate.settlement[:] *= 1000.0
    w = plate.settlement
    with pytest.raises(ValueError, match="read-only"):
        w *= 1000.0
    np.testing.assert_array_equal(plate.settlement, before)
    np.testing.assert_array_equal(1000.0 * plate.settlement, 1000.0 * before)


class Softer(groundslab.Winkler):
    """A ground with a modulus of its own, which no case file can say."""

    @property
    def modulus(self) -> float:
        """Return a quarter of what the keys say."""
        return 0.25 * float(self.k or 0.0)


class Heavier(groundslab.PointLoad):
    """A load of a kind that no case file knows."""


class Renamed(groundslab.Model):
    """A model of a kind that no case file knows."""


def test_subclasses_are_refused(results: Results) -> None:
    """A ground, a load and a model of a class of one's own are named with what is expected; nothing is solved."""
    model = results.model
    parts = {"plate": model.plate, "mesh": model.mesh}
    with pytest.raises(InputError, match="ground: found a subclass, Softer, of Winkler, expected a Winkler itself"):
        groundslab.Model(**parts, ground=Softer(k=20e6))
    with pytest.raises(InputError, match=r"loads\[1\]: found a subclass, Heavier, of PointLoad"):
        groundslab.Model(**parts, ground=model.ground, loads=[Heavier(P=1e3, x=0.0, y=0.0)])
    own = Renamed(**parts, ground=model.ground, loads=[groundslab.PointLoad(P=1e3, x=0.0, y=0.0)])
    with pytest.raises(InputError, match="found a subclass, Renamed, of Model"):
        groundslab.solve(own)
