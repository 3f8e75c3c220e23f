"""How many examples tests try that draw them."""

from __future__ import annotations

import os

#: Every run tries one of so many examples: they are the same each time, so that more of them tell more only of changes.
ONE_OF = 5


def examples(count: int) -> int:
    """Return how many examples to try: a fifth, times GROUNDSLAB_EXAMPLES, which `make test-random` sets."""
    return max(1, round(count * int(os.environ.get("GROUNDSLAB_EXAMPLES", "1")) / ONE_OF))
