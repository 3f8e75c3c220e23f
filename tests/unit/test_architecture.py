"""The floors of the package: imports point downwards, heavy libraries wait until they are needed."""

from __future__ import annotations

import ast
import os
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

import groundslab

PACKAGE = Path(groundslab.__file__).parent

#: Rooms by floor; a folder stands for all that is in it. What a room imports lies on its own floor or below.
FLOORS = [
    ["errors", "atomic", "provenance", "units", "ranges", "dxf"],
    [
        "model",
        "slab",
        "actions",
        "clipping",
        "columns",
        "supports",
        "loadcases",
        "strata",
        "wanted",
        "combine",
        "outline",
        "plan",
        "unmeshable",
        "schema",
        "keys",
        "findings",
        "reference",
        "soil",
        "casefile",
        "shape",
        "memo",
        "mesh",
        "results",
    ],
    [
        "plate",
        "ground",
        "vlasov",
        "between",
        "symmetric",
        "assembly",
        "mumps",
        "linear",
        "lanes",
        "bearings",
        "interior_point",
        "contact",
        "problem",
        "loads",
        "mesher",
        "design",
        "reinforcement",
        "punching_resistance",
        "patches",
        "traverse",
        "envelope",
    ],
    ["borders", "layout", "subsoil", "voids", "loading", "bearing", "discretise"],
    [
        "statics",
        "conditioning",
        "solution",
        "forecast",
        "contact_fields",
        "coverage",
        "checks",
        "creases",
        "edge_forces",
        "frame",
        "recover",
        "ladder",
        "analysis",
        "sections",
        "punching",
        "tilt",
        "readings",
        "underground",
    ],
    ["verify", "exact", "exact_circular", "exact_springs", "proofs", "cases", "tables"],
    ["plots", "views", "scene", "report", "study"],
    ["workbench"],
    ["speech", "command_plot", "command_study", "cli", "__main__"],
]
FLOOR = {room: number for number, rooms in enumerate(FLOORS) for room in rooms}
DESCRIPTION = {"model", "schema", "keys", "findings", "reference", "soil", "casefile", "results"}
HEAVY = {
    "matplotlib",
    "meshio",
    "rich",
    "pint",
    "scipy",
    "pypardiso",
    "petsc4py",
    "ezdxf",
    "gmsh",
    "netgen",
    "shapely",
    "pandas",
    "jinja2",
    "distributed",
    "dask",
    "gstools",
    "SALib",
    "openturns",
}
#: Modules that are imported by functions only, with the heavy library that they are made of.
LATE = {"study.plugin": {"distributed"}}


def name_of(path: Path) -> str:
    """Return a module's name within the package; empty for the package itself."""
    return ".".join(path.relative_to(PACKAGE).with_suffix("").parts).removesuffix("__init__").rstrip(".")


MODULES = {name_of(path): path for path in sorted(PACKAGE.rglob("*.py"))}


@cache
def tree(module: str) -> ast.Module:
    """Return the syntax tree of a module."""
    return ast.parse(MODULES[module].read_text(encoding="utf-8"))


def within_package(dotted: str, names: list[str]) -> set[str]:
    """Return the modules of the package that `from dotted import names` (or `import dotted`) reaches."""
    if dotted != "groundslab" and not dotted.startswith("groundslab."):
        return set()
    inside = dotted.removeprefix("groundslab").removeprefix(".")
    below = {f"{inside}.{name}".strip(".") for name in names}
    found = {name for name in below if name in MODULES}
    return found | ({inside} if len(found) < len(below) or not names else set())


def imports(module: str) -> set[str]:
    """Return the modules of the package that a module imports anywhere, in functions and for types too."""
    found: set[str] = set()
    for node in ast.walk(tree(module)):
        if isinstance(node, ast.Import):
            for alias in node.names:
                found |= within_package(alias.name, [])
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{module} imports relatively"
            found |= within_package(node.module or "", [alias.name for alias in node.names])
    return found


def at_once(module: str) -> set[str]:
    """Return the top names of all packages that importing a module imports by itself, right away."""
    found: set[str] = set()
    left: list[ast.AST] = list(tree(module).body)
    while left:
        node = left.pop()
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
            continue
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test):
            left += node.orelse
            continue
        if isinstance(node, ast.Import):
            found |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            found.add((node.module or "").split(".")[0])
        left += list(ast.iter_child_nodes(node))
    return found


def room(module: str) -> str:
    """Return the room that a module belongs to."""
    return module.split(".")[0]


def test_every_module_has_a_floor() -> None:
    """A new room must be given its floor here before anything else."""
    assert {room(module) for module in MODULES if module} <= FLOOR.keys()


@pytest.mark.parametrize("module", [module for module in MODULES if module])
def test_imports_point_downwards(module: str) -> None:
    """Nothing imports from a higher floor, in functions and for types neither; the package's front has its version."""
    for imported in imports(module):
        if imported:
            assert FLOOR[room(imported)] <= FLOOR[room(module)], f"{module} imports {imported}"
        elif module:
            names = [
                alias.name
                for node in ast.walk(tree(module))
                if isinstance(node, ast.ImportFrom) and node.module == "groundslab"
                for alias in node.names
            ]
            assert {name for name in names if name not in MODULES} <= {"__version__"}


@pytest.mark.parametrize("module", FLOORS[2])
def test_kernels_know_nothing_of_the_description(module: str) -> None:
    """Kernels see arrays and floats: neither the model nor anything of the input file nor the results."""
    assert not {room(imported) for imported in imports(module)} & DESCRIPTION


@pytest.mark.parametrize("module", [module for module in MODULES if module])
def test_rooms_do_not_import_in_circles(module: str) -> None:
    """Within a floor, too, no module comes back to itself through what it imports when it runs."""

    def when_it_runs(name: str) -> set[str]:
        skipped: set[ast.AST] = set()
        for node in ast.walk(tree(name)):
            if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test):
                skipped |= set(ast.walk(node))
        found: set[str] = set()
        for node in ast.walk(tree(name)):
            if node not in skipped and isinstance(node, ast.ImportFrom):
                found |= within_package(node.module or "", [alias.name for alias in node.names])
        return found - {""}

    reached, left = set[str](), when_it_runs(module)
    while left:
        one = left.pop()
        if one not in reached:
            reached.add(one)
            left |= when_it_runs(one) - reached
    assert module not in reached


@pytest.mark.parametrize("module", MODULES)
def test_heavy_libraries_are_imported_when_used(module: str) -> None:
    """Plots, files, tables, units and solvers cost nothing until a function needs them."""
    assert not at_once(module) & (HEAVY - LATE.get(module, set()))


@pytest.mark.parametrize("late", LATE)
def test_what_loads_with_its_library_is_imported_when_used(late: str) -> None:
    """A module that needs a heavy library as soon as it is imported is imported by functions only."""
    home, _, name = late.rpartition(".")
    for module in MODULES:
        names = [
            alias.name
            for node in tree(module).body
            if isinstance(node, ast.ImportFrom) and node.module in (f"groundslab.{home}", f"groundslab.{late}")
            for alias in node.names
        ]
        assert name not in names, module


def test_front_imports_nothing() -> None:
    """Importing the package loads neither NumPy nor pydantic nor any of its own rooms."""
    program = "import sys, groundslab; print(*sorted(sys.modules))"
    environment = {**os.environ, "PYTHONPATH": str(PACKAGE.parent)}
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True, env=environment)
    loaded = set(run.stdout.split())
    assert not loaded & {"numpy", "pydantic", *HEAVY}
    assert {name for name in loaded if name.startswith("groundslab")} == {"groundslab"}


def test_public_names_can_all_be_had() -> None:
    """Every name that the package promises loads, and no others are taken for its own."""
    for name in groundslab.__all__:
        assert getattr(groundslab, name) is not None
    with pytest.raises(AttributeError):
        groundslab.no_such_name  # noqa: B018
