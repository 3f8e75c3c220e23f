"""Figures of results, drawn by Matplotlib without a display: plans, the deformed plate, lines, soil, convergence."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab.results.results import Combined, Results, alone

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from groundslab.views.plots.request import PlotRequest

#: More panels than this are too many for one sheet.
MOST_PANELS = 24
#: Pixels per inch of the picture of `solve --plot`: enough for a screen, in a small file.
PICTURE_DPI = 140


def plot(
    results: Results | Combined,
    *fields: str,
    kind: str | None = None,
    combination: str | Sequence[str] | None = None,
    envelope: str | None = None,
    line: Sequence[Any] | None = None,
    to: str | Path | None = None,
) -> Figure:
    """Return a figure of results, and write it into a file if one is named (.pdf, .svg or .png).

    Fields are those of results.PLATE_FIELDS by name or symbol, m_1, m_2, bottom_x, bottom_y, top_x and top_y. Kinds are
    plan (if nothing is said), deformed, lines (if a line is given), soil and convergence; docs/plots.md shows each.
    Without a combination all certified ones are drawn. An envelope is that of a limit state; a line is x1, y1, x2, y2
    in meters, or several of these. A PDF has pages of A4 width, other files are one sheet. A file that exists is
    replaced only if groundslab drew it. Raises InputError.
    """
    from groundslab.views.plots import export
    from groundslab.views.plots.request import parse_request

    combined = alone(results) if isinstance(results, Results) else results
    request = parse_request(combined, fields, kind, combination, envelope, line)
    if to is None:
        return _sheet(request)
    export.check(to)
    written = write(request, to)
    return written[0] if len(written) == 1 else _sheet(request)


def write(request: PlotRequest, path: str | Path) -> list[Figure]:
    """Write what is wished for into a file, a PDF page by page and else one sheet, and return what was drawn."""
    from groundslab.views.plots import export
    from groundslab.views.plots.style import apply_style

    if export.file_format(path) == "pdf":
        with apply_style():
            figures: list[Figure] = _drawing_module(request).draw_pages(request)
    else:
        figures = [_sheet(request)]
    export.save(figures, path)
    return figures


def write_picture(results: Results, path: Path) -> None:
    """Write the picture of `solve --plot`, settlement and contact pressure in plan, as a PNG file."""
    from groundslab.views.plots import export

    export.save([plot(results)], path, dpi=PICTURE_DPI)


def _sheet(request: PlotRequest) -> Figure:
    """Return one sheet with all that is wished for; raises InputError if that is too much."""
    from groundslab.errors import InputError, Issue
    from groundslab.views.plots.style import apply_style

    count = request.panel_count
    if count > MOST_PANELS:
        hint = "name fewer fields or combinations, or write a PDF, which has pages"
        raise InputError([Issue("combination", f"{count} panels on one sheet", f"at most {MOST_PANELS}", hint)])
    with apply_style():
        figure: Figure = _drawing_module(request).draw_sheet(request)
    return figure


def _drawing_module(request: PlotRequest) -> Any:
    """Return the module that draws a kind."""
    from groundslab.views.plots import convergence, deformed, plan, sections, soil

    modules = {"plan": plan, "deformed": deformed, "lines": sections, "soil": soil, "convergence": convergence}
    return modules[request.kind]
