"""The command import-reactions shows what a table changes, and writes only what it is asked to write."""

from __future__ import annotations

from pathlib import Path

import pytest

from groundslab.case import casefile
from groundslab.cli.main import main
from helpers.reactions import BY_HAND, CASE, ETABS, write_case, write_table

Capture = pytest.CaptureFixture[str]


def test_changes_are_shown_before_they_are_taken(tmp_path: Path, capsys: Capture) -> None:
    """Without a word nothing is written; -o writes another case, --yes replaces the case itself."""
    table, case = str(write_table(tmp_path, BY_HAND)), write_case(tmp_path)
    assert main(["import-reactions", table, str(case)]) == 0
    shown = capsys.readouterr()
    assert "new: A in G: P 1.8124 MN, M_x 20 kNm, M_y 10 kNm" in shown.out
    assert "G: P 0 -> 2.3124 MN" in shown.out
    assert "signs: P = F_z, M_x = -M_y of the table" in shown.out
    assert "nothing was written" in shown.err
    assert case.read_text() == CASE
    other = tmp_path / "other.toml"
    assert main(["import-reactions", table, str(case), "-o", str(other)]) == 0
    assert case.read_text() == CASE
    assert main(["import-reactions", table, str(case), "-o", str(other)]) == 2  # which is there
    capsys.readouterr()
    assert main(["import-reactions", table, str(case), "--yes"]) == 0
    assert case.read_text() == other.read_text()
    assert main(["import-reactions", table, str(case), "--yes"]) == 0
    assert "no changes" in capsys.readouterr().out
    assert case.read_text() == other.read_text()


def test_choices_are_kept_in_the_case(tmp_path: Path, capsys: Capture) -> None:
    """The next import needs the file alone."""
    text = ETABS.replace(",Q,", ",LIVE,").replace(",G,", ",DEAD,").replace("Base,B,102", "Base,D,104")
    table, case = str(write_table(tmp_path, text)), str(write_case(tmp_path))
    assert main(["import-reactions", table, case, "--yes"]) == 2
    told = capsys.readouterr().err
    assert all(name in told for name in ('"DEAD"', '"LIVE"', '"101"', '"104"'))
    choices = ["--new-case", "LIVE=B", "--same-case", "DEAD=G", "--support", "101=A", "--without-support", "104"]
    signs = ["--positive", "lifts", "--moments", "as here", "--threshold", "0.05"]
    assert main(["import-reactions", table, case, *choices, *signs, "--yes"]) == 0
    model = casefile.load(case)
    assert model.reactions is not None
    assert (model.reactions.positive, model.reactions.without_supports) == ("lifts", ("104",))
    assert [load.source for load in model.loads[1:]] == ["101", "101"]  # type: ignore[union-attr]
    capsys.readouterr()
    assert main(["import-reactions", table, case]) == 0
    assert "no changes" in capsys.readouterr().out


def test_wrong_pairs_are_refused(tmp_path: Path, capsys: Capture) -> None:
    """With the option that they stand behind."""
    table, case = str(write_table(tmp_path, BY_HAND)), str(write_case(tmp_path))
    assert main(["import-reactions", table, case, "--new-case", "LIVE"]) == 2
    assert "--new-case" in capsys.readouterr().err


def test_long_lists_are_cut_short(tmp_path: Path, capsys: Capture) -> None:
    """Of many changes of one kind the first are listed, and the others counted."""
    rows = "".join(f"{n},{0.1 * (n % 60) - 3:.1f},{0.2 * (n // 60) - 2:.1f},G,{n + 1}\n" for n in range(120))
    table = str(write_table(tmp_path, "Node,x [m],y [m],Case,Fz [kN]\n" + rows))
    widths = ["--footprint", "50 mm", "50 mm", "--tolerance", "1 mm"]
    assert main(["import-reactions", table, str(write_case(tmp_path)), *widths]) == 0
    told = capsys.readouterr().out
    assert told.count("new: ") == 51
    assert "new: 70 more" in told
    assert "P 0 -> 7.26 MN" in told
