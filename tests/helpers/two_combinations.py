"""A case of two combinations in the workbench, solved."""

from __future__ import annotations

from pathlib import Path

from helpers.browsing import Bench, Server

TWO = """
[[cases]]
name = "G"

[[cases]]
name = "Q"

[[loads]]
case = "Q"
kind = "uniform"
q = "10 kPa"

[[combinations]]
name = "heavy"
limit_state = "characteristic"
factors = {G = 1.0, Q = 1.0}

[[combinations]]
name = "light"
limit_state = "characteristic"
factors = {G = 1.0}
"""


def open_two(server: Server, bench: Bench, case: Path, more: str = "") -> None:
    """Open the case with two combinations and more tables, and wait for its results."""
    text = case.read_text().replace('column = "A1"\nP', 'case = "G"\ncolumn = "A1"\nP')
    case.write_text(text + TWO + more)
    bench.open(server.start(case))
    bench.wait_solved()
