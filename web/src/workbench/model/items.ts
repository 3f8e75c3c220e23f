// Items of the case file that have a place in plan.

import type { Kind } from "../../viewer/plan/symbols";
import { counted, say, together, verbatim } from "../../viewer/shared/language";
import { piecesOf } from "./doors";
import {
  boundsOf,
  type Geometry,
  type Point,
  type Ring,
  readGeometry,
  readSides,
  rectangleCorners,
  ringOf,
} from "./geometry";
import { applyTo, rotation } from "./isometry";
import { formatPath, isTable, type Json, listAt, type Path, samePath, type Table, tableAt } from "./paths";
import { patternFeet } from "./patterns";
import { readJoint } from "./plates";
import { parseLength } from "./quantities";

export interface Item {
  kind: Kind;
  /** Its path in the case file: what is selected, moved, removed. */
  path: Path;
  /** Its title: `column A1`, `opening 2`. */
  title: string;
  table: Table;
  geometry: Geometry;
  /** A column's cross-section, a load's footprint. */
  foot: Ring | null;
  /** The footprints of the forces of a pattern that stands. */
  feet?: readonly Ring[];
  /** What there is of a wall between its doors, and of a load on it. */
  pieces?: readonly Ring[] | undefined;
  /** Whether it can be moved and reshaped; a load on a column, a wall or a core goes with that. */
  movable: boolean;
}

interface Source {
  kind: Kind;
  list: Path;
  /** What it is called, if not by its kind. */
  word?: string;
  /** The key of the geometry. */
  below?: string;
}

const SOURCES: readonly Source[] = [
  { kind: "plate", list: ["plates"], below: "outline" },
  { kind: "joint", list: ["joints"] },
  { kind: "soil zone", list: ["soil_zones"], below: "shape" },
  { kind: "zone", list: ["plate", "zones"], below: "shape" },
  { kind: "opening", list: ["plate", "openings"] },
  { kind: "void", list: ["contact", "voids"] },
  { kind: "gap", list: ["contact", "gaps"], word: "measured gap" },
  { kind: "support", list: ["supports"] },
  { kind: "wall", list: ["walls"] },
  { kind: "beam", list: ["beams"] },
  { kind: "column", list: ["columns"] },
  { kind: "load", list: ["loads"] },
  { kind: "move", list: ["moves"], word: "pattern" },
  { kind: "borehole", list: ["boreholes"] },
  { kind: "refinement", list: ["mesh", "refine"], word: "refined mesh", below: "shape" },
  { kind: "strip", list: ["output", "strips"] },
  { kind: "section line", list: ["output", "lines"] },
  { kind: "output point", list: ["output", "points"] },
];

/** Whether an item fills the view like the slab. */
export function isPlate({ kind }: Item): boolean {
  return kind === "slab" || kind === "plate";
}

/** What items are called. */
export const ITEM_WORDS: readonly string[] = SOURCES.map(({ word, kind }) => word ?? kind);

/** Kinds of loads that have no place of their own in plan. */
export const UNPLACED: ReadonlySet<string> = new Set([
  "uniform",
  "self weight",
  "temperature",
  "shrinkage",
  "settlement",
]);

/** Everything that can be drawn, from below upwards; what cannot be read here is taken from the server's plan. */
export function itemsOf(data: Table, plan: Table | null): Item[] {
  return [...slabItem(data, plan), ...sourcesOf(data).flatMap((source) => itemsFrom(source, data, plan))];
}

/** Return all lists of items, those within further plates after these. */
function sourcesOf(data: Table): Source[] {
  const inner = listAt(data, ["plates"]).flatMap((_, n): Source[] => [
    { kind: "zone", list: ["plates", n, "zones"], below: "shape" },
    { kind: "opening", list: ["plates", n, "openings"] },
  ]);
  return [...SOURCES.slice(0, 1), ...inner, ...SOURCES.slice(1)];
}

function slabItem(data: Table, plan: Table | null): Item[] {
  const table = tableAt(data, ["plate"]);
  const outlined = table.outline !== undefined;
  const path: Path = outlined ? ["plate", "outline"] : ["plate"];
  const geometry = (outlined ? readGeometry(data, path) : readSides(data)) ?? fixedGeometry(plan?.outline, path);
  return geometry ? [{ kind: "slab", path, title: "slab", table, geometry, foot: null, movable: outlined }] : [];
}

function itemsFrom(source: Source, data: Table, plan: Table | null): Item[] {
  return listAt(data, source.list).flatMap((table, n): Item[] => {
    if (!isTable(table)) return [];
    const path = [...source.list, n];
    const title = titleOf(source.word ?? source.kind, table, n);
    const host = source.kind === "load" ? hostOf(data, table, path, plan) : null;
    if (host) return [{ ...host, kind: source.kind, path, title, table, foot: null, movable: false }];
    if (source.kind === "load" && UNPLACED.has(String(table.kind))) return [];
    if (source.kind === "joint") {
      const joint = readJoint(data, path);
      return joint ? [{ kind: "joint", path, title, table, geometry: joint, foot: null, movable: false }] : [];
    }
    const at = source.below ? [...path, source.below] : path;
    const geometry = readOwn(data, at, table, path) ?? fromPlan(plan, path);
    const feet = geometry && source.kind === "move" ? { feet: patternFeet(data, table, geometry) } : {};
    const pieces = geometry && source.kind === "wall" ? piecesOf(table, geometry) : undefined;
    return geometry
      ? [
          {
            ...feet,
            pieces,
            kind: source.kind,
            path,
            title,
            table,
            geometry,
            foot: footprintOf(table, geometry),
            // a wall along a slab's edge goes with that
            movable: source.kind !== "wall" || table.edge === undefined,
          },
        ]
      : [];
  });
}

/** Return the geometry that a table has itself, or in its shape. */
function readOwn(data: Table, at: Path, table: Table, path: Path): Geometry | null {
  return readGeometry(data, at) ?? (table.shape === undefined ? null : readGeometry(data, [...path, "shape"]));
}

/** Return the title of an item: its kind and its name, else its number. */
function titleOf(word: string, table: Table, position: number): string {
  const kinds =
    word === "load" || word === "support" ? `${typeof table.kind === "string" ? table.kind : ""} ${word}`.trim() : word;
  const name = typeof table.name === "string" ? table.name : "";
  return say(`${kinds} {name}`, { name: verbatim(name || String(position + 1)) });
}

/** Return the title of the item at a path, also of one without a place in plan. */
export function titleAt(data: Table, path: Path): string {
  const source = sourcesOf(data).find((each) => samePath(each.list, path.slice(0, -1)));
  const position = path.at(-1);
  if (source && typeof position === "number") return titleOf(source.word ?? source.kind, tableAt(data, path), position);
  if (path[0] === "axes" && typeof position === "number") return say("axes {number}", { number: position + 1 });
  return path[0] === "plate" && path.length < 3 ? "slab" : formatPath(path);
}

/** Return what the items at some paths are called together. */
export function titleOfAll(data: Table, paths: readonly Path[]): string {
  const sources = sourcesOf(data);
  const kindAt = (path: Path) => sources.find((each) => samePath(each.list, path.slice(0, -1)));
  const items = paths.map((path) => {
    const source = kindAt(path);
    return { kind: source?.word ?? source?.kind ?? ("slab" as const), title: titleAt(data, path) };
  });
  return countItems(items);
}

/** Where a load acts that names what stands there: where that is, and its parts that there are. */
interface Host {
  geometry: Geometry;
  pieces?: readonly Ring[] | undefined;
}

/** Return where the column, the wall or the core is that a load names, null if it names none that is known. */
function hostOf(data: Table, load: Table, at: Path, plan: Table | null): Host | null {
  const column = columnOf(data, load, at);
  if (column) return { geometry: column };
  if (load.kind !== "core") return wallOf(data, load, at, plan);
  const geometry = fromPlan(plan, at);
  return geometry && { geometry, pieces: piecesFromPlan(plan, at) };
}

/** Return where the column is that a load names, null if it names none that is known. */
function columnOf(data: Table, load: Table, at: Path): Geometry | null {
  if (typeof load.column !== "string" || !load.column) return null;
  const n = listAt(data, ["columns"]).findIndex((each) => isTable(each) && each.name === load.column);
  const geometry = n < 0 ? null : readGeometry(data, ["columns", n]);
  return geometry?.type === "point" ? { ...geometry, at } : null;
}

/** Return the axis of the wall that a load names, null if it names none that is known. */
function wallOf(data: Table, load: Table, at: Path, plan: Table | null): Host | null {
  if (typeof load.wall !== "string" || !load.wall) return null;
  const n = listAt(data, ["walls"]).findIndex((each) => isTable(each) && each.name === load.wall);
  if (n < 0) return null;
  const path: Path = ["walls", n];
  const geometry = readOwn(data, path, tableAt(data, path), path) ?? fromPlan(plan, path);
  return geometry && { geometry: { ...geometry, at }, pieces: piecesOf(tableAt(data, path), geometry) };
}

/** The outline of a column's cross-section or a load's footprint, null if there is none. */
export function footprintOf(table: Table, geometry: Geometry): Ring | null {
  if (geometry.type !== "point") return null;
  const { x, y } = geometry;
  const diameter = parseLength(table.diameter);
  if (diameter !== null && diameter > 0)
    return ringOf({ type: "circle", at: [], center: [x, y], radius: diameter / 2 });
  const [width, depth] = [parseLength(table.width_x), parseLength(table.width_y)];
  if (width === null || depth === null || width <= 0 || depth <= 0) return null;
  const turn = rotation(typeof table.angle === "number" ? table.angle : 0, [x, y]);
  const corners = rectangleCorners([x - width / 2, x + width / 2], [y - depth / 2, y + depth / 2]);
  return corners.map((corner) => applyTo(turn, corner));
}

/** Return a geometry from the server's plan, which can be moved but not reshaped. */
function fromPlan(plan: Table | null, path: Path): Geometry | null {
  const found = inPlan(plan, path);
  if (!found) return null;
  if (typeof found.x === "number" && typeof found.y === "number")
    return { type: "point", at: path, x: found.x, y: found.y };
  const line = found.points ?? (found.start && found.end ? [found.start, found.end] : undefined);
  return fixedGeometry(found.ring ?? line, path, found.ring !== undefined);
}

/** Return the pieces of an item in the server's plan, undefined if it has none. */
function piecesFromPlan(plan: Table | null, path: Path): Ring[] | undefined {
  const pieces = inPlan(plan, path)?.pieces;
  return Array.isArray(pieces) ? pieces.map(readPoints) : undefined;
}

/** Return what the server's plan says of an item, null if it does not know it. */
function inPlan(plan: Table | null, path: Path): Table | null {
  const words = formatPath(path);
  for (const list of Object.values(plan ?? {})) {
    const found = Array.isArray(list) ? list.find((each) => isTable(each) && each.path === words) : undefined;
    if (isTable(found)) return found;
  }
  return null;
}

function readPoints(value: Json | undefined): Point[] {
  return (Array.isArray(value) ? value : []).flatMap((each): Point[] =>
    Array.isArray(each) && typeof each[0] === "number" && typeof each[1] === "number" ? [[each[0], each[1]]] : [],
  );
}

function fixedGeometry(value: Json | undefined, at: Path, closed = true): Geometry | null {
  const points = readPoints(value);
  return points.length > 0 ? { type: "fixed", at, points, closed } : null;
}

/** Return what several items are called together: `2 columns, 3 loads`; of one, its title. */
export function countItems(items: readonly { kind: string; title: string }[]): string {
  if (items.length === 1) return items[0]!.title;
  const counts = new Map<string, number>();
  for (const { kind } of items) counts.set(kind, (counts.get(kind) ?? 0) + 1);
  return together(
    [...counts].map(([kind, count]) => counted(count, `{count} ${kind}`, `{count} ${severalOf(kind)}`)),
    ", ",
  );
}

/** Return the plural of what items are called. */
export function severalOf(word: string): string {
  return word.endsWith("sh") ? `${word}es` : `${word}s`;
}

/** Return the loads that go with columns and walls which are moved. */
export function loadsOn(items: readonly Item[], hosts: readonly Item[]): Item[] {
  const names = (host: Item["kind"]) =>
    new Set(hosts.filter(({ kind }) => kind === host).map(({ table }) => table.name));
  const [columns, walls] = [names("column"), names("wall")];
  return items.filter(
    ({ kind, movable, table }) =>
      kind === "load" && !movable && (columns.has(table.column ?? "") || walls.has(table.wall ?? "")),
  );
}

/** The rectangle around everything drawn, null if there is nothing. */
export function boundsOfItems(items: readonly Item[]): [number, number, number, number] | null {
  return boundsOf(items.flatMap((item) => [...ringOf(item.geometry)]));
}
