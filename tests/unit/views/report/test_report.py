"""The report: whole, safe, the same every time, and with the numbers of the results."""

from __future__ import annotations

import base64
import gzip
import hashlib
import json
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import groundslab
from groundslab.case import casefile
from groundslab.cli import main as cli
from groundslab.errors import GroundslabError, InputError, NoEquilibrium
from groundslab.languages import catalogue
from groundslab.model.combinations import as_solved, list_combinations
from groundslab.model.model import Model
from groundslab.results.fields import PLATE_FIELDS
from groundslab.results.records import Constants, SupportResult
from groundslab.results.results import Results, results_of
from groundslab.schema.wording import printable
from groundslab.storage import checksums
from groundslab.units import format_number
from groundslab.views import report
from groundslab.views.files import results_folder
from groundslab.views.plots import export, plot
from groundslab.views.plots.annotations import LabelPlacement
from groundslab.views.plots.export import to_inline_svg
from groundslab.views.plots.ground import soil
from groundslab.views.plots.request import PlottedCombination
from groundslab.views.plots.style import PAGE_COLORS, plain_text
from groundslab.views.report import html as document
from groundslab.views.report.drawings.case_plan import SIDES, draw_case_plan
from groundslab.views.report.drawings.drawings import draw_case, draw_soil, find_governing
from groundslab.views.report.html import render_report
from groundslab.views.report.input_tables import SECTIONS as CASE
from groundslab.views.report.input_tables import InputTable, input_tables
from groundslab.views.report.table_layout import (
    MOST_COLUMNS,
    is_long,
    layout_table,
    split_columns,
    split_symbol,
    split_words,
    summarize_table,
)
from groundslab.views.scene.binary import PART
from groundslab.views.summary import sections
from groundslab.views.summary.terminal import shown_row
from groundslab.views.tables.result_tables import tables_of
from groundslab.views.tables.table import table_of
from helpers import synthetic
from helpers.pages import Element, page
from helpers.scenes import unpack, values_of

#: Chapters in their order; the viewer stands in a section that is not on paper.
CHAPTERS = [
    "drawings", "loads", "extremes", "pictures", "assumptions", "calculations", "tables", "viewer", "refused",
    "case", "certificate", "convergence",
]  # fmt: skip
#: Texts that do harm where they are not escaped.
EVIL = [
    "</script><script>alert(1)</script>",
    '"><img src=x onerror=alert(1)>',
    "' onmouseover='alert(1)",
    "{{ 7 * 7 }}{% raw %}",
    "<!-- --><style>*{display:none}</style>",
    "&lt;b&gt; ]]> \u202e\x00\x1b[2J",
]
SOIL = {"kind": "vlasov", "layers": [{"E": 10e6, "nu": 0.3, "thickness": 2}, {"E": 60e6, "nu": 0.3, "thickness": 4}]}


def described(words: list[str], **changes: Any) -> Model:
    """Return a model with something of every kind, named by the words in turn, each name once."""
    names = (f"{word} {turn}" for turn in range(100) for word in words)
    cases, combos = [next(names), next(names)], [next(names) for _ in range(3)]
    column, pile = next(names), next(names)
    parts: dict[str, Any] = {
        "title": next(names),
        "project": {"name": next(names), "client": next(names), "revision": "B"},
        "plate": {
            "length_x": synthetic.LENGTH_X, "length_y": synthetic.LENGTH_Y, "thickness": 0.4, "E": 30e9, "nu": 0.2,
            "openings": [{"kind": "circle", "centre": (-3, 1), "radius": 0.3}],
            "zones": [{"shape": {"kind": "rectangle", "x": (0, 1), "y": (0, 1)}, "thickness": 0.6}],
        },
        "ground": SOIL,
        "boreholes": [
            {"name": next(names), "x": x, "y": 0, "layers": SOIL["layers"]} for x in (-4, 4, 50)
        ],
        "contact": {"voids": [{"depth": 0.01, "x": (3, 4), "y": (-1, 0)}]},
        "cases": [{"name": cases[0]}, {"name": cases[1], "action": "variable"}],
        "columns": [
            {"name": column, "x": 1, "y": 2, "diameter": 0.4},
            {"name": next(names), "x": -2, "y": -2, "width_x": 0.4, "width_y": 0.6},
        ],
        "supports": [
            {"kind": "point", "name": pile, "x": 2, "y": -1.5, "stiffness": 5e7, "acts": "in compression"},
            {"kind": "line", "name": next(names), "points": [(3, 1), (3, 2)]},
        ],
        "loads": [
            {"kind": "uniform", "name": next(names), "q": 1e3, "case": cases[0]},
            {"kind": "patch", "name": next(names), "q": 2e3, "x": (1, 2), "y": (-1, 1), "case": cases[1]},
            {"kind": "line", "name": next(names), "q": 2e3, "points": [(-4, -3), (4, -3)], "case": cases[1]},
            {"kind": "point", "name": next(names), "P": 2e5, "column": column, "case": cases[0]},
            {"kind": "point", "name": next(names), "P": 1e5, "x": 4, "y": 3, "width_x": 0.2, "width_y": 0.3,
             "case": cases[1]},
            {"kind": "settlement", "name": next(names), "support": pile, "w": 0.01, "case": cases[1]},
        ],
        "combinations": [
            {"name": combos[0], "factors": {cases[0]: 1.35, cases[1]: 1.5}},
            {"name": combos[1], "limit_state": "characteristic", "factors": {cases[0]: 1.0, cases[1]: 1.0}},
            {"name": combos[2], "factors": {cases[1]: 2.0}},
        ],
        "output": {
            "points": [{"name": next(names), "x": 0, "y": 1.5}],
            "lines": [{"name": next(names), "start": (-4, 0.5), "end": (4, 0.5)}],
            "strips": [{"name": next(names), "start": (-4, -1), "end": (4, -1), "width": 1}],
        },
        "reinforcement": {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05)},
        "mesh": {"symmetry": "off"},
    }  # fmt: skip
    return Model(**parts | changes)


def solved(model: Model, n: int = 6, **changes: Any) -> Results:
    """Return made-up results of all combinations but the last one, which is refused with the case's title."""
    supports = tuple(
        SupportResult(
            name=support.name,
            nodes=np.array([[2.0, -1.5]]) if support.kind == "point" else np.array([[3.0, 1.0], [3.0, 2.0]]),
            length=np.zeros(1) if support.kind == "point" else np.full(2, 0.5),
            settlement=np.full(1 if support.kind == "point" else 2, 0.01),
            force=np.full(1 if support.kind == "point" else 2, 1e5),
            moment_x=np.zeros(1 if support.kind == "point" else 2),
            moment_y=np.zeros(1 if support.kind == "point" else 2),
        )
        for support in model.supports
    )
    made = {}
    for number_of, each in enumerate(model.combinations[:-1], 1):
        one = synthetic.results(
            n, model=model, combination=each.name, limit_state=each.limit_state, factors=each.factors,
            supports=supports, constants=Constants((2e7,), (3e7,), 1.2, 3, 0.25), **changes,
        )  # fmt: skip
        plate = replace(one.plate, settlement=number_of * one.plate.settlement)
        made[each.name] = replace(one, plate=plate)
    last = model.combinations[-1].name
    return Results(model, model.combinations, made, {last: NoEquilibrium(f"nothing holds {model.title}")})


@pytest.fixture(scope="module")
def plain() -> Results:
    """Return a solved model with something of every kind."""
    return solved(described(["part"]))


@pytest.fixture(scope="module")
def root(plain: Results) -> Element:
    """Return the report of the plain model."""
    return page(render_report(plain))


def sections_of(model: Model) -> list[InputTable]:
    """Return the sections of a case as the report lists them."""
    return input_tables(model, list_combinations(model))


def grids(section: Element) -> Iterator[tuple[list[str], list[list[str]]]]:
    """Yield heads and rows of each table in a section."""
    for table in section.all("table"):
        yield (
            [" ".join(head.text.split()) for head in table.all("th")],
            [[cell.text for cell in row.all("td")] for row in table.one("tbody").all("tr")],
        )


class TestStructure:
    """What stands where."""

    @pytest.mark.slow
    def test_sections_stand_in_their_order(self, root: Element) -> None:
        """The page has all sections, and the contents lead to each."""
        main = root.one("main")
        ids = [each.attributes["id"] for each in main.all("section") if "id" in each.attributes]
        found = ["viewer" if each == "explore" else each for each in ids if not each.startswith("table-")]
        assert found == CHAPTERS
        assert [link.attributes["href"] for link in root.one("nav").all("a")] == [f"#{name}" for name in CHAPTERS]

    @pytest.mark.slow
    def test_names_of_places_are_there_once(self, root: Element) -> None:
        """No id stands twice, and every link leads to one."""
        ids = [each.attributes["id"] for each in root.all() if "id" in each.attributes]
        assert len(set(ids)) == len(ids)
        links = [link.attributes["href"] for link in root.all("a")]
        assert links
        assert {link.removeprefix("#") for link in links} <= set(ids)

    def test_title_block(self, plain: Results, root: Element) -> None:
        """Title, program, version, file and hash; the hash is that of the text that the page holds."""
        head = root.one("header", class_="title")
        assert head.one("h1").text == plain.model.title
        facts = dict(zip((each.text for each in head.all("dt")), (each.text for each in head.all("dd")), strict=True))
        text = casefile.to_toml(plain.model)
        assert groundslab.__version__ in facts["Program"]
        assert facts["Input file"] == "case.toml"
        assert facts["SHA-256 of its text"] == hashlib.sha256(text.encode()).hexdigest()
        assert facts["Combinations"] == "3, of which 1 without equilibrium"
        assert root.one("details", id="text").one("pre").text == text

    @pytest.mark.slow
    def test_own_text_and_name_of_the_input(self, plain: Results) -> None:
        """Whoever has the input as it was written can give it: the page holds it, and its hash."""
        text = "# mine\n" + casefile.to_toml(plain.model)
        found = page(render_report(plain, text=text, file="raft <1>.toml", chapters=["case"]))
        assert found.one("pre").text == text
        reported = found.one("header", class_="title").text
        assert hashlib.sha256(text.encode()).hexdigest() in reported
        assert "raft <1>.toml" in reported

    def test_drawings_and_pictures(self, root: Element) -> None:
        """Plan, soil and signs are drawings; pictures are within the page, with words and their size."""
        assert [each.attributes["aria-label"] for each in root.one("section", id="drawings").all("svg")] == [
            "Plan of the plate",
            "Mesh: the elements of the plate.",
            "Columns of soil",
        ]
        case = root.one("section", id="case").text
        assert [case.count(each) for each in ("mean scaled Jacobian", "unknowns1234")] == [1, 1]
        *pictures, strips = root.one("section", id="pictures").all("svg", class_="drawing")
        assert strips.attributes["aria-label"].startswith("Along the strips ")
        shown = [picture.attributes["aria-label"].partition(" [")[0] for picture in pictures]
        assert shown[:2] == ["Settlement of the plate, downwards positive", "Contact pressure under the plate"]
        assert [words.partition(",")[0] for words in shown[-4:]] == [
            f"Required area {face} {axis}" for face in ("bottom", "top") for axis in "xy"
        ]
        assert {words.partition(",")[0] for words in shown[2:-4]} == {
            f"Bending moment of strips along {axis}" for axis in "xy"
        }
        for number, picture in enumerate(pictures):
            assert picture.attributes["aria-label"] == picture.one("title").text
            assert picture.attributes["aria-label"].endswith(".")
            assert 300 < int(picture.attributes["width"]) < 400
            assert len(list(picture.all("path"))) > 5
            # what lies on the plate is drawn once, and the others refer to it
            assert [each.attributes["href"] for each in picture.all("use")].count("#frame-of-maps") == (number > 0)
            assert len(list(picture.all("g", id="frame-of-maps"))) == (number == 0)

    def test_pictures_have_numbers(self, plain: Results, root: Element) -> None:
        """The numbers on a picture are values at nodes: each is one of the field that is drawn, to three digits."""
        picture = next(root.one("section", id="pictures").all("svg", class_="drawing"))
        largest = find_governing(plain)["settlement"]
        values = plain.results[largest].plate.settlement * PLATE_FIELDS["settlement"].scale
        known = {f"{value:.3g}".replace("-", "\N{MINUS SIGN}") for value in values}
        numbers = [each.text for each in picture.all("text") if each.attributes.get("paint-order")]
        on_plan = [text for text in numbers if not text.startswith(("max", "min", "t ="))]
        named = {column.name for column in plain.model.columns}
        assert len(set(on_plan) - named) > 5
        assert set(on_plan) - named <= known

    def test_drawings_follow_the_page(self, root: Element) -> None:
        """Inline drawings have the page's colors and letters: no style, no font, none of the palette's own colors."""
        inside = [each for svg in root.all("svg", class_="drawing") for each in svg.all()]
        values = {value for each in inside for value in each.attributes.values()}
        assert not values & set(PAGE_COLORS)
        used = {name for value in values for name in re.findall(r"var\((--[\w-]+)\)", value)}
        assert {"--gs-ink", "--gs-paper", "--gs-load", "--gs-soil"} <= used
        assert used <= set(re.findall(r"(--[\w-]+):", root.one("style").text))
        assert not {"style", "font-family"} & {name for each in inside for name in each.attributes}

    @pytest.mark.slow
    def test_the_same_results_give_the_same_page(self) -> None:
        """Nothing depends on when or where it is made, pictures included."""
        results = synthetic.results()
        assert render_report(results) == render_report(results)


class TestVerdict:
    """Whether the results may be used."""

    def test_of_several(self, root: Element) -> None:
        """One refused combination makes the verdict bad, and its reason is reported."""
        verdict = root.one("p", class_="verdict bad").text
        assert "FOUNDATION FAILS: no equilibrium in 1 of 3 combinations, number 3." in verdict
        assert "The results of the others are certified." in verdict
        assert root.one("p", class_="verdict bad design").text.startswith("FOUNDATION FAILS")
        assert "nothing holds part" in root.one("section", id="refused").text

    @pytest.mark.slow
    def test_of_one_that_is_certified(self) -> None:
        """A good result is called so; nothing is refused."""
        uniform = synthetic.model().replace(loads=[{"kind": "uniform", "q": 1e4}])
        results = synthetic.in_contact(synthetic.results(model=uniform))
        found = page(render_report(synthetic.compared(results)))
        assert found.one("p", class_="verdict good").text == sections.certified_words(1)
        assert not list(found.all("section", id="refused"))
        assert {each for row in next(grids(found.one("section", id="certificate")))[1] for each in row[4:]} == {
            "",
            "holds",
        }

    @pytest.mark.slow
    def test_of_one_that_is_not(self) -> None:
        """An uncertified result is shown with its certificate only: no extremes, no pictures, no tables of it."""
        bad = replace(synthetic.CERTIFICATE, residual=1.0)
        found = page(render_report(synthetic.results(certificate=bad)))
        assert "do not use the result" in found.one("p", class_="verdict bad").text
        rows = next(grids(found.one("section", id="certificate")))[1]
        assert [row[0] for row in rows if row[-1] == "FAILED"] == ["residual force at a node"]
        assert "No combination has a certified result" in found.one("section", id="extremes").text
        assert not list(found.one("section", id="pictures").all("svg"))

    @pytest.mark.slow
    def test_of_none(self) -> None:
        """If every combination is refused, the case, its drawings and the reasons are left."""
        model = described(["part"])
        refused = {each.name: NoEquilibrium(f"why {each.name}") for each in model.combinations}
        found = page(render_report(Results(model, model.combinations, {}, refused)))
        assert "no equilibrium in " in found.one("p", class_="verdict bad").text
        assert all(f"why {name}" in found.one("section", id="refused").text for name in refused)
        assert found.one("section", id="drawings").one("svg", class_="drawing").text.startswith("Plan")


class TestNumbers:
    """Every number is one of the results, shown as the summary shows it."""

    @pytest.mark.slow
    def test_all_tables_are_there(self, plain: Results, root: Element) -> None:
        """Each table has its section, its title, its rows and its notes; a wide one in parts of few columns."""
        section = root.one("section", id="tables")
        tables = tables_of(plain)
        assert len(tables) == 15
        for table in tables:
            if table.name == "calculations":  # a chapter of its own
                continue
            part = section.one("section", id=f"table-{table.name}")
            assert part.one("h3").text == table.title
            if is_long(table):
                assert f"All {len(table)} rows: tables/{table.name}.csv" in part.text
                continue
            assert all(note in part.text for note in table.notes)
            cells = [
                "" if value is None else format_number(value) if isinstance(value, float) else str(value)
                for value in table.columns[-1].values
            ]
            whole = [rows for _, rows in grids(part) if len(rows) == len(table)]
            assert [row[-1] for row in whole[-1]] == cells, table.name
            assert all(len(heads) <= MOST_COLUMNS for heads, _ in grids(part))

    def test_extremes_are_those_of_the_results(self, plain: Results, root: Element) -> None:
        """The largest settlement stands with place and combination, as made: the second has twice the first's."""
        rows = {tuple(row[:2]): row for _, found in grids(root.one("section", id="extremes")) for row in found}
        second = plain.combinations[1].name
        first = plain.combinations[0].name
        assert rows["largest settlement", "w"] == [
            "largest settlement", "w", "mm",
            format_number(28.0), "(0.000, 0.000)", first, format_number(56.0), "(0.000, 0.000)", second,
        ]  # fmt: skip
        assert rows["largest moment", "mx"][2:4] == ["kNm/m", format_number(100.0)]

    @pytest.mark.slow
    def test_figures_are_written_as_in_the_summary(self) -> None:
        """Value, unit and place of each extreme are the texts of the summary's rows."""
        results = synthetic.results(4, shear=True, constants=Constants((synthetic.K0,), (synthetic.K1,), None, 0))
        found = [row for _, rows in grids(page(render_report(results)).one("section", id="extremes")) for row in rows]
        for section in sections.figures(results):
            for row in section.rows:
                shown = shown_row(row, "SI")
                symbol = row.symbol.replace("_", "")
                cells = next(each for each in found if each[0] == row.label and symbol in each[1])
                assert shown.figure in cells
                assert shown.unit in cells
                assert shown.place in cells

    def test_scene_holds_the_fields(self, plain: Results, root: Element) -> None:
        """The viewer's data are those of the results to a share of their range that is no part of a color."""
        scene = unpack(gzip.decompress(base64.b64decode(root.one("script", id="scene").text)))
        assert scene.head["title"] == plain.model.title
        for reported in scene.head["combinations"][:2]:
            plate = plain.results[reported["name"]].plate
            for name in ("settlement", "pressure", "moment_x", "moment_xy", "shear_y"):
                exact = getattr(plate, name) * PLATE_FIELDS[name].scale
                error = np.abs(values_of(scene, reported["values"][name]) - exact).max()
                assert error <= np.ptp(exact) / PART, name

    def test_the_viewer_gets_its_messages(self, plain: Results, root: Element, monkeypatch: pytest.MonkeyPatch) -> None:
        """In another language the page holds the viewer's own messages and those of its fields, and no others."""
        assert not list(root.all("script", id="messages"))
        meaning = PLATE_FIELDS["settlement"].meaning
        known = {"Fit": "Zoom", meaning: "Setzung </script>", "Save the case file as": "Sichern"}
        monkeypatch.setattr(catalogue, "messages", lambda _: known)
        assert plain.model.project is not None
        project = plain.model.project.model_copy(update={"language": "de"})
        model = plain.model.model_copy(update={"project": project})
        german = page(render_report(replace(plain, model=model), chapters=["viewer"]))
        assert german.one("html").attributes["lang"] == "de"
        held = json.loads(german.one("script", id="messages").text)
        assert (held["language"], held["messages"]) == ("de", {"Fit": "Zoom", meaning: "Setzung </script>"})

    def test_constants_and_history(self, plain: Results, root: Element) -> None:
        """The combinations share their constants; each has its steps."""
        (heads, rows), (_, steps) = grids(root.one("section", id="convergence"))
        assert heads == ["compression k0 [MPa/m]", "shear k1 [MPa m]", "decay of the mode γ", "iterations for gamma"]
        assert rows == [["20.000", "30.000", "1.2000", "3"]]
        assert len(steps) == sum(len(each.steps) for each in plain.results.values())
        assert steps[2][1:] == ["1234", "1", "-", "2", "16", "0", "*"]

    def test_governing_combinations(self) -> None:
        """Each picture shows the combination that governs: the second has twice the settlements, the third moments."""
        combined = solved(described(["part"]))
        first, second, _ = (each.name for each in combined.combinations)
        more = {**combined.results}
        plate = more[first].plate
        more[first] = replace(more[first], plate=replace(plate, moment_x=-3 * plate.moment_x))
        found = find_governing(replace(combined, results=more))
        assert found == {
            "settlement": second, "uplift": second, "pressure": first, "moment_x": first, "moment_y": first,
        }  # fmt: skip

    def test_without_uplift_none_governs(self) -> None:
        """Where all of the plate bears, no uplift is shown."""
        assert "uplift" not in find_governing(results_of(synthetic.results(lifts=False)))


def harmful(root: Element) -> list[str]:
    """Return what could run or load something: handlers, styles in attributes, strange elements, foreign addresses."""
    found = []
    for each in root.all():
        if each.name in {"iframe", "object", "embed", "link", "base", "form", "audio", "video", "foreignobject"}:
            found.append(each.name)
        for name, value in each.attributes.items():
            address = name in {"src", "href", "srcset", "action", "data", "poster", "background", "xlink:href"}
            if (
                name.startswith("on")
                or name == "style"
                or (address and not re.match(r"#|data:image/png;base64,", value))
            ):
                found.append(f"{each.name} {name}={value[:60]}")
    return found


class TestSafety:
    """Nothing that a case says does anything, and nothing is fetched."""

    @pytest.mark.slow
    def test_texts_are_only_texts(self, root: Element) -> None:
        """Title, names of all things, file, and reasons are shown as they are; the page has the elements it would."""
        evil = "".join(EVIL)
        model = described([evil])
        html = render_report(solved(model), file=evil)
        found, usual = page(html), root
        assert harmful(found) == []
        assert [each.name for each in found.all("script")] == ["script"] * 2
        assert [each.name for each in found.one("head").all()] == [each.name for each in usual.one("head").all()]
        assert {each.name for each in found.all()} == {each.name for each in usual.all()}
        shown = printable(evil)
        assert found.one("h1").text.startswith(shown)
        assert found.one("head").one("title").text.startswith(shown)
        assert f"nothing holds {shown}" in found.one("section", id="refused").text
        plan = next(found.one("section", id="drawings").all("svg"))
        for each in (*model.columns, *model.supports, *model.output.lines, *model.output.strips):
            assert any(text.text.startswith(plain_text(each.name)) for text in plan.all("text"))
        assert not re.search(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]", html)

    def test_the_policy_lets_through_what_the_page_brings(self, root: Element) -> None:
        """The page's policy allows nothing but its own script and style, whose hashes it states."""
        (policy,) = [each.attributes["content"] for each in root.all("meta") if "http-equiv" in each.attributes]
        rules = dict(rule.strip().split(" ", 1) for rule in policy.split(";"))
        assert rules["default-src"] == "'none'"
        script = next(each for each in root.all("script") if "type" not in each.attributes)
        for rule, text in (("script-src", script.text), ("style-src", root.one("style").text)):
            digest = base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()
            assert rules[rule] == f"'sha256-{digest}'"
        assert rules["img-src"] == "data: blob:"
        assert rules["base-uri"] == rules["form-action"] == "'none'"

    def test_nothing_is_fetched(self, root: Element) -> None:
        """No address of the page, of its style or of its drawings leads out of it."""
        assert harmful(root) == []
        style = root.one("style").text
        assert not re.search(r"url\(\s*[\"']?(?!data:)|@import", style)

    def test_a_broken_script_is_noticed(self, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
        """A built file that would end its element, or one that is missing, is an error that says what to do."""
        monkeypatch.setattr(document, "HERE", tmp_path)
        with pytest.raises(GroundslabError, match=r"report.js.*npm run build"):
            document.read_asset("report.js")
        (tmp_path / "static").mkdir()
        for bad in ("x = '</script>'", "<!-- x", "a\x00b"):
            (tmp_path / "static" / "report.js").write_text(bad, encoding="utf-8")
            with pytest.raises(GroundslabError, match="break the page"):
                document.read_asset("report.js")


class TestSize:
    """Reports go by mail."""

    @pytest.mark.slow
    def test_a_long_table_has_a_digest_and_is_whole_in_the_appendix(self, monkeypatch: pytest.MonkeyPatch) -> None:
        """On paper a long table of lines leaves its extremes; one that is longer still names its CSV file."""
        combined = solved(described(["part"]), n=24)
        found = page(render_report(combined, chapters=["tables"])).one("section", id="table-lines")
        table = {each.name: each for each in tables_of(combined)}["lines"]
        assert len(table) > 60
        heads, rows = next(grids(found))
        assert heads == [
            "line",
            "quantity",
            "unit",
            "least",
            "s [m]",
            "combination",
            "greatest",
            "s [m]",
            "combination",
        ]
        settlements = table["settlement w"]
        assert rows[0][3] == format_number(min(settlements))
        assert rows[0][6] == format_number(max(settlements))
        assert rows[0][8] == combined.combinations[1].name
        assert f"All {len(table)} rows: tables/lines.csv" in found.text
        assert not list(found.all("details"))
        root = page(render_report(combined, chapters=["tables", "long_tables"]))
        assert f"All {len(table)} rows: the appendix." in root.one("section", id="table-lines").text
        _, whole = next(grids(root.one("section", id="whole-lines")))
        assert len(whole) == len(table)
        monkeypatch.setattr("groundslab.views.report.table_layout.MOST_IN_FILE", 50)
        cut = page(render_report(combined, chapters=["tables", "long_tables"]))
        for part in (cut.one("section", id="table-lines"), cut.one("section", id="whole-lines")):
            assert "tables/lines.csv" in part.text
            assert not list(part.all("details"))

    @pytest.mark.slow
    def test_what_is_left_out_is_named(self, monkeypatch: pytest.MonkeyPatch, plain: Results) -> None:
        """Fields beyond the budget are left out, and the page says whose."""
        monkeypatch.setattr(document, "MOST_DATA", 1)
        reported = page(render_report(plain, chapters=["viewer"])).one("section", id="explore").text
        assert plain.combinations[0].name in reported
        assert plain.combinations[1].name not in reported

    def test_as_much_as_there_is_room_for(self, monkeypatch: pytest.MonkeyPatch) -> None:
        """With room for two of three combinations, two are kept, and the file's part for them is not exceeded."""
        model = synthetic.model().replace(
            cases=[{"name": "G"}],
            loads=[{"kind": "uniform", "q": 1e3, "case": "G"}],
            combinations=[{"name": f"C{n}", "factors": {"G": float(n)}} for n in range(1, 4)],
        )
        noise = np.random.default_rng(1).uniform(size=(3, 5, 41 * 41))
        made = {}
        for each, values in zip(model.combinations, noise, strict=True):
            one = synthetic.results(20, model=model, combination=each.name, factors=each.factors)
            fields = dict(zip(("moment_x", "moment_y", "moment_xy", "shear_x", "shear_y"), values, strict=True))
            made[each.name] = replace(one, plate=replace(one.plate, **fields))
        combined = Results(model, model.combinations, made, {})
        whole, head = document._scene(combined)
        assert head["left_out"] == []
        monkeypatch.setattr(document, "MOST_DATA", int(0.85 * len(whole)))
        text, head = document._scene(combined)
        assert len(head["left_out"]) == 1
        assert len(text) <= 0.85 * len(whole)

    @pytest.mark.slow
    def test_ten_thousand_nodes_stay_small(self) -> None:
        """A tenth of a large raft, with two combinations, stays below a tenth of 20 MB."""
        html = render_report(solved(described(["part"]), n=50))
        assert len(html.encode()) < 2_000_000


class TestEcho:
    """The case as the report tells it."""

    def test_single_keys(self) -> None:
        """Quantities come in a fitting unit, numbers as they are, choices and flags as words."""
        reported = {section.key: section for section in sections_of(described(["part"]))}
        plate = {row[0].text: row for row in reported["plate"].grids[0].rows}
        assert [cell.text for cell in plate["thickness"]] == ["thickness", "t", "400 mm", "thickness"]
        assert plate["E"][2].text == "30 GPa"
        assert plate["nu"][1].text == "nu"
        assert plate["shear factor"][2].text == "0.833333"
        contact = {row[0].text: row[-2].text for row in reported["contact"].grids[0].rows}
        assert contact["tensionless"] == "yes"

    def test_lists_share_a_unit(self) -> None:
        """Parts of one kind stand in one grid by their numbers in the case, each column in one unit."""
        reported = {section.key: section for section in sections_of(described(["part"]))}
        points = next(grid for grid in reported["loads"].grids if grid.title.startswith("point"))
        assert [(head.text, head.unit) for head in points.heads[:4]] == [
            ("no.", ""),
            ("name", ""),
            ("case", ""),
            ("P", "kN"),
        ]
        assert [[row[0].text, row[3].text] for row in points.rows] == [["4", "200"], ["5", "100"]]
        supports = reported["supports"].grids
        assert [head.text for head in supports[0].heads if head.unit == "MN/m"] == ["stiffness"]
        assert "rigid" in [cell.text for cell in supports[1].rows[0]]

    def test_parts_within_parts(self) -> None:
        """Layers of boreholes stand below them, each under its name."""
        reported = {section.key: section for section in sections_of(described(["part"]))}
        titles = [grid.title for grid in reported["boreholes"].grids]
        assert titles[0] == ""
        assert [title.endswith(": layers") for title in titles[1:]] == [True] * 3
        assert [row[1].text for row in reported["boreholes"].grids[1].rows] == ["10", "60"]

    def test_shapes_in_words(self) -> None:
        """Rectangles, circles and polygons are reported with their places in metres."""
        plate = {
            "outline": {"kind": "polygon", "points": [(0, 0), (8, 0), (8, 4)], "bulges": (0.0, 0.5)},
            "openings": [{"kind": "circle", "centre": (6, 1.5), "radius": 0.25}],
            "zones": [{"shape": {"kind": "rectangle", "x": (7, 7.5), "y": (1, 2)}, "thickness": 0.6}],
            "thickness": 0.4, "E": 30e9, "nu": 0.2,
        }  # fmt: skip
        model = Model(plate=plate, ground={"kind": "winkler", "k": 2e7}, loads=[{"kind": "uniform", "q": 1e3}])
        texts = {
            cell.text for section in sections_of(model) for grid in section.grids for row in grid.rows for cell in row
        }
        assert "polygon (0, 0) (8, 0) (8, 4) m; bulges 0, 0.5" in texts
        assert "rectangle, x = 7 to 7.5 m, y = 1 to 2 m" in texts
        assert {"(6, 1.5) m", "250"} <= texts

    def test_automatic_combinations_are_told(self) -> None:
        """What EN 1990 makes stands among the combinations, with its factors."""
        model = described(["part"], combinations=(), combine={"sets": ["ultimate"]})
        reported = {section.key: section for section in sections_of(model)}
        (grid,) = reported["combinations"].grids
        assert "1.35 part 0 + 1.5 part 1" in {row[3].text for row in grid.rows}


def texts(figure: Any) -> list[str]:
    """Return all that is written in a figure."""
    from matplotlib.text import Text

    return [each.get_text() for each in figure.findobj(Text) if each.get_text()]


class TestDrawings:
    """Plan and soil."""

    def test_plan_has_dimensions_names_and_notes(self) -> None:
        """The sides in meters, names of what stands there, numbers of loads; what is too far away is named."""
        drawn = draw_case(described(["part"]), as_solved(described(["part"])))
        found = [each.text for each in page(drawn.svg).all("text")]
        assert {"9.6", "7.2", "L2", "L3", "L5", "x", "y"} <= set(found)
        assert "L4" not in found  # it stands on a column
        assert "L1 (uniform), L6 (settlement)" in drawn.caption
        assert "(50, 0)" in drawn.caption

    def test_plan_is_to_scale(self) -> None:
        """The plate's outline has the proportions of the plate, y upwards."""
        figure = draw_case_plan(described(["part"]), as_solved(described(["part"])))
        (axes,) = figure.axes
        outline = axes.patches[0]
        corners = axes.transData.transform(outline.get_xy())
        (width, height), (x, y) = np.ptp(corners, axis=0), corners[0]
        assert width / height == pytest.approx(synthetic.LENGTH_X / synthetic.LENGTH_Y, rel=1e-3)
        assert (x, y) == (corners[:, 0].min(), corners[:, 1].min())  # the first corner is the lower left one

    def test_corners_have_dimensions_of_their_own(self) -> None:
        """An L has a chain of dimensions along each side, beside those of the entire plate."""
        plate = {
            "outline": {"kind": "polygon", "points": [(0, 0), (30, 0), (30, 10), (12, 10), (12, 20), (0, 20)]},
            "thickness": 0.4, "E": 30e9, "nu": 0.2,
        }  # fmt: skip
        model = Model(plate=plate, ground={"kind": "winkler", "k": 2e7}, loads=[{"kind": "uniform", "q": 1e3}])
        found = texts(draw_case_plan(model, as_solved(model)))
        assert [found.count(length) for length in ("12", "18", "30", "10", "20")] == [1, 1, 1, 2, 1]

    def test_columns_have_dimensions_and_sizes(self) -> None:
        """Chains stop at the columns' centers; where two stand too close, at the place that more of them share."""
        columns = [
            {"name": name, "x": x, "y": y, "width_x": 0.3, "width_y": 0.4}
            for name, x, y in (("A", -4, -2), ("B", -4, 2), ("C", -3.9, 0), ("D", 2, 0))
        ]
        columns.append({"name": "R", "x": -1, "y": 0, "diameter": 0.5})
        plate = {"length_x": 12.0, "length_y": 6.0, "thickness": 0.4, "E": 30e9, "nu": 0.2}
        ground, loads = {"kind": "winkler", "k": 2e7}, [{"kind": "uniform", "q": 1e3}]
        model = Model(plate=plate, ground=ground, loads=loads, columns=columns)
        found = texts(draw_case_plan(model, as_solved(model)))
        assert [found.count(length) for length in ("2", "3", "4", "12", "1", "6")] == [3, 2, 1, 1, 2, 1]
        assert {"A 300/400", "R \N{DIAMETER SIGN}500", "t = 0.4 m"} <= set(found)
        feet = texts(draw_case_plan(model.replace(project={"name": "slab", "units": "US"}), as_solved(model)))
        assert "A 11.811/15.748" in feet

    def test_labels_keep_apart(self) -> None:
        """Many labels at one place do not lie upon each other as long as there is space."""
        labels = LabelPlacement((0, 200, 0, 200))
        for _ in range(6):
            labels.place_beside((100, 100), (20, 6), 7, SIDES)
        boxes = labels.taken
        assert len(boxes) == 6
        for i, a in enumerate(boxes):
            for b in boxes[:i]:
                assert abs(a[0] - b[0]) >= a[2] + b[2] or abs(a[1] - b[1]) >= a[3] + b[3]

    def test_attributes_and_texts_of_drawings_are_escaped(self) -> None:
        """Neither a text nor a label can end what it stands in, nor is it taken for an attribute of ours."""
        evil = '"><b> id="x" style="y" #1b1f23 url(#z)'

        def draw() -> Any:
            from matplotlib.figure import Figure

            figure = Figure()
            figure.text(0.5, 0.5, evil)
            return figure

        svg = page(to_inline_svg(draw, "evil", evil)).one("svg")
        assert svg.attributes["aria-label"] == svg.one("title").text == svg.one("text").text == evil
        assert not list(svg.all("b"))

    def test_fonts_in_shorthand(self) -> None:
        """Older versions of Matplotlib write slope, weight, size and family as one property."""
        found = dict(export._font_attributes("oblique 700 8.5px 'DejaVu Sans', sans-serif"))
        assert found == {"font-style": "oblique", "font-weight": "700", "font-size": "8.5px"}

    @pytest.mark.slow
    def test_ids_begin_with_the_name(self) -> None:
        """Two drawings on one page have no id in common, and what refers to one finds it."""
        found = [page(to_inline_svg(lambda: plot(synthetic.results(), "p"), name, "p")) for name in "ab"]
        ids, used = [], []
        for root in found:
            ids.append({each.attributes["id"] for each in root.all() if "id" in each.attributes})
            values = [value for each in root.all() for value in each.attributes.values()]
            links = {each.attributes["href"].removeprefix("#") for each in root.all() if "href" in each.attributes}
            used.append(links | {name for value in values for name in re.findall(r"url\(#(.+)\)", value)})
        assert not ids[0] & ids[1]
        assert set() < used[0] <= ids[0]

    @pytest.mark.slow
    def test_soil_is_to_scale(self, plain: Results) -> None:
        """Layers are drawn by their thickness, with their moduli, constants and modes."""
        results = next(iter(plain.results.values()))
        combination = PlottedCombination(results.combination, results.limit_state, results, certified=True)
        figure = soil.draw_columns(results.model, soil.soil_columns(results.model, [combination]))
        boxes = [axes for axes in figure.axes if axes.get_ylabel() == "depth z [m]"]
        assert [[patch.get_height() for patch in axes.patches[:2]] for axes in boxes] == [[2.0, 4.0]] * 3
        assert sum(axes.get_xlabel() == r"$\psi$ [-]" and len(axes.lines) == 1 for axes in figure.axes) == 3
        drawn = draw_soil(results)
        assert drawn is not None
        found = [each.text for each in page(drawn.svg).all("text")]
        assert found.count("10") >= 3
        assert found.count("0.3") == 6
        assert found.count(results.combination) == 3

    def test_springs_have_no_column(self) -> None:
        """Ground without layers has nothing to draw."""
        assert draw_soil(synthetic.results()) is None


class TestGrids:
    """Rows and columns."""

    def test_wide_tables_are_cut(self) -> None:
        """Each part repeats the columns that say which row it is, and no column is lost."""
        heads = [("a", ""), *((f"c{n}", "m") for n in range(35))]
        grid = layout_table(table_of("extremes", "Wide", heads, [["x", *range(35)]], ["note"]))
        parts = split_columns(grid, 1)
        assert [part.heads[0].text for part in parts] == ["a"] * 3
        assert [head.text for part in parts for head in part.heads[1:]] == [f"c{n}" for n in range(35)]
        assert all(len(part.heads) <= MOST_COLUMNS for part in parts)
        assert [part.notes for part in parts] == [(), (), ("note",)]

    def test_short_tables_have_no_digest(self) -> None:
        """A table that is printed whole needs none, and one of extremes has the envelope."""
        assert summarize_table(table_of("lines", "Lines", [("combination", ""), ("line", "")], [["a", "b"]])) is None

    @pytest.mark.parametrize(
        ("symbol", "pieces"),
        [
            ("gamma_c", [("γ", "c")]),
            ("q_x, q_y", [("q", "x"), (", q", "y")]),
            ("E", [("E", "")]),
            ("", []),
            ("-w", [("-w", "")]),
        ],
    )
    def test_symbols(self, symbol: str, pieces: list[tuple[str, str]]) -> None:
        """Greek letters are such, what follows an underscore is a subscript."""
        assert split_symbol(symbol) == pieces

    def test_symbols_within_words(self) -> None:
        """Words with an underscore are symbols, all others stay as they are."""
        pieces = split_words("largest |m_xy| of beta_x, gamma")
        assert "".join(base for base, _ in pieces) == "largest |m| of β, gamma"
        assert [sub for _, sub in pieces if sub] == ["xy", "x"]


class TestFiles:
    """Writing, and the command."""

    @pytest.fixture
    def folder(self, tmp_path: Path) -> Path:
        """Return a folder of results."""
        return results_folder.save_results(synthetic.results(model=synthetic.model()), tmp_path / "raft-results")

    @pytest.mark.slow
    def test_beside_the_folder(self, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """Without --out the report stands beside the folder under its name, which standard error tells."""
        assert cli.main(["report", str(folder)]) == 0
        target = folder.with_name("raft-results.html")
        out, err = capsys.readouterr()
        assert out == ""
        assert str(target) in err
        assert page(target.read_text(encoding="utf-8")).one("h1").text == "A slab of formulas"

    @pytest.mark.slow
    def test_the_same_folder_gives_the_same_file(self, folder: Path, tmp_path: Path) -> None:
        """Byte by byte, and it is that of the results in memory; the hash is that of case.toml."""
        for name in ("a.html", "b.html"):
            assert cli.main(["report", str(folder), "--out", str(tmp_path / name)]) == 0
        content = (tmp_path / "a.html").read_bytes()
        assert content == (tmp_path / "b.html").read_bytes()
        assert content == checksums.seal(render_report(synthetic.results(model=synthetic.model())).encode())
        assert hashlib.sha256((folder / "case.toml").read_bytes()).hexdigest() in content.decode()

    def test_a_case_that_was_changed_is_not_taken_for_the_input(self, folder: Path) -> None:
        """The text in the page describes the model that was solved, whatever became of the file."""
        model = synthetic.model()
        path = folder / "case.toml"
        assert report.text_of(folder, model) == casefile.to_toml(model)
        path.write_text("# a remark\n" + path.read_text(encoding="utf-8"), encoding="utf-8")
        assert str(report.text_of(folder, model)).startswith("# a remark")
        path.write_text(casefile.to_toml(synthetic.model(title="another")), encoding="utf-8")
        assert report.text_of(folder, model) is None
        path.write_bytes(b"\xff\xfe")
        assert report.text_of(folder, model) is None

    @pytest.mark.slow
    def test_a_case_that_has_changed_is_told_on_the_first_page(
        self, folder: Path, capsys: pytest.CaptureFixture[str]
    ) -> None:
        """A case of another model beside the folder is named; one with the same model is not."""
        model, beside = synthetic.model(), folder.with_name("raft.toml")
        assert report.changes_since(folder, model) == ""
        beside.write_text("# a remark\n" + casefile.to_toml(model), encoding="utf-8")
        assert report.changes_since(folder, model) == ""
        beside.write_text(casefile.to_toml(synthetic.model(title="another")), encoding="utf-8")
        assert report.changes_since(folder, model).startswith("raft.toml has changed since this analysis.")
        assert cli.main(["report", str(folder)]) == 0
        assert "note: raft.toml has changed" in capsys.readouterr().err
        told = page(folder.with_name("raft-results.html").read_text(encoding="utf-8")).one("header").text
        assert "raft.toml has changed since this analysis." in told

    @pytest.mark.slow
    def test_only_reports_are_replaced(self, folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """A file of another kind is left as it is; an older report is replaced."""
        target = tmp_path / "mine.html"
        target.write_text("<p>my notes", encoding="utf-8")
        assert cli.main(["report", str(folder), "--out", str(target)]) == 2
        assert target.read_text(encoding="utf-8") == "<p>my notes"
        assert "a report of groundslab" in capsys.readouterr().err
        assert cli.main(["report", str(folder), "--out", str(tmp_path)]) == 2
        target.unlink()
        for _ in range(2):
            assert cli.main(["report", str(folder), "--out", str(target)]) == 0
        assert sorted(path.name for path in tmp_path.iterdir()) == ["mine.html", "raft-results"]

    def test_not_within_the_folder_of_results(self, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """A report there would keep the folder from being replaced."""
        before = sorted(folder.rglob("*"))
        assert cli.main(["report", str(folder), "--out", str(folder / "tables" / "x.html")]) == 2
        assert "--out" in capsys.readouterr().err
        assert sorted(folder.rglob("*")) == before

    def test_what_is_no_folder_of_results(self, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """Exit code 2, the issue, and no file."""
        assert cli.main(["report", str(tmp_path)]) == 2
        assert "a folder of results that groundslab wrote" in capsys.readouterr().err
        assert not tmp_path.with_name(f"{tmp_path.name}.html").exists()

    def test_a_place_that_cannot_be_written(self, tmp_path: Path) -> None:
        """A folder that is not there is reported as such."""
        with pytest.raises(InputError, match="no folder"):
            groundslab.write_report(synthetic.results(), tmp_path / "missing" / "x.html")

    @pytest.mark.slow
    def test_refused_combinations_are_told(
        self, plain: Results, tmp_path: Path, capsys: pytest.CaptureFixture[str]
    ) -> None:
        """The command says that not all is well; the report is made, so the exit code is 0."""
        results_folder.save_results(plain, tmp_path / "several")
        assert cli.main(["report", str(tmp_path / "several")]) == 0
        assert "1 of 3 combinations" in capsys.readouterr().err

    @pytest.mark.slow
    def test_an_installation_that_is_not_whole(
        self, folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
    ) -> None:
        """Without the built parts there is no report: exit code 1 and what to do."""
        monkeypatch.setattr(document, "HERE", folder)
        assert cli.main(["report", str(folder)]) == 1
        assert "missing from this installation" in capsys.readouterr().err
        assert not folder.with_name("raft-results.html").exists()

    @pytest.mark.slow
    def test_in_python(self, tmp_path: Path) -> None:
        """The package's front has it, for one combination and for several."""
        target = groundslab.write_report(synthetic.results(), str(tmp_path / "x.html"))
        assert target.read_text(encoding="utf-8").startswith("<!doctype html>")


def test_title_block(root: Element) -> None:
    """What is given of the project stands first in the title block, in the order of its keys, and nothing else."""
    facts = root.one("dl")
    names = [each.text for each in facts.all("dt")]
    assert names[:4] == ["Project", "Client", "Revision", "Program"]
    project = described(["part"]).project
    assert project is not None
    assert [each.text for each in facts.all("dd")][:3] == [project.name, project.client, project.revision]


def test_every_section_of_a_case_is_listed() -> None:
    """No section of a case is missing in the report, whatever sections there are."""
    assert {name for name in Model.model_fields if name not in ("title", "project", "report")} <= CASE.keys()
