"""Examples written as files of the Structural Analysis Format, read, and solved: the results are the same."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.exchange.saf.writing.writer import write_model
from groundslab.model.combinations import as_solved, list_combinations
from groundslab.model.plates.pits import pits_of
from helpers.paths import EXAMPLES

pytest.importorskip("openpyxl")

#: Parts that the format has no place for, and those that say nothing of settlements and moments: they are put back.
NO_PLACE = {"beyond", "boreholes", "building", "contact", "cracking", "ground", "long_term", "output", "reinforcement"}
SILENT = {"floor", "limits", "mesh", "soil_strength", "report"}
#: What else does not come back as it was, and why; it is put back, too.
OTHERS = {
    "piled_raft": ("supports", "piles of given stiffness have a gap and a limit"),
    "strip": ("soil_zones", "the zone reaches over the plate's edge, regions do not"),
}
#: Examples that do not come back whole, and why.
NOT_COMPARED = {
    "joined_bays": "two plates and the joint between them; one plate at a time is read",
    "neighbours": "two plates; one at a time is read",
    "raft_with_pit": "a pit, which is read as a zone at the slab's level, with all layers under it",
}
#: Examples of each kind of plan, structure, load and combination; of all of them the descriptions are compared, load by
#: load, where they are written.
COMPARED = (
    "bearing_walls", "boreholes", "grade_beams", "house_raft", "l_raft", "oblique_facade", "piled_raft",
    "raft_under_a_frame", "ribbed_raft", "strip", "tank", "us_mat", "void", "warehouse", "wind_turbine",
)  # fmt: skip
#: Largest differences, relative to the largest value of each field, and of the one example with a round footprint,
#: whose pressure balances the moment by other chords in place of its circle, and with a door, beside which loads of the
#: wall come as free lines without its thickness.
SAME, OTHER = 1e-9, {"wind_turbine": 2e-5, "bearing_walls": 2e-3}
#: Elements along the longer side.
COARSE = 3


def coarse(model: gs.Model) -> gs.Mesh:
    """Return a mesh on which a model is solved in about a second."""
    return gs.Mesh(size=max(model.plate.sides) / COARSE)


def put_back(model: gs.Model, path: Path, name: str) -> gs.Model:
    """Return what comes back of a model, with the parts that the format has no place for."""
    write_model(model, path, (12e6, 3e6))
    parts: dict[str, Any] = dict(gs.read_saf(path, model.plate.name or "S1").parts)
    plain = type(model).field_defaults
    whole = {part for part in NO_PLACE - {"ground"} if getattr(model, part) != plain[part]}
    if model.ground.kind not in ("winkler", "pasternak"):
        whole.add("ground")
    whole |= set(OTHERS.get(name, ())[:1])
    parts |= {part: getattr(model, part) for part in whole}
    # rectangles about the origin are plates by their sides, for which grids are made
    if model.plate.outline is not None and parts["plate"].outline is None:
        parts["plate"] = parts["plate"].replace(length_x=None, length_y=None, outline=model.plate.outline)
    return gs.Model(**parts, mesh=coarse(model))


def few(model: gs.Model) -> gs.Model:
    """Return a model with the last combination, and the first ones with cases that are in none of those taken."""
    placed = as_solved(model)
    taken, cases = list(placed.combinations[-1:]), set[str]()
    for combination in placed.combinations[-1:] + placed.combinations[:-1]:
        present = {name for name, factor in combination.factors if factor}
        taken += [combination] if not present <= cases and combination not in taken else []
        cases |= present
    return placed.model_copy(update={"combinations": tuple(taken)})


@pytest.mark.slow
@pytest.mark.parametrize("name", COMPARED)
def test_results_are_the_same(name: str, tmp_path: Path) -> None:
    """All combinations come back in their order, with settlements and moments of some of them on the same mesh."""
    # without ground beside the slab, of which more would be tried in vain
    model = gs.load(EXAMPLES / f"{name}.toml").replace(beyond={"kind": "none"})
    here = gs.Model(**{part: value for part, value in model if part not in SILENT}, mesh=coarse(model))
    there = put_back(model, tmp_path / "slab.xlsx", name)
    sums = [
        [(each.limit_state, {factor for _, factor in each.factors}) for each in list_combinations(of)]
        for of in (here, there)
    ]
    assert sums[0] == sums[1]
    before, after = gs.solve(few(here)), gs.solve(few(there))
    assert len(before) == len(after)
    tolerance = OTHER.get(name, SAME)
    for (combination, one), other in zip(before.items(), after.values(), strict=True):
        for field in ("settlement", "moment_x", "moment_y"):
            values, others = getattr(one.plate, field), getattr(other.plate, field)
            size = np.abs(values).max()
            assert np.abs(values - others).max() <= tolerance * size, (combination, field)


def test_those_that_are_not_compared_have_several_plates_or_a_pit() -> None:
    """Such an example is none of those that are."""
    assert not NOT_COMPARED.keys() & {*COMPARED}
    for name in NOT_COMPARED:
        plates = gs.load(EXAMPLES / f"{name}.toml").every_plate
        assert len(plates) > 1 or pits_of(plates[0])
