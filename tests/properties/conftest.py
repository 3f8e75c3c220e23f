"""What tests of properties share."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from copy import deepcopy
from typing import Any

import numpy as np
import pytest

from groundslab.meshing import gmsh
from groundslab.meshing.cells import Cells

#: So many meshes are kept, which is more than any one example makes.
KEPT = 20


@pytest.fixture(autouse=True, scope="session")
def same_meshes() -> Iterator[None]:
    """Let Gmsh mesh each plan once.

    Of several ways to join triangles it takes one by their addresses in memory, so that two meshes of the same plan may
    differ in the places and numbers of single nodes. Results on them cannot be held to each other node by node.
    """
    made: dict[str, Cells] = {}
    cells_of = gmsh.cells_of

    def once(*arguments: Any, **options: Any) -> Cells:
        with np.printoptions(threshold=sys.maxsize, floatmode="unique"):
            key = repr((arguments, options))
        if key not in made:
            made[key] = cells_of(*arguments, **options)
            if len(made) > KEPT:
                del made[next(iter(made))]
        return deepcopy(made[key])

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(gmsh, "cells_of", once)
        yield
