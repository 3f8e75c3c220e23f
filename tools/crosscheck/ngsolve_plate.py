"""NGSolve's side of the cross-check: a slab of the input file, by elements of high order and contact by penalty.

    python ngsolve_plate.py CASE.json

Nothing of groundslab is used: the file's words are read here anew, the plate and its ground are formulated from their
energies, the mesh is Netgen's, of triangles that follow all borders. Unknowns are the settlement w, the rotations and,
where the ground carries shear, a ground surface w0 of its own that goes on beyond the slab. Contact is a penalty of a
hundred thousand times the ground's stiffness, on areas and along the slab's edges, where the ground takes forces per
length; Newton's steps end when no point of integration changes. Ground without end is a strip ten decay lengths wide.
Prints settlements [m] and moments [N] at the file's points as JSON.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import ngsolve as ng
from netgen.occ import Glue, OCCGeometry, WorkPlane

ORDER, SIZE, FINE = 4, 0.6, 0.3
PENALTY, DECAYS, STEPS = 1e5, 10.0, 100


def number(text: str) -> float:
    """Return a quantity that is given in base units."""
    return float(text.split()[0])


def rectangle(place: dict[str, Any]) -> tuple[float, float, float, float]:
    """Return x0, x1, y0, y1 [m]."""
    x0, x1, y0, y1 = map(number, (*place["x"], *place["y"]))
    return x0, x1, y0, y1


def face(place: dict[str, Any]) -> Any:
    """Return a rectangle as a face."""
    x0, x1, y0, y1 = rectangle(place)
    return WorkPlane().MoveTo(x0, y0).Rectangle(x1 - x0, y1 - y0).Face()


def inside(place: dict[str, Any]) -> ng.CoefficientFunction:
    """Return 1 in a rectangle, 0 outside; elements do not cross its border."""
    x0, x1, y0, y1 = rectangle(place)
    within = [
        ng.IfPos(ng.x - x0, 1, 0),
        ng.IfPos(x1 - ng.x, 1, 0),
        ng.IfPos(ng.y - y0, 1, 0),
        ng.IfPos(y1 - ng.y, 1, 0),
    ]
    return within[0] * within[1] * within[2] * within[3]


def mesh_of(case: dict[str, Any], width: float) -> ng.Mesh:
    """Return a mesh of the slab ("slab", its edges "edge") and of the ground around it up to a width [m]."""
    points = [tuple(map(number, point)) for point in case["plate"]["outline"]["points"]]
    plane = WorkPlane().MoveTo(*points[0])
    for point in points[1:]:
        plane.LineTo(*point)
    slab = plane.Close().Face()
    openings = case["plate"].get("openings", [])
    for opening in openings:
        slab = slab - face(opening)
    slab.edges.name = "edge"
    slab.faces.name = "slab"
    places = [*(zone["shape"] for zone in case["plate"].get("zones", [])),
              *(load for load in case["loads"] if load["kind"] == "patch")]  # fmt: skip
    parts = []
    for place in places:
        part = face(place) * slab
        part.faces.name, part.faces.maxh = "slab", FINE
        slab = slab - face(place)
        parts.append(part)
    slab.faces.name = "slab"
    slab.faces.maxh = SIZE
    pieces = [slab, *parts]
    if width:
        xs, ys = zip(*points, strict=True)
        x0, x1, y0, y1 = min(xs) - width, max(xs) + width, min(ys) - width, max(ys) + width
        around = WorkPlane().MoveTo(x0, y0).Rectangle(x1 - x0, y1 - y0).Face()
        for piece in pieces:
            around = around - piece
        around.faces.name = "ground"
        pieces.append(around)
    return ng.Mesh(OCCGeometry(Glue(pieces), dim=2).GenerateMesh(maxh=max(SIZE, width / 6)))


def main(path: str) -> None:
    """Solve the slab of a file and print its values."""
    case = json.loads(Path(path).read_text(encoding="utf-8"))
    ground, plate = case["ground"], case["plate"]
    shear = ground["kind"] == "pasternak"
    k0 = number(ground["k0"] if shear else ground["k"])
    k1 = number(ground["k1"]) if shear else 0.0
    width = DECAYS * (k1 / k0) ** 0.5 if case["beyond"]["kind"] == "infinite" else 0.0
    mesh = mesh_of(case, width)
    E, nu, t = number(plate["E"]), plate["nu"], ng.CoefficientFunction(number(plate["thickness"]))
    for zone in plate.get("zones", []):
        chosen = inside(zone["shape"])
        t = chosen * number(zone["thickness"]) + (1 - chosen) * t
    q = ng.CoefficientFunction(0.0)
    for load in case["loads"]:
        q = q + number(load["q"]) * (1 if load["kind"] == "uniform" else inside(load))
    with ng.TaskManager():
        found = solve(mesh, t, E, nu, k0, k1, q)
    w, beta = found.components[:2]
    D = E * t**3 / (12 * (1 - nu**2))
    slope = ng.Grad(beta)
    values = [w, -D * (slope[0, 0] + nu * slope[1, 1]), -D * (slope[1, 1] + nu * slope[0, 0])]
    print(json.dumps({
        "unknowns": found.space.ndof,
        "values": [[value(mesh(x, y)) for value in values] for x, y in case["points"]],
    }))  # fmt: skip


def solve(
    mesh: ng.Mesh, t: ng.CoefficientFunction, E: float, nu: float, k0: float, k1: float, q: ng.CoefficientFunction
) -> ng.GridFunction:
    """Return settlement, rotations of the normal (u = -z beta) and, with k1, the ground's settlement."""
    slab = mesh.Materials("slab")
    V = ng.H1(mesh, order=ORDER, definedon=slab) * ng.VectorH1(mesh, order=ORDER, definedon=slab)
    if k1:
        V = V * ng.H1(mesh, order=ORDER)
    trial, test = V.TnT()
    (w, beta), (v, eta) = trial[:2], test[:2]
    kappa, other = ng.Sym(ng.Grad(beta)), ng.Sym(ng.Grad(eta))
    D, S = E * t**3 / (12 * (1 - nu**2)), 5 / 6 * E / (2 * (1 + nu)) * t
    form = ng.BilinearForm(V, symmetric=True)
    form += D * ((1 - nu) * ng.InnerProduct(kappa, other) + nu * ng.Trace(kappa) * ng.Trace(other)) * ng.dx("slab")
    form += S * (ng.grad(w) - beta) * (ng.grad(v) - eta) * ng.dx("slab")
    if k1:
        form += (k0 * trial[2] * test[2] + k1 * ng.grad(trial[2]) * ng.grad(test[2])) * ng.dx
    f = ng.LinearForm(V)
    f += q * v * ng.dx("slab")
    f.Assemble()
    found, before = ng.GridFunction(V), ng.GridFunction(V)
    pushed = (lambda u: u[0] - u[2]) if k1 else (lambda u: u[0])
    now, earlier = pushed(found.components), ng.IfPos(pushed(before.components), 1, 0)
    area = ng.dx("slab", intrules={ng.ET.TRIG: ng.IntegrationRule(ng.ET.TRIG, 2 * ORDER + 2)})
    edge = ng.ds("edge", intrules={ng.ET.SEGM: ng.IntegrationRule(ng.ET.SEGM, 2 * ORDER + 2)})
    form += (PENALTY if k1 else 1.0) * k0 * earlier * pushed(trial) * pushed(test) * area
    if k1:
        # the edges of the slab, within the mesh where the ground goes on
        form += PENALTY * (k0 * k1) ** 0.5 * earlier * pushed(trial) * pushed(test) * edge
    before.components[0].Set(1, definedon=slab)
    for _ in range(STEPS):
        form.Assemble()
        found.vec.data = form.mat.Inverse(V.FreeDofs(), "sparsecholesky") * f.vec
        changed = (ng.IfPos(now, 1, 0) - earlier) ** 2
        if ng.Integrate(changed * area, mesh) == 0:
            return found
        before.vec.data = found.vec
    raise SystemExit("the contact does not come to rest")


if __name__ == "__main__":
    main(*sys.argv[1:])
