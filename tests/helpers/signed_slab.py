"""A small raft with all that a design follows: columns inside, at an edge and in a corner, a wall, thin slab, links."""

from __future__ import annotations

from typing import Any

import groundslab as gs

BARS = {
    "bottom_x": {"diameter": 0.016, "spacing": 0.1}, "bottom_y": {"diameter": 0.016, "spacing": 0.1},
    "top_x": {"diameter": 0.014, "spacing": 0.1}, "top_y": {"diameter": 0.014, "spacing": 0.1},
}  # fmt: skip
AXES = (0.05, 0.066)
ZONE = {
    "name": "under M", "layers": ["bottom_x", "bottom_y"], "diameter": 0.02, "spacing": 0.15,
    "shape": {"kind": "rectangle", "x": (-3.4, 0.9), "y": (-2.4, 2.2)},
}  # fmt: skip
LINKS = {"of": "M", "diameter": 0.010, "distances": (0.13, 0.33, 0.53, 0.73), "legs": (20, 24, 28, 32)}
COLUMNS = {
    "M": (-1.2, 0.0, 0.4, 0.3, 1000e3, 30e3), "E": (0.5, -2.7, 0.5, 0.4, 330e3, 0.0),
    "C": (-3.75, 2.8, 0.4, 0.3, 150e3, -10e3), "R": (2.6, -1.3, 0.35, None, 230e3, 0.0),
}  # fmt: skip


def signed_slab(code: dict[str, Any]) -> gs.Model:
    """Return the raft of 8 m by 6 m by 0.45 m, 0.3 m in a corner, by a code's keys of the reinforcement."""
    columns = [
        {"name": name, "x": x, "y": y, **({"width_x": a, "width_y": b} if b else {"diameter": a})}
        for name, (x, y, a, b, _, _) in COLUMNS.items()
    ]
    points = [
        {"kind": "point", "column": name, "P": share * P, "M_x": share * M, "case": case}
        for case, share in (("G", 1.0), ("Q", 0.4))
        for name, (*_, P, M) in COLUMNS.items()
    ]
    return gs.Model(
        title="Raft to be signed",
        plate={
            "length_x": 8.0, "length_y": 6.0, "thickness": 0.45, "E": 33e9, "nu": 0.2,
            "zones": [{"thickness": 0.3, "shape": {"kind": "rectangle", "x": (1.5, 4.0), "y": (-3.0, -0.5)}}],
            "openings": [{"kind": "rectangle", "x": (-0.3, 0.2), "y": (0.6, 1.1)}],
        },
        ground={"kind": "pasternak", "k0": 25e6, "k1": 15e6},
        columns=columns,
        walls=[{"name": "W", "thickness": 0.25, "height": 2.8, "E": 33e9, "points": [(1.4, 1.2), (4.0, 1.2)]}],
        cases=[{"name": "G"}, {"name": "Q", "action": "variable"}],
        loads=[
            {"kind": "self weight", "unit_weight": 25e3, "case": "G"}, {"kind": "uniform", "q": 2e3, "case": "G"},
            {"kind": "line", "wall": "W", "q": 150e3, "case": "G"}, *points,
        ],
        combinations=[
            {"name": "ULS", "factors": {"G": 1.35, "Q": 1.5}},
            {"name": "char", "limit_state": "characteristic", "factors": {"G": 1.0, "Q": 1.0}},
            {"name": "lasting", "limit_state": "quasi-permanent", "factors": {"G": 1.0, "Q": 0.3}},
        ],
        reinforcement={"bottom": AXES, "top": AXES, "links": [LINKS], "zones": [ZONE], **BARS, **code},
        limits={"pressure": 400e3, "settlement": 0.03, "tilt": 0.002, "angular_distortion": 0.002},
        report={"sheets": "all"},
        mesh={"size": 0.5},
    )  # fmt: skip
