"""Chapters of the report, its plans of loads, and its print."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from groundslab.cli import main as cli
from groundslab.errors import InputError
from groundslab.messages import joined
from groundslab.model.combinations import as_solved
from groundslab.model.model import Model
from groundslab.results.results import Results
from groundslab.units import UNITS, format_drawn
from groundslab.views.files import results_folder
from groundslab.views.report import content
from groundslab.views.report.drawings import drawings
from groundslab.views.report.drawings.load_plan import MOST_LISTED, LoadPlan, load_text, plan_base
from groundslab.views.report.drawings.maps import _path_data
from groundslab.views.report.html import render_report
from groundslab.views.summary.combinations import Extreme
from groundslab.views.summary.rows import Row, SummarySection
from helpers import grounds, synthetic
from helpers.pages import Element, page


def model(**changes: Any) -> Model:
    """Return a slab with a load of each kind in one of two cases."""
    parts: dict[str, Any] = {
        "title": 'A "slab" </style> of \\ 6 m',
        "project": {"name": "Yard", "part": "Hall 2", "revision": "B"},
        "plate": {"length_x": 6, "length_y": 4, "thickness": 0.25, "E": 30e9, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 2e7},
        "cases": [{"name": "G", "H_x": 12e3}, {"name": "Q", "action": "variable"}],
        "loads": [
            {"kind": "uniform", "q": 5e3, "case": "G"},
            {"kind": "line", "q": 20e3, "points": [(-2, -1), (2, -1)], "case": "G"},
            {"kind": "point", "P": 321e3, "M_x": 15e3, "x": 1, "y": 1, "case": "Q"},
        ],
    }
    return Model(**parts | changes)


def plans_of_loads(described: Model) -> list[drawings.Drawing]:
    """Return the plans of a case's loads."""
    return list(drawings.draw_loads(described, as_solved(described)))


def sections(root: Element) -> set[str]:
    """Return the names of the sections of a page that are no tables."""
    found = (each.attributes.get("id", "") for each in root.one("main").all("section"))
    return {name for name in found if name and not name.startswith("table-")}


class TestChapters:
    """Which chapters are made."""

    def test_those_of_the_case(self) -> None:
        """The file chooses; the first page is there in any case, and the data of the viewer are left out with it."""
        wanted = synthetic.model().replace(report={"chapters": ["assumptions", "certificate"]})
        root = page(render_report(synthetic.results(model=wanted)))
        assert sections(root) == {"assumptions", "certificate"}
        assert root.one("header", class_="title").one("h1").text == wanted.title
        assert root.one("script", id="scene").text == ""

    def test_those_given(self) -> None:
        """Who makes the report can choose others."""
        assert sections(page(render_report(synthetic.results(), chapters=["certificate"]))) == {"certificate"}

    def test_an_unknown_one(self) -> None:
        """What is no chapter is refused, each by its name."""
        with pytest.raises(InputError, match=r'(?s)"pages".*"books"'):
            render_report(synthetic.results(), chapters=["pages", "certificate", "books"])  # type: ignore[list-item]

    def test_in_a_case_file(self) -> None:
        """A wrong word in the file says what is meant."""
        with pytest.raises(InputError, match=r"report.chapters\[1\]"):
            model(report={"chapters": ["picture"]})

    def test_by_command(self, tmp_path: Path) -> None:
        """The command has the same choice."""
        folder = results_folder.save_results(synthetic.results(), tmp_path / "slab")
        assert cli.main(["report", str(folder), "--chapters", "certificate"]) == 0
        assert sections(page((tmp_path / "slab.html").read_text(encoding="utf-8"))) == {"certificate"}


@pytest.mark.slow
class TestGrounds:
    """The chapter of ground models."""

    def test_there_with_a_comparison_only(self) -> None:
        """It has a column for each ground, differences under the figures, and curves; without one it is left out."""
        assert "grounds" not in sections(page(render_report(synthetic.results())))
        root = page(render_report(synthetic.results(), chapters=["grounds"], comparison=grounds.comparison()))
        chapter = root.one("section", id="grounds")
        figures, constants = (each.text for each in chapter.all("table"))
        assert "winkler, fitted" in figures
        assert "+30.0 %" in figures
        assert "gamma" in constants
        assert chapter.one("figure").one("svg") is not None

    def test_of_another_model(self) -> None:
        """A comparison that does not belong to the results is refused."""
        other = grounds.comparison(synthetic.model().replace(title="another"))
        with pytest.raises(InputError, match="one of another model"):
            render_report(synthetic.results(), comparison=other)


class TestPageHeads:
    """What stands at the head of each printed page."""

    def test_title_and_revision(self) -> None:
        """A title with quotes, a backslash and the end of a style stays within its string, letter by letter."""
        style = page(render_report(synthetic.results(model=model()), chapters=["certificate"])).one("style").text
        text = re.search(r'@top-left \{ content: "([^"]*)"', style)
        assert text is not None
        assert "<" not in text[1]
        assert re.sub(r"\\([0-9a-f]+) ", lambda found: chr(int(found[1], 16)), text[1]) == model().title
        assert 'content: "Hall 2, B"' in style


class TestLoads:
    """Plans of loads, case by case."""

    def test_each_case_has_one(self) -> None:
        """The caption names the case, what acts everywhere and horizontal forces; the plan has the values."""
        first, second = plans_of_loads(model())
        assert first.caption == "G, permanent: uniform 5 kPa; Hx 12 kN."
        assert second.caption == "Q, variable."
        assert "20 kN/m" in [each.text for each in page(first.svg).all("text")]
        assert "321 kN, Mx 15 kNm" in [each.text for each in page(second.svg).all("text")]

    def test_without_cases_all_loads(self) -> None:
        """Loads without cases stand in one plan."""
        loads = [{"kind": "uniform", "q": 5e3}, {"kind": "point", "P": 1e3, "x": 0, "y": 0}]
        (drawn,) = plans_of_loads(model(cases=[], loads=loads))
        assert drawn.caption == "All loads: uniform 5 kPa."

    def test_what_moves_stands_where_it_begins(self) -> None:
        """A vehicle on a path is drawn once, at its first position; a rack at its place."""
        axle = {"kind": "vehicle", "name": "axle", "wheels": [{"P": 45e3, "y": -0.5}, {"P": 46e3, "y": 0.5}]}
        rack = {"kind": "rack", "name": "rack", "P": 60e3, "frames": 2, "bay": 1.0}
        moves = [
            {"pattern": "axle", "case": "Q", "points": [(-2, 0), (2, 0)], "step": 0.5},
            {"pattern": "rack", "case": "G", "points": [(0, 1)]},
        ]
        loads = [{"kind": "uniform", "q": 5e3, "case": "G"}]
        rolling = model(loads=loads, patterns=[axle, rack], moves=moves)
        first, second = plans_of_loads(rolling)
        assert [each.text for each in page(first.svg).all("text")].count("60 kN") == 2
        written = [each.text for each in page(second.svg).all("text")]
        assert (written.count("45 kN"), written.count("46 kN")) == (1, 1)
        assert second.caption == "Q, variable. It moves along the dashed path; drawn at the first position."

    def test_a_value_at_many_places_is_written_once(self) -> None:
        """Twenty legs of one force stand in the caption, with their number; the force beside them at its place."""
        rack = {"kind": "rack", "name": "rack", "P": 60e3, "frames": 10, "bay": 0.5, "rows": [0, 1]}
        beside = {"kind": "point", "P": 7e3, "x": 2, "y": -1.5, "case": "Q"}
        moves = [{"pattern": "rack", "case": "Q", "points": [(-2.5, 0)]}]
        (drawn,) = plans_of_loads(model(loads=[beside], patterns=[rack], moves=moves))
        assert drawn.caption == "Q, variable: 20 \N{MULTIPLICATION SIGN} 60 kN."
        written = [each.text for each in page(drawn.svg).all("text")]
        assert (written.count("60 kN"), written.count("7 kN")) == (0, 1)

    def test_values_thin_out(self) -> None:
        """Of very many loads those values are written that there is space for, others are listed, the rest counted."""
        loads = [{"kind": "point", "P": 1e3 + n, "x": -2.9 + 0.02 * n, "y": 0} for n in range(250)]
        (drawn,) = plans_of_loads(model(cases=[], loads=loads))
        many = model(cases=[], loads=loads)
        figure = LoadPlan(plan_base(many, as_solved(many)), None).draw()
        (axes,) = figure.axes
        written = {text.get_text() for text in axes.texts}
        listed = {text.get_text() for text in figure.texts}
        forces = {f"{1 + n / 1e3:.5g} kN": f"({format_drawn(-2.9 + 0.02 * n)}, 0) m" for n in range(250)}
        assert len(written) > 20
        assert written < forces.keys()
        assert len(listed) == MOST_LISTED
        assert listed < {f"{place}: {force}" for force, place in forces.items() if force not in written}
        missing = len(loads) - len(written) - MOST_LISTED
        assert drawn.caption == f"All loads. For {missing} values there is no space; the case lists all."

    def test_values_farther_off_are_led_to(self) -> None:
        """A value that stands far from its load has a line that ends there; one beside its load has none."""
        close = [{"kind": "point", "P": 1e5 + 1e3 * n, "x": -0.9 + 0.3 * n, "y": 0} for n in range(7)]
        slab = model(cases=[], loads=[*close, {"kind": "point", "P": 55e3, "x": 2.5, "y": 1.5}])
        (axes,) = LoadPlan(plan_base(slab, as_solved(slab)), None).draw().axes
        places = {text.get_text(): text.get_position() for text in axes.texts}
        lines = [line.get_xydata() for line in axes.lines if len(line.get_xdata()) == 2]
        ends = {tuple(np.round(end, 6)): start for start, end in lines}
        led = {words: ends[key] for words, place in places.items() if (key := tuple(np.round(place, 6))) in ends}
        assert led
        assert "55 kN" not in led
        for words, place in led.items():
            assert place == pytest.approx((-0.9 + 0.3 * (float(words.split()[0]) - 100), 0.0), abs=1e-9)

    def test_one_value_without_space_is_one(self, monkeypatch: pytest.MonkeyPatch) -> None:
        """The caption says so."""
        monkeypatch.setattr(
            "groundslab.views.report.drawings.load_plan._place_values", lambda *_: ([], [((0.0, 0.0), "1 kN")])
        )
        monkeypatch.setattr("groundslab.views.report.drawings.load_plan.MOST_LISTED", 0)
        (drawn,) = plans_of_loads(model(cases=[], loads=[{"kind": "point", "P": 1e3, "x": 0, "y": 0}]))
        assert drawn.caption == "All loads. For one value there is no space; the case lists all."

    def test_values_stand_on_no_line(self) -> None:
        """The value of a line load stands beside it, and that of a column on the plate's edge off the edge."""
        column = {"name": "A", "x": 0, "y": 1.8, "width_x": 0.4, "width_y": 0.4}
        loads = [
            {"kind": "point", "P": 321e3, "column": "A"},
            {"kind": "line", "q": 20e3, "points": [(-2, -1), (2, -1)]},
        ]
        slab = model(cases=[], loads=loads, columns=[column])
        figure = LoadPlan(plan_base(slab, as_solved(slab)), None).draw()
        (axes,) = figure.axes
        boxes = {text.get_text(): text.get_window_extent() for text in axes.texts}
        for words, y in (("321 kN", 2.0), ("20 kN/m", -1.0)):
            _, at = axes.transData.transform((0.0, y))
            assert not boxes[words].y0 <= at <= boxes[words].y1

    def test_a_force_with_both_ends(self) -> None:
        """A line load that varies shows both of its values."""
        varying = model(cases=[], loads=[{"kind": "line", "q": 10e3, "q_end": 20e3, "points": [(-2, 0), (2, 0)]}])
        assert load_text(varying.loads[0]) == "10 to 20 kN/m"


def test_extremes_stand_by_kind_of_limit_state() -> None:
    """Ultimate and serviceability stand apart, each with its own combination."""
    combined = synthetic.combined()
    first, *_ = combined.combinations
    combined = replace(combined, results={
        name: replace(each, limit_state="ultimate" if name == first.name else "characteristic")
        for name, each in combined.results.items()
    })  # fmt: skip
    found = page(render_report(combined, chapters=["extremes"])).one("section", id="extremes")
    heads = {head.text for table in found.all("table") for head in table.all("th")}
    assert {"ultimate", "serviceability"} <= heads


def test_an_extreme_that_is_of_another_quantity_says_of_which(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where ultimate and serviceability differ in the quantity, it stands under each value, not before both."""
    of = {"ultimate": "shear q_x", "characteristic": "moment m_x"}

    def extremes(_: Results, states: Sequence[str]) -> list[tuple[SummarySection, tuple[Extreme, ...]]]:
        label = joined(("largest error", of[states[0]]))
        rows = (Row("largest_error", label, 0.1, UNITS["%"]), Row("w", "settlement", 0.1))
        section = SummarySection("discretization", "Discretization error", rows)
        return [(section, tuple(Extreme(row, 1) for row in rows))]

    monkeypatch.setattr(content.combinations, "extremes", extremes)
    monkeypatch.setattr(content, "GROUPS", {name: (name,) for name in of})
    combined = synthetic.combined()
    (table,) = content._extremes(combined, content.combinations.entries(combined))
    first, second = table.rows
    assert first[0].text == "largest error"
    assert [cell.under for cell in first if cell.under] == ["shear q_x", "moment m_x"]
    assert (second[0].text, {cell.under for cell in second}) == ("settlement", {""})


def test_a_band_in_which_nothing_lies_has_no_path() -> None:
    """A field with two values alone, such as areas of bars, leaves the bands between without a path."""
    assert _path_data(np.empty((0, 2)), np.empty(0, dtype=int)) == ""
    square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 0.0]])
    assert _path_data(square, np.array([1, 2, 2, 79])) == "M0 0l25 0 0 25z"
