"""The commands plot and bars: what they understand, and what they do."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from groundslab.cli.console import EXIT_OK, print_stderr
from groundslab.errors import InputError, Issue

if TYPE_CHECKING:
    import argparse

#: Sizes of paper for sheets, as in views/drawing/sheets/paper.py, which the command line does without.
PAPERS = ("a1", "a2", "a3")


def describe(plot: argparse.ArgumentParser) -> None:
    """Add what the command plot understands."""
    plot.add_argument("folder", metavar="FOLDER", help="results folder written by groundslab solve")
    plot.add_argument(
        "fields",
        nargs="*",
        metavar="FIELD",
        help="what to draw, by name or symbol: settlement (w), rotation_x, rotation_y, gap (g), penetration (s), "
        "pressure (p), moment_x (m_x), moment_y, moment_xy, shear_x (q_x), shear_y; principal moments m_1, m_2; "
        "design moments bottom_x, bottom_y, top_x, top_y; of bars over all ultimate combinations "
        "required_bottom_x, required_bottom_y, required_top_x, required_top_y, "
        "provided_bottom_x, provided_bottom_y, provided_top_x, provided_top_y, "
        "utilization_bottom_x, utilization_bottom_y, utilization_top_x, utilization_top_y, "
        "missing_bottom_x, missing_bottom_y, missing_top_x, missing_top_y; discretization_error, "
        "large where the mesh is too coarse; stiffness_ratio of cracked slabs; membrane_x (n_x), membrane_y, "
        "membrane_xy with eccentric beams (default: the usual choice for the kind)",
    )
    plot.add_argument(
        "--kind",
        metavar="KIND",
        help="plan, deformed (the plate in space), lines (values along section lines), beams (their moments and "
        "shear forces), mesh (the elements), soil "
        "(layers, moduli, mode), stress (in the depth of a continuum, along section lines) or convergence (default: "
        "plan; lines if --line is given)",
    )
    plot.add_argument("--mesh", action="store_true", help="draw the elements over the fields, in plan and deformed")
    plot.add_argument(
        "--combination",
        action="append",
        metavar="NAME",
        help="combination to draw, may be repeated (default: all with a certified result)",
    )
    plot.add_argument(
        "--envelope",
        metavar="STATE",
        help="draw the largest and smallest values over the combinations of a limit state, such as ultimate or "
        "quasi-permanent; for plan, lines and beams",
    )
    plot.add_argument(
        "--line",
        action="append",
        metavar="X1,Y1,X2,Y2",
        help="section line in meters, may be repeated (default: those in the case)",
    )
    plot.add_argument(
        "--minus",
        metavar="FOLDER",
        help="other results, which are subtracted in plans: of the combination of the same name, or the only one; the "
        "scale has zero in its middle",
    )
    plot.add_argument(
        "--minus-combination", metavar="NAME", help="combination that is subtracted, of --minus or of the same results"
    )
    plot.add_argument(
        "--out",
        metavar="FILE",
        help="file to write: .pdf (pages of A4 width), .svg or .png (one sheet), or of a plan .dxf (contours and what "
        "lies on the plate, on layers); an existing one is replaced only if groundslab drew it (default: a PDF next to "
        "the folder)",
    )


def run(options: argparse.Namespace) -> int:
    """Draw figures of a folder of results into a file."""
    from pathlib import Path

    from groundslab.views import plots
    from groundslab.views.difference import choose_subtracted
    from groundslab.views.files import results_folder
    from groundslab.views.plots.export import check
    from groundslab.views.plots.panels import subtract
    from groundslab.views.plots.request import parse_request

    folder = Path(os.path.realpath(options.folder))
    lines = [_coordinates(text) for text in options.line] if options.line else None
    if options.out is not None:
        check(options.out)
    combined = results_folder.load_results(options.folder)
    request = parse_request(
        combined, options.fields, options.kind, options.combination, options.envelope, lines, options.mesh
    )
    if options.minus is not None or options.minus_combination is not None:
        other = combined if options.minus is None else results_folder.load_results(options.minus)
        request = subtract(request, choose_subtracted(other, options.minus_combination, "--minus-combination"))
    names = [quantity.name for quantity in request.quantities]
    what = "-".join(names) if options.fields and request.kind == "plan" else request.kind
    file = folder.with_name(f"{folder.name}-{what}.pdf") if options.out is None else Path(options.out)
    check(file)
    if folder in Path(os.path.realpath(file)).parents:
        hint = "solve could not replace the folder any more"
        raise InputError([Issue("--out", f"{file}, inside the folder of results", "a place outside it", hint)])
    pages = len(plots.write(request, file))
    print_stderr(f"wrote {file}" + (f", {pages} pages" if pages > 1 else ""))
    return EXIT_OK


def describe_bars(bars: argparse.ArgumentParser) -> None:
    """Add what the command bars understands."""
    bars.epilog = (
        "A plan of each face with one bar of each set, and the bar list by marks, with lengths and masses; laps "
        "and U-shaped bars at edges are in it if the case has [reinforcement.detailing]; so are links against punching "
        "where results need them. The bending schedule lists bars and links as they are cut and bent, without welded "
        "meshes, which are delivered as sheets; the building model has each bar in its place. An "
        "existing file is replaced only if groundslab wrote it."
    )
    bars.add_argument("results", metavar="RESULTS", help="results folder written by groundslab solve")
    bars.add_argument(
        "--out",
        metavar="FILE",
        help="file to write: .dxf, .svg, .pdf or .png for the drawing; .csv or .xlsx for the bending schedule; .abs "
        "for machines that bend bars (BVBS); .ifc for a building model (default: RESULTS-bars.svg and "
        "RESULTS-bars.dxf next to the folder)",
    )
    bars.add_argument(
        "--paper",
        metavar="SIZE",
        choices=PAPERS,
        help="a1, a2 or a3: draw sheets to scale, one for each layer, for edges and for links, with dimensions, a list "
        "of the bars and a title block, into a .pdf or .dxf file (default: RESULTS-bars-SIZE.pdf next to the folder)",
    )


def run_bars(options: argparse.Namespace) -> int:
    """Draw the bars of a folder of results."""
    from pathlib import Path

    from groundslab.views import bars
    from groundslab.views.files import results_folder

    targets = bars.default_paths(options.results, options.paper) if options.out is None else (Path(options.out),)
    for target in targets:
        bars.check(target, options.paper)
    results = results_folder.load_results(options.results)
    for target in targets:
        bars.write_bars(results, target, paper=options.paper)
        print_stderr(f"wrote {target}")
        for words in bars.left_out(results, target):
            print_stderr(f"note: {words}")
    return EXIT_OK


def _coordinates(text: str) -> list[float]:
    """Return the coordinates of a section line."""
    try:
        x1, y1, x2, y2 = map(float, text.split(","))
    except ValueError:
        raise InputError([Issue("--line", f'"{text}"', "four numbers x1,y1,x2,y2, in meters")]) from None
    return [x1, y1, x2, y2]
