"""A footing with links of a strip, of a rib and of a part of the slab, whose sizes are known by hand."""

from __future__ import annotations

from typing import Any

from groundslab.model.model import Model

COVER = 0.05
LAYERS = ("bottom_x", "bottom_y", "top_x", "top_y")


def model(**steel: Any) -> Model:
    """Return a footing of 8 m by 1 m by 0.6 m that is a beam, with a rib along it 0.5 m below."""
    return Model(
        plate={"length_x": 8.0, "length_y": 1.0, "thickness": 0.6, "E": 33e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 40e6},
        beams=[{
            "name": "R", "points": [(-4.0, 0.0), (4.0, 0.0)],
            "section": {"kind": "rib", "width": 0.4, "height": 0.5, "effective_width": 1.0},
        }],
        cases=[{"name": "G"}],
        loads=[{"kind": "uniform", "case": "G", "q": 1e4}],
        combinations=[{"name": "U", "factors": {"G": 1.35}, "limit_state": "ultimate"}],
        output={"strips": [{"name": "S", "start": (-4, 0), "end": (4, 0), "width": 1.0, "design": "beam"}]},
        reinforcement={
            "f_ck": 30e6, "f_yk": 500e6, "cover": (COVER, COVER),
            **{layer: {"diameter": 0.016, "spacing": 0.15} for layer in LAYERS}, **steel,
        },
    )  # fmt: skip


LINKS: dict[str, Any] = {
    "beam_links": [
        {"of": "S", "diameter": 0.012, "legs": 4, "spacing": 0.2},
        {"of": "R", "diameter": 0.010, "legs": 2, "spacing": 0.25, "start": 1.0, "end": 3.0},
    ],
    "shear_links": [
        {"name": "east", "diameter": 0.008, "spacing_x": 0.2, "spacing_y": 0.25,
         "shape": {"kind": "rectangle", "x": (2.0, 6.0), "y": (-0.5, 0.5)}},
    ],
}  # fmt: skip
