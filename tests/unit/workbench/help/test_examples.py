"""The examples that the workbench offers are those of the repository."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from groundslab.errors import InputError
from groundslab.workbench.help.examples import list_examples, read_example
from helpers.help_files import copied_help
from helpers.paths import ROOT


@pytest.fixture(scope="module", autouse=True)
def _copied(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Copy the files."""
    with copied_help(tmp_path_factory.mktemp("help") / "static"):
        yield


def test_all_examples_are_offered_with_their_words() -> None:
    """Each file has an entry with its title, a sentence of the comment at its start, and what is drawn."""
    examples = {example["name"]: example for example in list_examples()}
    assert set(examples) == {path.stem for path in (ROOT / "examples").glob("*.toml")}
    assert all(example["title"] and example["about"].rstrip()[-1] in ".?" for example in examples.values())
    assert examples["void"]["title"] == "Slab over a cavity"
    assert examples["void"]["about"].startswith("A slab for a transformer over old mines")
    assert examples["void"]["data"]["plate"]["length_x"] == "8 m"


def test_an_example_keeps_its_comments() -> None:
    """The text is the file's."""
    assert read_example("pad") == (ROOT / "examples" / "pad.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", ["", "../pyproject", "/etc/passwd", "pads", "pad.toml"])
def test_other_names_are_refused(name: str) -> None:
    """Only names of the list are taken."""
    with pytest.raises(InputError):
        read_example(name)
