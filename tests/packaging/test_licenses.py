"""No license that would bind whoever uses groundslab comes with it unasked, and the page on licenses is complete."""

from __future__ import annotations

import re
from importlib import metadata

import licenses
import pytest

from helpers.paths import DOCS

try:
    metadata.distribution(licenses.PACKAGE)
except metadata.PackageNotFoundError:
    pytest.skip("groundslab is not installed, so that its metadata are missing", allow_module_level=True)


def test_nothing_that_groundslab_itself_needs_is_under_the_gpl() -> None:
    """None of the required packages, direct or not, states the GPL as its license."""
    required = licenses.brought_along()
    assert {"numpy", "scipy", "matplotlib", "kiwisolver"} <= required
    assert not {name for name in required if licenses.is_gpl(name)}


@pytest.mark.parametrize(("name", "gpl"), [("gmsh", True), ("cvxopt", True), ("gstools", False), ("numpy", False)])
def test_the_gpl_is_told_from_the_lgpl_and_others(name: str, gpl: bool) -> None:
    """Gmsh's classifier and CVXOPT's own words are the GPL; the LGPL and the BSD license are not."""
    pytest.importorskip(name)
    assert licenses.is_gpl(name) is gpl


def test_the_page_has_every_package_that_is_required_or_an_extras_own() -> None:
    """The table of docs/licenses.md has each package that groundslab or one of its extras names."""
    page = (DOCS / "licenses.md").read_text(encoding="utf-8")
    listed = set(re.split(r", ", ", ".join(re.findall(r"^\| .+ \| .+ \| (.+) \|$", page, re.MULTILINE))))
    named = {licenses.Requirement(text) for text in metadata.requires(licenses.PACKAGE) or []}
    names = {licenses.canonicalize_name(each.name) for each in named} - {licenses.PACKAGE}
    assert len(names) > 20
    assert not names - listed
