"""Settlements, tilt and pressures against limits."""

from __future__ import annotations

import math

import numpy as np

from helpers.second_program.materials import Rule, Values


def limits(_: str) -> dict[str, Rule]:
    """Return settlements, tilt and pressures against limits: planes by least squares, from means over the area."""
    return {
        "w_max": lambda v: max(0.0, v["w"]),
        "p_max": lambda v: v["p"] + (v["f"] / v["b"] if "b" in v else 0.0),
        "omega_x": lambda v: _plane(v)[0],
        "omega_y": lambda v: _plane(v)[1],
        "omega": lambda v: math.hypot(v["omega_x"], v["omega_y"]),
        "l": lambda v: _distance(v),
        "Delta_w": lambda v: (
            v["w_2"] - v["w_1"] - v["omega_x"] * (v["x_2"] - v["x_1"]) - v["omega_y"] * (v["y_2"] - v["y_1"])
        ),
        "beta": lambda v: abs(v["Delta_w"]) / _distance(v),
        "eta": lambda v: _share(v, 0.0),
        "eta_e": lambda v: _share(v, v["e"]),
    }


def _plane(v: Values) -> tuple[float, float]:
    slopes = np.linalg.solve([[v["S_xx"], v["S_xy"]], [v["S_xy"], v["S_yy"]]], [v["S_xw"], v["S_yw"]])
    return float(slopes[0]), float(slopes[1])


def _distance(v: Values) -> float:
    return math.dist((v["x_1"], v["y_1"]), (v["x_2"], v["y_2"]))


def _share(v: Values, error: float) -> float:
    """Return the value, with its error, over the limit."""
    name = next(name for name in v if name.endswith("lim"))
    return (v[name.removesuffix("_lim").removesuffix(",lim")] + error) / v[name]
