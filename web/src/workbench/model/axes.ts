// Axes of the building: where they are and cross, and the places of what is attached to them, as the server finds them.
import { isTable, type Json, listAt, type Path, type Table } from "./paths";
import { parseLength, parsePoint } from "./quantities";

type Point = readonly [number, number];

/** One axis: a straight one through a place, a ray that begins there, or a ring about it. */
export interface Axis {
  name: string;
  /** The path of its family, and its position in it. */
  path: Path;
  position: number;
  place: Point;
  /** Of length 1, null of rings. */
  direction: Point | null;
  radius: number;
  ray: boolean;
}

/** Stands between the names of axes that cross. */
export const BETWEEN = "/";
const SAME = 1e-6; // m: places so near are one
const ROUNDED = 1e9;

const known = new WeakMap<Json[], Axis[]>();

/** Return all axes of a case, without those that cannot be read here. */
export function axesIn(data: Json | undefined): Axis[] {
  const families = listAt(data, ["axes"]);
  const before = known.get(families);
  if (before) return before;
  const axes = families.flatMap((family, n) => (isTable(family) ? axesOfFamily(family, ["axes", n]) : []));
  known.set(families, axes);
  return axes;
}

function axesOfFamily(family: Table, path: Path): Axis[] {
  const place = placeOf(family.kind === "straight" ? family.origin : family.centre);
  if (!place) return [];
  const angles = listAt(family, ["angles"]).filter((each) => typeof each === "number");
  const distances = parseDistances(family.distances) ?? [];
  const ways = [0];
  for (const each of distances) ways.push(ways.at(-1)! + each);
  const count = family.kind === "ray" ? angles.length : family.kind === "ring" ? distances.length : ways.length;
  const names = namesOf(family, count);
  const axis = (position: number, at: Point, direction: Point | null, radius = 0): Axis => ({
    name: names[position] ?? "",
    path,
    position,
    place: at,
    direction,
    radius,
    ray: family.kind === "ray",
  });
  if (family.kind === "ray") return angles.map((angle, n) => axis(n, place, directionOf(angle)));
  if (distances.length === 0) return [];
  if (family.kind === "ring") return ways.slice(1).map((radius, n) => axis(n, place, null, radius));
  const [u, v] = directionOf(typeof family.angle === "number" ? family.angle : 0);
  return ways.map((way, n) => axis(n, [place[0] + way * u, place[1] + way * v], [-v, u]));
}

function placeOf(value: Json | undefined): Point | null {
  return value === undefined ? [0, 0] : parsePoint(value);
}

function namesOf(family: Table, count: number): string[] {
  const names = listAt(family, ["names"]).map(String);
  const first = typeof family.first === "string" ? family.first : family.kind === "ray" ? "1" : "A";
  return names.length > 0 ? names : countOn(first, count);
}

/** Return so many names from the first one on: A, B, C or 1, 2, 3; after Z comes AA. */
export function countOn(first: string, count: number): string[] {
  const numbers = Array.from({ length: count }, (_, n) => n);
  const [, stem = "", from] = /^(.*?)(\d{1,6})$/.exec(first) ?? [];
  if (from !== undefined) return numbers.map((n) => `${stem}${Number(from) + n}`);
  if (!/^[A-Za-z]+$/.test(first)) return numbers.map((n) => (n === 0 ? first : `${first}${n + 1}`));
  const start = [...first.toUpperCase()].reduce((sum, letter) => 26 * sum + letter.charCodeAt(0) - 64, 0) - 1;
  const isLower = first === first.toLowerCase();
  return numbers.map((n) => (isLower ? letters(start + n).toLowerCase() : letters(start + n)));
}

/** Return the letters at a position among A to Z, AA, AB. */
export function letters(n: number): string {
  return n < 26 ? String.fromCharCode(65 + n) : letters(Math.floor(n / 26) - 1) + letters(n % 26);
}

/** Return the direction of an angle [degrees], exactly along x or y for right angles. */
export function directionOf(degrees: number): Point {
  const turned = ((degrees % 360) + 360) % 360;
  const exact: Record<number, Point> = { 0: [1, 0], 90: [0, 1], 180: [-1, 0], 270: [0, -1] };
  const angle = (degrees * Math.PI) / 180;
  return exact[turned] ?? [Math.cos(angle), Math.sin(angle)];
}

/** Return the distances of a text such as `3 x 6 m, 4.5 m` [m], null if it is none. */
export function parseDistances(value: Json | undefined): number[] | null {
  if (typeof value !== "string") return null;
  const found = value.split(/[,;]/).flatMap((part) => {
    const [, times = "1", one = part] = /^\s*(\d{1,3})\s*[x×*]\s*(.+)$/s.exec(part) ?? [];
    return Array<number>(Number(times)).fill(parseLength(one) ?? Number.NaN);
  });
  return found.length > 0 && found.every((each) => each > 0) ? found : null;
}

/** Return where two axes cross. */
function crossings(one: Axis, other: Axis): Point[] {
  if (!one.direction) return other.direction ? crossings(other, one) : [];
  const [[x, y], [u, v]] = [one.place, one.direction];
  const [dx, dy] = [other.place[0] - x, other.place[1] - y];
  const at = (way: number): Point => [roundOff(x + way * u), roundOff(y + way * v)];
  if (other.direction) {
    const [s, t] = other.direction;
    const cross = u * t - v * s;
    if (Math.abs(cross) < 1e-9) return [];
    const [way, otherWay] = [(dx * t - dy * s) / cross, (dx * v - dy * u) / cross];
    return (one.ray && way < -1e-9) || (other.ray && otherWay < -1e-9) ? [] : [at(way)];
  }
  const [middle, off] = [dx * u + dy * v, dx * v - dy * u];
  if (Math.abs(off) > other.radius + 1e-9) return [];
  const half = Math.sqrt(Math.max(0, other.radius ** 2 - off ** 2));
  const ways = half < 1e-9 ? [middle] : [middle - half, middle + half];
  return ways.filter((way) => !one.ray || way >= -1e-9).map(at);
}

function roundOff(value: number): number {
  return Math.round(value * ROUNDED) / ROUNDED + 0;
}

/** Return where the axes cross that a text such as `B/3` names, null unless that is one place. */
export function crossingOf(text: Json | undefined, axes: readonly Axis[]): Point | null {
  const names = typeof text === "string" ? text.split(BETWEEN).map((name) => name.trim()) : [];
  const [one, other] = names.map((name) => axes.find((axis) => axis.name === name));
  if (names.length !== 2 || !one || !other) return null;
  const places = crossings(one, other);
  return places.length === 1 ? places[0]! : null;
}

/** A place where two axes cross, with their names. */
export interface NamedCrossing {
  at: Point;
  name: string;
}

/** Return all places where two axes cross once. */
export function crossingsOf(axes: readonly Axis[]): NamedCrossing[] {
  return axes.flatMap((one, n) =>
    axes.slice(n + 1).flatMap((other): NamedCrossing[] => {
      const places = crossings(one, other);
      return places.length === 1 ? [{ at: places[0]!, name: `${one.name}${BETWEEN}${other.name}` }] : [];
    }),
  );
}

/** Return the names of the first two axes that cross at a place, empty if none do. */
export function nameOfCrossing(at: Point, axes: readonly Axis[]): string {
  const near = axes.filter((axis) => distanceTo(axis, at) <= SAME);
  for (const [n, one] of near.entries())
    for (const other of near.slice(n + 1))
      if (crossings(one, other).length === 1) return one.name + BETWEEN + other.name;
  return "";
}

/** Return how far a place is from an axis. */
export function distanceTo(axis: Axis, at: Point): number {
  const [x, y] = nearestOn(axis, at);
  return Math.hypot(at[0] - x, at[1] - y);
}

/** Return the place on an axis that is nearest to another one. */
export function nearestOn({ place: [x, y], direction, radius, ray }: Axis, at: Point): Point {
  const [dx, dy] = [at[0] - x, at[1] - y];
  if (!direction) {
    const length = Math.hypot(dx, dy) || 1;
    return [x + (dx / length) * radius, y + (dy / length) * radius];
  }
  const way = dx * direction[0] + dy * direction[1];
  const along = ray ? Math.max(0, way) : way;
  return [x + along * direction[0], y + along * direction[1]];
}

/** Return the places at which something is attached to axes: one of a point; null if it is to none that are known. */
export function attachedPlaces(table: Table, axes: readonly Axis[]): Point[] | null {
  if (table.at === undefined || table.at === "") return null;
  const texts = Array.isArray(table.at) ? table.at : [table.at];
  const places = texts.map((text) => crossingOf(text, axes));
  return places.length > 0 && places.every((place) => place !== null) ? (places as Point[]) : null;
}

/** Whether something is attached to axes. */
export function isAttached({ at }: Table): boolean {
  return Array.isArray(at) ? at.length > 0 : at !== undefined && at !== "";
}
