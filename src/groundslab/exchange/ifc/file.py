"""The IFC file: opening it, its unit of length and map coordinates, and the bodies of its elements in meters."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from groundslab.errors import InputError, Issue
from groundslab.exchange.ifc.body import FARTHEST, TURN, Body
from groundslab.optional import import_optional
from groundslab.schema.wording import describe

#: The largest file that is read [bytes]: reading one takes some six times its size of memory.
LARGEST_FILE = 200_000_000
#: Most elements whose bodies are made, and most triangles of one body.
MOST_BODIES, MOST_TRIANGLES = 20_000, 200_000
#: Names of quantities that are the thickness of slabs, and of walls.
THICKNESSES = (("Depth", "NominalDepth"), ("Width", "NominalWidth"))
#: Curves become chords that are so far off them at most [m].
SAG = 1e-3
#: Classes that are asked for, and that a version does not know.
UNKNOWN = {"IFC2X3": ("IfcMapConversion",)}
#: Versions of the format that are read, as their schemas begin.
VERSIONS = ("IFC4", "IFC2X3")
_EXPECTED = "an IFC 2x3 or IFC 4 file"


@dataclass(slots=True)
class IfcFile:
    """An open file; bodies are made when they are asked for."""

    path: str
    model: Any
    settings: Any
    create_shape: Any
    relations: Any  # of elements: storeys, materials, quantities
    unit: str
    scale: float  # size of the unit [m]
    bodies: dict[int, Body | str] = field(default_factory=dict, repr=False)

    def by_type(self, name: str) -> list[Any]:
        """Return the elements of a class and of the classes derived from it, in the order of the file.

        Of a class that the file's version does not know there are none.
        """
        if name in UNKNOWN.get(str(self.model.schema), ()):
            return []
        return sorted(self.model.by_type(name), key=lambda element: int(element.id()))

    def body(self, element: Any) -> Body | str:
        """Return the body of an element without what openings take off, or why there is none; each is made once."""
        key = int(element.id())
        if key not in self.bodies:
            if len(self.bodies) >= MOST_BODIES:
                hint = "export the storey of the slab alone"
                raise InputError([Issue(self.path, f"more than {MOST_BODIES:,} elements", "fewer", hint)])
            self.bodies[key] = self._make_body(element)
        return self.bodies[key]

    def said_thickness(self, element: Any) -> dict[str, float]:
        """Return what the file says of an element's thickness [m] beside its body, by what says it."""
        thicknesses: dict[str, float] = {}
        try:
            material = self.relations.get_material(element)
            layers = getattr(getattr(material, "ForLayerSet", material), "MaterialLayers", None) or ()
            if layers:
                thicknesses["its material layers"] = self.scale * sum(float(layer.LayerThickness) for layer in layers)
            for values in self.relations.get_psets(element, qtos_only=True).values():
                named = (name for name in THICKNESSES[element.is_a("IfcWall")] if isinstance(values.get(name), float))
                thicknesses |= {f"its quantity {name}": self.scale * values[name] for name in named}
        except MemoryError:
            raise
        except Exception:  # of any kind, as what is damaged may be anything; the body counts
            return {}
        return {what: round(value, 9) for what, value in thicknesses.items() if math.isfinite(value) and value > 0}

    def _make_body(self, element: Any) -> Body | str:
        """Return the body of an element, or why there is none."""
        if element.Representation is None:
            return "it has no geometry of its own"
        try:
            shape = self.create_shape(self.settings, element)
            matrix = np.array(shape.transformation.matrix, dtype=float).reshape(4, 4).T
            local = np.array(shape.geometry.verts, dtype=float).reshape(-1, 3)
            triangles = np.array(shape.geometry.faces, dtype=int).reshape(-1, 3)
        except MemoryError:
            raise
        except Exception as error:  # of any kind, as what is damaged may be anything
            return f"its geometry cannot be made ({error})"
        points = local @ matrix[:3, :3].T + matrix[:3, 3]
        if not len(triangles):
            return "it has no geometry with faces"
        if len(triangles) > MOST_TRIANGLES:
            return f"it has {len(triangles):,} triangles, expected at most {MOST_TRIANGLES:,}"
        if not bool((np.abs(points) < FARTHEST).all()):
            return f"its coordinates are not numbers, or farther away than {FARTHEST:g} m"
        return Body(points, triangles)


def open_file(path: str) -> IfcFile:
    """Return an open file; raises InputError."""
    purpose = "which reads building models"
    names = ("ifcopenshell", "ifcopenshell.geom", "ifcopenshell.util.unit", "ifcopenshell.util.element")
    ifcopenshell, geom, unit, element = (import_optional(name, purpose, "ifc") for name in names)
    _check_readable(path)
    try:
        model = ifcopenshell.open(path)
        schema = str(model.schema)
    except MemoryError:
        raise
    except Exception as error:  # of any kind, as what is damaged may be anything
        damage = f"a file that is not IFC, or damaged ({error})"
        raise InputError([Issue(path, damage, _EXPECTED, "export it again from the building's program")]) from None
    if not schema.upper().startswith(VERSIONS):
        raise InputError([Issue(f"{path}, schema", describe(schema), _EXPECTED, "export it as IFC 4")])
    settings = geom.settings()
    settings.set("disable-opening-subtractions", True)  # openings are read for themselves
    settings.set("mesher-linear-deflection", SAG)
    settings.set("mesher-angular-deflection", TURN)
    name, scale = _unit(model, unit, path)
    return IfcFile(path, model, settings, geom.create_shape, element, name, scale)


def _check_readable(path: str) -> None:
    """Raise InputError if a path is no file, or a larger one than is read."""
    try:
        if Path(path).exists() and not (Path(path).is_file() or Path(path).is_dir()):
            raise InputError([Issue(path, "a device or a pipe", f"{_EXPECTED}, which is a file")])
        with Path(path).open("rb") as file:
            start, size = file.read(4), os.fstat(file.fileno()).st_size
    except FileNotFoundError:
        raise InputError([Issue(path, "no file of that name", _EXPECTED)]) from None
    except IsADirectoryError:
        raise InputError([Issue(path, "a directory", _EXPECTED)]) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise InputError([Issue(path, f"a file that cannot be read ({reason})", _EXPECTED)]) from None
    if start.startswith(b"PK"):
        raise InputError([Issue(path, "a compressed file", _EXPECTED, "unpack the IFC file in it")])
    if size > LARGEST_FILE:
        file_size = f"a file of {size / 1e6:,.0f} MB"
        expected = f"at most {LARGEST_FILE / 1e6:.0f} MB"
        raise InputError([Issue(path, file_size, expected, "export the storey of the slab alone")])


def _unit(model: Any, unit: Any, path: str) -> tuple[str, float]:
    """Return the name of the file's unit of length, and its size in meters; raises InputError."""
    where = f"{path}, unit of length"
    try:
        used = unit.get_project_unit(model, "LENGTHUNIT")
        name = "" if used is None else f"{getattr(used, 'Prefix', None) or ''}{used.Name}".lower()
        scale = float(unit.calculate_unit_scale(model))
    except Exception as error:  # of any kind, as what is damaged may be anything
        raise InputError([Issue(where, f"none that can be read ({error})", "a unit of length")]) from None
    if not name or not 0 < scale < math.inf:
        hint = "the project's IfcUnitAssignment must have a LENGTHUNIT"
        raise InputError([Issue(where, "none", "a unit of length", hint)])
    return name, scale


def map_note(file: IfcFile) -> str | None:
    """Return where the file's origin lies on the map, if it says so."""
    operations = file.by_type("IfcMapConversion")
    if not operations:
        return None
    conversion = operations[0]
    try:
        easting, northing, height = (float(conversion[n] or 0.0) for n in (2, 3, 4))
        east, north = conversion.XAxisAbscissa, conversion.XAxisOrdinate
        turned = 0.0 if east is None or north is None else math.degrees(math.atan2(north, east))
    except (TypeError, ValueError, AttributeError):
        return "IfcMapConversion: it cannot be read; coordinates are those of the building"
    name = getattr(conversion.TargetCRS, "Name", None)
    system = f" of {name}" if name else ""
    return (
        f"IfcMapConversion: the file's origin is at easting {easting:.10g}, northing {northing:.10g}, height "
        f"{height:.6g}{system}, its x axis {turned:.6g} degrees from east; coordinates are the building's"
    )
