"""Repairs of issues: each one, applied to the text, removes its issue and brings no other."""

from __future__ import annotations

import json

import pytest

from groundslab.workbench.checking.parsing import check
from groundslab.workbench.editing.document import Document

PLATE = """\
[plate]
length_x = "6 m"
length_y = "4 m"
thickness = "250 mm"  # as on the drawing
E = "30 GPa"
nu = 0.2
"""
GROUND = '[ground]\nkind = "winkler"\nk = "20 MPa/m"\n'
LOADS = '[[loads]]\nkind = "uniform"\nq = "5 kPa"\n'
LAYER = '{E = "20 MPa", nu = 0.3, thickness = "4 m"}'
VLASOV = f'[ground]\nkind = "vlasov"\nlayers = [{LAYER}]\n'
CONTINUUM = f'[ground]\nkind = "continuum"\nlayers = [{LAYER}]\nhalf_space = {{E = "60 MPa", nu = 0.3}}\n'
BOREHOLE = f'[[boreholes]]\nx = "1 m"\ny = "1 m"\nlayers = [{LAYER}]\n'
CASES = '[[cases]]\nname = "dead"\n[[cases]]\nname = "live"\naction = "variable"\n'
TWO = 'name = "A"\n[[plates]]\nname = "B"\nthickness = "250 mm"\nE = "30 GPa"\nnu = 0.2\n[plates.outline]\n\
kind = "rectangle"\nx = ["3 m", "6 m"]\ny = ["-2 m", "2 m"]\n'
RECTANGLE = 'shape = {kind = "rectangle", x = ["0 m", "1 m"], y = ["0 m", "1 m"]}'
SUPPORT = '[[supports]]\nkind = "point"\nname = "S"\nx = "1 m"\ny = "1 m"\n'
COLUMN = '[[columns]]\nname = "C1"\nx = "1 m"\ny = "1 m"\nwidth_x = "400 mm"\nwidth_y = "400 mm"\n'


def write(plate: str = PLATE, ground: str = GROUND, loads: str = LOADS, more: str = "") -> str:
    """Return the text of a case."""
    return f"{plate}\n{ground}\n{loads}\n{more}"


#: What is wrong: the text, the place of the issue, and the labels of its repairs.
WRONG: dict[str, tuple[str, str, list[str]]] = {
    "misspelt key": (write(PLATE.replace("thickness", "thicknes")), "plate.thicknes",
                     ["rename to thickness", "remove thicknes"]),
    "misspelt table": (write(ground=GROUND.replace("[ground]", "[grund]")), "grund",
                       ["rename to ground", "remove grund"]),
    "unknown key": (write(PLATE + "colour = 3\n"), "plate.colour", ["remove colour"]),
    "key beside the right one": (write(PLATE + "thicknes = 3\n"), "plate.thicknes", ["remove thicknes"]),
    "number without unit": (write(PLATE.replace('"250 mm"', "0.25")), "plate.thickness", ["0.25 m", "0.25 mm"]),
    "text without unit": (write(loads=LOADS.replace("5 kPa", "5")), "loads[1].q", ["5 MPa", "5 Pa", "5 kPa", "5 GPa"]),
    "misspelt word": (write(more='[beyond]\nkind = "infinit"\n'), "beyond.kind", ['use "infinite"']),
    "misspelt kind": (write(loads=LOADS.replace("uniform", "unifrom")), "loads[1].kind", ['use "uniform"']),
    "one table for a list": (write(loads=LOADS.replace("[[loads]]", "[loads]")), "loads", ["make it a list"]),
    "width of no ground": (write(more='[beyond]\nwidth = "2 m"\n'), "beyond.width",
                           ["remove width", 'set kind to "margin"']),
    "edge of no margin": (write(more='[beyond]\nedge = "fixed"\n'), "beyond.edge", ["remove edge"]),
    "gap under glue": (write(more='[contact]\ntensionless = false\ngap = "1 mm"\n'), "contact.gap",
                       ["remove gap", "set tensionless to true"]),
    "limit under glue": (write(more='[contact]\ntensionless = false\nlimit_pressure = "1 MPa"\n'),
                         "contact.limit_pressure", ["remove limit_pressure", "set tensionless to true"]),
    "size and counts": (write(more='[mesh]\nsize = "1 m"\ncounts = [6, 4]\n'), "mesh",
                        ["remove counts", "remove size"]),
    "counts with supports": (write(more=f"[mesh]\ncounts = [6, 4]\n{SUPPORT}"), "mesh.counts", ["remove mesh.counts"]),
    "gap of a two-way support": (write(more=f'{SUPPORT}gap = "1 mm"\n'), "supports[1].gap",
                                 ["remove gap", 'set acts to "in compression"', 'set acts to "in tension"']),
    "name given twice": (write(more=SUPPORT + SUPPORT.replace('"1 m"', '"-1 m"')), "supports[2].name",
                         ['rename to "S 2"']),
    "unknown column": (write(loads='[[loads]]\nkind = "point"\nP = "9 kN"\ncolumn = "C2"\n', more=COLUMN),
                       "loads[1].column", ['use "C1"']),
    "unknown case": (write(loads=LOADS + 'case = "dad"\n', more=CASES), "loads[1].case",
                     ['use "dead"', 'add permanent load case "dad"', 'add variable load case "dad"']),
    "no case": (write(more=CASES), "loads[1].case", ['use "dead"', 'use "live"']),
    "case without cases": (write(loads=LOADS + 'case = "wind"\n'), "loads[1].case",
                           ['add permanent load case "wind"', 'add variable load case "wind"', "remove loads[1].case"]),
    "unknown case in factors": (
        write(loads=LOADS + 'case = "dead"\n',
              more=CASES + '[[combinations]]\nname = "1"\nfactors = {dead = 1.35, liv = 1.5}\n'),
        "combinations[1].factors.liv",
        ["rename to live", 'add permanent load case "liv"', 'add variable load case "liv"',
         "remove the factor"]),
    "combinations without cases": (write(more='[[combinations]]\nname = "1"\nfactors = {dead = 1.35}\n'),
                                   "combinations", ["remove combinations"]),
    "unknown plate": (write(PLATE + TWO, loads=LOADS + 'plate = "b"\n'), "loads[1].plate",
                      ['use "B"', "remove plate"]),
    "plate given twice": (write(PLATE + TWO.replace('name = "B"', 'name = "A"').replace('["3 m"', '["3.5 m"')),
                          "plates[1].name", ['rename to "A 2"']),
    "joint without plates": (write(more='[[joints]]\nkind = "hinge"\nbetween = ["A", "B"]\n'), "joints[1].between[1]",
                             ["remove the joint"]),
    "joint of an unknown plate": (
        write(PLATE + TWO, more='[[joints]]\nkind = "hinge"\nbetween = ["A", "BB"]\n'), "joints[1].between[2]",
        ['use "B"', "remove the joint"]),
    "boreholes in springs": (write(more=BOREHOLE), "boreholes", ["remove boreholes"]),
    "boreholes in a continuum": (write(ground=CONTINUUM, more=BOREHOLE), "boreholes", ["remove boreholes"]),
    "margin of a continuum": (write(ground=CONTINUUM, more='[beyond]\nkind = "margin"\nwidth = "2 m"\nedge = "fixed"'),
                              "beyond", ['set beyond.kind to "infinite"']),
    "no shear beside infinite ground": (
        write(ground='[ground]\nkind = "layered"\ncoupling = "interface"\nlayers = [\n{k0 = "20 MPa/m", '
              'k1 = "10 MN/m"},\n{k0 = "20 MPa/m", k1 = "0 MN/m"}]\n', more='[beyond]\nkind = "infinite"\n'),
        "ground.layers[2].k1", ['set beyond.kind to "none"']),
    "zones together with boreholes": (
        write(ground=VLASOV, more=BOREHOLE + f'[[soil_zones]]\n{RECTANGLE}\n'
              f'ground = {{kind = "vlasov", layers = [{LAYER}]}}\n'),
        "soil_zones", ["remove soil_zones", "remove boreholes"]),
    "formulas beside boreholes": (write(ground=VLASOV + 'formulas = "as printed"\n', more=BOREHOLE),
                                  "ground.formulas", ['set ground.formulas to "exact"']),
    "k twice": (write(ground=GROUND + 'selvadurai = {E = "20 MPa", depth = "5 m"}\n'), "ground",
                ["remove selvadurai", "remove k"]),
    "variation of nothing": (write(ground=VLASOV.replace('"4 m"', '"4 m", variation = "linear"')),
                             "ground.layers[1].variation", ["remove variation"]),
    "a diameter beside widths": (write(more=COLUMN + 'diameter = "400 mm"\n'), "columns[1].diameter",
                                 ["remove diameter", "remove width_x and width_y"]),
    "factors with ACI 318": (
        write(loads=LOADS + 'case = "dead"\n',
              more=CASES + '[combine]\nsets = ["ultimate"]\nexpression = "ACI 318"\nxi = 0.9\n'),
        "combine.xi", ["remove xi"]),
}  # fmt: skip


@pytest.mark.parametrize("name", WRONG)
def test_each_repair_removes_its_issue(name: str) -> None:
    """The issue is where it should be and offers these repairs; after each one it is gone, and nothing else is new."""
    text, location, labels = WRONG[name]
    before = check(Document(text)).issues_json
    [issue] = [each for each in before if each["location"] == location]
    assert [repair["label"] for repair in issue["repairs"]] == labels
    others = {(each["location"], each["expected"]) for each in before if each is not issue}
    for repair in issue["repairs"]:
        edits = json.loads(json.dumps(repair["edits"]))
        after = check(Document(text).apply(edits)).issues_json
        left = {(each["location"], each["expected"]) for each in after}
        assert (location, issue["expected"]) not in left, repair["label"]
        assert left <= others, repair["label"]


def test_a_renamed_key_keeps_its_comment() -> None:
    """Nothing of the text but the name changes, of keys and of tables that are scattered."""
    edit = {"op": "rename", "path": ["plate"], "value": "slab"}
    text = write(PLATE, more="[plate.outline]\nkind = 1\n[[plate.zones]]\n[plate.zones.shape]\n")
    assert Document(text).apply([edit]).text == text.replace("[plate", "[slab").replace("[[plate", "[[slab")
    dotted = "# first\nplate.outline.kind = 1\nplate.nu = 0.2  # here\n"
    assert Document(dotted).apply([edit]).text == dotted.replace("plate", "slab")
    key = {"op": "rename", "path": ["plate", "thickness"], "value": "depth"}
    assert Document(text).apply([key]).text == text.replace("thickness", "depth")
    inline = 'factors = {dead = 1.35, "a b" = 1.5}\n'
    pair = {"op": "rename", "path": ["factors", "a b"], "value": "c d"}
    assert Document(inline).apply([pair]).data == {"factors": {"dead": 1.35, "c d": 1.5}}


@pytest.mark.parametrize(
    "edit",
    [
        {"op": "rename", "path": [], "value": "a"},
        {"op": "rename", "path": ["nothing"], "value": "a"},
        {"op": "rename", "path": ["plate", "E"], "value": "nu"},
        {"op": "rename", "path": ["plate", "E"], "value": 3},
        {"op": "rename", "path": ["loads", 0], "value": "a"},
    ],
)
def test_what_cannot_be_renamed(edit: dict[str, object]) -> None:
    """Keys that are not there, names that are taken or none: refused, and nothing has changed."""
    from groundslab.errors import InputError

    with pytest.raises(InputError):
        Document(write()).apply([edit])
