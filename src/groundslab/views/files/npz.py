"""All numbers of a result in one NumPy archive (SI units), from which the same result can be read back."""

from __future__ import annotations

import io
import json
import math
import stat
import zipfile
from dataclasses import asdict, dataclass, fields, replace
from functools import cache, lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab._version import __version__
from groundslab.errors import InputError, Issue
from groundslab.fem.continuum.pressed_cells import PressedCells
from groundslab.fem.parts.mesh_plan import MeshPlan
from groundslab.results.plate_result import ElementResult, GroundResult, PlateResult
from groundslab.results.records import (
    BaseResult,
    BeamResult,
    Certificate,
    Constants,
    JointResult,
    LargestValues,
    MeshHistory,
    Step,
    SupportResult,
    WallLimit,
)
from groundslab.results.results import CombinationResult, Comparison, Increment
from groundslab.views.files.validation import require_sound

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from pydantic import TypeAdapter

    from groundslab.model.model import Model

#: The version of the archive's layout; it grows when an array changes its name, unit or meaning.
FORMAT = 12


#: Longest text of a library's reason.
LONGEST_REASON = 300
#: Arrays that all states have in common.
MESH = {"nodes", "elements"}
#: Arrays that combinations of a folder, and their coarser meshes, mostly have in common: what follows is made once.
ALIKE = {f"{part}.{name}" for part in ("plate", "ground") for name in MESH} | {"elements.thickness", "elements.section"}
COARSER = "coarser."
#: Where the cells stand through which a plate presses on an elastic continuum.
CELLS = "ground.cells"
#: Nodal fields of a comparison itself.
REDUCTIONS = ("moment_reduction", "shear_reduction")


class OtherLayout(InputError):
    """An archive has a layout of another version, whose arrays have other names or meanings.

    Parameters
    ----------
    path : pathlib.Path
        The archive.
    layout : int
        Its layout.
    version : str
        The version of groundslab that wrote it.
    """

    def __init__(self, path: Path, layout: int, version: str) -> None:
        newer = layout > FORMAT
        hint = "solve the case.toml of the folder again" + (", or read it with a newer groundslab" if newer else "")
        writer = f"results of groundslab {version[:40]} in layout {layout}"
        super().__init__([Issue(str(path), writer, f"layout {FORMAT}, which groundslab {__version__} reads", hint)])


@dataclass(frozen=True, slots=True)
class _Layout:
    """What every version of an archive says of itself."""

    format: int
    version: str = ""


@dataclass(frozen=True, slots=True)
class _About:
    """What an archive holds besides arrays and model; its JSON text is held to these types."""

    format: int
    version: str
    constants: Constants
    certificate: Certificate
    steps: tuple[Step, ...]
    solver: str
    unknowns: int
    mesh_plan: MeshPlan
    combination: str
    limit_state: str
    factors: tuple[tuple[str, float], ...]
    supports: tuple[str, ...]
    joints: tuple[str, ...]
    beams: tuple[str, ...]
    bases: tuple[str, ...]
    increments: tuple[float, ...]
    comparison: tuple[float, float, Constants] | None  # error in energy, its reduction, the coarser mesh's constants
    largest: LargestValues | None
    mesh_history: MeshHistory | None
    wall_limits: tuple[WallLimit, ...]


#: What has a name each, by the part of the results.
NAMED: dict[str, type[Any]] = {
    "supports": SupportResult, "joints": JointResult, "beams": BeamResult, "bases": BaseResult,
}  # fmt: skip
#: What an archive says of results as they have it themselves.
PLAIN = [
    item.name
    for item in fields(_About)
    if item.name not in ("format", "version", "supports", "joints", "beams", "bases", "increments", "comparison")
]


def write(results: CombinationResult, path: Path) -> None:
    """Write arrays named as "plate.settlement", the case as TOML in "model", the rest as JSON in "about".

    The case as solved is "solved_model" where it is another one.
    """
    from groundslab.case import casefile

    arrays: dict[str, Any] = _arrays("", results)
    for number, increment in enumerate(results.increments):
        arrays |= _arrays(f"increments.{number}.", increment)
    for name in NAMED:
        arrays |= _named_arrays(name, getattr(results, name))
    other = results.comparison
    if other is not None:
        arrays |= _arrays(COARSER, other)
        arrays |= {f"{COARSER}{name}": field for name in REDUCTIONS if (field := getattr(other, name)) is not None}
        for name in NAMED:
            arrays |= _named_arrays(f"{COARSER}{name}", getattr(other, name))
    about = _About(
        format=FORMAT,
        version=__version__,
        **{name: getattr(results, name) for name in PLAIN},
        supports=tuple(support.name for support in results.supports),
        joints=tuple(joint.name for joint in results.joints),
        beams=tuple(beam.name for beam in results.beams),
        bases=tuple(base.name for base in results.bases),
        increments=tuple(increment.share for increment in results.increments),
        comparison=None if other is None else (other.energy_error, other.reduction, other.constants),
    )
    text = json.dumps(asdict(about), allow_nan=False, default=lambda number: number.item())
    arrays |= {"model": np.array(casefile.to_toml(results.model)), "about": np.array(text)}
    if results.solved_model != results.model:
        arrays["solved_model"] = np.array(casefile.to_toml(results.solved_model))
    with path.open("wb") as file:
        np.savez(file, **arrays)


#: Texts among the arrays, four bytes a letter, and the most bytes that they may have.
TEXTS = {"model.npy": 40_000_000, "about.npy": 40_000_000}


def load(path: Path, alike: CombinationResult | None = None) -> CombinationResult:
    """Return the results that ``write`` put into an archive.

    Their mesh is that of results `alike` if it is the same: what is derived from it is then derived once. Raises
    InputError if anything in it is damaged.
    """
    try:
        if not stat.S_ISREG(path.stat().st_mode):
            raise _refusal(path, "something that is not a file")
        return _results(_stored(path), alike, path)
    except InputError as error:
        if error.issues[0].location == str(path):
            raise
        # of the description within
        raise _refusal(path, f"a description that is wrong ({error.issues[0]})") from error
    except OSError as error:
        raise _refusal(path, error.strerror or str(error)) from error
    except Exception as error:
        # whatever a library trips over in a damaged file
        words = " ".join(f"{type(error).__name__}: {error}".split())
        raise _refusal(path, f"something else ({words[:LONGEST_REASON]})") from error


def _stored(path: Path) -> dict[str, Any]:
    """Return the arrays of an archive by their names.

    Raises ValueError if any takes more memory than it has bytes in the file, or holds objects.
    """
    with path.open("rb") as file, zipfile.ZipFile(file) as archive:
        members = archive.infolist()
        if any(member.compress_type != zipfile.ZIP_STORED for member in members):
            raise ValueError("compressed arrays, which groundslab does not write")
        texts = [member for member in members if member.filename in TEXTS]
        if any(member.file_size > TEXTS[member.filename] for member in texts):
            raise ValueError("a description that is larger than any")
        if sum(member.file_size for member in members) > path.stat().st_size:
            raise ValueError("arrays that are larger than the file")
        return {member.filename.removesuffix(".npy"): _array(archive, member) for member in members}


def _array(archive: zipfile.ZipFile, member: zipfile.ZipInfo) -> Any:
    """Return one array of an archive."""
    content = archive.read(member)
    length = content[8:10] if content[6:7] == b"\x01" else content[8:12]  # by the version of the format
    shape, in_columns, dtype, start = _head(content[: 8 + len(length) + int.from_bytes(length, "little")])
    if dtype.hasobject or dtype.itemsize * math.prod(shape) != len(content) - start:
        raise ValueError(f"{member.filename}: an array of another size than its bytes")
    return np.ndarray(shape, dtype, content, start, order="F" if in_columns else "C").copy("A")


@lru_cache(maxsize=1000)
def _head(content: bytes) -> tuple[tuple[int, ...], bool, np.dtype[Any], int]:
    """Return shape, order, type and length of the head that an array begins with; most arrays have one of few."""
    file = io.BytesIO(content)
    version = np.lib.format.read_magic(file)
    of_version = {(1, 0): np.lib.format.read_array_header_1_0, (2, 0): np.lib.format.read_array_header_2_0}
    return *of_version[version](file), file.tell()


@cache
def _adapters() -> tuple[TypeAdapter[_Layout], TypeAdapter[_About]]:
    """Return the type adapters that read the JSON text: the version of its layout alone, and all of it."""
    from pydantic import TypeAdapter

    return TypeAdapter(_Layout), TypeAdapter(_About)


def _read_about(text: str, path: Path) -> _About:
    """Return the metadata in the JSON text; raises OtherLayout, and ValueError, which names the first invalid value."""
    from pydantic import ValidationError

    layout, about = _adapters()
    try:
        stated = layout.validate_json(text, strict=True)
        if stated.format != FORMAT:
            raise OtherLayout(path, stated.format, stated.version)
        return about.validate_json(text, strict=True)
    except ValidationError as error:
        first = error.errors(include_url=False, include_input=False)[0]
        raise ValueError(f"about.{'.'.join(map(str, first['loc']))}: {first['msg']}") from None


def _results(arrays: dict[str, Any], alike: CombinationResult | None, path: Path) -> CombinationResult:
    """Return the results that the arrays of an archive stand for; raises ValueError if they cannot be results."""
    about = _read_about(str(arrays["about"]), path)
    if alike is not None:
        shared = _arrays("", alike)
        arrays |= {name: shared[name] for name in arrays.keys() & ALIKE if np.array_equal(shared[name], arrays[name])}
    arrays |= {
        f"{COARSER}{name}": arrays[name]
        for name in ALIKE
        if (coarser := arrays.get(f"{COARSER}{name}")) is not None and np.array_equal(coarser, arrays[name])
    }
    results = CombinationResult(
        model=_read_model(str(arrays["model"])),
        solved_model=_read_model(str(arrays["solved_model" if "solved_model" in arrays else "model"])),
        **_parts("", arrays),
        **{name: getattr(about, name) for name in PLAIN},
        **_all_named("", about, arrays),
        increments=tuple(
            Increment(share, **_parts(f"increments.{number}.", arrays)) for number, share in enumerate(about.increments)
        ),
        comparison=None if about.comparison is None else _comparison(about, arrays),
    )
    require_sound(results)
    return results


@lru_cache(maxsize=4)
def _read_model(text: str) -> Model:
    """Return the model that a text describes; the combinations of a folder share theirs."""
    from groundslab.case import casefile

    return casefile.loads(text)


def _comparison(about: _About, arrays: dict[str, Any]) -> Comparison:
    """Return the comparison with the coarser mesh."""
    assert about.comparison is not None
    energy_error, reduction, constants = about.comparison
    return Comparison(
        **_parts(COARSER, arrays),
        **_all_named(COARSER, about, arrays),
        constants=constants,
        energy_error=energy_error,
        reduction=reduction,
        moment_reduction=arrays.get(f"{COARSER}moment_reduction"),
        shear_reduction=arrays.get(f"{COARSER}shear_reduction"),
    )


def _arrays(below: str, state: CombinationResult | Increment | Comparison) -> dict[str, Any]:
    """Return the arrays of a state by their names, which begin with `below`; a mesh that is known stands there once."""
    named: dict[str, Any] = {}
    parts: dict[str, Any] = {
        "plate": state.plate,
        "elements": state.elements,
        "ground": state.ground,
        CELLS: state.ground.cells,
    }
    for part, values in parts.items():
        if values is None:
            continue
        names = (item.name for item in fields(values) if item.name != "cells" and (not below or item.name not in MESH))
        arrays = {f"{below}{part}.{name}": getattr(values, name) for name in names}
        named |= {name: array for name, array in arrays.items() if array is not None}
    return named


def _parts(below: str, arrays: dict[str, Any]) -> dict[str, Any]:
    """Return plate, elements and ground of a state from the arrays whose names begin with `below`."""
    kinds = {"plate": PlateResult, "elements": ElementResult, "ground": GroundResult}
    parts: dict[str, Any] = {}
    for part, kind in kinds.items():
        names = {item.name: f"{'' if item.name in MESH else below}{part}.{item.name}" for item in fields(kind)}
        optional = {item.name for item in fields(kind) if item.default is None and names[item.name] not in arrays}
        parts[part] = kind(**{name: arrays[key] for name, key in names.items() if name not in optional})
    if any(name.startswith(f"{below}{CELLS}.") for name in arrays):
        cells = {field.name: arrays[f"{below}{CELLS}.{field.name}"] for field in fields(PressedCells)}
        cells |= {name: bool(cells[name]) for name in ("bonded", "piled")}
        parts["ground"] = replace(parts["ground"], cells=PressedCells(**cells))
    return parts


def _named_arrays(below: str, named: Sequence[Any]) -> dict[str, Any]:
    """Return the arrays of supports, joints, beams or bases by their names, which begin with `below`."""
    return {
        f"{below}.{number}.{item.name}": getattr(part, item.name)
        for number, part in enumerate(named)
        for item in fields(part)
        if item.name != "name"
    }


def _all_named(below: str, about: _About, arrays: dict[str, Any]) -> dict[str, Any]:
    """Return supports, joints, beams and bases from the arrays whose names begin with `below`."""
    by_part: dict[str, Any] = {}
    for part, kind in NAMED.items():
        keys = [item.name for item in fields(kind) if item.name != "name"]
        by_part[part] = tuple(
            kind(name=name, **{key: arrays[f"{below}{part}.{number}.{key}"] for key in keys})
            for number, name in enumerate(getattr(about, part))
        )
    return by_part


def _refusal(path: Path, found: str) -> InputError:
    """Return the error for a file that is not an archive of results."""
    return InputError([Issue(str(path), found, "an archive (results.npz) that groundslab wrote")])
