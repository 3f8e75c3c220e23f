"""A small case and studies of it, for tests: a slab on springs that lifts off at one end."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import groundslab
from groundslab.study.definition import files
from groundslab.study.evaluation.study import Study

CASE = """
title = "A small slab"

[plate]
length_x = "4 m"
length_y = "3 m"
thickness = "200 mm"
E = "30 GPa"
nu = 0.2

[ground]
kind = "winkler"
k = "20 MPa/m"

[[cases]]
name = "dead"

[[cases]]
name = "live"

[[loads]]
kind = "uniform"
name = "self-weight"
case = "dead"
q = "2 kPa"

[[loads]]
kind = "patch"
name = "machine"
case = "live"
q = "200 kPa"
x = ["1 m", "2 m"]
y = ["-0.5 m", "0.5 m"]

[[combinations]]
name = "service"
factors = {dead = 1.0, live = 1.0}

[[combinations]]
name = "design"
factors = {dead = 1.35, live = 1.5}

[mesh]
counts = [8, 6]
"""

#: Sampling, variables and results that belong to it.
STUDY = """
title = "The small slab"
case = "slab.toml"
seed = 3

[sampling]
kind = "monte carlo"
count = 12

[[vary]]
path = "ground.k"
name = "k"
distribution = {kind = "lognormal", mean = "20 MPa/m", cov = 0.3}

[[vary]]
path = "loads[2].q"
name = "machine"
times = true
distribution = {kind = "normal", mean = 1.0, std = 0.2}

[[keep]]
of = "settlement"
take = "largest"

[[keep]]
of = "in contact"
combination = "service"

[[keep]]
of = "settlement"
take = "everywhere"
combination = "service"

[[limit_state]]
name = "serviceability"
keep = "largest settlement"
at_most = "8 mm"
"""


def write(folder: Path, study: str = STUDY, case: str = CASE) -> Path:
    """Write a case and a study of it into a folder and return the study's file."""
    (folder / "slab.toml").write_text(case, encoding="utf-8")
    path = folder / "study.toml"
    path.write_text(study, encoding="utf-8")
    return path


def read(folder: Path, study: str = STUDY, case: str = CASE) -> files.StudyInput:
    """Return a study of a case as it is read from files."""
    return files.read(write(folder, study, case))


def run(folder: Path, study: str = STUDY, case: str = CASE, **options: Any) -> Study:
    """Run a study of a case in this process, with a model in place of the case if one is given."""
    model = options.pop("model", None)
    return groundslab.study(write(folder, study, case), case=model, workers=0, quiet=True, **options)
