// The places that others snap to: corners, ends, middles, centers and intersections of what is drawn.
import { pointBetween } from "../../../viewer/data/points";
import { isClosed, type Point, type Ring, ringOf } from "../../model/geometry";
import type { Item } from "../../model/items";
import { type Path, samePath } from "../../model/paths";

/** A place with what it is, such as `middle`. */
export interface SnapPlace {
  at: Point;
  name: string;
}

const MOST_EDGES = 200; // of which intersections are looked for

/** Return the places of items to snap to, the better ones first; `without` are the items that move. */
export function snapPlaces(items: readonly Item[], without: readonly Path[]): SnapPlace[] {
  const still = items.filter((item) => !without.some((path) => samePath(path, item.path)));
  const edges = still.flatMap(edgesOf);
  const middles = edges.map(([a, b]): SnapPlace => ({ at: pointBetween(a, b), name: "middle" }));
  return [{ at: [0, 0], name: "origin" }, ...still.flatMap(ownPlaces), ...intersections(edges), ...middles];
}

function ownPlaces(item: Item): SnapPlace[] {
  const { geometry } = item;
  if (geometry.type === "circle") {
    const { center, radius } = geometry;
    const [x, y] = center;
    const quadrants: Ring = [
      [x + radius, y],
      [x, y + radius],
      [x - radius, y],
      [x, y - radius],
    ];
    return [{ at: center, name: "center" }, ...quadrants.map((at) => ({ at, name: "quadrant" }))];
  }
  const name = geometry.type === "point" ? item.title : isClosed(geometry) ? "corner" : "end";
  return corners(item).map((at) => ({ at, name }));
}

/** Return the corners of an item, not those of the chords of its arcs. */
function corners({ geometry }: Item): Ring {
  return "bulges" in geometry ? geometry.points : ringOf(geometry);
}

/** Return the straight edges of an item. */
function edgesOf(item: Item): [Point, Point][] {
  const { geometry } = item;
  if (geometry.type === "circle" || geometry.type === "point") return [];
  const ring = corners(item);
  const bulges = "bulges" in geometry ? geometry.bulges : [];
  const ends = isClosed(geometry) ? [...ring.slice(1), ring[0]!] : ring.slice(1);
  return ends.flatMap((end, n): [Point, Point][] => (bulges[n] ? [] : [[ring[n]!, end]]));
}

function intersections(edges: readonly [Point, Point][]): SnapPlace[] {
  if (edges.length > MOST_EDGES) return [];
  return edges.flatMap((one, n) =>
    edges.slice(n + 1).flatMap((other) => {
      const at = intersection(one, other);
      return at ? [{ at, name: "intersection" }] : [];
    }),
  );
}

/** Return where two straight edges cross, null if they do not. */
export function intersection([a, b]: readonly [Point, Point], [c, d]: readonly [Point, Point]): Point | null {
  const [ux, uy, vx, vy] = [b[0] - a[0], b[1] - a[1], d[0] - c[0], d[1] - c[1]];
  const cross = ux * vy - uy * vx;
  if (cross === 0) return null;
  const s = ((c[0] - a[0]) * vy - (c[1] - a[1]) * vx) / cross;
  const t = ((c[0] - a[0]) * uy - (c[1] - a[1]) * ux) / cross;
  const isInside = (share: number) => share > 1e-9 && share < 1 - 1e-9; // ends are places of their own
  return isInside(s) && isInside(t) ? [a[0] + s * ux, a[1] + s * uy] : null;
}
