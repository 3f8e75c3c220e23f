"""What a drawing holds before anything is chosen of it: its unit, its layers, and their lines to be shown."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from groundslab.errors import InputError
from groundslab.exchange.dxf.curves import read_lines, read_position
from groundslab.exchange.dxf.document import UNITS, Layers, Roles, open_drawing
from groundslab.exchange.dxf.drawing import ReadContext, Source
from groundslab.exchange.dxf.entities import BlockCounts, iterate_entities, layer_of
from groundslab.exchange.dxf.loads.distributed_loads import divide_edge
from groundslab.geometry.plan import Place, Segment, make_segments

if TYPE_CHECKING:
    from ezdxf.document import Drawing as Document
    from ezdxf.entities import DXFEntity

#: Points of lines that are shown at most.
MOST_POINTS = 50_000
#: Names of layers that often hold the outline of a slab, suggested where no layer has the usual one.
SLABS = frozenset(("base", "plate", "raft", "slab", "bodenplatte", "sohle", "dalle", "radier", "losa", "płyta"))


@dataclass(slots=True)
class LayerContent:
    """A layer: its entities by kind, what its name says that it holds; straight lines, curves, points [m] to be shown.

    Curves are chords, exact at their ends only.
    """

    name: str
    role: str | None
    hidden: bool
    kinds: Counter[str] = field(default_factory=Counter)
    lines: list[list[Place]] = field(default_factory=list)
    curves: list[list[Place]] = field(default_factory=list)
    points: list[Place] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class Survey:
    """The layers of a drawing; places are meters if its unit is ``scale`` meters, as ``unit`` says if it has one.

    ``remarks`` say what is not counted or not shown.
    """

    unit: str | None
    scale: float
    layers: tuple[LayerContent, ...]
    remarks: tuple[str, ...]


class _EveryLayer(Roles):
    """Each layer for itself."""

    def of(self, layer: str) -> str:
        """Return the layer."""
        return f"layer {layer.lower()}"


def survey(path: str | Path) -> Survey:
    """Return the contents of a drawing's layers; raises InputError if it cannot be opened."""
    context = ReadContext(str(path))
    document = open_drawing(context.path)
    unit = UNITS.get(document.header.get("$INSUNITS", 0))
    if unit is not None:
        context.unit, context.scale = unit
    layers: dict[str, LayerContent] = {}
    remarks: list[str] = []
    shown, left = 0, 0
    for source, entity in _iterate_all(document, context, remarks):
        layer = layers.setdefault(source.layer.lower(), _describe_layer(document, source.layer))
        layer.kinds[entity.dxftype()] += 1
        for points, straight in _parts_of(entity, layer, context):
            if shown + len(points) > MOST_POINTS:
                left += 1
                continue
            shown += len(points)
            (layer.lines if straight else layer.curves).append(points)
    if left:
        remarks.append(f"{left:,} lines are not shown, as there are more than {MOST_POINTS:,} points")
    _suggest_outline(list(layers.values()))
    ordered = sorted(layers.values(), key=lambda layer: (layer.role is None, layer.name.lower()))
    return Survey(None if unit is None else context.unit, float(context.scale), tuple(ordered), tuple(remarks))


def _iterate_all(document: Document, context: ReadContext, remarks: list[str]) -> Iterator[tuple[Source, DXFEntity]]:
    """Yield all entities, those of blocks too unless they are too many; references to blocks are entities as well."""
    space = document.modelspace()
    for entity in space:
        if entity.dxftype() == "INSERT":
            yield Source(layer_of(entity), "INSERT", ""), entity
    names = {layer_of(entity) for block in document.blocks for entity in block}
    roles = _EveryLayer({name.lower(): f"layer {name.lower()}" for name in names})
    try:
        blocks = BlockCounts(document, roles, context)
        for _, source, entity in iterate_entities(space, roles, blocks, context):
            yield source, entity
    except InputError as error:
        remarks.append(f"what lies in blocks is not counted: {error.issues[-1].found}")
        for entity in space:
            if entity.dxftype() != "INSERT":
                yield Source(layer_of(entity), entity.dxftype(), ""), entity


def _describe_layer(document: Document, name: str) -> LayerContent:
    """Return a layer without its content."""
    usual = Layers()
    role = Roles({getattr(usual, role_name).lower(): role_name for role_name in Layers.__dataclass_fields__}).of(name)
    layer = document.layers.get(name) if document.layers.has_entry(name) else None
    return LayerContent(name, role, layer is not None and (layer.is_frozen() or layer.is_off()))


def _suggest_outline(layers: list[LayerContent]) -> None:
    """Let the one layer that is called like a slab hold the outline, if none has the usual name."""
    slabs = [layer for layer in layers if layer.role is None and layer.name.lower() in SLABS]
    if len(slabs) == 1 and all(layer.role != "outline" for layer in layers):
        slabs[0].role = "outline"


def _parts_of(entity: DXFEntity, layer: LayerContent, context: ReadContext) -> list[tuple[list[Place], bool]]:
    """Return the points of a line's parts, and whether each is straight; one that is a point is added to its layer."""
    try:
        if entity.dxftype() in {"POINT", "INSERT"}:
            place = read_position(entity, context)
            layer.points += [place] if place is not None and len(layer.points) < MOST_POINTS else []
            return []
        pieces = read_lines(entity, context)
    except MemoryError:
        raise
    except Exception:  # of any kind, as what is damaged may be anything; it is counted all the same
        return []
    if isinstance(pieces, str):
        return []
    if entity.dxftype() in {"ELLIPSE", "SPLINE"}:
        return [(piece.points, False) for piece in pieces]
    return [part for piece in pieces for part in _split(make_segments(piece.points, piece.bulges))]


def _split(edges: Sequence[Segment]) -> list[tuple[list[Place], bool]]:
    """Return the points of edges in parts, and whether each is straight."""
    parts: list[tuple[list[Place], bool]] = []
    for edge in edges:
        if not (parts and edge.straight and parts[-1][1]):
            parts.append(([edge.start], edge.straight))
        parts[-1][0].extend([*((x, y) for x, y in divide_edge(edge)[:-1]), edge.end])
    return parts
