"""Joints between plates: which are refused, and what is between the plates on the mesh."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab import InputError, Model
from groundslab.case import casefile
from groundslab.discretize.discretize import discretize
from groundslab.fem.problem import BETA_X, BETA_Y, TOP, W, free_motions, joined_plates
from groundslab.model.plates.joints import play_of, stiffness_of

STUFF = {"thickness": 0.3, "nu": 0.2}
HINGED = {"kind": "hinge", "between": ("A", "B")}
DOWELS = {"kind": "elastic", "between": ("B", "A"), "stiffness": 1e8}


def rectangle(x: tuple[float, float], y: tuple[float, float] = (0, 3)) -> dict[str, Any]:
    """Return a rectangle."""
    return {"kind": "rectangle", "x": x, "y": y}


def model(joints: list[dict[str, Any]], **parts: Any) -> Model:
    """Return three plates, of which the first two share 2 m of a line, and the third one stands apart."""
    usual = {
        "plate": {"outline": rectangle((0, 4)), "name": "A", "E": 30e9, **STUFF},
        "plates": [
            {"name": "B", "outline": rectangle((4, 8), (1, 4)), "E": 20e9, **STUFF},
            {"name": "C", "outline": rectangle((10, 12)), "E": 20e9, **STUFF},
        ],
        "joints": joints,
        "ground": {"kind": "pasternak", "k0": 2e7, "k1": 1e7},
        "beyond": {"kind": "infinite"},
        "loads": [{"kind": "uniform", "q": 1e4}],
        "mesh": {"size": 1.0},
    }
    return Model.model_validate(usual | parts)


PILE = {"kind": "point", "x": 4.0, "y": 2.0}
REFUSED: dict[str, tuple[dict[str, Any], str, str]] = {
    "no joint": ({"joints": []}, "plates[1].outline", "touches the first plate without a joint"),
    "one plate": ({"joints": [HINGED, HINGED | {"between": ("C", "C")}]}, "joints[2].between[2]", '"C" again'),
    "unknown": ({"joints": [HINGED, HINGED | {"between": ("C", "D")}]}, "joints[2].between[2]", '"D"'),
    "apart": ({"joints": [HINGED, HINGED | {"between": ("A", "C")}]}, "joints[2].between", "share no line"),
    "twice": ({"joints": [HINGED, DOWELS]}, "joints[2].between", "again"),
    "support": ({"joints": [HINGED], "supports": [PILE]}, "supports[1]", 'on the joint "A - B"'),
    "wall": (
        {"joints": [HINGED], "supports": [{"kind": "line", "points": [(4, 1), (4, 2)]}]},
        "supports[1]",
        'on the joint "A - B"',
    ),
    "glued": (
        {"joints": [DOWELS], "contact": {"tensionless": False}},
        "joints[1].kind",
        "an elastic joint without effect",
    ),
    "negative": ({"joints": [DOWELS | {"gap": -1e-3}]}, "joints[1].gap", "-0.001"),
    "overlap": (
        {"joints": [HINGED], "plates": [{"name": "B", "outline": rectangle((3, 8)), "E": 20e9, **STUFF}]},
        "plates[1].outline",
        "overlaps the first plate",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_refused(name: str) -> None:
    """Plates that touch without a joint, joints without two plates, and what stands on a joint, are errors."""
    parts, location, words = REFUSED[name]
    with pytest.raises(InputError) as refused:
        model(**({"joints": []} | parts))
    assert location in [issue.location for issue in refused.value.issues]
    issue = next(issue for issue in refused.value.issues if issue.location == location)
    assert words in str(issue)


def test_accepted_and_written() -> None:
    """A wall across a joint and a loose joint are accepted; a file says the same."""
    wall = {"kind": "line", "points": [(2, 2), (6, 2)], "stiffness": 1e7}
    found = model([DOWELS | {"gap": 1e-3, "name": "dowels"}], supports=[wall])
    assert casefile.loads(casefile.to_toml(found)) == found
    (joint,) = found.joints
    assert (joint.title, play_of(joint), stiffness_of(joint)) == ("dowels", 1e-3, 1e8)
    problem = discretize(found)
    assert problem.contact.bearing.length[problem.contact.bearing.support == 0].sum() == pytest.approx(4.0)


def test_both_sides_of_a_hinge_share_the_settlement() -> None:
    """Along a hinge the nodes of both plates have one unknown settlement, and rotations for each; dowels share none."""
    for joint, shared in ((HINGED, True), (DOWELS | {"between": ("A", "B")}, False)):
        problem = discretize(model([joint]))
        first, second = problem.unknown[problem.links.nodes[problem.links.joint == 0]].transpose(1, 0, 2)
        assert len(first) > 3
        assert ((first[:, W] == second[:, W]) == shared).all()
        assert (first[:, BETA_X : BETA_Y + 1] != second[:, BETA_X : BETA_Y + 1]).all()
        assert problem.unknown.max() + 1 == len(np.unique(problem.unknown[problem.unknown >= 0]))


@pytest.mark.parametrize("shear", [False, True])
@pytest.mark.parametrize("gap", [0.0, 1e-3])
def test_links_on_the_mesh(shear: bool, gap: float) -> None:
    """Both plates have nodes of their own along the joint, linked by its stiffness; the ground's surface goes on."""
    ground = {"kind": "layered", "coupling": "interface", "layers": [{"k0": 4e7, "k1": 1e7 * shear}] * 2}
    beyond = {"kind": "infinite" if shear else "none"}
    problem = discretize(model([DOWELS | {"gap": gap}], ground=ground, beyond=beyond))
    links, nodes = problem.links, problem.mesh.nodes
    own = links.joint == 0
    np.testing.assert_array_equal(nodes[links.nodes[:, 0]], nodes[links.nodes[:, 1]])
    assert set(nodes[links.nodes[own], 0].ravel()) == {4.0}
    assert np.ptp(nodes[links.nodes[own], 1]) == 2.0
    assert links.stiffness[own].sum() == pytest.approx(1e8 * 2.0)
    assert np.isinf(links.stiffness[~own]).all()
    assert set(map(tuple, links.fields[~own][:, W:].tolist())) == (
        {tuple(np.isin(np.arange(5 + (gap > 0)), fields)) for fields in ([W, TOP], [TOP + 1])} if shear else set()
    )
    slips = (problem.unknown[:, 5:] >= 0).sum()
    assert slips == (own.sum() if gap else 0)
    at_slips = problem.contact.bearing.field > TOP
    assert at_slips.sum() == 2 * slips
    assert set(np.abs(problem.contact.bearing.law.offset[at_slips])) == ({gap} if gap else set())
    plates = [set(problem.nodes_of(n).tolist()) for n in range(3)]
    assert not any(a & b for n, a in enumerate(plates) for b in plates[n + 1 :])


def test_free_motions_of_joined_plates() -> None:
    """A hinge leaves two plates their three motions and the turn about its line; a link that carries nothing, all."""
    free = {k: free_motions(discretize(model([DOWELS | {"stiffness": k}]))) for k in (0.0, 1e8)}
    assert [found.shape for found in free.values()] == [(9, 9), (9, 7)]
    motions = free[1e8]
    for y in (1.0, 3.0):
        np.testing.assert_allclose((motions[:3] - motions[3:6]).T @ [1.0, 4.0, y], 0.0, atol=1e-9)
    groups = [part.plate.names for part, _ in joined_plates(discretize(model([HINGED])))]
    assert groups == [("A", "B"), ("C",)]
