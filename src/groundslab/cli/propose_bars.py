"""The command propose-bars: a case with bars that are proposed for it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from groundslab.cli.case import write_or_print
from groundslab.cli.console import EXIT_DESIGN_FAILS, EXIT_NO_RESULT, EXIT_OK, print_stderr
from groundslab.messages import Message, Name, words_in
from groundslab.unit_systems import bar_size, bars_at

if TYPE_CHECKING:
    import argparse
    from collections.abc import Iterator

    from groundslab.design.bars.proposal.propose import BarProposal
    from groundslab.design.rules.punching_links.layout import LinkLayout
    from groundslab.model.design.bars import Bars, BarZone
    from groundslab.model.design.beam_links import BeamLinks
    from groundslab.model.design.shear_links import ShearLinks
    from groundslab.results.results import Results
    from groundslab.unit_systems import System

_KG = 7850.0


def describe(command: argparse.ArgumentParser) -> None:
    """Add what the command propose-bars understands."""
    command.epilog = (
        "A case is solved first. Bars of the case, if it has any, are replaced; what may be proposed is set in "
        "[reinforcement.proposal]. Comments of the case are kept but for those in [reinforcement]."
    )
    command.add_argument("case", metavar="CASE", help="case file (TOML), or results folder written by groundslab solve")
    command.add_argument("-o", "--out", metavar="FILE", help="case file to write, a new one (default: print the text)")


def run(options: argparse.Namespace) -> int:
    """Propose bars for a case and write the case with them; exit code 3 if a check of these bars fails."""
    from dataclasses import replace

    from groundslab.case.editing.reinforcement import with_reinforcement
    from groundslab.design.checks import check_design
    from groundslab.design.proposal import propose_bars

    path = Path(options.case)
    results, text = _results(path)
    if not results.results:
        raise next(iter(results.refused.values()))
    proposal = propose_bars(results)
    write_or_print(with_reinforcement(text, proposal.reinforcement, _folder(path)), options.out)
    units = proposal.model.units
    print_stderr("\n".join(words_in(line, units) for line in _words(proposal, units)))
    design = check_design(replace(results, model=proposal.model))
    for check in design.open:
        print_stderr(f"{check.status}: {check.name}: {check.words}")
    if options.out is not None:
        print_stderr(f"wrote {options.out}; next: groundslab solve {options.out}")
    if any(check.status == "fails" for check in design.open):
        return EXIT_DESIGN_FAILS
    return EXIT_NO_RESULT if results.unsolved else EXIT_OK


def _folder(path: Path) -> Path:
    """Return the folder of a case."""
    return path if path.is_dir() else path.parent


def _results(path: Path) -> tuple[Results, str]:
    """Return the results of a case, solved or read from their folder, and the text of the case."""
    from groundslab.case import casefile

    if path.is_dir():
        from groundslab.views.files import results_folder

        return results_folder.load_results(path), casefile.read(path / "case.toml")
    from groundslab.analysis.driver import solve

    text = casefile.read(path)
    return solve(casefile.from_table(casefile.tables(text, str(path)), path.parent)), text


def _words(proposal: BarProposal, units: System) -> Iterator[str]:
    """Yield what is proposed, a line for each layer and zone."""
    steel, laps = proposal.reinforcement, _laps(proposal)
    for layer, volume in proposal.laid.items():
        base = steel.base_bars(layer)
        assert base is not None
        zones = [zone for zone in steel.zones if layer in zone.layers]
        yield (
            Message(
                "{layer}: {bars}{laps}, {zones}; {laid:.0f kg} without laps, required {required:.0f kg}",
                layer=layer.replace("_", " "), bars=_bars(base, units), laps=laps.get((layer, ""), ""),
                zones=f"{len(zones)} zone{'s' * (len(zones) != 1)}", laid=volume * _KG,
                required=proposal.required[layer] * _KG,
            )
        )  # fmt: skip
        yield from (_zone(zone, units, laps.get((layer, zone.name), "")) for zone in zones)
    laid, least = (sum(volumes.values()) for volumes in (proposal.laid, proposal.with_least))
    yield Message(
        "all layers: {laid:.0f kg} without laps, {more:.0f} % more than {least:.0f kg} for bending and least areas",
        laid=laid * _KG, more=(laid / least - 1) * 100, least=least * _KG,
    )  # fmt: skip
    yield from (_links(layout, units) for layout in proposal.links)
    yield from (_beam_links(links, units) for links in steel.beam_links)
    yield from (_shear_links(links, units) for links in steel.shear_links)
    yield from (Message("note: {remark}", remark=remark) for remark in proposal.remarks)


def _laps(proposal: BarProposal) -> dict[tuple[str, str], str]:
    """Return how bars lap that are longer than those delivered, by layer and zone, the base being without a name."""
    from groundslab.design.bars.positions import STRAIGHT, positions

    return {
        (position.layer, position.zone): Message(" lapped by {lap:.2f m}", lap=position.lap)
        for position in positions(proposal.model)
        if position.shape == STRAIGHT and position.lap is not None
    }


def _zone(zone: BarZone, units: System, laps: str) -> str:
    """Return a zone in words."""
    x0, x1, y0, y1 = zone.shape.ring().bounds
    return Message(
        "  {zone}: {bars}{laps}, x {x0:g (m)} to {x1:g m}, y {y0:g (m)} to {y1:g m}",
        zone=Name(zone.name), bars=_bars(zone.bars, units), laps=laps, x0=x0, x1=x1, y0=y0, y1=y1,
    )  # fmt: skip


def _links(layout: LinkLayout, units: System) -> str:
    """Return links against punching in words."""
    if not layout.perimeters:
        return Message("no links at {where}: {why}", where=Name(layout.where), why=layout.why)
    radial = "" if layout.radial is None else Message(", {radial:g m} apart", radial=layout.radial)
    return Message(
        "links at {where}: {counts} legs {size}, first perimeter {first:g m} from the face{radial}; {mass:.0f kg}",
        where=Name(layout.where), counts=str(layout.counts), size=bar_size(layout.diameter, units),
        first=layout.perimeters[0].distance, radial=radial, mass=layout.mass,
    )  # fmt: skip


def _beam_links(links: BeamLinks, units: System) -> str:
    """Return links along a beam in words."""
    return Message(
        "links along {beam}: {legs} legs, {bars}",
        beam=Name(links.of), legs=links.legs, bars=bars_at(links.diameter, links.spacing, units),
    )  # fmt: skip


def _shear_links(links: ShearLinks, units: System) -> str:
    """Return links against one-way shear in words."""
    x0, x1, y0, y1 = links.shape.ring().bounds
    return Message(
        "{links}: {bars} both ways, x {x0:g (m)} to {x1:g m}, y {y0:g (m)} to {y1:g m}",
        links=Name(links.name), bars=bars_at(links.diameter, links.spacing_x, units), x0=x0, x1=x1, y0=y0, y1=y1,
    )  # fmt: skip


def _bars(bars: Bars, units: System) -> str:
    """Return diameter and spacing."""
    return bars_at(bars.diameter, bars.spacing, units)
