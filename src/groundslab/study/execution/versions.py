"""Versions of installed packages; sent by value to the processes of a cluster, which may lack groundslab.

Nothing but the standard library may be imported here.
"""

from __future__ import annotations

#: What must be the same everywhere for rows to be the same, whatever the case.
MUST_AGREE = ("python", "groundslab", "numpy", "scipy", "pypardiso", "gstools", "dask", "distributed")
#: Where the mesh is not a plain grid.
MESHERS = ("shapely", "gmsh", "netgen-mesher")


def versions(packages: tuple[str, ...]) -> dict[str, str]:
    """Return the versions of packages, and of Python without its last part; missing packages are left out."""
    import importlib
    import importlib.metadata
    import sys

    installed = {"python": f"{sys.version_info[0]}.{sys.version_info[1]}"}
    for name in packages:
        try:
            # an installed package may not be the one that is imported
            if name == "groundslab":
                installed[name] = importlib.import_module(name).__version__
            elif name != "python":
                installed[name] = importlib.metadata.version(name)
        except ImportError:
            continue
    return installed
