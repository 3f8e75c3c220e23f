// Which items are under the pointer, the likeliest first.

import { isClosed, isInside, nearestOnSegment, type Point, ringOf, signedArea } from "../../model/geometry";
import type { Item } from "../../model/items";

/** Return the items within `reach` [m] of a place: points first, then lines, then areas, the smaller the earlier. */
export function itemsAt(items: readonly Item[], at: Point, reach: number): Item[] {
  const found: { item: Item; rank: number }[] = [];
  for (const item of items) {
    const rank = rankOf(item, at, reach);
    if (rank !== null) found.push({ item, rank });
  }
  return found.sort((a, b) => a.rank - b.rank).map((each) => each.item);
}

function rankOf(item: Item, at: Point, reach: number): number | null {
  const ring = ringOf(item.geometry);
  if (item.geometry.type === "point") {
    const distance = Math.hypot(at[0] - item.geometry.x, at[1] - item.geometry.y);
    const near = distance <= reach || (item.foot !== null && isInside(item.foot, at));
    // a column comes before the loads on it, which hide it
    return near ? (item.kind === "column" ? 0 : 1) + distance / (1 + distance) / 2 : null;
  }
  const closed = isClosed(item.geometry);
  let distance = Infinity;
  ring.forEach((point, n) => {
    const next = ring[n + 1] ?? (closed ? ring[0] : undefined);
    if (next) distance = Math.min(distance, nearestOnSegment(point, next, at).distance);
  });
  if (distance <= reach) return (closed ? 3 : 2) + distance / (1 + distance) / 2;
  if (!closed || !isInside(ring, at)) return null;
  const area = Math.abs(signedArea(ring));
  return (item.kind === "slab" ? 20 : 10) + area / (1 + area);
}
