"""Builds the pages, copies the help and compiles catalogues of messages, before groundslab is packed or installed."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import tomllib
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

ROOT = Path(__file__).resolve().parent
WEB = ROOT / "web"
LANGUAGES = ROOT / "src" / "groundslab" / "languages"
STATIC_HELP = ROOT / "src" / "groundslab" / "workbench" / "help" / "static"
#: Files that the workbench shows as help: patterns below the repository, copied with their paths.
HELP = (
    "docs/*.md",
    "docs/start/*.md",
    "docs/howto/*.md",
    "docs/tutorials/*.md",
    "docs/images/*.*",
    "docs/*.png",
    "examples/*.toml",
)
#: Pages that are for developers, or made by running code.
NO_HELP = ("api", "architecture", "changelog", "contributing", "gallery", "licenses", "performance", "releasing")
HINT = (
    "The pages of the report and the workbench are made of web/ with Node.js and npm, which fetch their packages from "
    "the network. Without a network, install a wheel or an sdist of groundslab: they contain the pages."
)


def has_node() -> bool:
    """Return whether there are npm and a Node.js that Vite 8 supports: 20.19 and newer 20, 22.12 and newer."""
    node = shutil.which("node")
    if node is None or shutil.which("npm") is None:
        return False
    printed = subprocess.run([node, "--version"], capture_output=True, text=True, check=False).stdout
    major, minor = map(int, re.findall(r"\d+", printed)[:2] or (0, 0))
    return (major, minor) >= (22, 12) or (major == 20 and minor >= 19)


def are_pages_current() -> bool:
    """Return whether all pages are built and newer than their sources; those of an sdist always are."""
    if (ROOT / "PKG-INFO").is_file():
        return True
    configurations = [file.read_text(encoding="utf-8") for file in WEB.glob("vite*.config.ts")]
    folders = re.findall(r"src/groundslab/[\w/]+", "".join(configurations))
    pages = [[file.stat().st_mtime for file in (ROOT / folder).glob("*.*")] for folder in folders]
    sources = [file.stat().st_mtime for file in [*WEB.glob("*.*"), *(WEB / "src").rglob("*.*")]]
    return all(pages) and min(map(min, pages)) >= max(sources)


def build_pages() -> None:
    """Build the pages where they are not current; RuntimeError with a hint if that fails."""
    if are_pages_current():
        return
    npm = shutil.which("npm") or "npm"
    installed, locked = WEB / "node_modules" / ".package-lock.json", WEB / "package-lock.json"
    try:
        if not installed.is_file() or installed.stat().st_mtime < locked.stat().st_mtime:
            subprocess.run([npm, "ci"], cwd=WEB, check=True)
        subprocess.run([npm, "run", "build"], cwd=WEB, check=True)
    except (OSError, subprocess.CalledProcessError) as error:
        raise RuntimeError(f"{error}\n{HINT}") from error


def copy_help(target: Path = STATIC_HELP) -> None:
    """Copy documentation and examples to where the workbench finds them; those of an sdist are there already."""
    if (ROOT / "PKG-INFO").is_file() and target.is_dir():
        return
    shutil.rmtree(target, ignore_errors=True)
    for file in (each for pattern in HELP for each in sorted(ROOT.glob(pattern)) if each.stem not in NO_HELP):
        copy = target / file.relative_to(ROOT)
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, copy)


def compile_catalogues() -> None:
    """Write each catalogue of messages as JSON, which program and pages read; those of an sdist are there already.

    Translations that are marked as doubtful ("fuzzy") are left out.
    """
    if (ROOT / "PKG-INFO").is_file():
        return
    from babel.messages.pofile import read_po

    target = LANGUAGES / "static"
    target.mkdir(exist_ok=True)
    for file in LANGUAGES.glob("*.po"):
        with file.open("rb") as content:
            entries = [entry for entry in read_po(content, abort_invalid=True) if entry.id and not entry.fuzzy]
        messages = {entry.id: entry.string for entry in entries}
        text = json.dumps(messages, ensure_ascii=False, indent=0)
        (target / f"{file.stem}.json").write_text(text, encoding="utf-8")


class PagesHook(BuildHookInterface):  # type: ignore[type-arg]
    """Hatchling's hook for sdists, wheels and editable installs."""

    def dependencies(self) -> list[str]:
        """Return what the build needs: Babel, and Node.js where the machine has none that is recent enough."""
        groups = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["dependency-groups"]
        babel = [] if (ROOT / "PKG-INFO").is_file() else groups["babel"]
        return [*babel, *([] if are_pages_current() or has_node() else groups["node"])]

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:  # noqa: ARG002
        """Build the pages, copy the help and compile the catalogues."""
        build_pages()
        copy_help()
        compile_catalogues()


if __name__ == "__main__":
    build_pages()
    copy_help()
    compile_catalogues()
