"""The files of a folder of results: their names, and what writes each of them."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from groundslab.results.results import refusal_words
from groundslab.schema.wording import as_cell
from groundslab.views.summary import combinations

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from pathlib import Path

    from groundslab.results.results import CombinationResult, Results
    from groundslab.views.summary.combinations import Entry

    Writer = Callable[[Path], object]

#: Longest name of a combination in the name of its folder.
LONGEST = 40
#: A path that is longer than that of any file below a folder of results.
DEEPEST = "/".join(("0" * (LONGEST + 8), "increments", "00000-ground.vtu"))
#: The paths of all files that are ever written into a folder of results.
_PATHS = re.compile(
    r"(case\.toml|summary\.json|combinations\.csv|envelope\.vtu|(plate|ground|beams)\.pvd|tables/[a-z_]{1,40}\.csv"
    r"|ground-comparison\.(json|svg))"
    rf"|([0-9]{{2,7}}(-[a-z0-9-]{{1,{LONGEST}}})?/)?"
    r"((plate|ground|beams)\.vtu|results\.npz|picture\.png|(plate|ground)-increments\.pvd"
    r"|increments/[0-9]{2,5}-(plate|ground)\.vtu)"
)


def is_path(name: str) -> bool:
    """Return whether a file of that path below a folder of results can have been written by groundslab."""
    return _PATHS.fullmatch(name) is not None


def _of_one(results: CombinationResult, below: str, plot: bool) -> dict[str, Writer]:
    """Return the writers of the files of one combination by their paths, all of which begin with `below`."""
    from groundslab.views import plots
    from groundslab.views.files import npz, vtk

    writers: dict[str, Writer] = {
        f"{below}plate.vtu": partial(vtk.write_plate, results),
        f"{below}ground.vtu": partial(vtk.write_ground, results),
        f"{below}results.npz": partial(npz.write, results),
    }
    if results.beams:
        writers[f"{below}beams.vtu"] = partial(vtk.write_beams, results)
    writers |= _of_increments(results, below)
    if plot:
        writers[f"{below}picture.png"] = partial(plots.write_picture, results)
    return writers


def _of_increments(results: CombinationResult, below: str) -> dict[str, Writer]:
    """Return the writers of the states under shares of the load, and of collections that join them with the last one.

    ParaView's time is the share.
    """
    from groundslab.views.files import vtk

    if not results.increments:
        return {}
    writers: dict[str, Writer] = {}
    files: dict[str, dict[float, str]] = {"plate": {}, "ground": {}}
    for number, increment in enumerate(results.increments, 1):
        state = replace(
            results, plate=increment.plate, elements=increment.elements, ground=increment.ground, increments=()
        )
        for part, write in (("plate", vtk.write_plate), ("ground", vtk.write_ground)):
            name = f"increments/{number:02}-{part}.vtu"
            writers[below + name] = partial(write, state)
            files[part][increment.share] = name
    for part, those in files.items():
        text = collection({**those, 1.0: f"{part}.vtu"})
        writers[f"{below}{part}-increments.pvd"] = partial(write_text, text=text)
    return writers


def files_of(combined: Results, plot: bool) -> tuple[dict[str, Writer], dict[str, str]]:
    """Return the writers of each combination's files and of those that join them, and the combinations' folders.

    ParaView's time is the number of each combination; those without a certified result are left out there.
    """
    entries = combinations.entries(combined)
    only = combinations.only(entries)
    if only is not None:
        return _of_one(only, "", plot), {}
    folders = {
        entry.combination.name: folder_name(entry.number, entry.combination.name, len(entries))
        for entry in entries
        if entry.results is not None
    }
    certified = {entry.number: folders[entry.combination.name] for entry in entries if entry.refused is None}
    writers: dict[str, Writer] = {}
    for entry in entries:
        if entry.results is not None:
            writers |= _of_one(entry.results, f"{folders[entry.combination.name]}/", plot)
    for name in ("plate", "ground", *(("beams",) if combined.model.members else ())):
        text = collection({number: f"{folder}/{name}.vtu" for number, folder in certified.items()})
        writers[f"{name}.pvd"] = partial(write_text, text=text)
    writers["combinations.csv"] = partial(write_text, text=_list_of(entries, folders))
    return writers, folders


def of_all(combined: Results) -> dict[str, Writer]:
    """Return the writers of the files of all combinations together: tables, and envelopes if there is more than one."""
    from groundslab.views.files import vtk
    from groundslab.views.translation import translated_tables

    writers: dict[str, Writer] = {
        f"tables/{table.name}.csv": partial(write_text, text=table.csv()) for table in translated_tables(combined)
    }
    if len(combined.results) > 1 or (combined.results and combined.model.reinforcement is not None):
        writers["envelope.vtu"] = partial(vtk.write_envelope, combined)
    return writers


def folder_name(number: int, name: str, count: int) -> str:
    """Return the name of a combination's folder: its number, and of its own name what every system can hold.

    It begins with a digit, so that it is none of the names that Windows keeps for itself.
    """
    plain = unicodedata.normalize("NFKD", name.casefold()).encode("ascii", "ignore").decode()
    slug = re.sub(r"[^a-z0-9]+", "-", plain).strip("-")[:LONGEST].rstrip("-")
    return f"{number:0{max(2, len(str(count)))}}{'-' if slug else ''}{slug}"


def collection(files: Mapping[float, str]) -> str:
    """Return a ParaView collection (PVD) of files by their times."""
    sets = [f'    <DataSet timestep="{time:g}" group="" part="0" file="{file}"/>' for time, file in files.items()]
    head = '<VTKFile type="Collection" version="0.1" byte_order="LittleEndian">'
    return "\n".join(['<?xml version="1.0"?>', head, "  <Collection>", *sets, "  </Collection>", "</VTKFile>", ""])


def _list_of(entries: list[Entry], folders: dict[str, str]) -> str:
    """Return the combinations as comma-separated values: number, which is ParaView's time, names, factors, outcome."""
    import csv
    import io

    cases = list(dict.fromkeys(case for entry in entries for case, _ in entry.combination.factors))
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    head = ["number", "name", "limit state", "folder", "certified", "reason"]
    rows.writerow(head + [f"factor of {case}" for case in cases])
    for entry in entries:
        factors = dict(entry.combination.factors)
        name = entry.combination.name
        outcome = ["yes", ""] if entry.refused is None else ["no", refusal_words(entry.refused)]
        first = [str(entry.number), as_cell(name), entry.combination.limit_state, folders.get(name, "")]
        rows.writerow([*first, *outcome, *(factors.get(case, 0.0) for case in cases)])
    return text.getvalue()


def write_text(path: Path, text: str) -> None:
    """Write text as UTF-8 with plain line ends."""
    path.write_text(text, encoding="utf-8", newline="\n")
