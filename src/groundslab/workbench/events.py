"""What pages are told as it happens: server-sent events, the same for every page that listens."""

from __future__ import annotations

import asyncio
import json
import threading
from collections.abc import AsyncIterator, Callable, Sequence
from contextlib import suppress
from typing import Any

#: A line to show that the server is there, after so long a silence [s].
PULSE = 15.0
#: A page that is so many events behind is let go; it connects again and is told how things stand.
MOST_WAITING = 1000

Event = tuple[str, dict[str, Any]]


class Hub:
    """Hands events on to all that listen; may be told of them on any thread."""

    def __init__(self) -> None:
        self._lock = threading.RLock()  # a signal may close the hub while the same thread is at it
        self._listeners: dict[asyncio.Queue[Event | None], asyncio.AbstractEventLoop] = {}
        self._closed = False

    def tell(self, name: str, about: dict[str, Any]) -> None:
        """Hand an event on."""
        self._send((name, about))

    def close(self) -> None:
        """Let all go that listen, and whoever comes later."""
        with self._lock:
            self._closed = True
        self._send(None)

    def _send(self, event: Event | None) -> None:
        with self._lock:
            for queue, loop in list(self._listeners.items()):
                with suppress(RuntimeError):  # of a loop that has ended
                    loop.call_soon_threadsafe(self._put, queue, event)

    def _put(self, queue: asyncio.Queue[Event | None], event: Event | None) -> None:
        if queue.qsize() >= MOST_WAITING and event is not None:
            with self._lock:
                self._listeners.pop(queue, None)
            event = None
        queue.put_nowait(event)

    async def listen(self, present: Callable[[], Sequence[Event]], pulse: float = PULSE) -> AsyncIterator[bytes]:
        """Yield the stream for one page: how things stand, then every event, until all are let go."""
        queue: asyncio.Queue[Event | None] = asyncio.Queue()
        with self._lock:
            if self._closed:
                return
            self._listeners[queue] = asyncio.get_running_loop()
        try:
            # listening has begun, so that nothing is missed; what is told twice does no harm
            for event in await asyncio.to_thread(present):
                yield written(event)
            while True:
                try:
                    told = await asyncio.wait_for(queue.get(), pulse)
                except TimeoutError:
                    yield b": here\n\n"
                    continue
                if told is None:
                    return
                yield written(told)
        finally:
            with self._lock:
                self._listeners.pop(queue, None)


def written(event: Event) -> bytes:
    """Return an event as it is sent."""
    name, about = event
    return f"event: {name}\ndata: {json.dumps(about)}\n\n".encode()
