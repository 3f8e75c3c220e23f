"""What the server says to a page: messages become texts in the language of a request just before they are sent.

A page names its language in a header, or in the address of a stream, which has no headers of its own. Without any it is
English. Messages, labels and clauses change; all other texts are names, values of the case or words that a page knows.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextvars import ContextVar
from typing import Any, get_args
from urllib.parse import parse_qs

from fastapi.responses import JSONResponse
from fastapi.routing import APIRoute
from starlette.datastructures import Headers
from starlette.types import Scope

from groundslab.languages import Language, Translator, translator
from groundslab.messages import Clause, Label, Message

#: Where a request names its language.
HEADER, QUERY = "x-groundslab-language", "language"
_language: ContextVar[Language] = ContextVar("language", default="en")


def take_language(scope: Scope) -> None:
    """Let what is said from now on in answer to a request be in its language."""
    named = Headers(scope=scope).get(HEADER) or _named_in_query(scope)
    _language.set(next((language for language in get_args(Language) if language == named), "en"))


def _named_in_query(scope: Scope) -> str:
    try:
        query = parse_qs(scope["query_string"].decode("latin-1"), max_num_fields=20)
    except ValueError:
        return ""
    return str(query.get(QUERY, [""])[-1])


def present_translator() -> Translator:
    """Return what writes messages in the language of the present request."""
    return translator(_language.get())


def say(data: Any, translate: Translator) -> Any:
    """Return data for JSON with its messages, labels and clauses in a language."""
    if translate is str:
        return data
    if isinstance(data, str):
        return translate(data) if isinstance(data, Message | Label | Clause) else data
    if isinstance(data, Mapping):
        return {key: say(value, translate) for key, value in data.items()}
    return [say(item, translate) for item in data] if isinstance(data, list | tuple) else data


def say_refusals(scene: bytes, refused: Mapping[str, str]) -> bytes:
    """Return a packed scene that says in the language of the request why combinations are refused."""
    translate = present_translator()
    if translate is str or not refused:
        return scene
    from groundslab.views.scene.binary import with_head

    def change(head: dict[str, Any]) -> None:
        for combination in head["combinations"]:
            if combination["refused"] is not None:
                combination["refused"] = translate(refused[combination["name"]])

    return with_head(scene, change)


class Answer(JSONResponse):
    """Data for a page, in its language."""

    def render(self, content: Any) -> bytes:
        """Return the body."""
        return super().render(say(content, present_translator()))


class Route(APIRoute):
    """A route whose answer is sent as it was made: as data of a type its messages would be mere texts."""

    def __init__(self, path: str, endpoint: Any, **options: Any) -> None:
        super().__init__(path, endpoint, **options | {"response_model": None})
