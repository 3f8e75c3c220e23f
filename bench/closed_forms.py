"""Slabs whose fields are known in closed form, for bench/told_errors.py."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from groundslab.arrays import Array
from groundslab.model.model import Model
from groundslab.verification import analytic_continuum as continuum
from groundslab.verification import analytic_rigid as rigid
from groundslab.verification.analytic import partly_loaded_circular_plate
from groundslab.verification.analytic_beams import InfinitePlate, Part, Strip
from groundslab.verification.analytic_springs import lifting_circular_plate

SHEAR = 5 / 6
E, NU = 30e9, 0.2
#: Points along a line of the plan or a radius, and around it, at which extremes are looked for.
SAMPLES, ANGLES = 1001, 17
#: Terms of a double series along each side.
TERMS = 1000
#: Places at a time, and half of the distance [m] over which a slope is taken.
CHUNK, STEP = 2000, 1e-4

Fields = dict[str, Array]


@dataclass(frozen=True)
class ClosedForm:
    """A slab without a mesh, sizes of elements [m], what is exact at places (n, 2) and where to look for extremes.

    Or values of extremes alone, by field and sign; "share" is the area in contact, "support" a force.
    """

    name: str
    description: dict[str, Any]
    sizes: tuple[float, ...]
    at: Callable[[Array], Fields] | None = None
    places: Array = field(default_factory=lambda: np.zeros((0, 2)))
    extremes: dict[tuple[str, int], float] = field(default_factory=dict)
    inside: bool = False  # whether the largest shear force lies where it is judged, away from edges
    adaptive: bool = True
    signs: tuple[int, ...] = (1, -1)  # of settlement and pressure whose extremes are exact

    def model(self, **mesh: float) -> Model:
        """Return the slab with a mesh."""
        return Model.model_validate({**self.description, "mesh": mesh})


def closed_forms() -> list[ClosedForm]:
    """Return all of them."""
    return [*circles(), *on_infinite_plates(), *rectangles(), *strips(), *lifting(), *on_continuum(), *rigid_plates()]


def stiffness(t: float, nu: float = NU) -> tuple[float, float]:
    """Return D [N m] and S [N/m] of a plate of thickness t [m]."""
    return E * t**3 / (12 * (1 - nu**2)), SHEAR * E / (2 * (1 + nu)) * t


def radial(
    fields: Callable[[Array], Fields], radius: float, *borders: float
) -> tuple[Callable[[Array], Fields], Array]:
    """Return the fields at places from those along a radius, and places at which to look for extremes.

    At borders [m] fields may jump or have a kink.
    """
    r = radius * np.linspace(1e-9, 1.0, SAMPLES)
    r = np.sort(np.concatenate([r, *([s * (1 - 1e-9), s * (1 + 1e-9)] for s in borders)]))
    known = fields(r)

    def at(places: Array) -> Fields:
        s, angle = np.hypot(*places.T), np.arctan2(places[:, 1], places[:, 0])
        of = {name: np.interp(s, r, values) for name, values in known.items()}
        cos, sin = np.cos(angle), np.sin(angle)
        mean, half = (of["moment_r"] + of["moment_t"]) / 2, (of["moment_r"] - of["moment_t"]) / 2
        found = {
            "settlement": of["settlement"],
            "moment_x": mean + half * (cos**2 - sin**2),
            "moment_y": mean - half * (cos**2 - sin**2),
            "moment_xy": 2 * half * sin * cos,
        }
        if "shear" in of:
            found |= {"shear_x": of["shear"] * cos, "shear_y": of["shear"] * sin}
        if "pressure" in of:
            found["pressure"] = of["pressure"]
        return found

    angles = np.linspace(0, math.pi / 2, ANGLES)
    return at, (r[:, None, None] * np.stack([np.cos(angles), np.sin(angles)], axis=-1)).reshape(-1, 2)


def circles() -> Iterator[ClosedForm]:
    """Yield circular plates on next to no ground, under pressure, a part load and a ring."""
    radius = 2.0
    loads: dict[str, tuple[dict[str, Any], dict[str, float]]] = {
        "all over": ({"kind": "uniform", "q": 1e3}, {"b": radius, "q": 1e3}),
        "on a disk": (
            {"kind": "area", "q": 1e3, "shape": {"kind": "circle", "radius": 0.8}}, {"b": 0.8, "q": 1e3},
        ),
        "on a ring": ({"kind": "line", "q": 1e3, "shape": {"kind": "circle", "radius": 0.8}}, {"b": 0.8, "ring": 1e3}),
    }  # fmt: skip
    for load, (described, given) in loads.items():
        for support, t in (("clamped", 0.1), ("soft", 0.4)):

            def along(
                r: Array, given: dict[str, float] = given, t: float = t, clamped: bool = support == "clamped"
            ) -> Fields:
                rows = [
                    partly_loaded_circular_plate(
                        s, radius=radius, t=t, E=E, nu=NU, factor=SHEAR, clamped=clamped, **given
                    )
                    for s in r
                ]
                found = {name: np.array([row[name] for row in rows]) for name in rows[0]}
                b, ring = given["b"], given.get("ring", 0.0)
                found["shear"] = np.where(
                    r < b, given.get("q", 0.0) * r / 2, (given.get("q", 0.0) * b**2 / 2 + ring * b) / r
                )
                return found

            yield ClosedForm(
                f"circle, {support}, loaded {load}",
                {
                    "plate": {
                        "outline": {"kind": "circle", "radius": radius},
                        "thickness": t, "E": E, "nu": NU, "support": support,
                    },
                    "ground": {"kind": "winkler", "k": 1.0},
                    "contact": {"tensionless": False},
                    "loads": [described],
                },
                (0.4, 0.2, 0.1),
                *radial(along, radius, *([given["b"]] if given["b"] < radius else [])),
                inside=given["b"] < radius,
            )  # fmt: skip


def on_infinite_plates() -> Iterator[ClosedForm]:
    """Yield plates so wide that their edges are not felt, on springs and Pasternak ground, under disks and a ring."""
    for name, t, k0, k1, load in (
        ("disk of 0.6 m", 0.25, 40e6, 0.0, ("disk", 0.6)),
        ("disk of 0.3 m", 0.25, 40e6, 0.0, ("disk", 0.3)),
        ("disk of 1.5 m", 0.25, 40e6, 0.0, ("disk", 1.5)),
        ("disk of 0.6 m, thick", 0.8, 400e6, 0.0, ("disk", 0.6)),
        ("disk of 0.6 m, Pasternak", 0.25, 40e6, 30e6, ("disk", 0.6)),
        ("ring of 1.2 m", 0.25, 40e6, 0.0, ("ring", 1.2)),
    ):
        D, S = stiffness(t)
        plate, (kind, a) = InfinitePlate(D, S, NU, k0, k1), load
        side = 2 * math.ceil(7.5 * (D / k0) ** 0.25)

        def along(r: Array, plate: InfinitePlate = plate, kind: str = kind, a: float = a) -> Fields:
            found = plate.under_disk(r, a, 500e3) if kind == "disk" else plate.under_ring(r, a, 100e3)
            if not plate.k1:
                found["pressure"] = plate.k0 * found["settlement"]
            return found

        shape = {"kind": "circle", "radius": a}
        described = {"kind": "area", "q": 500e3} if kind == "disk" else {"kind": "line", "q": 100e3}
        ground = {"kind": "pasternak", "k0": k0, "k1": k1} if k1 else {"kind": "winkler", "k": k0}
        yield ClosedForm(
            f"infinite plate, {name}",
            {
                "plate": {"length_x": side, "length_y": side, "thickness": t, "E": E, "nu": NU},
                "ground": ground,
                "contact": {"tensionless": False},
                "beyond": {"kind": "infinite" if k1 else "none"},
                "loads": [{**described, "shape": shape}],
            },
            (0.6, 0.4, 0.25),
            *radial(along, side / 2, a),
            inside=True,
            signs=(1,),
        )


def rectangles() -> Iterator[ClosedForm]:
    """Yield simply supported plates on springs and Pasternak ground: Navier's series."""
    for name, t, k0, k1, load in (
        ("all over", 0.2, 2e6, 0.0, None),
        ("all over, Pasternak", 0.2, 20e6, 10e6, None),
        ("on a square of 1.2 m", 0.25, 40e6, 0.0, (-0.6, 0.6, -0.6, 0.6)),
        ("on a square of 0.4 m", 0.25, 40e6, 0.0, (0.8, 1.2, 0.3, 0.7)),
        ("on a rectangle, thick", 1.0, 400e6, 0.0, (-1.0, 1.0, -0.5, 0.5)),
        ("on a square, Pasternak", 0.25, 40e6, 20e6, (-0.6, 0.6, -0.6, 0.6)),
    ):
        a, b = 8.0, 6.0
        at = Navier(a, b, t, k0, k1, load or (-a / 2, a / 2, -b / 2, b / 2))
        x = np.linspace(-a / 2, a / 2, 81)
        y = np.linspace(-b / 2, b / 2, 61)
        X, Y = np.meshgrid(x, y, indexing="ij")
        described: dict[str, Any] = {"kind": "uniform", "q": 100e3}
        if load is not None:
            described = {"kind": "patch", "q": 100e3, "x": load[:2], "y": load[2:]}
        yield ClosedForm(
            f"supported plate loaded {name}",
            {
                "plate": {
                    "length_x": a, "length_y": b, "thickness": t, "E": E, "nu": NU,
                    "edges": dict.fromkeys(("left", "right", "bottom", "top"), "hinged"),
                },
                "ground": {"kind": "pasternak", "k0": k0, "k1": k1} if k1 else {"kind": "winkler", "k": k0},
                "contact": {"tensionless": False},
                "loads": [described],
            },
            (0.6, 0.4, 0.2),
            at,
            np.column_stack([X.ravel(), Y.ravel()]),
        )  # fmt: skip


@dataclass(frozen=True)
class Navier:
    """The fields of a simply supported plate a x b [m] under 100 kPa on a rectangle x0, x1, y0, y1 [m]."""

    a: float
    b: float
    t: float
    k0: float
    k1: float
    load: tuple[float, float, float, float]

    def __call__(self, places: Array) -> Fields:
        """Return the fields at places (n, 2) [m] from the middle.

        Those of TERMS terms and of half as many extrapolated: shear forces have a kink where the load ends, and what
        is left of their series falls with the number of its terms.
        """
        fine, coarse = (self.of(places, terms) for terms in (TERMS, TERMS // 2))
        return {name: 2 * field - coarse[name] for name, field in fine.items()}

    def of(self, places: Array, terms: int) -> Fields:
        """Return the fields of a number of terms along each side."""
        D, S = stiffness(self.t)
        m = np.arange(1, terms + 1)
        alpha, beta = m[:, None] * math.pi / self.a, m[None, :] * math.pi / self.b
        x0, x1, y0, y1 = np.array(self.load) + np.array([self.a, self.a, self.b, self.b]) / 2
        q = 100e3 * 4 / (self.a * self.b) / (alpha * beta)
        q = q * (np.cos(alpha * x0) - np.cos(alpha * x1)) * (np.cos(beta * y0) - np.cos(beta * y1))
        l2 = alpha**2 + beta**2
        softer = 1 + D * l2 / S
        psi = q / (D * l2**2 + (self.k0 + self.k1 * l2) * softer)
        (x, column), (y, row) = (np.unique(places[:, i].round(9), return_inverse=True) for i in (0, 1))
        along_x, along_y = (x[:, None] + self.a / 2) * alpha.T, (y[:, None] + self.b / 2) * beta
        (sin_x, cos_x), (sin_y, cos_y) = ((np.sin(each), np.cos(each)) for each in (along_x, along_y))

        def field(amplitude: Array, of_x: Array, of_y: Array) -> Array:
            by_column = of_x @ amplitude
            some = np.array_split(np.arange(len(places)), len(places) // CHUNK + 1)
            return np.concatenate([(by_column[column[part]] * of_y[row[part]]).sum(axis=1) for part in some])

        found = {
            name: field(amplitude, of_x, of_y)
            for name, amplitude, of_x, of_y in (
                ("settlement", psi * softer, sin_x, sin_y),
                ("moment_x", D * (alpha**2 + NU * beta**2) * psi, sin_x, sin_y),
                ("moment_y", D * (beta**2 + NU * alpha**2) * psi, sin_x, sin_y),
                ("moment_xy", D * (1 - NU) * alpha * beta * psi, cos_x, cos_y),
                ("shear_x", D * l2 * alpha * psi, cos_x, sin_y),
                ("shear_y", D * l2 * beta * psi, sin_x, cos_y),
            )
        }
        return found if self.k1 else found | {"pressure": self.k0 * found["settlement"]}


def along(strip: Strip, length: float, contact: tuple[float, float] | None = None) -> Callable[[Array], Fields]:
    """Return the fields of a strip at places; beyond the part in contact, if given, it is straight."""
    first, last = contact or (-length / 2, length / 2)

    def at(places: Array) -> Fields:
        x, back = np.unique(places[:, 0], return_inverse=True)
        rows = [strip.at(s) for s in np.clip(x, first, last) - first]
        of = {name: np.array([row[name] for row in rows])[back] for name in rows[0]}
        beyond = places[:, 0] - np.clip(places[:, 0], first, last)
        of["settlement"] = of["settlement"] + of["slope"] * beyond
        zero = np.zeros(len(places))
        return {
            "settlement": of["settlement"], "moment_x": of["moment"], "shear_x": of["shear"],
            "moment_y": zero, "moment_xy": zero,
        }  # fmt: skip

    return at


def strip_form(
    name: str, strip: Strip, length: float, description: dict[str, Any], t: float = 0.3, **given: Any
) -> ClosedForm:
    """Return a strip of t [m], 0.8 m wide, nu = 0."""
    # a little inside, where a line load ends, too
    x = np.concatenate(
        [np.linspace(-length / 2, length / 2, 1001), *([s - 1e-9, s + 1e-9] for s in given.get("near", ()))]
    )
    places = np.column_stack([x, np.zeros(len(x))])
    return ClosedForm(
        f"strip, {name}",
        {
            "plate": {"length_x": length, "length_y": 0.8, "thickness": t, "E": E, "nu": 0.0},
            "contact": {"tensionless": "contact" in given},
            **description,
        },
        (0.4, 0.2, 0.1),
        along(strip, length, given.get("contact")),
        places,
        given.get("extremes", {}),
    )


def line(q: float, x: float) -> dict[str, Any]:
    """Return a line load across a strip."""
    return {"kind": "line", "q": q, "points": [(x, -0.4), (x, 0.4)]}


def strips() -> Iterator[ClosedForm]:
    """Yield strips with line loads, patches and two kinds of ground."""
    D, S = stiffness(0.3, 0.0)
    k, k1, L = 20e6, 40e6, 12.0
    springs, pasternak = {"kind": "winkler", "k": k}, {"kind": "pasternak", "k0": k, "k1": k1}
    middle = [line(100e3, 0.0)]
    yield strip_form(
        "line load", Strip(D, S, (Part(L / 2, k0=k), Part(L / 2, k0=k, P=100e3))), L,
        {"ground": springs, "loads": middle}, near=(0.0,),
    )  # fmt: skip
    yield strip_form(
        "line load at its end", Strip(D, S, (Part(L, k0=k), Part(0.0, P=100e3))), L,
        {"ground": springs, "loads": [line(100e3, L / 2)]},
    )  # fmt: skip
    yield strip_form(
        "patch", Strip(D, S, (Part(5.0, k0=k), Part(1.5, q=100e3, k0=k), Part(5.5, k0=k))), L,
        {"ground": springs, "loads": [{"kind": "patch", "q": 100e3, "x": (-1.0, 0.5), "y": (-0.4, 0.4)}]},
    )  # fmt: skip
    yield strip_form(
        "two springs", Strip(D, S, (Part(L / 2, 100e3, k), Part(L / 2, 100e3, 3 * k))), L,
        {
            "ground": springs,
            "soil_zones": [{
                "shape": {"kind": "rectangle", "x": (0.0, L / 2), "y": (-1.0, 1.0)},
                "ground": {"kind": "winkler", "k": 3 * k},
            }],
            "loads": [{"kind": "uniform", "q": 100e3}],
        },
    )  # fmt: skip
    halves = (Part(L / 2, k0=k, k1=k1), Part(L / 2, k0=k, k1=k1, P=100e3))
    yield strip_form(
        "Pasternak", Strip(D, S, halves), L,
        {"ground": pasternak, "loads": middle, "beyond": {"kind": "none"}}, near=(0.0,),
    )  # fmt: skip
    end = math.sqrt(k * k1)
    yield strip_form(
        "Pasternak that goes on", Strip(D, S, halves, end, end), L,
        {"ground": pasternak, "loads": middle, "beyond": {"kind": "infinite", "sides": ["left", "right"]}},
        near=(0.0,),
    )  # fmt: skip


def lifting() -> Iterator[ClosedForm]:
    """Yield strips and a circular plate that lift off."""
    from scipy.optimize import brentq

    k, k1, L, P = 20e6, 20e6, 16.0, 100e3
    D, S = stiffness(0.3, 0.0)
    for name, shear, kind in (("springs", 0.0, "winkler"), ("Pasternak", k1, "pasternak")):
        end = math.sqrt(k * shear)

        def pressed(c: float, shear: float = shear, end: float = end) -> Strip:
            return Strip(D, S, (Part(c, k0=k, k1=shear), Part(c, k0=k, k1=shear, P=P)), end, end)

        def misfit(c: float, shear: float = shear) -> float:
            found = pressed(c).at(2 * c)
            return found["settlement"] if not shear else found["shear"]

        length = (4 * D / k) ** 0.25
        c = float(brentq(misfit, 0.5 * length, 2.2 * length, xtol=1e-12))
        ground = {"kind": kind, "k": k} if not shear else {"kind": kind, "k0": k, "k1": shear}
        beyond = {"kind": "infinite", "sides": ["left", "right"]} if shear else {"kind": "none"}
        edge = pressed(c).at(2 * c)
        gap = -(edge["settlement"] + edge["slope"] * (L / 2 - c))
        if shear:
            gap += edge["settlement"] * math.exp(-math.sqrt(k / shear) * (L / 2 - c))
        yield strip_form(
            f"lifting from {name}", pressed(c), L,
            {"ground": ground, "loads": [line(P, 0.0)], "beyond": beyond},
            contact=(-c, c), near=(0.0,), extremes={("share", 1): 2 * c / L, ("gap", 1): gap},
        )  # fmt: skip
    given = {"radius": 5.0, "b": 0.4, "P": 1e6, "t": 0.4, "E": E, "nu": NU, "factor": SHEAR, "k": 200e6}

    def moment(r: Array) -> Array:
        return np.array([lifting_circular_plate(s, **given)["moment"] for s in r])

    def of_circle(r: Array) -> Fields:
        settlement = np.array([lifting_circular_plate(s, **given)["settlement"] for s in r])
        # m_t = (r m_r)' - r Q, and Q is what ground and load within r have left over
        w, q = np.maximum(settlement, 0.0), given["P"] / (math.pi * given["b"] ** 2)
        ground = given["k"] * np.concatenate([[0.0], np.cumsum((w[1:] * r[1:] + w[:-1] * r[:-1]) / 2 * np.diff(r))])
        shear = (ground - q * np.minimum(r, given["b"]) ** 2 / 2) / r
        low, high = np.clip(r - STEP, 1e-6, None), np.clip(r + STEP, None, given["radius"])
        m = moment(r)
        slope = (moment(high) - moment(low)) / (high - low)
        return {
            "settlement": settlement, "moment_r": m, "moment_t": m + r * (slope - shear), "shear": shear,
            "pressure": given["k"] * w,
        }  # fmt: skip

    radius = lifting_circular_plate(0.0, **given)["contact radius"]
    rim = lifting_circular_plate(given["radius"], **given)["settlement"]
    yield ClosedForm(
        "circle that lifts",
        {
            "plate": {"outline": {"kind": "circle", "radius": 5.0}, "thickness": 0.4, "E": E, "nu": NU},
            "ground": {"kind": "winkler", "k": given["k"]},
            "loads": [{
                "kind": "area", "q": given["P"] / (math.pi * given["b"] ** 2),
                "shape": {"kind": "circle", "radius": given["b"]},
            }],
        },
        (0.8, 0.4, 0.2),
        *radial(of_circle, 5.0, 0.4),
        inside=True,
        extremes={("share", 1): (radius / 5.0) ** 2, ("gap", 1): -rim},
    )  # fmt: skip


def on_continuum() -> Iterator[ClosedForm]:
    """Yield flexible and rigid plates on a half-space and on a layer, whose settlements are known."""
    half_space = {"kind": "continuum", "half_space": {"E": 20e6, "nu": 0.3}}
    layer = {"kind": "continuum", "layers": [{"E": 20e6, "nu": 0.3, "thickness": 3.0}]}
    thin, stiff = {"thickness": 0.01, "E": 1e9, "nu": 0.0}, {"thickness": 1.0, "E": 20e12, "nu": 0.0}
    given = {"q": 100e3, "E": 20e6, "nu": 0.3}
    rectangle, circle = {"length_x": 5.0, "length_y": 2.5}, {"outline": {"kind": "circle", "radius": 2.0}}
    flexible, whole = (0, 0, 5.0, 2.5), 400e3 * math.pi
    for name, plate, ground, w in (
        ("flexible rectangle", {**rectangle, **thin}, half_space, continuum.flexible_rectangle(*flexible, **given)),
        ("flexible circle", {**circle, **thin}, half_space, continuum.flexible_circle(0, 2.0, **given)),
        ("flexible circle on a layer", {**circle, **thin}, layer, continuum.flexible_circle(0, 2.0, h=3.0, **given)),
        (
            "rigid rectangle", {**rectangle, **stiff}, half_space,
            continuum.rigid_rectangle_on_half_space(0, 5.0, 2.5, 1.25e6, 20e6, 0.3),
        ),
        (
            "rigid circle", {**circle, **stiff}, half_space,
            continuum.rigid_circle_on_half_space(0, 2.0, whole, 20e6, 0.3),
        ),
        (
            "rigid circle on a layer", {**circle, **stiff}, layer,
            continuum.rigid_circle_on_layer(2.0, whole, 20e6, 0.3, 3.0),
        ),
    ):  # fmt: skip
        yield ClosedForm(
            f"continuum, {name}",
            {
                "plate": plate, "ground": ground, "contact": {"tensionless": False},
                "loads": [{"kind": "uniform", "q": 100e3}],
            },
            (0.5, 0.25, 0.125),
            extremes={("settlement", 1): w},
            adaptive=False,
        )  # fmt: skip


def rigid_plates() -> Iterator[ClosedForm]:
    """Yield rigid plates that lift off springs: displacements, pressure and contact by statics."""
    stiff, springs = {"thickness": 1.0, "E": 1e13, "nu": 0.0}, {"kind": "winkler", "k": 20e6}
    strip, corner = {"length_x": 4.0, "length_y": 1.0}, {"length_x": 4.0, "length_y": 3.0}
    circle, force = {"outline": {"kind": "circle", "radius": 2.0}}, {"kind": "patch", "q": 25e6}
    across = {"kind": "patch", "q": 3e6, "x": (-1.2, -1.0), "y": (-0.5, 0.5)}
    w_strip = [rigid.rigid_plate_on_springs(x, 4.0, 600e3, 0.9, 20e6) for x in (0.0, 4.0)]
    w_corner = [rigid.rigid_plate_by_its_corner(x, y, 1e6, 0.8, 0.6, 20e6) for x, y in ((0.0, 0.0), (4.0, 3.0))]
    w_circle = [rigid.rigid_circle_on_springs(x, 2.0, 1e6, 1.0, 20e6) for x in (2.0, -2.0)]
    angle = math.acos(-1 + 2 * w_circle[1] / (w_circle[1] - w_circle[0]))
    for name, plan, load, (top, bottom), share in (
        ("strip", strip, across, w_strip, 3 * 0.9 / 4.0),
        ("corner", corner, {**force, "x": (-1.3, -1.1), "y": (-1.0, -0.8)}, w_corner, 8 * 0.8 * 0.6 / 12.0),
        (
            "circle", circle, {**force, "x": (0.9, 1.1), "y": (-0.1, 0.1)}, w_circle,
            (angle - math.sin(angle) * math.cos(angle)) / math.pi,
        ),
    ):  # fmt: skip
        extremes = {
            ("settlement", 1): top, ("settlement", -1): bottom, ("gap", 1): -bottom, ("pressure", 1): 20e6 * top,
            ("share", 1): share,
        }  # fmt: skip
        yield ClosedForm(
            f"rigid {name}", {"plate": {**plan, **stiff}, "ground": springs, "loads": [load]}, (0.4, 0.2, 0.1),
            extremes=extremes,
        )  # fmt: skip
