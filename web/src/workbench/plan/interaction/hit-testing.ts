// Which items are under the pointer, the likeliest first.

import { distanceBetween } from "../../../viewer/data/points";
import { isClosed, isInside, nearestOnSegment, type Point, ringOf, signedArea } from "../../model/geometry";
import type { Item } from "../../model/items";

/** Return the items within `reach` [m] of a place: points first, then lines, then areas, the smaller the earlier. */
export function itemsAt(items: readonly Item[], at: Point, reach: number): Item[] {
  const ranked = items.map((item) => ({ item, rank: rankOf(item, at, reach) })).filter(({ rank }) => rank < Infinity);
  return ranked.sort((a, b) => a.rank - b.rank).map(({ item }) => item);
}

/** Return the rank of an item, infinite if it is not within reach. */
function rankOf(item: Item, at: Point, reach: number): number {
  const ring = ringOf(item.geometry);
  if (item.geometry.type === "point") {
    const distance = distanceBetween(at, [item.geometry.x, item.geometry.y]);
    const near = distance <= reach || (item.foot !== null && isInside(item.foot, at));
    // a column comes before the loads on it, which hide it
    return near ? (item.kind === "column" ? 0 : 1) + distance / (1 + distance) / 2 : Infinity;
  }
  const closed = isClosed(item.geometry);
  let distance = Infinity;
  ring.forEach((point, n) => {
    const next = ring[n + 1] ?? (closed ? ring[0] : undefined);
    if (next) distance = Math.min(distance, nearestOnSegment(point, next, at).distance);
  });
  if (distance <= reach) return (closed ? 3 : 2) + distance / (1 + distance) / 2;
  if (!closed || !isInside(ring, at)) return Infinity;
  const area = Math.abs(signedArea(ring));
  return (item.kind === "slab" ? 20 : 10) + area / (1 + area);
}
