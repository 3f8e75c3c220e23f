"""National psi and partial factors: combinations of cases that name an annex, written out by hand."""

from __future__ import annotations

from typing import Any, get_args

import pytest

from groundslab.case import casefile
from groundslab.design.codes.en1992_2004.annex import ANNEXES
from groundslab.model.combinations import list_combinations
from groundslab.model.loads.annexes import AnnexName, action_parameters, document_of
from groundslab.model.loads.load_cases import NATIONAL, PSI, Combine
from groundslab.model.model import Model
from groundslab.model.remarks.remarks import find_remarks
from groundslab.workbench.checking.revision import usual_factors

CASES = """
[plate]
length_x = "4 m"
length_y = "4 m"
thickness = "0.3 m"
E = "30 GPa"
nu = 0.2

[ground]
kind = "winkler"
k = "20 MN/m3"

[[loads]]
kind = "uniform"
q = "10 kPa"
case = "G"

[[loads]]
kind = "uniform"
q = "5 kPa"
case = "Q"

[[loads]]
kind = "uniform"
q = "1 kPa"
case = "W"

[[cases]]
name = "G"
action = "permanent"

[[cases]]
name = "Q"
action = "variable"
category = "A"
{q}

[[cases]]
name = "W"
action = "variable"
category = "wind"

[combine]
sets = [{sets}]
{keys}
"""
REINFORCED = """
[reinforcement]
concrete = "C30/37"
steel = "B500B"
cover = ["40 mm", "40 mm"]
bottom = ["50 mm", "60 mm"]
top = ["50 mm", "60 mm"]
annex = "{annex}"
"""


def read(sets: str, keys: str = "", q: str = "", annex: str = "") -> Model:
    """Return a case with some combinations, whose annex the combinations or the reinforcement name."""
    text = CASES.format(sets=sets, keys=keys, q=q)
    return casefile.loads(text + (REINFORCED.format(annex=annex) if annex else ""))


def sums(model: Model) -> list[str]:
    """Return the combinations of a model as sums."""
    return [" + ".join(f"{factor:.10g} {name}" for name, factor in each.factors) for each in list_combinations(model)]


@pytest.mark.parametrize("named", [{"annex": "United Kingdom"}, {"keys": 'annex = "United Kingdom"'}])
def test_british_combinations_by_hand(named: dict[str, str]) -> None:
    """psi_0 of wind is 0.5: 1.5 x 0.5 = 0.75, not 0.9; xi 0.925: 1.24875; UPL 1.1. Germany and none have 0.9 and 0.85.

    The same whether the design names the annex or the combinations do.
    """
    sets = '"ultimate", "characteristic"' if named else ""
    made = sums(read(sets, **named))
    assert made[:3] == ["1.35 G + 1.5 Q + 0.75 W", "1.35 G + 1.5 Q", "1.35 G + 1.05 Q + 1.5 W"]
    assert "1 G + 1 Q + 0.5 W" in made
    two = {**named, "keys": f'expression = "6.10a and 6.10b"\n{named.get("keys", "")}'}
    made = sums(read('"ultimate"', **two))
    assert (made[0], made[8]) == ("1.35 G + 1.05 Q + 0.75 W", "1.24875 G + 1.5 Q + 0.75 W")
    assert sums(read('"uplift", "ultimate"', **named))[0] == "1.1 G + 1.5 Q + 0.75 W"
    assert sums(read('"ultimate"', annex="Germany"))[0] == sums(read('"ultimate"'))[0] == "1.35 G + 1.5 Q + 0.9 W"


def test_british_roofs() -> None:
    """What a roof bears goes with other actions by 0.7 in Britain, by nothing elsewhere."""
    case = read('"ultimate"').cases[1].replace(category="H")
    assert (case.by_annex("United Kingdom").psi_0, case.by_annex("Germany").psi_0) == (0.7, 0.0)


def test_dutch_combinations_by_hand() -> None:
    """6.10a and 6.10b: 1.35 G + 1.5 x 0.4 Q and 1.2 G + 1.5 Q, favorable 0.9 G; wind accompanies nothing."""
    model = read('"ultimate"', 'annex = "Netherlands"')
    assert sums(model) == [
        "1.35 G + 0.6 Q", "1.35 G", "0.9 G + 0.6 Q", "0.9 G",
        "1.2 G + 1.5 Q", "1.2 G + 0.6 Q + 1.5 W", "1.2 G + 1.5 W", "1.2 G",
        "0.9 G + 1.5 Q", "0.9 G + 0.6 Q + 1.5 W", "0.9 G + 1.5 W",
    ]  # fmt: skip
    assert {each.rule for each in list_combinations(model)} == {
        "EN 1990 6.10a, Netherlands", "EN 1990 6.10b, Netherlands",
    }  # fmt: skip


def test_values_of_the_case_come_first() -> None:
    """Psi and factors that a file gives win over its annex, one by one; the others of the same case are the annex's."""
    model = read('"ultimate"', 'permanent = [1.4, 1.0]\nannex = "Netherlands"\nexpression = "6.10"', q="psi_1 = 0.35")
    assert (model.cases[1].psi_0, model.cases[1].psi_1) == (0.4, 0.35)
    assert sums(model)[0] == "1.4 G + 1.5 Q"
    assert sums(read('"ultimate"', 'annex = "recommended"', annex="United Kingdom"))[0] == "1.35 G + 1.5 Q + 0.9 W"


def test_what_an_annex_says_is_no_value_of_the_case() -> None:
    """Another annex brings its own values, none the recommended ones; files of the case do not have them."""
    british = read('"ultimate"', annex="United Kingdom")
    assert british.reinforcement is not None
    german = british.replace(reinforcement=british.reinforcement.replace(annex="Germany"))
    assert german == read('"ultimate"', annex="Germany")
    assert german.cases[2].psi_0 == 0.6
    assert british.replace(title="other").cases[2].psi_0 == 0.5
    text = casefile.to_toml(british)
    assert "psi_0" not in text
    assert casefile.loads(text) == british
    assert casefile.loads(text.replace("United Kingdom", "Germany")) == german


def test_combinations_by_aci318_have_no_annex() -> None:
    """Factors are those of ACI 318 whatever the annex; its psi are those of no case."""
    made = list_combinations(read('"ultimate"', 'expression = "ACI 318"\nannex = "Netherlands"'))
    assert {each.rule for each in made} >= {"ACI 318-19 5.3.1a"}
    assert not [each.rule for each in made if "Netherlands" in each.rule]


@pytest.mark.parametrize("name", [name for name in get_args(AnnexName) if name != "recommended"])
def test_values_of_annexes(name: str) -> None:
    """Each value of an annex is that of a case which names it; where it has none they are those recommended."""
    model = read('"ultimate"', f'annex = "{name}"')
    assert model.combine is not None
    for row in action_parameters()["rows"]:
        part, _, key = row["key"].partition(".")
        want: Any = row.get("national", {}).get(name, row["recommended"])
        if part == "combine":
            found: Any = getattr(model.combine, key)
        else:
            case = model.cases[1].replace(category=key.removeprefix("category ")).by_annex(name)
            found = (case.psi_0, case.psi_1, case.psi_2)
        assert (list(found) if isinstance(found, tuple) else found) == want, row["key"]
    assert bool(document_of(name)) == (name in {"Netherlands", "Poland", "United Kingdom"})


def test_the_table_is_whole() -> None:
    """Each row has sources, of each annex its own; each annex has a document."""
    file = action_parameters()
    assert not [row["key"] for row in file["rows"] if not all(row["sources"].values())]
    for row in file["rows"]:
        assert set(row["sources"]) == {"recommended", *row.get("national", {})}, row
        assert not [own for own in row.get("national", {}).values() if own == row["recommended"]], row
        part, _, key = row["key"].partition(".")
        assert key in NATIONAL if part == "combine" else key.removeprefix("category ") in PSI
    defaults = Combine(sets=("ultimate",))
    assert {f"combine.{key}" for key in NATIONAL} <= {row["key"] for row in file["rows"]}
    assert all(getattr(defaults.by_annex("recommended"), key) == getattr(defaults, key) for key in NATIONAL)
    assert set(file["documents"]) == set(ANNEXES) - {"recommended"}
    assert set(ANNEXES) == set(get_args(AnnexName))


def test_the_workbench_tells_national_factors() -> None:
    """What a case of a type means on the page is by the annex of the file, whichever section names it, also unread."""
    british = usual_factors({"reinforcement": {"annex": "United Kingdom"}})
    assert (british["psi"]["wind"], british["psi"]["A"]) == ((0.5, 0.2, 0.0), (0.7, 0.5, 0.3))
    dutch = usual_factors({"combine": {"annex": "Netherlands"}, "reinforcement": {"annex": "Germany"}})
    assert (dutch["permanent"], dutch["psi"]["snow"]) == ((1.35, 0.9), (0.0, 0.2, 0.0))
    for plain in (None, {}, {"combine": 3, "reinforcement": {"annex": "Atlantis"}}):
        assert usual_factors(plain)["permanent"] == (1.35, 1.0)


def test_unknown_annexes_are_remarked_on() -> None:
    """Where nothing was found of an annex, check and report say that the recommended values are taken."""
    for name, unknown in (("Italy", True), ("Germany", False), ("Netherlands", False), ("recommended", False)):
        words = [remark.words for remark in find_remarks(read('"ultimate"', f'annex = "{name}"'))]
        assert any(f"of the annex of {name} to EN 1990 were not found" in each for each in words) == unknown
    assert find_remarks(read('"ultimate"', annex="France"))
