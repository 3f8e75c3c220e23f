"""Results that are kept as references: those of a run anew each time, no more than a few, none in the end."""

from __future__ import annotations

from pathlib import Path

import pytest

from groundslab.errors import InputError
from groundslab.workbench.exports.reference import MOST, KeptReferences


def test_the_last_results_of_a_run_are_kept() -> None:
    """Provisional ones make way for those of a finer mesh of the same run."""
    kept = KeptReferences()
    for words in ("provisional", "final"):
        kept.keep(3, lambda file, words=words: Path(file).write_text(words))
        assert Path(kept.find(3)).read_text() == words
    kept.clear()
    with pytest.raises(InputError):
        kept.find(3)


def test_the_oldest_ones_go() -> None:
    """What cannot be saved takes none of the others away; folders are gone with their results."""
    kept = KeptReferences()
    for run in range(MOST + 1):
        kept.keep(run, lambda file: Path(file).touch())

    def fail(_: str) -> None:
        raise OSError

    with pytest.raises(OSError):
        kept.keep(MOST, fail)
    with pytest.raises(InputError):
        kept.find(0)
    files = [Path(kept.find(run)) for run in range(1, MOST + 1)]
    assert all(file.exists() for file in files)
    kept.clear()
    assert not any(file.parent.exists() for file in files)
    assert kept.find(None) == ""
