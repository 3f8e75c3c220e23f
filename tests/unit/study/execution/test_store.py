"""Studies: nothing that is done is lost, doubled or done again, whatever happens; all in one process."""

from __future__ import annotations

import hashlib
import os
import sqlite3
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import groundslab
from groundslab.case import casefile
from groundslab.cli import main
from groundslab.errors import InputError
from groundslab.study.execution import store, variant
from groundslab.study.sampling import designs
from helpers.studies import CASE, STUDY, read, run, write

pytestmark = pytest.mark.slow

MODEL = casefile.loads(CASE)


@pytest.fixture
def without_evaluation(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the command evaluate nothing, where only the rows are judged."""
    monkeypatch.setattr("groundslab.study.evaluate", lambda study: (study.folder,))


class TestStore:
    """Nothing that is done is lost, doubled or done again."""

    def test_folder(self, tmp_path: Path) -> None:
        """A folder holds both files as they were, seed, versions and hashes, and nothing half made beside it."""
        study = run(tmp_path)
        assert study.folder == tmp_path / "study-study"
        assert (study.folder / "study.toml").read_text() == STUDY
        assert (study.folder / "case.toml").read_text() == CASE
        assert study.about["seed"] == 3
        assert study.about["versions"]["numpy"] == np.__version__
        assert study.about["case_sha256"] == hashlib.sha256(CASE.encode()).hexdigest()
        assert {path.name for path in tmp_path.iterdir()} == {"slab.toml", "study.toml", "study-study"}
        names = {"study.toml", "case.toml", "about.json", "rows.sqlite", "lock.sqlite"}
        assert {path.name for path in study.folder.iterdir()} == names

    def test_numbers_come_back_as_they_were(self, tmp_path: Path) -> None:
        """Figures have all their digits in the store, fields the seven of a float32."""
        read_ = read(tmp_path)
        sample = designs.list_variants(read_.setup)
        rows = {n: variant.Worker(read_.setup).row(sample[n]) for n in (1, 2)}
        study = run(tmp_path)
        table = study.table()
        for number, row in rows.items():
            assert tuple(table.loc[number, ["k", "machine"]]) == sample[number].values
            assert tuple(table.loc[number, list(table.columns[-2:])]) == row.results
            whole = row.fields[0]
            assert whole is not None
            assert np.array_equal(dict(study.fields("settlement"))[number], whole.astype(np.float32))

    def test_interrupted_at_every_row(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """A study interrupted again and again has the rows of one that was not, and computed none of them twice."""
        whole = run(tmp_path)
        computed: list[int] = []
        row = variant.Worker.row

        def one_and_no_more(self: variant.Worker, one: designs.Variant, known: tuple[str, ...] = ()) -> variant.Row:
            if computed and one.number % 2:
                computed.append(0)
            if computed[-1:] == [0]:
                computed.pop()
                computed.append(one.number)
                raise KeyboardInterrupt
            computed.append(one.number)
            return row(self, one, known)

        monkeypatch.setattr(variant.Worker, "row", one_and_no_more)
        path, times = tmp_path / "study.toml", 0
        while True:
            try:
                part = groundslab.study(path, out=tmp_path / "part", workers=0, resume=True, quiet=True)
                break
            except KeyboardInterrupt:
                times += 1
                computed.clear()
        assert times > 3
        same = [column for column in whole.table().columns if column != "seconds"]
        assert part.table()[same].equals(whole.table()[same])
        assert len(part.runs()) == times + 1

    def test_resume_computes_what_is_missing_only(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """Rows that are there stay as they are, to the time that they took; only the others are solved."""
        before = run(tmp_path).table()
        with sqlite3.connect(tmp_path / "study-study" / "rows.sqlite") as connection:
            connection.execute("DELETE FROM rows WHERE number IN (3, 12)")
        connection.close()
        solved_now: list[int] = []
        row = variant.Worker.row
        monkeypatch.setattr(
            variant.Worker, "row", lambda self, one, known=(): (solved_now.append(one.number), row(self, one, known))[1]
        )
        after = run(tmp_path, resume=True).table()
        assert solved_now == [3, 12]
        kept = before.index.difference([3, 12])
        assert after.loc[kept].equals(before.loc[kept])
        assert after.drop(columns="seconds").equals(before.drop(columns="seconds"))

    def test_row_is_never_doubled(self, tmp_path: Path) -> None:
        """A row that is there is left alone when it comes again."""
        study = run(tmp_path, STUDY.replace("count = 12", "count = 2"))
        again = variant.Worker(study.setup).row(study.variants[1])
        with store.Store(study.folder, study.setup) as rows:
            before = rows.rows(["number", "seconds"])
            assert rows.add(again) == 0
            assert rows.rows(["number", "seconds"]) == before

    def test_full_disk(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """Where the database may not grow the study ends and says so; with room it continues to the same rows."""
        study = run(tmp_path)
        whole, connect = study.table(), store._connect
        with sqlite3.connect(study.folder / "rows.sqlite") as connection:
            (pages,) = connection.execute("PRAGMA page_count").fetchone()
        connection.close()

        def cramped(path: Path) -> sqlite3.Connection:
            connection = connect(path)
            connection.execute(f"PRAGMA max_page_count = {pages - 1}")
            return connection

        path, out = tmp_path / "study.toml", tmp_path / "part"
        with monkeypatch.context() as patch:
            patch.setattr(store, "_connect", cramped)
            with pytest.raises(store.StoreFull, match="database or disk is full"):
                groundslab.study(path, out=out, workers=0, quiet=True, resume=True)
        part = groundslab.open_study(out)
        assert 0 < len(part) < 12
        before = part.table()
        after = groundslab.study(path, out=out, workers=0, quiet=True, resume=True).table()
        assert after.loc[before.index].equals(before)
        assert after.drop(columns="seconds").equals(whole.drop(columns="seconds"))

    @pytest.mark.usefixtures("without_evaluation")
    @pytest.mark.skipif(sys.platform != "linux", reason="limits of this kind are those of Linux")
    def test_system_refuses_to_write(self, tmp_path: Path) -> None:
        """Where the system lets no file grow the command ends with code 1 and says how to go on, which then works."""
        path = write(tmp_path)
        program = (
            "import resource, sys\nfrom groundslab.cli import main as cli\n"
            "resource.setrlimit(resource.RLIMIT_FSIZE, (57344, 57344))\n"
            "sys.exit(cli.main(sys.argv[1:]))\n"
        )
        options = ["study", str(path), "--workers", "0", "--quiet"]
        ended = subprocess.run([sys.executable, "-c", program, *options], capture_output=True, text=True)
        assert ended.returncode == 1
        assert "could not be written" in ended.stderr
        assert "--resume" in ended.stderr
        assert 0 < len(groundslab.open_study(tmp_path / "study-study")) < 12
        assert main.main([*options, "--resume"]) == 0
        assert len(groundslab.open_study(tmp_path / "study-study")) == 12

    def test_one_run_at_a_time(self, tmp_path: Path) -> None:
        """A second run of the same folder is refused while the first one is on; reading is not."""
        study = run(tmp_path)
        with store.lock(study.folder):
            with pytest.raises(InputError, match="runs at this moment"):
                run(tmp_path, resume=True)
            assert len(study.table()) == 12

    def test_what_stands_in_the_way(self, tmp_path: Path) -> None:
        """A folder that is there is not taken over without resume, nor by another study, case or version."""
        study = run(tmp_path, STUDY.replace("count = 12", "count = 1"))
        with pytest.raises(InputError, match="--resume continues"):
            run(tmp_path, STUDY.replace("count = 12", "count = 1"))
        with pytest.raises(InputError, match="study file: found a file that was changed"):
            run(tmp_path, resume=True)
        with pytest.raises(InputError, match="case file: found a file that was changed"):
            run(tmp_path, STUDY.replace("count = 12", "count = 1"), CASE + "# more\n", resume=True)
        about = study.folder / "about.json"
        about.write_text(about.read_text().replace(f'"groundslab": "{groundslab.__version__}"', '"groundslab": "0"'))
        with pytest.raises(InputError, match="version 0, which the rows"):
            run(tmp_path, STUDY.replace("count = 12", "count = 1"), resume=True)

    def test_other_random_numbers(self, tmp_path: Path) -> None:
        """Rows whose values are not those that the seed gives now are not mixed with new ones."""
        run(tmp_path)
        with sqlite3.connect(tmp_path / "study-study" / "rows.sqlite") as connection:
            connection.execute("UPDATE rows SET k = k * 1.0000001 WHERE number = 4")
            checksum = store._checksum(connection.execute("SELECT * FROM rows WHERE number = 4").fetchone())
            connection.execute("UPDATE checksums SET sha256 = ? WHERE part = 'rows 4'", (checksum,))
        connection.close()
        with pytest.raises(InputError, match="row 4"):
            run(tmp_path, resume=True)

    def test_no_study(self, tmp_path: Path) -> None:
        """What is no study's folder is not opened, and not written to."""
        with pytest.raises(InputError, match="a folder that groundslab study made"):
            groundslab.open_study(tmp_path)
        (tmp_path / "study-study").mkdir()
        with pytest.raises(InputError, match="a name that is taken"):
            run(tmp_path)

    @pytest.mark.usefixtures("without_evaluation")
    def test_failed_worker_makes_no_row(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """What goes wrong with the machine leaves no row; the study goes on, says so, and resume tries again."""
        row = variant.Worker.row

        def sometimes(self: variant.Worker, one: designs.Variant, known: tuple[str, ...] = ()) -> variant.Row:
            if one.number == 7:
                raise MemoryError("no more")
            return row(self, one, known)

        path = write(tmp_path)
        with monkeypatch.context() as patch:
            patch.setattr(variant.Worker, "row", sometimes)
            assert main.main(["study", str(path), "--workers", "0", "--quiet"]) == 1
        study = groundslab.open_study(tmp_path / "study-study")
        assert study.worker_failures() == {7: "MemoryError: no more"}
        assert len(study) == 11
        assert main.main(["study", str(path), "--workers", "0", "--quiet", "--resume"]) == 0
        assert study.worker_failures() == {}

    def test_variants_that_end_the_only_process(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """Without workers two variants end the study each time; continued, it solves all others before them."""
        path, folder = write(tmp_path), tmp_path / "study-study"
        note, row = folder / store.SOLVING, variant.Worker.row
        left: list[str] = []

        class End(BaseException):
            """What ends the process, and leaves no time for anything."""

        def row_or_end(self: variant.Worker, one: designs.Variant, known: tuple[str, ...] = ()) -> variant.Row:
            if one.number in (2, 5):
                left.append(note.read_text())
                raise End
            return row(self, one, known)

        rows = []
        with monkeypatch.context() as patch:
            patch.setattr(variant.Worker, "row", row_or_end)
            for _ in range(4):
                with pytest.raises(End):
                    groundslab.study(path, workers=0, resume=True, quiet=True)
                assert not note.exists()
                # as the end of the process leaves it
                note.write_text(left[-1])
                rows.append(len(groundslab.open_study(folder)))
        assert left == ["2", "5", "2", "5"]
        assert rows == [1, 3, 10, 10]
        study = groundslab.study(path, workers=0, resume=True, quiet=True)
        assert len(study) == 12
        assert study.worker_failures() == {}
        assert not note.exists()
        with sqlite3.connect(folder / "rows.sqlite") as kept:
            mishaps = kept.execute("SELECT number, message FROM mishaps").fetchall()
        assert mishaps == [(number, "the process ended while it was solved") for number in (2, 5, 2, 5)]

    @pytest.mark.skipif(sys.platform == "win32" or os.geteuid() == 0, reason="needs a folder that cannot be written")
    def test_read_where_nothing_can_be_written(self, tmp_path: Path) -> None:
        """A study can be read from a folder without leave to write."""
        study = run(tmp_path)
        study.folder.chmod(0o500)
        assert len(groundslab.open_study(study.folder).table()) == 12


class TestCommand:
    """The command line."""

    def test_outcome(self, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
        """The command prints how many rows there are, and progress to standard error only."""
        path = write(tmp_path)
        assert main.main(["study", str(path), "--workers", "0"]) == 0
        shown = capsys.readouterr()
        rows, evaluation = shown.out.splitlines()
        assert rows == f"{tmp_path / 'study-study'}: 12 of 12 variants have a row, 12 solved"
        assert evaluation == f"evaluation: {tmp_path / 'study-study' / 'evaluation' / 'report.html'}"
        assert "solving in this process" in shown.err
        assert main.main(["study", str(path), "--workers", "0"]) == 2
        assert "--resume continues" in capsys.readouterr().err

    def test_interrupt(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
    ) -> None:
        """Ctrl-C ends with code 130 and says what is kept and how to go on."""
        row = variant.Worker.row

        def until_five(self: variant.Worker, one: designs.Variant, known: tuple[str, ...] = ()) -> variant.Row:
            if one.number == 5:
                raise KeyboardInterrupt
            return row(self, one, known)

        path = write(tmp_path)
        monkeypatch.setattr(variant.Worker, "row", until_five)
        assert main.main(["study", str(path), "--workers", "0", "--quiet"]) == 130
        stderr = capsys.readouterr().err
        assert "4 of 12 rows are kept" in stderr
        assert f"groundslab study {path} --resume" in stderr

    @pytest.mark.parametrize(
        "option", [["--workers", "-1"], ["--workers", "x"], ["--workers", "1", "--scheduler", "a"]]
    )
    def test_wrong_options(self, tmp_path: Path, option: list[str]) -> None:
        """Numbers that are none, and two places at once, are refused."""
        with pytest.raises(SystemExit) as caught:
            main.main(["study", str(write(tmp_path)), *option])
        assert caught.value.code == 2
