"""Random slabs with meshes that make themselves: are the values as accurate as asked for, and at how many unknowns?

    python bench/random_slabs.py                        # a hundred slabs at 2 %; hours
    python bench/random_slabs.py --slabs 10 --accuracy 5 --first 40

Slabs of several outlines with openings, zones, columns, line loads and uplift, on all kinds of ground. Each is solved
with mesh.accuracy alone. The truth is the same mesh with elements a fourth as large (half as large, where that would
have too many unknowns); the uniform mesh beside it is the coarsest of a row of sizes whose judged values are as
accurate, or the first with four times the unknowns. A line is printed for each slab, at the end the shares: of judged
values within the accuracy, of values told to be within it that are not (false), and the ratio of unknowns. All figures
go to bench/random_slabs.json, by the accuracy, from which --resume goes on with the slabs that are not yet there.
"""

from __future__ import annotations

import argparse
import json
import statistics
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from groundslab.accuracy.judgment import JudgedValue, find_largest, judge, judged_values
from groundslab.analysis import driver
from groundslab.analysis.tasks.run import Setting
from groundslab.arrays import Array
from groundslab.discretize.plan_layout import Meshes
from groundslab.errors import GroundslabError
from groundslab.fem.mesh import Mesh, locate_nearest
from groundslab.fem.shape_functions import areas, q9
from groundslab.meshing.sizing import Sources
from groundslab.model.model import Model
from groundslab.results.fields import PLATE_FIELDS
from groundslab.results.plate_result import PlateResult
from groundslab.results.results import CombinationResult

RESULTS = Path(__file__).parent / "random_slabs.json"
#: Fields that are not judged everywhere.
LIMITED = ("shear_x", "shear_y", "pressure")
#: Truth and uniform meshes have at most about so many unknowns, uniform ones so many times those of the adaptive mesh.
MOST_UNKNOWNS, MOST_RATIO = 1_500_000, 4
#: So far towards the middle of its element a node is moved to be on its side of a border.
INWARDS = 1e-6
#: Of smaller errors no ratio of told and true is taken: the truth has errors of its own.
SEEN = 1e-3
#: The coarsest uniform mesh has about so many elements on the shorter side.
COARSEST = 5
#: Of uniform meshes, each has elements so many times as large as the one before.
STEP = 2**-0.5


def random_slab(seed: int, accuracy: float) -> Model:
    """Return a slab that only its number decides."""
    rng = np.random.default_rng(seed)
    a, b = rng.uniform(8, 20), rng.uniform(6, 14)
    u, v = rng.uniform(0.35, 0.65, 2)
    outlines = {
        "rectangle": [(0, 0), (a, 0), (a, b), (0, b)],
        "L": [(0, 0), (a, 0), (a, v * b), (u * a, v * b), (u * a, b), (0, b)],
        "oblique": [(0, 0), (a, 0), (a, v * b), (u * a, b), (0, b)],
    }
    points = outlines[str(rng.choice(list(outlines)))]
    thickness = float(rng.choice([0.2, 0.3, 0.5, 0.8]))
    plate: dict[str, Any] = {
        "outline": {"kind": "polygon", "points": points},
        "thickness": thickness,
        "E": 30e9,
        "nu": 0.2,
    }
    if rng.random() < 0.3:
        x, y = 0.12 * a, 0.15 * b
        plate["openings"] = [{"kind": "rectangle", "x": (x, x + 0.1 * a), "y": (y, y + 0.12 * b)}]
    if rng.random() < 0.3:
        x = u * a * 0.5
        shape = {"kind": "rectangle", "x": (0.5 * x, 0.9 * x), "y": (0.3 * v * b, 0.9 * v * b)}
        plate["zones"] = [{"shape": shape, "thickness": 1.6 * thickness}]
    k = float(rng.uniform(10e6, 60e6))
    grounds = [
        {"kind": "winkler", "k": k},
        {"kind": "pasternak", "k0": k, "k1": float(rng.uniform(2e6, 20e6))},
        {"kind": "vlasov", "layers": [{"E": 2 * k, "nu": 0.3, "thickness": float(rng.uniform(2, 6))}]},
    ]
    loads: list[dict[str, Any]] = [{"kind": "uniform", "q": 5e3}]
    side = float(rng.choice([0.15, 0.3, 0.5]))
    for _ in range(int(rng.integers(2, 7))):
        x, y = rng.uniform(side, u * a - side), rng.uniform(side, b - side)
        while "openings" in plate and x < 0.22 * a + side and y < 0.27 * b + side:
            x, y = rng.uniform(side, u * a - side), rng.uniform(side, b - side)
        P = float(rng.uniform(0.1, 1.0)) * 2e6 * thickness
        loads.append({"kind": "point", "P": P, "x": x, "y": y, "width_x": side, "width_y": side})
    if rng.random() < 0.4:
        y = 0.5 * v * b
        loads.append({"kind": "line", "q": 30e3, "points": [(0.1 * a, y), (0.9 * a, y)]})
    if rng.random() < 0.4:
        at = {"x": 0.9 * a, "y": 0.3 * v * b, "width_x": 0.5, "width_y": 0.5}
        loads.append({"kind": "point", "P": 1e3, "M_x": 6e5 * thickness, **at})
    return Model.model_validate({
        "plate": plate,
        "ground": grounds[int(rng.integers(3))],
        "contact": {"tensionless": bool(rng.random() < 0.7)},
        "beyond": {"kind": str(rng.choice(["none", "infinite"]))},
        "loads": loads,
        "mesh": {"accuracy": accuracy},
    })  # fmt: skip


def solve_on(model: Model, sizes: Sources | None) -> CombinationResult:
    """Return the results on one mesh with elements of given sizes in places."""
    return driver.analyze(model, Setting(model, Meshes(local=sizes)), lambda _: None).only


def true_errors(results: CombinationResult, truth: CombinationResult, of_truth: list[tuple[str, JudgedValue]]) -> Array:
    """Return the errors (k,) of the judged values, each as a share of what governs.

    Fields that are not judged everywhere are steep where they begin to be: the truth is taken at the same nodes. Its
    judged values are passed, as they are asked for again and again.
    """
    values = [*judged_values(results)]
    there = [*judged_values(at_nodes_of(results, truth))]
    limited = {PLATE_FIELDS[name].label for name in LIMITED}
    exact = [b if b.label in limited else a for (_, a), (_, b) in zip(of_truth, there, strict=True)]
    largest = find_largest([truth])
    assert largest is not None
    return np.array([
        abs(value.value - true.value) / size if (size := getattr(largest, against)) > 0 else 0.0
        for (against, value), true in zip(values, exact, strict=True)
    ])  # fmt: skip


def at_nodes_of(results: CombinationResult, truth: CombinationResult) -> CombinationResult:
    """Return results whose fields that are not judged everywhere are those of the truth, at the same nodes."""
    plate, mesh = results.plate, Mesh(truth.plate.nodes, truth.plate.elements)
    element, place = locate_nearest(mesh, moved_inwards(plate))
    N = q9(place)[0]
    fields = {}
    for name in LIMITED:
        values = getattr(truth.plate, name)[mesh.elements[element]]
        # parabolas overshoot where a field has a kink, and where means over discs end
        fields[name] = (N * values).sum(axis=1).clip(values.min(axis=1), values.max(axis=1))
    return replace(results, plate=replace(plate, **fields))


def moved_inwards(plate: PlateResult) -> Array:
    """Return the nodes (n, 2) of a plate, each a little way towards an element that has it.

    A node may stand on one side of a border.
    """
    owner = np.empty(len(plate.nodes), dtype=np.int64)
    owner[plate.elements] = np.arange(len(plate.elements))[:, None]
    moved: Array = plate.nodes + INWARDS * (plate.nodes[plate.elements[owner, 8]] - plate.nodes)
    return moved


def examine(seed: int, accuracy: float) -> dict[str, Any]:
    """Return what came out for one slab."""
    model = random_slab(seed, accuracy)
    start = time.perf_counter()
    found = driver.solve(model).only
    seconds = time.perf_counter() - start
    xy = found.plate.nodes[found.plate.elements]
    factor = 4 if 16 * found.unknowns <= MOST_UNKNOWNS else 2
    truth = solve_on(model, (xy[:, 8], np.sqrt(areas(xy)) / factor))
    of_truth = [*judged_values(truth)]
    errors = true_errors(found, truth, of_truth)
    told = {each.value: each.share for each in judge(found)}
    shares = np.array([told.get(each.value, 0.0) for _, each in judged_values(found)])
    wanted = max(accuracy, float(errors.max()))
    uniform, size = 0, min(model.plate.sides) / COARSEST
    while not uniform:
        size *= STEP
        other = solve_on(model.replace(mesh=model.mesh.replace(size=size)), None)
        if true_errors(other, truth, of_truth).max() <= wanted or other.unknowns > min(
            MOST_UNKNOWNS, MOST_RATIO * found.unknowns
        ):
            uniform = other.unknowns
    return {
        "seed": seed, "unknowns": found.unknowns, "uniform": uniform, "seconds": round(seconds, 1),
        "factor": factor, "true": errors.round(5).tolist(), "told": shares.round(5).tolist(),
    }  # fmt: skip


def summarize(rows: list[dict[str, Any]], accuracy: float) -> str:
    """Return the shares over all slabs."""
    true, told = (np.concatenate([row[name] for row in rows]) for name in ("true", "told"))
    within, false = true <= accuracy, (told <= accuracy) & (true > accuracy)
    ratio = statistics.median(row["uniform"] / row["unknowns"] for row in rows)
    seen = true > SEEN
    low, middle, high = np.quantile(told[seen] / true[seen], (0.1, 0.5, 0.9)) if seen.any() else (np.nan,) * 3
    return (
        f"{len(rows)} slabs, {len(true)} values: {100 * within.mean():.1f} % within {100 * accuracy:g} %, "
        f"{100 * false.mean():.1f} % false, uniform mesh / adaptive: median {ratio:.1f} times the unknowns; "
        f"told / true of the {seen.sum()} errors above {100 * SEEN:g} %: {low:.2g} for one in ten, "
        f"median {middle:.2g}, {high:.2g} for nine in ten"
    )


def main() -> None:
    """Examine slabs and print what came out."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--slabs", type=int, default=100, help="how many (100)")
    parser.add_argument("--first", type=int, default=0, help="number of the first one (0)")
    parser.add_argument("--accuracy", type=float, default=2.0, help="in percent (2)")
    parser.add_argument("--resume", action="store_true", help="go on where an interrupted run stopped")
    given = parser.parse_args()
    accuracy, known = given.accuracy / 100, {}
    if RESULTS.exists():
        known = json.loads(RESULTS.read_text(encoding="utf-8"))
    rows = known.get(f"{given.accuracy:g} %", []) if given.resume else []
    done = {row["seed"] for row in rows}
    for seed in (each for each in range(given.first, given.first + given.slabs) if each not in done):
        try:
            row = examine(seed, accuracy)
        except GroundslabError as error:
            print(f"{seed}: {' '.join(str(error).split())}", flush=True)
            continue
        rows.append(row)
        print(
            f"{seed}: {row['unknowns']} unknowns, {row['seconds']} s, uniform {row['uniform']}, largest error "
            f"{100 * max(row['true']):.2g} %, told {100 * max(row['told']):.2g} %",
            flush=True,
        )
        found = known | {f"{given.accuracy:g} %": rows}
        RESULTS.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    if rows:
        print(summarize(rows, accuracy))


if __name__ == "__main__":
    main()
