"""Entities on the layers that are read, out of nested blocks."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from graphlib import CycleError, TopologicalSorter
from typing import TYPE_CHECKING

from groundslab.exchange.dxf.document import Roles
from groundslab.exchange.dxf.drawing import MOST_ENTITIES, ReadContext, Source, abort
from groundslab.schema.wording import describe

if TYPE_CHECKING:
    from ezdxf.document import Drawing as Document
    from ezdxf.entities import DXFEntity, DXFGraphic, Insert

DEEPEST = 16  # blocks in blocks
MOST_PLACED = 200_000  # entities of blocks, copied to where they are referred to
FEWER = "leave only what is needed in the drawing, or resolve the blocks in the CAD program"


@dataclass(slots=True)
class _Content:
    """What a block holds: its entities by the role of their layers, and references to other blocks.

    Entities on layer 0 take the role of the layer that the block is referred to from; here they have the role "0".
    """

    entities: Counter[str | None] = field(default_factory=Counter)
    references: Counter[tuple[str, str | None]] = field(default_factory=Counter)  # by block and role


class BlockCounts:
    """How many entities of each block lie on the layers that are read, and how many must be placed to get them."""

    def __init__(self, document: Document, roles: Roles, context: ReadContext) -> None:
        self._document, self._roles = document, roles
        contents: dict[str, _Content] = {}
        space = self._content(document.modelspace(), contents)
        graph = {name: {child for child, _ in content.references} for name, content in contents.items()}
        #: By block and role of what lies on layer 0: entities taken and entities placed.
        self._counts: dict[tuple[str, str | None], tuple[int, int]] = {}
        try:
            order = list(TopologicalSorter(graph).static_order())
        except CycleError as error:
            names = " in ".join(describe(name) for name in error.args[1][:8])
            abort(context, f"a block that holds itself: {names}", "blocks that can be resolved")
        for name in order:
            for role in (None, *roles.named.values()):
                self._counts[name, role] = self._count_below(contents.get(name, _Content()), role)
        taken, placed = self._count_below(space, None)
        for count, limit, words in (
            (taken, MOST_ENTITIES, "entities on the layers that are read, those of blocks included"),
            (placed - sum(space.entities.values()), MOST_PLACED, "entities of blocks to be placed"),
        ):
            if count > limit:
                shown = f"{count:,}" if count < 10**15 else f"more than {10**15:,}"
                abort(context, f"{shown} {words}", f"at most {limit:,}", FEWER)

    def holds(self, name: str, role: str | None) -> bool:
        """Return whether a block has anything on the layers that are read, if its layer 0 has this role."""
        return self._counts.get((name.lower(), role), (1, 1))[0] > 0

    def _content(self, entities: Iterable[DXFEntity], contents: dict[str, _Content]) -> _Content:
        """Return the content of entities, and add that of blocks they refer to, directly or through other blocks."""
        first, todo = _Content(), [(entities, "")]
        while todo:
            items, name = todo.pop()
            content = contents.setdefault(name, _Content()) if name else first
            for entity in items:
                layer = layer_of(entity)
                role = "0" if layer == "0" and name else self._roles.of(layer)
                if entity.dxftype() != "INSERT":
                    content.entities[role] += 1
                    continue
                child = str(entity.dxf.get("name")).lower()
                content.references[child, role] += max(entity.mcount, 1)
                content.entities[role] += _count_attributes(entity, self._roles)
                block = self._document.blocks.get(child)
                if child not in contents and block is not None and not block.block.is_xref:
                    contents[child] = _Content()
                    todo.append((block, child))
        return first

    def _count_below(self, content: _Content, role: str | None) -> tuple[int, int]:
        """Return how many entities are taken and placed, if layer 0 has this role."""
        role_of_layer = {"0": role}
        taken = sum(count for kind, count in content.entities.items() if role_of_layer.get(str(kind), kind) is not None)
        placed = sum(content.entities.values())
        for (child, kind), count in content.references.items():
            its = role_of_layer.get(str(kind), kind)
            below = (1, 1) if its == "point_loads" else self._counts.get((child, its), (0, 0))
            if below[0]:
                taken, placed = taken + count * below[0], placed + count * (1 + below[1])
            else:
                placed += 1
        return taken, placed


def layer_of(entity: DXFEntity) -> str:
    """Return the layer that an entity names."""
    return str(entity.dxf.get("layer", "0")) if entity.is_supported_dxf_attrib("layer") else "0"


def _count_attributes(insert: DXFEntity, roles: Roles) -> int:
    """Return how many attributes of a block's reference lie on the layer of point loads."""
    attributes: list[DXFEntity] = insert.attribs
    return sum(roles.of(layer_of(attribute)) == "point_loads" for attribute in attributes)


def iterate_entities(
    entities: Iterable[DXFEntity],
    roles: Roles,
    blocks: BlockCounts,
    context: ReadContext,
    outer: tuple[Source, ...] = (),
) -> Iterator[tuple[str, Source, DXFEntity]]:
    """Yield what lies on the layers that are read, with blocks resolved: role, source, entity."""
    from ezdxf.entities import Insert

    for entity in entities:
        source = _locate_entity(entity, outer)
        role = roles.of(source.layer)
        if not isinstance(entity, Insert):
            if role:
                yield role, source, entity
            continue
        if role != "point_loads" and not _has_content(entity, source, role, blocks, context):
            continue
        for single in entity.multi_insert() if entity.mcount > 1 else (entity,):
            if role == "point_loads":
                yield role, source, single
            else:
                yield from _iterate_block(single, source, roles, blocks, context, outer)


def _locate_entity(entity: DXFEntity, outer: tuple[Source, ...]) -> Source:
    """Return where an entity comes from; on layer 0 of a block it lies on the layer of the block's reference."""
    layer, kind = layer_of(entity), entity.dxftype()
    if not outer:
        return Source(layer, kind, entity.dxf.get("handle") or "")
    block = outer[-1].entity.removeprefix("INSERT ")
    return Source(outer[-1].layer if layer == "0" else layer, f"{kind} in {block}", outer[0].handle)


def _has_content(insert: Insert, source: Source, role: str | None, blocks: BlockCounts, context: ReadContext) -> bool:
    """Return whether there is anything to take from a block's reference; if not, and it lies on a layer, say why."""
    name = insert.dxf.get("name")
    block = Source(source.layer, f"INSERT block {describe(str(name))}", source.handle)
    if not isinstance(name, str) or insert.block() is None or insert.is_xref():
        why = "its block is an external file or is missing"
    elif not blocks.holds(name, role):
        why = "its block has nothing on the layers that are read"
    else:
        return True
    if role:
        context.report_entity(block, False, why)
    return bool(insert.attribs)


def _iterate_block(
    insert: Insert, source: Source, roles: Roles, blocks: BlockCounts, context: ReadContext, outer: tuple[Source, ...]
) -> Iterator[tuple[str, Source, DXFEntity]]:
    """Yield what the content of a block's reference has on the layers that are read."""
    from ezdxf.lldxf.const import DXFError

    for attribute in insert.attribs:
        its = _locate_entity(attribute, (*outer, source))
        if roles.of(its.layer) == "point_loads":
            yield "point_loads", its, attribute
    name = str(insert.dxf.get("name"))
    block = Source(source.layer, f"INSERT block {describe(name)}", source.handle)
    if insert.block() is None or insert.is_xref() or not blocks.holds(name, roles.of(source.layer)):
        return
    if len(outer) >= DEEPEST:
        context.issue([block], None, "too many blocks in blocks", f"at most {DEEPEST} blocks in each other", FEWER)
        return
    inner = (*outer, block)
    skipped: list[tuple[DXFGraphic, str]] = []
    callback: Callable[[DXFGraphic, str], None] = lambda part, why: skipped.append((part, why))  # noqa: E731
    try:
        parts = list(insert.virtual_entities(skipped_entity_callback=callback))
    except (DXFError, ArithmeticError, ValueError) as error:
        context.issue([block], None, f"a block that cannot be placed ({error})", "a block with sound scales")
        return
    for part, why in skipped:
        its = _locate_entity(part, inner)
        if roles.of(its.layer):
            context.report_entity(its, False, f"it cannot be placed ({why})")
    yield from iterate_entities(parts, roles, blocks, context, inner)
