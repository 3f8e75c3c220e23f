"""How many examples tests try that draw them."""

from __future__ import annotations

import os


def examples(count: int) -> int:
    """Return how many examples to try: so many, times GROUNDSLAB_EXAMPLES if that is set.

    They are the same in every run, so that more of them tell more only after a change.
    """
    return count * int(os.environ.get("GROUNDSLAB_EXAMPLES", "1"))
