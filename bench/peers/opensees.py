"""OpenSeesPy: ShellMITC4 elements, no-tension springs at the nodes, MUMPS.

    python bench/peers/opensees.py 25000

Where the system has no libblas.so.3, LD_LIBRARY_PATH must name the folder lib of the package openseespylinux. In-plane
displacements and the drilling rotation are held at all nodes, so that three unknowns remain at each. Full Newton steps;
the test on the unbalanced forces ends them as soon as no spring has changed.
"""

from __future__ import annotations

import importlib.metadata
import os

import numpy as np
import openseespy.opensees as ops
from first_plate import LIMIT, NU, E, Job, K, Q, T, divisions, mesh_nodes, run


def main(unknowns: int) -> None:
    """Solve the plate and print the figures."""
    job = Job()
    ops.logFile(os.devnull, "-noEcho")
    nx, ny = divisions(unknowns, 1)
    with job.phase("mesh"):
        corners = build(nx, ny)
    with job.phase("solution"):
        ops.constraints("Plain")
        ops.numberer("Plain")  # MUMPS finds an order by itself
        ops.system("Mumps", "-matrixType", 1)  # symmetric, positive definite
        ops.test("NormUnbalance", 1e-6, LIMIT, 0)  # of 1.44 MN
        ops.algorithm("Newton")
        ops.integrator("LoadControl", 1.0)
        ops.analysis("Static")
        if ops.analyze(1) != 0:
            raise SystemExit("OpenSees did not converge")
    centre, corner = (-ops.nodeDisp(tag, 3) for tag in corners)
    # from the integration points of the element at the centre to its corner there
    N = np.outer([1 + 3**0.5, 1 - 3**0.5], [1 + 3**0.5, 1 - 3**0.5])[[0, 1, 1, 0], [0, 0, 1, 1]] / 4
    moment = N @ np.reshape(ops.eleResponse(1, "stresses"), (4, 8))[:, 3]
    job.report(
        program="OpenSeesPy",
        version=importlib.metadata.version("openseespy"),
        element="ShellMITC4",
        solver="MUMPS, symmetric positive definite",
        unknowns=ops.systemSize(),
        iterations=ops.testIter(),
        centre=centre,
        corner=corner,
        moment=float(moment),
    )


def build(nx: int, ny: int) -> tuple[int, int]:
    """Make the model and return the tags of the nodes at the plate's centre and corner."""
    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    ops.section("ElasticMembranePlateSection", 1, E, NU, T, 0.0)
    x, y, cell, around, loaded = mesh_nodes(nx, ny)

    ops.timeSeries("Constant", 1)
    ops.pattern("Plain", 1, 1)
    ground = (nx + 1) * (ny + 1) + 1  # one fixed node is the ground of all springs
    ops.node(ground, 0.0, 0.0, -1.0)
    ops.fix(ground, 1, 1, 1, 1, 1, 1)
    for n in np.unique(around).astype(int).tolist():
        ops.uniaxialMaterial("ENT", n, K * n * cell / 4)
    tag = 0
    for j, Y in enumerate(y.tolist()):
        for i, X in enumerate(x.tolist()):
            tag += 1
            ops.node(tag, X, Y, 0.0)
            ops.element("zeroLength", nx * ny + tag, ground, tag, "-mat", int(around[j, i]), "-dir", 3)
            if loaded[j, i]:
                ops.load(tag, 0.0, 0.0, -Q * loaded[j, i] * cell / 4, 0.0, 0.0, 0.0)
            # restraints of the pattern, as fix() compares each new one with all that there are
            for free, dof in ((False, 1), (False, 2), (False, 6), (i > 0, 5), (j > 0, 4)):
                if not free:
                    ops.sp(tag, dof, 0.0)
    tag = 0
    for j in range(ny):
        for i in range(nx):
            tag += 1
            first = 1 + i + j * (nx + 1)
            ops.element("ShellMITC4", tag, first, first + 1, first + nx + 2, first + nx + 1, 1)
    return 1, ground - 1


if __name__ == "__main__":
    run(main)
