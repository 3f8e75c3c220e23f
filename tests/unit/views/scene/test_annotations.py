"""What scenes and drawings write beside supports, walls and bars: forces by hand, the words of drawings of bars."""

from __future__ import annotations

import groundslab as gs
from groundslab.case import casefile
from groundslab.unit_systems import System
from groundslab.views.drawing.bars import draw
from groundslab.views.drawing.shapes import Text
from groundslab.views.reactions import Reaction, support_reactions, wall_reactions
from groundslab.views.scene.annotations import bars_of, reactions_of
from helpers.small_case import TEXT

PILES = """
[[supports]]
kind = "point"
name = "P1"
x = "-1 m"
y = "0 m"

[[supports]]
kind = "point"
name = "P2"
x = "1 m"
y = "0 m"

[[walls]]
name = "inner"
points = [["-1.5 m", "0.5 m"], ["1.5 m", "0.5 m"]]
thickness = "200 mm"

[[loads]]
kind = "line"
wall = "inner"
q = "8 kN/m"
"""
BARS = """
[[cases]]
name = "G"

[[combinations]]
name = "all"
limit_state = "ultimate"
factors = {G = 1.0}

[reinforcement]
f_ck = "30 MPa"
f_yk = "500 MPa"
bottom = ["46 mm", "58 mm"]
top = ["46 mm", "58 mm"]
bottom_x = { diameter = "12 mm", spacing = "150 mm" }
bottom_y = { diameter = "12 mm", spacing = "150 mm" }
top_x = { diameter = "12 mm", spacing = "150 mm" }
top_y = { diameter = "12 mm", spacing = "150 mm" }

[[reinforcement.zones]]
name = "middle"
layers = ["bottom_x"]
diameter = "16 mm"
spacing = "150 mm"
shape = { kind = "rectangle", x = ["-1 m", "1 m"], y = ["-1 m", "1 m"] }
"""


def test_an_arrow_points_where_the_force_does_and_numbers_have_units() -> None:
    """Upwards for pressed supports, downwards for tension and walls; kips beside customary units."""
    pressed = Reaction("A", (0.0, 0.0), 520e3, 145e3)
    assert (pressed.arrow, pressed.words("SI")) == ("\N{UPWARDS ARROW}", "520 kN, max 145 kN/m")
    assert pressed.words("US") == "116.9 kip, max 9.936 kip/ft"
    pulled = Reaction("B", (0.0, 0.0), -35e3, moments=(12e3, 0.0))
    assert (pulled.arrow, pulled.words("SI", signed=False)) == ("\N{DOWNWARDS ARROW}", "35 kN, M_x = 12 kNm")
    assert pulled.words("SI") == "\N{MINUS SIGN}35 kN, M_x = 12 kNm"
    # along a wall that presses with 8 kN/m the most is beside the arrow, the other sense negative
    assert Reaction("C", (0.0, 0.0), -24e3, -8e3).words("SI", signed=False) == "24 kN, max 8 kN/m"
    assert Reaction("D", (0.0, 0.0), -24e3, 8e3).words("SI", signed=False) == "24 kN, max \N{MINUS SIGN}8 kN/m"


def test_reactions_of_a_solved_slab_are_those_of_its_supports_and_walls() -> None:
    """A wall of 3 m with 8 kN/m presses with 24 kN in its middle; piles are at their places with their forces."""
    results = gs.solve(casefile.loads(TEXT.replace("counts = [4, 3]", 'size = "1 m"') + PILES))
    (one,) = results.results.values()
    (wall,) = wall_reactions(one)
    assert (wall.place, wall.force, wall.most) == ((0.0, 0.5), -24e3, -8e3)
    piles = list(support_reactions(one))
    assert [pile.place for pile in piles] == [(-1.0, 0.0), (1.0, 0.0)]
    assert [pile.force for pile in piles] == [support.total for support in one.supports]
    written = reactions_of(one)
    assert [each["at"] for each in written] == [[-1.0, 0.0], [1.0, 0.0], [0.0, 0.5]]
    assert written[-1]["text"] == "\N{DOWNWARDS ARROW} 24 kN, max 8 kN/m"


def test_bars_have_the_words_of_their_drawing_in_both_systems_of_units() -> None:
    """Each set's diameter and spacing stands in a label of the drawing; words of the base are beside the zone."""
    systems: tuple[System, ...] = ("SI", "US")
    for units in systems:
        text = f'[project]\nunits = "{units}"\n{TEXT}{BARS}'.replace('q = "10 kPa"', 'q = "10 kPa"\ncase = "G"')
        model = casefile.loads(text)
        labels = [shape.words for shape in draw(model) if isinstance(shape, Text)]
        written = bars_of(model)
        assert [(each["layer"], each["zone"]) for each in written][:2] == [("bottom_x", ""), ("bottom_x", "middle")]
        assert all(any(each["text"] in label for label in labels) for each in written)
        base, zone = written[:2]
        assert max(map(abs, base["at"])) > 1
        (ring,) = zone["rings"]
        assert sorted(ring) == [[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]]
    assert bars_of(casefile.loads(TEXT)) == []
