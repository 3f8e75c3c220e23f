"""Discretization errors as they are shown: beside figures, in the verdict, in JSON, archive, report and workbench."""

from __future__ import annotations

import io
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from rich.console import Console

from groundslab import Model, solve
from groundslab.errors import InputError
from groundslab.results.records import MeshHistory
from groundslab.results.results import CombinationResult, Comparison, results_of
from groundslab.views.files import npz
from groundslab.views.files.vtk import plate_mesh
from groundslab.views.report.html import render_report
from groundslab.views.summary import sections, terminal
from groundslab.views.summary.discretization import coarse_words
from groundslab.views.summary.json_summary import json_text
from groundslab.views.summary.rows import Row
from groundslab.workbench.solver.summary import build_summary
from helpers import synthetic
from helpers.pages import page


def compared(share: float, **parts: Any) -> CombinationResult:
    """Return made-up results whose moments m_x are so much smaller on elements twice as large, their error halved."""
    uniform = synthetic.model().replace(loads=[{"kind": "uniform", "q": 1e4}])
    found = synthetic.in_contact(synthetic.results(4, **{"model": uniform} | parts))
    plate = replace(found.plate, moment_x=(1 - share) * found.plate.moment_x)
    return synthetic.compared(found, plate)


def shown_on_terminal(results: CombinationResult) -> str:
    """Return what the terminal shows."""
    console = Console(file=io.StringIO(), width=80)
    terminal.print_summary(results_of(results), console)
    return console.file.getvalue()  # type: ignore[attr-defined]


def row_of(results: CombinationResult, section: str, key: str) -> Row:
    """Return a row of the summary."""
    own = next(each for each in sections.summary(results) if each.key == section)
    return next(row for row in own.rows if row.key == key)


def test_figures_have_their_errors() -> None:
    """A change of 4 % whose error is halved leaves 4 %; what did not change has none; without a coarser mesh none."""
    results = compared(0.04)
    row = row_of(results, "section_forces", "largest_moment_x")
    assert row.error == pytest.approx(0.04 * 1e5)
    assert row_of(results, "section_forces", "largest_moment_y").error == 0.0
    assert row_of(synthetic.results(4), "section_forces", "largest_moment_x").error is None
    assert row_of(results, "discretization", "energy").value == 0.02
    largest = row_of(results, "discretization", "largest_error")
    assert (largest.value, largest.label) == (pytest.approx(0.04), "largest error, moment m_x")
    assert largest.place == row.place


def test_an_error_that_is_not_known_is_said_to_be_so() -> None:
    """Without a coarser mesh terminal, certificate, report and workbench say that no error is known; with one not."""
    model = synthetic.model().replace(loads=[{"kind": "uniform", "q": 1e4}])
    results = synthetic.results(4, model=model)
    words = "The discretization error is not known"
    verdict = page(render_report(results)).one("p", class_="verdict doubtful").text
    notes = next(each for each in sections.summary(results) if each.key == "certificate").notes
    shown = shown_on_terminal(results)
    assert words in verdict
    assert any(words in note for note in notes)
    assert shown.count(words) == 2
    assert words in build_summary(results_of(results))["coarse"]
    assert words not in shown_on_terminal(compared(0.04))


def test_a_slab_that_bends_within_a_cell_of_the_coarser_mesh() -> None:
    """On an elastic continuum the coarser mesh of a very thin slab has no solution, and that is told as the reason."""
    results = solve(
        Model(
            plate={"length_x": 8, "length_y": 6, "thickness": 0.010, "E": 30e9, "nu": 0.2},
            ground={"kind": "continuum", "half_space": {"E": 50e6, "nu": 0.3}},
            loads=[
                {"kind": "uniform", "q": 1e3},
                {"kind": "patch", "q": 2e5, "x": (-0.5, 0.5), "y": (-0.5, 0.5)},
            ],
            mesh={"size": 0.25},
        )
    )
    assert results.only.coarser is None
    assert "the slab may bend within one of these" in coarse_words(results)


def test_terminal() -> None:
    """Each in percent of its figure, within 80 columns and in plain ASCII; the verdict on the mesh comes last."""
    fine, coarse = shown_on_terminal(compared(0.04)), shown_on_terminal(compared(0.2))
    assert max(map(len, coarse.splitlines())) <= 80
    assert coarse.isascii()
    assert "kNm/m +-4.0 %" in next(line for line in fine.splitlines() if "largest moment m_x" in line)
    assert "kNm/m +-20 %" in next(line for line in coarse.splitlines() if "largest moment m_x" in line)
    assert "too coarse" not in fine
    assert "The mesh is too coarse: the largest discretization error is 20 % (moment m_x)" in coarse.replace("\n", " ")


@pytest.mark.parametrize(
    ("error", "value", "text"),
    [(0.0, 1.0, ""), (4e-4, 1.0, "±<0.1 %"), (0.0123, -1.0, "±1.2 %"), (0.3, 1.0, "±30 %"), (1.0, 0.0, "±>99 %")],
)
def test_text_of_an_error(error: float, value: float, text: str) -> None:
    """Two digits at most, and none for what is exact."""
    assert terminal.error_text(error, value) == text


def test_accuracy_decides() -> None:
    """The same error is fine for one accuracy, and too large for another."""
    model = compared(0.2).model
    wide = model.replace(mesh=model.mesh.replace(accuracy=0.25))
    assert coarse_words(results_of(compared(0.2))) != ""
    assert coarse_words(results_of(compared(0.2, model=wide))) == ""


@pytest.mark.parametrize(
    ("history", "words"),
    [
        (None, "It was made for another case"),
        (MeshHistory((100, 900), "no progress"), "It was refined until this error fell no more."),
        (
            MeshHistory((100, 900), "max_unknowns", 123_456),
            "because of mesh.max_unknowns = 5000; the next mesh takes mesh.max_unknowns = 130000.",
        ),
        (MeshHistory((1, 2, 3, 4, 5), "most meshes"), "5 meshes were made, and no more are."),
    ],
)
def test_why_the_accuracy_is_missed(history: MeshHistory | None, words: str) -> None:
    """The verdict on a mesh that is too coarse says why it is no finer, and what it would take."""
    results = compared(0.2)
    model = results.model.replace(mesh={"max_unknowns": 5000})
    results = replace(results, model=model, mesh_history=history)
    assert words in coarse_words(results_of(results))
    section = next(each for each in sections.summary(results) if each.key == "discretization")
    assert words.lower() in section.notes[-1].lower()
    document = json.loads(json_text(results_of(results)))
    assert document["provisional"] is False
    assert document["mesh_history"] == (
        None if history is None else {"unknowns": [*history.unknowns], "end": history.end, "needed": history.needed}
    )


def test_provisional_results_say_so() -> None:
    """On the terminal, in JSON, report and workbench: which mesh, how far it is off, and what is asked for."""
    results = results_of(replace(compared(0.2), mesh_history=MeshHistory((100, 1234))))
    words = (
        "Provisional: mesh 2 (1,234 unknowns) is still to be refined: largest error 20 % (moment m_x), 5 % asked for."
    )
    assert words in " ".join(shown_on_terminal(results.only).split())
    assert page(render_report(results)).one("p", class_="verdict doubtful").text.endswith(words)
    assert build_summary(results)["coarse"] == words
    assert json.loads(json_text(results))["provisional"] is True
    assert repr(results).startswith("Provisional results of ")
    assert coarse_words(replace(results, results={})) == ""


def test_singular_moments_are_called_so() -> None:
    """At a force without a footprint a moment is a mean: the note, its place, JSON and workbench say so."""
    model = synthetic.model().replace(loads=[{"kind": "point", "P": 1e5, "x": 0.0, "y": 0.0}])
    results = synthetic.results(model=model)
    document = json.loads(json_text(results_of(results)))["section_forces"]
    assert "singular (*) at forces without a footprint (1): within a thickness" in document["notes"][0]
    assert [key for key, each in document.items() if "singular" in each] == ["largest_moment_x", "largest_moment_y"]
    row = row_of(results, "section_forces", "largest_moment_x")
    assert terminal.shown_row(row, "SI").place == "(0.000, 0.000)*"
    parts = {each["key"]: each for each in build_summary(results_of(results))["combinations"][0]["sections"]}
    notes = {each["key"]: each["note"] for each in parts["section_forces"]["rows"]}
    assert notes["largest_moment_x"] == "at (0.000, 0.000) m, singular"
    assert not notes["largest_shear_x"].endswith("singular")


def test_a_line_of_the_certificate() -> None:
    """The largest error beside what was asked for: too large it refuses nothing."""
    for share, ok in ((0.04, True), (0.2, None)):
        results = compared(share)
        row = row_of(results, "certificate", "discretization_error")
        assert (row.value, row.tolerance, row.ok) == (pytest.approx(share), 0.05, ok)
        line = next(each for each in shown_on_terminal(results).splitlines() if "largest discretization error" in each)
        verdict = "ok" if ok else "too coarse"
        assert " ".join(line.split()[3:]) == f"{100 * share:g} % {verdict} (limit 5 %)"
        document = json.loads(json_text(results_of(results)))
        assert document["certified"]
        assert document["certificate"]["discretization_error"]["ok"] is bool(ok)
    keys = [row.key for row in sections.certificate_section(synthetic.results()).rows]
    assert "discretization_error" not in keys


def test_json_has_errors_in_si_units() -> None:
    """Beside value and unit."""
    document = json.loads(json_text(results_of(compared(0.04))))
    assert document["section_forces"]["largest_moment_x"]["error"] == pytest.approx(4e3)
    assert document["discretization"]["energy"] == 0.02


def test_archive_keeps_the_coarser_mesh(tmp_path: Path) -> None:
    """Its arrays and both figures come back, and so does the error of each element."""
    results = replace(
        compared(0.04), mesh_history=MeshHistory((100, 900), "max_unknowns", 5000, (("moment m_x", 0.2),))
    )
    npz.write(results, tmp_path / "results.npz")
    loaded = npz.load(tmp_path / "results.npz")
    assert loaded.mesh_history == results.mesh_history
    found = loaded.comparison
    assert found is not None
    assert results.comparison is not None
    assert loaded.elements.discretization_error is not None
    np.testing.assert_array_equal(loaded.elements.discretization_error, results.elements.discretization_error)
    assert found.elements.discretization_error is None
    np.testing.assert_array_equal(found.plate.moment_x, results.comparison.plate.moment_x)
    assert (found.energy_error, found.reduction) == (0.02, 0.5)


def test_archive_with_a_part_of_an_error_is_refused(tmp_path: Path) -> None:
    """A comparison without errors of elements, or such errors without a comparison, or below zero."""
    results, plain = compared(0.04), synthetic.results(4)
    errors = results.elements.discretization_error
    assert errors is not None
    damaged = [
        replace(results, elements=plain.elements),
        replace(plain, elements=results.elements),
        replace(results, elements=replace(results.elements, discretization_error=-errors)),
        replace(results, elements=replace(results.elements, discretization_error=errors[1:])),
    ]
    for number, each in enumerate(damaged):
        npz.write(each, tmp_path / f"{number}.npz")
        with pytest.raises(InputError, match="discretization_error"):
            npz.load(tmp_path / f"{number}.npz")


def test_vtu_file_has_the_error_of_each_element() -> None:
    """In percent, where there is a comparison, and no such array where there is none."""
    name = "discretization error rho_e [%] (centre, mean over the element)"
    results = compared(0.04)
    errors = results.elements.discretization_error
    assert errors is not None
    np.testing.assert_allclose(plate_mesh(results).cell_data[name], 100 * errors)
    assert name not in plate_mesh(synthetic.results(4)).cell_data


@pytest.mark.slow
def test_report_and_workbench_do_not_call_a_coarse_mesh_good() -> None:
    """The verdict of the report is doubtful, and the workbench has the words."""
    good, coarse = results_of(compared(0.04)), results_of(compared(0.2))
    for combined, status in ((good, "good"), (coarse, "doubtful")):
        verdict = page(render_report(combined)).one("p", class_=f"verdict {status}").text
        assert ("too coarse" in verdict) == (combined is coarse)
        assert bool(build_summary(combined)["coarse"]) == (combined is coarse)


@pytest.mark.slow
def test_extremes_over_combinations_have_the_governing_ones_error() -> None:
    """Of two combinations each extreme has the error of the one that governs: in JSON, terminal and report."""
    combined = synthetic.combined()
    (first, a), (second, b) = combined.results.items()
    shares = {first: 0.04, second: 0.2}
    changed = {}
    for name, each in ((first, a), (second, b)):
        scale = 2.0 if name == first else 1.0
        plate = replace(each.plate, moment_x=scale * each.plate.moment_x)
        before = replace(plate, moment_x=(1 - shares[name]) * plate.moment_x, settlement=0.9 * plate.settlement)
        before = replace(before, contact_area=0.5 * plate.contact_area)
        other = Comparison(
            before, each.elements, each.ground, each.supports, each.constants, energy_error=0.02, reduction=0.5
        )
        changed[name] = replace(each, plate=plate, comparison=other)
    combined = replace(combined, results=changed)
    found = json.loads(json_text(combined))["extremes"]
    moment, settlement, share = (
        found[section][key]
        for section, key in (
            ("section_forces", "largest_moment_x"),
            ("settlement", "largest"),
            ("contact", "share"),
        )
    )
    assert (moment["combination"], moment["error"]) == (first, pytest.approx(0.04 * moment["value"]))
    assert (settlement["combination"], settlement["error"]) == (second, pytest.approx(0.1 * settlement["value"]))
    assert share["error"] == pytest.approx(share["value"] / 2)
    console = Console(file=io.StringIO(), width=80)
    terminal.print_summary(combined, console)
    shown = console.file.getvalue()  # type: ignore[attr-defined]
    assert "kNm/m +-4.0 %" in next(line for line in shown.splitlines() if "largest moment m_x" in line)
    rows = [row.text for row in page(render_report(combined)).one("section", id="extremes").all("tr")]
    assert "±4.0 %" in next(text for text in rows if text.startswith("largest momentmx"))
    without = replace(combined, results={name: replace(each, comparison=None) for name, each in changed.items()})
    assert "error" not in json.loads(json_text(without))["extremes"]["section_forces"]["largest_moment_x"]
