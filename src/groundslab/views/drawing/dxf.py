"""Drawings as DXF files, by ezdxf; the same drawing gives the same bytes."""

from __future__ import annotations

import hashlib
import io
from collections import OrderedDict
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab._version import __version__
from groundslab.optional import import_optional
from groundslab.storage import bounded, checksums
from groundslab.storage.ownership import check_replaceable
from groundslab.unit_systems import System, unit_in
from groundslab.views.drawing.shapes import Circle, Layer, Line, Shape

if TYPE_CHECKING:
    from ezdxf.document import Drawing as Document

#: What a drawing says of itself, by which it is known, and within how many bytes of its beginning.
MARK, LOOK = "drawn by groundslab", 100_000
#: Numbers of units of length among those of DXF.
UNITS = {"m": 6, "ft": 2}
#: The font of texts, which has the letters of all languages here.
FONT = "arial.ttf"
#: What the data of contours stand under: the quantity, its value and its unit.
DATA = "GROUNDSLAB"
#: What stands before the checksum of the rest; CAD programs leave comments out when they save.
COMMENT = "999\ngroundslab sha256 "


def import_ezdxf() -> Any:
    """Return ezdxf; raises InputError where it is not installed."""
    return import_optional("ezdxf", "which writes drawings", "dxf")


def check(path: str | Path) -> Path:
    """Return the full path if a drawing can be written there; else raise InputError saying why not."""
    import_ezdxf()
    return check_replaceable(path, is_ours, "a drawing of groundslab")


def to_bytes(shapes: Sequence[Shape], layers: Mapping[str, Layer], subject: str, system: System = "SI") -> bytes:
    """Return a drawing as the content of a DXF file; raises InputError where ezdxf is missing.

    Coordinates are meters, or feet in the customary units of the United States.
    """
    ezdxf = import_ezdxf()
    dated = ezdxf.options.write_fixed_meta_data_for_testing
    ezdxf.options.write_fixed_meta_data_for_testing = True  # neither dates nor random numbers
    try:
        document = _document(shapes, layers, subject, system)
        stream = io.StringIO()
        document.write(stream)
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = dated
    content: bytes = document.encode(stream.getvalue())
    # a comment at the top, as nothing may follow the end
    return f"{COMMENT}{hashlib.sha256(content).hexdigest()}\n".encode() + content


def _document(shapes: Sequence[Shape], layers: Mapping[str, Layer], subject: str, system: System) -> Document:
    """Return a drawing as ezdxf holds it."""
    from ezdxf.enums import TextEntityAlignment
    from ezdxf.filemanagement import new

    unit, scale = unit_in("m", system)
    document = new("R2010", setup=["linetypes"], units=UNITS[unit])
    document.header.custom_vars.append("Creator", f"{subject} {MARK} {__version__}")
    classes = document.classes
    classes.add_required_classes(document.dxfversion)
    classes.classes = OrderedDict(sorted(classes.classes.items()))  # from a set, whose order varies between processes
    document.appids.add(DATA)
    document.styles.get("Standard").dxf.font = FONT
    for name, look in layers.items():
        layer = document.layers.add(name, color=look.color, linetype="DASHED" if look.broken else "CONTINUOUS")
        if look.off:
            layer.off()
    space = document.modelspace()
    for shape in shapes:
        on = {"layer": shape.layer}
        if isinstance(shape, Line):
            line = space.add_lwpolyline(_corners(shape, scale), format="xyb", close=shape.closed, dxfattribs=on)
            if shape.level is not None:
                quantity, value, of = shape.level
                line.set_xdata(DATA, [(1000, quantity), (1040, value), (1000, of)])
        elif isinstance(shape, Circle):
            x, y = shape.center
            space.add_circle((scale * x, scale * y), scale * shape.radius, dxfattribs=on)
        else:
            text = space.add_text(shape.words, height=scale * shape.height, rotation=shape.turned, dxfattribs=on)
            align = TextEntityAlignment.MIDDLE_CENTER if shape.centered else TextEntityAlignment.LEFT
            text.set_placement((scale * shape.place[0], scale * shape.place[1]), align=align)
    return document


def _corners(line: Line, scale: float) -> list[tuple[float, float, float]]:
    """Return the points of a line in the drawing's unit, with the bulge of the edge after each."""
    if line.curve is None:
        return [(scale * x, scale * y, 0.0) for x, y in line.points.tolist()]
    bulges = (*line.curve.bulges, *[0.0] * len(line.curve.points))
    return [(scale * x, scale * y, bulge) for (x, y), bulge in zip(line.curve.points, bulges, strict=False)]


def is_ours(path: Path) -> bool:
    """Return whether a file is a drawing that groundslab wrote."""
    with path.open("rb") as file:
        return MARK.encode() in file.read(LOOK)


def is_unchanged(path: Path) -> bool:
    """Return whether a drawing is as groundslab wrote it."""
    start, _, content = bounded.read_whole(path, checksums.LARGEST).removeprefix(COMMENT.encode()).partition(b"\n")
    return start == hashlib.sha256(content).hexdigest().encode()
