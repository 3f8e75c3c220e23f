// Which items a rubber band selects: those inside it, or from right to left also those that it touches.
import { isClosed, type Point, ringOf } from "../../model/geometry";
import type { Item } from "../../model/items";

/** Return the items that a rubber band selects, never the slab, in which it is stretched. */
export function itemsInBand(items: readonly Item[], from: Point, to: Point): Item[] {
  const low: Point = [Math.min(from[0], to[0]), Math.min(from[1], to[1])];
  const high: Point = [Math.max(from[0], to[0]), Math.max(from[1], to[1])];
  const isWithin = ([x, y]: Point) => x >= low[0] && x <= high[0] && y >= low[1] && y <= high[1];
  return items.filter((item) => {
    if (item.kind === "slab") return false;
    const ring = item.foot ?? ringOf(item.geometry);
    if (from[0] <= to[0]) return ring.every(isWithin);
    const ends = item.foot || isClosed(item.geometry) ? [...ring.slice(1), ring[0]!] : ring.slice(1);
    return ring.some(isWithin) || ends.some((end, n) => crosses(ring[n]!, end, low, high));
  });
}

/** Return whether a straight piece has a part inside a box: its range of x and of y in it overlap. */
function crosses(a: Point, b: Point, low: Point, high: Point): boolean {
  let [first, last] = [0, 1];
  for (const axis of [0, 1] as const) {
    const step = b[axis] - a[axis];
    if (step === 0) {
      if (a[axis] < low[axis] || a[axis] > high[axis]) return false;
      continue;
    }
    const ends = [(low[axis] - a[axis]) / step, (high[axis] - a[axis]) / step];
    first = Math.max(first, Math.min(...ends));
    last = Math.min(last, Math.max(...ends));
  }
  return first <= last;
}
