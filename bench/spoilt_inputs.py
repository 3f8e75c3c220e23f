"""Spoilt inputs: what comes from others is read or refused in words, in little time and memory.

    python bench/spoilt_inputs.py 5000 1           # so many inputs, with this seed
    python bench/spoilt_inputs.py 5000 2 540       # or as many as are done in so many seconds

Kinds: cases, drawings, study files, archives and folders of results, comparisons of grounds, unsaved work. Each input
is a sound one that chance has spoilt: bytes, words, numbers, lines, values of JSON, arrays, members. It is read in a
process of its own; what is not read must be refused by an error of groundslab's own. Prints the counts, all
tracebacks, the slowest input (time of the processor) and the largest memory, and ends with 1 if any input raised
something else, took longer than 10 s, or more than 1 GB. Inputs that fail are kept in the folder spoilt_inputs.
"""

from __future__ import annotations

import io
import json
import os
import random
import resource
import shutil
import sys
import tempfile
import time
import traceback
import zipfile
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
sys.path.append(str(ROOT / "tests"))
#: Limits of one input: time [s] and memory [bytes].
TIME, MEMORY = 10.0, 1_000_000_000
#: What stops an input that exceeds them by far.
KILL_TIME, MORE_MEMORY = 30, 2_000_000_000
ACCEPTED, REFUSED, TRACEBACK, NO_MEMORY = range(4)
KEPT = Path("spoilt_inputs")
#: What may stand in place of a number or a word.
NUMBERS = ["0", "-1", "1e308", "1e-308", "nan", "inf", "-0.0", "9" * 400, "1e9", "0.1", "2147483648", "", "1_0", "0x10"]
WORDS = [
    "",
    '"',
    "\0",
    "\ufeff",
    "µ",
    "𝛑",
    "[",
    "]]",
    "{",
    "= = =",
    "m",
    "kN",
    "MPa/m",
    "true",
    "kind",
    "x" * 5000,
    "a.b.c.d",
]
Read = Callable[[Path], object]


@dataclass(frozen=True)
class Kind:
    """A kind of input: what writes a spoilt one into a folder and returns its path, and what reads it."""

    write: Callable[[random.Random, Path], Path]
    read: Read


def spoil_text(chance: random.Random, text: str) -> str:
    """Return a text with one to four changes."""
    for _ in range(chance.randint(1, 4)):
        text = chance.choice(TEXT_CHANGES)(chance, text)
    return text


def _span(chance: random.Random, text: str, longest: int = 200) -> tuple[int, int]:
    start = chance.randrange(len(text) + 1)
    return start, min(len(text), start + chance.randint(1, longest))


def _cut(chance: random.Random, text: str) -> str:
    a, b = _span(chance, text)
    return text[:a] + text[b:]


def _double(chance: random.Random, text: str) -> str:
    a, b = _span(chance, text)
    return text[:b] + text[a:b] * chance.choice([1, 1, 1, 2, 50, 2000]) + text[b:]


def _end_early(chance: random.Random, text: str) -> str:
    return text[: chance.randrange(len(text) + 1)]


def _insert(chance: random.Random, text: str) -> str:
    a, _ = _span(chance, text)
    return text[:a] + chance.choice(WORDS + NUMBERS) + text[a:]


def _swap_lines(chance: random.Random, text: str) -> str:
    lines = text.split("\n")
    i, j = chance.randrange(len(lines)), chance.randrange(len(lines))
    lines[i], lines[j] = lines[j], lines[i]
    return "\n".join(lines)


def _replace_value(chance: random.Random, text: str) -> str:
    """Replace what stands on one line behind its equals sign, or the line."""
    lines = text.split("\n")
    i = chance.randrange(len(lines))
    key, equals, _ = lines[i].partition("=")
    value = chance.choice(NUMBERS + WORDS + ['"1 m"', '"-3 kN"', '"1e300 m"', "[]", "{}", "[[1, 2], [3]]", '"0 m"'])
    lines[i] = f"{key}= {value}" if equals else value
    return "\n".join(lines)


def _change_digit(chance: random.Random, text: str) -> str:
    places = [n for n, letter in enumerate(text) if letter.isdigit()]
    if not places:
        return text
    n = chance.choice(places)
    return text[:n] + chance.choice("0123456789-.e") + text[n + 1 :]


def _nest(chance: random.Random, text: str) -> str:
    a, _ = _span(chance, text)
    return text[:a] + chance.choice("[{(") * chance.choice([2, 100, 100_000]) + text[a:]


def _repeat_line(chance: random.Random, text: str) -> str:
    lines = text.split("\n")
    i = chance.randrange(len(lines))
    return "\n".join([*lines[:i], *[lines[i]] * chance.choice([2, 10, 1000, 20_000]), *lines[i:]])


TEXT_CHANGES = [
    _cut, _double, _end_early, _insert, _swap_lines, _replace_value, _replace_value, _replace_value, _change_digit,
    _change_digit, _nest, _repeat_line,
]  # fmt: skip


def spoil_bytes(chance: random.Random, content: bytes) -> bytes:
    """Return bytes of which some were changed, cut or doubled."""
    for _ in range(chance.randint(1, 4)):
        a = chance.randrange(len(content) + 1)
        b = min(len(content), a + chance.choice([1, 4, 100, 10_000]))
        middle = chance.choice([b"", chance.randbytes(b - a), content[a:b] * 2, bytes(b - a), b"\xff" * (b - a)])
        content = content[:a] + middle + content[b:]
    return content


def spoil_json(chance: random.Random, text: str) -> str:
    """Return the text of JSON data of which one value was replaced, or a text that was spoilt."""
    from helpers import damage

    if chance.random() < 0.2:
        return spoil_text(chance, text)
    data = json.loads(text)
    damage.put(data, chance.choice(list(damage.places(data))), chance.choice(damage.VALUES))
    return json.dumps(data)


def spoil_drawing(chance: random.Random, text: str) -> str:
    """Return a drawing with other values behind some codes, with entities repeated, or spoilt as a text."""
    if chance.random() < 0.2:
        return spoil_text(chance, text)
    lines = text.split("\n")
    start = lines.index("ENTITIES") if chance.random() < 0.8 else 0
    for _ in range(chance.randint(1, 6)):
        i = chance.randrange(start // 2, len(lines) // 2) * 2 + 1
        lines[min(i, len(lines) - 1)] = chance.choice(
            [
                *NUMBERS,
                *WORDS,
                "OUTLINE",
                "OPENINGS",
                "LOADS",
                "COLUMNS",
                "LINE",
                "HATCH",
                "LWPOLYLINE",
                "INSERT",
                "SPLINE",
            ]
        )
    if chance.random() < 0.1:
        heads = [n for n in range(start, len(lines) - 1) if lines[n].strip() == "0"]
        if len(heads) > 2:
            k = chance.randrange(len(heads) - 1)
            entity = lines[heads[k] : heads[k + 1]]
            lines[heads[k] : heads[k]] = entity * chance.choice([2, 100, 3000])
    return "\n".join(lines)


def write_text(path: Path, text: str) -> Path:
    """Write a text with all its letters, also those that are none."""
    path.write_bytes(text.encode("utf-8", "surrogatepass"))
    return path


def drawing() -> str:
    """Return the text of a drawing with everything that is read."""
    import ezdxf

    document = ezdxf.new("R2010", units=6)
    space = document.modelspace()
    on = lambda layer: {"layer": layer}  # noqa: E731
    corners = [(0, 0), (10, 0.0003), (10, 0), (10, 6), (0, 6), (0, 0)]
    for k in (0, 2, 3, 4):
        space.add_line(corners[k], corners[k + 1], on("OUTLINE"))
    space.add_circle((5, 3), 0.5, on("OPENINGS"))
    space.add_ellipse((2, 4), (0.5, 0), 0.5, dxfattribs=on("OPENINGS"))
    space.add_spline([(7, 1), (8, 1), (8, 2), (7, 1)], dxfattribs=on("ZONES"))
    space.add_lwpolyline([(1, 1, 0.3), (1.4, 1, 0), (1.4, 1.4, 0)], "xyb", close=True, dxfattribs=on("COLUMNS"))
    hatch = space.add_hatch(dxfattribs=on("LOAD_AREA 5 kPa"))
    hatch.paths.add_polyline_path([(3, 1, 0), (4, 1, 0.5), (4, 2, 0)], flags=1)
    path = hatch.paths.add_edge_path(flags=16)
    path.add_arc((3.7, 1.3), 0.1, 0, 270)
    path.add_line((3.7, 1.2), (3.8, 1.3))
    block = document.blocks.new("B")
    block.add_point((0, 0), dxfattribs=on("0"))
    space.add_blockref("B", (2, 2), on("LOADS"))
    space.add_point((3, 3), on("LOADS"))
    space.add_text("600,5 kN", height=0.1, dxfattribs={**on("LOADS"), "insert": (3.05, 3)})
    space.add_mtext("q = 25 kN/m", dxfattribs={**on("LOAD_LINE"), "insert": (5, 5), "char_height": 0.1})
    space.add_lwpolyline([(4, 5), (6, 5)], dxfattribs=on("LOAD_LINE"))
    stream = io.StringIO()
    document.write(stream)
    return stream.getvalue()


def sound_cases() -> list[str]:
    """Return the texts of the fuzz tests and of the examples."""
    from properties import test_input_fuzz

    examples = [path.read_text("utf-8") for path in sorted(ROOT.glob("examples/*.toml"))]
    return [text for text in (*test_input_fuzz.FILES.values(), *examples) if "sampling" not in text]


def spoil_member(chance: random.Random, name: str, content: bytes) -> bytes:
    """Return a file of an archive, spoilt as a file of its kind, or with very many blanks before it."""
    if chance.random() < 0.3:
        return b" " * chance.choice([0, *[10**6] * 10, 10**8]) + content
    if chance.random() < 0.3 or name.endswith(".npz"):
        return spoil_bytes(chance, content)
    spoil = spoil_json if name.endswith(".json") else spoil_text
    return spoil(chance, content.decode()).encode("utf-8", "surrogatepass")


def write_archive(chance: random.Random, to: Path, packed: bytes) -> Path:
    """Write an archive of results of which a file was spoilt, or its bytes."""
    path = to / "x.zip"
    if chance.random() < 0.4:
        path.write_bytes(spoil_bytes(chance, packed))
        return path
    with zipfile.ZipFile(io.BytesIO(packed)) as old, zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as new:
        names = old.namelist()
        spoilt = chance.choice([name for name in names if name.endswith((".npz", ".json", ".toml"))])
        for name in names:
            content = old.read(name)
            content = spoil_member(chance, name, content) if name == spoilt else content
            new.writestr(name if chance.random() > 0.005 else f"../{name}", content)
    return path


def read_archive(path: Path) -> None:
    """Unpack an archive and read its results."""
    from groundslab.views.files import archive, results_folder

    with tempfile.TemporaryDirectory() as unpacked:
        archive.unpack_results(path, Path(unpacked))
        results_folder.load_results(unpacked)


def write_folder(chance: random.Random, to: Path, sound: Path) -> Path:
    """Write a folder of results of which an array, a value of JSON, a text or a file was spoilt."""
    from helpers import damage

    folder = to / "one"
    shutil.copytree(sound, folder)
    npz, way = folder / "results.npz", chance.random()
    if way < 0.4:
        name = chance.choice([name for name in damage.arrays(npz) if name not in ("about", "model")])
        damage.with_array(npz, name, chance.choice(list(damage.ARRAYS.values())))
    elif way < 0.6:
        about = json.loads(str(damage.arrays(npz)["about"]))
        damage.with_about(npz, chance.choice(list(damage.places(about))), chance.choice(damage.VALUES))
    elif way < 0.75:
        path = folder / chance.choice(["summary.json", "case.toml"])
        spoil = spoil_json if path.suffix == ".json" else spoil_text
        write_text(path, spoil(chance, path.read_text("utf-8")))
    elif way < 0.9:
        npz.write_bytes(spoil_bytes(chance, npz.read_bytes()))
    else:
        chance.choice(list(damage.FILES.values()))(folder)
    return folder


def read_drawing(path: Path) -> None:
    """Survey a drawing, make a case of it and the report; raises the last refusal."""
    from groundslab.errors import InputError
    from groundslab.exchange import dxf
    from groundslab.exchange.dxf import survey

    refusal = None
    try:
        survey.survey(path)
    except InputError as error:
        refusal = error
    drawing = dxf.read(path)
    dxf.to_case(dxf.center(drawing))
    dxf.report_text(drawing)
    if refusal is not None:
        raise refusal


def write_study(chance: random.Random, to: Path) -> Path:
    """Write a study of which the file or the case was spoilt."""
    from helpers import studies

    of_case = chance.random() < 0.2
    write_text(to / "slab.toml", spoil_text(chance, studies.CASE) if of_case else studies.CASE)
    return write_text(to / "study.toml", studies.STUDY if of_case else spoil_text(chance, studies.STUDY))


def write_rows(chance: random.Random, to: Path) -> Path:
    """Write a folder of a study whose about.json was spoilt."""
    from groundslab.study.execution import store

    about = {"format": store.FORMAT, "program": "groundslab study", "seed": 1, "variants": 2, "versions": {}}
    (to / store.ROWS).write_bytes(spoil_bytes(chance, bytes(5000)))
    return write_text(to / store.ABOUT, spoil_json(chance, json.dumps(about))).parent


def kinds(folder: Path) -> dict[str, Kind]:
    """Return all kinds of inputs; sound ones are made in a folder."""
    import groundslab
    from groundslab.analysis.check import check
    from groundslab.case import casefile
    from groundslab.study.definition import files
    from groundslab.study.execution import store
    from groundslab.views.files import archive, results_folder
    from groundslab.views.ground_comparison.files import load_comparison, save_comparison
    from groundslab.workbench.persistence.autosave import HEAD, read_unsaved
    from helpers import bombs, grounds, studies, synthetic

    cases = sound_cases()
    drawings = [drawing(), bombs.document(bombs.many(30, lambda x, y: bombs.circle(x, y, 0.4)))]
    packed = archive.pack_results(groundslab.solve(casefile.loads(studies.CASE)), studies.CASE, "<html></html>")
    sound = results_folder.save_results(synthetic.results(), folder / "one")
    comparison = save_comparison(grounds.comparison(), folder / "comparison") / "ground-comparison.json"
    compared = comparison.read_text("utf-8")
    head = {"file": None, "when": "2026-01-01", "base": None, "newline": "\n", "mark": False}
    unsaved = f"{HEAD}{json.dumps(head)}\n{studies.CASE}"
    return {
        "case": Kind(
            lambda c, to: write_text(to / "x.toml", spoil_text(c, c.choice(cases))),
            lambda path: check(casefile.load(path)),
        ),
        "drawing": Kind(lambda c, to: write_text(to / "x.dxf", spoil_drawing(c, c.choice(drawings))), read_drawing),
        "archive": Kind(lambda c, to: write_archive(c, to, packed), read_archive),
        "folder": Kind(lambda c, to: write_folder(c, to, sound), results_folder.load_results),
        "study": Kind(write_study, files.read),
        "comparison": Kind(
            lambda c, to: write_text(to / comparison.name, spoil_json(c, compared)).parent, load_comparison
        ),
        "unsaved work": Kind(lambda c, to: write_text(to / "x.unsaved", spoil_text(c, unsaved)), read_unsaved),
        "rows": Kind(write_rows, store.about),
    }


#: How often each kind is taken.
WEIGHTS = {
    "case": 30,
    "drawing": 25,
    "archive": 12,
    "folder": 12,
    "study": 12,
    "comparison": 4,
    "unsaved work": 3,
    "rows": 2,
}


def attempt(read: Read, path: Path, log: Path) -> tuple[int, float, float]:
    """Read an input in a process of its own: outcome, time of the processor [s], memory [bytes]."""
    from groundslab.errors import GroundslabError

    child = os.fork()
    if child == 0:
        held = int(Path("/proc/self/statm").read_text("ascii").split()[0]) * resource.getpagesize()
        resource.setrlimit(resource.RLIMIT_AS, (held + MORE_MEMORY, held + MORE_MEMORY))
        resource.setrlimit(resource.RLIMIT_CPU, (KILL_TIME, KILL_TIME))
        code = ACCEPTED
        try:
            read(path)
        except GroundslabError as error:
            code = REFUSED if str(error) else TRACEBACK
        except MemoryError:
            code = NO_MEMORY
        except BaseException:
            log.write_text(traceback.format_exc(), "utf-8", "replace")
            code = TRACEBACK
        os._exit(code)
    _, status, used = os.wait4(child, 0)
    code = os.waitstatus_to_exitcode(status)
    return (code if code >= 0 else TRACEBACK), used.ru_utime + used.ru_stime, used.ru_maxrss * 1024.0


def main(count: int, seed: int, limit: float = float("inf")) -> dict[str, Any]:
    """Return the figures of so many inputs, or of those that were read within a time [s]."""
    end, done = time.monotonic() + limit, 0
    outcomes, failures = Counter[str](), list[str]()
    slowest, largest = (0.0, ""), (0.0, "")
    with tempfile.TemporaryDirectory() as made:
        known = kinds(Path(made))
        for number in range(count):
            if time.monotonic() > end:
                break
            done += 1
            chance = random.Random(f"{seed} {number}")
            (kind,) = chance.choices(list(WEIGHTS), list(WEIGHTS.values()))
            with tempfile.TemporaryDirectory() as folder:
                log = Path(folder) / "traceback.txt"
                path = known[kind].write(chance, Path(folder))
                code, seconds, memory = attempt(known[kind].read, path, log)
                name = f"{seed}-{number} {kind}"
                slowest, largest = max(slowest, (seconds, name)), max(largest, (memory, name))
                outcomes[f"{kind}: {('read', 'refused', 'traceback', 'out of memory')[code]}"] += 1
                if code > REFUSED or seconds > TIME or memory > MEMORY:
                    failures.append(f"{name}: {log.read_text('utf-8') if log.exists() else f'{seconds:.1f} s'}")
                    shutil.copytree(folder, KEPT / name.replace(" ", "-"), dirs_exist_ok=True)
    return {
        "inputs": done,
        "seed": seed,
        "outcomes": dict(sorted(outcomes.items())),
        "slowest [s]": slowest,
        "largest memory [MB]": (largest[0] / 1e6, largest[1]),
        "failures": failures,
    }


if __name__ == "__main__":
    figures = main(int(sys.argv[1]), int(sys.argv[2]), *map(float, sys.argv[3:4]))
    print(json.dumps(figures, indent=2))
    sys.exit(bool(figures["failures"]))
