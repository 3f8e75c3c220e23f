"""Bars that are laid: plans with quantities (SVG, PDF, PNG, DXF), the bending schedule, and records for benders."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from groundslab.design.bars.positions import positions
from groundslab.design.bars.proposal.links import punching_links
from groundslab.design.rules.punching_links.layout import LinkLayout
from groundslab.errors import InputError, Issue
from groundslab.model.model import Model
from groundslab.results.results import CombinationResult, Results
from groundslab.storage.ownership import check_replaceable
from groundslab.views.bars.bvbs import is_bvbs, to_bvbs
from groundslab.views.bars.schedule import is_schedule, schedule_of
from groundslab.views.drawing.bars import LAYERS, draw
from groundslab.views.files import xlsx
from groundslab.views.plots import export

#: What the names of files end with: of records of BVBS, of bending schedules as text and as workbooks.
RECORDS, TEXT, WORKBOOK = ".abs", ".csv", ".xlsx"


def write_bars(of: Model | Results | CombinationResult, path: str | Path) -> Path:
    """Draw the bars provided: a plan of each face, and how many there are, how long, and what they weigh; or list them.

    The bending schedule lists bars and links as they are cut and bent, with their masses by diameter and altogether.

    One bar of each set stands for all of them, with a line across over which they are distributed, its marks, number,
    diameter, spacing and length. With `reinforcement.detailing` lengths have laps, and bars of U shape at edges are
    drawn in the plan of the bottom. So are, of results, links against punching where they are needed, each leg a dot.

    Parameters
    ----------
    of : Model, Results or CombinationResult
        The model, or results of it; links are known from Results alone.
    path : str or pathlib.Path
        File to write: .dxf (in meters, on the layers OUTLINE, OPENINGS, COLUMNS, BAR_ZONES, BARS_BOTTOM_X, and so on,
        BARS_EDGES, LINKS, LABELS and TABLE), .svg, .pdf or .png; .csv or .xlsx for the bending schedule; .abs for
        records of BVBS, which machines that bend bars read. Neither schedule nor records have welded meshes. An
        existing file is replaced only if groundslab wrote it, or if it has records of BVBS alone.

    Returns
    -------
    pathlib.Path
        The path of the file.

    Raises
    ------
    InputError
        If no bars are laid, or for schedule and records meshes alone, if the file cannot be written, or if ezdxf
        (extra `dxf`) or XlsxWriter (`tables`) is missing.

    Examples
    --------
    >>> import groundslab
    >>> path = groundslab.write_bars(groundslab.load("case.toml"), "bars.dxf")
    """
    model = of if isinstance(of, Model) else of.model
    target = check(path)
    if model.reinforcement is None or not model.reinforcement.laid:
        hint = "give bottom_x, bottom_y, top_x and top_y, or bottom_mesh and top_mesh, in [reinforcement]"
        raise InputError([Issue("reinforcement", "no bars provided", "bars in all four layers", hint)])
    links = punching_links(of) if isinstance(of, Results) else ()
    if target.suffix.lower() in (RECORDS, TEXT, WORKBOOK):
        return _write_list(model, links, path, target)
    shapes = draw(model, links)
    if export.is_drawing(path):
        export.save_drawing(shapes, LAYERS, "Bars", path)
    else:
        from groundslab.views.bars.figure import to_figure
        from groundslab.views.plots.style import apply_style

        with apply_style():
            figure = to_figure(model.title, shapes)
        export.save([figure], path)
    return Path(path)


def _write_list(model: Model, links: Sequence[LinkLayout], path: str | Path, target: Path) -> Path:
    """Write the bending schedule, or records of BVBS."""
    schedule = schedule_of(model, links)
    if not len(schedule):
        raise InputError([Issue("reinforcement", "welded meshes alone", "bars, which are cut and bent")])
    if target.suffix.lower() == WORKBOOK:
        return xlsx.write_tables([schedule], model.title, path)
    content = schedule.csv().encode() if target.suffix.lower() == TEXT else to_bvbs(model, links).encode("ascii")
    export.write_file(path, target, content)
    return Path(path)


def left_out(of: Model | Results | CombinationResult, path: str | Path) -> list[str]:
    """Return what of the bars a schedule, or a file of records, does not have, in words."""
    model = of if isinstance(of, Model) else of.model
    ending = Path(path).suffix.lower()
    steel = model.reinforcement
    if steel is None or ending not in (RECORDS, TEXT, WORKBOOK):
        return []
    left = []
    if any(position.mesh for position in positions(model)):
        left.append("welded meshes are not in it: how they are cut into sheets is not known here")
    if ending == RECORDS and any(links.kind == "studs" for links in steel.links):
        left.append("studs are not in it: they are not bent")
    if isinstance(of, CombinationResult):
        left.append("links against punching are not in it: they follow from all combinations")
    return left


def check(path: str | Path) -> Path:
    """Return the full path if bars may be drawn or listed there; else raise InputError saying why not."""
    checks = {
        RECORDS: lambda: check_replaceable(path, _is_bvbs_file, "records of BVBS"),
        TEXT: lambda: check_replaceable(path, is_schedule, "a bending schedule of groundslab"),
        WORKBOOK: lambda: xlsx.check(path),
    }
    return checks.get(Path(path).suffix.lower(), lambda: export.check(path))()


def _is_bvbs_file(path: Path) -> bool:
    """Return whether a file has records of BVBS alone."""
    return is_bvbs(path.read_bytes().decode("ascii", "replace"))


def default_paths(folder: str | Path) -> tuple[Path, Path]:
    """Return where the drawings of a folder of results are put: beside the folder, as SVG and as DXF."""
    whole = Path(os.path.realpath(folder))
    return whole.with_name(f"{whole.name}-bars.svg"), whole.with_name(f"{whole.name}-bars.dxf")
