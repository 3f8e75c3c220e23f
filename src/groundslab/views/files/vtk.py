"""Plate and ground as VTU files (for ParaView): nine-node cells, array names that carry their units.

They are VTK's unstructured grids in XML, their data in compressed blocks.
"""

from __future__ import annotations

import base64
import html
import sys
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.design.demands.design_moments import derive_fields, fields_of
from groundslab.errors import GroundslabError
from groundslab.fem.mesh import in_space
from groundslab.geometry.nearest import nearest_of_same
from groundslab.results.fields import ELEMENT_FIELDS, PLATE_FIELDS, POINT_FIELDS, RANGED_FIELDS

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    from numpy.typing import NDArray

    from groundslab.arrays import Array, Integers
    from groundslab.results.results import CombinationResult, Results

#: VTK's numbers of cells by how many nodes they have: lines, and biquadratic quadrilaterals, in our order of nodes.
CELLS = {2: 3, 9: 28}
#: Bytes that are compressed at a time, and zlib's level: with higher ones files are hardly smaller.
BLOCK, LEVEL = 2**20, 1


@dataclass(frozen=True, slots=True)
class Grid:
    """Biquadratic quadrilaterals, or lines, at z = 0 with data."""

    nodes: Array  # (n, 2)
    elements: Integers  # (m, 9), or (m, 2)
    point_data: Mapping[str, NDArray[Any]]  # (n,) each
    cell_data: Mapping[str, NDArray[Any]]  # (m,) each

    def write(self, path: Path) -> None:
        """Write a VTU file."""
        m, count = self.elements.shape
        cells: dict[str, NDArray[Any]] = {
            "connectivity": self.elements.ravel(),
            "offsets": count * np.arange(1, m + 1),
            "types": np.full(m, CELLS[count], dtype=np.uint8),
        }
        parts: dict[str, Mapping[str, NDArray[Any]]] = {
            "Points": {"Points": in_space(self.nodes)},
            "Cells": cells,
            "PointData": self.point_data,
            "CellData": self.cell_data,
        }
        order = "LittleEndian" if sys.byteorder == "little" else "BigEndian"
        with path.open("wb") as file:
            file.write(
                f'<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" byte_order="{order}" '
                'header_type="UInt64" compressor="vtkZLibDataCompressor">\n<UnstructuredGrid>\n'
                f'<Piece NumberOfPoints="{len(self.nodes)}" NumberOfCells="{m}">\n'.encode()
            )
            for part, arrays in parts.items():
                file.write(f"<{part}>\n".encode())
                for name, values in arrays.items():
                    file.writelines(_data_array(name, values))
                file.write(f"</{part}>\n".encode())
            file.write(b"</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")


def _data_array(name: str, values: NDArray[Any]) -> Iterator[bytes]:
    """Yield the pieces of an array's element: its sizes, then its blocks."""
    kind = {"f": "Float", "i": "Int", "u": "UInt"}[values.dtype.kind]
    components = f' NumberOfComponents="{values.shape[1]}"' if values.ndim == 2 else ""
    data = values.tobytes()
    blocks = [zlib.compress(data[start : start + BLOCK], LEVEL) for start in range(0, len(data), BLOCK)]
    sizes = np.array([len(blocks), BLOCK, len(data) % BLOCK, *map(len, blocks)], dtype=np.uint64)
    about = f'type="{kind}{8 * values.dtype.itemsize}" Name="{html.escape(name)}"{components} format="binary"'
    yield f"<DataArray {about}>\n".encode()
    yield base64.b64encode(sizes.tobytes())
    yield base64.b64encode(b"".join(blocks))
    yield b"\n</DataArray>\n"


def plate_mesh(results: CombinationResult) -> Grid:
    """Return the plate with its fields at nodes and elements in units of display, and flags (1 or 0) of the nodes."""
    plate = results.plate
    fields, shown = derive_fields(fields_of(plate)), RANGED_FIELDS | POINT_FIELDS
    data = {about.name: fields[name] * about.scale for name, about in shown.items()} | plate.node_data()
    cells = {
        f"{about.name} (centre, {about.averaged})": getattr(results.elements, name) * about.scale
        for name, about in ELEMENT_FIELDS.items()
        if getattr(results.elements, name) is not None
    }
    return Grid(plate.nodes, plate.elements, data, cells | {"section": results.elements.section})


def ground_mesh(results: CombinationResult) -> Grid:
    """Return the ground with the settlement of each surface, 0 being the top one, and of the plate above.

    Where no plate is, "under the plate" is 0 and "settlement of the plate" is filled with 0.
    """
    ground, plate = results.ground, results.plate
    unit = PLATE_FIELDS["settlement"]
    data = {f"settlement w_{n} [{unit.unit}]": w * unit.scale for n, w in enumerate(ground.settlement)}
    below = match(plate.nodes, ground.nodes)
    data[f"settlement of the plate [{unit.unit}]"] = settlement = np.zeros(len(ground.nodes))
    settlement[below] = plate.settlement * unit.scale
    data["under the plate"] = under = np.zeros(len(ground.nodes), dtype=np.int8)
    under[below] = 1
    return Grid(ground.nodes, ground.elements, data, {})


def write_plate(results: CombinationResult, path: Path) -> None:
    """Write the plate as a VTU file."""
    plate_mesh(results).write(path)


def write_ground(results: CombinationResult, path: Path) -> None:
    """Write the ground as a VTU file."""
    ground_mesh(results).write(path)


def beam_lines(results: CombinationResult) -> Grid:
    """Return the beams as lines with their section forces and settlement, and the number of each, from 1."""
    beams = results.beams
    fields = {
        "moment M [kNm]": ("moment", 1e-3),
        "shear force V [kN]": ("shear", 1e-3),
        "torsional moment T [kNm]": ("torsion", 1e-3),
        "axial force N [kN]": ("axial", 1e-3),
        "settlement w [mm]": ("settlement", 1e3),
    }
    data = {name: scale * np.concatenate([getattr(beam, field) for beam in beams])
            for name, (field, scale) in fields.items()}  # fmt: skip
    number = np.repeat(np.arange(1, len(beams) + 1), [len(beam.way) for beam in beams])
    way = np.concatenate([beam.way for beam in beams])
    # where section forces jump two places lie at one
    start = np.flatnonzero((number[1:] == number[:-1]) & (way[1:] > way[:-1]))
    nodes = np.concatenate([beam.nodes for beam in beams])
    return Grid(nodes, np.column_stack([start, start + 1]), data, {"beam": number[start]})


def write_beams(results: CombinationResult, path: Path) -> None:
    """Write the beams as a VTU file."""
    beam_lines(results).write(path)


def write_envelope(combined: Results, path: Path) -> None:
    """Write the envelopes over all combinations at the plate's nodes; where no area of steel is enough it is NaN."""
    from groundslab.views.tables.envelopes import fields_of_envelope

    plate = next(iter(combined.results.values())).plate
    fields = {
        name: np.where(np.isfinite(values), values, np.nan) for name, values in fields_of_envelope(combined).items()
    }
    Grid(plate.nodes, plate.elements, fields, {}).write(path)


def match(places: Array, among: Array) -> Integers:
    """Return for each of some places (k, 2) its index in ``among`` (n, 2), rounding aside."""
    if np.array_equal(places, among):
        return np.arange(len(places))
    nearest, distance = nearest_of_same(places, among)
    if distance.max(initial=0.0) > 1e-9 * np.ptp(among, axis=0).max():
        raise GroundslabError("the plate has nodes that the ground below it lacks")
    return nearest
