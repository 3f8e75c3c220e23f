"""The architecture page is held to the code: the files it names, the folders it lists, the order of the contract."""

from __future__ import annotations

import ast
import re
import tomllib

from helpers.paths import DOCS, PACKAGE, ROOT

PAGE = (DOCS / "architecture.md").read_text(encoding="utf-8")
CONTRACTS = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"]["contracts"]


def test_named_files_are_there() -> None:
    """Every file and folder in code type exists, from the root of the repository or of the package."""
    named = re.findall(r"`([\w./]+(?:\.\w+|/))`", PAGE)
    assert len(named) > 50
    folders = [path.parent for path in PACKAGE.rglob("__init__.py")]
    for path in named:
        inside = folders if path.count("/") == 1 else []
        places = [ROOT, PACKAGE, ROOT / "web" / "src", *inside]
        assert any((place / path).exists() for place in places), path


def test_named_definitions_are_there() -> None:
    """Every name in code type beside a file of the package occurs in that file."""
    pairs = re.findall(r"`(\w+)`(?: \(or `\w+`\))?(?: there)?,? in\s+`([\w/]+\.py)`", PAGE)
    assert len(pairs) >= 7
    for name, path in pairs:
        place = next(place for place in (PACKAGE, ROOT) if (place / path).exists())
        assert re.search(rf"\b{name}\b", (place / path).read_text(encoding="utf-8")), (name, path)


def test_folders_are_listed_in_the_order_of_the_contract() -> None:
    """The table has every folder and module of the package, from the bottom up as import-linter has them."""
    section = PAGE.split("\n## Folders\n")[1].split("\n## ")[0]
    rows = re.findall(r"^\| (`[^|]+`) \|", section, re.MULTILINE)
    listed = [[name.rstrip("/").removesuffix(".py") for name in re.findall(r"`(.+?)`", row)] for row in rows]
    layers = next(contract for contract in CONTRACTS if contract["type"] == "layers")["layers"]
    ordered = [set(layer.split(" | ")) for layer in reversed(layers)]
    flat = [name for row in listed for name in row]
    assert set(flat) == set().union(*ordered) - {"__main__"}
    level = {name: number for number, layer in enumerate(ordered) for name in layer}
    assert [level[name] for name in flat] == sorted(level[name] for name in flat)


def test_folders_stay_small() -> None:
    """At most fifteen modules lie in a folder beside what it exports, so that it can be read at a glance."""
    for folder in (path.parent for path in PACKAGE.rglob("__init__.py")):
        assert len([path for path in folder.glob("*.py") if path.stem != "__init__"]) <= 15, folder


def test_functions_stay_short() -> None:
    """No function of the package has over 60 lines; a file holds one idea, of whatever length."""
    for path in PACKAGE.rglob("*.py"):
        left: list[ast.AST] = [ast.parse(path.read_text(encoding="utf-8"))]
        while left:
            node = left.pop()
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                assert (node.end_lineno or 0) - node.lineno < 60, (path, node.name)
            left += [child for child in ast.iter_child_nodes(node) if not isinstance(child, ast.expr)]
