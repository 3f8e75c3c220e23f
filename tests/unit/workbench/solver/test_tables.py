"""The tables of results as the page gets them: the report's texts, and where a click on a cell leads."""

from __future__ import annotations

import pickle
from functools import cache

import pytest

from groundslab.views.report.table_layout import Cell, TableLayout, headers, layout_table
from groundslab.views.tables.result_tables import table_makers, tables_of
from groundslab.workbench.solver import process
from groundslab.workbench.solver.tables import table_to_json

CASE = """
[plate]
length_x = "4 m"
length_y = "3 m"
thickness = "300 mm"
E = "30 GPa"
nu = 0.2
[ground]
kind = "winkler"
k = "20 MPa/m"
[mesh]
counts = [4, 4]
[[columns]]
name = "A1"
x = "1 m"
y = "0.5 m"
width_x = "400 mm"
width_y = "400 mm"
[[cases]]
name = "G"
[[cases]]
name = "Q"
[[loads]]
case = "G"
kind = "uniform"
q = "10 kPa"
[[loads]]
case = "Q"
kind = "point"
column = "A1"
P = "100 kN"
[[combinations]]
name = "first"
limit_state = "ultimate"
factors = {G = 1.35, Q = 1.5}
[[combinations]]
name = "second"
limit_state = "characteristic"
factors = {G = 1.0, Q = 1.0}
[[output.strips]]
name = "axis 1"
start = ["-2 m", "0 m"]
end = ["2 m", "0 m"]
width = "1 m"
stations = 3
"""


@cache
def solved() -> process.Solved:
    """Return the solved case."""
    return process.solve(CASE, process.Progress(lambda *_: None))[2]


def table(name: str) -> dict[str, object]:
    """Return a table as the page reads it."""
    found: dict[str, object] = pickle.loads(process._write_table(solved(), name))
    return found


def test_all_tables_of_results_are_there_with_the_texts_of_the_report() -> None:
    """Every table that `tables_of` makes is offered, each of its cells as the report prints it."""
    made = {each.name: each for each in tables_of(solved().results)}
    assert list(made) == [name for name in solved().tables if name in made] == list(table_makers(solved().results))
    assert {"combinations", "envelope", "columns", "column_envelope", "strips"} <= set(made)
    for name, each in made.items():
        shown = layout_table(each)
        found = table(name)
        texts = [[cell if isinstance(cell, str) else cell[0] for cell in row] for row in found["rows"]]
        assert texts == [[cell.text for cell in row] for row in shown.rows]
        assert [(head["text"], head["unit"]) for head in found["heads"]] == [(h.text, h.unit) for h in shown.heads]


def test_steps_mesh_and_constants_are_tables_too() -> None:
    """The report's history has a row a step, the mesh its unknowns; constants that all combinations share, one row."""
    steps = sum(len(each.steps) for each in solved().results.values())
    assert len(table("steps")["rows"]) == steps
    assert len(table("constants")["rows"]) == 1
    assert any("unknowns" in row[0][0] for row in table("mesh")["rows"])


def test_cells_lead_to_places_combinations_and_fields() -> None:
    """Each extreme leads to its own place and combination; a row of a quantity to that field."""
    found = table("envelope")
    heads = {head["text"]: head for head in found["heads"]}
    at = {text: n for n, text in enumerate(heads)}
    for word in ("least", "greatest"):
        assert heads[word]["place"] == [at[f"x of the {word}"], at[f"y of the {word}"]]
        assert heads[word]["combination"] == at[f"combination of the {word}"]
    quantity = [cell if isinstance(cell, str) else cell[0] for cell in (row[at["quantity"]] for row in found["rows"])]
    known = dict(zip(quantity, found["fields"], strict=True))
    assert known["settlement w"] == "settlement"
    assert known["moment m_x"] == "moment_x"
    assert known["design moment top y"] == "top_y"


def test_rows_name_items_and_their_place() -> None:
    """A column's row leads to the column, its combination and its place; a strip's to the strip."""
    columns = table("columns")
    assert columns["item"] == {"list": "columns", "column": 1}
    assert (columns["heads"][4]["place"], columns["heads"][4]["combination"]) == ([2, 3], 0)
    assert columns["heads"][0]["place"] == [2, 3]
    assert table("strips")["item"] == {"list": "output.strips", "column": 1}
    loads = [head["field"] for head in table("combinations")["heads"] if head["text"] == "largest settlement"]
    assert loads == ["settlement"]


def test_cells_of_numbers_and_words_are_texts_others_say_what_they_are() -> None:
    """What is under a cell and what it is are told only where there is something to tell."""
    cells = (Cell("a"), Cell("1.0", "number"), Cell("2", "number", "±3 %"), Cell("holds", "good"))
    found = table_to_json("x", TableLayout("X", headers("a", "#b", "#c", "d"), (cells,)))
    assert found["rows"] == [["a", "1.0", ["2", "±3 %", "number"], ["holds", "", "good"]]]
    assert (found["fields"], found["item"]) == (None, None)


def test_a_table_that_cannot_be_made_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    """An error in a table is passed on in words, and the process goes on."""

    class Kept:
        def __init__(self) -> None:
            self.messages: list[object] = []

        def send(self, message: object) -> None:
            self.messages.append(message)

    pipe = Kept()
    broken = process.Solved("", solved().results, {"x": lambda: 1 / 0}, "")  # type: ignore[dict-item]
    process._send_view(pipe, ("table", 1, "x"), (1, broken))  # type: ignore[arg-type]
    process._send_view(pipe, ("table", 2, "x"), (1, broken))  # type: ignore[arg-type]
    first, second = (message[2] for message in pipe.messages)  # type: ignore[index]
    assert "division by zero" in first
    assert "not kept" in second
    assert "ZeroDivisionError" in capsys.readouterr().err
