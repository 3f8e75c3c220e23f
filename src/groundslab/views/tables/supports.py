"""The tables of supports and of joints: what each carries."""

from __future__ import annotations

import numpy as np

from groundslab.design.demands.support_forces import stiffness_alone, utilization
from groundslab.design.rules.combinations import solved_results
from groundslab.model.supports import AnySupport
from groundslab.results.records import JointResult, SupportResult
from groundslab.results.results import CombinationResult, Results
from groundslab.views.tables.table import Cell, Table, table_of


def support_table(combined: Results) -> Table:
    """Return force, settlement, stiffness, use of the limit and moments of each support in each combination."""
    heads = [
        ("combination", ""), ("support", ""), ("kind", ""), ("force", "kN"), ("length", "m"),
        ("least force per length", "kN/m"), ("greatest force per length", "kN/m"),
        ("least settlement", "mm"), ("greatest settlement", "mm"), ("stiffness alone", "MN/m"),
        ("force over settlement", "MN/m"), ("limit", ""), ("unit of the limit", ""), ("force over limit", ""),
        ("moment M_x", "kNm"), ("moment M_y", "kNm"),
    ]  # fmt: skip
    rows = [
        [results.combination, support.name, described.kind, *_figures(results, support, described)]
        for results in solved_results(combined)
        for support, described in zip(results.supports, combined.model.supports, strict=True)
    ]
    notes = (
        "Forces on the plate, positive upwards. Forces per length are nodal forces divided by their share of the "
        "line; at ends and corners of rigid lines they grow as the mesh is refined.",
        "The stiffness alone is the one given, for a pile that of Randolph and Wroth in its soil; the force over the "
        "mean settlement also includes the effects of neighbors, the ground between them and yielding.",
        "Moments are those with which the support restrains the plate's rotation, summed over its nodes, positive if "
        "they press the side of larger x (M_x, about the y axis) or y (M_y, about the x axis) down; they exclude the "
        "lever arms of its forces.",
    )
    return table_of("supports", "Supports", heads, rows, notes)


def _figures(results: CombinationResult, support: SupportResult, described: AnySupport) -> list[Cell]:
    """Return the figures of a support, in the order of the table."""
    if not len(support.nodes):
        return [support.total / 1e3, *[None] * 12]
    w = support.settlement * 1e3
    on_line = support.length > 0
    per_length = support.force[on_line] / support.length[on_line] / 1e3
    along: list[Cell] = [None, None, None]
    if described.kind == "line" and len(per_length) > 0:
        along = [support.length.sum(), per_length.min(), per_length.max()]
    moments = support.moment_x.sum() / 1e3, support.moment_y.sum() / 1e3
    return [support.total / 1e3, *along, w.min(), w.max(), *_stiffness(results, support, described),
            *_limit(support, described), *moments]  # fmt: skip


def _stiffness(results: CombinationResult, support: SupportResult, described: AnySupport) -> list[Cell]:
    """Return the stiffness of a support alone, and its force over its mean settlement [MN/m]."""
    alone = stiffness_alone(results, described, support)
    if alone is None:
        return [None, None]
    w = float(support.settlement.mean())
    return [alone / 1e6, support.total / w / 1e6 if w else None]


def _limit(support: SupportResult, described: AnySupport) -> list[Cell]:
    """Return the limit that a support is nearest to, its unit, and the force over it."""
    used = utilization(described, support)
    if used is None:
        return [None, None, None]
    return [used.limit / 1e3, "kN/m" if described.kind == "line" else "kN", used.share]


def joint_table(combined: Results) -> Table:
    """Return the shear that each joint carries in each combination, and the difference of settlement across it."""
    heads = [
        ("combination", ""), ("joint", ""), ("force", "kN"), ("length", "m"),
        ("greatest force per length", "kN/m"), ("x of it", "m"), ("y of it", "m"), ("greatest step", "mm"),
    ]  # fmt: skip
    rows = [
        [results.combination, joint.name, *_joint_figures(joint)]
        for results in solved_results(combined)
        for joint in results.joints
    ]
    notes = (
        "The force from the first plate of a joint to its second one, positive if it presses the second one down. The "
        "force per length is that of the largest size; a step is the first plate's settlement less the second one's.",
    )
    return table_of("joints", "Joints", heads, rows, notes)


def _joint_figures(joint: JointResult) -> list[Cell]:
    """Return the figures of a joint, in the order of the table."""
    q = joint.force / joint.length
    most = int(np.argmax(np.abs(q)))
    x, y = joint.nodes[most]
    largest = float(joint.step[np.argmax(np.abs(joint.step))])
    return [joint.total / 1e3, float(joint.length.sum()), q[most] / 1e3, float(x), float(y), largest * 1e3]
