"""The report on paper: the same value as the page, typeset by Typst into an archivable, accessible PDF."""

from __future__ import annotations

import importlib.util
import json
import re
from dataclasses import fields
from functools import cache
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from groundslab.messages import Message
from groundslab.views.plots.style import PAGE_COLORS
from groundslab.views.report.calculations import Sheet
from groundslab.views.report.document import CHECK_HEADS, Bullets, Columns, Figures, Paragraph, Part
from groundslab.views.report.formulas import set_formula
from groundslab.views.report.sentences import raised, set_sentence, with_powers, written_out
from groundslab.views.report.table_layout import TableLayout, drop_empty_columns, split_symbol, split_words

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from groundslab.languages import Language, Translator
    from groundslab.views.report.calculations import Line
    from groundslab.views.report.document import Block, CheckLine, Report
    from groundslab.views.report.drawings.drawings import Drawing
    from groundslab.views.report.table_layout import Cell, TableHeader

HERE = Path(__file__).parent
#: What every PDF keeps to: reading aloud and by keys (PDF/UA-1), and archives (PDF/A-2a).
STANDARDS: tuple[Literal["ua-1", "a-2a"], ...] = ("ua-1", "a-2a")
#: Colors of pages on paper, by their names.
COLORS = {name: color for color, name in PAGE_COLORS.items() if color != "#000000"}
#: Where a line may end within a word: after an underscore, and anywhere in what no line, or no column, has space for.
BREAK = "\N{ZERO WIDTH SPACE}"
_NO_LINE, _NO_COLUMN = re.compile(r"\S{80,}"), re.compile(r"\S{25,}")
#: What Typst calls sizes of paper.
PAPERS = {"A4": "a4", "letter": "us-letter"}
#: Where letters stand that the fonts of the report lack, such as Hebrew and Arabic.
_MORE_FONTS = Path("mpl-data", "fonts", "ttf")


def typeset(
    report: Report, language: Language, translate: Translator, mark: str, remark: str = "", paper: str = "A4"
) -> bytes:
    """Return a report as PDF; the same report always gives the same bytes."""
    import typst

    writer = _Writer(language, translate)
    content = writer.of_report(report, mark, remark) | {"paper": PAPERS[paper]}
    data = json.dumps(content, ensure_ascii=False)
    template = (HERE / "templates" / "report.typ").read_bytes()
    # the package's annotations lack several files
    files: Any = {"main.typ": template, "report.json": data.encode(), **writer.drawings}
    pdf: bytes = typst.compile(files, font_paths=report_fonts(), pdf_standards=list(STANDARDS))
    return pdf


@cache
def report_fonts() -> Any:
    """Return the fonts of the report: its own, those that Typst brings for formulas, and Matplotlib's for all else."""
    import typst

    matplotlib = importlib.util.find_spec("matplotlib")
    more = [] if matplotlib is None or matplotlib.origin is None else [Path(matplotlib.origin).parent / _MORE_FONTS]
    return typst.Fonts(include_system_fonts=False, font_paths=[HERE / "fonts", *more])


class _Writer:
    """Writes the parts of a report as the template reads them, in a language; it keeps the drawings."""

    def __init__(self, language: Language, translate: Translator) -> None:
        self.language = language
        self.say = translate
        self.drawings: dict[str, bytes] = {}
        self._shared: dict[str, str] = {}

    def of_report(self, report: Report, mark: str, remark: str) -> dict[str, Any]:
        """Return all of a report; what the screen alone has is left out."""
        say = self.say
        left, right, digest = report.heading
        facts = [(say(name), _breakable(say(value))) for name, value in (*report.project, *report.facts)]
        chapters = [chapter for chapter in report.chapters if chapter.name != "viewer"]
        return {
            "language": self.language,
            "mark": mark,
            "title": _breakable(report.title) or say("(no title)"),
            "file": report.file,
            "head": [" ".join(left.split()), " ".join(right.split())],
            "foot": f"groundslab {report.version}, {say('SHA-256 of the input')} {digest}",
            "facts": facts,
            "remark": self._sentence(remark),
            "design": [report.design[0], self._sentence(report.design[1])],
            "unchecked": self._sentence(report.unchecked),
            "analysis": [report.analysis[0], self._sentence(report.analysis[1])],
            "heads": [say(head) for head in CHECK_HEADS],
            "checks": [self._of_check(check) for check in report.checks],
            "refused": f"{say('Why: see')} {say('combinations without results')}." if "refused" in report.names else "",
            "appendix": say("Appendix"),
            "chapters": [
                {
                    "title": say(chapter.title),
                    "appendix": chapter.in_appendix,
                    "blocks": self._of_blocks(chapter.blocks),
                }
                for chapter in chapters
            ],
        }

    def _of_check(self, check: CheckLine) -> dict[str, Any]:
        """Return a line of the first page."""
        texts = {field.name: self.say(getattr(check, field.name)) for field in fields(check)}
        words = self._sentence(check.words)
        return texts | {
            "demand": with_powers(texts["demand"]), "limit": with_powers(texts["limit"]), "words": words,
            "verdict": check.verdict,
        }  # fmt: skip

    def _sentence(self, text: str) -> list[tuple[str, str]]:
        """Return words as pairs of what stands on the line and what below it."""
        return [(_breakable(words), below) for words, below in set_sentence(text, self.say)]

    def _of_blocks(self, blocks: Iterable[Block]) -> list[dict[str, Any]]:
        """Return those blocks that stand on paper."""
        return [written for block in blocks for written in self._of_block(block)]

    def _of_block(self, block: Block) -> Iterator[dict[str, Any]]:
        """Yield a block as the template reads it, if it stands on paper."""
        match block:
            case Paragraph(text, kind):
                yield {"block": "paragraph", "text": self._sentence(text), "kind": kind}
            case Bullets(texts):
                yield {"block": "bullets", "texts": [self._sentence(text) for text in texts]}
            case Figures(drawings, columns) if drawings:
                yield {
                    "block": "figures",
                    "columns": columns,
                    "figures": [self._of_drawing(drawing) for drawing in drawings],
                }
            case TableLayout(rows=()):
                yield from self._of_blocks((Paragraph("Nothing to list."), *map(Paragraph, block.notes)))
            case TableLayout():
                yield self._of_table(block)
            case Sheet():
                yield self._of_sheet(block)
            case Columns(parts, beside):
                yield {"block": "columns", "beside": beside, "parts": self._of_blocks(parts)}
            case Part(on_paper=True):
                title, blocks = _breakable(self.say(block.title)), self._of_blocks(block.blocks)
                yield {"block": "part", "title": title, "level": block.level, "keep": block.keep, "blocks": blocks}

    def _of_drawing(self, drawing: Drawing) -> dict[str, Any]:
        """Return the name of a drawing's file, and its caption."""
        name = f"{len(self.drawings)}.svg"
        self._shared |= {part[1]: part[0] for part in _SHARED.finditer(drawing.svg)}
        svg, label = standalone(_USED.sub(lambda use: self._shared.get(use[1], use[0]), drawing.svg))
        self.drawings[name] = svg
        return {"file": name, "label": label, "caption": self._sentence(drawing.caption)}

    def _of_table(self, table: TableLayout) -> dict[str, Any]:
        """Return a table without empty columns; each cell is its text, its kind and what stands small below it."""
        table = drop_empty_columns(table)
        return {
            "block": "table",
            "heads": [self._of_head(head) for head in table.heads],
            "rows": [[self._of_cell(cell) for cell in row] for row in table.rows],
            "notes": [self._sentence(note) for note in table.notes],
        }

    def _of_head(self, head: TableHeader) -> dict[str, Any]:
        """Return what stands above a column."""
        words = head.text if head.plain else split_words(self.say(head.text))
        return {"words": words, "symbol": split_symbol(head.symbol), "unit": raised(head.unit), "number": head.number}

    def _of_cell(self, cell: Cell) -> Any:
        """Return a cell, a plain text as it is."""
        match cell.kind:
            case "symbol":
                text: Any = split_symbol(cell.text)
            case "words":
                text = split_words(self.say(cell.text))
            case "number":
                text = written_out(self.say(cell.text))
            case _ if isinstance(cell.text, Message):
                text = self._sentence(cell.text)
            case _:
                text = _breakable(self.say(cell.text), _NO_COLUMN).replace("_", f"_{BREAK}")
        return [text, cell.kind, self.say(cell.under)] if cell.kind or cell.under or not isinstance(text, str) else text

    def _of_sheet(self, sheet: Sheet) -> dict[str, Any]:
        """Return a calculation, with the sketch of a perimeter if it has one."""
        sketch = None if sheet.sketch is None else self._of_drawing(sheet.sketch)
        pieces = [self._of_table(table) | {"title": self.say(table.title)} for table in sheet.pieces]
        return {
            "block": "sheet", "title": _breakable(self.say(sheet.title)), "sketch": sketch, "pieces": pieces,
            "groups": [
                list(map(self._of_line, lines)) for _, lines in groupby(sheet.lines, lambda line: bool(line.formula))
            ],
        }  # fmt: skip

    def _of_line(self, line: Line) -> dict[str, Any]:
        """Return a line of a calculation, its formulas as Typst sets them."""
        point = "." if self.language == "en" else ","
        numbers = line.numbers if line.numbers != line.formula else ""
        return {
            "quantity": split_words(self.say(line.quantity)),
            "symbol": [set_formula(line.symbol), line.symbol],
            "formula": [set_formula(line.formula), line.formula] if line.formula else None,
            "numbers": [set_formula(numbers, point), numbers] if numbers else None,
            "value": [set_formula(line.value, point), line.value],
            "unit": raised(line.unit),
            "other": [self.say(line.other_value), raised(line.other_unit)] if line.other_unit else None,
            "clause": line.clause.replace("Table", self.say("Table")),
        }


#: A part of a drawing that later drawings refer to, and where they do.
_SHARED = re.compile(r'<g id="([\w-]+)"><svg .*?</svg></g>', re.DOTALL)
_USED = re.compile(r'<use href="#([\w-]+)"/>')


def _breakable(text: str, long: re.Pattern[str] = _NO_LINE) -> str:
    """Return a text in which what is too long without a space may be broken at each letter."""
    return long.sub(lambda run: BREAK.join(run[0]), text)


def standalone(svg: str) -> tuple[bytes, str]:
    """Return a drawing of the page as a file of its own, in the colors of paper, and what it shows in words."""
    from html import unescape

    label = re.search(r'aria-label="([^"]*)"', svg)
    markup = str(svg).replace("<svg ", '<svg xmlns="http://www.w3.org/2000/svg" font-family="Inter" font-size="11" ', 1)
    painted = re.sub(r"var\((--[\w-]+)\)", lambda match: COLORS[match[1]], markup)
    return painted.encode(), unescape(label[1]) if label else ""
