"""Figures: they hold what they must, say what they show, and come out the same each time."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from dataclasses import fields, replace
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import matplotlib as mpl
import numpy as np
import pytest

import groundslab
from groundslab.cli import main
from groundslab.discretize.ground import ground_under
from groundslab.errors import InputError, NotConverged
from groundslab.fem import vlasov
from groundslab.fem.mesh import Mesh
from groundslab.fem.vlasov import Soil
from groundslab.model.ground import InterfaceLayer, Layered, SoilLayer, Vlasov
from groundslab.model.loads.lines import LineLoad
from groundslab.model.loads.load_cases import Combination
from groundslab.model.loads.load_types import PointLoad
from groundslab.model.outputs import Output, OutputLine
from groundslab.model.plate import Edges, Plate, Zone
from groundslab.model.settings import Contact
from groundslab.model.shapes import Polygon, Rectangle
from groundslab.model.structure.columns import Column
from groundslab.model.supports import LineSupport, PointSupport
from groundslab.model.varying_ground import Borehole, Void
from groundslab.results.contact_zone import contact_function
from groundslab.results.fields import BAR_FIELDS, MEMBRANE
from groundslab.results.results import CombinationResult, Results, results_of
from groundslab.units import format_drawn
from groundslab.views import plots
from groundslab.views.files import results_folder
from groundslab.views.plots import contours, convergence, deformed, plan, request, sections
from groundslab.views.plots.annotations import LabelPlacement
from groundslab.views.plots.ground import soil
from groundslab.views.plots.panels import build_panels
from groundslab.views.plots.request import parse_request
from groundslab.views.plots.style import apply_style, math_symbol, plain_text
from groundslab.views.tables.quantities import mean_at_nodes, nodal_values
from helpers import synthetic
from helpers.paths import ROOT

#: All but the fields of bars, which belong to no single combination.
OF_COMBINATIONS = {name: each for name, each in request.QUANTITIES.items() if name not in BAR_FIELDS}


def words(figure: Any) -> str:
    """Return all that is written in a figure, a line each."""
    from matplotlib.text import Text

    return "\n".join(text.get_text() for text in figure.findobj(Text) if text.get_text())


def panels(figure: Any) -> list[Any]:
    """Return the axes of a figure that lie in no other axes."""
    return [axes for axes in figure.axes if axes.axison]


def entries(figure: Any) -> set[str]:
    """Return the words of a figure's legend."""
    return {text.get_text() for legend in figure.legends for text in legend.get_texts()}


def found_by_location(error: pytest.ExceptionInfo[InputError]) -> dict[str, str]:
    """Return what was found by location."""
    return {issue.location: issue.found for issue in error.value.issues}


def layered(ground: Any, gamma: float | None, **changes: Any) -> CombinationResult:
    """Return made-up results on soil, of which only gamma counts."""
    model = synthetic.model(shear=True).replace(ground=ground, **changes)
    found = synthetic.results(2, shear=True, model=model)
    mesh = Mesh(found.plate.nodes, found.plate.elements)
    soil, _ = ground_under(found.model, mesh, np.arange(len(mesh.elements)), {})
    decay = gamma / soil.gamma_of(1.0) if gamma is not None and isinstance(soil, Soil) else None
    return replace(found, constants=replace(found.constants, gamma=gamma, decay=decay))


class TestRequest:
    """What can be asked for, and what is said about what cannot."""

    def test_all_errors_come_at_once(self) -> None:
        """Unknown names of fields and combinations come together, with the known ones and what may be meant."""
        with pytest.raises(InputError) as error:
            groundslab.plot(synthetic.combined(), "settlemnt", "m_z", combination="NULL")
        assert found_by_location(error) == {"combination": '"NULL"', "FIELD": '"m_z"'}
        reported = str(error.value)
        assert '"settlemnt", expected' in reported
        assert 'did you mean "settlement"?' in reported
        assert 'did you mean "NUL"?' in reported
        assert all(name in reported for name in request.QUANTITIES)

    @pytest.mark.parametrize(
        ("wrong", "where"),
        [
            ({"kind": "plann"}, "kind"),
            ({"kind": "lines"}, "line"),
            ({"kind": "soil", "fields": ("w",)}, "FIELD"),
            ({"kind": "plan", "line": (0, 0, 1, 1)}, "line"),
            ({"line": (0, 0, 0, 0)}, "line"),
            ({"line": (0, 0, 1)}, "line"),
            ({"line": ((0, 0), (1,))}, "line"),
            ({"line": (0, 0, np.inf, 1)}, "line"),
            ({"line": (20, 20, 30, 30)}, "line"),
            ({"envelope": "ultimat"}, "envelope"),
            ({"envelope": "frequent"}, "envelope"),
            ({"envelope": "ultimate", "kind": "soil"}, "envelope"),
            ({"envelope": "ultimate", "combination": "NUL"}, "envelope"),
            ({"combination": "wind alone"}, "combination"),
            ({"fields": ("discretization_error",)}, "FIELD"),
            ({"fields": ("rho_e",), "line": (0, 0, 1, 1)}, "FIELD"),
            ({"fields": ("w",), "kind": "mesh"}, "FIELD"),
            ({"mesh": True, "line": (0, 0, 1, 1)}, "mesh"),
            ({"mesh": True, "kind": "soil"}, "mesh"),
        ],
    )
    def test_what_does_not_go_together_is_refused(self, wrong: dict[str, Any], where: str) -> None:
        """Each misfit is reported where it stands."""
        fields = wrong.pop("fields", ())
        with pytest.raises(InputError) as error:
            groundslab.plot(synthetic.combined(), *fields, **wrong)
        assert list(found_by_location(error)) == [where]

    def test_symbols_are_names_too_and_each_is_drawn_once(self) -> None:
        """W is the settlement; a field that is named twice has one panel."""
        chosen = request.resolve(("w", "settlement", "m_xy", "bottom_x"))
        assert [quantity.name for quantity in chosen] == ["settlement", "moment_xy", "bottom_x"]

    @pytest.mark.slow
    def test_certified_combinations_are_drawn_unless_others_are_named(self) -> None:
        """Without a name those with a certified result; one without is drawn when it is named, and called so."""
        combined = synthetic.combined()
        names = [each.name for each in parse_request(combined, (), None, None, None, None).combinations]
        assert names == list(combined.results)
        figure = groundslab.plot(combined, "w", combination="uncertified")
        assert "NOT CERTIFIED" in words(figure)
        assert "NOT CERTIFIED" not in words(groundslab.plot(combined, "w"))

    def test_why_a_combination_has_no_results_is_told(self) -> None:
        """The reason of the refusal stands in the issue."""
        with pytest.raises(InputError, match="the loads pull the plate off"):
            groundslab.plot(synthetic.combined(), combination="wind alone")

    def test_a_line_may_be_four_numbers_or_two_places(self) -> None:
        """One line or several, as four coordinates or as two places each."""
        combined = synthetic.combined()
        given = [(0, 0, 1, 2), ((0, 0), (1, 2)), [(0, 0, 1, 2)], [((0, 0), (1, 2))]]
        for line in given:
            (line,) = parse_request(combined, (), None, None, None, line).lines
            assert (line.start, line.end) == ((0.0, 0.0), (1.0, 2.0))
        assert len(parse_request(combined, (), None, None, None, [(0, 0, 1, 2), (0, 0, 2, 2)]).lines) == 2

    def test_numbers_that_are_none_are_refused(self) -> None:
        """NaN is never drawn."""
        results = synthetic.results()
        bad = replace(results, plate=replace(results.plate, gap=np.full_like(results.plate.gap, np.nan)))
        with pytest.raises(groundslab.GroundslabError, match="not finite"):
            groundslab.plot(bad)


class TestScale:
    """Colors of values."""

    @pytest.mark.parametrize("low", [-37.3, -0.02, 0.0, 12.1])
    @pytest.mark.parametrize("high", [13.7, 49.9])
    @pytest.mark.parametrize("signed", [False, True])
    def test_levels_are_round_and_cover_the_data(self, low: float, high: float, signed: bool) -> None:
        """First and last level enclose all values; steps are 1, 2, 2.5 or 5 times a power of ten."""
        found = contours.make_scale([np.linspace(low, high, 50)], signed=signed)
        assert found.levels[0] <= low
        assert found.levels[-1] >= high
        step = np.diff(found.levels)
        assert np.allclose(step, step[0])
        assert np.round(step[0] / 10 ** np.floor(np.log10(step[0])), 6) in (1, 2, 2.5, 5)
        assert 5 <= len(step) <= contours.BANDS + 2

    @pytest.mark.parametrize(("low", "signed", "parts"), [(-3, False, True), (0, False, False), (1, True, True)])
    def test_colors_part_at_zero_where_the_sign_matters(self, low: float, signed: bool, parts: bool) -> None:
        """White stands for zero if the quantity is signed or goes below zero, and only then."""
        found = contours.make_scale([np.linspace(low, 10, 20)], signed=signed)
        colors, norm = found.color_map()
        assert found.parts_at == (0.0 if parts else None)
        if parts:
            assert norm(0.0) == pytest.approx(0.5)
            assert min(colors(0.5)[:3]) > 0.9
            red, blue = colors(norm(10.0)), colors(norm(-10.0))
            assert red[0] > red[2]
            assert blue[2] > blue[0]
        else:
            assert colors.name == contours.ONE_SIGN

    def test_what_is_never_above_zero_runs_one_way_too(self) -> None:
        """Design moments at the top have one sign: one map, light where they are largest in size."""
        found = contours.make_scale([np.linspace(-80, 0, 9)], signed=False)
        assert found.parts_at is None
        colors, norm = found.color_map()
        assert sum(colors(norm(-80.0))[:3]) > sum(colors(norm(0.0))[:3])

    @pytest.mark.parametrize("value", [0.0, 3.0, -2.0])
    def test_a_constant_has_a_scale(self, value: float) -> None:
        """One value alone lies within levels that rise."""
        levels = contours.make_scale([np.full(4, value)], signed=False).levels
        assert (np.diff(levels) > 0).all()
        assert levels[0] <= value <= levels[-1]

    def test_bands_have_the_colors_of_the_map(self) -> None:
        """Values within one band have one color, values in two bands have two."""
        found = contours.ColorScale(np.array([0.0, 1.0, 2.0, 3.0]), parts_at=None)
        colors = found.colors_at(np.array([0.0, 0.9, 1.0, 3.0]))
        assert np.array_equal(colors[0], colors[1])
        assert not np.array_equal(colors[1], colors[2])
        assert not np.array_equal(colors[2], colors[3])


def with_all_fields() -> CombinationResult:
    """Return results that have every field: a comparison, and elements that cracked and were stretched."""
    results = synthetic.compared(synthetic.results(3))
    ratio = np.linspace(0.3, 1.0, len(results.plate.elements))
    stretched = dict.fromkeys(MEMBRANE, 100000.0 * ratio)
    return replace(results, elements=replace(results.elements, stiffness_ratio=ratio, **stretched))


class TestPlan:
    """Plans of amounts."""

    @pytest.mark.slow
    def test_each_amount_has_a_panel_with_units(self) -> None:
        """All that can be drawn is drawn: axes in meters, bars with symbol and unit, titles with the meaning."""
        figure = groundslab.plot(with_all_fields(), *OF_COMBINATIONS)
        boxes = panels(figure)
        assert len(boxes) == len(OF_COMBINATIONS)
        for axes, quantity in zip(boxes, OF_COMBINATIONS.values(), strict=True):
            assert (axes.get_xlabel(), axes.get_ylabel()) == ("x [m]", "y [m]")
            assert axes.get_aspect() == 1.0
            (bar,) = axes.child_axes
            assert bar.get_ylabel() == f"{quantity.symbol} [{quantity.field.unit.replace('kNm', 'kN m')}]"
            assert any(text.get_text().lower() == quantity.field.meaning.lower() for text in axes.texts)

    @pytest.mark.slow
    def test_bars_cover_the_values_that_are_drawn(self) -> None:
        """The color bar's range holds the quantity's values in its unit of display."""
        results = with_all_fields()
        figure = groundslab.plot(results, *OF_COMBINATIONS)
        for axes, name in zip(panels(figure), OF_COMBINATIONS, strict=True):
            low, high = axes.child_axes[0].get_ylim()
            values = nodal_values(results, name)
            assert low <= values.min() + 1e-9 * abs(values).max()
            assert high >= values.max() - 1e-9 * abs(values).max()

    def test_the_drawing_covers_the_plate(self) -> None:
        """The filled bands together have the plate's area: none of it is left white."""
        results = synthetic.results(3)
        axes = panels(groundslab.plot(results, "top_x"))[0]
        bands = axes.collections[0].get_paths()

        def area(path: Any) -> float:
            return sum(
                0.5 * (ring[:-1, 0] * ring[1:, 1] - ring[1:, 0] * ring[:-1, 1]).sum()
                for ring in path.to_polygons(closed_only=True)
            )

        assert sum(abs(area(path)) for path in bands) == pytest.approx(9.6 * 7.2, rel=1e-6)

    def test_extremes_are_told_with_their_places(self) -> None:
        """Largest value, uplift and places are those that the made-up fields have by construction; rings mark them."""
        axes = panels(groundslab.plot(synthetic.results(4), "settlement"))[0]
        reported = [text.get_text() for text in axes.texts]
        uplift = "uplift 28 mm at (4.8, 3.6) m"
        assert f"largest 28 mm at (0, 0) m;  {uplift}" in reported
        assert {"max 28", "min \N{MINUS SIGN}28"} <= set(reported)
        rings = {tuple(map(float, line.get_xydata()[0])) for line in axes.lines if line.get_marker() == "o"}
        assert rings == {(0.0, 0.0), (4.8, 3.6)}

    def test_zeros_are_no_extremes(self) -> None:
        """The smallest pressure is not labeled where it is zero; a field of zeros is called so."""
        results = synthetic.results(4)
        reported = words(groundslab.plot(results, "p", "s"))
        assert "smallest" not in reported
        assert "zero everywhere" in reported

    @pytest.mark.parametrize("lifts", [True, False])
    def test_contact_boundary_is_drawn_only_if_the_plate_lifts(self, lifts: bool) -> None:
        """A plate that rests everywhere has no border of contact and no hatching."""
        found = entries(groundslab.plot(synthetic.results(4, lifts=lifts), "p"))
        assert ("contact boundary" in found) is lifts
        assert ("no contact" in found) is lifts

    def test_contact_boundary_lies_where_winkler_has_it(self) -> None:
        """On Winkler ground the border runs where the settlement is zero, to the size of an element squared."""
        results = synthetic.results(12)
        axes = panels(groundslab.plot(results, "w"))[0]
        wide = [each for each in axes.collections if len(each.get_paths()) == 1 and each.get_linewidth()[0] == 1.3]
        places = wide[0].get_paths()[0].vertices
        assert len(places) > 50
        assert np.abs(1 - 2 * (places**2).sum(axis=1) / 36).max() < 0.01

    @pytest.mark.slow
    def test_the_pressure_tells_of_the_edge_line_force(self) -> None:
        """The line force neither stretches the scale nor is a pressure; its largest is reported in words."""
        reported = words(groundslab.plot(synthetic.results(4, shear=True), "p"))
        assert "largest 560 kPa at (0, 0) m" in reported
        assert "edge line force up to 500 kN/m at" in reported
        assert "line force" not in words(groundslab.plot(synthetic.results(4), "p"))

    @pytest.mark.slow
    def test_what_lies_on_the_plate_is_drawn(self) -> None:
        """Opening, zone with its thickness, void, columns with names, supports, held edges and loads are all there."""
        plate = Plate(
            outline=Polygon(points=[(0, 0), (8, 0), (8, 6), (0, 6)]),
            openings=[Rectangle(x=(5, 6), y=(3, 4))],
            zones=[Zone(shape=Rectangle(x=(0, 2), y=(0, 2)), thickness=0.5)],
            thickness=0.2,
            E=3e10,
            nu=0.2,
            edges=Edges(left="hinged"),
        )
        model = synthetic.model().replace(
            plate=plate,
            contact=Contact(voids=[Void(x=(1, 2), y=(4, 5))]),
            columns=[
                Column(name="A1", x=7, y=1, width_x=0.4, width_y=0.4),
                Column(name="$B<2>", x=7, y=5, diameter=0.4),
            ],
            supports=[PointSupport(x=1, y=1), LineSupport(points=[(3, 1), (3, 5)])],
            loads=[
                PointLoad(P=1e5, column="A1"),
                PointLoad(P=1e5, x=4, y=2),
                LineLoad(q=1e3, points=[(1, 3), (4, 3)]),
            ],
        )
        figure = groundslab.plot(synthetic.results(model=model), "w")
        assert entries(figure) == {
            "contact boundary", "zone", "void in the ground", "column with load", "column", "support", "line support",
            "supported edge", "point load", "line load",
        }  # fmt: skip
        assert {"A1", "$B<2>", "t = 0.5 m"} <= set(words(figure).splitlines())

    def test_only_loads_that_take_part_are_drawn(self) -> None:
        """A load of a case that is not in the combination is left out; the combination is named above."""
        combined = synthetic.combined()
        for name, there in ((combined.combinations[0].name, True), ("NUL", False)):
            figure = groundslab.plot(combined, "w", combination=name)
            assert ("point load" in entries(figure)) is there
            assert f"{name} (ultimate)" in words(figure)

    def test_panels_of_one_amount_share_a_scale(self) -> None:
        """Two combinations, one with twice the settlement, have the same bar, so that colors can be compared."""
        figure = groundslab.plot(synthetic.combined(), "w")
        first, second = (axes.child_axes[0].get_ylim() for axes in panels(figure))
        assert first == second

    def test_nothing_is_averaged_across_the_border_of_sections(self) -> None:
        """Where two nodes stand at one place each keeps its value: the drawing jumps there as the field does."""
        left, cells = synthetic.grid(2, 2, 2.0, 2.0)
        nodes = np.vstack([left - np.array([1, 0]), left + np.array([1, 0])])
        elements = np.vstack([cells, cells + len(left)])
        values = np.repeat([0.5, 9.5], len(left))
        with apply_style():
            axes = mpl.figure.Figure().add_subplot()
            contours.draw_contours(
                axes,
                contours.triangulation(nodes, elements),
                values,
                contours.ColorScale(np.arange(11.0), parts_at=None),
            )
        drawn = [path.vertices for path in axes.collections[0].get_paths() if len(path.vertices)]
        assert len(drawn) == 2
        assert [float(np.ptp(path[:, 0])) for path in drawn] == [2.0, 2.0]

    @pytest.mark.slow
    def test_envelope_has_extremes_with_the_governing_combination(self) -> None:
        """Panels hold the largest and smallest values over the certified combinations, and who governs is named."""
        combined = synthetic.combined()
        request = parse_request(combined, ("w", "bottom_x", "top_x"), None, None, "ultimate", None)
        panels = build_panels(request)
        assert [(panel.quantity.name, panel.source.split()[0]) for panel in panels] == [
            ("settlement", "Largest"), ("settlement", "Smallest"), ("bottom_x", "Largest"), ("top_x", "Smallest"),
        ]  # fmt: skip
        one, two = (nodal_values(each, "settlement") for each in combined.results.values())
        assert np.array_equal(panels[0].values, np.maximum(one, two))
        assert np.array_equal(panels[1].values, np.minimum(one, two))
        reported = words(groundslab.plot(combined, "w", envelope="ultimate"))
        assert "largest 56 mm at (0, 0) m (NUL)" in reported
        assert f"uplift 28 mm at (4.8, 3.6) m ({combined.combinations[0].name})" in reported

    @pytest.mark.slow
    @pytest.mark.parametrize("ratio", [0.1, 0.4, 0.75, 1.0, 2.5])
    def test_pages_fit_on_a4(self, ratio: float) -> None:
        """Whatever the plate's shape, a full page is as wide as the text and not higher than a sheet of A4."""
        columns, rows = plan.panels_per_page(ratio)
        model = synthetic.model().replace(
            plate=Plate(length_x=10, length_y=10 * ratio, thickness=0.2, E=3e10, nu=0.2),
            loads=[PointLoad(P=1, x=0, y=0)],
        )
        nodes, elements = synthetic.grid(2, 2, 10, 10 * ratio)
        flat = synthetic.results(model=model)
        results = replace(flat, plate=replace(flat.plate, nodes=nodes, elements=elements))
        names = list(request.QUANTITIES)[: columns * rows]
        with apply_style():
            (figure,) = plan.draw_pages(parse_request(results_of(results), names, None, None, None, None))
        width, height = figure.get_size_inches() * 25.4
        assert width == pytest.approx(180)
        assert height < 275


def sides_of(axes: Any) -> list[Any]:
    """Return the sides of elements that axes in plan have, each a curve of three places."""
    lines = [line.get_xydata() for line in axes.lines if np.isnan(line.get_xydata()).any()]
    return [side for line in lines for side in np.split(line, len(line) // 4)]


class TestMesh:
    """The mesh, alone and over fields."""

    def test_every_side_is_drawn_once(self) -> None:
        """Of 3 x 3 elements 24 sides, which together are as long as all lines of the grid; sizes stand above."""
        figure = groundslab.plot(synthetic.results(3), kind="mesh")
        (axes,) = panels(figure)
        sides = sides_of(axes)
        assert len(sides) == 24
        lengths = [np.hypot(*(side[2] - side[0])) for side in sides]
        assert sum(lengths) == pytest.approx(4 * (synthetic.LENGTH_X + synthetic.LENGTH_Y))
        assert "9 elements of 2.771 m" in words(figure)
        assert {"element", "point load"} <= entries(figure)

    def test_sides_between_sections_are_drawn(self) -> None:
        """Where nodes stand twice, once for each section, no side is missing."""
        found = synthetic.results(2)
        apart = np.arange(9 * 4).reshape(4, 9)
        plate = replace(found.plate, **{
            field.name: getattr(found.plate, field.name)[found.plate.elements.ravel()]
            for field in fields(found.plate) if field.name != "elements"
        }, elements=apart)  # fmt: skip
        (axes,) = panels(groundslab.plot(replace(found, plate=plate), kind="mesh"))
        assert len(sides_of(axes)) == 16

    def test_a_crooked_element_is_named(self) -> None:
        """Sizes from the smallest to the largest, and where the worst element lies."""
        found = synthetic.results(2)
        nodes = found.plate.nodes.copy()
        nodes[found.plate.elements[0, 2]] += [0.5, 0.3]
        text = words(groundslab.plot(replace(found, plate=replace(found.plate, nodes=nodes)), kind="mesh"))
        assert re.search(r"4 elements of \S+ to \S+ m", text)
        assert re.search(r"at worst 0\.\d+ at \(", text)

    @pytest.mark.parametrize("kind", ["plan", "deformed"])
    def test_over_a_field_only_if_asked_for(self, kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
        """In plan and in space; in space small meshes have their sides anyway."""
        monkeypatch.setattr(deformed, "MOST_SIDES", 3)

        def count(mesh: bool) -> int:
            (axes,) = [
                each for each in groundslab.plot(synthetic.results(2), "w", kind=kind, mesh=mesh).axes
                if (each.name == "3d") == (kind == "deformed")
            ]  # fmt: skip
            return len(sides_of(axes)) if kind == "plan" else len(axes.collections)

        assert (count(False), count(True)) == ((0, 12) if kind == "plan" else (1, 2))

    def test_over_envelopes(self) -> None:
        """The mesh is that of all combinations."""
        figure = groundslab.plot(synthetic.combined(), "m_x", envelope="ultimate", mesh=True)
        assert [len(sides_of(axes)) for axes in panels(figure)] == [12, 12]


class TestDiscretizationError:
    """The error of each element, at the nodes by means."""

    def test_the_same_error_everywhere(self) -> None:
        """Of 2 % at all elements the mean is 2 % at all nodes."""
        found = synthetic.compared(synthetic.results(3))
        same = replace(found, elements=replace(found.elements, discretization_error=np.full(9, 0.02)))
        np.testing.assert_allclose(nodal_values(same, "discretization_error"), 2.0)

    def test_means_are_those_of_the_areas(self) -> None:
        """A node between elements 1 and 3 m wide has a quarter of the first one's value and the rest of the other's."""
        nodes, elements = synthetic.grid(2, 1, 4.0, 2.0)
        nodes[:, 0] = np.interp(nodes[:, 0], [-2, 0, 2], [0, 1, 4])
        plate = synthetic.results(1).plate
        found = mean_at_nodes(replace(plate, nodes=nodes, elements=elements), np.array([0.04, 0.08]))
        np.testing.assert_allclose(found[np.isclose(nodes[:, 0], 1.0)], 0.07)
        np.testing.assert_allclose(found[nodes[:, 0] < 0.9], 0.04)

    def test_is_drawn_with_the_mesh(self, tmp_path: Path) -> None:
        """By its symbol, into a file, with largest and smallest value in percent."""
        found = synthetic.compared(synthetic.results(3))
        figure = groundslab.plot(found, "rho_e", mesh=True, to=tmp_path / "error.png")
        assert (tmp_path / "error.png").stat().st_size > 10_000
        assert "largest 3 %" in words(figure)
        assert "Density of the discretization error in energy" in words(figure)


class TestWords:
    """What is written by users and by us."""

    @pytest.mark.slow
    @pytest.mark.parametrize(
        "title", ["costs $5 and $x", r"$\frac{1}{", "<b>bold</b> & more", "tab\tbell\a\x00end", "日本", "x" * 400, ""]
    )
    def test_free_text_is_harmless(self, tmp_path: Path, title: str) -> None:
        """Formulas, markup, letters that the font lacks and long words come out as they are in the model.

        Of control characters it has what shows them.
        """
        results = synthetic.results(model=synthetic.model(title=title))
        groundslab.plot(results, kind="convergence", to=tmp_path / "a.svg")
        written = "".join(ElementTree.parse(tmp_path / "a.svg").getroot().itertext())
        assert results.model.title.isprintable()
        assert set(plain_text(results.model.title, 60).split(" ...")[0].splitlines()) <= {
            line.strip() for line in written.splitlines()
        }

    @pytest.mark.slow
    @pytest.mark.parametrize("ending", ["pdf", "png"])
    def test_free_text_is_harmless_in_other_files(self, tmp_path: Path, ending: str) -> None:
        """The same for a title with all of that, and for names of combinations, which stand in legends too."""
        nasty = "$5 and $x \\frac{1}{ <b>\x00 日本"
        combined = synthetic.combined()
        names = {combined.combinations[0].name: nasty, "NUL": "$\\alpha"}
        renamed = replace(
            combined,
            combinations=tuple(each.replace(name=names.get(each.name, each.name)) for each in combined.combinations),
            results={names[name]: each for name, each in combined.results.items()},
        )
        renamed.plot("w", line=(-4, 0, 4, 0), to=tmp_path / f"a.{ending}")
        assert (tmp_path / f"a.{ending}").stat().st_size > 5000

    def test_control_characters_are_taken_out(self) -> None:
        """What XML cannot hold becomes a blank; long words are broken, long texts line."""
        assert plain_text("a\x00b\nc") == "a b c"
        assert plain_text("x" * 30, 10, 2).splitlines() == ["x" * 10, "..."]
        assert plain_text("one two three four", 9, 2).splitlines() == ["one two", "three ..."]

    def test_symbols_and_numbers(self) -> None:
        """Symbols are formulas; numbers have four digits and a true minus, zero has none."""
        assert math_symbol("m_xy") == "$m_{xy}$"
        assert math_symbol("beta_x") == r"$\beta_{x}$"
        assert format_drawn(-13.2641) == "\N{MINUS SIGN}13.26"
        assert format_drawn(-0.0) == "0"

    def test_words_stand_where_there_is_room(self) -> None:
        """A second box does not stand on the first, nor beyond the drawing."""
        placement = LabelPlacement((0, 20, 0, 20))
        first = placement.place_beside((10, 10), (3, 1), 1)
        second = placement.place_beside((10, 10), (3, 1), 1)
        assert first == (10, 12)
        assert second == (10, 8)
        assert placement.place_beside((10, 19.5), (3, 1), 1)[1] <= 19


class TestDeformed:
    """The plate in space."""

    @pytest.mark.slow
    def test_exaggeration_is_round_and_told(self) -> None:
        """1, 2 or 5 times a power of ten, so that the largest settlement is about a seventh of the longer side."""
        for largest in (1e-4, 0.0028, 0.028, 0.3):
            factor = deformed.find_exaggeration([np.array([0.0, -largest])], 9.6)
            mantissa = factor / 10 ** np.floor(np.log10(factor))
            assert round(mantissa, 9) in (1, 2, 5)
            assert 0.4 * deformed.DEPTH < factor * largest / 9.6 <= deformed.DEPTH * (1 + 1e-9)
        figure = groundslab.plot(synthetic.results(3), kind="deformed")
        assert "exaggerated 20 times" in words(figure)

    def test_facets_follow_the_shape_functions(self) -> None:
        """Facets of an element have a biquadratic field's exact values at their corners, and its whole area."""
        nodes, elements = synthetic.grid(2, 1, 4.0, 2.0)
        field = nodes[:, 0] ** 2 * nodes[:, 1] - 3 * nodes[:, 1] ** 2
        xy, (values,) = deformed.facets(nodes, elements, [field], 3)
        assert xy.shape == (2 * 9, 4, 2)
        assert np.allclose(values, xy[..., 0] ** 2 * xy[..., 1] - 3 * xy[..., 1] ** 2)
        a, b = xy[:, 2] - xy[:, 0], xy[:, 3] - xy[:, 1]
        twice = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
        assert (twice > 0).all()
        assert twice.sum() / 2 == pytest.approx(8.0)

    def test_uplift_stands_above_the_level_and_plan_axes_are_equal(self) -> None:
        """Heights are exaggerated settlements turned round; a meter is as long along x, along y and upwards."""
        figure = groundslab.plot(synthetic.results(4), kind="deformed")
        axes = next(each for each in figure.axes if each.name == "3d")
        low, high = axes.get_zlim()
        assert (low, high) == (pytest.approx(-20 * 0.028), pytest.approx(20 * 0.028))
        sides = np.array([9.6, 7.2, high - low])
        aspect = np.array(axes._box_aspect)
        assert np.allclose(aspect / aspect[0], sides / sides[0])
        assert axes.get_xlim() == (-4.8, 4.8)
        labels = [tick.get_text() for tick in axes.get_zticklabels()]
        assert any(label.startswith("\N{MINUS SIGN}") and label.endswith("mm") for label in labels)
        assert {"contact boundary", "level before loading"} <= entries(figure)

    def test_a_plate_that_does_not_move_can_be_drawn(self) -> None:
        """No settlement at all, and a border of sections along the border of contact, are no reason to fail."""
        results = synthetic.results(lifts=False)
        still = replace(results, plate=replace(results.plate, settlement=0 * results.plate.settlement))
        assert "exaggerated 1 times" in words(groundslab.plot(still, "p", kind="deformed"))


class TestLines:
    """Values along section lines."""

    def test_curves_hold_the_values_along_the_line(self) -> None:
        """Each combination has a curve; samples at nodes have the nodes' values, in the unit of display."""
        combined = synthetic.combined()
        (curves,) = sections.sample_lines(parse_request(combined, ("w", "m_1"), None, None, None, (-4.8, 0, 4.8, 0)))
        assert curves.names == tuple(combined.results)
        s, values = curves.section.s, curves.values["settlement"]
        assert np.allclose(values[0], 28 * (1 - 2 * (s - 4.8) ** 2 / 36))
        assert set(curves.values) == {"settlement", "m_1"}
        figure = groundslab.plot(combined, "w", "m_x", line=(-4.8, 0, 4.8, 0))
        assert {plain_text(name) for name in combined.results} == entries(figure)
        upper, lower = panels(figure)
        assert upper.yaxis_inverted()
        assert not lower.yaxis_inverted()
        assert (upper.get_ylabel(), lower.get_ylabel()) == ("$w$ [mm]", "$m_{x}$ [kN m/m]")
        assert lower.get_xlabel() == "distance s along the line [m]"
        assert len([line for line in upper.lines if len(line.get_xdata()) > 2]) == 2

    def test_lines_of_the_case_are_drawn_by_name(self) -> None:
        """Without a line those of the case are drawn; one that lies in an opening only is left out."""
        output = Output(
            lines=[
                OutputLine(name="axis $1", start=(-4, 0), end=(4, 0)),
                OutputLine(name="B", start=(0, -3), end=(0, 3)),
            ]
        )
        results = synthetic.results(model=synthetic.model().replace(output=output))
        figure = groundslab.plot(results, "w", kind="lines")
        assert {"axis $1", "B"} <= set(words(figure).splitlines())
        assert len(panels(figure)) == 2

    def test_curves_break_where_the_section_changes(self) -> None:
        """No curve runs across a gap between parts."""
        results = synthetic.results(2)
        keep = results.plate.elements[[0, 1]] - 0
        apart = np.vstack([results.plate.elements[0], results.plate.elements[1]])
        nodes = results.plate.nodes[apart].reshape(-1, 2)
        assert len(keep) == 2
        fields = {
            name: getattr(results.plate, name)[apart].ravel()
            for name in (
                "settlement", "rotation_x", "rotation_y", "gap", "penetration", "pressure", "moment_x", "moment_y",
                "moment_xy", "shear_x", "shear_y", "in_contact", "line_force", "area", "edge_length",
            )
        }  # fmt: skip
        plate = replace(results.plate, nodes=nodes, elements=np.arange(18).reshape(2, 9), **fields)
        figure = groundslab.plot(replace(results, plate=plate), "w", line=(-4.8, -1, 4.8, -1))
        curves = [line.get_xdata() for line in panels(figure)[0].lines if len(line.get_xdata()) > 2]
        assert len(curves) == 2
        assert curves[0][-1] == pytest.approx(curves[1][0])

    def test_many_combinations_become_a_band(self) -> None:
        """Of more than can be distinguished the largest and the smallest are drawn, as for an envelope."""
        base = synthetic.results()
        names = [f"c{n}" for n in range(10)]
        found = {
            name: replace(base, combination=name, plate=replace(base.plate, settlement=(n + 1) * base.plate.settlement))
            for n, name in enumerate(names)
        }
        combined = Results(base.model, tuple(Combination(name=name, factors={"": 1.0}) for name in names), found, {})
        (curves,) = sections.sample_lines(parse_request(combined, ("w",), None, None, None, (-4.8, 0, 4.8, 0)))
        assert curves.names == ("largest of 10 combinations", "smallest of 10 combinations")
        assert curves.values["settlement"][0].max() == pytest.approx(280)
        assert curves.values["settlement"][1].max() == pytest.approx(28)
        some = parse_request(combined, ("w",), None, names[:8], None, (-4.8, 0, 4.8, 0))
        assert len(sections.sample_lines(some)[0].names) == 8
        assert entries(sections.draw_sheet(some)) == set(names[:8])


class TestSoil:
    """The ground in section."""

    LAYERS = (
        SoilLayer(E=15e6, E_bottom=25e6, nu=0.3, thickness=2.0),
        SoilLayer(E=40e6, nu=0.25, thickness=4.0),
    )

    @pytest.mark.parametrize(
        ("layers", "variation"), [(LAYERS, "profile"), (LAYERS[1:], "sinh")], ids=["profile", "sinh"]
    )
    def test_constants_are_the_integrals_of_the_mode_that_is_drawn(self, layers: Any, variation: str) -> None:
        """k0 = int Ec psi'^2 dz (2.17) and k1 = int G psi^2 dz (2.18), by the trapezoidal rule over the drawn curve."""
        results = layered(Vlasov(layers=layers), 1.3)
        (found,) = soil.soil_columns(results.model, plotted_combinations(results))
        (mode,) = found.constants
        assert mode.gamma == pytest.approx(1.3, rel=1e-9)
        assert mode.psi is not None
        assert mode.z is not None
        assert (mode.psi[0], mode.psi[-1]) == (pytest.approx(1.0), pytest.approx(0.0, abs=1e-12))
        z = np.linspace(0, float(found.depth or 0), 40_001)
        psi = np.interp(z, mode.z, mode.psi)
        middle = (z[1:] + z[:-1]) / 2
        tops = np.cumsum([0.0, *(layer.thickness for layer in layers)])
        which = np.clip(np.searchsorted(tops, middle, side="right") - 1, 0, len(layers) - 1)
        E0 = np.array([layer.E for layer in layers])[which]
        E1 = np.array([layer.E if layer.E_bottom is None else layer.E_bottom for layer in layers])[which]
        thickness = np.array([layer.thickness for layer in layers])[which]
        nu = np.array([layer.nu for layer in layers])[which]
        E = E0 + (E1 - E0) * (middle - tops[which]) / thickness
        confined = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu))
        k0 = (confined * np.diff(psi) ** 2 / np.diff(z)).sum()
        k1 = (E / (2 * (1 + nu)) * ((psi[1:] + psi[:-1]) / 2) ** 2 * np.diff(z)).sum()
        assert mode.k0[0] == pytest.approx(k0, rel=1e-3), variation
        assert mode.k1[0] == pytest.approx(k1, rel=1e-3)

    def test_boreholes_stand_side_by_side(self) -> None:
        """Each has its name and place, its own layers, mode, k0 and k1; the mean of their gammas is the result's."""
        holes = [
            Borehole(name="B1", x=-4.8, y=0, layers=self.LAYERS),
            Borehole(x=4.8, y=0, layers=[layer.replace(thickness=2 * layer.thickness) for layer in self.LAYERS]),
        ]
        results = layered(Vlasov(layers=self.LAYERS), 1.3, boreholes=holes)
        first, second = soil.soil_columns(results.model, plotted_combinations(results))
        assert (first.name, second.name) == ("B1", "borehole 2")
        assert (first.depth, second.depth) == (6.0, 12.0)
        # twice the depth of the same soils has twice the gamma for one decay; the plate's mean lies between
        assert second.constants[0].gamma == pytest.approx(2 * first.constants[0].gamma)
        assert first.constants[0].gamma < 1.3 < second.constants[0].gamma
        assert second.constants[0].k0[0] < first.constants[0].k0[0]
        reported = words(groundslab.plot(results, kind="soil"))
        assert "B1 at (\N{MINUS SIGN}4.8, 0) m" in reported
        assert "borehole 2 at (4.8, 0) m" in reported

    def test_layers_to_scale_with_their_moduli(self) -> None:
        """Depth runs downwards, E as it varies, layers are as thick as they are."""
        results = layered(Vlasov(layers=self.LAYERS), 1.3)
        column, moduli, mode = panels(groundslab.plot(results, kind="soil"))
        heights = [patch.get_height() for patch in column.patches[:2]]
        assert heights == [2.0, 4.0]
        assert column.get_ylim() == (6.0, 0.0)
        assert column.get_ylabel() == "depth z [m]"
        assert moduli.get_xlabel() == "$E$ [MPa]"
        (curve,) = moduli.lines
        assert [curve.get_xdata()[0], curve.get_xdata()[-1]] == [15.0, 40.0]
        assert np.interp(1.0, curve.get_ydata(), curve.get_xdata()) == pytest.approx(20.0)
        assert mode.get_xlabel() == r"$\psi$ [-]"

    def test_stacks_have_constants_of_each_layer(self) -> None:
        """k0 and k1 stand beside each layer, given or found; without thickness nothing is called to scale."""
        given = Layered(coupling="interface", layers=[InterfaceLayer(k0=2e7, k1=3e6), InterfaceLayer(k0=5e7, k1=0)])
        figure = groundslab.plot(layered(given, None), kind="soil")
        reported = words(figure)
        assert "not to scale" in reported
        assert {"20", "50", "3", "0"} <= set(reported.splitlines())
        found = layered(Layered(coupling="interface", layers=self.LAYERS), 0.9)
        (stack,) = soil.soil_columns(found.model, plotted_combinations(found))
        for stratum, layer in zip(stack.layers, self.LAYERS, strict=True):
            made = soil.layer_of(layer)
            k0, k1 = vlasov.parameters(made, 0.9)
            assert stratum.k0 == (pytest.approx(float(k0)),)
            assert stratum.k1 == (pytest.approx(float(k1)),)
        consistent = layered(Layered(coupling="consistent", layers=[self.LAYERS[1].replace(sublayers=4)]), None)
        (parts,) = soil.soil_columns(consistent.model, plotted_combinations(consistent))
        confined = 40e6 * 0.75 / (1.25 * 0.5)
        assert parts.layers[0].k0 == (pytest.approx(confined / 1.0),) * 4

    def test_springs_have_no_depth(self) -> None:
        """Winkler's and Pasternak's ground are drawn as one layer, not to scale, with their constants."""
        for shear, known in ((False, {"20"}), (True, {"20", "30"})):
            reported = words(groundslab.plot(synthetic.results(shear=shear), kind="soil"))
            assert "not to scale" in reported
            assert known <= set(reported.splitlines())

    @pytest.mark.slow
    def test_many_profiles_go_on_several_pages(self) -> None:
        """Of six boreholes four stand on the first page and two on the next."""
        holes = [Borehole(x=float(n), y=0, layers=self.LAYERS) for n in range(-3, 3)]
        results = layered(Vlasov(layers=self.LAYERS), 1.3, boreholes=holes)
        with apply_style():
            pages = soil.draw_pages(parse_request(results_of(results), (), "soil", None, None, None))
        assert [words(page).count("borehole ") for page in pages] == [4, 2]


def plotted_combinations(results: CombinationResult) -> Any:
    """Return the one combination of results as it is drawn."""
    return parse_request(results_of(results), (), "soil", None, None, None).combinations


class TestConvergence:
    """How the iteration went."""

    def test_steps_are_grouped_by_mesh(self) -> None:
        """Changed nodes and nodes in contact of each step, a curve for each mesh, which is reported by its unknowns."""
        results = synthetic.results()
        figure = groundslab.plot(results, kind="convergence")
        changed, touching = panels(figure)
        assert [list(line.get_ydata()) for line in changed.lines] == [[8], [1, 0]]
        assert [list(line.get_ydata()) for line in touching.lines] == [[25], [17, 16]]
        assert [list(line.get_xdata()) for line in touching.lines] == [[1], [2, 3]]
        reported = words(figure)
        assert "340 unknowns" in reported
        assert "1234 unknowns" in reported
        assert "converged in 3 steps" in reported
        assert (changed.get_ylabel(), touching.get_ylabel()) == ("changed [-]", "in contact [-]")
        assert touching.get_xlabel() == "step"

    def test_gamma_has_axes_of_its_own_if_it_is_iterated(self) -> None:
        """Each step's gamma is drawn, and the last one labeled."""
        base = synthetic.results()
        steps = tuple(replace(step, gamma=1.0 + n / 10) for n, step in enumerate(base.steps))
        figure = groundslab.plot(replace(base, steps=steps), kind="convergence")
        gamma = panels(figure)[2]
        assert [round(float(y), 9) for line in gamma.lines for y in line.get_ydata()] == [1.0, 1.1, 1.2]
        assert gamma.get_ylabel() == r"$\gamma$ [-]"
        assert "gamma = 1.2" in words(figure)

    @pytest.mark.slow
    def test_an_iteration_that_did_not_converge_is_drawn_too(self) -> None:
        """Its history is what one wants to see; those without a history are left out."""
        combined = synthetic.combined()
        history = [{"iteration": 1, "closed": 40, "changed": 9}, {"iteration": 2, "closed": 41, "changed": 7}]
        refused = combined.refused | {"wind alone": NotConverged("the contact zone", history, {})}
        figure = groundslab.plot(replace(combined, refused=refused), kind="convergence")
        reported = words(figure)
        assert "wind alone: did not converge" in reported
        assert "uncertified: not certified" in reported
        with pytest.raises(InputError, match="history"):
            groundslab.plot(combined, kind="convergence", combination="wind alone")
        with apply_style():
            pages = convergence.draw_pages(parse_request(combined, (), "convergence", None, None, None))
        assert len(pages) == 2


class TestFiles:
    """Figures as files."""

    @pytest.mark.slow
    @pytest.mark.parametrize(
        ("kind", "ending"),
        [("plan", "pdf"), ("plan", "svg"), ("lines", "png"), ("soil", "svg")],
    )
    def test_two_runs_give_the_same_bytes(self, tmp_path: Path, kind: str, ending: str) -> None:
        """No date, no random name is in the files, and a reader's own style for figures changes nothing."""
        line = (-4, 0, 4, 1) if kind == "lines" else None
        results = synthetic.results(2)
        results.plot(kind=kind, line=line, to=tmp_path / f"a.{ending}")
        with mpl.rc_context({"axes.facecolor": "red", "font.size": 30, "svg.fonttype": "path", "lines.linewidth": 9}):
            results.plot(kind=kind, line=line, to=tmp_path / f"b.{ending}")
        first, second = ((tmp_path / f"{name}.{ending}").read_bytes() for name in "ab")
        assert first == second
        assert not any(word in first for word in (b"CreationDate", b"<dc:date>", b"tIME"))

    @pytest.mark.slow
    def test_another_process_gives_the_same_bytes(self, tmp_path: Path) -> None:
        """With other hashes of texts, too, the SVG is the same."""
        program = f"""
import sys
sys.path.insert(0, {str(ROOT / "tests")!r})
import groundslab
from helpers import synthetic
groundslab.plot(synthetic.results(2), "w", "p", to=sys.argv[1])
assert "matplotlib.pyplot" not in sys.modules
"""
        seed = "2" if os.environ.get("PYTHONHASHSEED") == "1" else "1"
        subprocess.run(
            [sys.executable, "-c", program, str(tmp_path / "there.svg")],
            check=True,
            env={**os.environ, "PYTHONHASHSEED": seed},
        )
        groundslab.plot(synthetic.results(2), "w", "p", to=tmp_path / "here.svg")
        assert (tmp_path / "here.svg").read_bytes() == (tmp_path / "there.svg").read_bytes()

    @pytest.mark.slow
    def test_text_stays_text(self, tmp_path: Path) -> None:
        """Titles and labels can be searched in the SVG."""
        groundslab.plot(synthetic.results(2), "w", to=tmp_path / "a.svg")
        text = (tmp_path / "a.svg").read_text(encoding="utf-8")
        for word in ("A slab of formulas", "Settlement of the plate, downwards positive", "x [m]", "loaded area"):
            assert f">{word}</text>" in text

    @pytest.mark.slow
    def test_colors_of_large_meshes_are_pixels(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """Above a number of elements the SVG holds an image, and lines and text as before."""
        results = synthetic.results(4)
        groundslab.plot(results, "w", to=tmp_path / "small.svg")
        monkeypatch.setattr(contours, "MOST_ELEMENTS", 10)
        groundslab.plot(results, "w", to=tmp_path / "large.svg")
        small, large = ((tmp_path / name).read_text(encoding="utf-8") for name in ("small.svg", "large.svg"))
        assert "<image" not in small
        assert "<image" in large
        assert ">x [m]</text>" in large

    @pytest.mark.slow
    def test_a_pdf_has_pages_and_others_one_sheet(self, tmp_path: Path) -> None:
        """Each combination has a page of its own in a PDF; a PNG holds all panels."""
        combined = synthetic.combined()
        combined.plot("w", to=tmp_path / "a.pdf")
        assert (tmp_path / "a.pdf").read_bytes().count(b"/Type /Page ") == 2
        figure = combined.plot("w", to=tmp_path / "a.png")
        assert len(panels(figure)) == 2
        assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG\r\n\x1a\n")

    def test_unknown_endings_are_refused(self, tmp_path: Path) -> None:
        """A name without one of the endings is reported, and nothing is written."""
        with pytest.raises(InputError, match=r"\.pdf, \.svg, \.png or \.dxf"):
            groundslab.plot(synthetic.results(), to=tmp_path / "a.docx")
        assert not list(tmp_path.iterdir())

    def test_too_much_for_one_sheet_is_told(self, monkeypatch: pytest.MonkeyPatch) -> None:
        """Rather than a sheet that nobody can read there is a hint at the PDF."""
        monkeypatch.setattr(plots, "MOST_PANELS", 3)
        with pytest.raises(InputError, match="PDF"):
            groundslab.plot(synthetic.combined(), "w", "p")
        assert len(panels(groundslab.plot(synthetic.combined(), "w"))) == 2

    @pytest.mark.slow
    def test_notebooks_show_the_figure(self) -> None:
        """The figure gives its own picture; results of one and of several combinations have the method."""
        figure = synthetic.results().plot("w")
        assert figure._repr_png_().startswith(b"\x89PNG")
        assert isinstance(figure, mpl.figure.Figure)
        assert len(panels(synthetic.combined().plot("w"))) == 2


class TestPicture:
    """The picture of solve --plot."""

    @pytest.mark.slow
    @pytest.mark.parametrize(("n", "shear", "lifts"), [(2, False, True), (3, True, True), (2, True, False)])
    def test_is_a_png_with_titles_and_units(self, tmp_path: Path, n: int, shear: bool, lifts: bool) -> None:
        """A PNG file comes out; both panels name their axes and color bars with units."""
        results = synthetic.results(n, shear=shear, lifts=lifts)
        plots.write_picture(results, tmp_path / "picture.png")
        assert (tmp_path / "picture.png").read_bytes().startswith(b"\x89PNG\r\n\x1a\n")
        figure = plots.plot(results)
        boxes = panels(figure)
        assert [axes.get_xlabel() for axes in boxes] == ["x [m]", "x [m]"]
        assert [axes.child_axes[0].get_ylabel() for axes in boxes] == ["$w$ [mm]", "$p$ [kPa]"]
        reported = words(figure)
        assert "Settlement of the plate" in reported
        assert "Contact pressure under the plate" in reported
        share = 100 * results.plate.area[results.plate.in_contact].sum() / results.plate.area.sum()
        assert f"{format_drawn(share)} % of the plate in contact" in reported
        found = entries(figure)
        assert ("contact boundary" in found) == lifts
        assert ("edge line force" in reported) == shear
        assert {"loaded area", "load on the entire plate", "point load"} <= found

    @pytest.mark.slow
    def test_colors_part_at_zero_only_with_uplift(self) -> None:
        """With uplift zero has the middle color; without it the colors run one way."""
        for lifts in (True, False):
            drawn = panels(plots.plot(synthetic.results(lifts=lifts)))[0].collections[0]
            assert (drawn.norm(0.0) == 0.5 and drawn.get_cmap().name == contours.TWO_SIGNS) == lifts

    @pytest.mark.slow
    @pytest.mark.parametrize("value", [0.0, 1e-3])
    def test_constant_fields_can_be_drawn(self, tmp_path: Path, value: float) -> None:
        """A plate that settles evenly, or not at all, has a picture too."""
        results = synthetic.results(lifts=False)
        flat = np.full_like(results.plate.settlement, value)
        plate = replace(results.plate, settlement=flat, pressure=flat * synthetic.K0)
        plots.write_picture(replace(results, plate=plate), tmp_path / "picture.png")

    def test_columns_and_supports_are_drawn(self) -> None:
        """Columns, supports at points and along lines have their entries, and their marks lie where they are."""
        model = synthetic.model().replace(
            columns=[Column(name="A1", x=1, y=2, width_x=0.3, width_y=0.4)],
            supports=[PointSupport(x=-2, y=-1), LineSupport(points=[(-3, 1), (-1, 1)])],
        )
        figure = plots.plot(synthetic.results(model=model))
        assert {"column", "support", "line support"} <= entries(figure)
        panel = panels(figure)[0]
        drawn = {tuple(map(float, (*line.get_xdata(), *line.get_ydata()))) for line in panel.lines}
        assert {(-2, -1), (-3, -1, 1, 1)} <= drawn
        corners = [patch.get_xy() for patch in panel.patches if len(patch.get_xy()) == 5]
        assert any(np.allclose([each.min(axis=0), each.max(axis=0)], [[0.85, 1.8], [1.15, 2.2]]) for each in corners)

    def test_the_combination_is_named(self) -> None:
        """A folder of several combinations has a picture in each, which says which one it is."""
        results = synthetic.combined()["NUL"]
        assert {"A slab of formulas", "NUL (ultimate)"} <= set(words(plots.plot(results)).splitlines())

    def test_triangles_cover_the_plate_once(self) -> None:
        """The triangles all turn the same way and their areas add up to the plate's."""
        nodes, elements = synthetic.grid(3, 2, 9.6, 7.2)
        a, b, c = (nodes[corner] for corner in contours.triangulate(elements).T)
        u, v = b - a, c - a
        twice = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
        assert (twice > 0).all()
        assert twice.sum() / 2 == pytest.approx(9.6 * 7.2)

    def test_contact_function_is_winklers(self) -> None:
        """On Winkler ground the function whose zero is drawn is -k w, straight through the boundary."""
        results = synthetic.results(4)
        assert np.allclose(contact_function(results), -synthetic.K0 * results.plate.settlement)


class TestCommand:
    """groundslab plot."""

    @pytest.fixture
    def folder(self, tmp_path: Path) -> Path:
        """Return a folder of results of several combinations."""
        return results_folder.save_results(synthetic.combined(), tmp_path / "raft-results")

    @pytest.mark.slow
    def test_writes_a_pdf_beside_the_folder(self, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """The file is named after the folder and what it shows, and reported on standard error."""
        assert main.main(["plot", str(folder)]) == 0
        assert main.main(["plot", f"{folder}/", "w", "--kind", "plan", "m_x"]) == 0
        assert main.main(["plot", str(folder), "--line", "-4,0,4,0"]) == 0
        out, err = capsys.readouterr()
        assert out == ""
        made = sorted(path.name for path in folder.parent.iterdir() if path.is_file())
        assert made == ["raft-results-lines.pdf", "raft-results-plan.pdf", "raft-results-settlement-moment_x.pdf"]
        assert all(name in err for name in made)
        assert "2 pages" in err

    @pytest.mark.slow
    def test_mesh(self, folder: Path, tmp_path: Path) -> None:
        """Alone on one page, and over a field."""
        for arguments in (["--kind", "mesh"], ["w", "--mesh"]):
            assert main.main(["plot", str(folder), *arguments, "--out", str(tmp_path / "a.svg")]) == 0
            text = (tmp_path / "a.svg").read_text(encoding="utf-8")
            assert ("Mesh: 4 elements" in text) == ("--kind" in arguments)

    @pytest.mark.slow
    def test_one_combination_and_one_file(self, folder: Path, tmp_path: Path) -> None:
        """A combination by name, a file by its ending; what is there is replaced."""
        out = tmp_path / "a.svg"
        for field in ("w", "p"):
            assert main.main(["plot", str(folder), "--combination", "NUL", "--out", str(out), field]) == 0
        text = out.read_text(encoding="utf-8")
        assert ">NUL (ultimate)</text>" in text
        assert "Contact pressure" in text

    @pytest.mark.slow
    @pytest.mark.parametrize(
        ("arguments", "reported"),
        [
            (["bogus"], "bottom_x"),
            (["--kind", "bogus"], "convergence"),
            (["--combination", "bogus"], "NUL"),
            (["--line", "1,2,3"], "--line"),
            (["--line", "a,b,c,d"], "--line"),
            (["--out", "a.docx"], ".svg"),
            (["--out", "a"], ".svg"),
        ],
    )
    def test_wrong_input_ends_with_2(
        self, folder: Path, arguments: list[str], reported: str, capsys: pytest.CaptureFixture[str]
    ) -> None:
        """What is wrong is reported with what would be right; nothing is written."""
        assert main.main(["plot", str(folder), *arguments]) == 2
        out, err = capsys.readouterr()
        assert out == ""
        assert reported in err
        assert [path.name for path in folder.parent.iterdir()] == ["raft-results"]

    def test_the_folder_of_results_is_kept_clean(self, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """A file in it would keep solve from replacing it later; a folder without results is reported."""
        assert main.main(["plot", str(folder), "--out", str(folder / "a.pdf")]) == 2
        assert "inside the folder" in capsys.readouterr().err
        assert main.main(["plot", str(folder.parent)]) == 2
        assert "a folder of results" in capsys.readouterr().err

    def test_unknown_options_are_refused(self, folder: Path) -> None:
        """An option that is not there is no field."""
        with pytest.raises(SystemExit) as code:
            main.main(["plot", str(folder), "w", "--color", "red"])
        assert code.value.code == 2

    def test_help_names_every_field_and_kind(self, capsys: pytest.CaptureFixture[str]) -> None:
        """What can be drawn stands in --help."""
        with pytest.raises(SystemExit):
            main.main(["plot", "--help"])
        reported = capsys.readouterr().out
        assert all(name in reported for name in (*request.QUANTITIES, *request.KINDS, "--mesh"))


@pytest.mark.slow
def test_plots_wait_for_matplotlib() -> None:
    """Importing all of them loads neither matplotlib nor pandas."""
    names = ", ".join(sorted(path.stem for path in Path(plots.__file__).parent.glob("*.py") if path.stem[0] != "_"))
    heavy = {"matplotlib", "pandas", "rich"}
    code = f"import sys\nfrom groundslab.views.plots import {names}\nassert not {heavy} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True)
