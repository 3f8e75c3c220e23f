"""The report as one HTML file: page, pictures, scene and script put together, written completely or not at all.

The page forbids everything that it does not bring along: scripts and styles run only with the hashes that its head
states, and nothing is fetched. Every text of a case is escaped by the template.
"""

from __future__ import annotations

import base64
import gzip
import hashlib
import json
import os
import re
from functools import cache, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab._version import __version__
from groundslab.errors import GroundslabError
from groundslab.languages import page_messages
from groundslab.results.results import CombinationResult, Results, results_of
from groundslab.storage import checksums
from groundslab.storage.ownership import check_replaceable, is_page
from groundslab.views.plots.export import write_file
from groundslab.views.report.calculations import split_formula, split_with_commas
from groundslab.views.report.content import build_report
from groundslab.views.report.document import CHECK_HEADS
from groundslab.views.report.table_layout import split_symbol, split_words
from groundslab.views.scene.binary import pack
from groundslab.views.scene.fields import scene_of
from groundslab.views.translation import translator_of

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from jinja2 import Environment

    from groundslab.analysis.ground_comparison.comparison import GroundComparison
    from groundslab.languages import Language, Translator
    from groundslab.model.outputs import Chapter, Length
    from groundslab.views.report.document import Report

HERE = Path(__file__).parent
#: What the head of every report says of itself, so that an older one can be recognized.
MARK = "groundslab report"
#: The viewer's data may take so many letters of the file; fields beyond that are left out, those of one combination
#: apart.
MOST_DATA = 15_000_000
#: Letters of scripts that run to the left: Hebrew, Arabic and others.
_TO_LEFT = "[\u0590-\u08ff\ufb1d-\ufdff\ufe70-\ufefc\U00010800-\U00010fff\U0001e800-\U0001efff]"
#: Words of such letters, with what is between them but digits.
_LEFTWARDS = re.compile(rf"{_TO_LEFT}(?:[ .,/()'-]*{_TO_LEFT})*")
#: Letters that control a terminal or a browser, which no page may hold.
_CONTROL = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]")


def render_report(
    results: CombinationResult | Results,
    *,
    text: str | None = None,
    file: str = "case.toml",
    chapters: Sequence[Chapter] | None = None,
    comparison: GroundComparison | None = None,
    remark: str = "",
    length: Length | None = None,
    told: Callable[[str, float], None] = lambda _, __: None,
) -> str:
    """Return the report as the text of an HTML file; the same results always give the same text.

    Text and file are those of the input; without them the text is that which the results' folder has as case.toml. The
    first page has the remark, such as that the case has changed since. `told` is called before each chapter with its
    title and the share that is made.
    """
    combined = results_of(results)
    from markupsafe import Markup

    page = build_report(
        combined, text, file, chapters, comparison, told, length or combined.model.report.length or "full"
    )
    scene, head = _scene(combined) if "viewer" in page.names else ("", {})
    language = combined.model.language
    messages = _viewer_messages(language, head) if head and language != "en" else ""
    style = read_asset("report.css") + (HERE / "templates" / "page.css").read_text(encoding="utf-8")
    style += _page_heads(page, translator_of(combined))
    script = read_asset("report.js")
    return render_page(
        HERE / "templates" / "report.html",
        translator_of(combined),
        language,
        page=page,
        check_heads=CHECK_HEADS,
        remark=remark,
        left_out=head.get("left_out", []),
        scene=scene,
        messages=Markup(messages),
        style=Markup(style),
        script=Markup(script),
        policy=content_security_policy(style, script),
        mark=f"{MARK} {__version__}",
    )


def write_report(
    results: CombinationResult | Results,
    path: str | Path,
    *,
    text: str | None = None,
    file: str = "case.toml",
    chapters: Sequence[Chapter] | None = None,
    comparison: GroundComparison | None = None,
    remark: str = "",
    length: Length | None = None,
) -> Path:
    """Write the report of results: one HTML file that needs no network, or a PDF for print and archive.

    Parameters
    ----------
    results : CombinationResult or Results
        Results of one or of several combinations.
    path : str or Path
        File to write, a PDF if its name ends with .pdf; an existing file is replaced only if it is such a report.
    text, file : str, optional
        Text of the case file, which the report quotes, and its name; without a text, the model is written out.
    chapters : sequence of str, optional
        The chapters beside the first page; by default those of ``report.chapters`` of the case.
    comparison : GroundComparison, optional
        A comparison of grounds of the same model, which is a chapter then.
    remark : str, optional
        What the first page says besides, such as that the case has changed since.
    length : {"short", "full"}, optional
        How much of all that was computed it holds; by default ``report.length`` of the case, else short on paper and
        full on the page.

    Returns
    -------
    Path
        The path of the report.

    Raises
    ------
    InputError
        If the file cannot be written, or is no report.
    GroundslabError
        If a result is not finite, or this installation lacks the report's script.

    Notes
    -----
    The same results give the same bytes. A PDF has no viewer.

    Examples
    --------
    >>> import groundslab
    >>> results = groundslab.solve(groundslab.load("case.toml"))
    >>> path = groundslab.write_report(results, "report.html")
    """
    target = check(path)
    about: dict[str, Any] = {"text": text, "file": file, "chapters": chapters, "comparison": comparison}
    if _is_pdf(target):
        write_file(target, target, _typeset(results_of(results), **about, remark=remark, length=length))
    else:
        _write_page(target, render_report(results, **about, remark=remark, length=length))
    return Path(path)


def _typeset(combined: Results, *, remark: str, length: Length | None, **about: Any) -> bytes:
    """Return the report as PDF, short unless the case or the caller asks for all."""
    from groundslab.views.report.pdf import typeset

    model = combined.model
    report = build_report(combined, **about, length=length or model.report.length or "short")
    paper = model.report.paper or ("letter" if model.units == "US" else "A4")
    return typeset(report, model.language, translator_of(combined), f"{MARK} {__version__}", remark, paper)


def _write_page(target: Path, page: str) -> None:
    """Write a page with its checksum; one that was edited is kept under another name."""
    checksums.keep_file(target, checksums.is_sealed)
    write_file(target, target, checksums.seal(page.encode()))


def _is_pdf(path: Path) -> bool:
    """Return whether a file's name says that it is a PDF."""
    return path.suffix.lower() == ".pdf"


def check(path: str | Path) -> Path:
    """Return the full path if a report can be written there; else raise InputError saying why not."""
    is_ours = _is_printed_report if _is_pdf(Path(path)) else partial(is_page, what="report")
    return check_replaceable(path, is_ours, "a report of groundslab")


def _is_printed_report(path: Path) -> bool:
    """Return whether a file is a report that groundslab wrote as PDF, as its metadata or its end says."""
    content = path.read_bytes()
    return content.startswith(b"%PDF-") and f"{MARK} ".encode() in content


def default_path(folder: str | Path, suffix: str = ".html") -> Path:
    """Return where the report of a folder of results is put: beside the folder, under its name."""
    whole = Path(os.path.realpath(folder))
    return whole.with_name(f"{whole.name}{suffix}")


def read_asset(name: str) -> str:
    """Return a part of the page that is made of TypeScript and CSS before groundslab is packed."""
    try:
        content = (HERE / "static" / name).read_text(encoding="utf-8")
    except OSError:
        raise GroundslabError(
            f"{name}, a part of every report, is missing from this installation; reinstall groundslab, or build it "
            "from its source: npm ci and npm run build in the folder web"
        ) from None
    # such texts would end the element that they stand in, or would not be read as they are written
    if re.search(r"</(script|style)|<!--|[\x00-\x08\x0b-\x1f]", content, re.IGNORECASE):
        raise GroundslabError(f"{name} holds a text that would break the page")
    return content


def _scene(combined: Results) -> tuple[str, Mapping[str, Any]]:
    """Return the scene as text and its head; as few combinations as exceed the size have no fields in it."""
    translate = translator_of(combined)
    most = len(combined.combinations)
    while True:
        scene = scene_of(combined, most)
        for combination in scene.head["combinations"]:
            if combination["refused"] is not None:
                combination["refused"] = translate(combination["refused"])
        text = base64.b64encode(gzip.compress(pack(scene), 6, mtime=0)).decode()
        if len(text) <= MOST_DATA or most <= 1:
            return text, scene.head
        # how well data can be compressed is known only now
        most = max(1, min(most - 1, most * MOST_DATA // len(text)))


def _viewer_messages(language: Language, head: Mapping[str, Any]) -> str:
    """Return the messages of the viewer in a language as JSON: its own, and those in the head of the scene."""
    fields = (field["meaning"] for field in head["fields"])
    combinations = (combination["name"] for combination in head["combinations"])
    wanted = {*json.loads(read_asset("messages.json")), *fields, *combinations}
    # no text ends the element that it stands in
    return json.dumps(page_messages(language, wanted), ensure_ascii=False).replace("<", "\\u003c")


def content_security_policy(style: str, script: str) -> str:
    """Return the page's Content Security Policy: its own style and script, pictures within it, and nothing else."""
    return (
        f"default-src 'none'; script-src '{_hash(script)}'; style-src '{_hash(style)}'; img-src data: blob:; "
        "base-uri 'none'; form-action 'none'"
    )


def _page_heads(page: Report, translate: Translator) -> str:
    """Return the style that prints title, project and revision at the head of each page, and the program at its foot.

    Letters that could end a string of a style stand there by their numbers.
    """
    left, right, digest = page.heading
    heads = {
        "top-left": left,
        "top-right": right,
        "bottom-left": f"groundslab {page.version}, {translate('SHA-256 of the input')} {digest}",
    }
    boxes = "".join(
        f'@{place} {{ content: "{re.sub(r"[^A-Za-z0-9 ,.]", lambda match: f"{chr(92)}{ord(match[0]):x} ", text)}"; '
        "font: 9px sans-serif; }\n"
        for place, text in heads.items()
    )
    return f"@page {{\n{boxes}}}\n"


def _hash(content: str) -> str:
    """Return the hash of an element's text as a policy states it."""
    return f"sha256-{base64.b64encode(hashlib.sha256(content.encode()).digest()).decode()}"


def _isolate(value: object) -> object:
    """Return a text whose words that run to the left are isolated, so that numbers beside them keep their place."""
    if not isinstance(value, str) or value.isascii() or not _LEFTWARDS.search(value):
        return value
    from markupsafe import Markup, escape

    if isinstance(value, Markup):
        return value
    return Markup(_LEFTWARDS.sub(r"<bdi>\g<0></bdi>", str(escape(value))))


def render_page(template: Path, translate: Translator = str, language: Language = "en", **values: Any) -> str:
    """Return a page of a template, which may use those here: values are escaped, a missing one is an error.

    What a template marks is translated, by `_` and the filter `tr`.
    """
    page = _environment(template.parent).get_template(template.name)
    return _CONTROL.sub("\ufffd", page.render(values, _=translate, language=language))


@cache
def _environment(folder: Path) -> Environment:
    """Return what makes pages of the templates of a folder, each of which is compiled once."""
    from jinja2 import Environment, FileSystemLoader, StrictUndefined, pass_context

    environment = Environment(
        loader=FileSystemLoader([folder, HERE / "templates"]),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        finalize=_isolate,
    )

    def formula_pieces(page: Mapping[str, Any], text: str) -> Any:
        return (split_formula if page["language"] == "en" else split_with_commas)(text)

    environment.filters |= {
        "tr": pass_context(lambda page, text: page["_"](str(text))),
        "pieces": split_symbol,
        "word_pieces": split_words,
        "formula_pieces": pass_context(formula_pieces),
    }
    return environment
