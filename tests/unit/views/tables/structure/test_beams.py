"""The table, the figures and the files of beams."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.errors import InputError
from groundslab.results.records import BeamResult
from groundslab.views.files import npz
from groundslab.views.files.vtk import beam_lines
from groundslab.views.report.html import render_report
from groundslab.views.tables.result_tables import tables_of


@pytest.fixture(scope="module")
def results() -> gs.Results:
    """Return the results of a raft with two ribs in two cases."""
    rib = {"kind": "rib", "width": 0.3, "height": 0.4, "effective_width": 1.0}

    def load(x: float, case: str) -> dict[str, Any]:
        return {"kind": "point", "x": x, "y": 0.5, "P": 300e3, "width_x": 0.4, "width_y": 0.4, "case": case}

    return gs.solve(
        gs.Model(
            plate={"length_x": 6.0, "length_y": 4.0, "thickness": 0.25, "E": 30e9, "nu": 0.2},
            ground={"kind": "winkler", "k": 20e6},
            beams=[
                {"name": "long", "points": [(-3.0, 0.5), (3.0, 0.5)], "section": rib},
                {"name": "short", "points": [(2.0, -2.0), (2.0, 2.0)], "section": rib},
            ],
            cases=[{"name": "G"}, {"name": "Q"}],
            loads=[load(-1.0, "G"), load(1.0, "Q")],
            mesh={"size": 0.4},
        )
    )


def table(results: gs.Results) -> Any:
    """Return the table of beams."""
    return next(table for table in tables_of(results) if table.name == "beams")


def test_a_row_for_each_beam_and_combination_with_its_extremes(results: gs.Results) -> None:
    """Extremes are those of the section forces; shear and torsion away from the ends; errors stand at the right."""
    found = table(results)
    assert list(zip(found["combination"], found["beam"], strict=True)) == [
        ("G", "long"), ("G", "short"), ("Q", "long"), ("Q", "short"),
    ]  # fmt: skip
    beam = results["G"].beams[0]
    # between the places, under the load, the moment is up to 2 % more
    assert beam.moment.max() / 1e3 < found["greatest moment"][0] < 1.02 * beam.moment.max() / 1e3
    assert found["least moment"][0] == pytest.approx(beam.moment.min() / 1e3, rel=1e-2)
    assert abs(found["from the start to it"][0] - beam.way[beam.moment.argmax()]) < 0.4
    inside = (beam.way >= 0.25) & (beam.way <= 5.75)
    assert abs(found["largest shear force"][0]) >= np.abs(beam.shear[inside]).max() / 1e3
    assert found["greatest settlement"][0] == pytest.approx(beam.settlement.max() * 1e3, rel=3e-3)
    assert all(error >= 0 for error in found["error of greatest moment"])


def test_section_forces_stand_twice_where_another_beam_crosses(results: gs.Results) -> None:
    """At 5 m along the long one, whose torsion the short one takes up in bending; its own ends stand once."""
    long, short = results["Q"].beams
    assert np.count_nonzero(np.isclose(long.way, 5.0)) == 2
    assert np.count_nonzero(np.isclose(short.way, 2.5)) == 2
    assert np.count_nonzero(long.way == 0.0) == 1
    jump = np.diff(long.torsion[np.isclose(long.way, 5.0)])[0]
    assert jump != pytest.approx(0.0, abs=1e-3 * np.abs(long.torsion).max())


def test_beams_are_kept_in_folders(results: gs.Results, tmp_path: Path) -> None:
    """Section forces come back as they were, those of the coarser mesh too."""
    gs.save_results(results, tmp_path / "out")
    loaded = gs.load_results(tmp_path / "out")
    assert (tmp_path / "out" / "beams.pvd").exists()
    for name in ("G", "Q"):
        one, other = results[name], loaded[name]
        assert one.coarser is not None
        assert other.coarser is not None
        for a, b in zip((*one.beams, *one.coarser.beams), (*other.beams, *other.coarser.beams), strict=True):
            assert a.name == b.name
            for field in ("nodes", "way", "settlement", "moment", "shear", "torsion"):
                assert np.array_equal(getattr(a, field), getattr(b, field))


def test_beams_are_lines_for_paraview(results: gs.Results) -> None:
    """A line between every two places that follow each other, none where forces jump, none from beam to beam."""
    grid = beam_lines(results["Q"])
    long, short = results["Q"].beams
    lengths = np.linalg.norm(np.diff(grid.nodes[grid.elements], axis=1)[:, 0], axis=1)
    assert lengths.min() > 0
    for number, beam in ((1, long), (2, short)):
        assert lengths[grid.cell_data["beam"] == number].sum() == pytest.approx(beam.way[-1])
    assert grid.point_data["moment M [kNm]"].max() == pytest.approx(
        max(beam.moment.max() for beam in (long, short)) / 1e3
    )


def test_beams_have_figures(results: gs.Results) -> None:
    """Moments, shear and, where it is more than little, torsion of each beam; without beams nothing is drawn."""
    figure = gs.plot(results, kind="beams")
    assert [axes.get_ylabel() for axes in figure.axes] == [*("M [kNm]", "V [kN]"), *("M [kNm]", "V [kN]", "T [kNm]")]
    assert len(gs.plot(results, kind="beams", combination="G").axes[0].lines) == 2
    bare = results.model.model_copy(update={"beams": ()})
    with pytest.raises(InputError, match="without beams"):
        gs.plot(gs.solve(bare), kind="beams")


def test_eccentric_beams_show_their_axial_forces(tmp_path: Path) -> None:
    """In the table with errors, in a diagram of their own, in reports, VTU files and archives; n_x in plan."""
    rib = {"kind": "rib", "width": 0.3, "height": 0.4, "eccentric": True}
    eccentric = gs.solve(
        gs.Model(
            plate={"length_x": 6.0, "length_y": 4.0, "thickness": 0.25, "E": 30e9, "nu": 0.2},
            ground={"kind": "winkler", "k": 2e7},
            beams=[{"name": "rib", "points": [(-3.0, 0.0), (3.0, 0.0)], "section": rib}],
            loads=[{"kind": "point", "x": 0.0, "y": 0.0, "P": 2e5, "width_x": 0.4, "width_y": 0.4}],
            mesh={"size": 0.5},
        )
    )
    (beam,) = eccentric.only.beams
    found = table(eccentric)
    whole = beam.between_ends(0.0)
    assert found["greatest axial force"] == (pytest.approx(whole.axial.max() / 1e3),)
    assert found["least axial force"] == (pytest.approx(whole.axial.min() / 1e3),)
    assert whole.axial.max() == pytest.approx(beam.axial.max(), rel=2e-2)
    assert all(error is not None and error > 0 for error in found["error of greatest axial force"])
    assert [axes.get_ylabel() for axes in gs.plot(eccentric, kind="beams").axes] == ["M [kNm]", "V [kN]", "N [kN]"]
    assert gs.plot(eccentric, "n_x").axes
    assert "Along rib: bending moment M, shear force V, axial force N." in render_report(eccentric)
    assert np.array_equal(beam_lines(eccentric.only).point_data["axial force N [kN]"], beam.axial * 1e-3)
    npz.write(eccentric.only, tmp_path / "results.npz")
    again = npz.load(tmp_path / "results.npz")
    assert np.array_equal(again.beams[0].axial, beam.axial)
    assert again.elements.membrane_x is not None
    assert np.array_equal(again.elements.membrane_x, eccentric.only.elements.membrane_x)


def test_parts_between_ends_begin_where_they_should() -> None:
    """At the distance itself; a quarter of the length at most; a ring is whole. Each step is divided."""
    way = np.linspace(0.0, 1.0, 9)
    beam = BeamResult("short", np.column_stack([way, 0 * way]), way, way, way, 10 * way, *(0 * way,) * 4)
    part = beam.between_ends(0.2)
    assert part.way == pytest.approx([0.2, *np.arange(7, 26) / 32, 0.8])
    assert part.shear == pytest.approx(10 * part.way)
    assert part.nodes == pytest.approx(np.column_stack([part.way, 0 * part.way]))
    assert beam.between_ends(2.0).way == pytest.approx(np.arange(8, 25) / 32)
    ring = replace(beam, nodes=np.column_stack([np.sin(2 * np.pi * way), np.cos(2 * np.pi * way)]))
    assert not ring.closed  # but for rounding
    ring.nodes[-1] = ring.nodes[0]
    assert ring.closed
    assert ring.between_ends(0.2).way == pytest.approx(np.arange(33) / 32)


@pytest.mark.parametrize("places", [[0.0, 1.3, 2.9, 4.0], [0.0, 2.0, 2.5, 4.0], [0.0, 0.5, 3.5, 4.0]])
def test_largest_values_do_not_depend_on_places(places: list[float]) -> None:
    """A span of 8 m under 10 kN/m with 20 kN in its middle: by hand 120 kNm there, V = 40 kN at 1 m.

    M = 50 x - 5 x^2 up to the middle, where V jumps from 10 to -10 kN.
    """
    way = np.array([*places, *(8.0 - np.array(places))[::-1]])
    rest = np.minimum(way, 8.0 - way)
    sign = np.repeat([1.0, -1.0], len(places))
    M, V = 50 * rest - 5 * rest**2, sign * (50 - 10 * rest)
    beam = BeamResult("span", np.column_stack([way, 0 * way]), way, 0 * way, M, V, *(0 * way,) * 4)
    assert beam.between_ends(0.0).moment.max() == pytest.approx(120.0)
    assert beam.between_ends(1.0).shear[[0, -1]] == pytest.approx([40.0, -40.0])
    at = beam.at(np.array([0.7, 4.0, 4.0, 6.1]))
    assert at.moment == pytest.approx([50 * 0.7 - 5 * 0.49, 120.0, 120.0, 50 * 1.9 - 5 * 1.9**2])
    assert at.shear == pytest.approx([43.0, 10.0, -10.0, -31.0])


def test_a_crest_between_places_is_found() -> None:
    """M = x (4 - x) has its largest value, 4, between places at 1.4 and 2.6."""
    way = np.array([0.0, 1.4, 2.6, 4.0])
    beam = BeamResult(
        "crest", np.column_stack([way, 0 * way]), way, 0 * way, way * (4 - way), 4 - 2 * way, *(0 * way,) * 4
    )
    assert beam.between_ends(0.0).moment.max() == pytest.approx(4.0)


def test_reports_draw_beams(results: gs.Results) -> None:
    """Their diagrams, their table and what is assumed of them."""
    page = render_report(results)
    assert "The moment is positive, downwards, where the beam sags." in page
    assert "Beams and ribs bend, shear and twist with the plate" in page
    assert "largest torsional moment" in page
