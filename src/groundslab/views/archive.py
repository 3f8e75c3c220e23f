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
    PlateResult,
    Results,
    Step,
    SupportResult,
)

if TYPE_CHECKING:
    from pathlib import Path

#: The version of the archive's layout; it grows when an array changes its name, unit or meaning.
FORMAT = 2


def write(results: Results, path: Path) -> None:
    """Write arrays named as "plate.settlement", the model as TOML in "model", the rest as JSON in "about"."""
    from groundslab import casefile

    arrays: dict[str, Any] = {}
    for part, values in (("plate", results.plate), ("elements", results.elements), ("ground", results.ground)):
        arrays |= {f"{part}.{item.name}": getattr(values, item.name) for item in fields(values)}
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
        plate=PlateResult(**{item.name: arrays[f"plate.{item.name}"] for item in fields(PlateResult)}),
        elements=ElementResult(**{item.name: arrays[f"elements.{item.name}"] for item in fields(ElementResult)}),
        ground=GroundResult(**{item.name: arrays[f"ground.{item.name}"] for item in fields(GroundResult)}),
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
    )


def _support(name: str, number: int, arrays: dict[str, Any]) -> SupportResult:
    """Return the support of a number among the arrays of an archive."""
    names = (item.name for item in fields(SupportResult) if item.name != "name")
    return SupportResult(name=name, **{each: arrays[f"supports.{number}.{each}"] for each in names})


def _refusal(path: Path, got: str) -> InputError:
    """Return the error for a file that is not an archive of results."""
    return InputError([Fault(str(path), got, "an archive (results.npz) that groundslab wrote")])
