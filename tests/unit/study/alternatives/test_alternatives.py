"""Alternatives to a design: what is tried, with quantities by hand and utilizations of the case that is written."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

import groundslab
from groundslab.analysis.driver import solve
from groundslab.case import casefile
from groundslab.case.editing.case_text import CaseText
from groundslab.cli import main
from groundslab.design.bars.proposal.propose import BarProposal
from groundslab.design.checks import check_design
from groundslab.errors import InputError
from groundslab.study.alternatives import comparison as module
from groundslab.study.alternatives.comparison import (
    DesignAlternative,
    DesignComparison,
    compare_designs,
    compare_texts,
)
from groundslab.study.alternatives.proposals import drop_panels, other_thicknesses, thickness_step
from groundslab.study.alternatives.rows import layout_rows, rows, to_json
from groundslab.unit_systems import INCH
from helpers.combinations import few
from helpers.paths import EXAMPLES

#: Two columns on a raft of 8 m x 5 m x 0.5 m, thicker over 1.1 m x 5 m at the left; one of them needs links.
RAFT = """\
# A raft under two columns
[plate]
length_x = "8 m"
length_y = "5 m"
thickness = "500 mm"   # first guess
E = "33 GPa"
nu = 0.2

[[plate.zones]]
thickness = "0.6 m"
shape = {kind = "rectangle", x = ["-4 m", "-2.9 m"], y = ["-2.5 m", "2.5 m"]}

[ground]
kind = "winkler"
k = "25 MPa/m"

[mesh]
size = "1 m"

[reinforcement]
f_ck = "30 MPa"   # C30/37
f_yk = "500 MPa"
bottom = ["50 mm", "66 mm"]
top = ["50 mm", "66 mm"]
proposal = {diameters = ["16 mm", "20 mm"], spacings = ["100 mm", "150 mm"], most_zones = 1}

[[columns]]
name = "A"
x = "-1 m"
y = "0 m"
width_x = "0.4 m"
width_y = "0.4 m"

[[columns]]
name = "B"
x = "2 m"
y = "0 m"
width_x = "0.6 m"
width_y = "0.6 m"

[[cases]]
name = "G"

[[combinations]]
name = "ultimate"
factors = {G = 1.35}

[[loads]]
case = "G"
kind = "point"
column = "A"
P = "1800 kN"

[[loads]]
case = "G"
kind = "point"
column = "B"
P = "900 kN"
"""
NOTE = "no links at A: the slab is thinner than 200 mm, too thin for links (9.3.2(1))"
#: The same without bars.
PLAIN = RAFT[: RAFT.index("[reinforcement]")] + RAFT[RAFT.index("[[columns]]") :]


@cache
def raft() -> DesignComparison:
    """Return the comparison of the raft."""
    return compare_texts(RAFT, None)


@pytest.mark.slow
def test_concrete_is_that_by_hand() -> None:
    """Of zones and slab, which change together; of drop panels, 2 x 50 mm over the column and 2 x 0.6 m beyond it."""
    drawn = 8 * 5 * 0.5 + 1.1 * 5 * 0.1
    panel = (0.4 + 2 * 1.2) ** 2 * 0.1
    expected = {
        "as drawn": drawn,
        "bars proposed": drawn,
        "50 mm thinner": drawn - 40 * 0.05,
        "50 mm thicker": drawn + 40 * 0.05,
        "100 mm thicker": drawn + 40 * 0.1,
        "drop panels, 100 mm": drawn + panel,
    }
    assert {each.name: each.concrete for each in raft().alternatives} == pytest.approx(expected)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["50 mm thicker", "drop panels, 100 mm"])
def test_utilizations_are_those_of_the_case_that_is_written(name: str) -> None:
    """Its text, solved and checked by itself, has the utilizations, the status and the settlement that are listed."""
    alternative = raft()[name]
    results = solve(casefile.loads(alternative.text))
    design = check_design(results)
    used = dict[str, float]()
    for check in design.checks:
        if check.utilization is not None:
            used[check.name] = max(check.utilization, used.get(check.name, 0.0))
    assert alternative.utilizations == pytest.approx(used)
    assert alternative.status == design.status
    assert ("punching around thicker zones within 2 d" in used) == name.startswith("drop panels")
    assert alternative.settlement == pytest.approx(results.plate.settlement.max())


@pytest.mark.slow
def test_bars_change_the_stiffness_of_cracked_slabs(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where concrete cracks, what is listed is of the slab with the bars that are proposed."""
    monkeypatch.setattr(module, "drop_panels", lambda *_: None)
    only(monkeypatch)
    comparison = compare_designs(few(casefile.load(EXAMPLES / "cracked_footing.toml")).replace(mesh={"size": 0.5}))
    alternative = comparison["bars proposed"]
    results = solve(casefile.loads(alternative.text))
    largest = max(each.plate.settlement.max() for each in results.values())
    assert alternative.settlement == pytest.approx(largest)
    assert comparison["as drawn"].settlement != pytest.approx(largest, rel=1e-3)


def only(monkeypatch: pytest.MonkeyPatch, *names: str) -> None:
    """Let slabs of no other thicknesses be tried."""
    monkeypatch.setattr(
        module, "other_thicknesses", lambda *case: [each for each in other_thicknesses(*case) if each.name in names]
    )


def with_panels(text: str) -> groundslab.Model:
    """Return the slab with drop panels where it needs links, which is not solved again.

    Its loads are larger: without bars that are laid, as many are reckoned with as count against punching.
    """
    text = text.replace('"1800 kN"', '"2600 kN"')
    document = CaseText(text, casefile.tables(text))
    proposal = drop_panels(solve(casefile.loads(text)), document.data)
    assert proposal is not None
    for path, value in proposal.edits:
        document.set(path, value)
    return casefile.loads(document.text)


@pytest.mark.slow
def test_drop_panels_never_thin_the_slab() -> None:
    """Beside a thicker zone they are thicker than that, too, where they cover it."""
    zone = 'thickness = "0.6 m"\nshape = {kind = "rectangle", x = ["-4 m", "-2.9 m"]'
    text = RAFT.replace(zone, zone.replace("0.6 m", "0.9 m").replace("-2.9 m", "-2 m"))
    assert text != RAFT
    zone_of_panel = with_panels(text).plate.zones[1]
    assert zone_of_panel.thickness == pytest.approx(1.0)


@pytest.mark.slow
def test_drop_panels_are_on_the_plate_of_their_column() -> None:
    """A column on a second plate has its panel in that plate's zones."""
    joined = RAFT.replace(
        'length_x = "8 m"\nlength_y = "5 m"\n',
        'name = "left"\noutline = {kind = "rectangle", x = ["-12 m", "-4 m"], y = ["-2.5 m", "2.5 m"]}\n',
    )
    zone = joined.index("[[plate.zones]]"), joined.index("[ground]")
    second = """[[plates]]
name = "right"
outline = {kind = "rectangle", x = ["-4 m", "4 m"], y = ["-2.5 m", "2.5 m"]}
thickness = "500 mm"
E = "33 GPa"
nu = 0.2

[[joints]]
between = ["left", "right"]
kind = "hinge"

"""
    weight = '\n[[loads]]\ncase = "G"\nkind = "uniform"\nq = "10 kPa"\n'
    model = with_panels(joined[: zone[0]] + second + joined[zone[1] :] + weight)
    assert model.plate.zones == ()
    (panel,) = model.plates[0].zones
    assert panel.thickness == pytest.approx(0.6)


def test_notes_are_in_every_output() -> None:
    """What a reader must know of an alternative is in the table and in JSON."""
    known = DesignAlternative("drop panels", "Drop panels", "", 1.0, None, None, 0, {}, 0.0, "attention")
    alternative = replace(known, notes=(NOTE,))
    comparison = DesignComparison(casefile.loads(PLAIN), (alternative,))
    assert f"{NOTE}." in layout_rows(comparison).notes
    assert NOTE in to_json(comparison)["alternatives"][0]["notes"]


@pytest.mark.slow
def test_one_without_bars_does_not_end_the_comparison(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where none are found for one alternative, it is named and the others are there."""
    only(monkeypatch, "50 mm thicker")
    monkeypatch.setattr(module, "drop_panels", lambda *_: None)
    propose = module.propose_bars

    def refuse_drawn(results: groundslab.Results) -> BarProposal:
        if results.model.plate.thickness == 0.5:
            raise groundslab.GroundslabError("no bars were found")
        return propose(results)

    monkeypatch.setattr(module, "propose_bars", refuse_drawn)
    comparison = compare_texts(RAFT, None)
    assert "50 mm thicker" in {each.name for each in comparison.alternatives}
    assert any("no bars were found" in note for note in comparison.notes)


@pytest.mark.slow
def test_texts_keep_what_is_not_changed() -> None:
    """The first is the case itself; others keep comments and units, change thicknesses, and have bars."""
    assert raft()["as drawn"].text == RAFT
    text = raft()["50 mm thicker"].text
    for line in ("# A raft under two columns", 'thickness = "550 mm"   # first guess', 'f_ck = "30 MPa"   # C30/37'):
        assert line in text
    model = casefile.loads(text)
    assert (model.plate.thickness, model.plate.zones[0].thickness) == (0.55, 0.65)
    assert model.reinforcement is not None
    assert model.reinforcement.laid
    panel = casefile.loads(raft()["drop panels, 100 mm"].text).plate.zones[1]
    assert panel.thickness == pytest.approx(0.6)
    assert panel.shape.ring().bounds == pytest.approx((-2.4, 0.4, -1.4, 1.4))


@pytest.mark.slow
def test_thicker_slabs_punch_less() -> None:
    """With the links that are proposed punching holds; no more columns need some as the slab gets thicker."""
    names = ("50 mm thinner", "bars proposed", "50 mm thicker", "100 mm thicker")
    assert all(raft()[name].utilizations["punching within 2 d"] <= 1 for name in names)
    places = [raft()[name].places_of_links for name in names]
    assert places == sorted(places, reverse=True)
    assert raft()["bars proposed"].places_of_links == 1


@pytest.mark.slow
def test_rows_have_a_cell_for_each_alternative() -> None:
    """Bad cells are those of failing checks and of what exceeds its limit."""
    count = len(raft().alternatives)
    for row in rows(raft()):
        assert len(row.cells) == len(row.bad) == count
    outcome, concrete, *_ = rows(raft())
    assert list(outcome.bad) == [each.status == "fails" for each in raft().alternatives]
    assert concrete.cells[0] == "20.55"
    assert len(layout_rows(raft()).heads) == count + 2


def test_steps_are_a_tenth_in_round_numbers() -> None:
    """50 mm or 2 in, more for thick slabs; thin ones are not made thinner than they can be; all plates change."""
    data = casefile.tables(RAFT)
    model = casefile.loads(RAFT)
    assert thickness_step(model) == 0.05
    thick = model.replace(plate=model.plate.replace(thickness=1.4))
    assert thickness_step(thick) == pytest.approx(0.15)
    customary = casefile.loads(RAFT + '[project]\nunits = "US"\n')
    assert thickness_step(customary) == pytest.approx(2 * INCH)
    thin = PLAIN.replace('"500 mm"', '"60 mm"').replace('"0.6 m"\nshape', '"70 mm"\nshape')
    names = [each.name for each in other_thicknesses(casefile.loads(thin), casefile.tables(thin))]
    assert names == ["50 mm thicker", "100 mm thicker"]
    edits = next(iter(other_thicknesses(model, data))).edits
    assert edits == ((("plate", "thickness"), "450 mm"), (("plate", "zones", 0, "thickness"), "0.55 m"))


def test_without_reinforcement_there_is_concrete_alone() -> None:
    """Neither bars nor links are counted, which is said."""
    comparison = compare_texts(PLAIN, None)
    assert [each.bars for each in comparison.alternatives] == [None] * 4
    assert any("reinforcement" in note for note in comparison.notes)
    assert all(row.label != "links" for row in rows(comparison))


def test_alternatives_without_a_result_are_named(monkeypatch: pytest.MonkeyPatch) -> None:
    """One that cannot be solved is left out with its reason; if the slab as drawn cannot be, that is the error."""
    floating = RAFT.replace("1800 kN", "-1800 kN").replace("900 kN", "-900 kN")
    with pytest.raises(groundslab.NoEquilibrium):
        compare_texts(floating, None)

    def refuse_thicker(model: groundslab.Model) -> groundslab.Results:
        if model.plate.thickness > 0.5:
            raise groundslab.NoResult("too stiff")
        return solve(model)

    monkeypatch.setattr(module, "solve", refuse_thicker)
    compared = compare_texts(PLAIN, None)
    assert [each.name for each in compared.alternatives] == ["as drawn", "50 mm thinner"]
    assert sum("too stiff" in note for note in compared.notes) == 2


@pytest.mark.slow
def test_command(tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    """It prints a table or JSON, and writes the case with the alternative that is taken."""
    monkeypatch.setattr(module, "compare_texts", lambda text, *_: {RAFT: raft}[text]())
    case, target = tmp_path / "raft.toml", tmp_path / "thicker.toml"
    case.write_text(RAFT, encoding="utf-8")
    command = ["compare-designs", str(case)]
    assert main.main([*command, "--take", "50 mm thicker"]) == 2
    assert main.main([*command, "--take", "50 mm thicker", "-o", str(target), "--json"]) == 0
    shown = json.loads(capsys.readouterr().out)
    assert [each["name"] for each in shown["alternatives"]][:2] == ["as drawn", "bars proposed"]
    assert groundslab.load(target).plate.thickness == 0.55
    assert main.main([*command, "--take", "thicker", "-o", str(tmp_path / "other.toml")]) == 2
    out, err = capsys.readouterr()
    assert "concrete" in out
    assert "50 mm thicker" in err


def test_a_model_is_compared_like_its_file(tmp_path: Path) -> None:
    """Names, and a file that does not exist."""
    with pytest.raises(InputError):
        compare_designs(tmp_path / "none.toml")
    model = casefile.loads(PLAIN)
    path = tmp_path / "raft.toml"
    path.write_text(casefile.to_toml(model), encoding="utf-8")
    assert compare_designs(model) == compare_designs(path)


def test_what_hangs_on_the_error_is_told() -> None:
    """0.93 that may be 2.91 within the error of a draft is no bare 0.93."""
    about = {
        "words": "",
        "text": "",
        "concrete": 1.0,
        "bars": 1.0,
        "links": 0.0,
        "places_of_links": 0,
        "settlement": 0.0,
    }
    sure = DesignAlternative(name="a", utilizations={"bars": 0.9}, status="no failure found", **about)
    open_ = replace(sure, name="b", within_error={"bars": 2.91}, utilizations={"bars": 0.93})
    failing = replace(open_, name="c", status="fails")
    assert [each.verdict for each in (sure, open_, failing)] == [
        "no failure found", "no failure found, but within the error", "fails"
    ]  # fmt: skip
    compared = DesignComparison(casefile.loads(PLAIN, "plain"), (sure, open_, failing))
    last = rows(compared)[-1]
    assert (last.label, last.cells) == ("bars", ("0.90", "0.93 to 2.91", "0.93 to 2.91"))
    assert to_json(compared)["alternatives"][1]["within_error"] == {"bars": 2.91}
