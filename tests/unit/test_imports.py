"""Importing the package is cheap: heavy libraries wait until a function needs them.

The order of the folders is a contract of import-linter, in pyproject.toml.
"""

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

HEAVY = {
    "matplotlib",
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
    "openturns",
}
#: Modules that are imported by functions only, with the heavy library that they are made of.
LATE = {"study.execution.dask_plugin": {"distributed"}}


def name_of(path: Path) -> str:
    """Return a module's name within the package; empty for the package itself."""
    return ".".join(path.relative_to(PACKAGE).with_suffix("").parts).removesuffix("__init__").rstrip(".")


MODULES = {name_of(path): path for path in sorted(PACKAGE.rglob("*.py"))}


@cache
def tree(module: str) -> ast.Module:
    """Return the syntax tree of a module."""
    return ast.parse(MODULES[module].read_text(encoding="utf-8"))


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
        left += [child for child in ast.iter_child_nodes(node) if not isinstance(child, ast.expr)]
    return found


@pytest.mark.slow
def test_heavy_libraries_are_imported_when_used() -> None:
    """Plots, files, tables, units and solvers cost nothing until a function needs them."""
    found = {module: at_once(module) & (HEAVY - LATE.get(module, set())) for module in MODULES}
    assert {module: names for module, names in found.items() if names} == {}


@pytest.mark.slow
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
    assert {name for name in loaded if name.startswith("groundslab")} == {"groundslab", "groundslab._version"}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("command", "unused"),
    [
        ("check", {"scipy", "matplotlib", "rich", "numpy.ma"}),
        (
            "solve",
            {"scipy.linalg", "scipy.spatial", "scipy.optimize", "matplotlib", "pint", "ssl", "numpy.f2py.f2py2e"},
        ),
    ],
)
def test_commands_import_what_they_use(command: str, unused: set[str], tmp_path: Path) -> None:
    """A plain slab is read, and solved, without the libraries that only other slabs need."""
    case = tmp_path / "slab.toml"
    slab = 'length_x = "6 m"\nlength_y = "4 m"\nthickness = "0.3 m"\nE = "30 GPa"\nnu = 0.2'
    load = 'kind = "patch"\nq = "40 kPa"\nx = ["-1 m", "1 m"]\ny = ["-1 m", "1 m"]'
    ground = 'kind = "winkler"\nk = "30 MPa/m"'
    case.write_text(f'[plate]\n{slab}\n[ground]\n{ground}\n[[loads]]\n{load}\n[mesh]\nsize = "0.5 m"\n')
    program = (
        "import sys; from groundslab.cli.main import main; "
        f"assert main([{command!r}, {str(case)!r}]) == 0; print(*sorted(sys.modules), file=sys.stderr)"
    )
    environment = {**os.environ, "PYTHONPATH": str(PACKAGE.parent)}
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True, env=environment)
    assert not unused & set(run.stderr.split())


def test_modules_of_numpy_that_are_not_needed_load_when_used() -> None:
    """Of two modules that SciPy would load the parts come with their first use."""
    program = (
        "import sys, numpy\n"
        "from groundslab.cli import solve\n"
        "solve.defer_parts_of_numpy()\n"
        "import scipy.sparse\n"
        "parts = {'numpy.f2py.f2py2e', 'numpy.testing._private.utils'}\n"
        "assert not parts & set(sys.modules)\n"
        "numpy.testing.assert_allclose(1, 1)\n"
        "assert numpy.f2py.get_include()\n"
        "assert parts <= set(sys.modules)"
    )
    environment = {**os.environ, "PYTHONPATH": str(PACKAGE.parent)}
    subprocess.run([sys.executable, "-c", program], check=True, env=environment)


def test_public_names_can_all_be_had() -> None:
    """Every name that the package promises loads, and no others are taken for its own."""
    for name in groundslab.__all__:
        assert getattr(groundslab, name) is not None
    with pytest.raises(AttributeError):
        groundslab.no_such_name  # noqa: B018
