"""README and docs are held to the code: links, equation numbers, sources, examples, commands."""

from __future__ import annotations

import ast
import importlib
import io
import re
import subprocess
import sys
import tokenize
import tomllib
from functools import cache
from pathlib import Path
from types import ModuleType

import pytest

import groundslab
from groundslab.case import casefile
from helpers.paths import PACKAGE, ROOT

README = ROOT / "README.md"
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")])
MODULES = sorted((ROOT / "src" / "groundslab").rglob("*.py"))
CASES = sorted((ROOT / "src" / "groundslab" / "verification" / "cases").glob("*.toml"))
BIBLIOGRAPHY = (ROOT / "docs" / "bibliography.md").read_text(encoding="utf-8")

FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
TAG = re.compile(r"(?<![\w)])\((\d\.\d{1,2})\)")
NAME = r"[A-Z][A-Za-z-]+"
SOURCE = re.compile(rf"({NAME}(?:, {NAME})*(?: and {NAME})?) \(?((?:1[89]|20)\d\d)\b")


def blocks(page: Path, *languages: str) -> list[str]:
    """Return the fenced blocks of a page in some languages."""
    return [text for language, text in FENCE.findall(page.read_text(encoding="utf-8")) if language in languages]


def anchors(page: Path) -> set[str]:
    """Return the anchors of a page's headings, as GitHub makes them."""
    headings = re.findall(r"^#+ (.+)$", FENCE.sub("", page.read_text(encoding="utf-8")), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def printed_equations() -> set[str]:
    """Return the numbers of the paper's equations, as the bibliography lists them: single ones and ranges."""
    line = re.search(r"^Equation numbers: (.+)$", BIBLIOGRAPHY, re.MULTILINE)
    assert line
    numbers: set[str] = set()
    for first, last in re.findall(r"\((\d\.\d+)\)(?: - \((\d\.\d+)\))?", line[1]):
        section, start = first.split(".")
        end = last.split(".")[1] if last else start
        numbers |= {f"{section}.{n}" for n in range(int(start), int(end) + 1)}
    return numbers


def entries() -> set[str]:
    """Return the bibliography's keys, such as "Hughes and Cohen 1978"."""
    return set(re.findall(rf"^## ({NAME}.* \d{{4}})$", BIBLIOGRAPHY, re.MULTILINE))


@cache
def prose(module: Path) -> str:
    """Return the comments and texts of a module, one after the other, line ends folded into spaces."""
    source = io.StringIO(module.read_text(encoding="utf-8"))
    kinds = {tokenize.COMMENT, tokenize.STRING, getattr(tokenize, "FSTRING_MIDDLE", tokenize.STRING)}
    texts = [token.string for token in tokenize.generate_tokens(source.readline) if token.type in kinds]
    return re.sub(r"\s+", " ", "\n".join(texts))


def docstrings(module: Path) -> str:
    """Return the docstrings of a module, line ends folded into spaces."""
    tree = ast.parse(module.read_text(encoding="utf-8"))
    documented = (ast.Module, ast.ClassDef, ast.FunctionDef)
    texts = [ast.get_docstring(node) or "" for node in ast.walk(tree) if isinstance(node, documented)]
    return re.sub(r"\s+", " ", "\n".join(texts))


def test_links_resolve() -> None:
    """Every relative link leads to a file that is there, and its anchor to a heading."""
    for page in PAGES:
        text = FENCE.sub("", page.read_text(encoding="utf-8"))
        for link in LINK.findall(text):
            if re.match(r"[a-z]+:", link):
                continue
            path, _, anchor = link.partition("#")
            target = (page.parent / path).resolve() if path else page
            assert target.exists(), link
            if anchor:
                assert anchor in anchors(target), link


@pytest.mark.slow
def test_theory_has_the_sections_that_the_code_names() -> None:
    """Every "docs/theory.md, SECTION" in the code names a heading of that page."""
    known = anchors(ROOT / "docs" / "theory.md")
    named = {name for module in MODULES for name in re.findall(r"docs/theory\.md, ([a-z ]+)", prose(module))}
    assert {"infinite ground", "contact", "equilibrium"} <= named
    for name in named:
        assert any(anchor.removeprefix("the-") == name.replace(" ", "-") for anchor in known), name


@pytest.mark.slow
def test_files_that_the_code_names_are_there() -> None:
    """Every docs/... that a comment or text of the package names is a file."""
    for module in MODULES:
        for path in re.findall(r"\bdocs/[\w/.-]*\w", prose(module)):
            assert (ROOT / path).exists(), f"{module.name}: {path}"


@pytest.mark.slow
def test_modules_that_the_docs_name_are_there() -> None:
    """Every path in code type that begins with a folder of the package is a module or folder, with what it names."""
    named = {
        (path, name)
        for page in PAGES
        for path, name in re.findall(
            r"`((?:[a-z]\w*/)+\w+)(?:\.(?!(?:py|html|toml)\b)(\w+))?`", page.read_text(encoding="utf-8")
        )
        if (PACKAGE / path.split("/")[0]).is_dir()
    }
    assert len(named) > 30
    for path, name in named:
        module = PACKAGE / f"{path}.py"
        assert module.exists() or (PACKAGE / path).is_dir(), path
        assert not name or re.search(rf"^(?:def|class) {name}\b", module.read_text(encoding="utf-8"), re.MULTILINE), (
            path
        )


def test_names_in_python_are_there() -> None:
    """Every name of the package with its dots, such as groundslab.views.tables.check_design, can be had."""
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        for name in set(
            re.findall(r"\bgroundslab((?:\.[a-z]\w*)+)(?![\w/-]|\.\w)", re.sub(r"\S+\.(?:json|toml)", "", text))
        ):
            found: object = groundslab
            module = "groundslab"
            for part in name[1:].split("."):
                module = f"{module}.{part}"
                if not hasattr(found, part) and isinstance(found, ModuleType):
                    importlib.import_module(module)
                found = getattr(found, part)


@pytest.mark.slow
def test_equation_numbers_are_the_papers() -> None:
    """Every equation number in the package's comments and texts is one that the paper has."""
    known = printed_equations()
    assert len(known) == 30
    found = {(module.name, number) for module in MODULES for number in TAG.findall(prose(module))}
    assert len(found) > 10
    assert not [each for each in found if each[1] not in known]


def test_equation_numbers_of_the_docs_are_the_papers() -> None:
    """The same for the pages on theory, notation and the paper."""
    known = printed_equations()
    for name in ("theory.md", "notation.md", "bibliography.md", "paper.md"):
        numbers = set(TAG.findall((ROOT / "docs" / name).read_text(encoding="utf-8")))
        assert numbers <= known, name


@pytest.mark.slow
def test_sources_are_in_the_bibliography() -> None:
    """Every author and year in a docstring of the package or as a case's source has an entry; pages name no others."""
    known = entries()
    texts = [docstrings(module) for module in MODULES]
    texts += [tomllib.loads(case.read_text(encoding="utf-8"))["source"] for case in CASES]
    found = {" ".join(source) for text in texts for source in SOURCE.findall(text)}
    assert len(found) > 5
    assert not found - known
    for name in ("theory.md", "decisions/0002-mitc9.md"):
        text = re.sub(r"\s+", " ", (ROOT / "docs" / name).read_text(encoding="utf-8"))
        assert not {" ".join(source) for source in SOURCE.findall(text)} - known, name


def test_cases_of_the_readme_load() -> None:
    """Every TOML block of the README is a case that loads."""
    cases = blocks(README, "toml")
    assert cases
    for text in cases:
        casefile.loads(text)


@pytest.mark.slow
def test_python_of_the_readme_runs(capsys: pytest.CaptureFixture[str]) -> None:
    """Every Python block of the README runs; the model is that of the TOML block, and its result is certified."""
    programs = blocks(README, "python")
    assert programs
    for text in programs:
        names: dict[str, object] = {}
        exec(compile(text, "README.md", "exec"), names)
        assert names["model"] == casefile.loads(blocks(README, "toml")[0])
    assert "True" in capsys.readouterr().out.split()


def test_commands_of_the_readme_name_files_and_targets() -> None:
    """Every file that the README names is there, and every make target is one of the Makefile's."""
    targets = set(re.findall(r"^(\w+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE))
    text = README.read_text(encoding="utf-8")
    files = set(re.findall(r"\b\w+/[\w/]+\.(?:toml|txt)\b", text))
    assert {"examples/table1.toml", "lock/run.txt"} <= files
    assert all((ROOT / file).is_file() for file in files)
    made = set(re.findall(r"(?:`|^)make (\w+)", text, re.MULTILINE))
    assert made
    assert made <= targets


def test_commands_of_the_readme_exist() -> None:
    """`groundslab --help` names each command that the README or a page of docs shows, and one page has them all."""
    asked = subprocess.run([sys.executable, "-m", "groundslab", "--help"], capture_output=True, text=True, check=True)
    known = set(re.findall(r"^    ([\w-]+)(?: |$)", asked.stdout, re.MULTILINE))
    page = (ROOT / "docs" / "commands.md").read_text(encoding="utf-8")
    assert set(re.findall(r"^## ([\w-]+)$", page, re.MULTILINE)) == known - {"COMMAND"}
    for page in PAGES:
        inline = re.findall(r"`groundslab ([a-z][\w-]*)", FENCE.sub("", page.read_text(encoding="utf-8")))
        typed = re.findall(r"^groundslab ([a-z][\w-]*)", "\n".join(blocks(page, "sh", "bat")), re.MULTILINE)
        assert {*inline, *typed} <= known, page.name


def test_picture_is_small() -> None:
    """The README's picture does not weigh the repository down."""
    assert (ROOT / "docs" / "table1.png").stat().st_size < 200_000
