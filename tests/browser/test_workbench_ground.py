"""Switching the kind of ground in a real browser: what depends on it follows, through all pairs of kinds."""

from __future__ import annotations

import tomllib
from itertools import pairwise, permutations
from pathlib import Path

import pytest

from groundslab.case import casefile
from helpers.browsing import Bench, Server

pytestmark = pytest.mark.slow

KINDS = {
    "Winkler": "winkler",
    "Pasternak": "pasternak",
    "Vlasov": "vlasov",
    "Layered": "layered",
    "Continuum": "continuum",
    "ConstrainedModulus": "constrained modulus",
}

PLATE = """\
[plate]
length_x = "6 m"
length_y = "4 m"
thickness = "300 mm"
E = "30 GPa"
nu = 0.2

[[loads]]
kind = "uniform"
q = "10 kPa"

# the neighbor's footing
[[loads]]
kind = "patch"
on = "ground"
q = "50 kPa"
x = ["-5 m", "-4 m"]
y = ["-1 m", "1 m"]
"""

ON_PILES = f"""{PLATE}
[[loads]]
kind = "settlement"
support = "P1"
w = "2 mm"

[ground]
kind = "constrained modulus"
relief = "20 kPa"
reloading = 3
layers = [
    {{ E = "10 MPa", E_bottom = "20 MPa", nu = 0.3, thickness = "3 m" }},
    {{ E = "30 MPa", nu = 0.3, thickness = "5 m" }},
]

[beyond]
kind = "infinite"

[[boreholes]]
name = "B1"
x = "0 m"
y = "0 m"
layers = [
    {{ E = "10 MPa", E_bottom = "20 MPa", nu = 0.3, thickness = "4 m" }},
    {{ E = "30 MPa", nu = 0.3, thickness = "4 m" }},
]

[[supports]]
kind = "pile"
name = "P1"
x = "1 m"
y = "0 m"
length = "6 m"
diameter = "0.5 m"

[mesh]
size = "0.5 m"
"""

IN_ZONES = f"""{PLATE}
[ground]
kind = "layered"
coupling = "consistent"
layers = [
    {{ E = "10 MPa", nu = 0.3, thickness = "3 m", sublayers = 3 }},
    {{ E = "30 MPa", nu = 0.3, thickness = "5 m" }},
]

[[soil_zones]]
shape = {{ kind = "rectangle", x = ["0 m", "2 m"], y = ["-1 m", "1 m"] }}

[soil_zones.ground]
kind = "layered"
coupling = "consistent"
layers = [
    {{ E = "5 MPa", nu = 0.3, thickness = "3 m", sublayers = 3 }},
    {{ E = "30 MPa", nu = 0.3, thickness = "5 m" }},
]

[beyond]
kind = "margin"
width = "4 m"
edge = "fixed"
sides = ["left", "right"]

[mesh]
size = "0.5 m"
"""


def _tour(first: str) -> list[str]:
    """Return a way through all ordered pairs of kinds, from one of them and back to it."""
    left = {kind: [other for other in KINDS if other != kind] for kind in KINDS}
    stack, way = [first], list[str]()
    while stack:
        if left[stack[-1]]:
            stack.append(left[stack[-1]].pop())
        else:
            way.append(stack.pop())
    assert set(pairwise(way)) == set(permutations(KINDS, 2))
    return way[::-1]


@pytest.mark.parametrize("text", [ON_PILES, IN_ZONES])
def test_each_kind_of_ground_follows_each_other_without_an_issue(
    server: Server, bench: Bench, case: Path, text: str
) -> None:
    """After each switch the file holds a model without issues, in the end the first one; undo brings all back."""
    case.write_text(text)
    model = casefile.loads(text)
    names = {value: name for name, value in KINDS.items()}
    bench.open(server.start(case, by_itself=False))
    bench.tab("Form")
    choice = bench.page.locator("""[data-path='["ground","kind"]'] select""").locator("visible=true")
    for name in _tour(names[model.ground.kind])[1:]:
        choice.select_option(name)
        bench.until(lambda name=name: tomllib.loads(bench.text())["ground"]["kind"] == KINDS[name])
        assert casefile.loads(bench.text()).ground.kind == KINDS[name]
    assert casefile.loads(bench.text()) == model
    before = bench.text()
    choice.select_option("Winkler")
    bench.wait_seen(".notice", "1 load on the ground")
    bench.until(lambda: bench.text() != before)
    bench.page.keyboard.press("Control+z")
    bench.until(lambda: bench.text() == before)
