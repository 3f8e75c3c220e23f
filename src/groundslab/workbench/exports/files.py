"""Files that are made of results: report, tables, figures, drawings, field values, the case for other programs."""

from __future__ import annotations

import pickle
import tempfile
import zipfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal, get_args

from groundslab.errors import InputError, Issue
from groundslab.messages import Label, Message
from groundslab.schema.wording import describe

if TYPE_CHECKING:
    from groundslab.analysis.ground_comparison.comparison import GroundComparison
    from groundslab.results.results import Results
    from groundslab.views.difference import Subtracted

#: What a file is of, and its kind.
ExportName = Literal[
    "report.pdf", "tables.xlsx", "tables.zip", "plan.pdf", "plan.svg", "plan.png", "plan.dxf", "bars.dxf", "bars.pdf",
    "bars.svg", "bars.csv", "bars.xlsx", "bars.abs", "bars.ifc", "bars-a1.pdf", "bars-a2.pdf", "bars-a3.pdf",
    "bars-a1.dxf", "bars-a2.dxf", "bars-a3.dxf", "saf.xlsx", "plate.vtu",
]  # fmt: skip
SAF: ExportName = "saf.xlsx"
#: Notes that are passed on, and letters of one, at most.
LISTED, LONGEST = 200, 300


@dataclass(frozen=True, slots=True)
class Wanted:
    """A file that is wanted: its name, that of the case, and the field and the combination or envelope that it is of.

    The envelope is a limit state. A report has the remark. A plan is of the difference to a combination of the same
    results, or of those in the file of a reference.
    """

    file: ExportName
    case: str = "case.toml"
    field: str = ""
    combination: str = ""
    envelope: str = ""
    remark: str = ""
    minus: str = ""
    reference: str = ""

    @property
    def name(self) -> str:
        """The name under which the file is saved; that of a plan has the field."""
        difference = "-difference" if self.minus or self.reference else ""
        what = self.file.replace("plan", f"{self.field or 'plan'}{difference}")
        return f"{Path(self.case).stem}-{what}"


@dataclass(frozen=True, slots=True)
class Exported:
    """The content of a file, and what is said of it: what it does not hold, or in another way than the case does."""

    content: bytes
    notes: tuple[str, ...] = ()

    def to_bytes(self) -> bytes:
        """Return what ``from_bytes`` turns into an equal value."""
        return pickle.dumps((self.content, self.notes))

    @classmethod
    def from_bytes(cls, packed: bytes) -> Exported:
        """Return what was packed."""
        return cls(*pickle.loads(packed))


def export(
    results: Results, wanted: Wanted, text: str | None = None, comparison: GroundComparison | None = None
) -> Exported:
    """Return a file that is made of results; raises InputError.

    Text and comparison of grounds are those of the report.
    """
    from groundslab.views.summary.discretization import provisional_words

    with tempfile.TemporaryDirectory(prefix="groundslab-") as folder:
        path = Path(folder) / wanted.file
        if wanted.file == "report.pdf":
            from groundslab.views.report.html import write_report

            write_report(results, path, text=text, file=wanted.case, comparison=comparison, remark=wanted.remark)
            return Exported(path.read_bytes())
        notes = _WRITERS[path.stem](results, wanted, path)
        provisional = provisional_words(results)
        return limit_notes(path.read_bytes(), [*([provisional] if provisional else []), *notes])


def limit_notes(content: bytes, notes: Sequence[str]) -> Exported:
    """Return a file with as many notes as are passed on, and how many there are besides."""
    listed = [note if len(note) <= LONGEST else Label(f"{note[:LONGEST]} ...") for note in notes[:LISTED]]
    more = len(notes) - len(listed)
    return Exported(content, (*listed, Message("{count:,} more", count=more)) if more else tuple(listed))


def _write_tables(results: Results, _: Wanted, path: Path) -> Sequence[str]:
    """Write all tables as one workbook, or each as a CSV file into an archive."""
    if path.suffix == ".xlsx":
        from groundslab.views.files.xlsx import write_workbook

        write_workbook(results, path)
        return ()
    from groundslab.views.translation import translated_tables

    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for table in translated_tables(results):
            archive.writestr(f"{table.name}.csv", table.csv())
    return ()


def _write_plan(results: Results, wanted: Wanted, path: Path) -> Sequence[str]:
    """Draw a field in plan; fields of bars are over all combinations."""
    from groundslab.results.fields import BAR_FIELDS
    from groundslab.views import plots
    from groundslab.views.plots.panels import subtract
    from groundslab.views.plots.request import parse_request

    chosen = wanted.field not in BAR_FIELDS
    combination = wanted.combination if chosen and wanted.combination else None
    envelope = wanted.envelope if chosen and wanted.envelope else None
    fields = [wanted.field] if wanted.field else []
    request = parse_request(results, fields, "plan", combination, envelope, None)
    if wanted.minus or wanted.reference:
        request = subtract(request, _find_minus(results, wanted))
    plots.write(request, path)
    return ()


def write_difference(results: Results, wanted: Wanted) -> bytes:
    """Return the packed scene of the difference of results to those that are subtracted; raises InputError."""
    from groundslab.views.scene.binary import pack
    from groundslab.views.scene.difference import difference_of

    return pack(difference_of(results, _find_minus(results, wanted)))


def write_document(results: Results, name: str) -> bytes:
    """Return one of the documents for other programs."""
    from groundslab.views.interface.documents import DOCUMENTS, to_text

    return to_text(DOCUMENTS[name](results)).encode()


def write_proposal(results: Results, case: str, folder: Path) -> bytes:
    """Return the text of a case with bars that are proposed; relative names of files are those in a folder."""
    from groundslab.case.editing.reinforcement import with_reinforcement
    from groundslab.design.proposal import propose_bars

    return with_reinforcement(case, propose_bars(results).reinforcement, folder).encode()


def write_reference(results: Results, path: Path) -> bytes:
    """Write results into a file of this process and its successors, which takes a fraction of writing a folder."""
    with path.open("wb") as file:
        pickle.dump(results, file)
    return b""


def read_reference(path: Path) -> Results:
    """Return the results in a file that ``write_reference`` has written."""
    with path.open("rb") as file:
        results: Results = pickle.load(file)
    return results


def _find_minus(results: Results, wanted: Wanted) -> Subtracted:
    """Return what is subtracted from results."""
    from groundslab.views.difference import choose_subtracted

    other = read_reference(Path(wanted.reference)) if wanted.reference else results
    return choose_subtracted(other, wanted.minus or None)


def _write_bars(results: Results, _: Wanted, path: Path) -> Sequence[str]:
    """Draw or list the bars that are laid."""
    from groundslab.views.bars import left_out, write_bars

    write_bars(results, path)
    return left_out(results, path)


def _write_sheets(results: Results, _: Wanted, path: Path) -> Sequence[str]:
    """Draw the bars that are laid on sheets of the paper that the file is called after."""
    from groundslab.views.bars import write_bars
    from groundslab.views.drawing.sheets.paper import PAPERS

    paper = next(paper for paper in PAPERS if path.stem.endswith(paper))
    write_bars(results, path, paper=paper)
    return ()


def _write_saf(results: Results, _: Wanted, path: Path) -> Sequence[str]:
    """Write case and results in the Structural Analysis Format."""
    from groundslab.views.files.saf import write_saf

    return write_saf(results, path)


def _write_plate(results: Results, wanted: Wanted, path: Path) -> Sequence[str]:
    """Write the plate's fields in a combination, or else their envelopes over all of them."""
    from groundslab.views.files.vtk import write_envelope, write_plate

    if not wanted.combination:
        write_envelope(results, path)
        return ()
    if wanted.combination not in results.results:
        raise InputError([Issue("combination", describe(wanted.combination), "one that has results")])
    write_plate(results.results[wanted.combination], path)
    return ()


_WRITERS: dict[str, Callable[[Results, Wanted, Path], Sequence[str]]] = {
    "tables": _write_tables, "plan": _write_plan, "bars": _write_bars, "saf": _write_saf, "plate": _write_plate,
    "bars-a1": _write_sheets, "bars-a2": _write_sheets, "bars-a3": _write_sheets,
}  # fmt: skip
assert {name.partition(".")[0] for name in get_args(ExportName)} == {"report", *_WRITERS}
