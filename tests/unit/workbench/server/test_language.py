"""What the server says in the language of a page: no English sentence is left, and numbers and names are the same."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from contextvars import copy_context
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import pytest

from groundslab.case import casefile
from groundslab.languages import LANGUAGES, translator
from groundslab.messages import Label, Message, Name
from groundslab.results.records import Step
from groundslab.views.summary.progress import CombinationCount, line
from helpers import asgi
from helpers.combinations import few

pytest.importorskip("fastapi")
from groundslab.workbench.events import encode_event
from groundslab.workbench.saying import say, take_language
from unit.workbench.server.test_exports import GOOD, Bench

EXAMPLES = Path(__file__).parents[4] / "examples"
pytestmark = pytest.mark.slow

CASE = casefile.to_toml(few(casefile.load(EXAMPLES / "house_raft.toml")).replace(mesh={"size": 1.5}))
#: Words that tell English from the other languages.
ENGLISH = re.compile(r"\b(?:the|of|is|are|and|not|with|which|than|from|where)\b")
#: What the user has written, what programs read, and errors of the case file, which are English.
OTHERS = {
    "text", "data", "readable", "location", "path", "file", "plan", "status", "kind", "key", "symbol", "name",
}  # fmt: skip


@pytest.fixture(scope="module")
def bench(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Bench]:
    """A workbench with a case that has checks, beams, columns and strips, and is solved."""
    made = Bench(tmp_path_factory.mktemp("language"), CASE)
    made.wait()
    yield made
    made.session.close()


def ask(bench: Bench, path: str, language: str, method: str = "GET", body: Any = None) -> asgi.Answer:
    """Return what is answered in a language."""
    content = b"" if body is None else json.dumps(body).encode()
    more = [] if body is None else [("content-type", "application/json"), ("content-length", str(len(content)))]
    headers = [*GOOD, ("x-groundslab-language", language), *more]
    return asgi.ask(bench.app, method, f"/api/{path}", headers, content)


def texts_of(data: Any, key: str = "") -> Iterator[str]:
    """Yield the texts that people read in data."""
    if isinstance(data, dict):
        for name, value in data.items():
            if name not in OTHERS:
                yield from texts_of(value, name)
    elif isinstance(data, list):
        for value in data:
            yield from texts_of(value, key)
    elif isinstance(data, str):
        yield data


def numbers_of(text: str) -> list[str]:
    """Return the numbers in a text, with decimal points, in the order of their size."""
    return sorted(re.findall(r"\d+(?:\.\d+)?", re.sub(r"(?<=\d)[,](?=\d)", ".", text)))


def english_of(answers: Iterator[str]) -> list[str]:
    """Return the English sentences in texts."""
    return [text for text in dict.fromkeys(answers) if len(text.split()) > 2 and ENGLISH.search(text)]


def test_answers_have_no_english_sentence_and_the_same_numbers(bench: Bench) -> None:
    """Summary, state, tables and events are said in each language, their numbers and shape are those in English."""
    run = bench.wait()
    tables = ask(bench, f"results/{run}/tables", "en").json()
    paths = ["state", f"results/{run}/summary", *(f"results/{run}/tables/{name}" for name in tables)]
    for path in paths:
        english = ask(bench, path, "en").json()
        for language in LANGUAGES.keys() - {"en"}:
            said = ask(bench, path, language).json()
            assert english_of(texts_of(said)) == [], (path, language)
            for before, after in zip(texts_of(english), texts_of(said), strict=True):
                assert numbers_of(before) == numbers_of(after), (before, after)


def test_errors_and_steps_of_undo_are_said_in_the_language_of_the_page(bench: Bench) -> None:
    """What cannot be done, and what can be undone, has no English word; a version is still one for programs."""
    edit = {"op": "set", "path": ["plate", "thickness"], "value": "350 mm"}
    assert ask(bench, "edits", "de", "POST", {"edits": [edit]}).json()["undo_text"] == "Bearbeiten"
    assert ask(bench, "undo", "fr", "POST", {}).json()["redo_text"] == "Modifier"
    wrong = [
        ("GET", "results/99/summary", None),
        ("POST", "open", {"file": "x.toml"}),
        ("POST", "save", {"file": "x.y"}),
        ("POST", "open", {"file": "a\0"}),
        ("GET", "drawing?file=x.ifc", None),
        ("GET", "slabs?file=x.dxf", None),
    ]
    for method, path, body in wrong:
        english, said = (ask(bench, path, language, method, body).json()["error"] for language in ("en", "de"))
        assert english_of(texts_of(said)) == [], path
        assert [*texts_of(english)] != [*texts_of(said)], path


def test_the_notes_on_a_file_are_said_in_the_language_of_the_page(bench: Bench) -> None:
    """They are sent in a header, each as a text."""
    run = bench.wait()
    english, german = (
        json.loads(unquote(ask(bench, f"results/{run}/exports/saf.xlsx", language).headers["x-groundslab-notes"]))
        for language in ("en", "de")
    )
    assert len(english) == len(german) > 0


def test_events_are_said_in_the_language_of_a_stream() -> None:
    """A stream names its language in its address, as it has no headers; names stay as they are."""
    scope = asgi.scope_of("GET", "/api/events?token=x&language=de", GOOD)
    copy_context().run(take_language, scope)
    data = {"text": Message("mesh {number}", number=2), "name": Name("begins"), "details": Label("begins")}
    assert encode_event(("progress", data), translator("de")).decode() == (
        'event: progress\ndata: {"text": "Netz 2", "name": "begins", "details": "beginnt"}\n\n'
    )
    step = Step(120, 2, 0.5, 3, 40, 4, True)
    count = CombinationCount(5, lambda: 0.0, mesh=1)
    count.begin("B")
    for told in (count.describe(step), count.words() + line(step)):
        assert english_of(iter([say(told, translator("de"))])) == []
