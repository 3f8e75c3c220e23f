"""The description: its rules, and that each broken one is reported with its exact place, all at once."""

from __future__ import annotations

import pickle
import re
import runpy
from collections.abc import Iterator
from copy import deepcopy
from dataclasses import FrozenInstanceError
from typing import Any

import numpy as np
import pytest

import groundslab
from groundslab.case.casefile import loads, to_toml
from groundslab.errors import InputError
from groundslab.geometry.plan import MOST_ELEMENTS
from groundslab.model.ground import InterfaceLayer, Layered, Pasternak, Selvadurai, SoilLayer, Vlasov, Winkler
from groundslab.model.loads.load_types import PatchLoad, PointLoad, UniformLoad
from groundslab.model.model import Model, docs_table, json_schema
from groundslab.model.plate import Edges, Plate
from groundslab.model.settings import Analysis, Beyond, Contact, Mesh
from groundslab.model.varying_ground import Void
from groundslab.schema.base import Section
from groundslab.schema.fields import FieldType
from helpers.paths import ROOT

PLATE = {"length_x": "6 m", "length_y": "4 m", "thickness": "0.25 m", "E": "30 GPa", "nu": 0.2}
LAYER = {"E": "20 MPa", "nu": 0.3, "thickness": "2 m"}
BY_K = {"k0": "20 MPa/m", "k1": "5 MN/m"}
WINKLER = {"kind": "winkler", "k": "20 MPa/m"}
PASTERNAK = {"kind": "pasternak", "k0": "20 MPa/m", "k1": "5 MN/m"}
VLASOV = {"kind": "vlasov", "layers": [LAYER]}
INTERFACE = {"kind": "layered", "coupling": "interface", "layers": [BY_K, BY_K]}
CONSISTENT = {"kind": "layered", "coupling": "consistent", "layers": [LAYER, LAYER]}
UNIFORM = {"kind": "uniform", "q": "10 kPa"}
PATCH = {"kind": "patch", "q": "10 kPa", "x": ["0 m", "1 m"], "y": ["0 m", "1 m"]}
POINT = {"kind": "point", "P": "10 kN", "x": "0 m", "y": "0 m"}
VOID = {"depth": "5 mm", "x": ["0 m", "1 m"], "y": ["0 m", "1 m"]}
CASE: dict[str, Any] = {"plate": PLATE, "ground": WINKLER, "loads": [UNIFORM]}


KINDS = '"winkler", "pasternak", "vlasov", "layered", "continuum" or "constrained modulus"'


def case(**changes: Any) -> dict[str, Any]:
    """Return a description as a file holds it: sound but for the changes, ``section__key`` going one level down."""
    data = deepcopy(CASE)
    for name, value in changes.items():
        section, _, key = name.partition("__")
        if key:
            data.setdefault(section, {})[key] = value
        else:
            data[section] = value
    return data


def from_file(data: object) -> Model:
    """Return the Model of what a file holds."""
    return Model.model_validate(data, from_file=True)


def issues(data: object) -> list[tuple[str, str, str, str]]:
    """Return all issues of what a file holds."""
    with pytest.raises(InputError) as error:
        from_file(data)
    return [(issue.location, issue.found, issue.expected, issue.hint) for issue in error.value.issues]


ONE_FAULT = [
    # dimensional keys
    (case(plate__E=30), "plate.E", "30", 'a pressure such as "30 MPa"'),
    (case(plate__E=30.5), "plate.E", "30.5", 'a pressure such as "30 MPa"'),
    (case(plate__E="30"), "plate.E", '"30"', 'a pressure such as "30 MPa"'),
    (case(plate__E="30 m"), "plate.E", '"30 m"', 'a pressure such as "30 MPa"'),
    (case(plate__E="-30 GPa"), "plate.E", '"-30 GPa"', "a pressure above 0"),
    (case(plate__E="0 GPa"), "plate.E", '"0 GPa"', "a pressure above 0"),
    (case(plate__E=True), "plate.E", "true", 'a pressure such as "30 MPa"'),
    (case(plate__E=["30 GPa"]), "plate.E", "a list of 1", 'a pressure such as "30 MPa"'),
    (case(plate__E={"top": 1}), "plate.E", "a table", 'a pressure such as "30 MPa"'),
    (case(plate__length_x="nan m"), "plate.length_x", '"nan m"', 'a length such as "0.2 m"'),
    (case(plate__thickness="0 m"), "plate.thickness", '"0 m"', "a length above 0"),
    (case(ground__k=20_000_000), "ground.k", "20000000", 'a pressure per length such as "20 MPa/m"'),
    (case(ground={**PASTERNAK, "k1": "-1 N/m"}), "ground.k1", '"-1 N/m"', "a pressure times length at least 0"),
    (case(loads=[{**POINT, "P": "10 kPa"}]), "loads[1].P", '"10 kPa"', 'a force such as "50 kN"'),
    # pure numbers
    (case(plate__nu=0.5), "plate.nu", "0.5", "a number at least 0 and below 0.5"),
    (case(plate__nu=-0.1), "plate.nu", "-0.1", "a number at least 0 and below 0.5"),
    (case(plate__nu="0.2"), "plate.nu", '"0.2"', "a number at least 0 and below 0.5"),
    (case(plate__nu=False), "plate.nu", "false", "a number at least 0 and below 0.5"),
    (case(plate__nu=float("nan")), "plate.nu", "nan", "a number at least 0 and below 0.5"),
    (case(plate__nu=10**400), "plate.nu", "a huge number", "a number at least 0 and below 0.5"),
    (case(plate__shear_factor=0), "plate.shear_factor", "0", "a number above 0 and at most 1"),
    (case(plate__shear_factor=1.1), "plate.shear_factor", "1.1", "a number above 0 and at most 1"),
    # words
    (case(plate__element="Q8"), "plate.element", '"Q8"', '"mitc9", "q9" or "heterosis"'),
    (
        case(plate__edges={"left": "fixed"}),
        "plate.edges.left", '"fixed"', '"free", "hinged", "soft" or "clamped"',
    ),
    (case(plate__edges="free"), "plate.edges", '"free"', "a table of keys"),
    (case(title=3), "title", "3", "text in quotes"),
    (case(contact__tensionless=1), "contact.tensionless", "1", "true or false"),
    (case(analysis__nested="true"), "analysis.nested", '"true"', "true or false"),
    # tables
    (case(plate=3), "plate", "3", "a table of keys"),
    (case(plate=[PLATE]), "plate", "a list of 1", "a table of keys"),
    (case(loads=UNIFORM), "loads", "a table", "a list of tables"),
    (case(loads=[]), "loads", "an empty list", "at least one table [[loads]]"),
    (case(loads=[UNIFORM, 3]), "loads[2]", "3", "a table of keys"),
    (case(ground={"k": "20 MPa/m"}), "ground.kind", "nothing", KINDS),
    (case(ground__kind="winckler"), "ground.kind", '"winckler"', KINDS),
    (case(ground__kind=["winkler"]), "ground.kind", "a list of 1", KINDS),
    (
        case(loads=[{"kind": "blob"}]),
        "loads[1].kind",
        '"blob"',
        '"uniform", "patch", "area", "line", "line moment", "point", "self weight", "temperature", "shrinkage", '
        '"settlement" or "core"',
    ),
    # ground
    (case(ground={"kind": "winkler"}), "ground", "neither k nor selvadurai", "exactly one of k and selvadurai"),
    (
        case(ground={**WINKLER, "selvadurai": {"E": "40 MPa", "depth": "5 m"}}),
        "ground", "both k and selvadurai", "exactly one of k and selvadurai",
    ),
    (
        case(ground={"kind": "winkler", "selvadurai": {"E": "40 MPa"}}),
        "ground.selvadurai.depth", "nothing", 'a length such as "0.2 m"',
    ),
    (case(ground={**VLASOV, "layers": []}), "ground.layers", "an empty list", "at least one table"),
    (
        case(ground={**VLASOV, "layers": [LAYER, {**LAYER, "E": 30}]}),
        "ground.layers[2].E", "30", 'a pressure such as "30 MPa"',
    ),
    (
        case(ground={**VLASOV, "layers": [{**LAYER, "variation": "cubic"}]}),
        "ground.layers[1].variation", '"cubic"', '"linear" or "quadratic"',
    ),
    (
        case(ground={**VLASOV, "layers": [{**LAYER, "E_bottom": "0 Pa"}]}),
        "ground.layers[1].E_bottom", '"0 Pa"', "a pressure above 0",
    ),
    (case(ground={**VLASOV, "gamma": 0}), "ground.gamma", "0", 'a number above 0 and at most 1000 or "iterate"'),
    (
        case(ground={**VLASOV, "gamma": "auto"}),
        "ground.gamma", '"auto"', 'a number above 0 and at most 1000 or "iterate"',
    ),
    (
        case(ground={**VLASOV, "layers": [LAYER, LAYER], "mode": "sinh"}),
        "ground.mode", '"sinh" with 2 layers', 'one layer, or mode = "profile"',
    ),
    (
        case(ground={**VLASOV, "layers": [LAYER, LAYER], "formulas": "as printed"}),
        "ground.formulas", '"as printed" with 2 layers', 'one layer, or formulas = "exact"',
    ),
    (
        case(ground={**VLASOV, "layers": [{**LAYER, "sublayers": 4}]}),
        "ground.layers[1].sublayers", "4", 'no sublayers, which only a layered ground with coupling = "consistent" has',
    ),
    (
        case(ground={**INTERFACE, "layers": [LAYER, {**LAYER, "sublayers": 4}]}),
        "ground.layers[2].sublayers", "4", 'no sublayers, which only a layered ground with coupling = "consistent" has',
    ),
    (
        case(ground={**CONSISTENT, "layers": [{**LAYER, "sublayers": 0}]}),
        "ground.layers[1].sublayers", "0", "a whole number from 1 to 100",
    ),
    (
        case(ground={**CONSISTENT, "layers": [{**LAYER, "sublayers": 1.0}]}),
        "ground.layers[1].sublayers", "1.0", "a whole number from 1 to 100",
    ),
    (
        case(ground={**INTERFACE, "layers": [BY_K, LAYER]}),
        "ground.layers", "layers of both kinds", "all layers given by k0 and k1, or all by E, nu and thickness",
    ),
    (
        case(ground={**INTERFACE, "layers": [{**LAYER, "k0": "20 MPa/m"}]}),
        "ground.layers[1].k0", "an unknown key", "one of E, E_bottom, variation, nu, thickness, sublayers",
    ),
    (
        case(ground={**CONSISTENT, "layers": [LAYER, BY_K]}),
        "ground.layers[2]", "k0 and k1", 'E, nu and thickness, as coupling is "consistent"',
    ),
    (
        case(ground={**INTERFACE, "gamma": 1.0}),
        "ground.gamma", "1.0", "no gamma, which only interface layers given by E use",
    ),
    (
        case(ground={**INTERFACE, "gamma": "iterate"}),
        "ground.gamma", '"iterate"', "no gamma, which only interface layers given by E use",
    ),
    (
        case(ground={**CONSISTENT, "gamma": 1.0}),
        "ground.gamma", "1.0", "no gamma, which only interface layers given by E use",
    ),
    (
        case(ground={**CONSISTENT, "formulas": "as printed"}),
        "ground.formulas", '"as printed"', "no formulas, which only interface layers given by E use",
    ),
    # beyond
    (case(beyond__width="5 m"), "beyond.width", "5.0 m", 'no width, as kind is "none"'),
    (case(beyond__edge="fixed"), "beyond.edge", '"fixed"', 'no edge, as kind is "none"'),
    (case(beyond__edge="free"), "beyond.edge", '"free"', 'no edge, as kind is "none"'),
    (
        case(ground=PASTERNAK, beyond={"kind": "infinite", "edge": "free"}),
        "beyond.edge", '"free"', 'no edge, as kind is "infinite"',
    ),
    (
        case(ground=PASTERNAK, beyond={"kind": "margin"}),
        "beyond.width", "nothing", 'a length such as "5 m", as kind is "margin"',
    ),
    (
        case(ground=PASTERNAK, beyond={"kind": "infinite", "sides": []}),
        "beyond.sides", "an empty list", 'a list of at least one, each "left", "right", "bottom" or "top"',
    ),
    (
        case(ground=PASTERNAK, beyond={"kind": "infinite", "sides": ["left", "left"]}),
        "beyond.sides", '["left", "left"]', "each value at most once",
    ),
    (
        case(ground=PASTERNAK, beyond={"kind": "infinite", "sides": ["left", "up"]}),
        "beyond.sides[2]", '"up"', '"left", "right", "bottom" or "top"',
    ),
    (
        case(ground={**INTERFACE, "layers": [BY_K, {**BY_K, "k1": "0 N/m"}]}, beyond={"kind": "infinite"}),
        "ground.layers[2].k1", "0 N/m", "k1 above 0, as other ground has it and is infinite",
    ),
    # contact
    (case(contact__gap="-1 mm"), "contact.gap", '"-1 mm"', "a length at least 0"),
    (
        case(contact={"tensionless": False, "gap": "1 mm"}),
        "contact.gap", "0.001 m", "no gap, as tensionless is false",
    ),
    (
        case(contact={"tensionless": False, "voids": [VOID]}),
        "contact.voids", "a list of 1", "no voids, as tensionless is false",
    ),
    (case(contact__voids=[{**VOID, "depth": "0 m"}]), "contact.voids[1].depth", '"0 m"', "a length above 0"),
    (
        case(contact__voids=[VOID, {**VOID, "x": ["1 m", "1 m"]}]),
        "contact.voids[2].x", '["1 m", "1 m"]', "the smaller value first and no empty range",
    ),
    (
        case(contact__voids=[VOID, {**VOID, "y": ["1 m", "2.1 m"]}]),
        "contact.voids[2].y", "[1.0 m, 2.1 m]", "a position on the plate, from -2.0 m to 2.0 m",
    ),
    # loads
    (
        case(loads=[{**PATCH, "x": ["1 m", "0 m"]}]),
        "loads[1].x", '["1 m", "0 m"]', "the smaller value first and no empty range",
    ),
    (
        case(loads=[{**PATCH, "x": ["1 m"]}]),
        "loads[1].x", "a list of 1", 'a list of 2, each a length such as "0.2 m"',
    ),
    (case(loads=[{**PATCH, "x": ["0 m", 1]}]), "loads[1].x[2]", "1", 'a length such as "0.2 m"'),
    (
        case(loads=[UNIFORM, {**PATCH, "x": ["3 m", "3.01 m"]}]),
        "loads[2]", "a load off the plate",
        "a load at least partly on the plate, not in an opening or outside the outline",
    ),
    (
        case(loads=[{**POINT, "y": "-2.01 m"}]),
        "loads[1].y", "-2.01 m", "a position on the plate, from -2.0 m to 2.0 m",
    ),
    (case(loads=[{**UNIFORM, "name": 3}]), "loads[1].name", "3", "text in quotes"),
    # mesh and analysis
    (case(mesh={"size": "1 m", "counts": [2, 2]}), "mesh", "both size and counts", "at most one of size and counts"),
    (
        case(mesh={"accuracy": "fine"}),
        "mesh.accuracy", '"fine"', 'a share such as "5 %", "draft", "normal" or "strict"',
    ),
    (case(mesh={"accuracy": "60 %"}), "mesh.accuracy", '"60 %"', "a share at most 50 %"),
    (case(mesh={"max_unknowns": 999}), "mesh.max_unknowns", "999", "a whole number from 1000 to 10000000"),
    (
        case(mesh={"size": "1 m", "max_unknowns": 5000}),
        "mesh.max_unknowns", "5000", "no max_unknowns, as size says what the mesh is",
    ),
    (
        case(mesh={"counts": [2, 2], "max_unknowns": 300_000}),
        "mesh.max_unknowns", "300000", "no max_unknowns, as counts says what the mesh is",
    ),
    (case(mesh__size="0 m"), "mesh.size", '"0 m"', "a length above 0"),
    (case(mesh__counts=[2, 0]), "mesh.counts[2]", "0", "a whole number from 1 to 100000"),
    (case(mesh__counts=[2, 2.0]), "mesh.counts[2]", "2.0", "a whole number from 1 to 100000"),
    (case(mesh__counts=[2, True]), "mesh.counts[2]", "true", "a whole number from 1 to 100000"),
    (
        case(mesh__counts=[2]),
        "mesh.counts", "a list of 1", "a list of 2, each a whole number from 1 to 100000",
    ),
    (case(mesh__counts=[2000, 2001]), "mesh.counts", "about 4e+06 elements", "at most 4,000,000 elements"),
    (case(mesh__size="1 mm"), "mesh.size", "about 2.4e+07 elements", "at most 4,000,000 elements"),
    (case(plate__length_x="1e4 km"), "mesh", "about 9e+07 elements", "at most 4,000,000 elements"),
    (
        case(ground={**CONSISTENT, "layers": [LAYER, {**LAYER, "sublayers": 100}, {**LAYER, "sublayers": 100}]}),
        "ground.layers", "201 layers and sublayers", "at most 200",
    ),
    (
        case(mesh__size="10 mm", ground={**CONSISTENT, "layers": [LAYER, {**LAYER, "sublayers": 99}]}),
        "ground.layers", "100 layers and sublayers on about 2.4e+05 elements",
        "at most 4,000,000 for the product of both",
    ),
    (case(analysis__increments=0), "analysis.increments", "0", "a whole number from 1 to 1000"),
    (case(analysis__increments=10**30), "analysis.increments", str(10**30), "a whole number from 1 to 1000"),
    (case(analysis__max_iterations=0), "analysis.max_iterations", "0", "a whole number from 1 to 10000"),
    (case(analysis__solver="cg"), "analysis.solver", '"cg"', '"auto", "pardiso", "cholmod", "superlu" or "mumps"'),
]  # fmt: skip


def test_one_fault() -> None:
    """Each rule, broken alone, gives exactly one issue with the exact place, what is there, and what should be."""
    for data, where, found, expected in ONE_FAULT:
        (issue,) = issues(data)
        assert issue[:3] == (where, found, expected)


@pytest.mark.parametrize("name", ["length_x", "length_y", "thickness", "E", "nu"])
def test_missing_key(name: str) -> None:
    """A key that is needed and missing is named with an example of what it should hold."""
    data = case()
    del data["plate"][name]
    ((where, found, _, _),) = issues(data)
    assert (where, found) == (f"plate.{name}", "nothing")


@pytest.mark.parametrize(
    ("section", "expected"),
    [("plate", "a table [plate]"), ("ground", "a table [ground]"), ("loads", "at least one table [[loads]]")],
)
def test_missing_section(section: str, expected: str) -> None:
    """A section that is needed and missing is named as it would be written."""
    data = case()
    del data[section]
    assert issues(data) == [(section, "nothing", expected, "")]


@pytest.mark.parametrize(
    ("data", "where", "fix"),
    [
        (case(plate__thicknes="1 m"), "plate.thicknes", 'did you mean "thickness"?'),
        (case(plate__e="1 Pa"), "plate.e", 'did you mean "E"?'),
        (case(plate__NU=0.2), "plate.NU", 'did you mean "nu"?'),
        (case(load=[]), "load", 'did you mean "loads"?'),
        (case(ground__modulus=1), "ground.modulus", ""),
        (case(ground={**VLASOV, "layers": [LAYER, {**LAYER, "tickness": 1}]}), "ground.layers[2].tickness",
         'did you mean "thickness"?'),
        (case(**{"plate__a b": 1}), 'plate."a b"', ""),
        (case(**{"plate__\x1b[31m": 1}), 'plate."\\u001b[31m"', ""),
        (case(**{"plate__" + "x" * 200: 1}), f'plate."{"x" * 37}..."', ""),
    ],
)  # fmt: skip
def test_unknown_key(data: object, where: str, fix: str) -> None:
    """An unknown key is named, made harmless for a terminal, with the known ones and the one that was meant."""
    ((place, found, expected, hint),) = issues(data)
    assert (place, found, hint) == (where, "an unknown key", fix)
    assert expected.startswith("one of ")


AXES = {"bottom": ["40 mm", "50 mm"], "top": ["40 mm", "50 mm"]}


@pytest.mark.parametrize(
    ("part", "key", "word", "hint"),
    [
        ({"reinforcement": AXES}, "concrete", "C28/36", "give the strength of any other class as f_ck"),
        ({"floor": {"kind": "TR34"}}, "concrete", "C34/45", "give the strength of any other class as f_ck"),
        ({"reinforcement": AXES}, "steel", "B500", "give the yield strength of any other steel as f_yk"),
        ({"reinforcement": AXES}, "exposure", "XC5", ""),
        ({"reinforcement": AXES}, "annex", "United States", "other values: gamma_c, gamma_s and alpha_cc"),
        ({"reinforcement": AXES}, "code", "ACI 360", ""),
        ({"reinforcement": AXES}, "top_mesh", "A192", "give the wires of any other mesh by diameter and spacing"),
        (
            {"cases": {"name": "a", "action": "variable"}},
            "category",
            "C5",
            "give psi_0, psi_1 and psi_2 of any other action",
        ),
        ({"combinations": {"name": "U", "factors": {"a": 1.0}}}, "limit_state", "permanent", ""),
        ({"combine": {"sets": ["ultimate"]}}, "expression", "6.10a", ""),
    ],
)
def test_no_suggestion_of_something_else(part: dict[str, dict[str, object]], key: str, word: str, hint: str) -> None:
    """A word that resembles a stronger class, another action or limit state is not answered with that one."""
    ((name, table),) = part.items()
    section: object = {**table, key: word}
    found = issues(case(**{name: [section] if name in ("cases", "combinations") else section}))
    assert [issue[3] for issue in found if issue[1] == f'"{word}"'] == [hint]


@pytest.mark.parametrize("factors", [3, 2.5, True, "a", ["a", 1.0], None])
def test_factors_that_are_no_table(factors: object) -> None:
    """Anything but a table of numbers is refused in words."""
    data = case(cases=[{"name": "a"}], combinations=[{"name": "U", "factors": factors}])
    places = [place for place, _, expected, _ in issues(data) if "a table of numbers" in expected]
    assert places == ["combinations[1].factors"]


def test_spelling_of_classes() -> None:
    """A class in other letters or with other signs is still recognized."""
    assert issues(case(reinforcement={**AXES, "concrete": "c30-37"}))[0][3] == 'did you mean "C30/37"?'


def test_suggestion_for_words() -> None:
    """A mistyped word or kind is answered with the one that was meant."""
    assert issues(case(plate__element="mitc"))[0][3] == 'did you mean "mitc9"?'
    assert issues(case(ground__kind="Winkler"))[0][3] == 'did you mean "winkler"?'


def test_hints() -> None:
    """The commonest mistakes are reported with a hint."""
    assert issues(case(plate__E=30))[0][3] == "write number and unit in quotes"
    assert issues(case(plate__nu="0.2"))[0][3] == "write it without quotes"
    assert issues(case(contact__tensionless="true"))[0][3] == "write it without quotes"
    assert issues(case(loads=UNIFORM))[0][3] == "write double brackets: [[...]]"
    assert issues(case(plate=[PLATE]))[0][3] == "write single brackets: [...]"


def test_all_at_once() -> None:
    """Faults in several sections, in lists, and between sections come together, in the order of the description."""
    data = case(
        plate={**PLATE, "E": 30},
        ground={**VLASOV, "layers": [LAYER, {**LAYER, "nu": 0.5}, 3], "mode": "sinh", "gama": 1},
        beyond={"kind": "margin", "edge": "loose"},
        loads=[UNIFORM, {**PATCH, "q": 3}, {"kind": "blob"}],
        mesh={"counts": [0, 3], "size": "-1 m"},
        analysis={"increments": 0},
        extra=1,
    )
    assert [where for where, *_ in issues(data)] == [
        "plate.E",
        "ground.layers[2].nu",
        "ground.layers[3]",
        "ground.gama",
        "beyond.edge",
        "beyond.width",
        "loads[2].q",
        "loads[3].kind",
        "mesh.size",
        "mesh.counts[1]",
        "analysis.increments",
        "extra",
    ]


def test_checks_between_fields_run_beside_faults() -> None:
    """A check runs if what it needs is sound, although other keys of the same section or other sections are not."""
    data = case(
        plate=PLATE,
        ground={**VLASOV, "layers": [LAYER, LAYER], "mode": "sinh", "gamma": -1},
        beyond={"kind": "margin", "edge": "loose"},
        loads=[{**POINT, "x": "9 m"}],
        mesh={"size": "1 mm", "counts": [2, 2], "symmetry": "no"},
    )
    assert [where for where, *_ in issues(data)] == [
        "ground.gamma", "ground.mode", "beyond.edge", "beyond.width", "mesh.symmetry", "mesh", "loads[1].x",
    ]  # fmt: skip


def test_broken_section_is_not_checked_against_others() -> None:
    """Nothing is said about positions on a plate whose size is unknown."""
    assert [where for where, *_ in issues(case(plate__length_x="x", loads=[{**POINT, "x": "9 m"}]))] == [
        "plate.length_x"
    ]


def test_flood_of_faults_is_bounded() -> None:
    """A file of nothing but mistakes gives a report that can be read."""
    data = case() | {f"key{i}": i for i in range(900)}
    assert 100 <= len(issues(data)) <= 102
    data = case() | {f"key{i}": i for i in range(100_000)}
    (issue,) = issues(data)
    assert issue[:2] == ("the description", "a table of 100003 keys")


@pytest.mark.parametrize("data", [None, 3, "text", [], [1], object(), {1: 2}, {"plate": {1: 2}}, b"x"])
def test_no_table_at_all(data: object) -> None:
    """What is no table of named keys is an InputError too."""
    assert issues(data)


def test_python_takes_si_numbers_and_text() -> None:
    """In Python plain numbers are SI units, text has its unit, and both give the same description as a file."""
    model = Model(
        plate=Plate(length_x=6, length_y=4.0, thickness="250 mm", E=np.float64(30e9), nu=0.2),
        ground=Winkler(k="20 MPa/m"),
        loads=[UniformLoad(q=10_000)],
    )
    assert model == from_file(case())
    assert isinstance(model.plate.E, float)
    assert type(model.plate.length_x) is float
    assert model.plate.nu == 0.2
    assert Plate(length_x=6, length_y=4, thickness=1, E=1, nu=0).nu == 0.0


def test_defaults() -> None:
    """What is left out has the documented default."""
    model = from_file(case())
    assert model.title == ""
    assert model.plate.edges == Edges(left="free", right="free", bottom="free", top="free")
    assert (model.plate.shear_factor, model.plate.element) == (5 / 6, "mitc9")
    assert model.beyond == Beyond(kind="none", sides=("left", "right", "bottom", "top"))
    assert model.contact == Contact(tensionless=True, gap=0, voids=[])
    assert model.mesh == Mesh(symmetry="auto")
    assert model.analysis == Analysis(increments=1, solver="auto", nested=True, max_iterations=200)
    layer = SoilLayer(E=1e6, nu=0, thickness=1)
    assert (layer.E_bottom, layer.variation, layer.sublayers) == (None, "linear", 1)
    vlasov = Vlasov(layers=[layer])
    assert (vlasov.gamma, vlasov.mode, vlasov.formulas) == ("iterate", "auto", "exact")


@pytest.mark.parametrize(("accuracy", "share"), [("draft", 0.15), ("normal", 0.05), ("strict", 0.02), ("3 %", 0.03)])
def test_words_and_shares_for_the_accuracy(accuracy: str, share: float) -> None:
    """A word stands for a share, and stays a word in the file that is written; nothing is "normal"."""
    model = from_file(case(mesh={"accuracy": accuracy}))
    assert model.mesh.largest_error == share
    assert model.mesh.adaptive
    assert loads(to_toml(model)) == model
    assert (f'accuracy = "{accuracy}"' in to_toml(model)) == (accuracy in ("draft", "strict", "3 %"))
    assert Mesh().largest_error == 0.05
    assert Mesh(accuracy=share).largest_error == share


def test_a_word_for_the_accuracy_that_is_misspelled() -> None:
    """The word that was meant is named."""
    ((_, _, _, hint),) = issues(case(mesh={"accuracy": "darft"}))
    assert hint == 'did you mean "draft"?'


def test_every_kind_of_ground_is_accepted() -> None:
    """Each kind of ground can be given from a file and from Python, to the same effect."""
    layer = SoilLayer(E=20e6, nu=0.3, thickness=2)
    by_k = InterfaceLayer(k0=20e6, k1=5e6)
    pairs = [
        (WINKLER, Winkler(k=20e6)),
        (
            {"kind": "winkler", "selvadurai": {"E": "40 MPa", "depth": "5 m"}},
            Winkler(selvadurai=Selvadurai(E=40e6, depth=5)),
        ),
        (PASTERNAK, Pasternak(k0=20e6, k1=5e6)),
        (VLASOV, Vlasov(layers=[layer])),
        ({**VLASOV, "mode": "sinh", "formulas": "as printed", "gamma": 1},
         Vlasov(layers=[layer], mode="sinh", formulas="as printed", gamma=1)),
        (INTERFACE, Layered(coupling="interface", layers=[by_k, by_k])),
        ({**INTERFACE, "layers": [LAYER], "gamma": 2, "formulas": "as printed"},
         Layered(coupling="interface", layers=[layer], gamma=2, formulas="as printed")),
        (CONSISTENT, Layered(coupling="consistent", layers=[layer, layer])),
    ]  # fmt: skip
    for data, ground in pairs:
        assert from_file(case(ground=data)).ground == ground
        assert Model(plate=PLATE, ground=ground, loads=[UniformLoad(q=1)]).ground == ground


def test_positions_have_a_tolerance() -> None:
    """A load up to the very edge may miss it by a rounding error."""
    load = PatchLoad(q=1, x=(-3 - 1e-9, 3 + 1e-9), y=(-2, 2))
    point = PointLoad(P=1, x=3 * (1 + 1e-9), y=2)
    assert Model(plate=PLATE, ground=Winkler(k=1), loads=[load, point]).loads == (load, point)


def test_largest_mesh_is_allowed() -> None:
    """The limit itself is no issue."""
    assert from_file(case(mesh__counts=[MOST_ELEMENTS // 2000, 2000])).mesh.counts == (2000, 2000)


def test_parts_raise_on_their_own() -> None:
    """A part built alone raises InputError with all its issues, named from the class; never another error."""
    with pytest.raises(InputError) as error:
        Plate(length_x=-1, length_y="4", thickness=float("nan"), E=30e9, nu=0.5, colour="red")
    assert [issue.location for issue in error.value.issues] == [
        "Plate.length_x", "Plate.length_y", "Plate.thickness", "Plate.nu", "Plate.colour",
    ]  # fmt: skip
    with pytest.raises(InputError, match=r"Void\.x: found \[1, 0\]"):
        Void(depth=1, x=(1, 0), y=(0, 1))
    with pytest.raises(InputError, match="PointLoad: found 3"):
        PointLoad.model_validate(3)
    with pytest.raises(InputError, match="or a number in Pa"):
        UniformLoad(q=None)


def test_python_forgives_defaults_without_effect() -> None:
    """In Python a default that has no effect may be given, so that a dump can be turned back into a Model."""
    assert Beyond(kind="none", edge="free", width=None) == Beyond()
    with pytest.raises(InputError, match="no edge"):
        Beyond(kind="none", edge="fixed")


def test_frozen_comparable_picklable() -> None:
    """A description is a value: it cannot be changed, but compared, pickled, and dumped in SI units and back."""
    model = from_file(case(ground={**VLASOV, "layers": [LAYER, LAYER]}, beyond={"kind": "infinite"}))
    with pytest.raises(FrozenInstanceError, match="cannot assign to field 'E'"):
        model.plate.E = 3.0
    with pytest.raises(FrozenInstanceError, match="cannot delete"):
        del model.plate.E
    assert pickle.loads(pickle.dumps(model)) == model
    dump = model.model_dump()
    assert dump["plate"]["E"] == 30e9
    assert Model(**dump) == Model.model_validate(dump) == model
    assert model != from_file(case())


def test_replace_checks_anew() -> None:
    """A changed copy is checked like any other description, and the original stays."""
    model = from_file(case(loads=[{**POINT, "x": "3 m"}]))
    wider = model.replace(plate=model.plate.replace(length_x=12))
    assert (wider.plate.length_x, model.plate.length_x) == (12.0, 6.0)
    with pytest.raises(InputError, match=r"loads\[1\]\.x"):
        model.replace(plate=model.plate.replace(length_x=1))


def parts(part: type[Section] = Model) -> Iterator[type[Section]]:
    """Yield a part's class and all those within it."""
    yield part
    for field in part.model_fields.values():
        for each in field.sections.parts:
            yield from parts(each)


def test_every_field_says_what_it_is() -> None:
    """Each field states its meaning, and its kind of key unless it holds parts or a tag."""
    for part in sorted(set(parts()), key=lambda part: part.__name__):
        for name, field in part.model_fields.items():
            assert field.meaning, name
            assert isinstance(field.type, FieldType) or field.sections.parts or name == "kind"


@pytest.mark.slow
def test_schema_covers_all_keys() -> None:
    """The JSON schema has each part with all its keys, text for dimensions, and refuses unknown keys."""
    schema = json_schema()
    for part in set(parts()) - {Model}:
        definition = schema["definitions"][part.__name__]
        assert set(definition["properties"]) == set(part.model_fields)
        assert definition["additionalProperties"] is False
    thickness = schema["definitions"]["Plate"]["properties"]["thickness"]
    assert (thickness["type"], thickness["x-dimension"], thickness["x-symbol"]) == ("string", "length", "t")
    assert "kind" in schema["definitions"]["Winkler"]["required"]


def test_docs_table_covers_all_keys() -> None:
    """The table of keys has a row for each key of each part."""
    table = docs_table()
    for part in parts():
        for name, field in part.model_fields.items():
            if not field.sections.parts:
                assert f"{name}` | " in table, (part, name)


def test_docs_are_up_to_date() -> None:
    """The generated parts of docs/ are what the code gives now (else run tools/write_docs.py)."""
    contents = runpy.run_path(str(ROOT / "tools" / "write_docs.py"))["contents"]()
    assert len(contents) == 7
    for path, text in contents.items():
        assert path.read_text(encoding="utf-8") == text, path


def sections(part: type[Section]) -> Iterator[type[Section]]:
    """Yield the subclasses of a section that belong to the model."""
    for each in part.__subclasses__():
        if each.__module__.startswith("groundslab.model.") and not each.__name__.startswith("_"):
            yield each
        yield from sections(each)


def test_everything_in_an_input_file_is_public_and_documented() -> None:
    """Each section of the model can be imported from groundslab, and its docstring lists its fields."""
    for part in sorted(set(sections(Section)), key=lambda each: each.__name__):
        assert getattr(groundslab, part.__name__) is part
        documented = re.findall(r"^(\w+) : .+\n    \S", part.__doc__ or "", re.MULTILINE)
        assert documented == list(part.model_fields)
