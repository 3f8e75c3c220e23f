"""Folders of the repository."""

from __future__ import annotations

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
EXAMPLES = ROOT / "examples"
PACKAGE = ROOT / "src" / "groundslab"
DATA = ROOT / "tests" / "data"
#: Examples whose default answer takes long: tests solve them on large elements.
TAKE_LONG = {
    "bearing_walls", "grade_beams", "house_raft", "industrial_floor", "l_raft", "oblique_facade", "pad",
    "raft_on_continuum", "raft_under_a_frame", "raft_with_pit", "ribbed_raft", "second_generation", "tank", "void",
    "warehouse", "wind_turbine",
}  # fmt: skip
