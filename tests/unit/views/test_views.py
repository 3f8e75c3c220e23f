"""What is said about results: summary, JSON, VTU, archive."""

from __future__ import annotations

import io
import json
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import meshio
import numpy as np
import pint
import pytest
from rich.console import Console
from rich.status import Status

from groundslab.errors import GroundslabError, InputError
from groundslab.results.fields import PLATE_FIELDS, POINT_FIELDS
from groundslab.results.records import SupportResult
from groundslab.results.results import results_of
from groundslab.units import UNITS, format_number
from groundslab.views.files import npz, vtk
from groundslab.views.summary import combinations, progress, sections, terminal
from groundslab.views.summary.json_summary import json_text
from groundslab.views.summary.rows import Row
from helpers import synthetic
from helpers.paths import ROOT


def rows(results: Any) -> dict[str, Row]:
    """Return all rows of a summary by "section.key"."""
    return {f"{section.key}.{row.key}": row for section in sections.summary(results) for row in section.rows}


def printed(results: Any, **options: Any) -> str:
    """Return what the summary prints."""
    console = Console(file=io.StringIO(), width=80, **options)
    terminal.print_summary(results_of(results), console)
    return console.file.getvalue()  # type: ignore[attr-defined]


class TestSummary:
    """The figures, whoever shows them."""

    def test_extremes_are_those_of_the_formulas(self) -> None:
        """Values and places are those that the made-up fields have by construction."""
        found = rows(synthetic.results(4))
        assert found["settlement.largest"].value == pytest.approx(0.028)
        assert found["settlement.largest"].place == (0.0, 0.0)
        assert found["settlement.largest_uplift"].value == pytest.approx(0.028)
        assert found["contact.largest_gap"].value == pytest.approx(0.028)
        assert found["contact.largest_pressure"].value == pytest.approx(0.028 * synthetic.K0)
        assert found["section_forces.largest_moment_x"].value == pytest.approx(1e5)
        assert found["section_forces.smallest_moment_y"].value == pytest.approx(-1e4)
        assert found["section_forces.smallest_moment_y"].place == (0.0, 3.6)
        assert found["section_forces.largest_moment_xy"].value == pytest.approx(2e3 * 4.8 * 3.6)
        assert found["section_forces.largest_shear_x"].value == pytest.approx(3e4 * 4.8)

    def test_of_equal_places_always_the_same_one_is_named(self) -> None:
        """Rounding on a symmetric plate does not decide which of four corners is named."""
        plain = synthetic.results()
        for sign in (-1, 1):
            noise = sign * 1e-18 * np.arange(len(plain.plate.nodes))
            shaken = replace(plain, plate=replace(plain.plate, settlement=plain.plate.settlement + noise))
            assert rows(shaken)["settlement.largest_uplift"].place == (4.8, 3.6)

    def test_share_of_contact_is_weighted_by_area(self) -> None:
        """The share is that of the areas, not of the number of nodes."""
        results = synthetic.results()
        only_centre = np.where(np.arange(len(results.plate.area)) == 12, results.plate.area, 0.0)
        share = rows(replace(results, plate=replace(results.plate, contact_area=only_centre)))["contact.share"]
        assert share.value == pytest.approx(4 / 144)

    def test_the_edge_line_force_is_a_figure_of_its_own(self) -> None:
        """Line forces at the edge are no pressure; they stand beside it in kN/m, where the ground has them."""
        results = synthetic.results(4, shear=True)
        found = rows(results)
        assert found["contact.largest_pressure"].value == pytest.approx(0.028 * synthetic.K0)
        line = found["contact.largest_line_force"]
        assert (line.value, line.unit, line.symbol) == (5e5, UNITS["kN/m"], "f")
        (note,) = next(section for section in sections.summary(results) if section.key == "contact").notes
        assert "line force" in note
        assert "contact.largest_line_force" not in rows(synthetic.results(4))
        pulled = replace(results, plate=replace(results.plate, line_force=-results.plate.line_force))
        assert rows(pulled)["contact.largest_pulling_line_force"].value == 5e5

    def test_without_uplift_the_smallest_settlement_is_shown(self) -> None:
        """A plate that rests everywhere has no uplift, and no place for a gap of zero."""
        found = rows(synthetic.results(lifts=False))
        assert found["settlement.smallest"].value == pytest.approx(0.014)
        assert "settlement.largest_uplift" not in found
        assert found["contact.largest_gap"].place is None

    def test_rounding_is_neither_uplift_nor_tension(self) -> None:
        """Negative values in the last digits, as at a held edge, are not called by those names."""
        results = synthetic.results(lifts=False)
        fields = {"settlement": results.plate.settlement, "pressure": results.plate.pressure}
        noisy = {name: np.where(results.plate.nodes[:, 0] < 0, -1e-15, values) for name, values in fields.items()}
        found = rows(replace(results, plate=replace(results.plate, **noisy)))
        assert "settlement.smallest" in found
        assert not any("tension" in key for key in found)

    def test_ground_that_pulls_is_reported(self) -> None:
        """Without tensionless contact a negative pressure shows up as tension."""
        results = synthetic.results()
        pulling = replace(results, plate=replace(results.plate, pressure=results.plate.settlement * synthetic.K0))
        assert rows(pulling)["contact.largest_tension"].value == pytest.approx(0.028 * synthetic.K0)

    def test_every_figure_that_must_vanish_has_words(self) -> None:
        """The certificate is shown in full."""
        assert set(sections.CERTIFICATE_WORDS) == set(synthetic.CERTIFICATE.limits())

    @pytest.mark.parametrize("part", ["plate", "ground", "certificate", "constants"])
    @pytest.mark.parametrize("bad", [np.nan, np.inf])
    def test_a_number_that_is_none_is_refused(self, part: str, bad: float) -> None:
        """NaN and infinity are never shown or written, wherever they stand."""
        results = synthetic.results()
        values: Any = getattr(results, part)
        name = {"certificate": "load", "constants": "gamma"}.get(part, "settlement")
        wrong = bad if part in ("certificate", "constants") else np.full_like(values.settlement, bad)
        with pytest.raises(GroundslabError, match=rf"{part}\.{name}"):
            sections.summary(replace(results, **{part: replace(values, **{name: wrong})}))

    @pytest.mark.slow
    def test_units_of_display_agree_with_si(self) -> None:
        """Every factor from SI to the unit of display is the one that pint finds."""
        registry = pint.UnitRegistry()
        assert {about.unit for about in (PLATE_FIELDS | POINT_FIELDS).values()} <= UNITS.keys()
        for unit in UNITS.values():
            texts = (re.sub(r"(m|cm)2", r"\1**2", text.replace("kNm", "kN m")) for text in (unit.name, unit.si))
            shown, si = (text.replace(" ", " * ").replace("%", "percent") for text in texts)
            assert registry.Quantity(1.0, si).to(shown).magnitude == pytest.approx(unit.scale), unit


class TestJson:
    """The summary for programs."""

    def test_numbers_with_a_dimension_name_their_si_unit(self) -> None:
        """Every object with a value has a unit, or is a line of the certificate with its limit."""
        document = json.loads(json_text(results_of(synthetic.results(shear=True)), files=["summary.json"]))

        def visit(item: Any) -> None:
            if isinstance(item, dict):
                if "value" in item:
                    assert set(item) <= {"value", "unit", "place"} or set(item) == {
                        "value",
                        "tolerance",
                        "ok",
                    }
                    assert item.get("unit", "m") in {"m", "Pa", "Pa/m", "Pa m", "N", "N/m", "N m/m", "m2"}
                for value in item.values():
                    visit(value)

        visit(document)
        assert document["settlement"]["largest"] == {"value": 0.028, "unit": "m", "place": [0.0, 0.0]}
        assert document["constants"]["k1"][1] == {"value": synthetic.K1 / 2, "unit": "Pa m"}
        assert document["certificate"]["residual"]["ok"] is True
        assert document["history"][2]["finest"] is True
        assert document["files"] == ["summary.json"]
        assert document["certified"] is True

    def test_numbers_of_numpy_are_written_too(self) -> None:
        """A result whose scalars come from NumPy gives the same text as one of plain numbers."""
        plain = synthetic.results()
        numpy = replace(
            plain,
            unknowns=np.int64(plain.unknowns),
            mesh_plan=replace(plain.mesh_plan, symmetry=tuple(np.bool_(used) for used in plain.symmetry)),
            constants=replace(plain.constants, k0=(np.float64(synthetic.K0),)),
            certificate=replace(plain.certificate, residual=np.float64(plain.certificate.residual)),
        )
        assert json_text(results_of(numpy)) == json_text(results_of(plain))


class TestTable:
    """The summary for people."""

    @pytest.mark.parametrize("shear", [False, True])
    def test_fits_80_columns_and_any_encoding(self, shear: bool) -> None:
        """No line is wider than 80 columns, and plain ASCII is enough."""
        text = printed(synthetic.results(4, shear=shear))
        assert max(map(len, text.splitlines())) <= 80
        assert text.isascii()

    def test_says_what_it_must(self) -> None:
        """Values, units, places and the verdict stand on the lines of their names."""
        lines = printed(synthetic.results()).splitlines()
        found = {key: next(line for line in lines if key in line) for key in ("uplift", "m_xy", "residual force")}
        assert "28.000 mm" in found["uplift"]
        assert "(4.800, 3.600)" in found["uplift"]
        assert "34.560 kNm/m" in found["m_xy"]
        assert found["residual force"].endswith("3.0e-12 ok (limit 1e-06)")
        assert any("1234" in line and line.rstrip().endswith("*") for line in lines)

    def test_a_failing_certificate_shows_without_colour(self) -> None:
        """FAILED stands in words on the line that fails, and at the end."""
        certificate = replace(synthetic.CERTIFICATE, force_balance=1e-3)
        text = printed(synthetic.results(certificate=certificate))
        assert text.count("FAILED") == 2
        assert "FAILED" in next(line for line in text.splitlines() if "loads against reactions" in line)

    def test_each_symbol_stands_once(self) -> None:
        """Label and symbol of a row are shown side by side, so a label does not repeat its symbol."""
        results = synthetic.results()
        text = printed(results)
        for section in sections.figures(results):
            for row in section.rows:
                assert row.symbol.strip("|-") not in row.label.split()
                assert text.count(f" {row.label} {row.symbol}".rstrip()) >= 1
        assert "largest moment m_x " in text

    def test_text_of_the_user_is_no_markup(self) -> None:
        """Brackets in a title are shown as they are."""
        model = synthetic.model(title="[bold]slab[/nothing]")
        assert "[bold]slab[/nothing]" in printed(synthetic.results(model=model), force_terminal=True)

    @pytest.mark.parametrize(
        ("value", "text"),
        [
            (0.0, "0"),
            (13.59, "13.590"),
            (-0.25, "-0.25000"),
            (23000.0, "23000"),
            (1e9, "1.0000e+09"),
            (2e-5, "2.0000e-05"),
        ],
    )
    def test_numbers_have_five_digits(self, value: float, text: str) -> None:
        """Five significant digits, an exponent only where needed."""
        assert format_number(value) == text

    def test_progress_names_the_step(self) -> None:
        """The line of progress changes with each step and says where the iteration is."""
        console = Console(file=io.StringIO(), width=100, force_terminal=True)
        step = synthetic.results().steps[1]
        with progress.on_terminal(progress.CombinationCount(1), console) as on_step:
            on_step(step)
        assert "1234 unknowns" in progress.line(step)
        assert "17 closed, 1 changed" in progress.line(step)


class TestOverview:
    """Several combinations side by side."""

    def test_extremes_name_the_combination_that_governs(self) -> None:
        """Of each figure the largest, of the smallest and of the share in contact the smallest; certified ones only."""
        found = {
            f"{section.key}.{each.row.key}": each
            for section, rows in combinations.extremes(synthetic.combined())
            for each in rows
        }
        largest = found["settlement.largest"]
        assert (largest.row.value, largest.number) == (pytest.approx(0.056), 2)
        assert found["settlement.smallest"].row.value == pytest.approx(0.028)
        assert found["settlement.largest_uplift"].number == 1
        assert found["contact.largest_gap"].number == 1
        share = found["contact.share"]
        assert share.number == 1
        assert share.row.value < 1
        assert found["section_forces.largest_moment_x"].number == 1  # the first of equal ones

    def test_worst_certificate(self) -> None:
        """Each figure is the largest of the certified results; the uncertified one is none of them."""
        found = {each.row.key: each for each in combinations.worst(synthetic.combined())}
        assert (found["residual"].row.value, found["residual"].number) == (4e-9, 2)
        assert all(each.row.ok for each in found.values())
        assert found.keys() == synthetic.CERTIFICATE.must_vanish().keys()

    def test_json_holds_each_with_its_figures(self) -> None:
        """Numbers as for one combination, extremes with the name of theirs; refused ones with their reason."""
        combined = synthetic.combined()
        document = json.loads(json_text(combined, {"NUL": "02-nul"}, ["summary.json"]))
        first, second, third, last = document["combinations"]
        one = json.loads(json_text(results_of(combined["NUL"])))
        for key in ("settlement", "contact", "section_forces", "certificate", "constants", "history"):
            assert second[key] == one[key]
        assert second["folder"] == "02-nul"
        assert first["factors"] == {"dead": 1.35, "wind": 1.5}
        assert third["certified"] is False
        assert third["certificate"]["residual"]["ok"] is False
        assert last["refused"] == {"error": "NoEquilibrium", "reason": "the loads pull the plate off"}
        assert "settlement" not in last
        assert document["extremes"]["settlement"]["largest"]["combination"] == "NUL"
        assert document["extremes"]["contact"]["share"]["combination"] == combined.combinations[0].name
        assert document["plate"] == one["plate"]
        assert document["mesh"] == one["mesh"]
        assert document["mesh"]["elements"] == 4
        assert document["mesh"]["smallest_side"] == {"value": pytest.approx(np.sqrt(4.8 * 3.6)), "unit": "m"}
        assert "elements" not in document["plate"]
        assert document["files"] == ["summary.json"]

    def test_table_fits_80_columns(self) -> None:
        """No line is wider than 80 columns; load, settlement, uplift, share, steps and verdict of each are there."""
        console = Console(file=io.StringIO(), width=80)
        terminal.print_summary(synthetic.combined(), console)
        text = console.file.getvalue()  # type: ignore[attr-defined]
        lines = text.splitlines()
        assert max(map(len, lines)) <= 80
        place = next(n for n, line in enumerate(lines) if line.startswith("  2 NUL (ultimate): 2 dead"))
        assert lines[place + 1].split() == ["10000", "56.000", "0", "100.00", "3", "ok"]
        assert "not solved: the result does not satisfy the equations" in text
        assert "    FOUNDATION FAILS: the loads pull the plate off" in lines
        assert lines[0].startswith('FOUNDATION FAILS (1 of 3 checks fails): static equilibrium: none in "wind')
        assert "FOUNDATION FAILS: no equilibrium in 1 of 4 combinations, number 4." in lines
        assert "FAILED: no certified result in 1 of 4 combinations, number 3." in lines
        assert text.count("unknowns") == text.count("elements on the plate") == 1

    def test_constants_of_the_ground_that_differ_are_left_out(self) -> None:
        """A row of the ground that is not the same in all is left out, and a note says so."""
        combined = synthetic.combined()
        assert [row.key for row in combinations.description(combined)[2].rows] == ["kind", "k0", "k1"]
        other = replace(combined["NUL"], constants=replace(combined["NUL"].constants, k0=(1e6,)))
        changed = replace(combined, results=combined.results | {"NUL": other})
        ground = combinations.description(changed)[2]
        assert [row.key for row in ground.rows] == ["kind", "k1"]
        assert "depend on the combination" in ground.notes[-1]

    def test_numbers_that_are_none_are_refused(self) -> None:
        """NaN in one of the combinations is never shown or written."""
        combined = synthetic.combined()
        plate = combined["NUL"].plate
        bad = replace(combined["NUL"], plate=replace(plate, gap=np.full_like(plate.gap, np.nan)))
        for show in (
            json_text,
            lambda each: terminal.print_summary(each, Console(file=io.StringIO())),
        ):
            with pytest.raises(GroundslabError, match="not finite"):
                show(replace(combined, results=combined.results | {"NUL": bad}))

    def test_progress_names_the_combination(self, monkeypatch: pytest.MonkeyPatch) -> None:
        """With several combinations the line says which one it is; with one it does not."""
        combination = synthetic.combined().combinations[0].replace(name="[bold]one")
        texts = list[str]()
        monkeypatch.setattr(Status, "update", lambda _, words: texts.append(words.plain))
        for count in (1, 3):
            console = Console(file=io.StringIO(), width=100, force_terminal=True)
            with progress.on_terminal(progress.CombinationCount(count), console) as shown:
                shown.begin(combination)
                shown(synthetic.results().steps[1])
            text = texts[-1]
            assert text.startswith("1 of 3, [bold]one: 1234 unknowns") is (count == 3)
            assert "1234 unknowns" in text


class TestVtu:
    """Files for ParaView, read back by meshio."""

    def test_plate_reads_back(self, tmp_path: Path) -> None:
        """Every field comes back in its unit of display, on quadratic cells in three dimensions."""
        results = synthetic.results(3)
        vtk.write_plate(results, tmp_path / "plate.vtu")
        mesh = meshio.read(tmp_path / "plate.vtu")
        assert mesh.points.shape[1] == 3
        assert not mesh.points[:, 2].any()
        assert [block.type for block in mesh.cells] == ["quad9"]
        assert np.array_equal(mesh.cells[0].data, results.plate.elements)
        for name, field in PLATE_FIELDS.items():
            array = mesh.point_data[PLATE_FIELDS[name].name]
            assert np.allclose(array, getattr(results.plate, name) * field.scale, rtol=1e-15, atol=0)
        assert np.array_equal(mesh.point_data["in contact"], results.plate.in_contact)
        assert "settlement w [mm]" in mesh.point_data

    def test_nodes_stand_in_the_order_of_vtk(self) -> None:
        """Corners run counter-clockwise; midsides 12, 23, 34, 41 and the centre lie between."""
        mesh = vtk.plate_mesh(synthetic.results())
        nodes = mesh.nodes[mesh.elements]
        corners = nodes[:, :4]
        following = np.roll(corners, -1, axis=1)
        assert np.allclose(nodes[:, 4:8], (corners + following) / 2)
        assert np.allclose(nodes[:, 8], corners.mean(axis=1))
        twice_area = (corners[..., 0] * following[..., 1] - corners[..., 1] * following[..., 0]).sum(axis=1)
        assert (twice_area > 0).all()

    def test_large_arrays_come_back_block_by_block(self, tmp_path: Path) -> None:
        """One array fills its blocks exactly, the other does not."""
        per_block = vtk.BLOCK // 8
        for n in (2 * per_block, 2 * per_block + 1):
            nodes, data = np.arange(2.0 * n).reshape(n, 2), {"a < b": np.arange(n) ** 2 / 7}
            vtk.Grid(nodes, np.arange(9)[None], data, {}).write(tmp_path / "large.vtu")
            mesh = meshio.read(tmp_path / "large.vtu")
            assert np.array_equal(mesh.point_data["a < b"], data["a < b"])
            assert np.array_equal(mesh.points[:, :2], nodes)

    def test_ground_holds_each_surface_and_the_plate_above(self, tmp_path: Path) -> None:
        """Surfaces are numbered from the top; the plate stands at its own places, zero beyond."""
        results = synthetic.results(shear=True)
        vtk.write_ground(results, tmp_path / "ground.vtu")
        mesh = meshio.read(tmp_path / "ground.vtu")
        data = mesh.point_data
        assert np.allclose(data["settlement w_1 [mm]"], 1e3 * results.ground.settlement[1])
        under = data["under the plate"] == 1
        inside = (np.abs(mesh.points[:, 0]) < 4.801) & (np.abs(mesh.points[:, 1]) < 3.601)
        assert np.array_equal(under, inside)
        x, y = mesh.points[under, :2].T
        expected = 28 * (1 - 2 * (x**2 + y**2) / 36)
        assert np.allclose(data["settlement of the plate [mm]"][under], expected)
        assert not data["settlement of the plate [mm]"][~under].any()
        assert all(np.isfinite(array).all() for array in data.values())

    def test_places_match_in_spite_of_rounding(self) -> None:
        """Coordinates that differ in the last digits are one place; a place that is missing is an error."""
        among, _ = synthetic.grid(7, 5, 9.6, 7.2)
        order = np.random.default_rng(1).permutation(len(among))
        shaken = among[order] * (1 + 3e-16) + 1e-15
        assert np.array_equal(vtk.match(shaken, among), order)
        with pytest.raises(GroundslabError):
            vtk.match(among + 0.01, among)


class TestArchive:
    """The archive of all numbers."""

    @pytest.mark.parametrize("shear", [False, True])
    def test_comes_back_bit_by_bit(self, tmp_path: Path, shear: bool) -> None:
        """What is read is what was written, from arrays to history; it cannot be changed."""
        results = synthetic.results(3, shear=shear)
        npz.write(results, tmp_path / "results.npz")
        read = npz.load(tmp_path / "results.npz")
        synthetic.assert_same(read, results)
        with pytest.raises(ValueError, match="read-only"):
            read.plate.settlement[0] = 1.0

    def test_another_mesh_is_not_shared(self, tmp_path: Path) -> None:
        """Results that are read beside others have the mesh of these only if it is theirs."""
        coarse, fine = synthetic.results(2), synthetic.results(3)
        for name, results in (("coarse", coarse), ("fine", fine)):
            npz.write(results, tmp_path / f"{name}.npz")
        read = npz.load(tmp_path / "fine.npz", coarse)
        synthetic.assert_same(read, fine)
        assert npz.load(tmp_path / "fine.npz", read).plate.nodes is read.plate.nodes

    def test_needs_no_pickle(self, tmp_path: Path) -> None:
        """Plain NumPy reads every array with pickles forbidden."""
        npz.write(synthetic.results(), tmp_path / "results.npz")
        with np.load(tmp_path / "results.npz", allow_pickle=False) as stored:
            assert stored["plate.settlement"].dtype == np.float64
            assert json.loads(str(stored["about"]))["solver"] == "superlu"

    @pytest.mark.parametrize("content", [None, b"", b"no archive", b"PK\x03\x04 torn"])
    def test_refuses_what_is_no_archive(self, tmp_path: Path, content: bytes | None) -> None:
        """A missing, empty, foreign or torn file gives a issue that names the file."""
        path = tmp_path / "results.npz"
        if content is not None:
            path.write_bytes(content)
        with pytest.raises(InputError, match=r"results\.npz"):
            npz.load(path)

    def test_refuses_other_arrays_and_layouts(self, tmp_path: Path) -> None:
        """An archive of something else, a single array and a layout of the future are refused."""
        path = tmp_path / "other.npz"
        np.savez(path, a=np.zeros(3))
        with pytest.raises(InputError, match="about"):
            npz.load(path)
        np.savez(path, about=np.array('{"format": 99}'))
        with pytest.raises(InputError, match="layout 99"):
            npz.load(path)
        with path.open("wb") as file:
            np.save(file, np.zeros(3))
        with pytest.raises(InputError):
            npz.load(path)


@pytest.mark.slow
def test_heavy_libraries_wait_until_they_are_called() -> None:
    """Importing every view loads neither matplotlib nor rich, and drawing never loads pyplot."""
    code = f"""
import sys
sys.path.insert(0, {str(ROOT / "tests")!r})
from groundslab.views.files import manifest, npz, results_folder, vtk
from groundslab.views.summary import combinations, progress, sections, terminal
assert not {{"matplotlib", "rich", "scipy", "pint", "pydantic"}} & set(sys.modules)
from groundslab.views import plots
assert "matplotlib" not in sys.modules
from helpers import synthetic
plots.plot(synthetic.results())
assert "matplotlib.figure" in sys.modules
assert "matplotlib.pyplot" not in sys.modules
"""
    subprocess.run([sys.executable, "-c", code], check=True)


class TestSupports:
    """What the supports carry, in the summary."""

    @staticmethod
    def support(name: str, *forces: float) -> SupportResult:
        """Return a support whose nodes stand along x and carry so much."""
        k = len(forces)
        nodes = np.column_stack([np.arange(k, dtype=float), np.zeros(k)])
        none = np.zeros(k)
        return SupportResult(name, nodes, none, none, np.array(forces), none, none)

    def test_each_of_a_few(self) -> None:
        """Each support's force stands with its middle, and their sum."""
        results = synthetic.results(supports=(self.support("pile", 5e4), self.support("wall", 1e4, 2e4, -4e3)))
        section = next(each for each in sections.summary(results) if each.key == "supports")
        found = {row.label: (row.value, row.place) for row in section.rows}
        assert found == {
            "force of pile": (5e4, (0.0, 0.0)),
            "force of wall": (2.6e4, (1.0, 0.0)),
            "all supports together": (7.6e4, None),
        }

    def test_of_many_the_extremes(self) -> None:
        """Of more than a dozen only the largest and the smallest force and their sum are shown."""
        piles = tuple(self.support(f"pile {n}", 1e3 * n) for n in range(-1, 19))
        section = next(each for each in sections.summary(synthetic.results(supports=piles)) if each.key == "supports")
        values = [row.value for row in section.rows]
        assert [row.label for row in section.rows[:2]] == ["largest force, of pile 18", "smallest force, of pile -1"]
        assert values == [18e3, -1e3, sum(range(-1, 19)) * 1e3]

    def test_none_without_supports(self) -> None:
        """A plate on the ground alone has no such section."""
        assert "supports" not in [section.key for section in sections.summary(synthetic.results())]
