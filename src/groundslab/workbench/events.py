"""Server-sent events, the same for every page that listens."""

from __future__ import annotations

import asyncio
import json
import threading
from collections.abc import AsyncIterator, Callable, Sequence
from contextlib import suppress
from typing import Any

from groundslab.languages import Translator
from groundslab.workbench.saying import say

#: A comment shows that the server is alive after so long without an event [s].
KEEP_ALIVE = 15.0
#: A page that is so many events behind is disconnected; it connects again and receives the present state.
MAX_QUEUE = 1000

Event = tuple[str, dict[str, Any]]


class Hub:
    """Sends events from any thread to all pages that listen."""

    def __init__(self) -> None:
        self._lock = threading.RLock()  # a signal handler may close the hub while its thread holds the lock
        self._listeners: dict[asyncio.Queue[Event | None], asyncio.AbstractEventLoop] = {}
        self._closed = False

    def publish(self, name: str, data: dict[str, Any]) -> None:
        """Send an event to all pages."""
        self._send((name, data))

    def close(self) -> None:
        """Disconnect all pages, and those that connect later."""
        with self._lock:
            self._closed = True
        self._send(None)

    def _send(self, event: Event | None) -> None:
        with self._lock:
            for queue, loop in list(self._listeners.items()):
                with suppress(RuntimeError):  # of a loop that has ended
                    loop.call_soon_threadsafe(self._put, queue, event)

    def _put(self, queue: asyncio.Queue[Event | None], event: Event | None) -> None:
        if queue.qsize() >= MAX_QUEUE and event is not None:
            with self._lock:
                self._listeners.pop(queue, None)
            event = None
        queue.put_nowait(event)

    async def listen(
        self,
        get_current_events: Callable[[], Sequence[Event]],
        translate: Translator = str,
        keep_alive: float = KEEP_ALIVE,
    ) -> AsyncIterator[bytes]:
        """Yield the stream for one page: the present state, then every event until the page is disconnected.

        Messages are written in its language.
        """
        queue: asyncio.Queue[Event | None] = asyncio.Queue()
        with self._lock:
            if self._closed:
                return
            self._listeners[queue] = asyncio.get_running_loop()
        try:
            # events since the registration may be sent twice, which does no harm
            for event in await asyncio.to_thread(get_current_events):
                yield encode_event(event, translate)
            while True:
                try:
                    received = await asyncio.wait_for(queue.get(), keep_alive)
                except TimeoutError:
                    yield b": here\n\n"
                    continue
                if received is None:
                    return
                yield encode_event(received, translate)
        finally:
            with self._lock:
                self._listeners.pop(queue, None)


def encode_event(event: Event, translate: Translator = str) -> bytes:
    """Return an event in the format of server-sent events, its messages in a language."""
    name, data = event
    return f"event: {name}\ndata: {json.dumps(say(data, translate))}\n\n".encode()
