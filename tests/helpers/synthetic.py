"""Results made of formulas, for tests of what is done with results; no equation was solved for them."""

from __future__ import annotations

from dataclasses import fields, replace
from typing import Any

import numpy as np

from groundslab.discretize.nodal_loads import materials
from groundslab.errors import GroundslabError, NoEquilibrium, NotCertified
from groundslab.fem.parts.mesh_plan import MeshPlan
from groundslab.geometry.regions import sections
from groundslab.model.combinations import as_solved
from groundslab.model.ground import Pasternak, Winkler
from groundslab.model.loads.load_cases import Combination, LoadCase
from groundslab.model.loads.load_types import PatchLoad, PointLoad, UniformLoad
from groundslab.model.model import Model
from groundslab.model.plate import Edges, Plate
from groundslab.model.supports import plan_of_plate
from groundslab.results.plate_result import ElementResult, GroundResult, PlateResult
from groundslab.results.records import Certificate, Constants, Step
from groundslab.results.results import CombinationResult, Comparison, Results

LENGTH_X, LENGTH_Y = 9.6, 7.2
K0, K1 = 20e6, 30e6

CERTIFICATE = Certificate(
    residual=3e-12,
    load=5.76e6,
    reaction=5.76e6,
    force_balance=2e-13,
    moment_balance=4e-14,
    ground_balance=1e-11,
    worst_gap=0.0,
    worst_pressure=0.0,
    worst_product=0.0,
    gamma_change=0.0,
    margin_effect=None,
)


def grid(nx: int, ny: int, length_x: float, length_y: float) -> tuple[np.ndarray, np.ndarray]:
    """Return nodes and elements of nx by ny nine-node rectangles around the origin."""
    x = np.linspace(-length_x / 2, length_x / 2, 2 * nx + 1)
    y = np.linspace(-length_y / 2, length_y / 2, 2 * ny + 1)
    X, Y = np.meshgrid(x, y)
    first = 2 * (np.arange(ny)[:, None] * (2 * nx + 1) + np.arange(nx)).ravel()
    row = 2 * nx + 1
    offsets = np.array([0, 2, 2 * row + 2, 2 * row, 1, row + 2, 2 * row + 1, row, row + 1])
    return np.column_stack([X.ravel(), Y.ravel()]), first[:, None] + offsets


def results(n: int = 2, *, shear: bool = False, lifts: bool = True, **changes: Any) -> CombinationResult:
    """Return made-up results on n by n elements: a bowl that lifts at its corners, or a flat settlement.

    With ``shear`` the ground has k1 and reaches beyond the plate, and there is a line force along its edges in contact.
    """
    nodes, elements = grid(n, n, LENGTH_X, LENGTH_Y)
    x, y = nodes.T
    r2 = (x**2 + y**2) / (LENGTH_X**2 / 4 + LENGTH_Y**2 / 4)
    w = 0.028 * (1 - 2 * r2) if lifts else 0.028 * (1 - 0.5 * r2)
    on_edge = (np.abs(x) > LENGTH_X / 2 - 1e-9) | (np.abs(y) > LENGTH_Y / 2 - 1e-9)
    line = np.where(on_edge & (w > 0), 5e5, 0.0) if shear else np.zeros_like(w)
    weights = np.ones(2 * n + 1)
    weights[1::2], weights[2:-1:2] = 4, 2
    area = np.outer(weights, weights).ravel()
    area = area * LENGTH_X * LENGTH_Y / area.sum()
    steps = weights / weights.sum()
    along_x = (np.abs(y) > LENGTH_Y / 2 - 1e-9) * np.tile(steps, 2 * n + 1) * LENGTH_X
    along_y = (np.abs(x) > LENGTH_X / 2 - 1e-9) * np.repeat(steps, 2 * n + 1) * LENGTH_Y
    plate = PlateResult(
        nodes=nodes,
        elements=elements,
        settlement=w,
        rotation_x=-0.005 * x,
        rotation_y=-0.005 * y,
        gap=np.maximum(-w, 0.0),
        penetration=np.zeros_like(w),
        pressure=K0 * np.maximum(w, 0.0),
        line_force=line,
        moment_x=1e5 * (1 - 4 * (x / LENGTH_X) ** 2),
        moment_y=8e4 * (1 - 4 * (y / LENGTH_Y) ** 2) - 1e4,
        moment_xy=2e3 * x * y,
        shear_x=-3e4 * x,
        shear_y=-2e4 * y,
        in_contact=w >= 0,
        edge_length=along_x + along_y,
        area=area,
        contact_area=area * (w >= 0),
    )
    scale = 2 if shear else 1
    ground_nodes, ground_elements = grid(scale * n, scale * n, scale * LENGTH_X, scale * LENGTH_Y)
    top = 0.028 * np.exp(-(ground_nodes**2).sum(axis=1) / 20)
    values: dict[str, Any] = {
        "model": model(shear=shear),
        "plate": plate,
        "ground": GroundResult(ground_nodes, ground_elements, np.stack([top, top / 2]) if shear else top[None]),
        "constants": Constants((K0, 2 * K0), (K1, K1 / 2), 1.1316, 5, 0.25)
        if shear
        else Constants((K0,), (0.0,), None, 0),
        "certificate": CERTIFICATE,
        "steps": (
            Step(340, 1, None, 1, 25, 8, finest=False),
            Step(1234, 1, None, 1, 17, 1, finest=True),
            Step(1234, 1, None, 2, 16, 0, finest=True),
        ),
        "solver": "superlu",
        "unknowns": 1234,
        "mesh_plan": MeshPlan((True, False), (), (), has_coarser=True),
        "combination": "all loads",
        "limit_state": "characteristic",
        "factors": (),
        "supports": (),
    }
    values |= changes
    values.setdefault("solved_model", as_solved(values["model"]))
    return CombinationResult(**{"elements": elements_of(values["plate"], values["model"])} | values)


def in_contact(results: CombinationResult) -> CombinationResult:
    """Return made-up results whose plate touches the ground all over."""
    plate = results.plate
    everywhere = np.ones(len(plate.nodes), dtype=bool)
    return replace(results, plate=replace(plate, in_contact=everywhere, contact_area=plate.area))


def compared(found: CombinationResult, plate: PlateResult | None = None) -> CombinationResult:
    """Return results with a comparison, in which the plate is the one given, and errors of elements from 0 to 3 %."""
    other = Comparison(plate or found.plate, found.elements, found.ground, found.supports, found.constants, 0.02, 0.5)
    error = np.linspace(0.0, 0.03, len(found.elements.section))
    return replace(found, comparison=other, elements=replace(found.elements, discretization_error=error))


def combined() -> Results:
    """Return made-up results of four combinations: two certified, one that is not, and one without any.

    The second has twice the settlements of the first and no uplift.
    """
    cases = [LoadCase(name="dead"), LoadCase(name="wind", action="variable")]
    loads = [UniformLoad(q=1e3, case="dead"), PointLoad(P=-1e5, x=3.0, y=2.0, case="wind")]
    names = ("Größe 1/2: dead + wind", "NUL", "uncertified", "wind alone")
    given = tuple(
        Combination(name=name, factors=factors)
        for name, factors in zip(
            names, ({"dead": 1.35, "wind": 1.5}, {"dead": 2.0}, {"dead": 1.0}, {"wind": 1.0}), strict=True
        )
    )
    whole = model().replace(cases=cases, loads=loads, combinations=given)
    certificates = (CERTIFICATE, replace(CERTIFICATE, load=1e7, residual=4e-9), replace(CERTIFICATE, residual=1.0))
    found = {}
    for each, certificate in zip(given, certificates, strict=False):
        one = results(
            lifts=each.name != "NUL",
            model=whole,
            combination=each.name,
            limit_state=each.limit_state,
            factors=each.factors,
            certificate=certificate,
        )
        if each.name == "NUL":
            one = replace(one, plate=replace(one.plate, settlement=2 * one.plate.settlement))
        found[each.name] = one
    refused: dict[str, GroundslabError] = {
        "uncertified": NotCertified(found.pop("uncertified")),
        "wind alone": NoEquilibrium("the loads pull the plate off"),
    }
    return Results(whole, given, found, refused)


def elements_of(plate: PlateResult, model: Model) -> ElementResult:
    """Return fields of elements that are a plate's nodal fields at the elements' centers; sections are the model's."""
    centre = plate.elements[:, 8]
    section = np.zeros(len(centre), dtype=np.int64)
    if model.plate.zones:
        section = np.maximum(sections(plan_of_plate(model.plate, ()), plate.nodes[centre]), 0)
    names = ("pressure", "moment_x", "moment_y", "moment_xy", "shear_x", "shear_y")
    return ElementResult(
        **{name: getattr(plate, name)[centre] for name in names},
        thickness=np.array([t for _, _, t in materials(model)])[section],
        section=section,
    )


def model(*, shear: bool = False, title: str = "A slab of formulas") -> Model:
    """Return a description that fits the made-up results, with a load of each kind."""
    ground = Pasternak(kind="pasternak", k0=K0, k1=K1) if shear else Winkler(kind="winkler", k=K0)
    return Model(
        title=title,
        plate=Plate(length_x=LENGTH_X, length_y=LENGTH_Y, thickness=0.2, E=23e9, nu=0.17, edges=Edges(left="hinged")),
        ground=ground,
        loads=[
            UniformLoad(kind="uniform", q=1e3),
            PatchLoad(kind="patch", q=1e6, x=(-1.2, 1.2), y=(-1.2, 1.2)),
            PointLoad(kind="point", P=1e5, x=3.0, y=2.0),
        ],
    )


def assert_same(one: Any, other: Any) -> None:
    """Assert that two results agree in every bit."""
    for part in fields(one):
        a, b = getattr(one, part.name), getattr(other, part.name)
        if part.name in ("plate", "elements", "ground"):
            for item in fields(a):
                p, q = getattr(a, item.name), getattr(b, item.name)
                if p is None or q is None:
                    assert p is q, item.name
                    continue
                assert p.dtype == q.dtype, item.name
                assert np.array_equal(p, q), item.name
        else:
            assert a == b, part.name
