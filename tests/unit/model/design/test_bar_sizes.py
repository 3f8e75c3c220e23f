"""Diameters of bars: as lengths, and by the sizes of ASTM A615."""

from __future__ import annotations

import pytest

from groundslab.case import casefile
from groundslab.errors import InputError
from groundslab.model.design.bars import Bars
from groundslab.unit_systems import BAR_SIZES


@pytest.mark.parametrize(
    ("size", "inches", "area"),
    # nominal diameters and areas as ASTM A615 lists them, the areas to its two decimals
    [("#3", 0.375, 0.11), ("#4", 0.5, 0.20), ("#5", 0.625, 0.31), ("#6", 0.75, 0.44), ("#7", 0.875, 0.60),
     ("#8", 1.0, 0.79), ("#9", 1.128, 1.00), ("#10", 1.27, 1.27), ("#11", 1.41, 1.56), ("#14", 1.693, 2.25),
     ("#18", 2.257, 4.00)],
)  # fmt: skip
def test_sizes(size: str, inches: float, area: float) -> None:
    """A size is its nominal diameter, whose circle has the nominal area."""
    diameter = Bars(diameter=size, spacing="8 in").diameter
    assert diameter == pytest.approx(inches * 0.0254, rel=1e-6)
    assert 3.14159265 / 4 * (diameter / 0.0254) ** 2 == pytest.approx(area, abs=0.0051)


def test_every_size_is_known() -> None:
    """There are eleven."""
    assert len(BAR_SIZES) == 11


def test_unknown_size_is_refused() -> None:
    """The sizes are listed; none of them is proposed as what was meant."""
    with pytest.raises(InputError) as refused:
        Bars(diameter="#12", spacing="8 in")
    (issue,) = refused.value.issues
    assert issue.found == '"#12"'
    assert issue.expected == 'a length such as "16 mm", or a size such as "#5"'
    assert issue.hint.startswith("there are #3, #4")


def test_sizes_are_written_as_sizes() -> None:
    """A case that is written again has the size, and a length that is none stays one."""
    assert 'diameter = "#6"' in casefile.to_toml(Bars(diameter="#6", spacing="8 in"))
