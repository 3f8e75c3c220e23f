"""The entities on the layers asked for, blocks resolved."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING

from groundslab.dxf.sheet import LARGEST, Sheet, Source, stop
from groundslab.dxf.words import named

if TYPE_CHECKING:
    from ezdxf.entities import DXFEntity, DXFGraphic, Insert

DEEPEST = 16  # blocks in blocks


def walk(
    entities: Iterable[DXFEntity], roles: dict[str, str], sheet: Sheet, outer: tuple[Source, ...] = ()
) -> Iterator[tuple[str, Source, DXFEntity]]:
    """Yield what lies on the layers asked for, with blocks resolved: role, source, entity."""
    from ezdxf.entities import Insert

    for entity in entities:
        source = _source(entity, outer)
        role = roles.get(source.layer.lower())
        if not isinstance(entity, Insert):
            if role:
                yield role, source, entity
            continue
        if entity.mcount > LARGEST:
            stop(sheet, f"a block repeated {entity.mcount:,} times", f"at most {LARGEST:,} times")
        for single in entity.multi_insert() if entity.mcount > 1 else (entity,):
            if role == "point_loads":
                yield role, source, single
            else:
                yield from _within(single, source, roles, sheet, outer)


def _source(entity: DXFEntity, outer: tuple[Source, ...]) -> Source:
    """Return where an entity comes from; on layer 0 of a block it lies on the layer of the block's reference."""
    layer = str(entity.dxf.get("layer", "0")) if entity.is_supported_dxf_attrib("layer") else "0"
    kind = entity.dxftype()
    if not outer:
        return Source(layer, kind, entity.dxf.get("handle") or "")
    block = outer[-1].entity.removeprefix("INSERT ")
    return Source(outer[-1].layer if layer == "0" else layer, f"{kind} in {block}", outer[0].handle)


def _within(
    insert: Insert, source: Source, roles: dict[str, str], sheet: Sheet, outer: tuple[Source, ...]
) -> Iterator[tuple[str, Source, DXFEntity]]:
    """Yield what the content of a block's reference has on the layers asked for."""
    from ezdxf.lldxf.const import DXFError

    for attribute in insert.attribs:
        its = _source(attribute, (*outer, source))
        if roles.get(its.layer.lower()) == "point_loads":
            yield "point_loads", its, attribute
    name = insert.dxf.get("name")
    block = insert.block() if isinstance(name, str) else None
    own = Source(source.layer, f"INSERT block {named(str(name))}", source.handle)
    on_layer = roles.get(source.layer.lower())
    if block is None or insert.is_xref():
        if on_layer:
            sheet.tell(own, False, "its block is an external file or is missing")
        return
    names = {each.entity for each in outer}
    if own.entity in names or len(outer) >= DEEPEST:
        sheet.fault(
            [own], None, "a block that holds itself, or too many blocks in blocks", "blocks that can be resolved"
        )
        return
    inner = (*outer, own)
    if not any(part.dxftype() == "INSERT" or _source(part, inner).layer.lower() in roles for part in block):
        if on_layer:
            sheet.tell(own, False, "its block has nothing on the layers that are read")
        return
    skipped: list[tuple[DXFGraphic, str]] = []
    callback: Callable[[DXFGraphic, str], None] = lambda part, why: skipped.append((part, why))  # noqa: E731
    try:
        parts = list(insert.virtual_entities(skipped_entity_callback=callback))
    except (DXFError, ArithmeticError, ValueError) as error:
        sheet.fault([own], None, f"a block that cannot be placed ({error})", "a block with sound scales")
        return
    for part, why in skipped:
        its = _source(part, inner)
        if its.layer.lower() in roles:
            sheet.tell(its, False, f"it cannot be placed ({why})")
    yield from walk(parts, roles, sheet, inner)
