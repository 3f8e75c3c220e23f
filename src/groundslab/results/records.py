"""What an analysis records besides the fields: supports, joints, beams, bases, constants, steps, the certificate."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Literal

import numpy as np

if TYPE_CHECKING:
    from groundslab.arrays import Array

#: Places along a beam as close as this share of its length are one.
SAME = 1e-9
#: Into so many parts each step between a beam's places is divided, to find what is largest.
PARTS = 4


@dataclass(frozen=True, slots=True)
class SupportResult:
    """A support: what it carries at each of its k nodes, one for a point.

    Attributes
    ----------
    name : str
        Name of the support, or its number.
    nodes : (k, 2) array of float
        Coordinates of its nodes [m].
    length : (k,) array of float
        The share of the line that belongs to each node [m]; 0 for a point.
    settlement : (k,) array of float
        Settlement of the plate there [m].
    force : (k,) array of float
        Force on the plate [N], upwards positive.
    moment_x, moment_y : (k,) array of float
        Moments on the plate [N m], positive if they press the side of larger x (or y) down.
    """

    name: str
    nodes: Array
    length: Array
    settlement: Array
    force: Array
    moment_x: Array
    moment_y: Array

    @property
    def total(self) -> float:
        """The sum of the forces [N], upwards positive."""
        return float(self.force.sum())


@dataclass(frozen=True, slots=True)
class LargestValues:
    """The largest size of each quantity over all combinations, against which discretization errors are judged.

    Attributes
    ----------
    displacement : float
        The largest settlement, uplift or gap [m].
    moment : float
        The largest principal moment [N m/m].
    shear : float
        The largest shear force in any direction [N/m], where shear forces are judged.
    pressure : float
        The largest contact pressure [Pa], where pressures are judged.
    support : float
        The largest force of a support [N].
    beam_moment, beam_shear : float
        The largest bending moment [N m], and the largest shear force [N], of a beam.
    """

    displacement: float
    moment: float
    shear: float
    pressure: float
    support: float
    beam_moment: float = 0.0
    beam_shear: float = 0.0

    @property
    def share(self) -> float:
        """The whole, against which the error of a share is judged."""
        return 1.0


@dataclass(frozen=True, slots=True)
class JointResult:
    """A joint of two plates: what it carries at each of the k places along its line.

    Attributes
    ----------
    name : str
        Name of the joint, or those of its plates.
    nodes : (k, 2) array of float
        Coordinates of the places [m].
    length : (k,) array of float
        The share of the line that belongs to each of them [m].
    step : (k,) array of float
        Settlement of the first plate less that of the second one [m].
    force : (k,) array of float
        Force from the first plate to the second one [N], positive if it presses the second one down.
    """

    name: str
    nodes: Array
    length: Array
    step: Array
    force: Array

    @property
    def total(self) -> float:
        """The sum of the forces [N], positive if they press the second plate down."""
        return float(self.force.sum())


@dataclass(frozen=True, slots=True)
class BeamResult:
    """A beam: its section forces at k places along it, from its start to its end; twice at places where they jump.

    Attributes
    ----------
    name : str
        Name of the beam.
    nodes : (k, 2) array of float
        Coordinates of the places [m].
    way : (k,) array of float
        Where they lie along the beam, from its start [m].
    settlement : (k,) array of float
        Settlement of beam and plate there [m].
    moment : (k,) array of float
        Bending moment M about the plate's middle plane [N m], positive where the beam sags; that of a rib includes the
        couple of the axial forces in rib and flange. About the beam's own axis it is M - e N.
    shear : (k,) array of float
        Shear force V [N] of the section that has M: dM/ds, along an axis that curves by alpha,s less T alpha,s. What
        passes from the plate into the beam is in it.
    torsion : (k,) array of float
        Torsional moment T [N m]: -G J times the twist, which is positive if what lies to the left turns down along it.
    axial : (k,) array of float
        Axial force N [N], tension positive; 0 of a beam that is not eccentric.
    eccentricity : (k,) array of float
        How far its axis lies below the plate's middle plane [m].
    own_shear : (k,) array of float
        Shear force that the beam by itself carries across a cut through beam and plate [N], which the plate's own
        shear forces add to; of walls and over openings the same as V.
    """

    name: str
    nodes: Array
    way: Array
    settlement: Array
    moment: Array
    shear: Array
    torsion: Array
    axial: Array
    eccentricity: Array
    own_shear: Array

    @property
    def closed(self) -> bool:
        """Whether it ends where it starts."""
        return bool(np.array_equal(self.nodes[0], self.nodes[-1]))

    def between_ends(self, distance: float) -> BeamResult:
        """Return its part between places so far [m] from its ends, a quarter of the length of a short one.

        With places between its own, so that its largest values do not depend on where these are. A closed beam has no
        ends.
        """
        length = float(self.way[-1])
        low = 0.0 if self.closed else min(distance, length / 4)
        pieces = np.flatnonzero(np.diff(self.way) > SAME * length)
        steps = self.way[pieces, None] + np.diff(self.way)[pieces, None] * (np.arange(PARTS + 1) / PARTS)
        # a place at which it goes on smoothly stands once
        first = np.append(True, np.diff(pieces) > 1)
        ways = steps[np.column_stack([first, np.ones((len(pieces), PARTS), dtype=bool)])]
        inside = ways[(ways > low + SAME * length) & (ways < length - low - SAME * length)]
        return self.at(np.concatenate([[low], inside, [length - low]]))

    def at(self, ways: Array) -> BeamResult:
        """Return it at other places along it.

        Between two of its own places each value follows the parabolas through these and the next one on either side,
        of which the nearer counts more; none reaches over a jump.

        Parameters
        ----------
        ways : (k,) array of float
            How far they lie from its start [m], in order. Of a place that stands twice the first has the values before
            it, the second those after it; one that stands alone has those after it.

        Returns
        -------
        BeamResult
            The same beam at these places alone.

        Examples
        --------
        >>> import numpy as np
        >>> from groundslab.results.records import BeamResult
        >>> way, none = np.array([0.0, 1.0, 3.0, 4.0]), np.zeros(4)
        >>> nodes = np.column_stack([way, none])
        >>> span = BeamResult("span", nodes, way, none, way * (4 - way), 4 - 2 * way, none, none, none, none)
        >>> span.at(np.array([2.0])).moment
        array([4.])
        """
        x, near = self.way, SAME * self.way[-1]
        side = np.where(np.append(np.diff(ways) <= near, False), -near, near)
        i = np.clip(np.searchsorted(x, ways + 2 * side) - 1, 0, len(x) - 2)
        step = np.diff(x)
        jumps = step <= near
        step = np.where(jumps, 1.0, step)
        # of each place but the ends: whether a parabola goes through it and those beside it, and its curvature's half
        smooth = ~(jumps[:-1] | jumps[1:])
        smooth, wide = np.pad(smooth, 1), np.pad(step[:-1] + step[1:], 1, constant_values=1.0)
        part = np.clip((ways - x[i]) / step[i], 0.0, 1.0)
        weights = np.stack([(1 - part) * smooth[i], part * smooth[i + 1]])
        weights /= np.maximum(weights.sum(axis=0), np.finfo(float).tiny)

        def of(values: Array) -> Array:
            slope = (np.diff(values, axis=0).T / step).T
            bent = (np.pad(np.diff(slope, axis=0), [(1, 1)] + [(0, 0)] * (values.ndim - 1)).T / wide).T
            curved = (weights[0] * bent[i].T + weights[1] * bent[i + 1].T) * part * (part - 1) * step[i] ** 2
            interpolated: Array = values[i] + ((part * step[i]) * slope[i].T + curved).T
            return interpolated

        return BeamResult(self.name, *(of(getattr(self, field.name)) for field in fields(self)[1:]))


@dataclass(frozen=True, slots=True)
class BaseResult:
    """A base of the building above: how it moves, and what that changes of its load, of k = 1 place.

    Attributes
    ----------
    name : str
        Name of the column or wall.
    nodes : (k, 2) array of float
        Coordinates of its middle [m].
    settlement : (k,) array of float
        Mean settlement of its footprint [m].
    slope_x, slope_y : (k,) array of float
        Mean slopes of its footprint along x and y [rad]; 0 of a building whose stiffness has settlements alone.
    force : (k,) array of float
        What the building's stiffness adds to its load [N], downwards positive.
    moment_x, moment_y : (k,) array of float
        What it adds to its moments [N m], positive if they press the side of larger x (or y) down.
    by_storeys : (k, s) array of float
        What the lowest 1, 2, .. s storeys alone would add to its load [N], with the contact as it is and the ground as
        in the first combination with that contact; none (s = 0) where that is not known.
    """

    name: str
    nodes: Array
    settlement: Array
    slope_x: Array
    slope_y: Array
    force: Array
    moment_x: Array
    moment_y: Array
    by_storeys: Array


#: Share of the walls' stiffness, and of fields of the plate their least and greatest values with it.
WallLimit = tuple[float, tuple[tuple[str, float, float], ...]]


@dataclass(frozen=True, slots=True)
class Constants:
    """The ground's constants that the analysis ended with, from the top layer downwards.

    Attributes
    ----------
    k0 : tuple of float
        Stiffness of each layer against compression [Pa/m].
    k1 : tuple of float
        Stiffness of each layer against shear [Pa m].
    gamma : float or None
        Decay of the mode over the depth; None if the ground has no such mode.
    gamma_iterations : int
        Iterations that gamma took.
    decay : float or None
        Decay of the settlement over the plan [1/m], which all columns of soil have in common: the root of
        int |grad w|^2 / int w^2. None if gamma is None.
    limit_depth : float or None
        Depth below which nothing settles [m], where it follows from the stresses. None if all layers count.
    """

    k0: tuple[float, ...]
    k1: tuple[float, ...]
    gamma: float | None
    gamma_iterations: int
    decay: float | None = None
    limit_depth: float | None = None


@dataclass(frozen=True, slots=True)
class Step:
    """One step of the convergence history.

    Attributes
    ----------
    unknowns : int
        Unknowns of the mesh that the step ran on.
    increment : int
        Increment of the load, from 1.
    gamma : float or None
        Decay of the mode of the ground.
    iteration : int
        Iteration of the contact, from 1.
    in_contact : int
        Nodes in contact; on an elastic continuum cells of pressure.
    changed : int
        Those that open or close after this step.
    finest : bool
        Whether this is the finest mesh, whose results are kept.
    """

    unknowns: int
    increment: int
    gamma: float | None
    iteration: int
    in_contact: int
    changed: int
    finest: bool


#: Why a mesh was not refined: its errors are small enough, they fall no more, the next one would be too large, or
#: meshes enough were made. One that is provisional was refined, or was to be.
MeshEnd = Literal["provisional", "accurate", "no progress", "max_unknowns", "most meshes"]


@dataclass(frozen=True, slots=True)
class MeshHistory:
    """The meshes that were made for an accuracy, of which the last one is that of the results.

    Attributes
    ----------
    unknowns : tuple of int
        The number of unknowns on each of them; of several combinations first on the coarse one without errors.
    end : {"provisional", "accurate", "no progress", "max_unknowns", "most meshes"}
        Why the last one was not refined; of provisional results it was, or was to be.
    needed : int or None
        The `mesh.max_unknowns` that the next mesh would take, where it was this bound that ended the refinement.
    before : tuple of (str, float)
        Errors of the judged values on the mesh before the last one, by their names, as shares of what governs.
    """

    unknowns: tuple[int, ...]
    end: MeshEnd = "provisional"
    needed: int | None = None
    before: tuple[tuple[str, float], ...] = ()


@dataclass(frozen=True, slots=True)
class Certificate:
    """How well a result satisfies equilibrium and contact conditions, computed independently of the solver's matrices.

    All figures but load and reaction are ratios. Of several load increments the worst counts.

    Attributes
    ----------
    residual : float
        Largest unbalanced force at a node, over the largest nodal force.
    load, reaction : float
        Sum of the loads on the plate, and of the contact forces and the supports' reactions [N].
    force_balance : float
        Difference of load and reaction, over the sum of the loads' sizes.
    moment_balance : float
        The same for the moments about both axes, over load size times plate size.
    ground_balance : float
        Contact forces and loads beside the plate against what the ground carries down and out, over the load size.
    worst_gap : float
        Largest violation of gap >= 0, over the largest settlement.
    worst_pressure : float
        Largest violation of pressure >= 0, over the largest nodal contact force.
    worst_product : float
        Largest pressure times gap, over largest contact force times largest settlement.
    gamma_change : float
        Relative change of gamma in the last step.
    margin_effect : float or None
        Infinite ground only: largest change of the settlement with a wider meshed margin, over the largest settlement.
    section_law : float or None
        Plates that crack only: largest difference between a moment and the one that the section's law gives for its
        curvature, over the largest moment.
    ground_load : float
        Sum of the loads on the ground beside the plate [N].
    joint_mismatch : float or None
        Joined plates only: largest difference of settlement across hinges, and of the ground's surface across joints,
        where there should be none, over the largest settlement.
    """

    residual: float
    load: float
    reaction: float
    force_balance: float
    moment_balance: float
    ground_balance: float
    worst_gap: float
    worst_pressure: float
    worst_product: float
    gamma_change: float
    margin_effect: float | None
    section_law: float | None = None
    ground_load: float = 0.0
    joint_mismatch: float | None = None

    TOLERANCE = 1e-6
    MARGIN_TOLERANCE = 0.01
    LAW_TOLERANCE = 1e-3
    JOINT_TOLERANCE = 1e-4

    @property
    def holds(self) -> bool:
        """Whether no figure exceeds its limit."""
        return not self.too_large()

    def too_large(self) -> dict[str, float]:
        """Return the figures that exceed their limits, NaN included.

        Returns
        -------
        dict of str to float
            The figures by name.
        """
        figures, limits = self.limited(), self.limits()
        return {name: value for name, value in figures.items() if not value <= limits[name]}

    def limited(self) -> dict[str, float]:
        """Return the figures that have a limit.

        Returns
        -------
        dict of str to float
            The figures by name.
        """
        others = {name: getattr(self, name) for name in ("margin_effect", "section_law", "joint_mismatch")}
        return self.must_vanish() | {name: value for name, value in others.items() if value is not None}

    def limits(self) -> dict[str, float]:
        """Return the limit of each figure that has one.

        Returns
        -------
        dict of str to float
            The limits by name.
        """
        others = {
            "margin_effect": self.MARGIN_TOLERANCE,
            "section_law": self.LAW_TOLERANCE,
            "joint_mismatch": self.JOINT_TOLERANCE,
        }
        return dict.fromkeys(self.must_vanish(), self.TOLERANCE) | others

    def must_vanish(self) -> dict[str, float]:
        """Return the figures that are zero for an exact solution.

        Returns
        -------
        dict of str to float
            The figures by name.
        """
        others = ("load", "reaction", "ground_load", "margin_effect", "section_law", "joint_mismatch")
        return {field.name: getattr(self, field.name) for field in fields(self) if field.name not in others}
