"""Secrets that are valid once."""

from __future__ import annotations

import secrets


class Tickets:
    """Secrets that are valid once, for addresses that other users of the machine may see."""

    def __init__(self) -> None:
        self._valid: set[str] = set()

    def issue(self) -> str:
        """Return a new ticket."""
        ticket = secrets.token_urlsafe(32)
        self._valid.add(ticket)
        return ticket

    def redeem(self, ticket: str) -> bool:
        """Invalidate a ticket and return whether it was valid."""
        try:
            self._valid.remove(ticket)
        except KeyError:
            return False
        return True
