"""A case file to start from: the drawing's geometry and loads, the rest to be filled in."""

from __future__ import annotations

from groundslab import units
from groundslab.dxf.curves import Curve, Point
from groundslab.dxf.drawing import Drawing
from groundslab.dxf.words import quote

_ZONE = (
    "# [[plate.zones]]",
    '# thickness = "400 mm"        # fill in; E and nu may differ too',
)
_GROUND = (
    "# The ground under the plate; groundslab new shows other kinds.",
    "# [ground]",
    '# kind = "vlasov"',
    "# [[ground.layers]]            # from the top downwards, as many as there are",
    '# E = "20 MPa"                # fill in',
    "# nu = 0.3                    # fill in",
    '# thickness = "2 m"           # fill in',
)
_LOADS = (
    "# The loads, as many as there are.",
    "# [[loads]]",
    '# kind = "uniform"',
    '# q = "6.25 kPa"              # fill in',
)


def to_case(drawing: Drawing, title: str = "") -> str:
    """Return the text of a case file with the drawing's geometry and loads; the rest is there to be filled in."""
    text = [
        "# Input file of groundslab, made from a drawing. What no drawing says stands behind #. Where it says",
        '# "fill in", give your own value and take the # away, from the other lines of that section too.',
        "# Coordinates are the drawing's own. Loads and settlements are positive downwards.",
        "",
        f"title = {quote(title)}",
        "",
        "[plate]",
        '# thickness = "250 mm"        # fill in',
        '# E = "30 GPa"                # fill in',
        "# nu = 0.2                    # fill in",
        "",
        "[plate.outline]",
        'kind = "polygon"',
        *_curve_lines(drawing.outline),
    ]
    for opening in drawing.openings:
        text += ["", "[[plate.openings]]", 'kind = "polygon"', *_curve_lines(opening)]
    for number, zone in enumerate(drawing.zones, 1):
        shape = ["[plate.zones.shape]", 'kind = "polygon"', *_curve_lines(zone)]
        text += ["", f"# Zone {number} of the drawing.", *_ZONE, *(f"# {line}" for line in shape)]
    for number, column in enumerate(drawing.columns, 1):
        text += ["", f"# Column {number} of the drawing, for information only."]
        lines = _curve_lines(column) if isinstance(column, Curve) else [f"point = {_pair(column)}"]
        text += [f"#   {line}" for line in lines]
    text += ["", *_GROUND]
    for mark in drawing.point_loads:
        name = [f"name = {quote(mark.text)}"] if mark.text else []
        force = f'P = "{units.write(mark.value, "force")}"' if mark.value is not None else 'P = "50 kN"  # fill in'
        x, y = _metres(mark.x), _metres(mark.y)
        lines = ["[[loads]]", 'kind = "point"', *name, force, f"x = {x}", f"y = {y}"]
        text += ["", *(lines if mark.value is not None else (f"# {line}" for line in lines))]
    if all(mark.value is None for mark in drawing.point_loads):
        text += ["", *_LOADS]
    return "\n".join(text) + "\n"


def _curve_lines(curve: Curve) -> list[str]:
    """Return the lines of a closed curve; bulges only if it has arcs."""
    lines = ["points = [", *(f"  {_pair(point)}," for point in curve.points), "]"]
    if any(curve.bulges):
        lines.append(f"bulges = [{', '.join(repr(bulge or 0.0) for bulge in curve.bulges)}]")
    return lines


def _pair(point: Point) -> str:
    return f"[{_metres(point[0])}, {_metres(point[1])}]"


def _metres(value: float) -> str:
    """Return a coordinate with all its digits."""
    return f'"{repr(value or 0.0).removesuffix(".0")} m"'
