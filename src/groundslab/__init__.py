"""Thick plates on layered, two-parameter, tensionless ground.

    import groundslab

    model = groundslab.load("case.toml")
    results = groundslab.solve(model)

The public names are listed in ``__init__.pyi``. Each loads when it is first used, so that importing the package costs
nothing.
"""

import importlib
import sys
from typing import Any

import lazy_loader

from groundslab._version import __version__ as __version__

_load, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
__all__ += ["__version__"]


def __getattr__(name: str) -> Any:
    """Return a public name; with results come their methods that draw them."""
    value = _load(name)
    if "groundslab.results.results" in sys.modules:
        importlib.import_module("groundslab.views.methods")
    return value
