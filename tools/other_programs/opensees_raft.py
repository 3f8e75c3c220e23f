"""An L-shaped raft that lifts off, solved by OpenSees; it prints what the case l_raft_opensees holds us against.

Needs a Python of its own with `pip install openseespy==3.7.1.2 numpy` (x86-64 Linux); nothing of groundslab is used.
Where the system has no libblas.so.3, LD_LIBRARY_PATH must name the folder lib of the package openseespylinux. Run it
with the element sizes as arguments, each half of the one before:

    python tools/other_programs/opensees_raft.py 1 0.5 0.25 0.125

Model: ShellMITC4 (four nodes, Mindlin, transverse shear 5/6 G t), free but for the ground; between each node and the
ground a zeroLength spring of material ENT (elastic, no tension) of stiffness k times the node's share of the area;
loads as forces on the nodes by the same shares. Full Newton steps from the unloaded state until nothing moves.
"""

from __future__ import annotations

import os
import sys

import numpy as np
import openseespy.opensees as ops

#: Lengths in m, forces in N; loads positive downwards.
PARTS = [((0, 30), (0, 10)), ((0, 12), (10, 20))]
OPENING = ((4, 6), (12, 15))
T, E, NU, K = 0.8, 30e9, 0.2, 10e6
LOADS = [
    (2e3, (0, 30), (0, 20)),
    (300e3, (13, 16), (3, 7)),
    (250e3, (1, 4), (16, 18)),
    (200e3, (25, 27), (1, 3)),
]
PLACES = [(0, 0), (0, 10), (0, 20), (2, 17), (5, 10), (6, 15), (12, 20), (12, 10), (14, 5), (20, 5), (26, 2), (30, 0),
          (30, 10)]  # fmt: skip


def cells(size: float) -> np.ndarray:
    """Return the lower left corners of all elements, counted in elements."""
    n = round(1 / size)
    found = []
    for (x0, x1), (y0, y1) in PARTS:
        i, j = np.meshgrid(np.arange(x0 * n, x1 * n), np.arange(y0 * n, y1 * n), indexing="ij")
        found.append(np.column_stack([i.ravel(), j.ravel()]))
    ij = np.vstack(found)
    (x0, x1), (y0, y1) = OPENING
    opened = (ij[:, 0] >= x0 * n) & (ij[:, 0] < x1 * n) & (ij[:, 1] >= y0 * n) & (ij[:, 1] < y1 * n)
    return ij[~opened]


def solve(size: float) -> dict[str, float]:
    """Return the settlements at PLACES and the largest uplift [mm], reactions and load [kN], and the share lifted."""
    lower = cells(size)
    corners = lower[:, None, :] + np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    places, number = np.unique(corners.reshape(-1, 2), axis=0, return_inverse=True)
    quads, xy = number.reshape(-1, 4), places * size
    middle = (lower + 0.5) * size
    q = sum(p * ((middle >= [x[0], y[0]]) & (middle <= [x[1], y[1]])).all(axis=1) for p, x, y in LOADS)
    area, force = np.zeros(len(xy)), np.zeros(len(xy))
    for corner in quads.T:
        np.add.at(area, corner, size**2 / 4)
        np.add.at(force, corner, q * size**2 / 4)

    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    ops.section("ElasticMembranePlateSection", 1, E, NU, T, 0.0)
    # One fixed node is the ground of all springs: OpenSees compares each new restraint with all that it has, and it
    # only warns that a spring's ends do not lie together, which does not matter along z.
    ops.logFile(os.devnull, "-noEcho")
    ground = len(xy) + 1
    ops.node(ground, 0.0, 0.0, 0.0)
    ops.fix(ground, 1, 1, 1, 1, 1, 1)
    for tag, ((x, y), share) in enumerate(zip(xy.tolist(), area.tolist(), strict=True), start=1):
        ops.node(tag, x, y, 0.0)
        ops.uniaxialMaterial("ENT", tag, K * share)
        ops.element("zeroLength", len(quads) + tag, ground, tag, "-mat", tag, "-dir", 3)
    for tag, nodes in enumerate(quads.tolist(), start=1):
        ops.element("ShellMITC4", tag, *(node + 1 for node in nodes), 1)
    # Nothing pulls in the plane of the plate; it only must not float there.
    ops.fix(1, 1, 1, 0, 0, 0, 1)
    ops.timeSeries("Constant", 1)
    ops.pattern("Plain", 1, 1)
    for tag, down in enumerate(force.tolist(), start=1):
        ops.load(tag, 0.0, 0.0, -down, 0.0, 0.0, 0.0)
    ops.constraints("Plain")
    ops.numberer("AMD")
    ops.system("UmfPack")
    ops.test("NormDispIncr", 1e-12, 60, 0)
    ops.algorithm("Newton")
    ops.integrator("LoadControl", 1.0)
    ops.analysis("Static")
    if ops.analyze(1) != 0:
        raise SystemExit(f"OpenSees did not converge at {size} m")
    ops.reactions()
    w = -1e3 * np.array([ops.nodeDisp(tag, 3) for tag in range(1, ground)])
    found = {f"w at {x}, {y}": w[((xy - [x, y]) ** 2).sum(axis=1).argmin()] for x, y in PLACES}
    found["largest uplift"] = -w.min()
    found["reactions kN"] = 1e-3 * ops.nodeReaction(ground, 3)
    found["load kN"] = 1e-3 * force.sum()
    found["share lifted"] = area[w < 0].sum() / area.sum()
    return {name: float(value) for name, value in found.items()}


def main(sizes: list[float]) -> None:
    """Print the values on each mesh, and extrapolated from the last two for errors that fall with the square."""
    print("OpenSees", ops.version())
    tables = [solve(size) for size in sizes]
    print(f"{'':18}", *(f"{size:>10g} m" for size in sizes), "extrapolated", "ratio", sep="  ")
    for name in tables[0]:
        values = [table[name] for table in tables]
        limit = values[-1] + (values[-1] - values[-2]) / 3 if len(values) > 1 else values[-1]
        steps = np.diff(values)
        ratio = steps[-2] / steps[-1] if len(steps) > 1 and steps[-1] else float("nan")
        print(f"{name:18}", *(f"{value:12.6f}" for value in values), f"{limit:12.6f}", f"{ratio:5.2f}", sep="  ")


if __name__ == "__main__":
    main([float(size) for size in sys.argv[1:]] or [1.0, 0.5, 0.25])
