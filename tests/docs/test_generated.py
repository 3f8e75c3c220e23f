"""The schemas and the description of the server in docs/interface are those that the code makes."""

from __future__ import annotations

import re
from importlib import metadata

import pytest

from helpers.paths import DOCS, ROOT

pytest.importorskip("fastapi")
write_docs = pytest.importorskip("write_docs")


def test_the_interface_is_current() -> None:
    """Each file is what tools/write_docs.py writes, with the libraries that the lock file names."""
    locked = dict(re.findall(r"^(fastapi|pydantic)==([\d.]+)", (ROOT / "lock" / "dev.txt").read_text("utf-8"), re.M))
    if {name: metadata.version(name) for name in locked} != locked:
        pytest.skip("other versions of fastapi or pydantic word schemas in other ways")
    made = write_docs.interface()
    assert set(made) == set((DOCS / "interface").glob("*.json"))
    assert len(made) > 4
    for path, text in made.items():
        assert path.read_text(encoding="utf-8") == text, f"run tools/write_docs.py: {path.name} is not current"
