"""The lock files hold all that the packages in them need: with hashes, pip refuses what is missing."""

from __future__ import annotations

import re
from importlib import metadata

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from helpers.paths import ROOT

LOCKED = re.compile(r"^([A-Za-z0-9_.-]+)(?:\[.*\])?==", re.MULTILINE)


@pytest.mark.parametrize("name", ["run", "image", "dev"])
def test_it_holds_what_its_packages_need(name: str) -> None:
    """Each package that one in the file requires on this machine is in the file, too."""
    path = ROOT / "lock" / f"{name}.txt"
    if not path.is_file():
        pytest.skip("there are no lock files")
    locked = {canonicalize_name(each) for each in LOCKED.findall(path.read_text(encoding="utf-8"))}
    known = {canonicalize_name(each.name): each for each in metadata.distributions()} if locked else {}
    needed = {
        (one, canonicalize_name(each.name))
        for one in locked & known.keys()
        for each in map(Requirement, known[one].requires or [])
        if each.marker is None or each.marker.evaluate({"extra": ""})
    }
    assert len(needed) > 20
    assert {(one, other) for one, other in needed if other not in locked} == set()
