"""A frame of three storeys on a raft, solved by PyNite in one model; it prints what tests hold us against.

Needs a Python of its own with `pip install -r bench/peers/pynite.txt`; nothing of groundslab is used. Run it with the
element sizes as arguments, each half of the one before:

    python tools/other_programs/pynite_frame.py 1 0.5 0.25

Model: four-node MITC quadrilaterals (Mindlin) on springs that pull, too, under the nodes; columns and beams as members
that do not shear, joined at nodes of the raft, which is held sideways. Loads on floors are forces at the columns' tops.
First the frame stands on rigid bases, then on the raft.
"""

from __future__ import annotations

import sys
from itertools import pairwise

import Pynite

#: Lengths in m, forces in N; the raft lies in the plane of x and z, y is up.
A, B, T, E, NU, K = 14.0, 10.0, 0.6, 30e9, 0.2, 15e6
COLUMNS = {
    f"{row}{number}": (x, z) for row, z in (("A", 2.0), ("B", 8.0)) for number, x in ((1, 2.0), (2, 7.0), (3, 12.0))
}
LINES = (("A1", "A2", "A3"), ("B1", "B2", "B3"), ("A1", "B1"), ("A2", "B2"), ("A3", "B3"))
HEIGHTS = (4.0, 3.0, 3.0)
#: On every floor [N].
LOADS = {"A1": 200e3, "A2": 600e3, "A3": 250e3, "B1": 200e3, "B2": 500e3, "B3": 100e3}
#: Area [m2], second moments of area sideways and vertically, torsion constant [m4].
COLUMN = (0.16, 0.4**4 / 12, 0.4**4 / 12, 0.0036)
BEAM = (0.18, 0.6 * 0.3**3 / 12, 0.3 * 0.6**3 / 12, 0.0037)


def make(size: float | None) -> Pynite.FEModel3D:
    """Return the frame on rigid bases, or on a raft of elements of a size [m]."""
    model = Pynite.FEModel3D()
    model.add_material("concrete", E, E / (2 * (1 + NU)), NU, 0.0)
    model.add_section("column", *COLUMN)
    model.add_section("beam", *BEAM)
    base = {}
    if size is not None:
        model.add_rectangle_mesh("raft", size * (1 + 1e-9), A, B, T, "concrete", plane="XZ")
        raft = model.meshes["raft"]
        raft.generate()
        share: dict[str, float] = {}
        for quad in raft.elements.values():
            for node in (quad.i_node, quad.j_node, quad.m_node, quad.n_node):
                share[node.name] = share.get(node.name, 0.0) + size**2 / 4
        for node in raft.nodes.values():
            model.def_support_spring(node.name, "DY", K * share[node.name])
            model.def_support(node.name, True, False, True, False, True, False)
        by_place = {(round(n.X, 6), round(n.Z, 6)): n.name for n in raft.nodes.values()}
        base = {name: by_place[place] for name, place in COLUMNS.items()}
    for name, (x, z) in COLUMNS.items():
        if size is None:
            base[name] = model.add_node(f"{name} 0", x, 0.0, z)
            model.def_support(base[name], *[True] * 6)
        height, below = 0.0, base[name]
        for storey, rise in enumerate(HEIGHTS, start=1):
            height += rise
            top = model.add_node(f"{name} {storey}", x, height, z)
            model.add_member(f"{name} {storey}", below, top, "concrete", "column")
            model.add_node_load(top, "FY", -LOADS[name])
            below = top
    for line in LINES:
        for one, other in pairwise(line):
            for storey in range(1, len(HEIGHTS) + 1):
                model.add_member(f"{one} {other} {storey}", f"{one} {storey}", f"{other} {storey}", "concrete", "beam")
    model.analyze_linear(check_stability=False)
    return model


def loads(model: Pynite.FEModel3D) -> dict[str, tuple[float, float, float]]:
    """Return P [kN], M_x and M_y [kN m] of each column on its base: downwards, and pressing larger x or z down."""
    found = {}
    for name in COLUMNS:
        # what the base does to the member, in global axes
        forces = model.members[f"{name} 1"].F("Combo 1").ravel()
        push, turn = forces[:3], forces[3:6]
        # a moment about z presses larger x down if it turns x towards -y, one about x presses larger z down
        found[name] = (push[1] / 1e3, turn[2] / 1e3, -turn[0] / 1e3)
    return found


def main(sizes: list[float]) -> None:
    """Print the loads of columns on rigid bases, and on a raft on each mesh."""
    print("PyNite", Pynite.__version__)
    for name, values in loads(make(None)).items():
        print(f"rigid {name}", *(f"{value:12.4f}" for value in values))
    tables = [loads(make(size)) for size in sizes]
    for name in COLUMNS:
        for part, what in enumerate(("P", "M_x", "M_y")):
            print(f"{name} {what:4}", *(f"{table[name][part]:12.4f}" for table in tables))


if __name__ == "__main__":
    main([float(size) for size in sys.argv[1:]] or [1.0, 0.5, 0.25])
