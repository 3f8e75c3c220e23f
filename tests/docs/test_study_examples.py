"""The examples of studies: each can be read and solved, and the figures that their comments work out come out."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from groundslab.analysis.driver import solve
from groundslab.case.casefile import load
from groundslab.design.codes.en1992_2004.materials import Concrete
from groundslab.study.definition import files
from groundslab.study.evaluation.form import design_point, margin_of, values_of
from groundslab.study.execution.variant import Worker
from groundslab.study.sampling.designs import list_variants
from helpers.paths import EXAMPLES

STUDIES = EXAMPLES / "studies"
FILES = sorted(path for path in STUDIES.glob("*.toml") if "sampling" in path.read_text(encoding="utf-8"))
CASES = sorted({*STUDIES.glob("*.toml")} - {*FILES})


def test_there_are_studies() -> None:
    """The folder holds cases and studies, and every case belongs to one."""
    assert len(FILES) >= 4
    named = {re.search(r'^case = "(.*)"$', path.read_text(encoding="utf-8"), re.MULTILINE) for path in FILES}
    assert {match[1] for match in named if match} == {path.name for path in CASES}


@pytest.mark.parametrize("path", CASES, ids=lambda path: path.stem)
def test_cases_of_the_studies_are_solved(path: Path) -> None:
    """Every case has a certified result as it stands."""
    assert solve(load(path)).certificate.holds


@pytest.mark.slow
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_the_first_variant_is_solved(path: Path) -> None:
    """Every study can be read, its first variant has all results, and its command is in its comment."""
    setup = files.read(path).setup
    if setup.fields:
        pytest.importorskip("gstools")
    row = Worker(setup).row(list_variants(setup)[1])
    assert row.status == "solved", row.message
    assert all(value is not None and np.isfinite(value) for value in row.results)
    text = path.read_text(encoding="utf-8")
    assert f"groundslab study examples/studies/{path.name}" in text
    counts = re.findall(r"= (\d+) variants", text)
    assert all(int(count) == setup.count for count in counts)


def test_the_first_plate_is_that_of_the_paper() -> None:
    """The two stiffnesses are those which the soil of the first example comes down to, to the digits given."""
    soil = solve(load(STUDIES.parent / "table1.toml")).constants
    springs = load(STUDIES / "first_plate.toml")
    assert springs.ground.kind == "pasternak"
    assert springs.ground.k0 == pytest.approx(soil.k0[0], rel=2e-5)
    assert springs.ground.k1 == pytest.approx(soil.k1[0], rel=2e-5)
    paper = load(STUDIES.parent / "table1.toml")
    assert (springs.plate, springs.loads) == (paper.plate, paper.loads)


def test_crack_moments_of_the_warehouse() -> None:
    """The limits are f_ctm t^2 / 6 and the flexural strength's by EN 1992-1-1 3.1.3 and 3.1.8, rounded to 0.1 kNm/m."""
    setup = files.read(STUDIES / "warehouse_fields.toml").setup
    t = setup.model.plate.thickness
    f_ctm = 0.30 * 30 ** (2 / 3) * 1e6
    assert f_ctm == pytest.approx(Concrete(30e6).f_ctm, rel=1e-9)
    flexural = max(1.6 - t, 1.0) * f_ctm
    limits = {limit.name: limit.bound for limit in setup.limits}
    assert limits["top reaches f_ctm"] == pytest.approx(-f_ctm * t**2 / 6, abs=50)
    assert limits["bottom reaches f_ctm"] == pytest.approx(f_ctm * t**2 / 6, abs=50)
    assert limits["top reaches the flexural strength"] == pytest.approx(-flexural * t**2 / 6, abs=50)
    (limit,) = files.read(STUDIES / "warehouse_thickness.toml").setup.limits
    assert limit.bound == pytest.approx(f_ctm, rel=0.005)


@pytest.mark.slow
def test_the_design_point_that_the_page_quotes() -> None:
    """beta, probability, inputs and importance of the example are those of the page, digit for digit."""
    pytest.importorskip("openturns")
    setup = files.read(STUDIES / "first_plate_reliability.toml").setup
    (limit,) = setup.limits
    point = design_point(margin_of(setup, limit), setup.correlation)
    values = values_of(setup, point.scores)
    page = re.sub(r"\s+", " ", (STUDIES.parents[1] / "docs" / "study-results.md").read_text(encoding="utf-8"))
    assert f"first order, {point.solves} solutions | {point.probability:.4f} | beta = {point.beta:.3f} |" in page
    k0, k1, t, E = values
    assert f"k0 = {k0 / 1e6:.1f} MPa/m, k1 = {k1 / 1e6:.1f} MN/m, t = {t * 1e3:.0f} mm, E = {E / 1e9:.1f} GPa" in page
    shares = [f"{share * 100:.0f}" for share in point.importance]
    assert f"importance {', '.join(shares[:3])} and {shares[3]} %" in page


def test_the_warehouse_on_even_ground_as_the_page_quotes() -> None:
    """The moment in the aisles and the difference of settlements on even ground are those of the page."""
    plate = solve(load(STUDIES / "warehouse.toml")).plate
    page = (STUDIES.parents[1] / "docs" / "study-results.md").read_text(encoding="utf-8")
    moment, difference = -plate.moment_x.min() / 1e3, np.ptp(plate.settlement) * 1e3
    assert f"the moment in the aisles is {moment:.1f} kNm/m and the difference {difference:.1f} mm" in page


def test_the_warehouse_mesh_is_fine_enough() -> None:
    """Settlement and moments are within 3 % of those on elements of half the size, as the comment says."""
    case = load(STUDIES / "warehouse.toml")
    coarse, fine = (solve(case.replace(mesh=case.mesh.replace(size=size))).plate for size in (1.0, 0.5))
    for field in ("settlement", "moment_x"):
        for extreme in (np.max, np.min):
            assert extreme(getattr(coarse, field)) == pytest.approx(extreme(getattr(fine, field)), rel=0.03)
