"""Force and moments of a core, as its walls bring them to the slab."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Literal

import numpy as np

from groundslab.model.loads.acting import LineForce
from groundslab.model.loads.base import Magnitude, _Load
from groundslab.model.plates.other_plates import AnyPlate
from groundslab.model.structure.cores import Core, CoreSection, check_cores, section_of
from groundslab.model.structure.walls import Wall
from groundslab.schema.fields import Quantity, Text
from groundslab.schema.issues import RelativeIssue
from groundslab.schema.section_fields import Table
from groundslab.schema.wording import quote
from groundslab.units import show


class CoreLoad(_Load):
    """Force and moments of a core, which its walls bring to the slab as a section that stays plane."""

    kind: Annotated[Literal["core"], Table("force and moments of a core, distributed over its walls")] = "core"
    core: Annotated[str, Text("core by whose walls it acts, one of [[cores]]")]
    P: Annotated[
        float,
        Quantity(
            "force",
            "P",
            "force through the center of its section, downwards positive; 0 for moments alone",
            example="4 MN",
        ),
    ]
    M_x: Annotated[
        float,
        Quantity(
            "moment",
            "M_x",
            "moment about the y axis through this center, positive if it presses the side of larger x down",
            example="900 kNm",
        ),
    ] = 0.0
    M_y: Annotated[
        float,
        Quantity(
            "moment",
            "M_y",
            "moment about the x axis through this center, positive if it presses the side of larger y down",
            example="900 kNm",
        ),
    ] = 0.0

    @property
    def magnitudes(self) -> tuple[Magnitude, ...]:
        """How large its force and its moments are."""
        return (("P", self.P, "force"), ("M_x", self.M_x, "moment"), ("M_y", self.M_y, "moment"))

    def acts_on(self, section: CoreSection) -> tuple[LineForce, ...]:
        """Return the forces along the walls of its core's section."""
        forces = section.line_forces(self.P, (self.M_x, self.M_y))
        return tuple(LineForce((part.edge,), q=q, width=part.thickness, wall=part.wall, start=part.start)
                     for part, q in forces)  # fmt: skip


def check_core_moments(
    loads: tuple[object, ...], cores: tuple[Core, ...], walls: tuple[Wall, ...], plates: tuple[AnyPlate, ...]
) -> Iterator[RelativeIssue]:
    """Find moments across cores whose walls all stand in one line; cores that are wrong have issues of their own."""
    by_name = {} if any(check_cores(cores, walls, plates)) else {core.name: core for core in cores}
    for position, load in enumerate(loads):
        if not isinstance(load, CoreLoad) or load.core not in by_name:
            continue
        left = np.abs(section_of(by_name[load.core], walls, plates).not_carried((load.M_x, load.M_y)))
        if left.any():
            place = ("loads", position, ("M_x", "M_y")[int(left.argmax())])
            across = show(float(np.hypot(*left)), "moment")
            across_core = f"{across} across core {quote(load.core)}, whose walls stand in one line"
            yield RelativeIssue(place, across_core, "a moment along them", "walls in two directions carry any moment")
