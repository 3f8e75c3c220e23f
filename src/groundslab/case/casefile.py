"""The input file: TOML with units to a Model and back, and a file to start from."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from groundslab.errors import InputError, Issue
from groundslab.model.model import Model
from groundslab.schema.base import Section, key_of, nested
from groundslab.schema.fields import FROM_FILE
from groundslab.schema.wording import describe, quote

LARGEST = 10_000_000  # bytes of a file
MOST_KEYS = 10  # joined by dots; those of a case are five at most, and tomllib's time grows with their square
_KEY = r"""(?:[\w-]++|"(?:[^"\\\n]|\\.)*+"|'[^'\n]*+')"""
_DOTTED = re.compile(rf"{_KEY}(?:[ \t]*+\.[ \t]*+{_KEY})*+")
_PLACE = re.compile(r"\s*\(at (?:line (\d+), column (\d+)|end of document)\)$")
_BARE_UNIT = re.compile(r"=\s*[-+0-9.eE]+\s*[A-Za-zµμ]")


def load(path: str | Path) -> Model:
    """Read a model from a case file.

    Parameters
    ----------
    path : str or pathlib.Path
        The case file (TOML).

    Returns
    -------
    Model
        The model.

    Raises
    ------
    InputError
        If the file cannot be read or describes no model; it lists all issues.

    Examples
    --------
    >>> import groundslab
    >>> groundslab.load(folder / "case.toml").plate.thickness
    0.3
    """
    return loads(read(path), str(path))


def read(path: str | Path) -> str:
    """Return the text of a TOML file; raises InputError if it cannot be read."""
    try:
        with Path(path).open("rb") as file:
            content = file.read(LARGEST + 1)
    except FileNotFoundError:
        raise _unreadable(path, "no file of that name") from None
    except IsADirectoryError:
        raise _unreadable(path, "a directory") from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise _unreadable(path, f"a file that cannot be read ({reason})") from None
    if len(content) > LARGEST:
        raise _unreadable(path, "a larger file", f"a TOML file of at most {LARGEST // 1_000_000} MB")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        where = f"{path}, line {line}"
        raise InputError([Issue(where, "bytes that are not UTF-8", "UTF-8 text", "save it as UTF-8")]) from None


def loads(text: str, name: str = "the text") -> Model:
    """Return the Model that a text describes; ``name`` stands for the file in messages."""
    return from_table(tables(text, name))


def tables(text: str, name: str = "the text") -> dict[str, Any]:
    """Return the tables of a TOML text; ``name`` stands for the file in messages; raises InputError."""
    if len(text) > LARGEST:
        raise _unreadable(name, "a longer text", f"at most {LARGEST:,} characters")
    _require_short_keys(text, name)
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InputError([_syntax(text, name, str(error))]) from None
    except RecursionError:
        raise _unreadable(name, "lists or tables nested too deeply", "the tables of an input file") from None
    except ValueError as error:  # such as a number of very many digits
        raise _unreadable(name, f"a value that cannot be read ({error})", "TOML") from None


def _require_short_keys(text: str, name: str) -> None:
    """Raise InputError for keys of very many parts, wherever they stand; what a text says is not understood yet."""
    for match in _DOTTED.finditer(text):
        if match.end() - match.start() > MOST_KEYS and (parts := match.group().count(".")) > MOST_KEYS:
            line = text.count("\n", 0, match.start()) + 1
            found = f"{parts + 1} names joined by dots"
            raise InputError(
                [Issue(f"{name}, line {line}", found, f"at most {MOST_KEYS}, as the tables of a file need")]
            )


def from_table(data: Mapping[str, Any]) -> Model:
    """Return the Model that the tables of a case file, already parsed, describe."""
    return Model.model_validate(data, context=FROM_FILE)


def to_toml(part: Section) -> str:
    """Return a Model as an input file that ``loads`` turns into an equal Model; defaults are left out."""
    return "\n".join(_lines(part, "")).strip() + "\n"


def _unreadable(path: str | Path, found: str, expected: str = "a TOML file") -> InputError:
    return InputError([Issue(str(path), found, expected)])


def _syntax(text: str, name: str, message: str) -> Issue:
    """Return what is wrong with the TOML, from tomllib's message, which ends with the place."""
    lines = text.split("\n")
    place = _PLACE.search(message)
    line, column = (int(place[1]), int(place[2])) if place and place[1] else (len(lines), len(lines[-1]) + 1)
    content = lines[line - 1].strip() if line <= len(lines) else ""
    hint = _PLACE.sub("", message)
    if _BARE_UNIT.search(content):
        hint = 'number and unit stand in quotes, as in thickness = "200 mm"'
    return Issue(f"{name}, line {line}, column {column}", describe(content) if content else "nothing", "TOML", hint)


def _lines(part: Section, path: str) -> Iterator[str]:
    """Yield the lines of a part: its values, then the parts in it."""
    tables: list[tuple[str, Section]] = []
    for name, field in type(part).model_fields.items():
        value: Any = getattr(part, name)
        key, inner = key_of(field), nested(field)
        below = f"{path}.{name}" if path else name
        if inner.many:
            tables += [(f"[[{below}]]", each) for each in value]
        elif inner.parts:
            if value is not None and (field.is_required() or value != field.default):
                tables.append((f"[{below}]", value))
        elif key is None:
            yield f"{name} = {quote(value)}"
        elif value is not None and (field.is_required() or value != field.default):
            yield f"{name} = {key.write(value)}"
    for heading, inner_part in tables:
        yield ""
        yield heading
        yield from _lines(inner_part, heading.strip("[]"))


def starter() -> str:
    """Return a commented input file to start from."""
    return STARTER


STARTER = """\
# Input file of groundslab: a slab on two layers of soil.
#
# A number with a dimension is text with its unit: "200 mm", "30 MPa", "20 MN/m^3", "60 kip". Pure numbers
# (Poisson's ratio, counts) stand without quotes. Loads and settlements are positive downwards.
# The centre of the plate is the origin of x and y. What is commented out is the default or an alternative.

title = "A slab of 6 x 4 m on two layers"

# The plate: sides, thickness, elastic constants.
[plate]
length_x = "6 m"
length_y = "4 m"
thickness = "250 mm"
E = "30 GPa"
nu = 0.2
# shear_factor = 0.8333        # 5/6
# element = "mitc9"            # or "heterosis", or "q9" (too stiff if the plate is thin)
# edges = {left = "free", right = "free", bottom = "free", top = "free"}
#                              # or "hinged" (no settlement, no rotation along the edge),
#                              # "soft" (no settlement), "clamped"

# The ground under the plate. A Vlasov ground settles in one mode over the depth of its layers; its two
# stiffnesses follow from the elastic constants. The layers stand from the top downwards, on a rigid base.
[ground]
kind = "vlasov"
# gamma = "iterate"            # decay of the mode, found by iteration; or a number
# mode = "auto"                # "sinh" for one layer, "profile" for several

[[ground.layers]]
E = "20 MPa"                   # at the top of the layer
# E_bottom = "40 MPa"          # if it varies with the depth ...
# variation = "linear"         # ... so, or "quadratic"
nu = 0.3
thickness = "2 m"

[[ground.layers]]
E = "60 MPa"
nu = 0.3
thickness = "4 m"

# Other kinds of ground, each instead of all of the above:
#
# [ground]
# kind = "winkler"
# k = "20 MPa/m"               # or: selvadurai = {E = "40 MPa", depth = "5 m"}
#
# [ground]
# kind = "pasternak"
# k0 = "20 MPa/m"
# k1 = "10 MN/m"
#
# [ground]
# kind = "layered"             # a settlement of its own for each surface between layers
# coupling = "consistent"      # or "interface", whose layers may also be given by k0 and k1
# [[ground.layers]]
# E = "20 MPa"
# nu = 0.3
# thickness = "2 m"
# sublayers = 4

# Ground that varies over the plan: zones with ground of their own, of the same kind and with as many layers ...
#
# [[soil_zones]]
# shape = {kind = "rectangle", x = ["1 m", "3 m"], y = ["-2 m", "2 m"]}
# [soil_zones.ground]
# kind = "vlasov"
# [[soil_zones.ground.layers]]
# E = "10 MPa"
# nu = 0.3
# thickness = "2 m"
# [[soil_zones.ground.layers]]
# E = "60 MPa"
# nu = 0.3
# thickness = "4 m"
#
# ... or boreholes, between which thickness, E and nu of each layer are interpolated.
#
# [[boreholes]]
# name = "B1"
# x = "-4 m"
# y = "0 m"
# [[boreholes.layers]]
# E = "20 MPa"
# nu = 0.3
# thickness = "1.5 m"
# [[boreholes.layers]]
# E = "60 MPa"
# nu = 0.3
# thickness = "4 m"
# [[boreholes]]
# name = "B2"
# x = "4 m"
# y = "0 m"
# [[boreholes.layers]]
# E = "15 MPa"
# nu = 0.3
# thickness = "3 m"
# [[boreholes.layers]]
# E = "60 MPa"
# nu = 0.3
# thickness = "4 m"

# The ground beyond the plate.
[beyond]
kind = "infinite"              # or "none" (default), or "margin"
# width = "5 m"                # of a margin
# edge = "free"                # outer edge of a margin; or "fixed"
# sides = ["left", "right", "bottom", "top"]

# Contact between plate and ground.
[contact]
tensionless = true             # the plate may lift off; false: it is held down
# gap = "0 mm"                 # initial gap everywhere
# limit_pressure = "300 kPa"   # pressure at which the ground yields
# [[contact.voids]]            # a rectangle where the ground lies deeper
# depth = "5 mm"
# x = ["-3 m", "-2 m"]
# y = ["-2 m", "-1 m"]

# Columns on the plate, rectangles or circles. Loads name them, and punching is checked.
# [[columns]]
# name = "A1"
# x = "-2 m"
# y = "0 m"
# width_x = "300 mm"
# width_y = "400 mm"           # or, instead of both: diameter = "400 mm"

# Supports beside the ground: at points, such as piles, and along lines, such as walls below.
# [[supports]]
# kind = "point"
# name = "pile"
# x = "-2.5 m"
# y = "-1.5 m"
# stiffness = "50 MN/m"        # rigid without it
# acts = "in compression"      # or "both ways", "in tension"
# [[supports]]
# kind = "line"
# name = "wall"
# points = [["2 m", "-2 m"], ["2 m", "2 m"]]
# stiffness = "100 MN/m^2"
# acts = "in compression"

# Load cases. Without any, all loads act together, without factors. With them each load names the case that it belongs
# to; each case is solved by itself ...
# [[cases]]
# name = "permanent"
# [[cases]]
# name = "imposed"
# action = "variable"          # psi_0 = 0.7, psi_1 = 0.5, psi_2 = 0.3 by default

# ... unless combinations are given, each solved by itself ...
# [[combinations]]
# name = "all"
# limit_state = "ultimate"     # or "characteristic", "frequent", "quasi-permanent"
# factors = {permanent = 1.35, imposed = 1.5}

# ... or made by EN 1990.
# [combine]
# sets = ["ultimate", "characteristic"]

# The loads, as many as there are.
[[loads]]
kind = "uniform"               # on the whole plate
name = "own weight"
# case = "permanent"
q = "6.25 kPa"

[[loads]]
kind = "patch"                 # on a rectangle
name = "machine"
# case = "imposed"
q = "200 kPa"
x = ["1 m", "2.5 m"]
y = ["-0.5 m", "1 m"]

# [[loads]]
# kind = "point"
# P = "50 kN"
# x = "0 m"
# y = "0 m"

# [[loads]]
# kind = "point"               # on a column, with moments
# P = "300 kN"
# M_x = "20 kNm"               # presses the side of larger x down: it turns about the y axis
# column = "A1"

# [[loads]]
# kind = "temperature"         # positive if the bottom is warmer
# difference = "10 K"

# [[loads]]
# kind = "settlement"          # forced on a support
# support = "pile"
# w = "5 mm"

# Where values are listed.
# [[output.points]]
# name = "middle"
# x = "0 m"
# y = "0 m"
# [[output.lines]]
# name = "axis"
# start = ["-3 m", "0 m"]
# end = ["3 m", "0 m"]
# [[output.strips]]
# name = "strip"
# start = ["-3 m", "1 m"]
# end = ["3 m", "1 m"]
# width = "1 m"

# Reinforcement by EN 1992-1-1, for ultimate combinations: with it there must be one above.
# [reinforcement]
# f_ck = "30 MPa"
# f_yk = "500 MPa"
# bottom = ["40 mm", "50 mm"]  # from the face to the axis of the bars along x and along y
# top = ["40 mm", "50 mm"]

# The mesh of the plate. Without this section the shorter side has 24 elements.
# [mesh]
# size = "0.25 m"              # or: counts = [24, 16]
# symmetry = "auto"            # or "off"

# How the equations are solved.
# [analysis]
# increments = 1
# solver = "auto"              # or "pardiso", "superlu", "mumps"
# nested = true                # start the contact zone from coarser meshes
# max_iterations = 200
"""
