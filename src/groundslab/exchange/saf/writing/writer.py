"""A case as a file in the Structural Analysis Format, version 2.2."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar, cast

from groundslab._version import __version__
from groundslab.errors import InputError, Issue
from groundslab.exchange.saf.writing.cases import write_cases, write_combinations
from groundslab.exchange.saf.writing.forces import EdgeForces, write_forces
from groundslab.exchange.saf.writing.loads import Placed, write_loads
from groundslab.exchange.saf.writing.sheets import LONGEST_NAME, Sheets
from groundslab.exchange.saf.writing.structure import (
    plate_at,
    plate_names,
    write_beams,
    write_columns,
    write_ground,
    write_materials,
    write_plate,
    write_supports,
    write_walls,
)
from groundslab.geometry.plan import Ring
from groundslab.model.combinations import list_combinations, place_patterns
from groundslab.schema.base import Section
from groundslab.storage import atomic

if TYPE_CHECKING:
    from groundslab.model.model import Model

VERSION = "2.2.0"
T = TypeVar("T")

#: Parts of a model that are written, or need not be.
_WRITTEN = {"title", "project", "report", "plate", "plates", "ground", "soil_zones", "supports", "columns", "walls",
            "beams", "cases", "loads", "combinations", "combine", "patterns", "moves"}  # fmt: skip


def write_model(
    model: Model,
    path: str | Path,
    stiffness: tuple[float, float] | None = None,
    forces: Sequence[EdgeForces] = (),
) -> tuple[str, ...]:
    """Write a case to a new file; return what is not in it, or there in another way.

    ``stiffness`` is k0 [Pa/m] and k1 [Pa m] of ground that is not given by them, ``forces`` are those along the edges
    of its only plate. Raises InputError if the file exists.
    """
    sheets = Sheets()
    short = _with_short_names(model)
    if short != model:
        sheets.leave("names", f"those above {LONGEST_NAME} letters are shortened")
    model = short
    forces = [replace(force, combination=_shorten(force.combination)) for force in forces]
    placed = place_patterns(model)
    if model.moves:
        sheets.leave("moves", "vehicles and racks are written as forces, each position as a case")
    names = plate_names(placed.every_plate)
    rings = {name: plate.ring() for plate, name in zip(placed.every_plate, names, strict=True)}
    materials = write_materials(sheets, placed)
    for plate, name in zip(placed.every_plate, names, strict=True):
        write_plate(sheets, plate, name, materials)
    first = materials[placed.plate.E, placed.plate.nu]
    feet = write_columns(sheets, placed, first)
    walls = write_walls(sheets, placed.placed_walls, first)
    write_beams(sheets, placed, rings, materials)
    write_supports(sheets, placed, rings)
    write_ground(sheets, placed, names, first, stiffness)
    weights = write_cases(sheets, placed)
    combined: dict[str, str] = {}
    # cases are solved one by one unless combinations say otherwise; of one that is written as two they must
    if placed.combinations or placed.combine is not None or any(name != case for case, name in weights.items()):
        combined = write_combinations(sheets, list_combinations(placed), weights)
    if placed.combine is not None:
        sheets.leave("combine", "its combinations are written with their factors")
    plates = {plate.name or name: name for plate, name in zip(placed.every_plate, names, strict=True)}
    write_loads(sheets, placed, Placed(plates, rings, feet, walls))
    write_forces(sheets, names[0], forces, combined)
    _add_internal_nodes(sheets, rings)
    if len(names) > 1:
        sheets.leave("plates", "one at a time is read back; joints are not written")
    _leave_others(sheets, model)
    content = sheets.to_bytes(_project(model), _model(model))
    try:
        atomic.write(Path(path), content, new=True)
    except FileExistsError:
        raise InputError(
            [Issue(str(path), "a file that exists", "a name that is free", "choose another name")]
        ) from None
    except OSError as error:
        raise InputError([Issue(str(path), error.strerror or str(error), "a file that can be written")]) from None
    return tuple(dict.fromkeys(sheets.left))


def _with_short_names(value: T) -> T:
    """Return a model, or a part of it, with names shortened alike where things are named and where they are meant."""
    shorter: Any = value
    if isinstance(value, str):
        shorter = _shorten(value)
    elif isinstance(value, tuple):
        shorter = tuple(map(_with_short_names, value))
    elif isinstance(value, Section):
        values = {name: _with_short_names(item) for name, item in value}
        changed = {name: item for name, item in values.items() if item != getattr(value, name)}
        shorter = value.model_copy(update=changed) if changed else value
    return cast("T", shorter)


def _shorten(name: str) -> str:
    """Return a name of as many letters as the format takes; one that is shortened ends in a part of its SHA-256."""
    if len(name) <= LONGEST_NAME:
        return name
    return f"{name[: LONGEST_NAME - 9]}~{sha256(name.encode()).hexdigest()[:8]}"


def _add_internal_nodes(sheets: Sheets, plates: Mapping[str, Ring]) -> None:
    """Name the nodes at which columns stand and loads and supports act as internal ones of their plates."""
    used = [row["nodes"].split("; ")[0] for row in sheets.rows["StructuralCurveMember"]]
    used += [row["node"] for row in sheets.rows["StructuralPointSupport"]]
    for sheet in ("StructuralPointAction", "StructuralPointMoment"):
        used += [row["referencenode"] for row in sheets.rows[sheet]]
    places = {name: (x, y) for (x, y, _), name in sheets.nodes.items()}
    inside: dict[str, list[str]] = {name: [] for name in plates}
    for node in dict.fromkeys(used):
        inside[plate_at(plates, places[node])].append(node)
    for member in sheets.rows["StructuralSurfaceMember"]:
        if member["name"] in inside:
            corners = set(member["nodes"].split("; "))
            member["internalnodes"] = "; ".join(node for node in inside[member["name"]] if node not in corners)


def _leave_others(sheets: Sheets, model: Model) -> None:
    """Note the parts of a model that the format has no place for."""
    for name, part in model:
        if name not in _WRITTEN and part != type(model).field_defaults[name]:
            sheets.leave(name, "the format has no place for it")
    plain = type(model.plate).field_defaults
    for key in ("shear_factor", "element"):
        if getattr(model.plate, key) != plain[key]:
            sheets.leave(f"plate.{key}", "the format has no place for it")
    if model.ground.kind not in ("winkler", "pasternak"):
        sheets.leave("ground", f"layers of {model.ground.kind} ground have no place in the format")


def _project(model: Model) -> dict[str, str]:
    """Return the lines of the sheet Project."""
    project = model.project
    return {
        "Name": project.name if project is not None else "",
        "Project nr": project.number if project is not None else "",
        "Project type": "Building construction",
    }


def _model(model: Model) -> dict[str, str]:
    """Return the lines of the sheet Model."""
    project, american = model.project, model.reinforcement is not None and "ACI" in model.reinforcement.code
    return {
        "Name": model.title,
        "Discipline": "Load-bearing structure",
        "Owner": project.author if project is not None else "",
        "Revision number": project.revision if project is not None else "",
        "Source type": "Structural analysis model",
        "Source application": f"groundslab {__version__}",
        "SAF Version": VERSION,
        "Global coordinate system": "Z vertical",
        "LCS of cross-section": "ZYX",
        "System of units": "Imperial" if project is not None and project.units == "US" else "Metric",
        "National code": "IBC" if american else "EC-Standard-EN",
    }
