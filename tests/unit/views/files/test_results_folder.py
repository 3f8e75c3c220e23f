"""Folders of results: whole or not at all, and never in place of what somebody else wrote."""

from __future__ import annotations

import csv
import json
import multiprocessing
import os
import shutil
import signal
import time
from contextlib import suppress
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from groundslab.analysis.driver import solve
from groundslab.case import casefile
from groundslab.cli import main
from groundslab.errors import (
    CertificateWithdrawn,
    EditedFilesKept,
    GroundslabError,
    InputError,
    NoEquilibrium,
    NotCertified,
    NotConverged,
    SingularMatrix,
)
from groundslab.results.results import Increment
from groundslab.views.files import npz, results_folder
from groundslab.views.files.manifest import DEEPEST, folder_name, is_path
from helpers import damage, dying, small_case, synthetic

OLD, NEW = synthetic.results(), synthetic.results(lifts=False)
TABLES = {f"tables/{name}.csv" for name in ("combinations", "extremes", "envelope", "tilt")}
FILES = {"plate.vtu", "ground.vtu", "results.npz", "case.toml", "summary.json"} | TABLES


def contents(folder: Path) -> dict[str, bytes]:
    """Return the files of a folder, byte by byte."""
    return {name: (folder / name).read_bytes() for name in tree(folder)}


def tree(folder: Path) -> set[str]:
    """Return the paths of all files below a folder."""
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if not path.is_dir()}


def debris(folder: Path) -> list[str]:
    """Return what lies beside the folder."""
    return sorted(path.name for path in folder.parent.iterdir() if path != folder)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a folder that holds results."""
    return results_folder.save_results(OLD, tmp_path / "room" / "raft")


class TestWrite:
    """What is written, and where."""

    @pytest.mark.slow
    @pytest.mark.parametrize("plot", [False, True])
    def test_summary_lists_exactly_the_files(self, tmp_path: Path, plot: bool) -> None:
        """The folder holds what the summary lists, a picture only when asked for; nothing lies beside it."""
        folder = results_folder.save_results(OLD, tmp_path / "deep" / "down" / "raft", plot=plot)
        files = FILES | ({"picture.png"} if plot else set())
        assert set(contents(folder)) == files == set(json.loads((folder / "summary.json").read_text())["files"])
        assert debris(folder) == []
        synthetic.assert_same(npz.load(folder / "results.npz"), OLD)
        assert casefile.load(folder / "case.toml") == OLD.model

    @pytest.mark.slow
    def test_replaces_earlier_results_whole(self, folder: Path) -> None:
        """Files of the earlier results that the new ones lack are gone."""
        results_folder.save_results(OLD, folder, plot=True)
        results_folder.save_results(NEW, folder)
        assert set(contents(folder)) == FILES
        synthetic.assert_same(npz.load(folder / "results.npz"), NEW)
        assert debris(folder) == []

    def test_an_empty_folder_and_litter_are_no_obstacle(self, tmp_path: Path) -> None:
        """An empty folder may be written to, also if a file manager has been there."""
        (tmp_path / "raft").mkdir()
        (tmp_path / "raft" / ".DS_Store").touch()
        assert set(contents(results_folder.save_results(OLD, tmp_path / "raft"))) == FILES

    def test_follows_a_link_to_a_folder(self, tmp_path: Path) -> None:
        """A link stays a link, and the folder that it leads to holds the results."""
        (tmp_path / "real").mkdir()
        _link(tmp_path / "link", tmp_path / "real")
        assert results_folder.save_results(OLD, tmp_path / "link") == (tmp_path / "real").resolve()
        assert (tmp_path / "link").is_symlink()
        assert set(contents(tmp_path / "real")) == FILES

    def test_rights_are_those_of_any_new_folder(self, folder: Path) -> None:
        """Others may read the results if the user's mask lets them."""
        plain = folder.parent / "plain"
        plain.mkdir()
        assert folder.stat().st_mode == plain.stat().st_mode


class TestSeveral:
    """Several combinations: a folder for each, beside what tells of all."""

    EACH = ("01-grosse-1-2-dead-wind", "02-nul", "03-uncertified")

    @pytest.mark.slow
    def test_a_folder_for_each_that_has_results(self, tmp_path: Path) -> None:
        """The summary names every file, in folders too; a combination without results has none."""
        folder = results_folder.save_results(synthetic.combined(), tmp_path / "raft", plot=True)
        each = {"plate.vtu", "ground.vtu", "results.npz", "picture.png"}
        shared = {"plate.pvd", "ground.pvd", "combinations.csv", "envelope.vtu", "case.toml", "summary.json"} | TABLES
        shared |= {"tables/acting.csv", "tables/checks.csv"}  # cases, and a combination without equilibrium
        files = shared | {f"{room}/{name}" for room in self.EACH for name in each}
        assert tree(folder) == files == set(json.loads((folder / "summary.json").read_text())["files"])
        assert debris(folder) == []

    @pytest.mark.slow
    def test_comes_back(self, tmp_path: Path) -> None:
        """Results, combinations, model and refusals are read back; what is not certified stays refused."""
        wanted = synthetic.combined()
        found = results_folder.load_results(results_folder.save_results(wanted, tmp_path / "raft"))
        assert (found.model, found.combinations) == (wanted.model, wanted.combinations)
        assert found.results.keys() == wanted.results.keys()
        for name, results in wanted.results.items():
            synthetic.assert_same(found[name], results)
        first, *others = found.results.values()
        assert others
        assert all(each.plate.elements is first.plate.elements for each in others)
        uncertified = found.refused["uncertified"]
        assert isinstance(uncertified, NotCertified)
        synthetic.assert_same(uncertified.results, wanted.refused["uncertified"].results)  # type: ignore[attr-defined]
        with pytest.raises(NoEquilibrium, match="pull the plate off"):
            found["wind alone"]

    def test_one_comes_back_as_all_there_are(self, folder: Path) -> None:
        """A folder of one combination is read as the one of several, certified or not."""
        found = results_folder.load_results(folder)
        (combination,) = found.combinations
        assert (combination.name, dict(combination.factors), found.refused) == ("all loads", {"": 1.0}, {})
        synthetic.assert_same(found["all loads"], OLD)
        bad = synthetic.results(certificate=replace(synthetic.CERTIFICATE, residual=1.0))
        results_folder.save_results(bad, folder)
        assert isinstance(results_folder.load_results(folder).refused["all loads"], NotCertified)

    def test_errors_come_back_with_their_history(self, tmp_path: Path) -> None:
        """What did not converge keeps its name and steps, also such as JSON cannot hold; other errors their kind."""
        combined = synthetic.combined()
        history = [OLD.steps[0], {"gamma": float("nan")}, 1.5]
        refused = {
            "uncertified": NotConverged("contact", history, {"u": OLD.plate.settlement}),
            "wind alone": SingularMatrix("no stiffness"),
        }
        found = results_folder.load_results(
            results_folder.save_results(replace(combined, refused=refused), tmp_path / "raft")
        ).refused
        one, other = found["uncertified"], found["wind alone"]
        assert isinstance(one, NotConverged)
        assert one.what == "contact"
        assert list(one.history) == [asdict(OLD.steps[0]), {"gamma": "nan"}, 1.5]
        assert isinstance(other, SingularMatrix)
        assert str(other) == "no stiffness"

    def test_collections_hold_what_is_certified(self, tmp_path: Path) -> None:
        """The times of a ParaView collection are the numbers; its files are there; the uncertified one is left out."""
        folder = results_folder.save_results(synthetic.combined(), tmp_path / "raft")
        for name in ("plate", "ground"):
            sets = ElementTree.parse(folder / f"{name}.pvd").getroot().findall("./Collection/DataSet")
            assert [each.get("timestep") for each in sets] == ["1", "2"]
            assert [each.get("file") for each in sets] == [f"{room}/{name}.vtu" for room in self.EACH[:2]]
            assert all((folder / str(each.get("file"))).is_file() for each in sets)

    def test_list_of_combinations(self, tmp_path: Path) -> None:
        """The list has a row for each, solved or not, with its factors."""
        folder = results_folder.save_results(synthetic.combined(), tmp_path / "raft")
        with (folder / "combinations.csv").open(encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        assert [row["number"] for row in rows] == ["1", "2", "3", "4"]
        assert [row["certified"] for row in rows] == ["yes", "yes", "no", "no"]
        assert [row["folder"] for row in rows] == [*self.EACH, ""]
        assert [row["factor of wind"] for row in rows] == ["1.5", "0.0", "0.0", "1.0"]
        assert rows[3]["reason"] == "FOUNDATION FAILS: the loads pull the plate off"

    @pytest.mark.slow
    @pytest.mark.parametrize("place", ["02-nul", "own", "01-grosse-1-2-dead-wind/deeper"])
    def test_foreign_things_in_folders_within(self, tmp_path: Path, place: str) -> None:
        """What somebody put into a folder below protects the whole; litter of file managers does not."""
        folder = results_folder.save_results(synthetic.combined(), tmp_path / "raft")
        (folder / "02-nul" / ".DS_Store").touch()
        results_folder.save_results(synthetic.combined(), folder)
        (folder / place).mkdir(exist_ok=True)
        (folder / place / "notes.txt").write_text("mine")
        before = tree(folder)
        with pytest.raises(InputError) as caught:
            results_folder.save_results(NEW, folder)
        (issue,) = caught.value.issues
        named = f"{place}/notes.txt" if place == "02-nul" else place
        assert Path(issue.location) == folder / named
        assert tree(folder) == before
        assert debris(folder) == []

    def test_a_folder_within_that_is_a_link_now(self, tmp_path: Path) -> None:
        """A link in place of a combination's folder is not ours, and what it leads to stays."""
        folder = results_folder.save_results(synthetic.combined(), tmp_path / "raft")
        (folder / "02-nul").rename(tmp_path / "elsewhere")
        _link(folder / "02-nul", tmp_path / "elsewhere")
        with pytest.raises(InputError, match="02-nul"):
            results_folder.save_results(NEW, folder)
        assert (tmp_path / "elsewhere" / "plate.vtu").is_file()

    def test_the_user_stands_in_a_folder_within(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """Nor is the working directory pulled away if it lies deeper."""
        folder = results_folder.save_results(synthetic.combined(), tmp_path / "raft")
        monkeypatch.chdir(folder / "02-nul")
        with pytest.raises(InputError, match="current"):
            results_folder.check(folder)

    def test_one_replaces_several_and_the_reverse(self, tmp_path: Path) -> None:
        """Nothing is left of what stood there before, in either direction."""
        folder = results_folder.save_results(synthetic.combined(), tmp_path / "raft")
        results_folder.save_results(NEW, folder)
        assert tree(folder) == FILES
        results_folder.save_results(synthetic.combined(), folder)
        assert not FILES - TABLES - {"case.toml", "summary.json"} & tree(folder)

    def test_every_file_is_on_the_disk(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """Each file is flushed before the folder gets its name, those in folders within too."""
        fsync, synced = os.fsync, []

        def seen(handle: int) -> None:
            synced.append(os.fstat(handle).st_ino)
            fsync(handle)

        monkeypatch.setattr(os, "fsync", seen)
        folder = results_folder.save_results(synthetic.combined(), tmp_path / "raft")
        assert {(folder / name).stat().st_ino for name in tree(folder)} <= set(synced)

    @pytest.mark.parametrize(
        ("name", "folder"),
        [
            ("dead", "07-dead"),
            ("CON", "07-con"),
            ("..", "07"),
            ("a/b\\c: *?<>|", "07-a-b-c"),
            ("Straße in Łódź", "07-strasse-in-odz"),
            ("雪", "07"),
            ("x" * 300, "07-" + "x" * 40),
            ("trailing. ", "07-trailing"),
        ],
    )
    def test_names_of_folders_that_every_system_can_hold(self, name: str, folder: str) -> None:
        """A number, and of the name only small letters, digits and hyphens; numbers as long as the largest."""
        assert folder_name(7, name, 12) == folder
        assert folder_name(7, name, 1000).startswith("0007")

    def test_what_is_no_folder_of_results(self, tmp_path: Path, folder: Path) -> None:
        """Nothing, something else, a summary of something else and archives that do not belong are refused."""
        for none in (tmp_path / "none", tmp_path):
            with pytest.raises(InputError, match="summary"):
                results_folder.load_results(none)
        several = results_folder.save_results(synthetic.combined(), tmp_path / "several")
        shutil.copy(folder / "results.npz", several / "02-nul" / "results.npz")
        with pytest.raises(InputError, match="another case"):
            results_folder.load_results(several)
        for wrong in ([{}], 3, [{"name": 3}]):
            text = json.dumps({"program": "groundslab", "files": ["a"], "combinations": wrong})
            (several / "summary.json").write_text(text)
            with pytest.raises(InputError):
                results_folder.load_results(several)


class TestDamaged:
    """Folders in which something is damaged."""

    @pytest.mark.slow
    @pytest.mark.parametrize("how", damage.FILES)
    def test_files(self, folder: Path, how: str, capsys: pytest.CaptureFixture[str]) -> None:
        """Whatever became of a file: reading, report and plot name the folder, with exit code 2 and no traceback."""
        damage.FILES[how](folder)
        with pytest.raises(InputError, match="raft"):
            results_folder.load_results(folder)
        for command, ending in (("report", "html"), ("plot", "png")):
            out = folder.with_name(f"a.{ending}")
            assert main.main([command, str(folder), "--out", str(out)]) == 2
            assert "that groundslab wrote" in capsys.readouterr().err
            assert not out.exists()

    @pytest.mark.slow
    @pytest.mark.parametrize("how", damage.ARRAYS)
    def test_arrays(self, folder: Path, how: str) -> None:
        """No array of another type, shape or range is read as one of results, whichever it is."""
        whole = (folder / "results.npz").read_bytes()
        for name, values in damage.arrays(folder / "results.npz").items():
            if name in ("model", "about") or (how == "single precision" and values.dtype == np.float32):
                continue
            damage.with_array(folder / "results.npz", name, damage.ARRAYS[how])
            with pytest.raises(InputError, match="archive"):
                results_folder.load_results(folder)
            (folder / "results.npz").write_bytes(whole)
        assert results_folder.load_results(folder)

    @pytest.mark.parametrize("by", [-1, 25, 10**12])
    def test_elements_with_nodes_that_are_not_there(self, folder: Path, by: int) -> None:
        """Indices beyond the nodes, or below 0, are found out, of plate and ground."""
        for name in ("plate.elements", "ground.elements"):
            archived = folder / "results.npz"
            whole = archived.read_bytes()
            damage.with_array(archived, name, lambda a: np.where(a == 0, by, a))
            with pytest.raises(InputError, match="nodes that are not there"):
                results_folder.load_results(folder)
            archived.write_bytes(whole)

    @pytest.mark.parametrize("change", [lambda a: a[:, ::-1], lambda a: a[:, [0] * 9]])
    def test_elements_without_area(self, folder: Path, change: Any) -> None:
        """Elements that are turned over, or one point, are no mesh."""
        damage.with_array(folder / "results.npz", "plate.elements", change)
        with pytest.raises(InputError, match=r"no area|no element"):
            results_folder.load_results(folder)

    def test_a_certificate_cannot_be_better_than_perfect(self, folder: Path) -> None:
        """Figures below zero would pass each limit; they are no figures of a certificate."""
        damage.with_about(folder / "results.npz", ("certificate", "residual"), -1.0)
        with pytest.raises(InputError, match="certificate"):
            results_folder.load_results(folder)

    @pytest.mark.slow
    @pytest.mark.parametrize("value", ["text", None, [], {"a": 1}])
    def test_summaries(self, tmp_path: Path, value: Any) -> None:
        """Whatever stands in place of any value of a summary, it is read as it was meant, or refused."""
        folder = results_folder.save_results(synthetic.combined(), tmp_path / "raft")
        path = folder / "summary.json"
        whole = path.read_text()
        read = {"name", "limit_state", "factors", "folder", "refused"}
        for place in damage.places({"combinations": json.loads(whole)["combinations"]}):
            if len(place) > 2 and (place[2] not in read or place[1] % 2):
                continue
            document = json.loads(whole)
            damage.put(document, place, value)
            path.write_text(json.dumps(document))
            with suppress(InputError, CertificateWithdrawn):
                assert len(results_folder.load_results(folder).combinations) == 4

    def test_folders_of_combinations_elsewhere(self, tmp_path: Path) -> None:
        """A summary cannot lead out of its folder."""
        folder = results_folder.save_results(synthetic.combined(), tmp_path / "raft")
        (folder / "02-nul").rename(tmp_path / "02-nul")
        text = (folder / "summary.json").read_text()
        (folder / "summary.json").write_text(text.replace('"folder": "02-nul"', '"folder": "../02-nul"'))
        with pytest.raises(InputError, match="02-nul"):
            results_folder.load_results(folder)


class TestElsewhere:
    """Results whose folder cannot be written."""

    def test_a_place_that_somebody_took_meanwhile(self, folder: Path) -> None:
        """They are kept in a new folder beside it, whole."""
        (folder / "notes.txt").write_text("mine")
        for number in (2, 3):
            assert results_folder.write_elsewhere(NEW, folder) == folder.with_name(f"raft-{number}")
        synthetic.assert_same(npz.load(folder.with_name("raft-2") / "results.npz"), NEW)

    def test_a_full_disk(self, folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """They are kept among temporary files, if these are on another disk; else nothing is left anywhere."""
        (tmp_path / "temporary").mkdir()
        monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "temporary"))
        fsync = os.fsync

        def full(handle: int) -> None:
            if all_full or "temporary" not in str(Path(f"/proc/self/fd/{handle}").readlink()):
                raise OSError(28, "No space left on device")
            fsync(handle)

        if not Path("/proc/self/fd").is_dir():
            pytest.skip("needs Linux, to tell two disks apart")
        monkeypatch.setattr(os, "fsync", full)
        all_full = False
        kept = results_folder.write_elsewhere(NEW, folder)
        assert kept is not None
        assert kept.is_relative_to(tmp_path / "temporary")
        synthetic.assert_same(npz.load(kept / "results.npz"), NEW)
        shutil.rmtree(kept.parent)
        all_full = True
        assert results_folder.write_elsewhere(NEW, folder) is None
        assert list((tmp_path / "temporary").iterdir()) == []
        assert debris(folder) == []


class TestRefuse:
    """What is in the way is named and left untouched."""

    @pytest.mark.parametrize("kind", ["file", "folder", "link"])
    def test_foreign_things_in_the_folder(self, folder: Path, kind: str) -> None:
        """A file, folder or link that somebody put among the results stops everything."""
        if kind == "file":
            (folder / "notes.txt").write_text("mine")
        elif kind == "folder":
            (folder / "notes.txt").mkdir()
        else:
            _link(folder / "notes.txt", folder / "plate.vtu")
        names = {path.name for path in folder.iterdir()}
        with pytest.raises(InputError, match=r"notes\.txt"):
            results_folder.save_results(NEW, folder)
        assert {path.name for path in folder.iterdir()} == names
        synthetic.assert_same(npz.load(folder / "results.npz"), OLD)
        assert debris(folder) == []

    def test_a_listed_name_that_is_a_link_now(self, folder: Path, tmp_path: Path) -> None:
        """A link under the name of one of our files is not ours."""
        (folder / "plate.vtu").rename(tmp_path / "elsewhere.vtu")
        _link(folder / "plate.vtu", tmp_path / "elsewhere.vtu")
        with pytest.raises(InputError, match=r"plate\.vtu"):
            results_folder.save_results(NEW, folder)

    @pytest.mark.slow
    @pytest.mark.parametrize(
        "name",
        ["thesis.docx", "case.md", "sub/thesis.docx", "../thesis.docx", "tables/../thesis.docx", "Plate.vtu",
         "01-A/plate.vtu", "tables/thesis.CSV", "increments/plate.vtu", "raft.toml", "01-a/case.toml", ".bashrc", ""],
    )  # fmt: skip
    def test_a_summary_that_names_what_is_not_ours(self, folder: Path, name: str) -> None:
        """A file is not ours because a summary says so: names that are never written protect the whole folder."""
        mine = folder / (name or "mine.txt")
        mine.parent.mkdir(exist_ok=True)
        mine.write_text("mine")
        summary = json.loads((folder / "summary.json").read_text())
        summary["files"] += [name, str(mine)]
        (folder / "summary.json").write_text(json.dumps(summary))
        before = tree(folder.parent)
        if name.startswith("..") or "/../" in name:
            # they lie outside of it or are called otherwise there, and stay; the edited summary is kept
            if name.startswith(".."):
                with pytest.warns(EditedFilesKept, match=r"raft-edited: summary\.json"):
                    results_folder.save_results(NEW, folder)
        else:
            with pytest.raises(InputError):
                results_folder.save_results(NEW, folder)
            assert tree(folder.parent) == before
        assert mine.read_text() == "mine"

    @pytest.mark.parametrize("name", ["plate.vtu", "picture.png", "results.npz", "tables/tilt.csv", "case.toml"])
    def test_a_name_of_ours_with_something_else_in_it(self, folder: Path, name: str) -> None:
        """Where one of our names holds another kind of file, it is the user's, listed or not."""
        (folder / name).write_bytes(b"\0 mine")
        summary = json.loads((folder / "summary.json").read_text())
        summary["files"].append(name)
        (folder / "summary.json").write_text(json.dumps(summary))
        with pytest.raises(InputError, match=Path(name).name):
            results_folder.save_results(NEW, folder)
        assert (folder / name).read_bytes() == b"\0 mine"
        assert debris(folder) == []

    @pytest.mark.slow
    def test_every_name_is_a_name_of_ours(self, tmp_path: Path) -> None:
        """Whatever is written, with many combinations and increments too, is among the names that may be replaced."""
        combined = synthetic.combined()
        state = Increment(0.5, OLD.plate, OLD.elements, OLD.ground)
        first = replace(combined.results["NUL"], increments=(state,) * 100)
        results = combined.results | {"NUL": first}
        folder = results_folder.save_results(replace(combined, results=results), tmp_path / "raft", plot=True)
        assert "02-nul/increments/100-plate.vtu" in tree(folder)
        assert all(map(is_path, tree(folder)))
        assert all(is_path(f"{folder_name(number, 'x' * 300, 12345)}/plate.vtu") for number in (1, 12345))
        assert max(map(len, tree(folder))) < len(DEEPEST)
        assert len(f"{folder_name(12345, 'x' * 300, 12345)}/increments/12345-ground.vtu") <= len(DEEPEST)

    def test_files_of_beams_are_ours(self, tmp_path: Path) -> None:
        """Results with beams are replaced as others are; those of several combinations have a collection of beams."""
        beam = '[[beams]]\nname = "rib"\npoints = [["-2 m", "0 m"], ["2 m", "0 m"]]\n'
        section = 'section = {kind = "rectangle", width = "300 mm", height = "500 mm"}\n'
        results = solve(casefile.loads(f"{small_case.TEXT}\n{beam}{section}"))
        folder = results_folder.save_results(results, tmp_path / "raft")
        assert (folder / "beams.vtu").is_file()
        assert results_folder.save_results(results, folder) == folder
        assert is_path("beams.pvd")
        assert is_path("02-nul/beams.vtu")

    def test_names_that_are_too_long(self, tmp_path: Path) -> None:
        """They are found out before the analysis; the longest that the system takes can be written and replaced."""
        with pytest.raises(InputError, match="too long"):
            results_folder.check(tmp_path / ("x" * 256))
        deep = tmp_path.joinpath(*["y" * 250] * 15)
        missing = 4095 - len(os.fsencode(deep))  # of Linux, with the zero at the end
        with pytest.raises(InputError, match="too long"):
            results_folder.check(deep / ("x" * min(250, missing - 30)))
        for length in (236, 255):
            for results in (OLD, NEW):
                folder = results_folder.save_results(results, tmp_path / "long" / ("x" * length))
                assert results_folder.check(folder) == folder
                assert debris(folder) == [] or length == 255
                synthetic.assert_same(npz.load(folder / "results.npz"), results)

    @pytest.mark.parametrize("summary", [None, "{", "[]", '{"program": "other", "files": ["a.txt"]}', '{"files": 3}'])
    def test_a_folder_without_our_summary(self, tmp_path: Path, summary: str | None) -> None:
        """Every file of a folder that is not ours is named, whatever its summary.json says."""
        (tmp_path / "a.txt").write_text("mine")
        if summary is not None:
            (tmp_path / "summary.json").write_text(summary)
        before = contents(tmp_path)
        with pytest.raises(InputError) as caught:
            results_folder.save_results(NEW, tmp_path)
        assert {Path(issue.location).name for issue in caught.value.issues} == set(before)
        assert contents(tmp_path) == before

    def test_a_file(self, tmp_path: Path) -> None:
        """A file under the folder's name, or in place of its parent, is left alone."""
        (tmp_path / "raft").write_text("mine")
        for target in (tmp_path / "raft", tmp_path / "raft" / "results"):
            with pytest.raises(InputError, match="a file"):
                results_folder.save_results(NEW, target)
        assert (tmp_path / "raft").read_text() == "mine"

    def test_a_link_to_itself(self, tmp_path: Path) -> None:
        """A loop of links is a issue, not a traceback, as the folder and as its parent."""
        _link(tmp_path / "loop", tmp_path / "loop")
        for target in (tmp_path / "loop", tmp_path / "loop" / "raft"):
            with pytest.raises(InputError, match="back to itself"):
                results_folder.check(target)

    def test_the_folder_that_the_user_stands_in(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """The working directory is not pulled away."""
        monkeypatch.chdir(tmp_path)
        with pytest.raises(InputError, match="current"):
            results_folder.check(".")

    def test_a_root_folder(self) -> None:
        """The root of the file system is no folder for results."""
        with pytest.raises(InputError):
            results_folder.check(os.path.abspath(os.sep))  # noqa: PTH100

    def test_a_parent_without_leave_to_write(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """If the system refuses a folder, that is a issue; earlier results stay."""
        monkeypatch.setattr(os, "access", lambda *_: False)
        with pytest.raises(InputError, match="leave to write"):
            results_folder.check(folder)
        monkeypatch.undo()

        def refuse(*_: Any, **__: Any) -> None:
            raise PermissionError(13, "Permission denied")

        monkeypatch.setattr(os, "mkdir", refuse)
        with pytest.raises(InputError, match="Permission denied"):
            results_folder.save_results(NEW, folder)
        synthetic.assert_same(npz.load(folder / "results.npz"), OLD)

    def test_somebody_elses_previous(self, folder: Path) -> None:
        """A folder of somebody else under the helper's name is neither removed nor used."""
        other = folder.with_name(".raft.previous")
        other.mkdir()
        (other / "mine.txt").write_text("mine")
        with pytest.raises(InputError, match="in the way"):
            results_folder.save_results(NEW, folder)
        assert contents(other) == {"mine.txt": b"mine"}

    def test_results_that_cannot_be_shown(self, folder: Path) -> None:
        """Results with a number that is none leave the earlier ones in place, and nothing beside them."""
        bad = synthetic.results(constants=synthetic.Constants((float("nan"),), (0.0,), None, 0))
        before = contents(folder)
        with pytest.raises(GroundslabError, match="not finite"):
            results_folder.save_results(bad, folder)
        assert contents(folder) == before
        assert debris(folder) == []


class TestFailures:
    """Failures of the system while results are written."""

    @pytest.mark.parametrize("failing", [1, 2])
    def test_a_rename_that_fails_is_undone(self, folder: Path, monkeypatch: pytest.MonkeyPatch, failing: int) -> None:
        """Whichever of the two renames fails, the earlier results are in place afterwards."""
        before, rename, calls = contents(folder), os.rename, []

        def once(*arguments: Any, **options: Any) -> None:
            calls.append(arguments)
            if len(calls) == failing:
                raise PermissionError(13, "in use")
            rename(*arguments, **options)

        monkeypatch.setattr(os, "rename", once)
        with pytest.raises(InputError, match="in use"):
            results_folder.save_results(NEW, folder)
        assert contents(folder) == before
        assert debris(folder) == []

    def test_a_full_disk(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """If the disk is full nothing is left half written."""

        def full(_: int) -> None:
            raise OSError(28, "No space left on device")

        before = contents(folder)
        monkeypatch.setattr(os, "fsync", full)
        with pytest.raises(InputError, match="No space left"):
            results_folder.save_results(NEW, folder)
        assert contents(folder) == before
        assert debris(folder) == []

    def test_only_old_rubbish_is_swept(self, folder: Path) -> None:
        """Half-written folders go after an hour, younger ones and other names stay."""
        names = {
            ".raft.partial-00000000": 2,
            ".raft.partial-11111111": 0,
            ".raft.partial-mine": 2,
            ".other.partial-00000000": 2,
        }
        for name, hours in names.items():
            path = folder.with_name(name)
            path.mkdir()
            (path / "plate.vtu").touch()
            then = time.time() - hours * 3600
            os.utime(path / "plate.vtu", (then, then))
            os.utime(path, (then, then))
        results_folder.save_results(NEW, folder)
        assert debris(folder) == sorted(set(names) - {".raft.partial-00000000"})


class TestRecover:
    """What a crash between the renames left behind."""

    def test_puts_back_what_lies_aside(self, folder: Path) -> None:
        """Results under the name of the previous ones come back."""
        before = contents(folder)
        folder.rename(folder.with_name(".raft.previous"))
        assert results_folder.recover(folder)
        assert contents(folder) == before
        assert not results_folder.recover(folder)

    def test_puts_back_over_an_empty_folder(self, folder: Path) -> None:
        """An empty folder made since is no reason to give up the results."""
        before = contents(folder)
        folder.rename(folder.with_name(".raft.previous"))
        folder.mkdir()
        assert results_folder.recover(folder)
        assert contents(folder) == before

    def test_keeps_both_where_something_foreign_stands(self, folder: Path) -> None:
        """If somebody's files stand in the results' place, neither these nor the old results are touched."""
        before, aside = contents(folder), folder.with_name(".raft.previous")
        folder.rename(aside)
        folder.mkdir()
        (folder / "notes.txt").write_text("mine")
        with pytest.raises(InputError):
            results_folder.save_results(NEW, folder)
        assert contents(aside) == before
        assert contents(folder) == {"notes.txt": b"mine"}


#: How processes start that die: forked from one that has loaded everything, where the system can.
PROCESSES = multiprocessing.get_context(
    "forkserver" if "forkserver" in multiprocessing.get_all_start_methods() else "spawn"
)


def killed(function: str, number: int, moment: str, folder: Path, several: bool = False) -> bool:
    """Return whether a process that saves results is killed at a call of the system."""
    if hasattr(PROCESSES, "set_forkserver_preload"):
        PROCESSES.set_forkserver_preload(["__main__", dying.__name__])
    process = PROCESSES.Process(target=dying.save, args=(function, number, moment, folder, several))
    process.start()
    process.join()
    return process.exitcode == (-signal.SIGKILL if hasattr(signal, "SIGKILL") else 9)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("function", "number", "moment", "survives", "needs_recovery"),
    [
        ("mkdir", 2, "after", "old", False),  # the staging folder is there, empty
        ("fsync", 1, "before", "old", False),  # all files are written, none is known to be on the disk
        ("fsync", 6, "after", "old", False),
        ("rename", 1, "before", "old", False),
        ("rename", 1, "after", "old", True),  # between the renames
        ("rename", 2, "before", "old", True),
        ("rename", 2, "after", "new", False),
        ("rename", 3, "before", "new", False),
        ("rename", 3, "after", "new", False),
        ("unlink", 2, "after", "new", False),  # while the old results are removed
    ],
)
def test_a_killed_run_leaves_whole_results(
    folder: Path, function: str, number: int, moment: str, survives: str, needs_recovery: bool
) -> None:
    """Wherever a run is killed, all of the old or all of the new results are there and can be replaced."""
    before = contents(folder)
    assert killed(function, number, moment, folder)
    assert folder.exists() is not needs_recovery
    assert results_folder.recover(folder) is needs_recovery
    if survives == "old":
        assert contents(folder) == before
    else:
        assert set(contents(folder)) == FILES
        synthetic.assert_same(npz.load(folder / "results.npz"), NEW)
    assert all(".partial-" in name for name in debris(folder))
    results_folder.save_results(NEW, folder)
    synthetic.assert_same(npz.load(folder / "results.npz"), NEW)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("function", "number", "moment", "survives", "needs_recovery"),
    [
        ("mkdir", 3, "after", "old", False),  # in the first of the folders within
        ("fsync", 9, "after", "old", False),
        ("rename", 1, "after", "old", True),
        ("rename", 2, "after", "new", False),
    ],
)
@pytest.mark.parametrize("before", ["one", "several"])
def test_a_killed_run_of_several_leaves_whole_results(
    tmp_path: Path, before: str, function: str, number: int, moment: str, survives: str, needs_recovery: bool
) -> None:
    """The same where each combination has a folder, in place of one or of several."""
    folder = results_folder.save_results(OLD if before == "one" else synthetic.combined(), tmp_path / "raft")
    (folder / ".DS_Store").touch()
    old = tree(folder)
    assert killed(function, number, moment, folder, several=True)
    assert results_folder.recover(folder) is needs_recovery
    if survives == "old":
        assert tree(folder) == old
    assert results_folder.load_results(folder).results.keys() == (
        {"all loads"} if before == "one" and survives == "old" else synthetic.combined().results.keys()
    )
    assert all(".partial-" in name for name in debris(folder) if survives == "old")
    results_folder.save_results(NEW, folder)
    assert tree(folder) == FILES


def _link(link: Path, target: Path) -> None:
    """Make a symbolic link, or skip the test where the system does not let us."""
    try:
        link.symlink_to(target)
    except OSError:
        pytest.skip("no symbolic links here")
