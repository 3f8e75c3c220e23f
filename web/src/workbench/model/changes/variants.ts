// Switching a table to another kind: what both kinds share stays, what the other needs is filled in.

import type { Box } from "../../../viewer/data/boxes";
import { defaultsFor } from "../defaults";
import type { Edit } from "../edits";
import { boundsOf, type Point, quarterPoints, readGeometry, readSides, rectangleCorners, ringOf } from "../geometry";
import { type Json, type Path, pathKey, sameValue, type Table, tableAt, valueAt } from "../paths";
import { formatLength } from "../quantities";
import type { Field, Node, Part } from "../schema";

/** Values that a switch of kind took away, by path and kind, to be put back by switching back. */
export type Memory = Map<string, Table>;

/** The edits that make the table at a path another kind. */
export function switchKind(data: Table, path: Path, from: Part | null, to: Part, memory: Memory): Edit[] {
  return replaceTable(data, path, convertTable(data, path, tableAt(data, path), from, to, memory));
}

/** The edits that make the table at a path this one, key by key. */
export function replaceTable(data: Table, path: Path, wanted: Table): Edit[] {
  const old = tableAt(data, path);
  if (valueAt(data, path) === undefined) return [{ op: "set", path, value: wanted }];
  const edits: Edit[] = [];
  if (wanted.kind) edits.push({ op: "set", path: [...path, "kind"], value: wanted.kind });
  for (const key of Object.keys(old)) if (!(key in wanted)) edits.push({ op: "remove", path: [...path, key] });
  for (const [key, value] of Object.entries(wanted)) {
    if (key !== "kind" && !sameValue(value, old[key])) edits.push({ op: "set", path: [...path, key], value });
  }
  return edits;
}

/** The table after the switch; `place` is what the memory calls it by. */
export function convertTable(
  data: Table,
  path: Path,
  old: Table,
  from: Part | null,
  to: Part,
  memory: Memory,
  place: Path = path,
): Table {
  if (from) memory.set(pathKey([...place, from.name]), old);
  const table: Table = to.kind ? { kind: to.kind } : {};
  const shared = new Map((from?.fields ?? []).map((field) => [field.name, field]));
  for (const field of to.fields) {
    const own = old[field.name];
    const previous = shared.get(field.name);
    if (own !== undefined && field.node.is !== "tag" && (!previous || isCompatible(previous, field)))
      table[field.name] = own;
  }
  // what the table was before it had another kind is complete: defaults would say a thing twice
  const given = memory.get(pathKey([...place, to.name])) ?? defaultsFor(to.name, data);
  const filled: Table = { ...defaultPlacement(data, path, to, old), ...defaultsFor(to.name, data), ...given };
  for (const field of to.fields) {
    const value = filled[field.name];
    const wanted = field.needed || field.name in given || needsPlace(to, field);
    if (table[field.name] === undefined && value !== undefined && wanted) table[field.name] = value;
  }
  return table;
}

/** Whether a value of one field means the same in another: same kind of value, same dimension, parts in common. */
function isCompatible(a: Field, b: Field): boolean {
  const [parts, others] = [partNames(a.node), partNames(b.node)];
  return (
    JSON.stringify(a.node) === JSON.stringify(b.node) ||
    (a.node.is === b.node.is && parts.some((part) => others.includes(part)))
  );
}

function partNames(node: Node): readonly string[] {
  if (node.is === "list") return partNames(node.of);
  if (node.is === "part") return [node.part];
  return node.is === "kinds" ? node.parts : [];
}

/** Whether a place is filled in although the schema does not require it. */
function needsPlace(part: Part, field: Field): boolean {
  if (part.name === "LineLoad") return field.name === "points";
  return ["PointLoad", "Void", "Circle"].includes(part.name) && ["x", "y", "centre"].includes(field.name);
}

/** Return where a new item is: where the old one was, else in the middle of the plate. */
export function defaultPlacement(data: Table, path: Path, part: Part, old: Table = {}): Table {
  const names = new Set(part.fields.map((field) => field.name));
  const [x0, y0, x1, y1] = boundsFor(data, path, old);
  const [x, y] = [(x0 + x1) / 2, (y0 + y1) / 2];
  const text = ([u, v]: Point): Json[] => [formatLength(u), formatLength(v)];
  const box = { x: [formatLength(x0), formatLength(x1)], y: [formatLength(y0), formatLength(y1)] };
  switch (part.name) {
    case "Rectangle":
      return { kind: "rectangle", ...box };
    case "Polygon":
      return { kind: "polygon", ...cornersFor(data, path, [x0, y0, x1, y1], text) };
    case "Circle":
      return { kind: "circle", centre: text([x, y]), radius: formatLength(Math.min(x1 - x0, y1 - y0) / 2) };
    case "LineLoad":
      return { points: [text([x0, y]), text([x1, y])] };
    case "PatchLoad":
    case "Void":
      return box;
  }
  const made: Table = {};
  if (names.has("shape")) made.shape = { kind: "rectangle", ...box };
  if (names.has("points")) made.points = [text([x0, y]), text([x1, y])];
  if (names.has("start")) Object.assign(made, { start: text([x0, y]), end: text([x1, y]) });
  if (names.has("x") && names.has("y")) Object.assign(made, { x: formatLength(x), y: formatLength(y) });
  if (part.name === "OutputStrip") made.width = formatLength(Math.max(1, Math.round((y1 - y0) / 2)));
  return made;
}

/** Corners of a rectangle; of a circle the ends of its quarters, which stay arcs: the tangent of a quarter of each. */
function cornersFor(data: Table, path: Path, [x0, y0, x1, y1]: Box, text: (at: Point) => Json[]): Table {
  const geometry = path.length > 0 ? readGeometry(data, path) : null;
  if (geometry?.type !== "circle") return { points: rectangleCorners([x0, x1], [y0, y1]).map(text) };
  const ends = quarterPoints(geometry);
  return { points: ends.map(text), bulges: ends.map(() => Math.tan(Math.PI / 8)) };
}

function boundsFor(data: Table, path: Path, old: Table): Box {
  const own = Object.keys(old).length > 0 ? (readGeometry(data, path) ?? readGeometry(data, [...path, "shape"])) : null;
  const bounds = own ? boundsOf(ringOf(own)) : null;
  if (bounds && bounds[2] > bounds[0] && bounds[3] > bounds[1]) return bounds;
  const slab = readSides(data) ?? readGeometry(data, ["plate", "outline"]);
  const [x0, y0, x1, y1] = (slab ? boundsOf(ringOf(slab)) : null) ?? [-3, -2, 3, 2];
  if (path[0] === "plate" && path[1] === "outline") return [x0, y0, x1, y1];
  // a quarter of the plate about its middle, or about where the old item was
  const [x, y] = bounds ? [(bounds[0] + bounds[2]) / 2, (bounds[1] + bounds[3]) / 2] : [(x0 + x1) / 2, (y0 + y1) / 2];
  const half = Math.max(0.1, Math.round(Math.min(x1 - x0, y1 - y0) * 1.25) / 10);
  return [x - half, y - half, x + half, y + half];
}
