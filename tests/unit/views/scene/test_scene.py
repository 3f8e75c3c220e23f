"""What a browser draws of a solved model: its plan as described, its fields as computed, quantized as documented."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from groundslab.errors import GroundslabError
from groundslab.model.loads.load_types import UniformLoad
from groundslab.model.model import Model
from groundslab.results.contact_zone import contact_function
from groundslab.results.fields import PLATE_FIELDS
from groundslab.results.results import Results, results_of
from groundslab.views.scene.binary import LEVELS, PART, Blocks, Scene, pack, put_fields
from groundslab.views.scene.fields import scene_of
from groundslab.views.scene.plan import plan_of
from groundslab.views.tables.quantities import nodal_values
from helpers import synthetic
from helpers.scenes import unpack, values_of

RAFT: dict[str, Any] = {
    "title": 'A raft </script><b>"&',
    "plate": {
        "outline": {"kind": "circle", "centre": (10, 0), "radius": 5},
        "openings": [{"kind": "rectangle", "x": (8, 9), "y": (-1, 1)}],
        "zones": [{"shape": {"kind": "rectangle", "x": (11, 12), "y": (0, 2)}, "E": 20e9}],
        "thickness": 0.5, "E": 30e9, "nu": 0.2,
    },
    "ground": {"kind": "vlasov", "layers": [{"E": 20e6, "nu": 0.3, "thickness": 4}]},
    "boreholes": [{"name": "B1", "x": 3, "y": 4, "layers": [{"E": 20e6, "nu": 0.3, "thickness": 4}]}],
    "contact": {"voids": [{"depth": 0.01, "x": (11, 12), "y": (-2, -1)},
                          {"shape": {"kind": "circle", "centre": (12, -2), "radius": 0.5}}]},
    "columns": [{"name": "A", "x": 10, "y": 3, "diameter": 0.4}, {"name": "B", "x": 7, "y": 0, "width_x": 0.4,
                                                                  "width_y": 0.6}],
    "supports": [
        {"kind": "point", "name": "pile", "x": 10, "y": -3, "stiffness": 5e7, "acts": "in compression"},
        {"kind": "line", "points": [(12, 1), (13, 1), (13, 2)]},
    ],
    "cases": [{"name": "G"}],
    "loads": [
        {"kind": "uniform", "q": 1e4, "case": "G"},
        {"kind": "patch", "q": 2e4, "slope": (1e3, 0), "x": (9, 10), "y": (2, 3), "case": "G"},
        {"kind": "area", "q": 3e4, "shape": {"kind": "circle", "centre": (10, -2), "radius": 1}, "case": "G"},
        {"kind": "line", "q": 4e4, "q_end": 1e4, "points": [(7, 2), (8, 2)], "case": "G"},
        {"kind": "point", "P": 2e5, "M_x": 1e4, "column": "B", "case": "G"},
        {"kind": "point", "P": 0, "M_y": 2e4, "x": 12, "y": 3, "width_x": 0.2, "width_y": 0.4, "case": "G"},
        {"kind": "self weight", "unit_weight": 25e3, "case": "G"},
        {"kind": "temperature", "difference": 10, "case": "G"},
        {"kind": "settlement", "support": "pile", "w": 5e-3, "case": "G"},
    ],
    "output": {
        "points": [{"name": "P", "x": 10, "y": 0}],
        "lines": [{"name": "L", "start": (6, 0), "end": (14, 0)}],
        "strips": [{"name": "S", "start": (6, 2), "end": (14, 2), "width": 1}],
    },
}  # fmt: skip


def area(ring: list[list[float]]) -> float:
    """Return the area in a closed polyline, positive if counterclockwise."""
    x, y = np.array(ring).T
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


class TestPlan:
    """What stands in plan, without any result."""

    def test_curves(self) -> None:
        """Curves are closed polylines within the chord error; circles keep their area to that, bounds are exact."""
        plan = plan_of(Model(**RAFT))
        assert plan["bounds"] == [5, -5, 15, 5]
        outline = np.array(plan["outline"])
        assert np.hypot(*(outline - [10, 0]).T) == pytest.approx(5)
        middles = (outline + np.roll(outline, -1, axis=0)) / 2
        assert np.hypot(*(middles - [10, 0]).T).min() >= 5 - 2e-4 * 10
        assert area(plan["openings"][0]["ring"]) == pytest.approx(2)
        assert plan["zones"][0] == {
            "path": "plate.zones[1]", "ring": [[11, 0], [12, 0], [12, 2], [11, 2]], "thickness": 0.5,
        }  # fmt: skip
        assert [area(each["ring"]) for each in plan["voids"]] == pytest.approx([1, np.pi / 4], rel=1e-3)
        assert area(plan["columns"][1]["ring"]) == pytest.approx(0.24)

    def test_a_pit_has_its_level_and_walls(self) -> None:
        """Its shape is that of their axes; its thickness is the plate's where it has none."""
        pit = {"shape": {"kind": "rectangle", "x": (0, 1), "y": (0, 1)}, "level": -1.2, "wall": 0.3}
        slab = {"length_x": 6, "length_y": 4, "thickness": 0.4, "E": 30e9, "nu": 0.2, "zones": [pit]}
        (zone,) = plan_of(Model(plate=slab, ground=RAFT["ground"], loads=[{"kind": "uniform", "q": 1e4}]))["zones"]
        assert (zone["thickness"], zone["level"], zone["wall"]) == (0.4, -1.2, 0.3)

    def test_things_have_paths_names_and_places(self) -> None:
        """Paths count from 1, as issues do; a load on a column stands where the column stands."""
        plan = plan_of(Model(**RAFT))
        assert [each["path"] for each in plan["columns"]] == ["columns[1]", "columns[2]"]
        assert plan["boreholes"] == [{"path": "boreholes[1]", "name": "B1", "x": 3, "y": 4}]
        pile, wall = plan["supports"]
        assert pile == {
            "path": "supports[1]", "name": "pile", "kind": "point", "points": [[10, -3]], "acts": "in compression",
            "elastic": True,
        }  # fmt: skip
        assert (wall["points"], wall["acts"], wall["elastic"]) == ([[12, 1], [13, 1], [13, 2]], "both ways", False)
        assert plan["loads"][4]["points"] == [[7, 0]]
        assert "footprint" not in plan["loads"][4]
        assert plan["thickness"] == 0.5
        assert area(plan["loads"][5]["footprint"]) == pytest.approx(0.08)
        assert plan["loads"][8]["points"] == [[10, -3]]
        assert area(plan["loads"][0]["ring"]) == area(plan["outline"])
        assert plan["lines"] == [{"path": "output.lines[1]", "name": "L", "start": [6, 0], "end": [14, 0]}]
        assert plan["strips"][0]["width"] == 1
        assert plan["points"] == [{"path": "output.points[1]", "name": "P", "x": 10, "y": 0}]

    def test_loads_say_how_large_they_are(self) -> None:
        """Each kind has its letters, values and units, and says so where it varies."""
        loads = plan_of(Model(**RAFT))["loads"]
        assert [load["parts"] for load in loads] == [
            [["q", 10, "kPa"]],
            [["q", 20, "kPa"]],
            [["q", 30, "kPa"]],
            [["q", 40, "kN/m"], ["q_end", 10, "kN/m"]],
            [["P", 200, "kN"], ["M_x", 10, "kNm"], ["M_y", 0, "kNm"]],
            [["P", 0, "kN"], ["M_x", 0, "kNm"], ["M_y", 20, "kNm"]],
            [["gamma_c", 25, "kN/m^3"]],
            [["dT", 10, "K"]],
            [["w_s", 5, "mm"]],
        ]
        assert ["varies" in load for load in loads] == [False, True, *[False] * 7]

    def test_zones_of_soil(self) -> None:
        """Zones of soil are reported by their curves."""
        zone = {"shape": {"kind": "rectangle", "x": (0, 1), "y": (0, 2)}, "ground": {"kind": "winkler", "k": 1e7}}
        plan = plan_of(synthetic.model().replace(soil_zones=[zone]))
        assert plan["soil_zones"] == [{"path": "soil_zones[1]", "ring": [[0, 0], [1, 0], [1, 2], [0, 2]]}]

    def test_json_can_hold_it(self) -> None:
        """The plan of a whole raft goes through JSON unchanged."""
        plan = plan_of(Model(**RAFT))
        assert json.loads(json.dumps(plan, allow_nan=False)) == plan


def fields(scene: Scene, number: int) -> dict[str, np.ndarray]:
    """Return the fields of a combination, as a browser would read them."""
    return {name: values_of(scene, block) for name, block in scene.head["combinations"][number - 1]["values"].items()}


class TestScene:
    """Solved models."""

    def test_fields_are_the_results(self) -> None:
        """Every field is the result's in units of display, to half a level of its range; so are mesh and extremes."""
        results = synthetic.results(3, shear=True)
        scene = unpack(pack(scene_of(results_of(results))))
        plate = results.plate
        assert np.array_equal(values_of(scene, scene.head["mesh"]["elements"]), plate.elements)
        assert np.array_equal(values_of(scene, scene.head["mesh"]["section"]), results.elements.section)
        mesh = scene.head["mesh"]
        nodes = values_of(scene, mesh["nodes"]) + mesh["origin"]
        assert nodes == pytest.approx(plate.nodes, rel=1e-7, abs=1e-7)
        found = fields(scene, 1)
        reported = {field["name"]: field for field in scene.head["fields"]}
        assert list(found) == list(reported)
        assert set(reported) == set(PLATE_FIELDS) - {"penetration"} | {"contact"}
        for name in set(found) - {"contact"}:
            exact = getattr(plate, name) * PLATE_FIELDS[name].scale
            assert np.abs(found[name] - exact).max() <= np.ptp(exact) / LEVELS * 0.5000001, name
            assert reported[name]["unit"] == PLATE_FIELDS[name].unit
            extremes = scene.head["combinations"][0]["extremes"][name]
            there = exact[plate.edge_length > 0] if name == "line_force" else exact
            assert (extremes["min"][0], extremes["max"][0]) == (there.min(), there.max())
        assert np.array_equal(found["contact"] < 0, plate.in_contact)
        assert found["contact"] == pytest.approx(contact_function(results), abs=np.abs(found["contact"]).max() / LEVELS)

    def test_fields_of_several_combinations_are_sums(self) -> None:
        """Sums of two fields take two blocks and come back; fields with nothing in common are put each by itself."""
        rng = np.random.default_rng(7)
        first, second = rng.normal(size=(2, 4000))
        sums = np.array([first, 2e6 * second, 3 * first - second, 1e-9 * (first + second), 0 * first + 1e200])
        blocks = Blocks()
        put = put_fields(blocks, sums)
        scene = Scene({}, blocks.data)
        assert len(blocks.data) <= 3 * 2 * 4000
        for block, exact in zip(put, sums, strict=True):
            assert np.abs(values_of(scene, block) - exact).max() <= np.ptp(exact) / PART
        lifted = np.maximum(np.array([first, second, first + second, 2 * first + second]), 0.0)
        blocks = Blocks()
        put = put_fields(blocks, lifted)
        for block, exact in zip(put, lifted, strict=True):
            assert np.array_equal(values_of(Scene({}, blocks.data), block) == 0, exact <= np.ptp(exact) / LEVELS / 2)
        apart = rng.normal(size=(3, 4000))
        blocks = Blocks()
        put = put_fields(blocks, apart)
        for block, exact in zip(put, apart, strict=True):
            assert np.abs(values_of(Scene({}, blocks.data), block) - exact).max() <= np.ptp(exact) / LEVELS * 0.5000001

    def test_the_discretization_error_is_a_field_where_all_have_it(self) -> None:
        """In percent at the nodes, never signed; without a comparison it is missing."""
        results = synthetic.compared(synthetic.results(3))
        scene = unpack(pack(scene_of(results_of(results))))
        about = next(field for field in scene.head["fields"] if field["name"] == "discretization_error")
        assert (about["symbol"], about["unit"], about["signed"]) == ("rho_e", "%", False)
        exact = nodal_values(results, "discretization_error")
        assert exact.max() == pytest.approx(3.0)
        assert np.abs(fields(scene, 1)["discretization_error"] - exact).max() <= 3.0 / LEVELS
        assert scene.head["combinations"][0]["extremes"]["discretization_error"]["max"][0] == exact.max()
        combined = synthetic.combined()
        some = {**combined.results, "NUL": synthetic.compared(combined["NUL"])}
        names = [field["name"] for field in scene_of(replace(combined, results=some)).head["fields"]]
        assert "discretization_error" not in names

    def test_the_edge_line_force_has_extremes_where_there_is_one(self) -> None:
        """They are those along the edge, beside those of the pressure, which knows nothing of them."""
        found = scene_of(results_of(synthetic.results(4, shear=True))).head["combinations"][0]["extremes"]
        assert found["pressure"]["max"] == pytest.approx([synthetic.K0 * 0.028 / 1e3, 0, 0])
        assert found["line_force"]["max"][0] == 500
        assert "line_force" not in scene_of(results_of(synthetic.results(4))).head["combinations"][0]["extremes"]

    def test_signs(self) -> None:
        """Moments are always signed; settlements and pressures only where one of them is negative."""
        lifted, pressed = (scene_of(results_of(synthetic.results(lifts=lifts))).head for lifts in (True, False))
        reported = [{field["name"]: field["signed"] for field in head["fields"]} for head in (lifted, pressed)]
        assert [each["settlement"] for each in reported] == [True, False]
        assert [each["pressure"] for each in reported] == [False, False]
        assert [each["moment_x"] for each in reported] == [True, True]

    def test_ground_that_yields_shows_how_far(self) -> None:
        """Penetration is a field where there is any."""
        plain = synthetic.results()
        sunk = replace(plain, plate=replace(plain.plate, penetration=np.maximum(plain.plate.settlement, 0)))
        assert "penetration" in fields(scene_of(results_of(sunk)), 1)

    def test_combinations_with_and_without_a_result(self) -> None:
        """Each says what acts, its values, and why it is refused; one that is not certified is not called so."""
        head = scene_of(synthetic.combined()).head
        assert [each["certified"] for each in head["combinations"]] == [True, True, False, False]
        assert [each["values"] is not None for each in head["combinations"]] == [True, True, True, False]
        assert head["combinations"][0]["factors"] == [["dead", 1.35], ["wind", 1.5]]
        assert head["combinations"][0]["refused"] is None
        assert "does not satisfy" in head["combinations"][2]["refused"]
        assert head["combinations"][3]["refused"] == "FOUNDATION FAILS: the loads pull the plate off"
        assert head["combinations"][3]["extremes"] == {}
        assert head["left_out"] == []

    def test_few_of_many(self) -> None:
        """Of too many combinations those that govern are kept, and the others named; their extremes stay."""
        combined = synthetic.combined()
        whole = scene_of(combined)
        head = scene_of(combined, most=1).head
        kept = [each["name"] for each in head["combinations"] if each["values"] is not None]
        assert kept == ["NUL"]
        assert head["left_out"] == ["Größe 1/2: dead + wind", "uncertified"]
        assert [each["extremes"] for each in head["combinations"]] == [
            each["extremes"] for each in whole.head["combinations"]
        ]
        two = scene_of(combined, most=2).head
        assert two["left_out"] == ["uncertified"]

    def test_without_any_result_the_plan_is_left(self) -> None:
        """If all combinations are refused the scene has no mesh, but its plan and the reasons."""
        model = synthetic.model()
        combined = synthetic.combined()
        (refusal,) = [error for name, error in combined.refused.items() if name == "wind alone"]
        none = Results(combined.model, combined.combinations[3:], {}, {"wind alone": refusal})
        head = scene_of(none).head
        assert head["mesh"]["nodes"]["shape"] == [0, 2]
        assert head["plan"]["outline"] == plan_of(model)["outline"]

    def test_different_meshes_have_no_common_picture(self) -> None:
        """Results on different meshes are refused rather than drawn wrongly."""
        combined = synthetic.combined()
        other = synthetic.results(3, model=combined.model, combination="NUL")
        with pytest.raises(GroundslabError, match="different meshes"):
            scene_of(replace(combined, results=combined.results | {"NUL": other}))

    def test_numbers_that_are_none_are_refused(self) -> None:
        """A result that holds no finite number is not drawn."""
        plain = synthetic.results()
        broken = replace(plain, plate=replace(plain.plate, gap=np.full_like(plain.plate.gap, np.nan)))
        with pytest.raises(GroundslabError, match="not finite"):
            scene_of(results_of(broken))


class TestPacking:
    """Bytes."""

    def test_layout(self) -> None:
        """Length, head, zeros, data; all offsets are multiples of 8, within the file too."""
        model = synthetic.model(title='</script>"\u2028é').replace(loads=[UniformLoad(q=1.0, name="Größe")])
        scene = scene_of(results_of(synthetic.results(model=model)))
        content = pack(scene)
        length = int.from_bytes(content[:4], "little")
        assert json.loads(content[4 : 4 + length].decode()) == scene.head
        assert content.endswith(scene.data)
        assert (len(content) - len(scene.data)) % 8 == 0
        assert not any(content[4 + length : len(content) - len(scene.data)])
        mesh = {name: block for name, block in scene.head["mesh"].items() if name != "origin"}
        blocks = [*mesh.values(), *scene.head["combinations"][0]["values"].values()]
        assert [block["offset"] % 8 for block in blocks] == [0] * len(blocks)
        assert unpack(content) == scene

    def test_the_same_results_give_the_same_bytes(self) -> None:
        """Nothing in a scene depends on when it was made."""
        assert pack(scene_of(synthetic.combined())) == pack(scene_of(synthetic.combined()))

    @pytest.mark.parametrize("values", [[3.0, 3.0], [0.0, 0.0], [-1e-290, 1e300], [5e-324, 0.0], []])
    def test_odd_ranges(self, values: list[float]) -> None:
        """Constant, empty and extreme ranges are kept; the least value exactly."""
        blocks = Blocks()
        block = blocks.put_range(np.array(values))
        found = values_of(Scene({}, blocks.data), block)
        if values:
            assert found.min() == min(values)
            assert np.abs(found - values).max() <= np.ptp(values) / LEVELS + 1e-300

    @pytest.mark.parametrize(
        "values", [[-1e-9, 1.0], [1e-9, -1.0], [-5e-324, 1e300], [1.0, 2.0], [-1.0, -1.0], [5e-324], []]
    )
    def test_signs_survive(self, values: list[float]) -> None:
        """A tiny value beside a huge one keeps its sign, on which the contact boundary hangs."""
        blocks = Blocks()
        block = blocks.put_signed(np.array(values))
        found = values_of(Scene({}, blocks.data), block)
        assert np.array_equal(np.sign(found), np.sign(values))
        if values:
            assert np.abs(found - values).max() <= np.abs(values).max() / LEVELS * 1.0001 + 1e-300
