"""A strip with two ribs and a raft under a shear wall, solved by NGSolve as folded shells, the strip as a solid, too.

Needs a Python of its own with `pip install -r bench/peers/ngs.txt`; nothing of groundslab is used. Run it with the
orders of the shells' elements as arguments, those of the solid are less by two; parts may be left out:

    python tools/other_programs/ngsolve_shells.py 5 6 --parts check,strip,solid,wall

Model: flat facets of Reissner and Mindlin with membrane stiffness; displacements u and rotations r are continuous over
folds, and the part of r around a facet's normal is tied softly to the turn in its plane. A rib is a web from the slab's
lower face down, hung from the slab's middle plane on a facet that is rigid downwards and has no stiffness along the
rib. z points down, moments are positive if they sag; of the strip, only x > 0 is meshed. Held (u_z = 0) is the edge of
the slab's middle plane, and of the solid the slab's end face between z = -held and held: a line would hold nothing.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise, product

import netgen.meshing as ng
import ngsolve
import numpy as np
from ngsolve import BBND, BND, CF, H1, VOL, BilinearForm, Grad, GridFunction, Id, InnerProduct, Trace, ds, dx, grad
from ngsolve.comp import DifferentialSymbol

#: Lengths in m, forces in N. The last three: the part of G t against turns in the plane, the part of E for rigid links,
#: and springs in the plane [N/m3], which keep bodies from drifting.
E, NU, DRILL, RIGID, SOFT = 30e9, 0.2, 1e-3, 1e4, 1e3
#: Thicknesses, ribs from TOP to FOOT around MIDDLE at y in RIBS, the raft's springs [N/m3].
SLAB, RIB, TOP, MIDDLE, FOOT, RIBS, RAFT, WALL, K = 0.2, 0.3, 0.1, 0.4, 0.7, (-1.2, 1.2), 0.5, 0.25, 20e6
EY, EZ = (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
STRIP_X = (0, 0.5, 1, 1.5, 2, 3, 4, 5, 5.5, 5.8, 5.93, 6)
SLAB_Y, WEB_Z = (0, 0.4, 0.7, 1.05, 1.2, 1.35, 1.7, 2, 2.4), (0.1, 0.15, 0.3, 0.5, 0.7)
SOLID_Y = (0, 0.7, 1, 1.05, 1.1, 1.3, 1.35, 1.4, 1.7, 2, 2.4)
SOLID_Z = (-0.1, -0.05, 0, 0.05, 0.1, 0.15, 0.3, 0.5, 0.7)
RAFT_X, RAFT_Y = (0, 1, 2, 2.6, 2.9, 3, 3.1, 3.4, 4, 5), (0, 0.1, 0.4, 1, 2, 3, 4)
DOWN = ((0, -1.2), (0, 1.2), (0, 0), (3, 1.2), (0, 2.4), (0, -2.4))
SUNK = ((0, 0), (-3, 0), (3, 0), (-5, 0), (5, 0), (0, 4), (-5, -4))
BENT = ((0, 0, 1), (1, 0, 1), (0, 4, 0), (1, 0, 2))
#: Integrates along edges.
dl = DifferentialSymbol(BBND)


def halve(lines: Iterable[float], times: int, mirror: bool = False) -> list[float]:
    """Return lines with as many halvings between them, at both signs if asked to."""
    found = sorted({sign * x for x in lines for sign in ((-1, 1) if mirror else (1,))})
    for _ in range(times):
        found = sorted(found + [(a + b) / 2 for a, b in pairwise(found)])
    return found


class Net:
    """A mesh of quadrilaterals or bricks between lines, joined where points fall together."""

    def __init__(self) -> None:
        self.mesh, self.points, self.names, self.edges = ng.Mesh(dim=3), {}, [], {}

    def point(self, place: Sequence[float]) -> ng.PointId:
        """Return the point at a place."""
        key = tuple(round(float(c), 7) for c in place)
        if key not in self.points:
            self.points[key] = self.mesh.Add(ng.MeshPoint(ng.Pnt(*key)))
        return self.points[key]

    def face(self, name: str, corners: Sequence[Sequence[float]]) -> None:
        """Add a quadrilateral to the boundary of a name."""
        if name not in self.names:
            self.names.append(name)
            count = len(self.names)
            self.mesh.Add(ng.FaceDescriptor(surfnr=count, domin=1, domout=0, bc=count))
            self.mesh.SetBCName(count - 1, name)
        points = [self.point(c) for c in corners]
        self.mesh.Add(ng.Element2D(self.names.index(name) + 1, points))
        for k in range(4):
            ends = [points[k - 1], points[k]]
            self.edges[frozenset(p.nr for p in ends)] = (ends, np.mean([corners[k - 1], corners[k]], axis=0))

    def plate(self, name: str | Callable, a: list[float], b: list[float], place: Callable) -> None:
        """Add a facet: places of coordinates a and b, cells named by their middle."""
        for (a0, a1), (b0, b1) in product(pairwise(a), pairwise(b)):
            corners = [place(*at) for at in ((a0, b0), (a1, b0), (a1, b1), (a0, b1))]
            self.face(name if isinstance(name, str) else name(*np.mean(corners, axis=0)), corners)

    def done(self, tests: dict[str, Callable]) -> ngsolve.Mesh:
        """Return the mesh, its edges named by the first test that their middles pass."""
        for index, name in enumerate(tests, start=1):
            self.mesh.SetCD2Name(index, name)
        for ends, middle in self.edges.values():
            index = next((i for i, test in enumerate(tests.values(), start=1) if test(*middle)), 0)
            if index:
                self.mesh.Add(ng.Element1D(ends, index=index))
        return ngsolve.Mesh(self.mesh)


def flat(n: Sequence[float]) -> CF:
    """Return what takes vectors to the plane of a normal."""
    return Id(3) - CF(tuple(p * q for p in n for q in n), dims=(3, 3))


def strains(fields: Iterable, n: Sequence[float], given: bool = False) -> tuple[CF, ...]:
    """Return strains, curvatures, slip and turn of u and r on a facet, and what a link downwards must not do."""
    parts, (a, b, c), P = tuple(fields), n, flat(n)
    slopes = [(grad(p) if given else grad(p).Trace())[k] for p in parts for k in range(3)]
    du, dr = (CF(tuple(slopes[k : k + 9]), dims=(3, 3)) for k in (0, 9))
    r, turn = CF(parts[3:]), CF((0, c, -b, -c, 0, a, b, -a, 0), dims=(3, 3))  # r x n = turn r
    strain, curvature = (P * (g + g.trans) / 2 * P for g in (du, turn * dr))
    link = CF((du[0, 2] - r[1], du[1, 2] + r[0], du[2, 2], dr[0, 2], dr[1, 2], dr[2, 2]))
    return strain, curvature, P * (du.trans * CF(n)) + turn * r, r * CF(n) - Trace(turn * du) / 2, link


def forces(strain: tuple[CF, ...], n: Sequence[float], t: float, nu: float) -> tuple[CF, CF]:
    """Return membrane forces [N/m], and moments [N] that are positive if they pull on the side of n."""
    stiff = E * t / (1 - nu**2)
    N, M = ((1 - nu) * e + nu * Trace(e) * flat(n) for e in strain[:2])
    return stiff * N, stiff * t**2 / 12 * M


def work(one: Iterable, other: Iterable, n: Sequence[float], t: float, nu: float = NU) -> CF:
    """Return the work per area of one's forces on the other's strains, both given by their six fields."""
    a, b, Gt = strains(one, n), strains(other, n), E / (2 * (1 + nu)) * t
    N, M = forces(a, n, t, nu)
    return InnerProduct(N, b[0]) + InnerProduct(M, b[1]) + Gt * (5 / 6 * a[2] * b[2] + DRILL * a[3] * b[3])


def solve(form: BilinearForm, work: CF) -> GridFunction:
    """Return the answer of a condensed form to a load, given as its work."""
    load, answer = ngsolve.LinearForm(form.space), GridFunction(form.space)
    load += work
    f = load.Assemble().vec
    f.data += form.harmonic_extension_trans * f
    answer.vec.data = form.mat.Inverse(form.space.FreeDofs(True), "sparsecholesky") * f
    answer.vec.data += form.harmonic_extension * answer.vec
    answer.vec.data += form.inner_solve * f
    return answer


def gauss(lines: Iterable[float]) -> tuple[np.ndarray, np.ndarray]:
    """Return places and weights of ten points between each two lines."""
    x, w = np.polynomial.legendre.leggauss(10)
    cells = [((a + b) / 2 + (b - a) / 2 * x, (b - a) / 2 * w) for a, b in pairwise(lines)]
    return np.concatenate([c[0] for c in cells]), np.concatenate([c[1] for c in cells])


def at(value: CF, mesh: ngsolve.Mesh, x: float, y: object, z: object, where: object = BND) -> np.ndarray:
    """Return values at places of the same x, a row each: the mean of what is just before and just behind x."""
    y, z = (np.array(c, dtype=float) for c in np.broadcast_arrays(y, z))
    near = [np.full(y.shape, s) for s in (x - 1e-7, x + 1e-7)]
    return np.mean([value(mesh(s, y, z, where)).reshape(len(y), -1) for s in near], axis=0)


def report(what: str, values: dict[str, float], scale: float) -> None:
    """Print values in a line each."""
    for name, value in values.items():
        print(f"{what:40} {name:14} {value * scale:12.5f}", flush=True)


def section(x: float, ribs: list[Sequence[float]], slab: Sequence[float]) -> dict[str, float]:
    """Return forces of a section by name, from N and M of ribs around their middles, and of the slab."""
    named = {f"{k} x={x} y={b}": v for b, rib in zip(RIBS, ribs, strict=True) for k, v in zip("NM", rib, strict=True)}
    whole = sum(N for N, _ in ribs) + slab[0], sum(N * MIDDLE + M for N, M in ribs) + slab[1]
    return named | {f"N sum x={x}": whole[0], f"M sum x={x}": whole[1]}


class Strip:
    """The ribbed strip as shells."""

    def __init__(self, order: int, fine: int, nu: float = NU, ribs: Sequence[float] = RIBS) -> None:
        net, xs, self.nu = Net(), halve(STRIP_X, fine), nu
        self.ys, self.zs = halve(SLAB_Y, fine, mirror=True), halve(WEB_Z, fine)
        net.plate(lambda x, y, _: "patch" if x < 1 and 0.7 < y < 1.7 else "rest", xs, self.ys, lambda x, y: (x, y, 0))
        for y in ribs:
            net.plate("link", xs, [0, TOP], lambda x, z, y=y: (x, y, z))
            net.plate("web", xs, self.zs, lambda x, z, y=y: (x, y, z))
        tests = {"middle": lambda x, *_: x == 0, "end": lambda x, _, z: x == 6 and z == 0}
        self.mesh = net.done(tests | {"foot": lambda x, _, z: x == 6 and z > TOP})
        held = ("middle", "", "end", "", "middle", "middle")
        space = ngsolve.FESpace([H1(self.mesh, order=order, dirichlet_bbnd=edge) for edge in held])
        u, v = space.TnT()
        self.form = BilinearForm(space, symmetric=True, condense=True)
        self.form += work(u, v, EZ, SLAB, nu) * ds("rest|patch") + work(u, v, EY, RIB, nu) * ds("web")
        self.form += RIGID * E * strains(u, EY)[-1] * strains(v, EY)[-1] * ds("link")
        self.form += SOFT * u[1] * v[1] * ds("rest|patch")
        self.form.Assemble()
        self.test = v

    def results(self, load: CF) -> tuple[dict[str, float], dict[str, float]]:
        """Return deflections [m], and forces [N] and moments [N m], under a load given as its work."""
        parts, mesh = solve(self.form, load).components, self.mesh
        web = forces(strains(parts, EY, True), EY, RIB, self.nu)[0][0, 0]
        slab = CF(tuple(m[0, 0] for m in forces(strains(parts, EZ, True), EZ, SLAB, self.nu)))
        (z, wz), (y, wy), found = gauss(self.zs), gauss(self.ys), {}
        for x in (0, 3):
            inside = max(x, 2e-7)
            along = [at(web, mesh, inside, b, z)[:, 0] for b in RIBS]
            ribs = [(wz @ n, wz @ (n * (z - MIDDLE))) for n in along]
            found |= section(x, ribs, wy @ at(slab, mesh, inside, y, 0))
        return {f"w{p}": parts[2](mesh(*map(float, p), 0.0, BND)) for p in DOWN}, found


def strip(order: int, fine: int) -> None:
    """Print the results of both loads on the strip."""
    model = Strip(order, fine)
    for name, q, where in (("a", 10e3, "rest|patch"), ("b", 100e3, "patch")):
        for values, scale in zip(model.results(q * model.test[2] * ds(where)), (1e3, 1e-3), strict=True):
            report(f"strip {name} order {order} fine {fine}", values, scale)


def check(order: int) -> None:
    """Print known answers with nu = 0: a slab without ribs, and the ribbed strip bent by moments at its ends."""
    model = Strip(order, 0, nu=0.0, ribs=())
    answer = solve(model.form, 10e3 * model.test[2] * ds("rest|patch")).components[2]
    known = 5 * 10e3 * 12**4 / (384 * E * SLAB**3 / 12) + 10e3 * 12**2 / (8 * E / 2 * SLAB * 5 / 6)
    report("check slab", {"w": answer(model.mesh(0.0, 0.0, 0.0, BND)), "known w": known}, 1e3)
    c, axis = 1e6, 2 * RIB * 0.6 * MIDDLE / (2 * RIB * 0.6 + 4.8 * SLAB)  # stress grows by c z from the axis down
    model = Strip(order, 0, nu=0.0)
    v, (end, foot) = model.test, (dl(definedon=model.mesh.BBoundaries(name)) for name in ("end", "foot"))
    load = c * SLAB * (SLAB**2 / 12 * v[4] - axis * v[0]) * end + c * RIB * (ngsolve.z - axis) * v[0] * foot
    down, found = model.results(load)
    report("check moments", down | {"known w(0)": c / E * 18, "known w(3)": c / E * 13.5}, 1e3)
    known = {"known N": c * RIB * 0.6 * (MIDDLE - axis), "known M": c * RIB * 0.6**3 / 12}
    report("check moments", found | known, 1e-3)


def solid_mesh(held: float) -> ngsolve.Mesh:
    """Return the strip's bricks."""
    net, outside = Net(), {}
    net.mesh.SetMaterial(1, "concrete")
    for (y0, y1), (x0, x1) in product(pairwise(halve(SOLID_Y, 0, mirror=True)), pairwise(STRIP_X)):
        rib = min(abs((y0 + y1) / 2 - b) for b in RIBS) < RIB / 2
        for z0, z1 in pairwise(z for z in SOLID_Z if rib or z <= TOP):
            brick = [(x, y, z) for z in (z0, z1) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
            net.mesh.Add(ng.Element3D(1, [net.point(p) for p in brick]))
            for k in ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)):
                key = frozenset(brick[i] for i in k)
                if outside.pop(key, None) is None:
                    outside[key] = [brick[i] for i in k]
    for corners in outside.values():
        x, y, z = np.mean(corners, axis=0)
        top = z == -SLAB / 2
        name = "patch" if top and x < 1 and 0.7 < y < 1.7 else "top" if top else "middle" if x == 0 else "free"
        net.face("end" if x == STRIP_X[-1] and abs(z) < held else name, corners)
    return ngsolve.Mesh(net.mesh)


def solid(order: int, held: float = SLAB / 2) -> None:
    """Print the results of both loads on the strip as a solid."""
    mesh = solid_mesh(held)
    space = ngsolve.VectorH1(mesh, order=order, dirichletx="middle", dirichletz="end")
    u, v = space.TnT()

    def stress(g: CF) -> CF:
        return E / (1 + NU) * ((g + g.trans) / 2 + NU / (1 - 2 * NU) * Trace(g) * Id(3))

    def cut(value: CF, x: float, y: list[float], z: list[float], middle: float) -> tuple[float, float]:
        (y, wy), (z, wz) = gauss(y), gauss(z)
        s = at(value, mesh, max(x, 2e-7), np.repeat(y, len(z)), np.tile(z, len(y)), VOL).reshape(len(y), -1)
        return wy @ s @ wz, wy @ s @ (wz * (z - middle))

    form = BilinearForm(space, symmetric=True, condense=True)
    form += InnerProduct(stress(Grad(u)), Grad(v)) * dx + SOFT * u[1] * v[1] * dx
    form.Assemble()
    ys, below = halve(SOLID_Y, 0, mirror=True), [z for z in SOLID_Z if z >= TOP]
    for name, q, where in (("a", 10e3, "top|patch"), ("b", 100e3, "patch")):
        answer, found = solve(form, q * v[2] * ds(where)), {}
        s = stress(Grad(answer))[0, 0]
        for x in (0, 3):
            ribs = [cut(s, x, [y for y in ys if abs(y - b) < RIB / 2 + 1e-9], below, MIDDLE) for b in RIBS]
            found |= section(x, ribs, cut(s, x, ys, [z for z in SOLID_Z if z <= TOP], 0.0))
        what = f"solid {name} order {order} held {held}"
        report(what, {f"w{p}": answer(mesh(*map(float, p), 0.0))[2] for p in DOWN}, 1e3)
        report(what, found, 1e-3)


def wall(order: int, fine: int, height: float, slides: bool) -> None:
    """Print the results of both loads on the wall that stands on the raft, joined fully or sliding in the plane."""
    net, xs, ys = Net(), halve(RAFT_X, fine, mirror=True), halve(RAFT_Y, fine, mirror=True)
    zs = halve((-height, -height / 2, -0.4, -0.1, 0), fine)
    net.plate("raft", xs, ys, lambda x, y: (x, y, 0))
    net.plate("wall", [x for x in xs if abs(x) <= 3], zs, lambda x, z: (x, 0, z))
    mesh = net.done({"first": lambda x, _, z: z == -height and x < -2, "others": lambda _x, _, z: z == -height})
    spaces = [H1(mesh, order=order) for _ in range(6)]
    if slides:  # the wall's u_x and u_y are its own
        spaces[:2] = [H1(mesh, order=order, definedon=mesh.Boundaries("raft")) for _ in range(2)]
        spaces += [H1(mesh, order=order, definedon=mesh.Boundaries("wall")) for _ in range(2)]
    space = ngsolve.FESpace(spaces)
    u, v = space.TnT()
    one, other = ([*w[6:], *w[2:6]] if slides else w for w in (u, v))
    form = BilinearForm(space, symmetric=True, condense=True)
    form += work(u[:6], v[:6], EZ, RAFT) * ds("raft") + work(one, other, EY, WALL) * ds("wall")
    form += (K * u[2] * v[2] + SOFT * (u[0] * v[0] + u[1] * v[1])) * ds("raft")
    form += SOFT * (one[0] * other[0] + one[1] * other[1]) * ds("wall")
    form.Assemble()
    for name, q, where in (("all", 300e3, "first|others"), ("first", 600e3, "first")):
        parts = solve(form, q * v[2] * dl(definedon=mesh.BBoundaries(where))).components
        moments = forces(strains(parts[:6], EZ, True), EZ, RAFT, NU)[1]
        what = f"wall {name} H={height} {'slides' if slides else 'joined'} order {order} fine {fine}"
        report(what, {f"w{p}": parts[2](mesh(*map(float, p), 0.0, BND)) for p in SUNK}, 1e3)
        bent = {(k, x, y): at(moments[k, k], mesh, x, [y - 1e-7, y + 1e-7], 0).mean() for k, x, y in BENT}
        report(what, {f"m_{'xy'[k]}({x}, {y})": m for (k, x, y), m in bent.items()}, 1e-3)
        report(what, {"springs": ngsolve.Integrate(K * parts[2] * ds("raft"), mesh)}, 1e-3)


def main() -> None:
    """Print what is asked for."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("orders", type=int, nargs="*", default=[5, 6])
    parser.add_argument("--parts", default="check,strip,solid,wall")
    parser.add_argument("--fine", type=int, default=1, help="how often the shells' lines are halved")
    given = parser.parse_args()
    print("NGSolve", ngsolve.__version__)
    for order in given.orders:
        if "check" in given.parts:
            check(order)
        if "strip" in given.parts:
            strip(order, given.fine)
        if "solid" in given.parts:
            solid(order - 2)
        if "wall" in given.parts:
            for height, slides in product((3.0, 1.0), (False, True)):
                wall(order, given.fine, height, slides)


if __name__ == "__main__":
    main()
