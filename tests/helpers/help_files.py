"""The files of the workbench's help, copied as the build does."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest


@contextmanager
def copied_help(folder: Path) -> Iterator[None]:
    """Let documentation and examples be those that the build would copy now, into a folder."""
    hatch_build = pytest.importorskip("hatch_build")
    from groundslab.workbench.help import documentation, examples

    caches = (documentation.list_pages, documentation.list_files, documentation.render_page, examples.list_examples)
    hatch_build.copy_help(folder)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(documentation, "STATIC", folder)
        patch.setattr(examples, "STATIC", folder)
        for each in caches:
            each.cache_clear()
        yield
    for each in caches:
        each.cache_clear()
