"""The commands that read or make case files: check, new, dxf, schema."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from groundslab.cli.console import EXIT_DESIGN_FAILS, EXIT_OK, EXIT_WRONG_INPUT, print_stderr, print_stdout
from groundslab.errors import InputError, Issue

if TYPE_CHECKING:
    import argparse
    from collections.abc import Sequence

    from groundslab.exchange.dxf.document import Layers
    from groundslab.model.loads.load_cases import Combination
    from groundslab.model.model import Model


def describe_dxf(dxf: argparse.ArgumentParser) -> None:
    """Add what the command dxf understands."""
    dxf.add_argument("drawing", metavar="DRAWING", help="drawing (DXF)")
    dxf.add_argument(
        "--layers",
        nargs="+",
        action="extend",
        default=[],
        metavar="WHAT=NAME",
        help="names of layers; WHAT is outline, openings, zones, columns, walls, beams, point_loads, line_loads "
        "or area_loads, whose usual layers are OUTLINE, OPENINGS, ZONES, COLUMNS, WALLS, BEAMS, LOADS, LOAD_LINE and "
        "LOAD_AREA",
    )
    dxf.add_argument("--unit", help='unit of the drawing, such as "mm" (default: the one stated in the drawing)')
    dxf.add_argument(
        "--close-gaps",
        default="1 mm",
        metavar="LENGTH",
        help="widest gap to close between the ends of lines, if no wider than a tenth of the adjoining edges "
        '(default: "1 mm"; "0 mm" closes none)',
    )
    dxf.add_argument(
        "--union", action="store_true", help="join outlines that adjoin each other, such as of a house and its porch"
    )
    describe_place(dxf, "drawing")
    dxf.add_argument("--out", metavar="FILE", help="file to write (default: print the text)")


def describe_place(parser: argparse.ArgumentParser, source: str) -> None:
    """Add where the plan of a drawing or a building lies in the case."""
    parser.add_argument(
        "--origin",
        choices=("own", "center"),
        default="own",
        help=f"where coordinates are measured from: the {source}'s own origin, or the middle of the slab, "
        "which is better in a national grid (default: own)",
    )
    parser.add_argument(
        "--align",
        action="store_true",
        help="turn the plan so that the slab's longest edge runs along x or y; rectangular columns that run along it "
        "then stay rectangles",
    )


def describe_check(check: argparse.ArgumentParser) -> None:
    """Add what the command check understands."""
    check.epilog = (
        "Combinations whose loads the ground and supports cannot balance are listed: the foundation fails, and the "
        "exit code is 3. Other design checks need a solution."
    )
    check.add_argument("case", help="case file or study file (TOML)")
    check.add_argument("--json", action="store_true", help="print what was found as JSON, the issues among it")


def check_case(options: argparse.Namespace) -> int:
    """Read a case file, or a study file with its case; wrong ones raise InputError."""
    if options.json:
        return _check_as_json(options.case)
    from groundslab.case import casefile

    tables = casefile.tables(casefile.read(options.case), options.case)
    if "sampling" in tables:
        from groundslab.study import describe_file

        print_stdout("\n".join(describe_file(Path(options.case))))
        return EXIT_OK
    model = casefile.from_table(tables, Path(options.case).parent)
    from groundslab.analysis.check import check, find_unbalanced
    from groundslab.messages import Message, Name, words_in
    from groundslab.model.combinations import list_combinations
    from groundslab.model.remarks.remarks import find_remarks

    check(model)
    lost = find_unbalanced(model)
    verdict = "FOUNDATION FAILS" if lost else "fine"
    what = f"in all, {len(model.every_plate)} plates" if model.plates else "plate"
    loads = f"{len(model.loads)} load{'s' if len(model.loads) > 1 else ''}"
    lines: list[str] = [
        Message(
            "{case}: {verdict} ({length:g m} x {width:g m} {what}, {ground} ground, {loads})",
            case=Name(options.case),
            verdict=verdict,
            length=model.sides[0],
            width=model.sides[1],
            what=what,
            ground=model.ground.kind,
            loads=loads,
        )
    ]
    combinations = list_combinations(model)
    lines += [
        Message('  no equilibrium in "{name}": {error}', name=Name(name), error=str(error))
        for name, error in lost.items()
    ]
    lines += _structure_and_supports(model) + _cases_and_combinations(model, combinations)
    lines += [Message("  remark: {words}", words=remark.words) for remark in find_remarks(model, combinations)]
    print_stdout("\n".join(words_in(line, model.units) for line in lines))
    return EXIT_DESIGN_FAILS if lost else EXIT_OK


def _check_as_json(file: str) -> int:
    """Print the check of a case file or study file as JSON, of a wrong one with its issues."""
    from groundslab.study.check import check_file
    from groundslab.views.interface.documents import to_text

    document = check_file(Path(file), file)
    print_stdout(to_text(document))
    return {"fine": EXIT_OK, "no equilibrium": EXIT_DESIGN_FAILS, "wrong input": EXIT_WRONG_INPUT}[document["status"]]


def _structure_and_supports(model: Model) -> list[str]:
    """Return the columns, walls, cores, beams, building and supports of a model in words, a line each."""
    from groundslab.messages import Message, Name, joined

    lines = [*_columns(model), *_walls(model), *_cores(model), *_beams(model)]
    if (above := model.building) is not None:
        count = len(above.storeys)
        listed = f"{count} storey{'s' * (count > 1)}"
        storeys = (
            Message("{listed}, {height:g m} high", listed=listed, height=sum(above.storeys)) if count else "a matrix"
        )
        on = f"on {len(above.names)} columns and walls{_share(above.stiffness)}"
        lines.append(Message("  building: {storeys}, {on}", storeys=storeys, on=on))
    for number, support in enumerate(model.supports, 1):
        *others, end = support.points
        start = [Message("{place:at (m)}", place=point) for point in others]
        where = joined([*start, Message("{place:at m}", place=end)], " to ")
        firm = "elastic" if support.elastic else "rigid"
        words = f"{support.kind}, {firm}, acts {support.acts}"
        name = Name(support.name or str(number))
        lines.append(Message("  support {name}: {words}, at {where}", name=name, words=words, where=where))
    return lines


def _columns(model: Model) -> list[str]:
    """Return the columns in words."""
    from groundslab.messages import Message, Name
    from groundslab.model.axes.crossings import name_of_crossing

    lines: list[str] = []
    for column in model.columns:
        if column.diameter is not None:
            size = Message("diameter {diameter:g m}", diameter=column.diameter)
        else:
            turned = f", turned by {column.angle:g} degrees," if column.angle else ""
            assert column.width_x is not None
            assert column.width_y is not None
            size = Message("{x:g m} x {y:g m}{turned}", x=column.width_x, y=column.width_y, turned=turned)
        crossing = name_of_crossing((column.x, column.y), model.axes)
        about = {"column": Name(column.name), "size": size, "crossing": Name(crossing and f"{crossing}, ")}
        lines.append(
            Message("  column {column}: {size} at {crossing}{place:at m}", **about, place=(column.x, column.y))
        )
    return lines


def _walls(model: Model) -> list[str]:
    """Return the walls in words."""
    from groundslab.messages import Message, Name, joined

    lines: list[str] = []
    for wall in model.placed_walls:
        parts = [Message("{thickness:g m} thick, {length:.6g m} long", thickness=wall.thickness, length=wall.length)]
        if wall.height is not None:
            share = _share(wall.stiffness)
            parts.append(Message("a deep beam {height:g m} high{share}", height=wall.height, share=share))
        parts += [
            Message(
                "an opening {height:g m} high from {start:g m} to {end:g m}",
                height=hole.height,
                start=hole.start,
                end=hole.end,
            )
            for hole in wall.openings
        ]
        lines.append(Message("  wall {wall}: {size}", wall=Name(wall.name), size=joined(parts)))
    return lines


def _cores(model: Model) -> list[str]:
    """Return the cores in words."""
    from groundslab.messages import Message, Name
    from groundslab.model.structure.cores import section_of

    sections = [(core.name, section_of(core, model.walls, model.every_plate)) for core in model.cores]
    return [
        Message(
            "  core {core}: {area:.4g m2} in plan about {center:at m}",
            core=Name(name),
            area=section.area,
            center=section.center,
        )
        for name, section in sections
    ]


def _beams(model: Model) -> list[str]:
    """Return the beams in words."""
    from groundslab.messages import Message, Name

    lines: list[str] = []
    for beam in model.beams:
        section = beam.section
        what: str = "a section by its properties"
        if section.kind != "properties":
            assert section.width is not None
            assert section.height is not None
            sides = {"width": section.width, "height": section.height}
            what = Message("{kind} of {width:g m} x {height:g m}", kind=section.kind, **sides)
        lines.append(
            Message(
                "  beam {beam}: {what}{eccentric}, {length:.6g m} long{share}",
                beam=Name(beam.name),
                what=what,
                eccentric=", eccentric" * beam.eccentric,
                length=beam.length,
                share=_share(beam.stiffness),
            )
        )
    return lines


def _share(stiffness: float) -> str:
    """Return the share of a stiffness that is taken, in words; none for all of it."""
    return "" if stiffness == 1 else f", {100 * stiffness:g} % of its stiffness"


def _cases_and_combinations(model: Model, combinations: Sequence[Combination]) -> list[str]:
    """Return the load cases of a model, where they act, and what is solved of them in words, a line each."""
    if not model.cases:
        return []
    from groundslab.messages import Message, Name
    from groundslab.model.remarks.case_use import case_uses
    from groundslab.views.summary.combinations import factors_text

    cases: list[str] = [
        Message("  case {case}: {about}; {words}", case=Name(use.case.name), about=use.about(), words=use.words())
        for use in case_uses(model, combinations)
    ]
    return (
        cases
        + _sums(model)
        + [
            Message(
                "  combination {name} ({state}): {factors}",
                name=Name(combination.name),
                state=combination.limit_state,
                factors=factors_text(combination),
            )
            for combination in combinations
        ]
    )


def _sums(model: Model) -> list[str]:
    """Return force and moments of each load case about the middle of the plan in words, a line each."""
    from groundslab.messages import Message, Name
    from groundslab.model.remarks.resultants import case_sums, middle

    about = middle(model)
    return [
        Message(
            "  sum of case {case}: F = {F:.6g kN}, M_x = {M_x:.6g kNm}, M_y = {M_y:.6g kNm} about {about:at m}",
            case=Name(name),
            F=total.F / 1e3,
            M_x=total.M_x / 1e3,
            M_y=total.M_y / 1e3,
            about=about,
        )
        for name, total in case_sums(model).items()
    ]


def write_starter(options: argparse.Namespace) -> int:
    """Write a case file to start from; an existing file is left alone."""
    from groundslab.case import casefile

    write_or_print(casefile.starter(), options.file)
    if options.file is not None:
        print_stderr(f"wrote {options.file}; next: groundslab solve {options.file}")
    return EXIT_OK


def convert_drawing(options: argparse.Namespace) -> int:
    """Make a case file from a drawing; an existing file is left alone."""
    from groundslab.exchange import dxf as drawings

    layers, gap = _layers(options.layers), drawings.parse_gap(options.close_gaps)
    drawing = drawings.read(options.drawing, layers, options.unit, gap, options.union)
    if options.origin == "center":
        drawing = drawings.center(drawing)
    if options.align:
        drawing = drawings.align(drawing)
    write_or_print(drawings.to_case(drawing, Path(options.drawing).stem), options.out)
    print_stderr(drawings.report_text(drawing).rstrip("\n"))
    if options.out is not None:
        print_stderr(f"\nwrote {options.out}; next: fill in the missing values, then groundslab check {options.out}")
    return EXIT_OK


def _layers(pairs: Sequence[str]) -> Layers:
    """Return the layers that WHAT=NAME name, the others under their usual names."""
    from dataclasses import fields

    from groundslab.exchange.dxf.document import Layers
    from groundslab.schema.wording import describe, listed, suggestion

    roles = [field.name for field in fields(Layers)]
    names: dict[str, str] = {}
    issues = []
    for pair in pairs:
        what, sign, name = pair.partition("=")
        if not sign or what not in roles:
            expected = f"WHAT=NAME, WHAT being {listed(roles)}"
            issues.append(Issue("--layers", describe(pair), expected, suggestion(what, roles)))
        elif what in names:
            issues.append(Issue("--layers", f"{what} twice", "one layer for it"))
        names[what] = name
    if issues:
        raise InputError(issues)
    return Layers(**names)


def write_or_print(text: str, file: str | None) -> None:
    """Write a text to a new file, or print it if there is none; an existing file is left alone."""
    if file is None:
        print_stdout(text.rstrip("\n"))
        return
    from groundslab.storage import atomic

    try:
        atomic.write(Path(file), text.encode(), new=True)
    except FileExistsError:
        raise InputError([Issue(file, "a file that exists", "a name that is free", "choose another name")]) from None


def print_schema(_: argparse.Namespace) -> int:
    """Print the JSON schema of a case file."""
    import json

    from groundslab.model.model import json_schema

    print_stdout(json.dumps(json_schema(), indent=2))
    return EXIT_OK
