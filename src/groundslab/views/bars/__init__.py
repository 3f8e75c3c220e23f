"""Bars that are laid: plans with quantities (SVG, PDF, PNG, DXF), the bending schedule, and records for benders."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from groundslab.design.bars.placed import placed_bars
from groundslab.design.bars.positions import U_SHAPE, positions, thicknesses
from groundslab.design.bars.proposal.links import punching_links
from groundslab.design.rules.punching_links.layout import LinkLayout
from groundslab.errors import InputError, Issue
from groundslab.languages import translator
from groundslab.model.model import Model
from groundslab.results.results import CombinationResult, Results
from groundslab.schema.wording import listed, quote
from groundslab.storage.ownership import check_replaceable, is_figure
from groundslab.views.bars.bvbs import is_bvbs, to_bvbs
from groundslab.views.bars.schedule import is_schedule, schedule_of
from groundslab.views.drawing.bars import LAYERS, draw
from groundslab.views.drawing.shapes import Shape
from groundslab.views.drawing.sheets.draw import LAYERS as SHEET_LAYERS
from groundslab.views.drawing.sheets.draw import draw_sheets, in_one_drawing
from groundslab.views.drawing.sheets.paper import PAPERS, Paper, Sheet
from groundslab.views.files import xlsx
from groundslab.views.plots import export
from groundslab.views.tables.bending_schedule import NO_DETAILING

#: What the names of files end with: of records of BVBS, of bending schedules as text and as workbooks.
RECORDS, TEXT, WORKBOOK = ".abs", ".csv", ".xlsx"
#: What that of a building model ends with.
BUILDING = ".ifc"


def write_bars(of: Model | Results | CombinationResult, path: str | Path, *, paper: Paper | None = None) -> Path:
    """Draw the bars provided: a plan of each face, and how many there are, how long, and what they weigh; or list them.

    The bending schedule lists bars and links as they are cut and bent, with their masses by diameter and altogether.

    One bar of each set stands for all of them, with a line across over which they are distributed, its marks, number,
    diameter, spacing and length. With `reinforcement.detailing` lengths have laps, and bars of U shape at edges are
    drawn in the plan of the bottom. So are, of results, links against punching where they are needed, each leg a dot.

    On paper there is a sheet for each layer, for bars at edges each way, and for links, to one of the scales 1:25,
    1:50, 1:75, 1:100 and 1:200, with dimensions of zones and columns, a list of the bars and a title block: in a PDF a
    page each, in a DXF file, which has the layers DIMENSIONS, FRAME and TITLE too, beside each other.

    Parameters
    ----------
    of : Model, Results or CombinationResult
        The model, or results of it; links are known from Results alone.
    path : str or pathlib.Path
        File to write: .dxf (in meters, on the layers OUTLINE, OPENINGS, COLUMNS, BAR_ZONES, BARS_BOTTOM_X, and so on,
        BARS_EDGES, LINKS, LABELS and TABLE), .svg, .pdf or .png; .csv or .xlsx for the bending schedule; .abs for
        records of BVBS, which machines that bend bars read; .ifc for a building model of the bars one by one. None of
        these has welded meshes, and the building model no links against one-way shear: `left_out_of_bars` says
        so. An existing file is replaced only if groundslab wrote it, or if it has records of BVBS alone.
    paper : str, optional
        "a1", "a2" or "a3": draw sheets, into a file that ends with .pdf or .dxf.

    Returns
    -------
    pathlib.Path
        The path of the file.

    Raises
    ------
    InputError
        If no bars are laid, or for schedule, records and building model meshes alone, if the file cannot be written,
        or if ezdxf (extra `dxf`), XlsxWriter (`tables`) or IfcOpenShell (`ifc`) is missing.

    Examples
    --------
    >>> import groundslab
    >>> path = groundslab.write_bars(groundslab.load("case.toml"), "bars.dxf")
    """
    model = of if isinstance(of, Model) else of.model
    target = check(path, paper)
    if model.reinforcement is None or not model.reinforcement.laid:
        hint = "give bottom_x, bottom_y, top_x and top_y, or bottom_mesh and top_mesh, in [reinforcement]"
        raise InputError([Issue("reinforcement", "no bars provided", "bars in all four layers", hint)])
    links = punching_links(of) if isinstance(of, Results) else ()
    if target.suffix.lower() in (RECORDS, TEXT, WORKBOOK):
        return _write_list(model, links, path, target)
    if target.suffix.lower() == BUILDING:
        return _write_building(model, links, path, target)
    if paper is not None:
        return _write_sheets(draw_sheets(model, links, paper), model, path, target)
    return _write_drawing(draw(model, links), model, path)


def _write_drawing(shapes: Sequence[Shape], model: Model, path: str | Path) -> Path:
    """Write the drawing of all bars, as a DXF file or as a figure."""
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
    if not content:
        raise InputError([Issue("reinforcement", "no bars that are bent, studs alone", "bars, which are cut and bent")])
    export.write_file(path, target, content)
    return Path(path)


def left_out_of_bars(of: Model | Results | CombinationResult, path: str | Path) -> tuple[str, ...]:
    """Return what a file of bars does not hold, or in another way than the case does, as the command says it.

    Parameters
    ----------
    of : Model, Results or CombinationResult
        What is given to `write_bars`.
    path : str or pathlib.Path
        The file that it writes; what it holds follows from what its name ends with. It is not read.

    Returns
    -------
    tuple of str
        Of drawings nothing: what they lack is written on them.

    Examples
    --------
    >>> import groundslab
    >>> model = groundslab.load("case.toml")
    >>> for words in groundslab.left_out_of_bars(model, groundslab.write_bars(model, "bars.csv")):
    ...     print(words)
    """
    return tuple(left_out(of, path))


def left_out(of: Model | Results | CombinationResult, path: str | Path) -> list[str]:
    """Return what of the bars a schedule, records or a building model do not have, or not as it is, in words."""
    model = of if isinstance(of, Model) else of.model
    ending = Path(path).suffix.lower()
    steel = model.reinforcement
    if steel is None or ending not in (RECORDS, TEXT, WORKBOOK, BUILDING):
        return []
    left = []
    listed = positions(model)
    if steel.laid and steel.detailing is None:
        left.append(NO_DETAILING)
    if any(position.shape == U_SHAPE for position in listed) and len(thicknesses(model)) > 1:
        left.append("bars around edges are all as high as the thickest slab at an edge")
    if any(position.mesh for position in listed):
        left.append("welded meshes are not in it: how they are cut into sheets is not known here")
    if ending == RECORDS and any(links.kind == "studs" for links in steel.links):
        left.append("studs are not in it: they are not bent")
    if ending == BUILDING and steel.shear_links:
        left.append("links against one-way shear are not in it: they do not stand one by one here")
    if isinstance(of, CombinationResult):
        left.append("links against punching are not in it: they follow from all combinations")
    return left


def _write_building(model: Model, links: Sequence[LinkLayout], path: str | Path, target: Path) -> Path:
    """Write all bars as a building model."""
    from groundslab.views.bars.ifc import to_bytes

    if not (placed := placed_bars(model, links)):
        raise InputError(
            [Issue("reinforcement", "no bars that lie one by one", "bars in layers, or links against punching")]
        )
    export.write_file(path, target, to_bytes(model, placed))
    return Path(path)


def _check_building(path: str | Path) -> Path:
    """Return the full path if a building model may be written there; else raise InputError."""
    from groundslab.views.bars.ifc import check as check_ifc

    return check_ifc(path)


def _write_sheets(sheets: Sequence[Sheet], model: Model, path: str | Path, target: Path) -> Path:
    """Write sheets into a PDF or a DXF file."""
    if export.is_drawing(path):
        export.save_drawing(in_one_drawing(sheets), SHEET_LAYERS, "Bars", path)
    else:
        from groundslab.views.bars.sheet_pdf import to_pdf

        say = translator(model.language)
        export.write_file(path, target, to_pdf(model.title, sheets, model.language, say))
    return Path(path)


def _check_sheets(path: str | Path, paper: Paper) -> Path:
    """Return the full path if sheets may be drawn there; else raise InputError."""
    ending = Path(path).suffix.lower()
    if paper not in PAPERS:
        raise InputError([Issue("paper", f'"{paper}"', f"one of {listed(PAPERS)}")])
    if ending not in (".pdf", export.DRAWING):
        raise InputError(
            [Issue(str(path), f"a name that ends with {quote(ending)}", ".pdf or .dxf for sheets of paper")]
        )
    if export.is_drawing(path):
        return export.check(path)
    return check_replaceable(path, _is_pdf_of_bars, "a drawing of bars by groundslab")


def _is_pdf_of_bars(path: Path) -> bool:
    """Return whether a file is a PDF in which groundslab drew bars, on sheets or all in one figure."""
    from groundslab.views.bars.sheet_pdf import is_ours

    return is_ours(path) or is_figure(path)


def check(path: str | Path, paper: Paper | None = None) -> Path:
    """Return the full path if bars may be drawn or listed there; else raise InputError saying why not."""
    if paper is not None:
        return _check_sheets(path, paper)
    checks = {
        RECORDS: lambda: check_replaceable(path, _is_bvbs_file, "records of BVBS"),
        TEXT: lambda: check_replaceable(path, is_schedule, "a bending schedule of groundslab"),
        WORKBOOK: lambda: xlsx.check(path),
        BUILDING: lambda: _check_building(path),
    }
    return checks.get(Path(path).suffix.lower(), lambda: export.check(path))()


def _is_bvbs_file(path: Path) -> bool:
    """Return whether a file has records of BVBS alone."""
    return is_bvbs(path.read_bytes().decode("ascii", "replace"))


def default_paths(folder: str | Path, paper: Paper | None = None) -> tuple[Path, ...]:
    """Return where the drawings of a folder of results are put: beside it, as SVG and as DXF, or sheets as PDF."""
    whole = Path(os.path.realpath(folder))
    if paper is not None:
        return (whole.with_name(f"{whole.name}-bars-{paper}.pdf"),)
    return whole.with_name(f"{whole.name}-bars.svg"), whole.with_name(f"{whole.name}-bars.dxf")
