"""Envelopes: the extremes of one array over named combinations, and which combination each of them comes from."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.errors import InputError, Issue


@dataclass(frozen=True, slots=True)
class Envelope:
    """The extremes of arrays of one shape, entry by entry, in the arrays' unit."""

    names: tuple[str, ...]  # of the combinations, in the order given
    greatest: Array
    least: Array
    greatest_by: Integers  # index into names, of the first combination that has the greatest value
    least_by: Integers


def envelope(combinations: Mapping[str, Array]) -> Envelope:
    """Return the envelope of arrays of one shape, by the names of their combinations.

    An envelope of moments m_x and one of m_xy do not belong together: for design moments take the envelope of the
    design moments of each combination.
    """
    names = tuple(combinations)
    if not names:
        raise InputError([Issue("combinations", "none", "at least one combination")])
    arrays = [np.asarray(values, dtype=float) for values in combinations.values()]
    issues = [
        Issue(f"combinations[{name!r}]", f"an array of shape {array.shape}", f"{arrays[0].shape}, as {names[0]!r} has")
        for name, array in zip(names, arrays, strict=True)
        if array.shape != arrays[0].shape
    ]
    issues += [
        Issue(f"combinations[{name!r}]", "values that are not numbers", "finite numbers")
        for name, array in zip(names, arrays, strict=True)
        if not np.isfinite(array).all()
    ]
    if issues:
        raise InputError(issues)
    values = np.stack(arrays)
    return Envelope(names, values.max(axis=0), values.min(axis=0), values.argmax(axis=0), values.argmin(axis=0))
