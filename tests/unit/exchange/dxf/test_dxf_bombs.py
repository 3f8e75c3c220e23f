"""Drawings that cost more than they say: how much there is to do is counted before it is done, and too much refused."""

from __future__ import annotations

import json
import re
import resource
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest

from groundslab.errors import InputError
from groundslab.exchange import dxf
from groundslab.exchange.dxf import document, drawing, reader
from helpers import bombs

pytestmark = pytest.mark.slow

#: Reads drawings, writes case and report of each, and prints what is wrong with them.
READ = """
import json, sys
from groundslab.exchange import dxf
from groundslab.errors import InputError
found = []
for path in sys.argv[1:]:
    try:
        drawing = dxf.read(path)
        dxf.to_case(drawing), dxf.report_text(drawing)
        found.append("")
    except InputError as error:
        found.append(str(error))
print(json.dumps(found))
"""


def said(folder: Path, texts: Sequence[str]) -> list[str]:
    """Return what is wrong with drawings that a process of a gigabyte, and half a minute of processor, reads."""
    paths = [folder / f"plan-{number}.dxf" for number in range(len(texts))]
    for path, text in zip(paths, texts, strict=True):
        path.write_text(text)

    def bounds() -> None:
        resource.setrlimit(resource.RLIMIT_AS, (2**30, 2**30))
        resource.setrlimit(resource.RLIMIT_CPU, (30, 30))

    command = [sys.executable, "-c", READ, *map(str, paths)]
    threads = {"OPENBLAS_NUM_THREADS": "1", "PYTHONPATH": ":".join(sys.path)}
    done = subprocess.run(command, capture_output=True, text=True, preexec_fn=bounds, check=False, env=threads)
    assert (done.returncode, done.stderr) == (0, "")
    return [str(words) for words in json.loads(done.stdout)]


def test_small_files_that_are_much(tmp_path: Path) -> None:
    """Short files end soon, all in little memory, and with words that say what there is too much of.

    A spline of 100,000 km is met within a hundred-thousandth of its size, not within a millimetre.
    """
    wave = [(1e5 * k, 1e8 * (k % 2)) for k in range(100)]
    large = bombs.document(bombs.spline(wave)), "lines that close end to end"
    small = bombs.SMALL | {"a spline of large waves": large}
    for (name, (_, words)), found in zip(
        small.items(), said(tmp_path, [text for text, _ in small.values()]), strict=True
    ):
        assert re.search(words, found) if words else found == "", (name, found)
        assert len(found.splitlines()) <= 101, name


@pytest.mark.parametrize("layer", ["OUTLINE", "OPENINGS", "COLUMNS", "ZONES", "LOAD_AREA"])
def test_many_circles(layer: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The edges of curves are counted; more than the limit are refused before they are compared."""
    monkeypatch.setattr(reader, "MOST_EDGES", 500)
    (tmp_path / "plan.dxf").write_text(bombs.circles(300, layer))
    with pytest.raises(InputError, match="more than 500 edges of curves"):
        dxf.read(tmp_path / "plan.dxf")


@pytest.mark.parametrize("layer", ["OUTLINE", "OPENINGS", "COLUMNS", "LOAD_AREA"])
def test_what_is_compared_grows_with_the_number_of_circles(layer: str, tmp_path: Path) -> None:
    """Four times as many circles beside each other make about four times as many comparisons, not sixteen."""
    counts = []
    for number in (400, 1600):
        counted = drawing.ReadContext(str(tmp_path / "plan.dxf"))
        (tmp_path / "plan.dxf").write_text(bombs.circles(number, layer))
        with pytest.MonkeyPatch.context() as patched:
            patched.setattr(reader, "ReadContext", lambda *_, counted=counted, **__: counted)
            dxf.read(tmp_path / "plan.dxf")
        counts.append(sum(counted.spent.values()))
        assert counts[-1] < 20 * number
    assert counts[1] < 6 * counts[0]


@pytest.mark.parametrize("height", [0.1, 0.2, 50.0])
def test_pairs_of_texts_and_loads_grow_with_their_number(height: float, tmp_path: Path) -> None:
    """However large the texts are, only pairs with the nearest loads are looked at: some dozens for each text."""
    for number in (400, 1600):
        counted = drawing.ReadContext(str(tmp_path / "plan.dxf"))
        (tmp_path / "plan.dxf").write_text(bombs.loads(number, height))
        with pytest.MonkeyPatch.context() as patched:
            patched.setattr(reader, "ReadContext", lambda *_, counted=counted, **__: counted)
            try:
                found = dxf.read(tmp_path / "plan.dxf")
            except InputError:
                assert height == 50.0  # where each text stands over many loads, some get none
            else:
                assert [load.value for load in found.point_loads] == [10e3] * number
        assert counted.spent["pairs of texts and loads near each other"] < 150 * number


def test_many_entities(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """More entities than the limit on the layers that are read are refused; on other layers they do not count."""
    monkeypatch.setattr("groundslab.exchange.dxf.entities.MOST_ENTITIES", 100)
    (tmp_path / "plan.dxf").write_text(bombs.circles(101, "OTHER"))
    dxf.read(tmp_path / "plan.dxf")
    (tmp_path / "plan.dxf").write_text(bombs.circles(101, "OPENINGS"))
    with pytest.raises(InputError, match="102 entities on the layers that are read, those of"):
        dxf.read(tmp_path / "plan.dxf")


def test_a_comb_of_overlapping_boxes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Edges whose boxes all overlap would be compared each with each; the pairs are counted first."""
    monkeypatch.setattr(drawing, "MOST_PAIRS", 10_000)
    (tmp_path / "plan.dxf").write_text(bombs.comb(400))
    with pytest.raises(InputError, match="more than 10,000 pairs of edges near each other"):
        dxf.read(tmp_path / "plan.dxf")


def test_lines_that_meet_in_one_point(tmp_path: Path) -> None:
    """A star of lines is a issue of its middle, and is looked at in one go."""
    star = bombs.many(3000, lambda x, y: bombs.line(0, 0, 1 + x, 1 + y + 0.001 * x, "OPENINGS"))
    assert "lines that meet in one point" in said(tmp_path, [bombs.document(star)])[0]


def test_a_long_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A file above the limit is not opened; the issue says its size."""
    monkeypatch.setattr(document, "LARGEST_FILE", 1_000)
    (tmp_path / "plan.dxf").write_text(bombs.circles(300, "OTHER"))
    with pytest.raises(InputError, match=r"found a file of 0 MB, expected at most 0 MB; save only the layers"):
        dxf.read(tmp_path / "plan.dxf")


def test_a_pipe_is_not_waited_for(tmp_path: Path) -> None:
    """A pipe, which might never end, is no file."""
    import os

    os.mkfifo(tmp_path / "pipe.dxf")
    with pytest.raises(InputError, match="a device or a pipe"):
        dxf.read(tmp_path / "pipe.dxf")
