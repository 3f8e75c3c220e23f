"""A drawing of bars as DXF, in meters, by ezdxf; the same drawing gives the same bytes."""

from __future__ import annotations

import hashlib
import io
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab._version import __version__
from groundslab.optional import import_optional
from groundslab.storage import bounded, checksums
from groundslab.views.bars.drawing import BROKEN, LAYERS, Circle, Line, Shape

if TYPE_CHECKING:
    from ezdxf.document import Drawing as Document

#: What a drawing says of itself, by which it is known, and within how many bytes of its beginning.
MARK, LOOK = "Bars drawn by groundslab", 100_000
#: Number of the meter among the units of DXF.
METER = 6
#: What stands before the checksum of the rest; CAD programs leave comments out when they save.
COMMENT = "999\ngroundslab sha256 "


def import_ezdxf() -> Any:
    """Return ezdxf; raises InputError where it is not installed."""
    return import_optional("ezdxf", "which writes drawings", "dxf")


def to_bytes(shapes: Sequence[Shape]) -> bytes:
    """Return a drawing as the content of a DXF file; raises InputError where ezdxf is missing."""
    ezdxf = import_ezdxf()
    dated = ezdxf.options.write_fixed_meta_data_for_testing
    ezdxf.options.write_fixed_meta_data_for_testing = True  # neither dates nor random numbers
    try:
        document = _document(shapes)
        stream = io.StringIO()
        document.write(stream)
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = dated
    content: bytes = document.encode(stream.getvalue())
    # a comment at the top, as nothing may follow the end
    return f"{COMMENT}{hashlib.sha256(content).hexdigest()}\n".encode() + content


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


def is_unchanged(path: Path) -> bool:
    """Return whether a drawing is as groundslab wrote it."""
    start, _, content = bounded.read_whole(path, checksums.LARGEST).removeprefix(COMMENT.encode()).partition(b"\n")
    return start == hashlib.sha256(content).hexdigest().encode()
