// What is attached to axes of the building: detached where it is moved, attached to others, and the axes themselves moved.
import { say, verbatim } from "../../../viewer/shared/language";
import { type Axis, attachedPlaces, isAttached, nameOfCrossing, parseDistances } from "../axes";
import type { Edit } from "../edits";
import { isTable, type Json, listAt, type Path, type Table, tableAt, valueAt } from "../paths";
import { formatDecimals, formatLength, parsePoint, parsePoints } from "../quantities";
import { editsToTable, Impossible } from "./transform";

type Point = readonly [number, number];

/** Lists of what may be attached to axes. */
export const LISTS = ["columns", "walls", "beams", "supports", "loads"];
/** Kinds of loads and supports that may. */
const KINDS: readonly Json[] = ["point", "pile", "line", "line moment"];

/** Return the edit that detaches an item from its axes, if it is attached to any. */
export function detachingEdits({ table, path }: { table: Table; path: Path }): Edit[] {
  return isAttached(table) ? [{ op: "remove", path: [...path, "at"] }] : [];
}

/** Return a table with places of its own instead of crossings of axes. */
export function detach(table: Table, axes: readonly Axis[]): Table {
  if (!isAttached(table)) return table;
  const places = attachedPlaces(table, axes);
  if (!places)
    throw new Impossible(say("it is attached to axes that are not known, {at}", { at: verbatim(String(table.at)) }));
  const { at, ...others } = table;
  if (Array.isArray(at)) return { ...others, points: places.map(writePlace) };
  const [x, y] = writePlace(places[0]!);
  return { ...others, x: x!, y: y! };
}

/** Return a table of a list attached to axes if its places are crossings of these; a line only if all are. */
export function attach(table: Table, list: Json | undefined, axes: readonly Axis[]): Table {
  const mayHang =
    list === "loads" || list === "supports" ? KINDS.includes(table.kind ?? "") : LISTS.includes(String(list));
  if (axes.length < 2 || !mayHang || isAttached(table)) return table;
  const place = parsePoint([table.x ?? "", table.y ?? ""]);
  if (place) {
    const at = nameOfCrossing(place, axes);
    return at ? withAt(table, at, ["x", "y"]) : table;
  }
  const names = parsePoints(table.points)?.map((each) => nameOfCrossing(each, axes));
  if (!names || names.length < 2 || names.includes("") || Array.isArray(table.bulges)) return table;
  return withAt(table, names, ["points"]);
}

/** Return a table with the crossings of axes where its first key with places was, and without these. */
function withAt(table: Table, at: Json, places: readonly string[]): Table {
  const entries = Object.entries(table).map(([key, value]): [string, Json] =>
    key === places[0] ? ["at", at] : [key, value],
  );
  return Object.fromEntries(entries.filter(([key]) => !places.includes(key)));
}

function writePlace([x, y]: Point): Json[] {
  return [formatLength(x), formatLength(y)];
}

/** Return the edits that attach to axes all that stands at their crossings. */
export function attachAll(data: Table, axes: readonly Axis[]): Edit[] {
  return LISTS.flatMap((list) =>
    listAt(data, [list]).flatMap((table, n): Edit[] => {
      if (!isTable(table)) return [];
      const attached = attach(table, list, axes);
      return attached === table ? [] : editsToTable([list, n], table, attached);
    }),
  );
}

/** Return how many parts are attached to axes. */
export function countAttached(data: Table): number {
  return LISTS.reduce(
    (sum, list) => sum + listAt(data, [list]).filter((each) => isTable(each) && isAttached(each)).length,
    0,
  );
}

/** Return distances as the case file writes them: equal ones in a row once. */
export function formatDistances(distances: readonly number[]): string {
  const texts = distances.map((each) => `${formatDecimals(each, 6)} m`);
  const runs: [string, number][] = [];
  for (const text of texts) {
    const last = runs.at(-1);
    if (last?.[0] === text) last[1] += 1;
    else runs.push([text, 1]);
  }
  return runs.map(([text, count]) => (count > 1 ? `${count} x ${text}` : text)).join(", ");
}

/**
 * Return the edits that move one axis sideways [m], the others stay; null where it would pass another one.
 *
 * A straight one moves to where the family counts on, a ring outwards.
 */
export function axisEdits(data: Table, { path, position }: Axis, by: number): Edit[] | null {
  const family = tableAt(data, path);
  const distances = parseDistances(family.distances);
  if (!distances || family.kind === "ray") return null;
  const isRing = family.kind === "ring";
  const moved = [...distances];
  const [before, after] = isRing ? [position, position + 1] : [position - 1, position];
  if (before >= 0) moved[before]! += by;
  if (after < moved.length) moved[after]! -= by;
  if (!moved.every((each) => each > 1e-3)) return null;
  const edits: Edit[] = [{ op: "set", path: [...path, "distances"], value: formatDistances(moved) }];
  if (isRing || position > 0) return edits;
  const origin = parsePoint(valueAt(data, [...path, "origin"])) ?? [0, 0];
  const angle = ((typeof family.angle === "number" ? family.angle : 0) * Math.PI) / 180;
  const place = [origin[0] + by * Math.cos(angle), origin[1] + by * Math.sin(angle)];
  return [...edits, { op: "set", path: [...path, "origin"], value: place.map((each) => formatLength(each)) }];
}

/** Return the edits that turn a ray to an angle [degrees], null where it has none. */
export function angleEdits(data: Table, { path, position }: Axis, angle: number): Edit[] | null {
  const angles = listAt(data, [...path, "angles"]);
  if (typeof angles[position] !== "number") return null;
  const turned = angle >= 360 ? angle - 360 : angle < -180 ? angle + 360 : angle;
  return [{ op: "set", path: [...path, "angles"], value: angles.with(position, Number(turned.toFixed(9))) }];
}
