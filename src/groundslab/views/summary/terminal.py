"""The summary and the convergence history on the terminal, readable at 80 columns."""

from __future__ import annotations

import math
import textwrap
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from groundslab._version import __version__
from groundslab.messages import Message, Name, joined
from groundslab.results.contact_zone import goes_below_zero
from groundslab.results.results import refusal_words
from groundslab.unit_systems import in_system, unit_in
from groundslab.units import UNITS, format_number
from groundslab.views.summary import combinations
from groundslab.views.summary.discretization import coarse_words, is_unknown
from groundslab.views.summary.rows import SummarySection, translated
from groundslab.views.summary.sections import certified_words, summary
from groundslab.views.translation import translator_of

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from rich.console import Console
    from rich.text import Text

    from groundslab.design.checks import Design, DesignCheck, Status
    from groundslab.languages import Translator
    from groundslab.results.records import Step
    from groundslab.results.results import CombinationResult, Results
    from groundslab.unit_systems import System
    from groundslab.views.summary.combinations import Entry, Extreme
    from groundslab.views.summary.rows import Row

#: Widths of the columns of words, values, units and discretization errors; with the place, 80 in all.
LABEL, VALUE, UNIT, ERROR = 34, 11, 5, 7
#: At most so many load cases are listed.
MOST_CASES = 40
#: Verdicts on figures with a tolerance, and their styles; see `Row.ok`.
VERDICTS = {True: ("ok", "green"), False: ("FAILED", "bold red"), None: ("too coarse", "bold yellow")}


def print_summary(combined: Results, console: Console) -> None:
    """Print the summary and the verdict.

    Of an only combination all its figures and the convergence history; of several what they have in common, each on its
    lines, and the extremes over all.
    """
    from groundslab.design.checks import check_design

    combinations.require_finite(combined)
    entries = combinations.entries(combined)
    design = check_design(combined)
    only = combinations.only(entries)
    translate = translator_of(combined)
    _head(combined.model.title, design, translate, console)
    if only is not None:
        _print_lines([f"{only.combination} ({translate(only.limit_state)})"], "dim", console)
        _print_cases(combined, console)
        _print_only(only, console)
    else:
        _print_cases(combined, console)
        _print_several(combined, entries, console)
    console.print()
    if not combined.refused:
        _print_certified(combined, design, console)
        return
    for line in combinations.refusal_sentences(combined):
        _print_lines(textwrap.wrap(translate(line), 78), "bold red", console)


def _print_cases(combined: Results, console: Console) -> None:
    """Print where each load case acts, of very many the first ones, and the remarks on the case."""
    lines = combinations.case_lines(combined)
    if not lines:
        return
    translate = translator_of(combined)
    console.print()
    _print_lines([translate("Load cases: factors and number of combinations")], "bold cyan", console)
    for line in lines[:MOST_CASES]:
        _print_lines(textwrap.wrap(translate(line), 76, initial_indent="  ", subsequent_indent="    "), "", console)
    if len(lines) > MOST_CASES:
        _print_lines(
            [translate(Message("  ... {count} more in the table acting", count=len(lines) - MOST_CASES))],
            "dim",
            console,
        )


def _print_only(results: CombinationResult, console: Console) -> None:
    """Print the figures of an only combination and its convergence history."""
    translate = translator_of(results)
    for section in (translated(original, translate) for original in summary(results)):
        _print_section(section, [_line(row, results.model.units, translate) for row in section.rows], console)
    console.print()
    print_history(results.steps, console, translate)


def _print_several(combined: Results, entries: Sequence[Entry], console: Console) -> None:
    """Print what combinations have in common, each on its lines, and the extremes over all."""
    units, translate = combined.model.units, translator_of(combined)
    described = combinations.description(combined) if any(entry.results for entry in entries) else []
    for section in (translated(original, translate) for original in described):
        _print_section(section, [_line(row, units, translate) for row in section.rows], console)
    console.print()
    _print_lines([translate("Combinations")], "bold cyan", console)
    of_figures = (unit_in("kN", units)[0], unit_in("mm", units)[0], unit_in("mm", units)[0], "%", "steps")
    for heading in (("load", "settlement", "uplift", "contact", "iteration"), of_figures):
        _print_lines(["   " + "".join(f"{translate(word):>14}" for word in heading)], "dim", console)
    for entry in entries:
        for line in _entry(entry, units, translate):
            console.print(line, soft_wrap=True)
    for section, rows in combinations.extremes(combined):
        titled = translated(
            replace(section, title=Message("{title}: extremes", title=section.title), rows=()), translate
        )
        _print_section(titled, [_extreme(row, units, translate) for row in rows], console)
    if not combined.results:
        return
    worst = SummarySection("certificate", translate("Certificate: the worst value of each figure"), ())
    _print_section(worst, [_extreme(row, units, translate) for row in combinations.worst(combined)], console)
    _print_lines(
        ["  " + translate("The number before each line is that of the governing combination.")], "dim", console
    )


def _print_lines(lines: Iterable[str], style: str, console: Console) -> None:
    """Print lines of text in one style."""
    from rich.text import Text

    for line in lines:
        console.print(Text(line, style=style), soft_wrap=True)


def _entry(entry: Entry, units: System, translate: Translator) -> Iterator[Text]:
    """Yield the lines of one combination: name and factors, figures, and why it is refused."""
    from rich.text import Text

    about, factors = entry.combination, combinations.factors_text(entry.combination)
    rule = joined((about.limit_state, Name(about.rule))) if about.rule else about.limit_state
    titled = Message("{name} ({rule}): {factors}", name=Name(about.name), rule=rule, factors=factors)
    name, *more = textwrap.wrap(translate(titled), 74)
    yield Text(f"{entry.number:>3} {name}", style="bold")
    yield from (Text(f"    {line}", style="bold") for line in more)
    if entry.results is not None:
        w, contact = entry.results.plate.settlement, entry.results.plate.contact_share
        uplift = -w.min() if goes_below_zero(w) else 0.0
        force, length = in_system(UNITS["kN"], units).scale, in_system(UNITS["mm"], units).scale
        figures = (entry.results.certificate.load * force, w.max() * length, uplift * length, contact * 100)
        texts = [*map(format_number, figures), str(len(entry.results.steps))]
        line = Text("   " + "".join(f"{translate(text):>14}" for text in texts))
        if entry.refused is None:
            line.append("  ok", style="green")
        yield line
    if entry.refused is not None:
        shown = textwrap.wrap(translate(refusal_words(entry.refused, units)), 74, max_lines=6, placeholder=" ...")
        yield from (Text(f"    {line}", style="bold red") for line in shown)


def _extreme(extreme: Extreme, units: System, translate: Translator) -> Text:
    """Return a row as one line that begins with the number of its combination."""
    from rich.text import Text

    row = replace(extreme.row, label=translate(extreme.row.label))
    return Text(f"{extreme.number:>2} ") + _line(row, units, translate, 1)


def _head(title: str, design: Design, translate: Translator, console: Console) -> None:
    """Print the verdict on the design, the title, the version, and the checks, utilization before each."""
    _print_lines(
        textwrap.wrap(translate(design.headline), 78), _style(design.status, hangs=bool(design.hanging)), console
    )
    _print_lines([title or translate("(no title)")], "bold", console)
    _print_lines([f"groundslab {__version__}"], "dim", console)
    for check in design.checks:
        used = "" if check.utilization is None else translate(f"{check.utilization:.2f}")
        within = f" ({translate(text).replace('±', '+-')})" if (text := between_text(check)) else ""
        verdict = f" [{translate(check.verdict)}]" if check.hangs else ""
        text = f"{used:>6}{within} {translate(check.name)}: {translate(check.words)}{verdict}"
        style = _style(check.status, hangs=check.hangs)
        _print_lines(textwrap.wrap(text, 78, subsequent_indent=" " * 7), style, console)


def between_text(check: DesignCheck) -> str:
    """Return between which values the utilization is within the discretization error, empty where it has none."""
    if check.between is None or not check.error:
        return ""
    used, low, high = (f"{value:.2f}" for value in (check.utilization or 0.0, *check.between))
    if low == used == high:
        return "±<0.01"
    return Message("{low:.2f} to {high:.2f}", low=check.between[0], high=check.between[1])


def _style(status: Status, *, hangs: bool) -> str:
    """Return the style of a verdict, which may hang on the discretization error."""
    return _STYLES["attention" if hangs and status == "no failure found" else status]


_STYLES: dict[Status, str] = {
    "fails": "bold red", "attention": "bold yellow", "switched off": "yellow", "no failure found": "dim",
    "not checked": "dim",
}  # fmt: skip


def _print_certified(combined: Results, design: Design, console: Console) -> None:
    """Print what the certificate of all results says, whether the mesh is fine enough, and what fails in the design."""
    coarse, translate = coarse_words(combined), translator_of(combined)
    style = "yellow" if coarse else "green"
    if not is_unknown(combined):
        _print_lines(textwrap.wrap(translate(certified_words(len(combined.combinations))), 78), style, console)
    _print_lines(textwrap.wrap(translate(coarse), 78), "bold yellow", console)
    if design.open:
        again = f"{translate(design.headline)} {translate('See the first lines.')}"
        _print_lines(textwrap.wrap(again, 78), _STYLES[design.status], console)


def _print_section(section: SummarySection, lines: Sequence[Text], console: Console) -> None:
    """Print lines under their heading, and the notes below."""
    from rich.padding import Padding
    from rich.text import Text

    console.print()
    _print_lines([section.title], "bold cyan", console)
    for line in lines:
        console.print(line, soft_wrap=True)
    for note in section.notes:
        console.print(Padding(Text(note, style="dim"), (0, 2)))


def print_history(steps: Sequence[Step], console: Console, translate: Translator = str) -> None:
    """Print one line for each step of the iteration; steps on the finest mesh carry a star."""
    from rich.padding import Padding
    from rich.table import Table

    _print_lines([translate("Convergence history")], "bold cyan", console)
    table = Table(box=None, padding=(0, 2, 0, 0), pad_edge=False, header_style="dim")
    for heading in (
        "mesh\nunknowns", "load\nincrement", "\ngamma", "contact\niteration", "in\ncontact", "\nchanged", "",
    ):  # fmt: skip
        table.add_column(translate(heading), justify="right", no_wrap=True)
    for step in steps:
        table.add_row(*map(translate, step_texts(step)), "*" if step.finest else "")
    console.print(Padding(table, (0, 0, 0, 2)))
    if any(step.finest for step in steps):
        _print_lines(["  " + translate("* on the finest mesh")], "dim", console)


def step_texts(step: Step) -> list[str]:
    """Return the numbers of a step as text: unknowns, increment, gamma, iteration, what is in contact, what changed."""
    gamma = "-" if step.gamma is None else format_number(step.gamma)
    return [
        str(number) for number in (step.unknowns, step.increment, gamma, step.iteration, step.in_contact, step.changed)
    ]


def _line(row: Row, units: System, translate: Translator, taken: int = 0) -> Text:
    """Return a row of the summary, whose words are translated, as one line; long words wrap under themselves.

    So many columns are taken before.
    """
    from rich.text import Text

    symbol = f" {row.symbol}" if row.symbol else ""
    first, *more = textwrap.wrap(row.label + symbol, LABEL - taken + 2)
    line = Text(f"\n{' ' * 4}".join([("" if taken else "  ") + first, *more[:-1]]))
    line.append(f"\n{' ' * 4}{more[-1].ljust(LABEL - 2)}" if more else " " * (LABEL - taken - len(first)))
    shown = shown_row(row, units)
    if row.tolerance is not None:
        line.append(f"{translate(shown.figure):>{VALUE}} {shown.unit}{' ' if shown.unit else ''}")
        line.append(translate(verdict_word(row)), style=VERDICTS[row.ok][1])
        line.append(f" ({translate(Message('limit {limit}', limit=limit_text(row)))})", style="dim")
    elif isinstance(row.value, str):
        pieces = textwrap.wrap(row.value, 78 - LABEL - 2)
        line.append(row.value.rjust(VALUE) if len(row.value) <= VALUE else f"\n{' ' * (LABEL + 2)}".join(pieces))
    else:
        error = translate(shown.error).replace("±", "+-")  # not every terminal has it
        figure, place = translate(shown.figure), translate(shown.place)
        line.append(f"{figure:>{VALUE}} {shown.unit:<{UNIT}} {error:<{ERROR}} {place}".rstrip())
    return line


@dataclass(frozen=True, slots=True)
class Shown:
    """A row of the summary as text: figure or words, unit of display, place, error."""

    figure: str
    unit: str = ""
    place: str = ""
    error: str = ""  # relative to the figure


def verdict_word(row: Row) -> str:
    """Return the verdict on a figure with a tolerance."""
    return VERDICTS[row.ok][0]


def limit_text(row: Row) -> str:
    """Return the tolerance of a figure: one with a unit in it, others as a power of ten."""
    assert row.tolerance is not None
    return f"{row.tolerance:.0e}" if row.unit is None else f"{row.tolerance * row.unit.scale:g} {row.unit.name}"


def shown_row(row: Row, units: System) -> Shown:
    """Return the texts of a row: figures that must vanish with two digits, others with five, and its place."""
    if isinstance(row.value, str):
        return Shown(row.value)
    if row.tolerance is not None and row.unit is None:
        return Shown(f"{row.value:.1e}")
    scale, unit = (1.0, "") if row.unit is None else (row.unit.scale, row.unit.name)
    figure = str(row.value) if isinstance(row.value, int) else format_number(row.value * scale)
    if row.tolerance is not None:
        figure = f"{row.value * scale:.2g}"
    place = "" if row.place is None else place_text(row.place, units)
    place += "*" if row.singular else ""
    return Shown(figure, unit, place, "" if row.error is None else error_text(row.error, row.value))


def place_text(place: tuple[float, float], units: System) -> str:
    """Return a place [m] with three decimals in meters or feet."""
    _, per_meter = unit_in("m", units)
    return "({:.3f}, {:.3f})".format(*(round(x * per_meter, 3) + 0.0 for x in place))


def error_text(error: float, value: float) -> str:
    """Return a discretization error as a share of its value, such as "± 0.4 %"."""
    if not error:
        return ""
    share = 100 * abs(error / value) if value else math.inf
    if share >= 99:
        return "±>99 %"
    return "±<0.1 %" if share < 0.1 else f"±{share:.0f} %" if share >= 10 else f"±{share:.1f} %"
