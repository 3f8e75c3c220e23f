"""The input file: reading, writing, and what is said when it cannot be read."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest

from groundslab.case.casefile import LARGEST, load, loads, starter, to_toml
from groundslab.errors import InputError, Issue
from groundslab.model.combinations import list_combinations
from groundslab.model.ground import Layered, SoilLayer, Vlasov, Winkler
from groundslab.model.loads.load_types import PatchLoad, PointLoad, SelfWeight, UniformLoad
from groundslab.model.model import Model
from groundslab.model.plate import Edges, Plate
from groundslab.model.settings import Analysis, Beyond, Contact, Mesh
from groundslab.model.varying_ground import Void
from helpers.paths import EXAMPLES


def issue(text: str) -> Issue:
    """Return the only issue of a text."""
    with pytest.raises(InputError) as error:
        loads(text, "case.toml")
    (only,) = error.value.issues
    return only


def unreadable(path: Path) -> Issue:
    """Return the only issue of a file."""
    with pytest.raises(InputError) as error:
        load(path)
    (only,) = error.value.issues
    return only


def test_starter() -> None:
    """The file to start from is valid and describes what its comments say."""
    model = loads(starter())
    assert (model.plate.length_x, model.plate.length_y) == (6.0, 4.0)
    assert isinstance(model.ground, Vlasov)
    assert len(model.ground.layers) == 2
    assert model.beyond.kind == "infinite"
    assert model.contact.tensionless
    (load,) = model.loads
    assert isinstance(load, SelfWeight)  # nothing but what the slab itself brings
    assert load.unit_weight == 25e3


def _without_comments(text: str) -> str:
    """Return the starter with one of its commented blocks switched on in place of what it replaces."""
    lines = [line[2:] if line.startswith("# ") else line for line in text.splitlines()]
    return "\n".join(line for line in lines if " = " in line or line.startswith("["))


def test_alternatives_of_the_starter_are_toml() -> None:
    """What is commented out in the starter is well-formed: each line of the form key = value is TOML by itself."""
    for line in _without_comments(starter()).splitlines():
        if not line.startswith("["):
            tomllib.loads(line)


@pytest.mark.parametrize(
    ("active", "alternative"),
    [
        ('kind = "infinite" ', 'kind = "margin"\nwidth = "5 m"\nedge = "fixed" '),
        ("tensionless = true ", "tensionless = false "),
        ("# gap", "gap"),
        ("# limit_pressure", "limit_pressure"),
        ("# shear_factor", "shear_factor"),
        ("# element", "element"),
        ("# edges", "edges"),
        ("# gamma", "gamma"),
        ("# mode", "mode"),
        ("# E_bottom", "E_bottom"),
        (
            '# E_bottom = "40 MPa"          # if it varies with the depth ...\n# variation',
            'E_bottom = "40 MPa"\nvariation',
        ),
        ("# sides", "sides"),
        (
            '# [[loads]]\n# kind = "point"\n# P = "50 kN"\n# x = "0 m"\n# y = "0 m"',
            '[[loads]]\nkind = "point"\nP = "50 kN"\nx = "0 m"\ny = "0 m"',
        ),
        ('# [mesh]\n# accuracy = "5 %"\n# size', "[mesh]\nsize"),
        ("# [mesh]\n# accuracy", "[mesh]\naccuracy"),
        ("# [analysis]\n# increments", "[analysis]\nincrements"),
    ],
)
def test_alternatives_of_the_starter(active: str, alternative: str) -> None:
    """What the starter offers in comments can be switched on."""
    assert active in starter()
    loads(starter().replace(active, alternative, 1))


COMMENTED = re.compile(r"# (?=\[|\w+ = )")


def blocks_of_the_starter() -> dict[str, list[int]]:
    """Return the lines of each block of keys that is commented out whole, by its headings and kind."""
    blocks: dict[str, list[int]] = {}
    current: list[int] = []
    lines = starter().splitlines()
    for number, line in enumerate([*lines, ""]):
        if COMMENTED.match(line) and (current or line.startswith("# [")):
            current.append(number)
        elif current:
            words = [lines[n][2:].partition("#")[0].strip() for n in current]
            headings = list(dict.fromkeys(word for word in words if word.startswith("[")))
            kinds = [word for word in words if word.startswith("kind") and headings[0] in ("[[loads]]", "[ground]")]
            blocks[" ".join(headings + kinds)] = current
            current = []
    return blocks


def switched_on(*names: str) -> str:
    """Return the starter with some of its blocks switched on, and the lines of cases where cases are among them."""
    lines, blocks = starter().splitlines(), blocks_of_the_starter()
    chosen = [number for name in names for number in blocks.pop(name)]
    if "[[cases]]" in names:
        within = {number for block in blocks_of_the_starter().values() for number in block}
        chosen += [n for n, line in enumerate(lines) if line.startswith("# case = ") and n not in within]
    for number in chosen:
        lines[number] = lines[number][2:]
    return "\n".join(lines)


COLUMN, SUPPORT = "[[columns]]", "[[supports]]"
POINT, PATCH = '[[loads]] kind = "point"', '[[loads]] kind = "patch"'
TOGETHER: list[tuple[str, ...]] = [
    ("[[contact.voids]]",),
    ("[[cases]]", '[[loads]] kind = "uniform"'),
    ("[[cases]]", PATCH),
    (COLUMN, POINT),
    (SUPPORT, '[[loads]] kind = "settlement"'),
    ('[[loads]] kind = "temperature"',),
    ('[[loads]] kind = "shrinkage"',),
    ("[[cases]]", "[[patterns]] [[moves]]"),
    ("[[cases]]", "[combine]", "[floor]"),
    ("[[cases]]",),
    ("[[cases]]", "[[combinations]]"),
    ("[[cases]]", "[combine]"),
    ("[[cases]]", "[[combinations]]", "[combine]"),
    ("[[soil_zones]] [soil_zones.ground] [[soil_zones.ground.layers]]",),
    ("[[boreholes]] [[boreholes.layers]]",),
    ("[[output.points]] [[output.lines]] [[output.strips]]",),
    ("[[cases]]", "[combine]", "[reinforcement]"),
    ("[mesh]",),
    ("[analysis]",),
]


@pytest.mark.parametrize("names", TOGETHER, ids=" and ".join)
def test_blocks_of_the_starter(names: tuple[str, ...]) -> None:
    """Each block that the starter has in comments is a valid part of the file when switched on."""
    model = loads(switched_on(*names))
    assert model != loads(starter()) or set(names) <= {"[mesh]", "[analysis]"}


def test_no_block_of_the_starter_is_forgotten() -> None:
    """All blocks in comments are tried above, but for the other kinds of ground, which are tried below."""
    tried = {name for names in TOGETHER for name in names}
    assert {name for name in blocks_of_the_starter() if not name.startswith("[ground]")} == tried


@pytest.mark.parametrize("kind", ["winkler", "pasternak", "layered"])
def test_other_kinds_of_ground_of_the_starter(kind: str) -> None:
    """Each other kind of ground in comments stands for all of the starter's ground."""
    text = starter()
    (name,) = (name for name in blocks_of_the_starter() if f'kind = "{kind}"' in name)
    lines = [starter().splitlines()[number][2:] for number in blocks_of_the_starter()[name]]
    start, end = text.index('[ground]\nkind = "vlasov"'), text.index("# Other kinds of ground")
    text = text[:start] + "\n".join(lines) + "\n" + text[end:]
    if kind == "winkler":
        text = text.replace('kind = "infinite"', 'kind = "none"')
    assert loads(text).ground.kind == kind


def test_what_the_starter_says_when_switched_on() -> None:
    """Values arrive where the comments say: columns, supports, combinations by EN 1990, soil that varies, output."""
    model = loads(switched_on(COLUMN, POINT, SUPPORT, '[[loads]] kind = "settlement"'))
    assert model.columns[0].width_y == 0.4
    assert [support.kind for support in model.supports] == ["point", "line"]
    assert [load.kind for load in model.loads][1:] == ["point", "settlement"]
    made = list_combinations(loads(switched_on("[[cases]]", "[combine]")))
    assert {each.limit_state for each in made} == {"ultimate", "characteristic"}
    holes = loads(switched_on("[[boreholes]] [[boreholes.layers]]")).boreholes
    assert [[layer.thickness for layer in hole.layers] for hole in holes] == [[1.5, 4], [3, 4]]
    output = loads(switched_on("[[output.points]] [[output.lines]] [[output.strips]]")).output
    assert [len(output.points), len(output.lines), len(output.strips)] == [1, 1, 1]


def test_example_of_the_paper() -> None:
    """The paper's first example is described as the paper gives it."""
    model = load(EXAMPLES / "table1.toml")
    assert model.plate == Plate(length_x=9.6, length_y=7.2, thickness=0.2, E=23e9, nu=0.17)
    assert model.ground == Vlasov(layers=[SoilLayer(E=42e6, nu=0.45, thickness=5)], gamma=1.1316)
    assert model.beyond == Beyond()
    assert model.contact == Contact()
    (patch,) = model.loads
    assert isinstance(patch, PatchLoad)
    assert (patch.q, patch.x, patch.y) == (1e6, (-1.2, 1.2), (-1.2, 1.2))
    assert model.mesh == Mesh(size=0.2)


def test_file_as_path_or_text(tmp_path: Path) -> None:
    """A path may be text; a byte order mark and Windows line ends do no harm."""
    path = tmp_path / "case.toml"
    path.write_bytes(b"\xef\xbb\xbf" + starter().replace("\n", "\r\n").encode())
    assert load(str(path)) == load(path) == loads(starter())


@pytest.mark.parametrize(
    ("text", "where", "hint"),
    [
        ("[plate\n", "case.toml, line 1, column 7", "Expected ']'"),
        ('title = "a"\nplate = \n', "case.toml, line 2, column 9", "Invalid value"),
        ('title = "a', "case.toml, line 1, column 11", "Unterminated string"),
        ("a = 1\na = 2\n", "case.toml, line 2, column 6", "Cannot overwrite a value"),
        ("[a]\n[a]\n", "case.toml, line 2, column 3", "Cannot declare"),
        ("[plate]\nthickness = 200 mm\n", "case.toml, line 2, column 17", "put number and unit in quotes"),
        ("[plate]\nE = 30GPa\n", "case.toml, line 2, column 7", "put number and unit in quotes"),
    ],
)
def test_syntax_errors(text: str, where: str, hint: str) -> None:
    """What is not TOML is reported with line and column, the line itself, and tomllib's reason or a better one."""
    reported = issue(text)
    line = int(where.split("line ")[1].split(",")[0])
    assert reported.location.split(", column")[0] == where.split(", column")[0]
    # the column just behind the end of a line differs between versions of tomllib
    assert abs(int(reported.location.rsplit(" ", 1)[1]) - int(where.rsplit(" ", 1)[1])) <= 1
    assert reported.found.strip('"').replace("\\", "") in text.split("\n")[line - 1]
    assert reported.expected == "TOML"
    assert hint in reported.hint


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("x = " + "[" * 100_000, "lists or tables nested too deeply"),
        ("x = " + "9" * 10_000, "a value that cannot be read"),
        ("#" * (LARGEST + 1), "a longer text"),
    ],
)
def test_hostile_texts(text: str, found: str) -> None:
    """Texts made to break a reader are refused."""
    reported = issue(text)
    assert reported.location == "case.toml"
    assert reported.found.startswith(found)


def test_huge_number() -> None:
    """A number too long to be printed is still a issue that can be."""
    reported = issue(starter() + "[analysis]\nincrements = 0x" + "f" * 10_000)
    assert str(reported) == "analysis.increments: found a huge number, expected a whole number from 1 to 1000"


def test_missing_file(tmp_path: Path) -> None:
    """A file that is not there is an InputError that names it."""
    path = tmp_path / "none.toml"
    assert unreadable(path) == Issue(str(path), "no file of that name", "a TOML file")


def test_directory(tmp_path: Path) -> None:
    """A directory is an InputError."""
    assert unreadable(tmp_path).found == "a directory"


def test_strange_paths(tmp_path: Path) -> None:
    """Paths that no system accepts are InputErrors."""
    assert unreadable(tmp_path / "a\0b").found.startswith("a file that cannot be read")
    assert unreadable(tmp_path / ("x" * 5000)).found.startswith("a file that cannot be read")


def test_not_utf8(tmp_path: Path) -> None:
    """Bytes that are not UTF-8 are reported with their line."""
    path = tmp_path / "case.toml"
    path.write_bytes('title = "a"\n# Gr\N{LATIN SMALL LETTER O WITH DIAERESIS}\xdfe\n'.encode("latin-1"))
    reported = unreadable(path)
    assert reported.location == f"{path}, line 2"
    assert reported.found == "bytes that are not UTF-8"


def test_too_large(tmp_path: Path) -> None:
    """A file of more than 10 MB is refused without reading all of it."""
    path = tmp_path / "case.toml"
    with path.open("wb") as file:
        file.seek(10 * LARGEST)
        file.write(b"\n")
    assert unreadable(path).expected == "a TOML file of at most 10 MB"


def test_units_are_mandatory_in_files() -> None:
    """A bare number for a dimensional key is an error in a file, with its place and a hint."""
    reported = issue(starter().replace('"60 MPa"', "60"))
    expected = 'ground.layers[2].E: found 60, expected a pressure such as "30 MPa"; write number and unit in quotes'
    assert str(reported) == expected


def test_all_faults_of_a_file() -> None:
    """All issues of a file come at once, one a line."""
    text = switched_on("[[cases]]", PATCH).replace("thickness =", "thicknes =", 1)
    text = text.replace('"200 kPa"', '"200"').replace("-0.5 m", "9 m")
    with pytest.raises(InputError) as error:
        loads(text)
    assert [each.location for each in error.value.issues] == [
        "plate.thickness", "plate.thicknes", "loads[2].q", "loads[2].y",
    ]  # fmt: skip
    assert len(str(error.value).splitlines()) == 4


@pytest.mark.parametrize(
    "model",
    [
        loads(starter()),
        load(EXAMPLES / "table1.toml"),
        Model(
            title='quotes " \\ and \n\t\x00\x7f\u2028 ü 😀',
            plate=Plate(
                length_x=0.1 + 0.2, length_y=1e-5, thickness=1.2345678901234567e6, E=1.0000000000000002e-6, nu=1 / 3,
                shear_factor=1, element="q9", edges=Edges(left="clamped"),
            ),
            ground=Layered(
                coupling="consistent",
                layers=[SoilLayer(E=1, E_bottom=2, variation="quadratic", nu=0, thickness=3, sublayers=4)],
            ),
            beyond=Beyond(kind="margin", width=1 / 3, edge="fixed", sides=["top", "left"]),
            contact=Contact(gap=1e-3, voids=[Void(depth=1e-9, x=(0, 0.1), y=(-1e-6, 1e-6))]),
            loads=[PointLoad(P=-0.0, x=0.15, y=0, name="]\n[loads]"), UniformLoad(q=-1)],
            mesh=Mesh(counts=(3, 4), symmetry="off"),
            analysis=Analysis(increments=7, solver="superlu", nested=False, max_iterations=9),
        ),
        Model(plate=Plate(length_x=1, length_y=1, thickness=1, E=1, nu=0),
              ground=Winkler(selvadurai={"E": 1e7, "depth": 3}), loads=[UniformLoad(q=1)]),
    ],
    ids=["starter", "table1", "odd", "selvadurai"],
)  # fmt: skip
def test_written_model_is_read_back(model: Model) -> None:
    """A Model written as TOML is read back as an equal one, to the last bit of each number."""
    assert loads(to_toml(model)) == model
