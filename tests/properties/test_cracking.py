"""Slabs that crack, under any columns on any ground: the iteration ends in a certified result."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from groundslab.analysis.driver import solve
from groundslab.case import casefile
from helpers.examples import examples

GROUNDS = (
    'kind = "winkler"\nk = "{} MPa/m"',
    'kind = "pasternak"\nk0 = "{} MPa/m"\nk1 = "8 MN/m"',
    'kind = "vlasov"\n[[ground.layers]]\nE = "{} MPa"\nnu = 0.3\nthickness = "5 m"',
    'kind = "layered"\ncoupling = "consistent"\n[[ground.layers]]\nE = "{} MPa"\nnu = 0.3\nthickness = "3 m"\n'
    '[[ground.layers]]\nE = "60 MPa"\nnu = 0.3\nthickness = "3 m"',
)
CASE = """
[plate]
length_x = "{x} m"
length_y = "{y} m"
thickness = "{t} m"
E = "33 GPa"
nu = 0.2
[ground]
{ground}
[[cases]]
name = "G"
[[loads]]
kind = "self weight"
case = "G"
unit_weight = "25 kN/m^3"
{columns}
[[combinations]]
name = "Ed"
factors = {{ G = 1.0 }}
[[combinations]]
name = "qp"
limit_state = "quasi-permanent"
factors = {{ G = 1.0 }}
[reinforcement]
concrete = "C30/37"
steel = "B500B"
bottom = ["45 mm", "60 mm"]
top = ["45 mm", "60 mm"]
{bars}
[cracking]
creep = {creep}
duration = "{duration}"
shrinkage = {shrinkage}
[mesh]
size = "{size} m"
"""
COLUMN = (
    '[[loads]]\nkind = "point"\ncase = "G"\nx = "{} m"\ny = "{} m"\nP = "{} kN"\nwidth_x = "0.05 m"\nwidth_y = "0.05 m"'
)


@st.composite
def cases(draw: st.DrawFn) -> str:
    """Return a slab with columns, bars, creep and shrinkage, loaded until it cracks or lifts off, or not."""
    x, y, t = draw(st.floats(4, 14)), draw(st.floats(3, 10)), draw(st.floats(0.18, 0.5))
    place = st.integers(-45, 45).map(lambda share: share / 100)
    columns = [
        COLUMN.format(draw(place) * x, draw(place) * y, draw(st.floats(100, 1500)) * (t / 0.3) ** 2)
        for _ in range(draw(st.integers(1, 5)))
    ]
    layers = ("bottom_x", "bottom_y", "top_x", "top_y")
    diameter, spacing = st.sampled_from([8, 10, 12, 16, 20]), st.sampled_from([100, 150, 200])
    bars = [f'{layer} = {{ diameter = "{draw(diameter)} mm", spacing = "{draw(spacing)} mm" }}' for layer in layers]
    return CASE.format(
        x=x, y=y, t=t, ground=draw(st.sampled_from(GROUNDS)).format(draw(st.floats(4, 60))),
        columns="\n".join(columns), bars="\n".join(bars), creep=draw(st.sampled_from([0.0, 1.0, 2.5])),
        duration=draw(st.sampled_from(["long", "short"])), shrinkage=draw(st.sampled_from([0.0, 3e-4])),
        size=max(x, y) / draw(st.sampled_from([12, 16, 24])),
    )  # fmt: skip


@pytest.mark.slow
@settings(max_examples=examples(8), deadline=None, derandomize=True)
@given(text=cases())
def test_the_iteration_ends_in_a_certified_result(text: str) -> None:
    """What the elastic slab bears the cracked one bears too: contact, gamma and stiffness converge together."""
    results = solve(casefile.loads(text))
    if "Ed" in results.refused:
        return
    found = results["qp"]
    assert found.certificate.holds
    assert found.certificate.section_law is not None
    assert found.elements.stiffness_ratio is not None
    assert found.elements.stiffness_ratio.max() <= 1 + 1e-9
