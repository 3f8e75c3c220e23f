"""`model` is the case as written, `solved_model` the case as solved: made once and carried by results."""

from __future__ import annotations

import ast
from dataclasses import replace
from pathlib import Path

import pytest

import groundslab
from groundslab.case import casefile
from groundslab.errors import InputError, NoEquilibrium
from groundslab.model.combinations import as_solved, list_combinations
from groundslab.model.model import Model
from groundslab.results.results import Results
from groundslab.views.files import npz
from groundslab.views.files.results_folder import load_results, save_results
from helpers import synthetic

SOURCE = Path(groundslab.__file__).parent
#: What makes a case as solved of one as written.
EXPANSIONS = {"as_solved", "expand", "list_combinations", "make_combinations", "place_patterns"}
#: What has results at hand, and so the case as solved.
WITH_RESULTS = ("accuracy", "design", "views")
CASES = [{"name": "G"}, {"name": "Q", "action": "variable"}]
LOADS = [{"kind": "uniform", "q": 5e3, "case": "G"}, {"kind": "point", "P": 1e5, "x": 0, "y": 0, "case": "Q"}]


def combined_model() -> Model:
    """Return a slab whose combinations are made by EN 1990."""
    return synthetic.model().replace(cases=CASES, loads=LOADS, combine={"sets": ["ultimate", "characteristic"]})


def imported(path: Path) -> set[str]:
    """Return the names that a file imports from the description of a case."""
    nodes = [node for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))) if isinstance(node, ast.ImportFrom)]
    described = [node for node in nodes if str(node.module).startswith("groundslab.model")]
    return {alias.name for node in described for alias in node.names}


def test_who_has_results_expands_nothing() -> None:
    """No file above the analysis imports what places patterns or lists combinations, as results have both cases."""
    files = [path for folder in WITH_RESULTS for path in (SOURCE / folder).rglob("*.py")]
    assert len(files) > 100
    assert [str(path) for path in files if imported(path) & EXPANSIONS] == []


def test_combinations_are_listed_in_the_case_as_solved() -> None:
    """Those made by EN 1990 are written out, so that nothing is left to be made."""
    model = combined_model()
    solved = as_solved(model)
    assert solved.combine is None
    assert solved.combinations == list_combinations(model)
    assert as_solved(solved) is solved
    assert casefile.loads(casefile.to_toml(solved)) == solved


def test_each_case_by_itself_is_a_combination_of_the_case_as_solved() -> None:
    """Without combinations each case is one; without cases nothing is listed, as a file could not be read then."""
    cases = synthetic.model().replace(cases=CASES, loads=LOADS)
    assert [dict(each.factors) for each in as_solved(cases).combinations] == [{"G": 1.0}, {"Q": 1.0}]
    assert as_solved(synthetic.model()) == synthetic.model()


@pytest.mark.parametrize("refused", [False, True])
def test_both_come_back_from_a_folder(refused: bool, tmp_path: Path) -> None:
    """A folder gives back both cases, even where no combination has a result; the rules of combinations stay."""
    model = combined_model()
    combinations = list_combinations(model)[:2]
    results = {
        each.name: synthetic.results(
            model=model, combination=each.name, limit_state=each.limit_state, factors=each.factors
        )
        for each in combinations
    }
    reasons = {each.name: NoEquilibrium("nothing holds it") for each in combinations}
    given = Results(model, combinations, {}, dict(reasons)) if refused else Results(model, combinations, results, {})
    loaded = load_results(save_results(given, tmp_path / "out"))
    assert loaded.combinations == combinations
    assert loaded.combinations[0].rule == "EN 1990 6.10"
    for each in (given, loaded, *loaded.values()):
        assert (each.model, each.solved_model) == (model, as_solved(model))


def test_an_archive_of_two_different_cases_is_refused(tmp_path: Path) -> None:
    """A case as solved differs in loads and combinations alone: another thickness was not solved."""
    results = synthetic.results()
    other = results.model.replace(title="another")
    npz.write(replace(results, solved_model=other), tmp_path / "results.npz")
    with pytest.raises(InputError, match="a case as solved that is another one"):
        npz.load(tmp_path / "results.npz")
