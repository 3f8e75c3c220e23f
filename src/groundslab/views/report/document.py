"""What a report is made of: one value of chapters and blocks that the page and the paper both read."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, Literal, TypeAlias

if TYPE_CHECKING:
    from groundslab.model.outputs import Chapter
    from groundslab.views.report.calculations import Sheet
    from groundslab.views.report.drawings.drawings import Drawing
    from groundslab.views.report.table_layout import TableLayout

Verdict = Literal["good", "doubtful", "bad"]


@dataclass(frozen=True, slots=True)
class Paragraph:
    """Some sentences, and whether they are an aside, an error or a plain text."""

    text: str
    kind: Literal["note", "bad", "bad reason", "contents"] = "note"
    block: ClassVar = "paragraph"


@dataclass(frozen=True, slots=True)
class Bullets:
    """A list of sentences."""

    texts: tuple[str, ...]
    block: ClassVar = "bullets"


@dataclass(frozen=True, slots=True)
class Figures:
    """Drawings beside each other on paper in some columns; on the page as many as there is space for, if several."""

    drawings: tuple[Drawing, ...]
    columns: int = 1
    block: ClassVar = "figures"


@dataclass(frozen=True, slots=True)
class Part:
    """Blocks under a heading of their own, kept together if they are short; some for the screen alone."""

    title: str
    blocks: tuple[Block, ...]
    name: str = ""
    keep: bool = False
    on_paper: bool = True
    level: Literal[3, 4] = 3
    block: ClassVar = "part"


@dataclass(frozen=True, slots=True)
class Columns:
    """Parts in two columns on paper, one below the other there, or beside each other as they are short."""

    parts: tuple[Part, ...]
    beside: bool = False
    block: ClassVar = "columns"


@dataclass(frozen=True, slots=True)
class SourceText:
    """The text of the case, which the screen alone has."""

    file: str
    text: str
    block: ClassVar = "source"


@dataclass(frozen=True, slots=True)
class Viewer:
    """Where the screen has the fields of all combinations."""

    block: ClassVar = "viewer"


Block: TypeAlias = "Paragraph | Bullets | Figures | TableLayout | Sheet | Part | Columns | SourceText | Viewer"


#: What stands above the checks of the first page.
CHECK_HEADS = ("Check", "Demand", "Limit", "Used", "Where and why", "")


@dataclass(frozen=True, slots=True)
class CheckLine:
    """A design check as the first page has it, every number a text; what is under one stands small below it."""

    name: str
    demand: str
    demand_error: str
    limit: str
    used: str
    between: str
    words: str
    status: str
    within: str  # that the verdict hangs on the error, if it does
    verdict: Verdict


@dataclass(frozen=True, slots=True)
class ChapterOfReport:
    """A chapter by its name, or what is said where combinations have no results."""

    name: Chapter | Literal["refused"]
    title: str
    blocks: tuple[Block, ...]
    in_appendix: bool = False


@dataclass(frozen=True, slots=True)
class Report:
    """The whole report: its title block, verdicts and checks on the first page, and the chapters."""

    title: str
    project: tuple[tuple[str, str], ...]
    version: str
    file: str
    sha256: str
    facts: tuple[tuple[str, str], ...]
    design: tuple[Verdict | Literal[""], str]  # how the design is, and that in words
    unchecked: str  # what no check looks at, if these words do not say so
    checks: tuple[CheckLine, ...]
    analysis: tuple[Verdict, str]  # how good the results of all combinations are, and that in words
    chapters: tuple[ChapterOfReport, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """Return the names of the chapters."""
        return tuple(chapter.name for chapter in self.chapters)

    @property
    def heading(self) -> tuple[str, str, str]:
        """Return what stands at the head of each printed page, left and right, and the first part of the hash."""
        about = dict(self.project)
        right = ", ".join(about[name] for name in ("Number", "Part", "Revision") if name in about)
        return self.title, right, self.sha256[:12]
