"""Told errors of judged values over true ones, on slabs that are known in closed form.

    python bench/told_errors.py                 # all of bench/closed_forms.py; some minutes
    python bench/told_errors.py ring strip      # those with such a word in their names; nothing is kept
    python bench/report.py                      # histograms in docs/performance.md

Each slab is solved on meshes for 5 % and for 2 %, and with a few sizes of elements. A line is printed for each value
whose true error is above 0.1 % of what governs, and marked where the told one is below half or above eight times it;
at the end the shares. All figures go to bench/told_errors.json.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from closed_forms import ClosedForm, closed_forms
from random_slabs import moved_inwards
from told_report import HEAD, HIGH, LEAST, SEEN, Told

from groundslab.accuracy.judgment import AGAINST, CONTACT, SIZES, find_largest, judged_values
from groundslab.accuracy.singularities import Limits, find_limits, limits_without_contact
from groundslab.analysis import driver
from groundslab.arrays import Array, Flags
from groundslab.results.fields import PLATE_FIELDS
from groundslab.results.results import CombinationResult

RESULTS = Path(__file__).parent / "told_errors.json"
ACCURACIES = (0.05, 0.02)
#: Judged values by what they are called, and those that are not judged everywhere.
NAMES = {PLATE_FIELDS[name].label: name for name in AGAINST} | {CONTACT: "share"}
LIMITED = ("pressure", "shear_x", "shear_y")

#: A value on one mesh: form, mesh, unknowns, name, sign, true and told error as shares of what governs.
Row = dict[str, Any]


class Exact:
    """The exact extremes of a slab; those that are judged everywhere are the same on every mesh."""

    def __init__(self, form: ClosedForm) -> None:
        """Know nothing yet."""
        self.form = form
        self.known: dict[tuple[str, int], float | None] = {}

    def extreme(self, name: str, sign: int, results: CombinationResult) -> float | None:
        """Return the largest (sign 1) or smallest value where it is judged, or the largest size; None if unknown."""
        form, limited = self.form, name in LIMITED
        if (name, sign) in form.extremes:
            return form.extremes[name, sign]
        if (
            form.at is None
            or name in ("gap", "share")
            or (name in ("settlement", "pressure") and sign not in form.signs)
        ):
            return None
        if limited and not form.inside:
            return self._among(name, sign, _judged_nodes(name, results))
        if (name, sign) not in self.known:
            places = form.places
            if limited:
                places = places[_where(name, limits_without_contact(results.solved_model, places))]
            self.known[name, sign] = self._among(name, sign, places)
        return self.known[name, sign]

    def _among(self, name: str, sign: int, places: Array) -> float | None:
        """Return the extreme at places, None if the field is not known."""
        assert self.form.at is not None
        values = self.form.at(places).get(name)
        if values is None:
            return None
        return float(np.abs(values).max() if name in SIZES else sign * (sign * values).max())


def _where(name: str, limits: Limits) -> Flags:
    """Return where a field is judged."""
    return limits.pressures if name == "pressure" else limits.shear_forces


def _judged_nodes(name: str, results: CombinationResult) -> Array:
    """Return the nodes at which a field is judged, each on its side of a border."""
    plate = results.plate
    return moved_inwards(plate)[_where(name, find_limits(results.solved_model, plate))]


def examine(exact: Exact, mesh: dict[str, float]) -> Iterator[Row]:
    """Yield what is told and what is true of each judged value on one mesh."""
    form = exact.form
    results = driver.solve(form.model(**mesh)).only
    largest = find_largest([results])
    if results.comparison is None or largest is None:
        return
    for against, value in judged_values(results):
        if value.label not in NAMES:
            continue
        name = NAMES[value.label]
        true, size = exact.extreme(name, value.sign, results), getattr(largest, against)
        if true is None or not size > 0:
            continue
        yield {
            "form": form.name, **mesh, "unknowns": results.unknowns, "name": name, "sign": value.sign,
            "true": round(abs(value.value - true) / size, 7), "told": round(value.share / size, 7),
        }  # fmt: skip


def asked(row: Row) -> float:
    """Return the accuracy that was asked for, 5 % by default."""
    return float(row.get("accuracy", ACCURACIES[0]))


def told_line(row: Row) -> str:
    """Return the line of one value."""
    ratio = row["told"] / row["true"]
    mark = "too small" if ratio < LEAST else "too large" if ratio > HIGH else ""
    mesh = f"{row['size']:g} m" if "size" in row else f"{100 * row['accuracy']:g} %"
    name = f"{'least ' if row['sign'] < 0 else ''}{row['name']}"
    return (
        f"{row['form']:38} {mesh:6} {row['unknowns']:>7} {name:18} "
        f"true {100 * row['true']:6.2f} % told {100 * row['told']:6.2f} % {ratio:6.2f} {mark}"
    )


def main() -> None:
    """Examine the slabs and print what came out."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*", help="of the names of the slabs (all)")
    words = parser.parse_args().words
    rows: list[Row] = []
    for form in closed_forms():
        if words and not any(word in form.name for word in words):
            continue
        exact = Exact(form)
        adaptive = [{"accuracy": accuracy} for accuracy in ACCURACIES if form.adaptive]
        for mesh in [*adaptive, *({"size": size} for size in form.sizes)]:
            found = [*examine(exact, mesh)]
            rows += found
            for row in found:
                if row["true"] > SEEN:
                    print(told_line(row), flush=True)
    for kind, key in (("meshes that make themselves", "accuracy"), ("given sizes", "size")):
        some = [row for row in rows if key in row]
        if some:
            errors = tuple((row["true"], row["told"], asked(row)) for row in some)
            print("; ".join(f"{head}: {cell}" for head, cell in zip(HEAD, Told(kind, errors).row(), strict=True)))
    if not words:
        RESULTS.write_text("[\n" + ",\n".join(map(json.dumps, rows)) + "\n]\n", encoding="utf-8")


if __name__ == "__main__":
    main()
