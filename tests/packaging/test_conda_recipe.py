"""The recipe for conda asks for what pyproject.toml asks for, under conda's names."""

from __future__ import annotations

import re
import tomllib
from typing import Any

import pytest

import groundslab
from helpers.paths import ROOT

yaml = pytest.importorskip("yaml")
RECIPE = ROOT / "packaging" / "conda" / "recipe.yaml"
if not RECIPE.is_file():
    pytest.skip("an sdist has no recipe", allow_module_level=True)
#: Names of conda-forge that are not those of pip.
NAMES = {"gmsh": "python-gmsh", "matplotlib": "matplotlib-base", "netgen-mesher": "netgen", "typst": "typst-py"}


def asked_for(requirements: list[str]) -> set[str]:
    """Return requirements as conda writes them, without markers."""
    found = set()
    for text in requirements:
        match = re.match(r"([\w-]+)\s*(>=[\d.]+)", text)
        if match:
            name = match[1].lower().replace("_", "-")
            found.add(f"{NAMES.get(name, name)} {match[2]}")
    return found


@pytest.fixture(scope="module")
def project() -> dict[str, Any]:
    """Return the table [project] of pyproject.toml."""
    return dict(tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"])


@pytest.fixture(scope="module")
def outputs() -> list[dict[str, Any]]:
    """Return what the recipe makes: all code, and the package that adds MKL."""
    recipe = yaml.safe_load(RECIPE.read_text(encoding="utf-8"))
    assert recipe["context"]["version"] == groundslab.__version__
    return list(recipe["outputs"])


def test_recipe_requires_what_pip_requires(project: dict[str, Any], outputs: list[dict[str, Any]]) -> None:
    """All required packages are those of the first output, but PARDISO, which only the second has where it exists."""
    (base, full), wanted = outputs, asked_for(project["dependencies"])
    run = {text for text in base["requirements"]["run"] if not text.startswith("python ")}
    (choice,) = (each for each in full["requirements"]["run"] if isinstance(each, dict))
    assert run | {choice["then"]} == wanted
    assert (choice["if"], choice["then"] in run) == ("x86_64 and (linux or win)", False)


def test_recipe_constrains_what_extras_require(project: dict[str, Any], outputs: list[dict[str, Any]]) -> None:
    """Each package that an extra names is constrained to the versions that the extra allows."""
    extras = [text for texts in project["optional-dependencies"].values() for text in texts if "groundslab" not in text]
    constraints = set(outputs[0]["requirements"]["run_constraints"]) - {"pypardiso >=0.4.6"}
    assert len(extras) > 10
    assert constraints == asked_for(extras)


def test_commands_are_those_of_the_package(project: dict[str, Any], outputs: list[dict[str, Any]]) -> None:
    """The recipe's entry points are pyproject.toml's."""
    made = [f"{name} = {place}" for name, place in project["scripts"].items()]
    assert outputs[0]["build"]["python"]["entry_points"] == made
