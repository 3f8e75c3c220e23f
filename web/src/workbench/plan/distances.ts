// Distances from a selected place to the edges and to what stands in line with it.
import { distanceBetween } from "../../viewer/data/points";
import type { Camera } from "../../viewer/plan/camera";
import { drawPath, drawText } from "../../viewer/plan/symbols";
import { type Point, ringOf } from "../model/geometry";
import type { Item } from "../model/items";
import { formatDecimals } from "../model/quantities";

const SAME = 1e-6; // m: places so near are one
const LEAST = 34; // px: a shorter distance is not written

/** Return lines from a point's place to the nearest edges, columns and items of its kind, along x and y both ways. */
export function neighborLines(item: Item, items: readonly Item[]): [Point, Point][] {
  const { geometry } = item;
  if (geometry.type !== "point") return [];
  const at: Point = [geometry.x, geometry.y];
  return ([0, 1] as const).flatMap((along) => {
    const distances = placesInLine(at, along, item.kind, items).map((place) => place - at[along]);
    const [before, after] = [distances.filter((each) => each < -SAME), distances.filter((each) => each > SAME)];
    const nearest = [
      ...(before.length > 0 ? [Math.max(...before)] : []),
      ...(after.length > 0 ? [Math.min(...after)] : []),
    ];
    return nearest.map((by): [Point, Point] => [at, along === 0 ? [at[0] + by, at[1]] : [at[0], at[1] + by]]);
  });
}

/** Return the x (along 0) or y (1) at which the line through a place meets edges and others. */
function placesInLine(at: Point, along: 0 | 1, kind: string, items: readonly Item[]): number[] {
  const across = along === 0 ? 1 : 0;
  return items.flatMap((other) => {
    const ring = ringOf(other.geometry);
    if (other.geometry.type === "point") {
      const isMet = other.kind === "column" || other.kind === kind;
      return isMet && Math.abs(ring[0]![across] - at[across]) <= SAME ? [ring[0]![along]] : [];
    }
    if (!["slab", "plate", "opening"].includes(other.kind)) return [];
    return ring.flatMap((a, n): number[] => {
      const b = ring[(n + 1) % ring.length]!;
      const [da, db] = [a[across] - at[across], b[across] - at[across]];
      return da === db || da * db > 0 ? [] : [a[along] + ((b[along] - a[along]) * da) / (da - db)];
    });
  });
}

/** Draw the distances of a selected point to its neighbors, where there is room for them. */
export function drawDistances(camera: Camera, item: Item, items: readonly Item[]): SVGElement[] {
  return neighborLines(item, items).flatMap(([from, to]) => {
    const [p, q] = [camera.toPixel(from), camera.toPixel(to)];
    if (distanceBetween(p, q) < LEAST) return [];
    const isLevel = from[1] === to[1];
    const text = `${formatDecimals(distanceBetween(from, to), 3)} m`;
    const middle: Point = [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];
    const label = drawText(middle, text, isLevel ? [0, -5] : [6, 4], isLevel ? "dimension middle" : "dimension");
    return [drawPath([p, q], false, "distance"), label];
  });
}
