"""One slab designed by both generations of EN 1992-1-1: a table of its checks, side by side, for docs/howto."""

from __future__ import annotations

from pathlib import Path

import groundslab as gs
from groundslab.design.rules.check import DesignCheck
from groundslab.model.design.reinforcement import KEYS_OF_CODES
from groundslab.model.model import Model

CASE = Path(__file__).resolve().parent.parent / "examples" / "second_generation.toml"
CODES = ("EN 1992-1-1", "EN 1992-1-1:2023")
#: Names of checks that are one and the same.
SAME = {"punching within 2 d": "punching", "punching at walls' ends within 2 d": "punching at walls' ends"}


def by_code(model: Model, code: str) -> Model:
    """Return the case with another code, without the keys that it does not have."""
    steel = model.reinforcement
    assert steel is not None
    own = {key for keys in KEYS_OF_CODES.values() for key in keys} - {*KEYS_OF_CODES[code]}
    given = {key: getattr(steel, key) for key in steel.model_fields_set if key not in own}
    return model.replace(reinforcement=type(steel)(**given | {"code": code}))


def table() -> str:
    """Return the checks that have numbers in both, as a table in Markdown."""
    model = gs.load(CASE)
    found: list[dict[str, DesignCheck]] = []
    for code in CODES:
        checks = gs.check_design(gs.solve(by_code(model, code))).checks
        found.append({SAME.get(check.name, check.name): check for check in checks if check.resistance is not None})
    heads = [f"{what}, {year}" for year in ("2004", "2023") for what in ("demand", "resistance", "used")]
    lines = [f"| check | unit | {' | '.join(heads)} |", "|---|---|" + "---|" * len(heads)]
    for name in dict.fromkeys(name for checks in found for name in checks):
        cells = [_cells(checks.get(name)) for checks in found]
        unit = next(checks[name].unit for checks in found if name in checks)
        lines.append(f"| {name} | {unit} | {' | '.join(cell for three in cells for cell in three)} |")
    return "\n".join(lines) + "\n"


def _cells(check: DesignCheck | None) -> tuple[str, str, str]:
    """Return demand, resistance and the share used of a check, if there is one."""
    if check is None or check.demand is None or check.resistance is None:
        return "", "", ""
    share = check.resistance / check.demand if check.least else check.demand / check.resistance
    return f"{check.demand:.3g}", f"{check.resistance:.3g}", f"{share:.2f}"


if __name__ == "__main__":
    print(table())
