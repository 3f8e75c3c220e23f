"""What is compared: figures of a plate, fields at its Gauss points, and curves along the axes through one place."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array
from groundslab.fem.mesh import Mesh, MeshLocations, interpolate, locate
from groundslab.fem.shape_functions import derivatives, gauss, q9_values
from groundslab.results.fields import PLATE_FIELDS
from groundslab.results.plate_result import PlateResult

Place = tuple[float, float]

#: Fields that are compared over the whole plate. The continuum's pressure is none of them: it grows without a limit
#: towards the edges, and so does the mean of its square.
COMPARED_FIELDS = ("settlement", "moment_x", "moment_y")
#: Fields along lines.
CURVE_FIELDS = ("settlement", "moment_x", "moment_y", "pressure")
#: Samples along a line, and how far from the plate's bounds its ends are, as a share of its length.
CURVE_SAMPLES, INSIDE = 161, 1e-6
#: The pressure that is exceeded on this share of the plate's area hardly depends on the mesh, as the largest one does.
EXCEEDED = 0.05


@dataclass(frozen=True, slots=True)
class Figure:
    """A figure of a plate: what it is called, the field that it belongs to (none for a share), its value in SI."""

    label: str
    field: str | None
    value: Callable[[PlateResult], float]

    @property
    def unit(self) -> tuple[str, float]:
        """Return the unit of display and the factor to it."""
        return ("%", 100.0) if self.field is None else (PLATE_FIELDS[self.field].unit, PLATE_FIELDS[self.field].scale)


def _mean_settlement(plate: PlateResult) -> float:
    return float(plate.area @ plate.settlement / plate.area.sum())


def _exceeded_pressure(plate: PlateResult) -> float:
    return float(np.quantile(plate.pressure, 1 - EXCEEDED, weights=plate.area, method="inverted_cdf"))


#: The figures that are compared, by their names in files.
FIGURES: dict[str, Figure] = {
    "largest_settlement": Figure("settlement w, largest", "settlement", lambda plate: plate.settlement.max()),
    "smallest_settlement": Figure("settlement w, smallest", "settlement", lambda plate: plate.settlement.min()),
    "mean_settlement": Figure("settlement w, mean", "settlement", _mean_settlement),
    "differential_settlement": Figure("settlement w, difference", "settlement", lambda plate: np.ptp(plate.settlement)),
    "largest_moment_x": Figure("moment m_x, largest", "moment_x", lambda plate: plate.moment_x.max()),
    "smallest_moment_x": Figure("moment m_x, smallest", "moment_x", lambda plate: plate.moment_x.min()),
    "largest_moment_y": Figure("moment m_y, largest", "moment_y", lambda plate: plate.moment_y.max()),
    "smallest_moment_y": Figure("moment m_y, smallest", "moment_y", lambda plate: plate.moment_y.min()),
    "largest_pressure": Figure("pressure p, largest", "pressure", lambda plate: plate.pressure.max()),
    "exceeded_pressure": Figure("pressure p, above on 5 %", "pressure", _exceeded_pressure),
    "contact_share": Figure("area in contact", None, lambda plate: plate.contact_share),
}


def figures_of(plate: PlateResult) -> dict[str, float]:
    """Return the figures of a plate by their names, in SI units."""
    return {name: float(figure.value(plate)) for name, figure in FIGURES.items()}


@dataclass(frozen=True, slots=True)
class Samples:
    """Gauss points of a plate's elements: places (p, 2) [m], and the root of each one's share of the area (p,)."""

    places: Array
    weights: Array


def gauss_points(plate: PlateResult) -> Samples:
    """Return the 2 x 2 Gauss points of all elements."""
    points, weights = gauss(2)
    xy = plate.nodes[plate.elements]
    area = (derivatives(points, xy)[2] * weights).ravel()
    places = np.einsum("pa,max->mpx", q9_values(points), xy).reshape(-1, 2)
    return Samples(places, np.sqrt(area / area.sum()))


def sample(plate: PlateResult, field: str, places: Array) -> Array:
    """Return a nodal field at places (p, 2) [m], NaN beside the plate."""
    mesh = Mesh(plate.nodes, plate.elements)
    return sample_within(mesh, getattr(plate, field), locate(mesh, places))


def sample_within(mesh: Mesh, values: Array, where: MeshLocations) -> Array:
    """Return nodal values (n,) of a mesh at places that were located in it, NaN beside it."""
    return np.where(where[0] < 0, np.nan, interpolate(mesh, values, where))


def rms_differences(plate: PlateResult, reference: PlateResult, samples: Samples) -> dict[str, float]:
    """Return the root of the mean square of the difference of each field, over the reference's largest value."""
    differences, meshes = {}, [Mesh(side.nodes, side.elements) for side in (plate, reference)]
    located = [locate(mesh, samples.places) for mesh in meshes]
    for field in COMPARED_FIELDS:
        fields = (getattr(side, field) for side in (plate, reference))
        sampled, wanted = map(sample_within, meshes, fields, located)
        difference = sampled - wanted
        largest = float(np.abs(getattr(reference, field)).max())
        differences[field] = float(np.linalg.norm(np.nan_to_num(difference) * samples.weights)) / (largest or 1.0)
    return differences


def axis_places(plate: PlateResult, place: Place) -> dict[str, Array]:
    """Return places (p, 2) [m] along x and along y through one place, from edge to edge of the plate."""
    low, high = plate.nodes.min(axis=0), plate.nodes.max(axis=0)
    margin = INSIDE * (high - low)
    places = {}
    for axis, name in enumerate("xy"):
        points = np.tile(np.array(place), (CURVE_SAMPLES, 1))
        points[:, axis] = np.linspace(low[axis] + margin[axis], high[axis] - margin[axis], CURVE_SAMPLES)
        places[name] = points
    return places


def curve(plate: PlateResult, field: str, places: Array) -> tuple[float | None, ...]:
    """Return a nodal field at places (p, 2) [m], None beside the plate."""
    return tuple(None if np.isnan(value) else value for value in sample(plate, field, places).tolist())
