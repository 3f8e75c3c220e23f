"""Writes the verification manual: runs every case, and makes a page of each with its table, a figure and its files.

    python tools/verification_manual.py docs/verification [CASE ...]

`make docs` does so before it builds the site. A row that fails ends it with exit code 1. Pictures take longer than the
cases: where cases are named only these get theirs.
"""

from __future__ import annotations

import re
import sys
import tomllib
from collections import defaultdict
from collections.abc import Iterator, Sequence
from pathlib import Path

import convergence_plots

from groundslab.case import casefile
from groundslab.model.model import Model
from groundslab.results.results import CombinationResult
from groundslab.verification import runner
from groundslab.verification.runner import Case, Outcome
from groundslab.views.plots import plot

ROOT = Path(__file__).resolve().parent.parent
GROUPS = {
    "paper": "The paper that groundslab began with",
    "analytic": "Closed forms and series",
    "programs": "Other programs",
    "design": "Design codes",
    "told": "Told errors held to true ones",
}
#: Sources that have no author and year.
NAMED = (
    "CNR-DT 211/2014",
    "Code_Aster",
    "The Concrete Centre",
    "Concrete Industry Eurocode 2 Group",
    "OpenSees",
    "OOFEM",
    "PyNite",
    "STAAD.Pro",
    "XC,",
    "calculocivil.com",
    "eurocodeapplied.com",
)
#: What slabs have in the matrix, and how one sees it in a model.
CAPABILITIES = {
    "springs": lambda m: m.ground.kind == "winkler",
    "Pasternak": lambda m: m.ground.kind == "pasternak",
    "Vlasov": lambda m: m.ground.kind == "vlasov",
    "layers": lambda m: m.ground.kind == "layered",
    "continuum": lambda m: m.ground.kind == "continuum",
    "varying ground": lambda m: bool(m.soil_zones or m.boreholes),
    "ground beyond": lambda m: m.beyond.kind != "none",
    "lift-off": lambda m: m.contact.tensionless,
    "gaps, voids": lambda m: bool(m.contact.gaps or m.contact.voids),
    "any outline": lambda m: not m.plain,
    "edges held": lambda m: (
        m.plate.support != "free" or any(edge != "free" for edge in m.plate.edges.model_dump().values())
    ),
    "supports": lambda m: bool(m.supports),
    "point loads": lambda m: any(load.kind == "point" for load in m.loads),
    "line loads": lambda m: any(load.kind == "line" for load in m.loads),
    "area loads": lambda m: any(load.kind in ("patch", "area") for load in m.loads),
    "temperature": lambda m: any(load.kind == "temperature" for load in m.loads),
}


def write(folder: Path, pictured: Sequence[str] = ()) -> bool:
    """Write the manual into a folder, with pictures of all cases or of some; return whether every row holds."""
    (folder / "files").mkdir(parents=True, exist_ok=True)
    cases = [case for case in map(runner.load, runner.case_names()) if runner.can_run(case)]
    outcomes: dict[str, list[Outcome]] = {}
    used: dict[str, list[str]] = {}
    for case in cases:
        solved: dict[tuple[str, tuple[int, ...]], CombinationResult] = {}
        outcomes[case.name] = list(runner.outcomes_of(case, solved))
        models = {name: runner.model_of(case, name) for name in case.models}
        used[case.name] = [name for name, has in CAPABILITIES.items() if any(map(has, models.values()))]
        drawn = solved if not pictured or case.name in pictured else {}
        text = "\n".join(_page(case, outcomes[case.name], models, drawn, folder))
        (folder / f"{case.name}.md").write_text(text, encoding="utf-8")
    rows = [outcome for found in outcomes.values() for outcome in found]
    sources = sources_of(cases)
    summary = f"{len(cases)} cases, {len(rows)} rows, {len(sources)} sources"
    (folder / "index.md").write_text("\n".join(_index(cases, outcomes, used, summary)), encoding="utf-8")
    failed = sum(not outcome.ok for outcome in rows)
    print(f"{summary}, {failed} rows FAILED" if failed else f"{summary}, every row holds")
    return not failed


def sources_of(cases: Sequence[Case]) -> set[str]:
    """Return the entries of the bibliography, and the programs, that cases are held against."""
    bibliography = (ROOT / "docs" / "bibliography.md").read_text(encoding="utf-8")
    known = [*re.findall(r"^## (.+ \d{4})$", bibliography, re.MULTILINE), *NAMED]
    texts = " ".join(f"{case.source} {case.note}" for case in cases)
    return {name for name in known if name in texts}


def _index(
    cases: Sequence[Case], outcomes: dict[str, list[Outcome]], used: dict[str, list[str]], summary: str
) -> Iterator[str]:
    """Yield the lines of the first page: what there is, and which case shows what."""
    yield "# Verification manual\n"
    yield f"{summary}. Every page was made by running its case as the site was built; `groundslab verify NAME` runs it"
    yield "again. A row agrees with its source within a tolerance that its case states, or differs by as much as its"
    yield "reason explains, or is refuted by a proof that is computed each time. Each value is also held to our own"
    yield "pinned one, so that a change within the tolerance is seen. Beside each value stands its discretization"
    yield "error, which the cases of the last group hold to the true one. Cases whose published numbers were not read"
    yield "in the source itself say so.\n"
    verdicts = defaultdict[str, int](int)
    for outcome in (each for found in outcomes.values() for each in found):
        verdicts[outcome.verdict] += 1
    yield "| verdict | rows |\n|---|---|"
    yield from (f"| {verdict} | {count} |" for verdict, count in verdicts.items())
    largest = max((o for found in outcomes.values() for o in found if o.verdict.startswith("differs")), key=_percent)
    yield f"\nThe largest difference that is explained: {largest.label}, {largest.difference}: {largest.reason}.\n"
    yield "## What is covered\n"
    yield "| case | " + " | ".join(CAPABILITIES) + " |"
    yield "|---|" + "---|" * len(CAPABILITIES)
    for case in cases:
        marks = ["x" if name in used[case.name] else "" for name in CAPABILITIES]
        yield f"| [{case.name}]({case.name}.md) | " + " | ".join(marks) + " |"
    yield "\n## What was not reproduced\n"
    yield "Published cases that were looked at and are not here, with the reason.\n"
    yield "| source | reason |\n|---|---|"
    left_out = tomllib.loads((ROOT / "tools" / "not_reproduced.toml").read_text(encoding="utf-8"))["case"]
    yield from (f"| {case['source']} | {case['reason']} |" for case in left_out)
    for group, title in GROUPS.items():
        yield f"\n## {title}\n\n```{{toctree}}\n:maxdepth: 1\n"
        yield from (case.name for case in cases if case.group == group)
        yield "```"


def _percent(outcome: Outcome) -> float:
    """Return the size of a difference in percent."""
    found = re.search(r"\(([^ ]+) %\)", outcome.difference)
    return abs(float(found[1])) if found else 0.0


def _page(
    case: Case,
    outcomes: Sequence[Outcome],
    models: dict[str, Model],
    solved: dict[tuple[str, tuple[int, ...]], CombinationResult],
    folder: Path,
) -> Iterator[str]:
    """Yield the lines of a case's page."""
    yield f"# {case.title[0].upper()}{case.title[1:]}\n"
    yield f"**Source.** {case.source}.\n"
    if case.note:
        yield " ".join(case.note.split()) + "\n"
    reasons = list(dict.fromkeys(outcome.reason for outcome in outcomes if outcome.reason))
    yield "| value | published | computed | discretization | difference | verdict |\n|---|---|---|---|---|---|"
    for outcome in outcomes:
        mark = f" [{reasons.index(outcome.reason) + 1}]" if outcome.reason else ""
        error = "" if outcome.error is None else f"± {outcome.error:.1g}"
        yield (
            f"| {outcome.label} | {outcome.published} | {outcome.computed:.6g} | {error} | {outcome.difference} "
            f"| {outcome.verdict}{mark} |"
        )
    if reasons:
        yield "\n**Differences, explained**\n"
        yield from (f"- [{number}] {reason}" for number, reason in enumerate(reasons, start=1))
    shown = next(((name, results) for (name, counts), results in solved.items() if not counts), None)
    if shown is not None:
        name, results = shown
        picture = f"{case.name}.png"
        plot(results, "settlement", "moment_x", to=folder / picture)
        yield f"\n![Settlement and moment m_x of the model {name}]({picture})\n"
        picture = f"{case.name}-convergence.png"
        if convergence_plots.draw(case, outcomes, models[name], name, results, folder / picture):
            yield "**Convergence**, on elements four times, twice and once as large as the case's. What differs from"
            yield f"its source levels off; what agrees goes down.\n\n![Differences over unknowns]({picture})\n"
    yield f"\n**Files.** `groundslab verify {case.name}` runs the case. Its models, for `groundslab solve`:\n"
    for number, (name, model) in enumerate(models.items(), start=1):
        file = f"files/{case.name}-{number}.toml"
        (folder / file).write_text(casefile.to_toml(model), encoding="utf-8")
        yield f"- {{download}}`{name} <{file}>`"
    yield ""


if __name__ == "__main__":
    sys.exit(0 if write(Path(sys.argv[1]), sys.argv[2:]) else 1)
