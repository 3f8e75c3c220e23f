"""Figures of results, drawn by Matplotlib without a display: plans, the deformed plate, lines, soil, convergence."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab.errors import InputError, Issue
from groundslab.results.results import CombinationResult, Results, results_of
from groundslab.schema.wording import quote

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from groundslab.views.plots.request import PlotRequest

#: More panels than this are too many for one sheet.
MOST_PANELS = 24
#: Pixels per inch of the picture of `solve --plot`: enough for a screen, in a small file.
PICTURE_DPI = 140


def plot(
    results: CombinationResult | Results,
    *fields: str,
    kind: str | None = None,
    combination: str | Sequence[str] | None = None,
    envelope: str | None = None,
    line: Sequence[Any] | None = None,
    mesh: bool = False,
    minus: CombinationResult | Results | None = None,
    to: str | Path | None = None,
) -> Figure:
    """Draw results, and write the figure into a file if one is named.

    Parameters
    ----------
    results : Results or Combined
        Results of one or of several combinations.
    *fields : str
        Quantities to draw, by name or symbol, as docs/plots.md lists them: nodal fields of the plate ("settlement" or
        "w", "moment_x" or "m_x", ...), principal moments "m_1" and "m_2", design moments "bottom_x", ...,
        "stiffness_ratio", "membrane_x", "discretization_error", bars "required_bottom_x", ... Or a usual choice.
    kind : str, optional
        "plan" (default), "deformed", "lines" (with a line), "beams", "mesh", "soil", "stress" or "convergence".
    combination : str or sequence of str, optional
        Names of the combinations to draw; without any, all that are certified.
    envelope : str, optional
        Limit state whose combinations are drawn by their largest and smallest values, for plans, lines and beams.
    line : sequence of float, optional
        Section line x1, y1, x2, y2 [m], or several of these; without any, the lines of the case.
    mesh : bool, default: False
        Whether the elements' sides are drawn over the fields, in plans and on the deformed plate.
    minus : CombinationResult or Results, optional
        Other results, on any mesh, subtracted in plans: the combination of the same name, or the only one.
    to : str or Path, optional
        File to write: .pdf (pages of A4 width), .svg or .png (one sheet), or of a plan .dxf (contours and what lies on
        the plate, on layers, where the case has them). An existing file is replaced only if groundslab drew it.

    Returns
    -------
    matplotlib.figure.Figure
        The figure, which notebooks show by themselves.

    Raises
    ------
    InputError
        If the request does not fit the results, or the file cannot be written; lists all issues at once.

    Examples
    --------
    >>> import groundslab
    >>> results = groundslab.solve(groundslab.load("case.toml"))
    >>> figure = groundslab.plot(results, "settlement", "m_x")
    """
    from groundslab.views.plots.panels import subtract
    from groundslab.views.plots.request import parse_request

    combined = results_of(results)
    request = parse_request(combined, fields, kind, combination, envelope, line, mesh)
    return _drawn(request if minus is None else subtract(request, minus), to)


def _drawn(request: PlotRequest, to: str | Path | None) -> Figure:
    """Return the figure of a request, which is written into a file if one is named."""
    from groundslab.views.plots import export

    if to is None:
        return _sheet(request)
    export.check(to)
    written = write(request, to)
    return written[0] if len(written) == 1 else _sheet(request)


def write(request: PlotRequest, path: str | Path) -> list[Figure]:
    """Draw a request into a file, a PDF page by page and else on one sheet, and return the figures; none of a DXF."""
    from groundslab.views.plots import export
    from groundslab.views.plots.style import apply_style, show_for

    if export.is_drawing(path):
        from groundslab.views.plots.dxf.plan import draw_plan

        if request.kind != "plan":
            raise InputError([Issue("kind", quote(request.kind), '"plan" as a drawing (DXF)')])
        with apply_style():
            shapes, layers = draw_plan(request)
        export.save_drawing(shapes, layers, "Results", path, request.combined.model.units)
        return []
    if export.file_format(path) == "pdf":
        with apply_style():
            drawn: list[Figure] = _drawing_module(request).draw_pages(request)
            figures = [show_for(figure, request.combined) for figure in drawn]
    else:
        figures = [_sheet(request)]
    export.save(figures, path)
    return figures


def write_picture(results: CombinationResult, path: Path) -> None:
    """Write the picture of `solve --plot`, settlement and contact pressure in plan, as a PNG file."""
    from groundslab.views.plots import export

    export.save([plot(results)], path, dpi=PICTURE_DPI)


def _sheet(request: PlotRequest) -> Figure:
    """Return one sheet with all panels of a request; raises InputError if they are too many."""
    from groundslab.views.plots.style import apply_style, show_for

    count = request.panel_count
    if count > MOST_PANELS:
        hint = "name fewer fields or combinations, or write a PDF, which has pages"
        raise InputError([Issue("combination", f"{count} panels on one sheet", f"at most {MOST_PANELS}", hint)])
    with apply_style():
        return show_for(_drawing_module(request).draw_sheet(request), request.combined)


def _drawing_module(request: PlotRequest) -> Any:
    """Return the module that draws a kind."""
    from groundslab.views.plots import beams, convergence, deformed, plan, sections
    from groundslab.views.plots.ground import soil, stress

    modules = {
        "deformed": deformed, "lines": sections, "beams": beams, "soil": soil, "stress": stress,
        "convergence": convergence,
    }  # fmt: skip
    return modules.get(request.kind, plan)
