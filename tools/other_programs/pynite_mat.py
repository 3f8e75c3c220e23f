"""A mat that lifts off, solved by PyNite; it prints what the case mat_pynite holds us against.

Needs a Python of its own with `pip install -r bench/peers/pynite.txt`; nothing of groundslab is used. Run it with the
element sizes as arguments, each half of the one before:

    python tools/other_programs/pynite_mat.py 0.5 0.25 0.125

Model: four-node MITC quadrilaterals (Mindlin), free but for springs under the nodes, stiffness times each node's share
of the area, that only push. A mat of 12 m x 8 m with an opening, three columns on squares of 1 m.
"""

from __future__ import annotations

import sys
from collections import Counter

import Pynite

#: Lengths in m, forces in N; loads positive downwards.
A, B, T, E, NU, K = 12.0, 8.0, 0.5, 30e9, 0.2, 20e6
OPENING = ((6.0, 8.0), (4.0, 6.0))
LOADS = [(1e3, (0, 12), (0, 8)), (900e3, (1, 2), (1, 2)), (600e3, (10, 11), (6, 7)), (300e3, (1, 2), (6, 7))]
PLACES = [(0, 0), (12, 0), (12, 8), (0, 8), (1.5, 1.5), (6, 4), (6, 6), (10.5, 6.5), (4, 3)]


def solve(size: float) -> dict[str, float]:
    """Return settlements [mm] on elements of a size [m]."""
    model = Pynite.FEModel3D()
    model.add_material("concrete", E, E / (2 * (1 + NU)), NU, 0.0)
    # y is up; the mat lies in the plane of x and z
    model.add_rectangle_mesh("mat", size * (1 + 1e-9), A, B, T, "concrete", plane="XZ")
    mat = model.meshes["mat"]
    mat.generate()
    (x0, x1), (z0, z1) = OPENING
    around: Counter[str] = Counter()
    for name, quad in list(mat.elements.items()):
        corners = quad.i_node, quad.j_node, quad.m_node, quad.n_node
        x, z = (sum(getattr(n, along) for n in corners) / 4 for along in "XZ")
        if x0 < x < x1 and z0 < z < z1:
            del mat.elements[name], model.quads[name]
            continue
        around.update(node.name for node in corners)
        pressure = sum(q for q, (u0, u1), (v0, v1) in LOADS if u0 < x < u1 and v0 < z < v1)
        model.add_quad_surface_pressure(name, pressure)
    for name in [name for name in mat.nodes if not around[name]]:
        del mat.nodes[name], model.nodes[name]
    for node in mat.nodes.values():
        model.def_support_spring(node.name, "DY", K * around[node.name] * size**2 / 4, "-")
        # nothing pulls in the plane of the mat, and its nodes do not turn about the vertical axis
        model.def_support(node.name, True, False, True, False, True, False)
    model.analyze(check_stability=False, sparse=True, max_iter=100)
    by_place = {(round(n.X, 6), round(n.Z, 6)): -1e3 * float(n.DY["Combo 1"]) for n in mat.nodes.values()}
    found = {f"w at {x}, {y}": by_place[float(x), float(y)] for x, y in PLACES}
    found["largest uplift"] = -min(by_place.values())
    return found


def main(sizes: list[float]) -> None:
    """Print the values on each mesh, and extrapolated from the last two for errors that fall with the square."""
    print("PyNite", Pynite.__version__)
    tables = [solve(size) for size in sizes]
    for name in tables[0]:
        values = [table[name] for table in tables]
        limit = values[-1] + (values[-1] - values[-2]) / 3 if len(values) > 1 else values[-1]
        print(f"{name:18}", *(f"{value:12.6f}" for value in values), f"{limit:12.6f}", sep="  ")


if __name__ == "__main__":
    main([float(size) for size in sys.argv[1:]] or [0.5, 0.25, 0.125])
