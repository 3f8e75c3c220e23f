"""What is suggested of the layers of a drawing before anything is chosen."""

from __future__ import annotations

from pathlib import Path

import ezdxf
import pytest

from groundslab.exchange.dxf.survey import survey


@pytest.mark.parametrize(
    ("names", "outlines"),
    [
        (["BASE", "WALL"], ["BASE"]),
        (["Bodenplatte", "A"], ["Bodenplatte"]),
        (["OUTLINE", "SLAB"], ["OUTLINE"]),
        (["SLAB", "BASE"], []),
        (["A-SLAB", "COLUMNS"], []),
    ],
)
def test_one_layer_that_is_called_like_a_slab_holds_the_outline(
    tmp_path: Path, names: list[str], outlines: list[str]
) -> None:
    """It is suggested if no layer has the usual name, and no other one is called so."""
    drawing = ezdxf.new()
    for name in names:
        drawing.modelspace().add_circle((0, 0), 5, dxfattribs={"layer": name})
    drawing.saveas(tmp_path / "plan.dxf")
    layers = survey(tmp_path / "plan.dxf").layers
    assert [layer.name for layer in layers if layer.role == "outline"] == outlines
