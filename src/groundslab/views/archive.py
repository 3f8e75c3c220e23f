"""All numbers of a result in one NumPy archive (SI units), from which the same result can be read back."""

from __future__ import annotations

import json
from dataclasses import asdict, fields
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab import __version__
from groundslab.errors import Fault, InputError
from groundslab.results import (
    Certificate,
    Constants,
    ElementResult,
    GroundResult,
    Increment,
    PlateResult,
    Results,
    Step,
    SupportResult,
)

if TYPE_CHECKING:
    from pathlib import Path

#: The version of the archive's layout; it grows when an array changes its name, unit or meaning.
FORMAT = 4


#: Arrays that all states have in common.
MESH = {"nodes", "elements"}


def write(results: Results, path: Path) -> None:
    """Write arrays named as "plate.settlement", the model as TOML in "model", the rest as JSON in "about"."""
    from groundslab import casefile

    arrays: dict[str, Any] = _arrays("", results)
    for number, increment in enumerate(results.increments):
        arrays |= _arrays(f"increments.{number}.", increment)
    for number, support in enumerate(results.supports):
        names = (item.name for item in fields(support) if item.name != "name")
        arrays |= {f"supports.{number}.{name}": getattr(support, name) for name in names}
    about = {
        "format": FORMAT,
        "version": __version__,
        "constants": asdict(results.constants),
        "certificate": asdict(results.certificate),
        "steps": [asdict(step) for step in results.steps],
        "solver": results.solver,
        "unknowns": results.unknowns,
        "symmetry": results.symmetry,
        "combination": results.combination,
        "limit_state": results.limit_state,
        "factors": results.factors,
        "supports": [support.name for support in results.supports],
        "increments": [each.share for each in results.increments],
    }
    text = json.dumps(about, allow_nan=False, default=lambda number: number.item())
    arrays |= {"model": np.array(casefile.to_toml(results.model)), "about": np.array(text)}
    with path.open("wb") as file:
        np.savez(file, **arrays)


def load(path: Path) -> Results:
    """Return the results that ``write`` put into an archive; their arrays cannot be written to."""
    from zipfile import BadZipFile

    try:
        with path.open("rb") as file, np.load(file, allow_pickle=False) as stored:
            return _results({name: stored[name] for name in stored.files})
    except OSError as error:
        raise _refusal(path, error.strerror or str(error)) from error
    except (KeyError, ValueError, TypeError, AttributeError, EOFError, BadZipFile) as error:
        raise _refusal(path, f"something else ({type(error).__name__}: {error})") from error


def _results(arrays: dict[str, Any]) -> Results:
    """Return the results that the arrays of an archive stand for."""
    from groundslab import casefile

    about = json.loads(str(arrays["about"]))
    if about["format"] != FORMAT:
        raise ValueError(f"layout {about['format']}, while this version reads {FORMAT}")
    for array in arrays.values():
        array.flags.writeable = False
    symmetric_x, symmetric_y = about["symmetry"]
    constants = about["constants"]
    return Results(
        model=casefile.loads(str(arrays["model"])),
        **_parts("", arrays),
        constants=Constants(**constants | {"k0": tuple(constants["k0"]), "k1": tuple(constants["k1"])}),
        certificate=Certificate(**about["certificate"]),
        steps=tuple(Step(**step) for step in about["steps"]),
        solver=about["solver"],
        unknowns=about["unknowns"],
        symmetry=(symmetric_x, symmetric_y),
        combination=about["combination"],
        limit_state=about["limit_state"],
        factors=tuple((name, factor) for name, factor in about["factors"]),
        supports=tuple(_support(name, number, arrays) for number, name in enumerate(about["supports"])),
        increments=tuple(
            Increment(share, **_parts(f"increments.{number}.", arrays))
            for number, share in enumerate(about["increments"])
        ),
    )


def _arrays(below: str, state: Results | Increment) -> dict[str, Any]:
    """Return the arrays of a state by their names, which begin with `below`; a mesh that is known stands there once."""
    found: dict[str, Any] = {}
    for part, values in (("plate", state.plate), ("elements", state.elements), ("ground", state.ground)):
        names = (item.name for item in fields(values) if not below or item.name not in MESH)
        found |= {f"{below}{part}.{name}": getattr(values, name) for name in names}
    return found


def _parts(below: str, arrays: dict[str, Any]) -> dict[str, Any]:
    """Return plate, elements and ground of a state from the arrays whose names begin with `below`."""
    kinds = {"plate": PlateResult, "elements": ElementResult, "ground": GroundResult}
    return {
        part: kind(
            **{item.name: arrays[f"{'' if item.name in MESH else below}{part}.{item.name}"] for item in fields(kind)}
        )
        for part, kind in kinds.items()
    }


def _support(name: str, number: int, arrays: dict[str, Any]) -> SupportResult:
    """Return the support of a number among the arrays of an archive."""
    names = (item.name for item in fields(SupportResult) if item.name != "name")
    return SupportResult(name=name, **{each: arrays[f"supports.{number}.{each}"] for each in names})


def _refusal(path: Path, got: str) -> InputError:
    """Return the error for a file that is not an archive of results."""
    return InputError([Fault(str(path), got, "an archive (results.npz) that groundslab wrote")])
