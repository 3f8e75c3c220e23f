"""What all peers solve, and what each of them prints: the paper's first plate on springs that only push, one quarter.

Nothing of groundslab is used here. The plate, its load, the ground and the sizes of the meshes are the same for all and
stand here once. Lengths in m, forces in N, settlements and loads positive downwards.
"""

from __future__ import annotations

import json
import os
import resource
import sys
import time
from collections import defaultdict
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

#: Half the plate's lengths, thickness [m].
A, B, T = 4.8, 3.6, 0.2
#: Half the loaded square's side [m]: the paper's, or a smaller one under the same force.
PAPERS = 1.2
LOADED = float(os.environ.get("LOADED", PAPERS))
E, NU = 23e9, 0.17
#: Modulus of the springs [N/m3] and pressure on the square [N/m2].
K, Q = 32.7862e6, 1e6 * (PAPERS / LOADED) ** 2
#: Bending rigidity [N m].
D = E * T**3 / (12 * (1 - NU**2))
#: Shear modulus of the plate [N/m2]; the shear correction is 5/6 in all programs.
G = E / (2 * (1 + NU))
SHEAR = 5 / 6 * G * T
#: No program may iterate longer than this.
LIMIT = 60


def divisions(unknowns: int, order: int) -> tuple[int, int]:
    """Return numbers of square elements along x and y for about so many unknowns, three at each of their nodes.

    They are multiples of 4 and 3, so that the load's edge follows the mesh; `order` is that of the element.
    """
    m = step = round(PAPERS / LOADED)
    while abs(unknowns_of(m + step, order) - unknowns) < abs(unknowns_of(m, order) - unknowns):
        m += step
    return 4 * m, 3 * m


def unknowns_of(m: int, order: int) -> int:
    """Return the number of unknowns of 4 m by 3 m elements."""
    return 3 * (4 * m * order + 1) * (3 * m * order + 1)


def mesh_nodes(nx: int, ny: int) -> tuple[Any, Any, float, Any, Any]:
    """Return coordinates x and y, an element's area, and how many elements a node has, and how many loaded ones."""
    import numpy as np  # which not every program comes with

    def add_cells(cells: Any) -> Any:
        padded = np.pad(cells, 1)
        return padded[:-1, :-1] + padded[:-1, 1:] + padded[1:, :-1] + padded[1:, 1:]

    x, y = np.linspace(0, A, nx + 1), np.linspace(0, B, ny + 1)
    loaded = (y[:-1, None] < LOADED - 1e-9) & (x[None, :-1] < LOADED - 1e-9)
    return x, y, x[1] * y[1], add_cells(np.ones((ny, nx))), add_cells(loaded.astype(float))


class Job:
    """The clock of one job: started when it is made, it adds up phases and prints the figures at the end."""

    def __init__(self) -> None:
        self.start = time.perf_counter()
        self.spent: dict[str, float] = defaultdict(float)

    @contextmanager
    def phase(self, name: str) -> Iterator[None]:
        """Add the time of what happens inside to a phase."""
        start = time.perf_counter()
        try:
            yield
        finally:
            self.spent[name] += time.perf_counter() - start

    def report(
        self, *, program: str, version: str, element: str, solver: str, unknowns: int, iterations: int,
        centre: float, corner: float, moment: float | None = None,
    ) -> None:  # fmt: skip
        """Print the job's figures as one line of JSON; the moment is m_x at the centre."""
        figures = {
            "program": program,
            "version": version,
            "element": element,
            "solver": solver,
            "unknowns": unknowns,
            "total [s]": time.perf_counter() - self.start,
            "phases [s]": dict(self.spent),
            "iterations": iterations,
            "settlement at the centre [m]": centre,
            "settlement at the corner [m]": corner,
            **({} if moment is None else {"moment at the centre [N]": abs(moment)}),
            "peak memory [MiB]": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
        }
        # a line of its own, after whatever the program has printed without an end of line
        sys.stdout.write("\n" + json.dumps(figures) + "\n")


def run(solve: Callable[..., None]) -> None:
    """Call a peer's function with the number of unknowns and what else stands in the command line."""
    solve(int(sys.argv[1]), *sys.argv[2:])
