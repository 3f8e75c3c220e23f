"""Which checks of the design are switched off, and why."""

from __future__ import annotations

from typing import Annotated

from groundslab.schema.base import Section
from groundslab.schema.fields import Text
from groundslab.schema.section_fields import Table


class CheckOff(Section):
    """A check that the engineer answers for in another way; every verdict counts and names it."""

    check: Annotated[
        str, Text("name of the check as results list it, or its first words: punching is all that begins so")
    ]
    of: Annotated[str, Text("what punches, the beam or the wall with a height; all of them by default")] = ""
    reason: Annotated[str, Text("why, as the report says it")]

    def covers(self, check: str, of: str) -> bool:
        """Return whether it switches off the check of a name of something."""
        words = self.check.casefold().split()
        return bool(words) and check.casefold().split()[: len(words)] == words and self.of in ("", of)


class Checks(Section):
    """Checks of the design that are switched off."""

    off: Annotated[tuple[CheckOff, ...], Table("checks that are switched off, each with its reason")] = ()
