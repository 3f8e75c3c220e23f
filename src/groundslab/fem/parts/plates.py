"""The plates of a problem: their elements, sections and edges."""

from __future__ import annotations

from dataclasses import dataclass

from groundslab.arrays import Array, Integers
from groundslab.fem.cracked_section import CrackedSections
from groundslab.fem.plate import PlateElement


@dataclass(frozen=True, slots=True)
class Plates:
    """All plates on a mesh, mp elements together."""

    elements: Integers  # (mp,): of the mesh
    nodes: Integers  # (np,), ascending
    element: PlateElement  # the kind of all
    bending: Array  # (k, 3, 3) [N m]: rigidities of the sections, or of the elements where these have cracked
    shear: Array  # (k,) [N/m]
    membrane: Array  # (sections, 3, 3) [N/m]: rigidities in their plane; none where no plate has u and v
    rigidity: Integers  # (mp,): which of bending and shear each element has
    section: Integers  # (mp,): number of each element's section: 0 outside all zones, else the zone's, from 1
    number: Integers  # (mp,): which of several plates it belongs to
    names: tuple[str, ...]  # of the plates
    thickness: Array  # (mp,) [m]
    edges: Integers  # (b, 3): sides of the plates' edges, openings' too; the plate lies to the left
    cracking: CrackedSections | None = None  # how elements crack, if they do
    stiffness: Array | None = None  # (mp, 2) [N m2/m]: of elements that have cracked, along x and y
