"""Cases and results as files in the Structural Analysis Format."""

from __future__ import annotations

from pathlib import Path

from groundslab.case.saf.writing.writer import write_model
from groundslab.model.model import Model
from groundslab.results.results import CombinationResult, Results, results_of

#: Stiffnesses that differ by less than this between combinations are one.
ALIKE = 1e-3


def write_saf(case: Model | CombinationResult | Results, path: str | Path) -> tuple[str, ...]:
    """Write a case to a new file in the Structural Analysis Format (SAF), version 2.2.

    Parameters
    ----------
    case : Model, Results or CombinationResult
        The case, or its results: these give soil of Vlasov's kind its k0 and k1, the means over their combinations.
    path : str or pathlib.Path
        The file to write, a workbook (XLSX); there must be none of that name.

    Returns
    -------
    tuple of str
        What the file does not say, or in another way than the case does.

    Raises
    ------
    InputError
        If there is such a file, or it cannot be written.
    """
    if isinstance(case, Model):
        return write_model(case, path)
    results = case if isinstance(case, Results) else results_of(case)
    pairs = [
        (each.constants.k0[0], each.constants.k1[0])
        for each in results.results.values()
        if results.model.ground.kind == "vlasov" and len(each.constants.k0) == 1
    ]
    if not pairs:
        return write_model(results.model, path)
    k0, k1 = (sum(values) / len(pairs) for values in zip(*pairs, strict=True))
    left = write_model(results.model, path, (k0, k1))
    ranges = [(min(values), max(values)) for values in zip(*pairs, strict=True)]
    if all(most - least <= ALIKE * most for least, most in ranges):
        return left
    (k0_least, k0_most), (k1_least, k1_most) = ranges
    return (
        *left,
        f"ground: k0 and k1 are means over {len(pairs)} combinations, in which they are {k0_least / 1e6:.4g} to "
        f"{k0_most / 1e6:.4g} MN/m3 and {k1_least / 1e6:.4g} to {k1_most / 1e6:.4g} MN/m",
    )
