"""Thick plates on layered, two-parameter, tensionless ground.

    import groundslab

    model = groundslab.load("case.toml")
    results = groundslab.solve(model)

The public names are listed in ``__init__.pyi``. Each loads when it is first used, so that importing the package costs
nothing.
"""

import lazy_loader

from groundslab._version import __version__ as __version__

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
__all__ += ["__version__"]
