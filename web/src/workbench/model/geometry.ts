// Shapes in plan in meters: read from the case file, and written back as edits.

import { type Box, boxAround } from "../../viewer/data/boxes";
import { distanceBetween, offset, pointBetween } from "../../viewer/data/points";
import { attachedPlaces, axesIn, isAttached } from "./axes";
import type { Edit } from "./edits";
import { isTable, type Json, listAt, type Path, type Table, valueAt } from "./paths";
import { parseLength, parsePoint, parsePoints } from "./quantities";

export type Point = readonly [number, number];
export type Ring = readonly Point[];
/** From a number to another. */
export type Range = readonly [number, number];

/** Where an item is in plan. `at` is the path of the table that holds the keys. */
export type Geometry =
  | { type: "sides"; at: Path; x: number; y: number }
  | { type: "box"; at: Path; x: Range; y: Range }
  | { type: "polygon"; at: Path; points: Ring; bulges: readonly number[] }
  | { type: "circle"; at: Path; center: Point; radius: number }
  | { type: "point"; at: Path; x: number; y: number }
  | { type: "line"; at: Path; points: Ring; bulges: readonly number[] }
  | { type: "segment"; at: Path; start: Point; end: Point }
  | { type: "fixed"; at: Path; points: Ring; closed: boolean };

/** The geometry that a table of the case file states, null if its lengths cannot be read here. */
export function readGeometry(data: Json, at: Path): Geometry | null {
  const table = valueAt(data, at);
  if (!isTable(table)) return null;
  if (isAttached(table)) {
    const places = attachedPlaces(table, axesIn(data));
    if (!places) return null;
    return Array.isArray(table.at)
      ? { type: "line", at, points: places, bulges: bulgesOf(table) }
      : { type: "point", at, x: places[0]![0], y: places[0]![1] };
  }
  if (table.start !== undefined && table.end !== undefined) {
    const [start, end] = [parsePoint(table.start), parsePoint(table.end)];
    return start && end ? { type: "segment", at, start, end } : null;
  }
  if (table.radius !== undefined) {
    const center: Point | null = table.centre === undefined ? [0, 0] : parsePoint(table.centre);
    const radius = parseLength(table.radius);
    return center && radius !== null && radius > 0 ? { type: "circle", at, center, radius } : null;
  }
  if (Array.isArray(table.x)) {
    const [x, y] = [parsePoint(table.x), parsePoint(table.y)];
    return x && y ? { type: "box", at, x, y } : null;
  }
  if (table.points !== undefined) {
    const points = parsePoints(table.points);
    if (!points || points.length === 0) return null;
    return { type: table.kind === "polygon" ? "polygon" : "line", at, points, bulges: bulgesOf(table) };
  }
  const [x, y] = [parseLength(table.x), parseLength(table.y)];
  return x !== null && y !== null ? { type: "point", at, x, y } : null;
}

function bulgesOf(table: Table): number[] {
  return listAt(table, ["bulges"]).map((each) => (typeof each === "number" ? each : 0));
}

/** The rectangle about the origin that length_x and length_y state, null if there is none. */
export function readSides(data: Json): Extract<Geometry, { type: "sides" }> | null {
  const [x, y] = [parseLength(valueAt(data, ["plate", "length_x"])), parseLength(valueAt(data, ["plate", "length_y"]))];
  return x !== null && y !== null && x > 0 && y > 0 ? { type: "sides", at: ["plate"], x, y } : null;
}

/** Arcs become chords of at most this angle, so that they look round on the largest screen. */
const CHORD_ANGLE = (2 * Math.PI) / 180;

/** The curve of a geometry, arcs as chords; closed unless it is a point, a line or a segment. */
export function ringOf(geometry: Geometry): Ring {
  switch (geometry.type) {
    case "sides":
      return rectangleCorners([-geometry.x / 2, geometry.x / 2], [-geometry.y / 2, geometry.y / 2]);
    case "box":
      return rectangleCorners(geometry.x, geometry.y);
    case "line":
    case "polygon":
      return geometry.points.flatMap((point, n) => {
        const next = geometry.points[n + 1] ?? (geometry.type === "polygon" ? geometry.points[0] : undefined);
        return next ? [point, ...arcPoints(point, next, geometry.bulges[n] ?? 0)] : [point];
      });
    case "circle":
      return Array.from({ length: 180 }, (_, n) => pointOnCircle(geometry.center, geometry.radius, n * CHORD_ANGLE));
    case "point":
      return [[geometry.x, geometry.y]];
    case "segment":
      return [geometry.start, geometry.end];
    default:
      return geometry.points;
  }
}

/** The four corners of a rectangle, counter-clockwise from the lower left. */
export function rectangleCorners(x: Range, y: Range): Ring {
  return [
    [x[0], y[0]],
    [x[1], y[0]],
    [x[1], y[1]],
    [x[0], y[1]],
  ];
}

/** The four points of a circle on the axes through its center. */
export function quarterPoints({ center, radius }: { center: Point; radius: number }): Ring {
  return offset([...center], [radius, 0], [0, radius], [-radius, 0], [0, -radius]);
}

function pointOnCircle([x, y]: Point, radius: number, angle: number): Point {
  return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
}

/** Points on an arc between two corners, without its ends; bulge is tan of a quarter of its angle. */
function arcPoints(from: Point, to: Point, bulge: number): Point[] {
  if (bulge === 0) return [];
  const chord: Point = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(...chord);
  if (length === 0) return [];
  const sweep = 4 * Math.atan(bulge);
  // the center lies on the chord's normal, to its left for a counter-clockwise arc below a half circle
  const off = length / 2 / Math.tan(sweep / 2);
  const [x, y] = pointBetween(from, to);
  const center: Point = [x - (chord[1] / length) * off, y + (chord[0] / length) * off];
  const start = Math.atan2(from[1] - center[1], from[0] - center[0]);
  const radius = distanceBetween(from, center);
  const steps = Math.max(2, Math.ceil(Math.abs(sweep) / CHORD_ANGLE));
  const angles = Array.from({ length: steps - 1 }, (_, n) => start + (sweep * (n + 1)) / steps);
  return angles.map((angle) => pointOnCircle(center, radius, angle));
}

/** Return the middle of the arc between two corners. */
export function arcMiddle(from: Point, to: Point, bulge: number): Point {
  const [x, y] = pointBetween(from, to);
  // the arc rises by bulge times half the chord, to the right of a counter-clockwise one's chord
  return [x + (bulge / 2) * (to[1] - from[1]), y - (bulge / 2) * (to[0] - from[0])];
}

/** Return the bulge of the arc between two corners through a third place; 0 for a straight edge. */
export function bulgeThrough(from: Point, to: Point, place: Point): number {
  const [a, b] = [from, to].map((end): Point => [end[0] - place[0], end[1] - place[1]]) as [Point, Point];
  const cross = a[0] * b[1] - a[1] * b[0];
  // the ends are seen from any place of the arc under pi less half the arc's angle
  const seen = Math.atan2(Math.abs(cross), a[0] * b[0] + a[1] * b[1]);
  const bulge = Math.tan((Math.PI - seen) / 2);
  return Number((-Math.sign(cross) * bulge).toFixed(6)) + 0;
}

/** Whether a geometry encloses an area. */
export function isClosed(geometry: Geometry): boolean {
  return geometry.type === "fixed" ? geometry.closed : !["point", "line", "segment"].includes(geometry.type);
}

/** The area inside a ring, positive if counterclockwise. */
export function signedArea(ring: Ring): number {
  let twice = 0;
  ring.forEach(([x, y], n) => {
    const [u, v] = ring[(n + 1) % ring.length] ?? [x, y];
    twice += x * v - u * y;
  });
  return twice / 2;
}

/** Whether a place lies inside a ring. */
export function isInside(ring: Ring, [x, y]: Point): boolean {
  let within = false;
  ring.forEach(([x0, y0], n) => {
    const [x1, y1] = ring[(n + 1) % ring.length] ?? [x0, y0];
    if (y0 > y !== y1 > y && x < x0 + ((y - y0) / (y1 - y0)) * (x1 - x0)) within = !within;
  });
  return within;
}

/** The place on a straight piece that is nearest to a place, and how far away it is. */
export function nearestOnSegment(a: Point, b: Point, [x, y]: Point): { at: Point; distance: number } {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const square = dx * dx + dy * dy;
  const share = square === 0 ? 0 : Math.min(1, Math.max(0, ((x - a[0]) * dx + (y - a[1]) * dy) / square));
  const at = pointBetween(a, b, share);
  return { at, distance: distanceBetween(at, [x, y]) };
}

/** The rectangle [x0, y0, x1, y1] around places, null if there are none. */
export function boundsOf(points: Iterable<Point>): Box | null {
  const box = boxAround(points);
  return box[0] <= box[2] ? box : null;
}

/** Return a geometry moved by a step. */
export function moveGeometry(geometry: Geometry, [dx, dy]: Point): Geometry {
  const shift = ([x, y]: Point): Point => [x + dx, y + dy];
  switch (geometry.type) {
    case "sides":
      return geometry;
    case "box":
      return { ...geometry, x: [geometry.x[0] + dx, geometry.x[1] + dx], y: [geometry.y[0] + dy, geometry.y[1] + dy] };
    case "circle":
      return { ...geometry, center: shift(geometry.center) };
    case "point":
      return { ...geometry, x: geometry.x + dx, y: geometry.y + dy };
    case "segment":
      return { ...geometry, start: shift(geometry.start), end: shift(geometry.end) };
    default:
      return { ...geometry, points: geometry.points.map(shift) };
  }
}

/** The keys of the case file that hold lengths of a geometry, and its properties. */
const LENGTHS: Record<Geometry["type"], Record<string, string>> = {
  sides: { length_x: "x", length_y: "y" },
  box: { x: "x", y: "y" },
  point: { x: "x", y: "y" },
  circle: { centre: "center", radius: "radius" },
  segment: { start: "start", end: "end" },
  line: { points: "points" },
  polygon: { points: "points" },
  fixed: {},
};

/** Return the edits that write a geometry in place of an older one of the same type. */
export function editsBetween(before: Geometry, after: Geometry): Edit[] {
  const differs = (a: unknown, b: unknown) => JSON.stringify(a) !== JSON.stringify(b);
  const [old, value] = [before, after] as unknown as Record<string, number | readonly unknown[]>[];
  const edits = Object.entries(LENGTHS[before.type]).flatMap(([key, property]): Edit[] =>
    differs(old?.[property], value?.[property])
      ? [{ op: "length", path: [...before.at, key], value: value![property]! }]
      : [],
  );
  if ("bulges" in before && "bulges" in after && differs(before.bulges, after.bulges))
    edits.push({ op: "set", path: [...before.at, "bulges"], value: [...after.bulges] });
  return edits;
}

/** Return the corner of a ring nearest to a place. */
export function nearestCorner(ring: Ring, at: Point): Point {
  const isNearer = (a: Point, b: Point) => distanceBetween(a, at) < distanceBetween(b, at);
  return ring.reduce((best, each) => (isNearer(each, best) ? each : best), ring[0] ?? at);
}
