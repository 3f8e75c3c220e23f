"""What tests of the server share."""

from __future__ import annotations

import pytest

from groundslab.workbench.checking import file_reader
from helpers import workers


@pytest.fixture
def reading_here(monkeypatch: pytest.MonkeyPatch) -> None:
    """Have files read in the process of the test instead of one of their own, as other tests have them."""
    monkeypatch.setattr(file_reader, "BoundedProcess", lambda *_: workers.Inline())
