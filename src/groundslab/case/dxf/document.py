"""The file: opening it, and the unit of its coordinates."""

from __future__ import annotations

import math
import os
import re
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING

from groundslab import units
from groundslab.case.dxf.drawing import ReportLine
from groundslab.case.dxf.sheet import Sheet
from groundslab.case.dxf.words import named
from groundslab.errors import InputError, Issue

if TYPE_CHECKING:
    from ezdxf.document import Drawing as Document

#: Units by the number that stands in a drawing's header: name and size in metres.
UNITS: dict[int, tuple[str, Fraction]] = {
    1: ("in", Fraction("0.0254")), 2: ("ft", Fraction("0.3048")), 3: ("mi", Fraction("1609.344")),
    4: ("mm", Fraction(1, 1000)), 5: ("cm", Fraction(1, 100)), 6: ("m", Fraction(1)), 7: ("km", Fraction(1000)),
    10: ("yd", Fraction("0.9144")), 14: ("dm", Fraction(1, 10)), 21: ("survey_foot", Fraction(1200, 3937)),
}  # fmt: skip


#: The largest file that is read [bytes]: reading one takes some ten times its size of memory.
LARGEST_FILE = 16_000_000


def open_drawing(path: str) -> Document:
    """Return the drawing as ezdxf reads it."""
    expected = "a DXF drawing"
    try:
        from ezdxf.filemanagement import readfile
    except ImportError:
        hint = "pip install groundslab[dxf]"
        raise InputError([Issue(path, "a DXF drawing", "ezdxf to read it", hint)]) from None
    try:
        if Path(path).exists() and not (Path(path).is_file() or Path(path).is_dir()):
            raise InputError([Issue(path, "a device or a pipe", "a DXF drawing, which is a file")])
        with Path(path).open("rb") as file:
            start, size = file.read(6), os.fstat(file.fileno()).st_size
    except FileNotFoundError:
        raise InputError([Issue(path, "no file of that name", expected)]) from None
    except IsADirectoryError:
        raise InputError([Issue(path, "a directory", expected)]) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise InputError([Issue(path, f"a file that cannot be read ({reason})", expected)]) from None
    if re.match(rb"AC10\d\d", start):
        raise InputError([Issue(path, "a DWG drawing", expected, "save it as DXF in the CAD program")])
    if size > LARGEST_FILE:
        hint = "save only the layers that are needed in a file of their own"
        found = f"a file of {size / 1e6:,.0f} MB"
        raise InputError([Issue(path, found, f"at most {LARGEST_FILE / 1e6:.0f} MB", hint)])
    try:
        document = readfile(path)
        document.modelspace()  # which a damaged file may lack
    except OSError:
        raise InputError([Issue(path, "a file that is not DXF", expected)]) from None
    except Exception as error:  # of any kind, as what is damaged may be anything
        found = f"a damaged DXF file ({error})"
        raise InputError([Issue(path, found, expected, "save it again in the CAD program")]) from None
    return document


def take_unit(document: Document, given: str | None, sheet: Sheet) -> None:
    """Give the sheet its unit: the one that was given, else the drawing's own."""
    code = document.header.get("$INSUNITS", 0)
    own = UNITS.get(code)
    if given is not None:
        try:
            scale = Fraction(repr(units.parse(f"1 {given}", "length")))
        except units.QuantityError as error:
            expected = 'the name of a length, such as "mm"'
            sheet.issues.append(Issue("the drawing's unit", named(given), expected, error.reason))
            return
        sheet.unit, sheet.scale = given, scale
        if own is not None and not math.isclose(own[1], scale, rel_tol=1e-5):
            why = f"the drawing says that its unit is {own[0]}; it was read in {given}, as asked for"
            sheet.report.append(ReportLine("", "HEADER", "", False, why))
    elif own is not None:
        sheet.unit, sheet.scale = own
    else:
        found = f"unit number {code}" if code else "no unit"
        hint = 'say the unit, such as "mm", or set INSUNITS in the drawing'
        sheet.issues.append(Issue(f"{sheet.path}, header, $INSUNITS", found, "a unit of length", hint))
