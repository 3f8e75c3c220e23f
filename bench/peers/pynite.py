"""PyNite: four-node MITC quadrilaterals on support springs that only push, SuperLU.

    python bench/peers/pynite.py 6000

The springs are those that PyNite's mat foundation makes, stiffness times each node's share of the area. Here they are
made from the elements around each node; the mat foundation's own search looks through all elements for every node. The
stability check, which looks through all nodes for every row of the matrix, is left out.
"""

from __future__ import annotations

from collections import Counter

import Pynite
import scipy.sparse.linalg  # noqa: F401  # PyNite loads it when it solves; the clock starts after all imports
from first_plate import LIMIT, LOADED, NU, A, B, E, G, Job, K, Q, T, divisions, run
from Pynite import Analysis


def main(unknowns: int) -> None:
    """Solve the plate and print the figures."""
    job = Job()
    nx, ny = divisions(unknowns, 1)
    size = A / nx
    with job.phase("mesh"):
        model = Pynite.FEModel3D()
        model.add_material("concrete", E, G, NU, 0.0)
        # y is up; the mesh lies in the plane of x and z
        # a size a little too large, as PyNite rounds numbers of elements up
        model.add_rectangle_mesh("plate", size * (1 + 1e-9), A, B, T, "concrete", plane="XZ")
        plate = model.meshes["plate"]
        plate.generate()
        assert len(plate.elements) == nx * ny, "PyNite has made another mesh"
        around: Counter[str] = Counter()
        for quad in plate.elements.values():
            corners = quad.i_node, quad.j_node, quad.m_node, quad.n_node
            around.update(node.name for node in corners)
            if sum(n.X for n in corners) / 4 < LOADED and sum(n.Z for n in corners) / 4 < LOADED:
                model.add_quad_surface_pressure(quad.name, Q)
        for node in plate.nodes.values():
            model.def_support_spring(node.name, "DY", K * around[node.name] * size**2 / 4, "-")
            along_x, along_z = abs(node.X) < 1e-9, abs(node.Z) < 1e-9  # on the lines of symmetry
            model.def_support(node.name, True, False, True, along_z, True, along_x)
    with job.phase("solution"):
        # PyNite does not keep the number of its steps
        steps = 0
        check = Analysis._check_TC_convergence

        def counted(*arguments: object, **named: object) -> bool:
            nonlocal steps
            steps += 1
            return check(*arguments, **named)

        Analysis._check_TC_convergence = counted
        model.analyze(check_stability=False, sparse=True, max_iter=LIMIT)
    by_place = {(round(n.X, 6), round(n.Z, 6)): -n.DY["Combo 1"] for n in plate.nodes.values()}
    free = sum(
        not held
        for n in plate.nodes.values()
        for held in (n.support_DX, n.support_DY, n.support_DZ, n.support_RX, n.support_RY, n.support_RZ)
    )
    job.report(
        program="PyNite",
        version=Pynite.__version__,
        element="four nodes, MITC4",
        solver="SuperLU, minimum degree of columns",
        unknowns=free,
        iterations=steps,
        centre=float(by_place[0.0, 0.0]),
        corner=float(by_place[A, B]),
    )


if __name__ == "__main__":
    run(main)
