"""Thick plates on layered, two-parameter, tensionless ground.

    import groundslab

    model = groundslab.load("case.toml")
    results = groundslab.solve(model)

The public names load when they are first used, so that importing the package costs nothing.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from groundslab import study
    from groundslab.analysis import solve, solve_combinations
    from groundslab.casefile import load
    from groundslab.errors import (
        GroundslabError,
        IllConditioned,
        InputError,
        NeutralEquilibrium,
        NoEquilibrium,
        NotCertified,
        NotConverged,
        SingularMatrix,
    )
    from groundslab.model import (
        Analysis,
        AreaLoad,
        Beyond,
        Circle,
        Contact,
        Edges,
        InterfaceLayer,
        Layered,
        LineLoad,
        Mesh,
        Model,
        Pasternak,
        PatchLoad,
        Plate,
        PointLoad,
        Polygon,
        Rectangle,
        SelfWeight,
        Selvadurai,
        SoilLayer,
        UniformLoad,
        Vlasov,
        Void,
        Winkler,
        Zone,
    )
    from groundslab.plots import plot
    from groundslab.report import write as write_report
    from groundslab.results import Combined, Results
    from groundslab.study import open_study
    from groundslab.tables import tables_of

__version__ = "0.1.0"

__all__ = [
    "Analysis",
    "AreaLoad",
    "Beyond",
    "Circle",
    "Combined",
    "Contact",
    "Edges",
    "GroundslabError",
    "IllConditioned",
    "InputError",
    "InterfaceLayer",
    "Layered",
    "LineLoad",
    "Mesh",
    "Model",
    "NeutralEquilibrium",
    "NoEquilibrium",
    "NotCertified",
    "NotConverged",
    "Pasternak",
    "PatchLoad",
    "Plate",
    "PointLoad",
    "Polygon",
    "Rectangle",
    "Results",
    "SelfWeight",
    "Selvadurai",
    "SingularMatrix",
    "SoilLayer",
    "UniformLoad",
    "Vlasov",
    "Void",
    "Winkler",
    "Zone",
    "__version__",
    "load",
    "open_study",
    "plot",
    "solve",
    "solve_combinations",
    "study",
    "tables_of",
    "write_report",
]

#: Where the public names live that are not in ``model``.
_HOME = {
    "GroundslabError": "errors",
    "IllConditioned": "errors",
    "InputError": "errors",
    "NeutralEquilibrium": "errors",
    "NoEquilibrium": "errors",
    "NotCertified": "errors",
    "NotConverged": "errors",
    "SingularMatrix": "errors",
    "Combined": "results",
    "Results": "results",
    "load": "casefile",
    "plot": "plots",
    "open_study": "study",
    "solve": "analysis",
    "solve_combinations": "analysis",
    "tables_of": "tables",
    "write_report": "report.document",
}
#: What those are called there that are called otherwise.
_CALLED = {"write_report": "write"}


def __getattr__(name: str) -> object:
    """Return a public name from the module that it lives in, which is imported now."""
    if name not in __all__:
        raise AttributeError(f"module 'groundslab' has no attribute {name!r}")
    from importlib import import_module

    if name == "study":  # a package that can be called
        return import_module("groundslab.study")
    value: object = getattr(import_module(f"groundslab.{_HOME.get(name, 'model')}"), _CALLED.get(name, name))
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """Return the public names along with what has been imported so far."""
    return sorted({*globals(), *__all__})
