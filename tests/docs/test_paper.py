"""The paper is held to its script: numbers, table and sources."""

from __future__ import annotations

import importlib.util
import json
import re
from types import ModuleType

import pytest

from groundslab.verification import runner
from helpers.paths import ROOT

SCRIPT = ROOT / "paper" / "reproduce" / "reproduce.py"
if not SCRIPT.is_file():
    pytest.skip("an sdist has no paper", allow_module_level=True)


@pytest.fixture(scope="module")
def reproduce() -> ModuleType:
    """Return the script as a module."""
    spec = importlib.util.spec_from_file_location("reproduce", SCRIPT)
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_numbers_are_those_of_the_script(reproduce: ModuleType) -> None:
    """Every number of the paper is the stored one, or follows from the stored bench; no figure is without a name."""
    numbers = json.loads(reproduce.STORED.read_text(encoding="utf-8"))
    numbers |= reproduce.random_slabs() | reproduce.benchmark()
    text = reproduce.PAPER.read_text(encoding="utf-8")
    assert not reproduce.problems(text, numbers, reproduce.peers())


def test_stored_counts_are_those_of_the_cases(reproduce: ModuleType) -> None:
    """A case or a row that came after the numbers were stored is noticed: the script must run again."""
    numbers = json.loads(reproduce.STORED.read_text(encoding="utf-8"))
    cases = [runner.load(name) for name in runner.case_names()]
    assert (int(numbers["cases"]), int(numbers["rows"])) == (len(cases), sum(len(case.rows) for case in cases))


def test_a_number_that_differs_or_has_no_name_is_found(reproduce: ModuleType) -> None:
    """A wrong number, one without a name, one that is missing and a changed table are told."""
    text = "7<!-- cases --> cases in 12 s\n<!-- begin peers -->\n\nold\n\n<!-- end peers -->"
    wrong = reproduce.problems(text, {"cases": "8", "rows": "9"}, "new")
    assert wrong == ["cases: 7 is printed, 8 found", "rows is not printed", "the table differs", "12 has no name"]


def test_sources_are_in_the_list() -> None:
    """Every source that the paper cites has an entry, and every entry is cited."""
    head, text = re.split(r"^# Summary$", (ROOT / "paper" / "paper.md").read_text(encoding="utf-8"), flags=re.MULTILINE)
    entries = re.findall(r"^@\w+\{(\w+),$", (ROOT / "paper" / "paper.bib").read_text(encoding="utf-8"), re.MULTILINE)
    assert "paper.bib" in head
    assert sorted(entries) == sorted(set(re.findall(r"@(\w+)", text)))
