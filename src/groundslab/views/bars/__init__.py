"""Bars that are laid: a plan of each face with a table of quantities (SVG, PDF, PNG, DXF), and records for benders."""

from __future__ import annotations

import os
from pathlib import Path

from groundslab.design.bars.proposal.links import punching_links
from groundslab.errors import InputError, Issue
from groundslab.model.model import Model
from groundslab.results.results import CombinationResult, Results
from groundslab.storage.ownership import check_replaceable
from groundslab.views.bars.bvbs import is_bvbs, to_bvbs
from groundslab.views.drawing.bars import LAYERS, draw
from groundslab.views.plots import export

#: What the name of a file with records of BVBS ends with.
RECORDS = ".abs"


def write_bars(of: Model | Results | CombinationResult, path: str | Path) -> Path:
    """Draw the bars provided: a plan of each face, and how many there are, how long, and what they weigh; or list them.

    One bar of each set stands for all of them, with a line across over which they are distributed, its marks, number,
    diameter, spacing and length. With `reinforcement.detailing` lengths have laps, and bars of U shape at edges are
    drawn in the plan of the bottom. So are, of results, links against punching where they are needed, each leg a dot.

    Parameters
    ----------
    of : Model, Results or CombinationResult
        The model, or results of it; links are known from Results alone.
    path : str or pathlib.Path
        File to write: .dxf (in meters, on the layers OUTLINE, OPENINGS, COLUMNS, BAR_ZONES, BARS_BOTTOM_X, and so on,
        BARS_EDGES, LINKS, LABELS and TABLE), .svg, .pdf or .png; .abs for records of BVBS, which machines that bend
        bars read, of straight and U-shaped bars without meshes and links. An existing file is replaced only if
        groundslab drew it, or if it has records of BVBS alone.

    Returns
    -------
    pathlib.Path
        The path of the file.

    Raises
    ------
    InputError
        If no bars are laid, or for records meshes alone, if the file cannot be written, or if ezdxf is missing (extra
        `dxf`).

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
    if target.suffix.lower() == RECORDS:
        if not (records := to_bvbs(model)):
            raise InputError([Issue("reinforcement", "welded meshes alone", "bars, which records of BVBS are of")])
        export.write_file(path, target, records.encode("ascii"))
        return Path(path)
    shapes = draw(model, punching_links(of) if isinstance(of, Results) else ())
    if export.is_drawing(path):
        export.save_drawing(shapes, LAYERS, "Bars", path)
    else:
        from groundslab.views.bars.figure import to_figure
        from groundslab.views.plots.style import apply_style

        with apply_style():
            figure = to_figure(model.title, shapes)
        export.save([figure], path)
    return Path(path)


def check(path: str | Path) -> Path:
    """Return the full path if bars may be drawn or listed there; else raise InputError saying why not."""
    if Path(path).suffix.lower() != RECORDS:
        return export.check(path)
    return check_replaceable(path, _is_bvbs_file, "records of BVBS")


def _is_bvbs_file(path: Path) -> bool:
    """Return whether a file has records of BVBS alone."""
    return is_bvbs(path.read_bytes().decode("ascii", "replace"))


def default_paths(folder: str | Path) -> tuple[Path, Path]:
    """Return where the drawings of a folder of results are put: beside the folder, as SVG and as DXF."""
    whole = Path(os.path.realpath(folder))
    return whole.with_name(f"{whole.name}-bars.svg"), whole.with_name(f"{whole.name}-bars.dxf")
