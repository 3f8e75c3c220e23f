"""A solved model as a browser draws it: what is described in plan, the mesh, the fields, packed into one block."""

from __future__ import annotations

from groundslab.scene.packing import Scene, packed, unpacked
from groundslab.scene.plan import plan_of
from groundslab.scene.solved import scene_of

__all__ = ["Scene", "packed", "plan_of", "scene_of", "unpacked"]
