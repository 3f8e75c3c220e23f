"""A drawing of bars as DXF, in meters, by ezdxf; the same drawing gives the same bytes."""

from __future__ import annotations

import io
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from groundslab._version import __version__
from groundslab.errors import InputError, Issue
from groundslab.views.bars.drawing import BROKEN, LAYERS, Circle, Line, Shape

if TYPE_CHECKING:
    from ezdxf.document import Drawing as Document

#: What a drawing says of itself, by which it is known, and within how many bytes of its beginning.
MARK, LOOK = "Bars drawn by groundslab", 100_000
#: Number of the meter among the units of DXF.
METER = 6


def to_bytes(shapes: Sequence[Shape], path: str | Path) -> bytes:
    """Return a drawing as the content of a DXF file; the path is named where ezdxf is missing."""
    try:
        import ezdxf
    except ImportError:
        hint = "pip install groundslab[dxf]"
        raise InputError([Issue(str(path), "a DXF drawing", "ezdxf to write it", hint)]) from None
    dated = ezdxf.options.write_fixed_meta_data_for_testing
    ezdxf.options.write_fixed_meta_data_for_testing = True  # neither dates nor random numbers
    try:
        document = _document(shapes)
        stream = io.StringIO()
        document.write(stream)
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = dated
    content: bytes = document.encode(stream.getvalue())
    return content


def _document(shapes: Sequence[Shape]) -> Document:
    """Return a drawing as ezdxf holds it."""
    from ezdxf.filemanagement import new

    document = new("R2010", setup=["linetypes"], units=METER)
    document.header.custom_vars.append("Creator", f"{MARK} {__version__}")
    for name, color in LAYERS.items():
        document.layers.add(name, color=color, linetype="DASHED" if name == BROKEN else "CONTINUOUS")
    space = document.modelspace()
    for shape in shapes:
        on = {"layer": shape.layer}
        if isinstance(shape, Line):
            space.add_lwpolyline(shape.points.tolist(), close=shape.closed, dxfattribs=on)
        elif isinstance(shape, Circle):
            space.add_circle(shape.center, shape.radius, dxfattribs=on)
        else:
            text = space.add_text(shape.words, height=shape.height, rotation=shape.turned, dxfattribs=on)
            text.set_placement(shape.place)
    return document


def is_ours(path: Path) -> bool:
    """Return whether a file is a drawing of bars that groundslab wrote."""
    with path.open("rb") as file:
        return MARK.encode() in file.read(LOOK)
