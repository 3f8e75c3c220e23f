"""Elements that are cut in places: what must not hang beside them."""

from __future__ import annotations

import numpy as np

import groundslab as gs
from groundslab import meshing
from groundslab.discretize.plan_layout import plan_of
from groundslab.fem.hanging import find_hanging


def test_nothing_hangs_along_a_joint_where_borders_lie() -> None:
    """Voids end at both sides of the joint, under all of each plate: what lies on both sides is cut alike."""
    outlines = [{"kind": "rectangle", "x": x, "y": (-2.0, 2.0)} for x in ((-3.0, 0.0), (0.0, 3.0))]
    material = {"thickness": 0.2, "E": 30e9, "nu": 0.2}
    model = gs.Model(
        plate=material | {"name": "a", "outline": outlines[0]},
        plates=[material | {"name": "b", "outline": outlines[1]}],
        joints=[{"kind": "hinge", "between": ("a", "b")}],
        ground={"kind": "winkler", "k": 20e6},
        contact={"tensionless": True, "voids": [{"shape": each, "depth": 1e-3} for each in outlines]},
        loads=[{"kind": "uniform", "q": 5e3}],
        mesh={"size": 1.0},
    )
    fine = np.array([[0.3, 0.6]]), np.array([0.05])
    found = meshing.mesh(plan_of(model, (False, False), 0.0), 1.0, edge_size=None, local=fine)
    hanging = find_hanging(found.elements)[:, 0]
    assert len(hanging) > 0
    assert (np.abs(found.nodes[hanging, 0]) > 1e-9).all()
