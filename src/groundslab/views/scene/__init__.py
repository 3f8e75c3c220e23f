"""A solved model as a browser draws it: what is described in plan, the mesh, the fields, packed into one block."""

from __future__ import annotations

from groundslab.views.scene.binary import Scene, pack, unpack
from groundslab.views.scene.fields import scene_of
from groundslab.views.scene.plan import plan_of

__all__ = ["Scene", "pack", "plan_of", "scene_of", "unpack"]
