// Further plates and the joints between plates, which lie where their outlines share a line.
import { type Geometry, nearestOnSegment, type Point, type Ring, readGeometry, readSides, ringOf } from "./geometry";
import { isTable, listAt, type Path, type Table, tableAt } from "./paths";

const SAME = 1e-6; // m: outlines this close share a line

/** A plate's name and outline. */
export interface PlateOutline {
  name: string;
  ring: Ring;
}

/** Return the tables of all plates with the geometry of their outlines, those of which can be read here. */
function allPlates(data: Table): { table: Table; geometry: Geometry }[] {
  const main = readGeometry(data, ["plate", "outline"]) ?? readSides(data);
  const further = listAt(data, ["plates"]).map((table, n): [Table, Geometry | null] => [
    isTable(table) ? table : {},
    readGeometry(data, ["plates", n, "outline"]),
  ]);
  const all: [Table, Geometry | null][] = [[tableAt(data, ["plate"]), main], ...further];
  return all.flatMap(([table, geometry]) => (geometry ? [{ table, geometry }] : []));
}

/** Return the outlines of all plates that have a name. */
export function plateOutlines(data: Table): PlateOutline[] {
  return allPlates(data).flatMap(({ table: { name }, geometry }) =>
    typeof name === "string" && name ? [{ name, ring: ringOf(geometry) }] : [],
  );
}

/** Return where a joint lies: the longest straight piece that both outlines share; null if there is none. */
export function readJoint(data: Table, at: Path): Geometry | null {
  const names = listAt(data, [...at, "between"]);
  const plates = plateOutlines(data);
  const [a, b] = names.map((name) => plates.find((plate) => plate.name === name));
  const shared = a && b ? sharedLine(a.ring, b.ring) : null;
  return shared && { type: "fixed", at, points: shared, closed: false };
}

const SIDES = ["bottom", "right", "top", "left"];

/** Return the plate's edge that is nearest to a place, as walls name it; null if none is within reach [m]. */
export function edgeAt(data: Table, at: Point, reach: number): Table | null {
  let [best, least]: [Table | null, number] = [null, reach];
  for (const { table, geometry } of allPlates(data)) {
    const plate: Table = table === tableAt(data, ["plate"]) || !table.name ? {} : { plate: table.name };
    for (const [n, edge] of edgesOf(geometry).entries()) {
      const pieces = edge.slice(1).map((end, m) => nearestOnSegment(edge[m]!, end, at).distance);
      const distance = Math.min(...pieces);
      const name = geometry.type === "circle" ? "all" : geometry.type === "polygon" ? n + 1 : SIDES[n]!;
      if (distance <= least) [best, least] = [{ edge: name, ...plate }, distance];
    }
  }
  return best;
}

/** Return the edges of an outline, arcs as chords; of a rectangle those at the bottom, right, top and left. */
function edgesOf(geometry: Geometry): Ring[] {
  if (geometry.type === "circle") return [[...ringOf(geometry), ringOf(geometry)[0]!]];
  if (geometry.type !== "polygon") return edges(ringOf(geometry));
  return edges(geometry.points).map((points, n) =>
    ringOf({ type: "line", at: [], points, bulges: [geometry.bulges[n] ?? 0] }),
  );
}

/** Return the plates whose shared line is nearest to a place, null if none is within reach [m]. */
export function platesAt(data: Table, at: Point, reach: number): [string, string] | null {
  const plates = plateOutlines(data);
  let [best, least]: [[string, string] | null, number] = [null, reach];
  plates.forEach((a, n) => {
    for (const b of plates.slice(n + 1)) {
      const shared = sharedLine(a.ring, b.ring);
      const distance = shared ? nearestOnSegment(shared[0], shared[1], at).distance : Number.POSITIVE_INFINITY;
      if (distance <= least) [best, least] = [[a.name, b.name], distance];
    }
  });
  return best;
}

/** Return the longest straight piece that two closed curves share, null if there is none. */
export function sharedLine(a: Ring, b: Ring): [Point, Point] | null {
  const pieces = edges(a).flatMap((one) => edges(b).flatMap((other) => overlap(one, other) ?? []));
  const length = ([p, q]: readonly [Point, Point]) => Math.hypot(q[0] - p[0], q[1] - p[1]);
  return pieces.toSorted((p, q) => length(q) - length(p))[0] ?? null;
}

function edges(ring: Ring): [Point, Point][] {
  return ring.map((point, n) => [point, ring[(n + 1) % ring.length]!]);
}

/** Return the part of a straight piece that lies on another one. */
function overlap([p, q]: [Point, Point], other: [Point, Point]): [[Point, Point]] | null {
  const length = Math.hypot(q[0] - p[0], q[1] - p[1]);
  if (length < SAME) return null;
  const [dx, dy] = [(q[0] - p[0]) / length, (q[1] - p[1]) / length];
  const along = ([x, y]: Point) => (x - p[0]) * dx + (y - p[1]) * dy;
  const across = ([x, y]: Point) => Math.abs((y - p[1]) * dx - (x - p[0]) * dy);
  if (other.some((point) => across(point) > SAME)) return null;
  const ends = other.map(along);
  const [from, to] = [Math.max(0, Math.min(...ends)), Math.min(length, Math.max(...ends))];
  const place = (s: number): Point => [p[0] + s * dx, p[1] + s * dy];
  return to - from > SAME ? [[place(from), place(to)]] : null;
}
