// The drawing of the case file's items, and the marks around the selected one.

import { withMinus } from "../../viewer/data/numbers";
import { distanceBetween } from "../../viewer/data/points";
import type { Camera } from "../../viewer/plan/camera";
import { drawSymbol, drawText, type PlanSymbol } from "../../viewer/plan/symbols";
import { thinLoads, thinTexts } from "../../viewer/plan/thinning";
import { svg } from "../../viewer/shared/dom";
import { say } from "../../viewer/shared/language";
import { caseColor } from "../model/case-colors";
import { isClosed, type Point, type Ring, readGeometry, ringOf } from "../model/geometry";
import type { Item } from "../model/items";
import { isTable, type Json, listAt, type Path, pathKey, samePath, startsWith, type Table } from "../model/paths";
import { formatDecimals, parseLength } from "../model/quantities";

const HANDLE = 8; // px: side of a handle

/** Which items are drawn how. */
export interface Highlights {
  selected: readonly Path[];
  /** The item under the pointer. */
  hovered: Path | null;
  /** Paths with issues. */
  faulty: readonly Path[];
  /** The load case whose loads stand out; empty for all. */
  loadCase: string;
  /** The names of all load cases, whose order gives their loads colors; left out, loads have one. */
  cases?: readonly string[];
}

/** Drawings of items by their paths, each with all that it shows. */
export type Drawn = Map<string, { looks: string; element: SVGElement }>;

/** Draw all items of a model, from below upwards; of what was drawn by the same camera, what looks the same stays. */
export function drawItems(
  camera: Camera,
  items: readonly Item[],
  highlights: Highlights,
  drawn: Drawn = new Map(),
): SVGElement[] {
  const loadsAt = new Map<string, Item[]>();
  for (const item of items.filter((each) => each.kind === "load"))
    loadsAt.set(placeKey(item), [...(loadsAt.get(placeKey(item)) ?? []), item]);
  const isMarked = ({ path }: Item) => samePath(highlights.hovered, path) || isSelected(path);
  const isSelected = (path: Path) => highlights.selected.some((each) => samePath(each, path));
  const symbols = items.map((item) => symbolOf(item, loadsAt.get(placeKey(item)) ?? [], highlights));
  const thinned = thinLoads(symbols, camera, (n) => isMarked(items[n]!));
  const elements = items.map((item, n) => {
    const path = pathKey(item.path);
    const symbol = thinned[n]!;
    const attributes = {
      class: classesOf(item, highlights),
      style: colorOf(item, highlights),
      "data-path": path,
      "data-kind": item.kind,
    };
    const looks = JSON.stringify([attributes, symbol]);
    const before = drawn.get(path);
    if (before?.looks === looks) return before.element;
    const element = svg("g", attributes, ...drawSymbol(camera, symbol));
    drawn.set(path, { looks, element });
    return element;
  });
  // texts of what is marked come first
  const first = items.flatMap((item, n) => (isMarked(item) ? [elements[n]!] : []));
  thinTexts([...first, ...elements.filter((element) => !first.includes(element))]);
  return elements;
}

/** Return the color of a load's case as a style, null for that of all loads. */
function colorOf({ kind, table }: Item, { cases = [] }: Highlights): string | null {
  const position = kind === "load" || kind === "move" ? cases.indexOf(String(table.case ?? "")) : 0;
  return position > 0 ? `--gs-load:${caseColor(position)}` : null;
}

/** Return a key that loads at the same place share. */
function placeKey({ geometry }: Item): string {
  return geometry.type === "point" ? `${geometry.x} ${geometry.y}` : JSON.stringify({ ...geometry, at: 0 });
}

function classesOf(item: Item, { selected, hovered, faulty, loadCase }: Highlights): string {
  const isFaulty = item.kind !== "slab" && faulty.some((path) => startsWith(path, item.path));
  const marks = {
    selected: selected.some((path) => samePath(path, item.path)),
    hovered: samePath(hovered, item.path),
    faulty: isFaulty,
    "on-ground": item.table.on === "ground",
    faint: (item.kind === "load" || item.kind === "move") && loadCase !== "" && item.table.case !== loadCase,
  };
  const names = Object.entries(marks).flatMap(([name, on]) => (on ? [name] : []));
  return ["symbol", item.kind.replaceAll(" ", "-"), ...names].join(" ");
}

/** Return the symbol of an item; `loads` are those at its place. */
function symbolOf(item: Item, loads: readonly Item[], highlights: Highlights): PlanSymbol {
  const { kind, table, geometry, foot } = item;
  const ring = ringOf(geometry);
  const closed = isClosed(geometry);
  const isLine = kind === "wall" || kind === "beam" || (kind === "load" && /^(line|core)/.test(String(table.kind)));
  const texts = kind === "load" ? loadTexts(item, loads, highlights) : textsOf(item);
  return {
    kind,
    shape: geometry.type === "point" ? "point" : closed && !isLine ? "area" : "line",
    points: closed && isLine ? [...ring, ...ring.slice(0, 1)] : ring,
    pieces: item.pieces,
    texts: texts ?? [],
    foot,
    holes: kind === "load" ? holesOf(item) : kind === "move" ? (item.feet ?? []) : [],
    hidden: texts === null,
    upward: /^\s*-/.test(String(table.P ?? "")),
    elastic: table.stiffness !== undefined,
    width: parseLength(widthOf(item)) ?? 0,
  };
}

/** Return how wide an item is: a wall by its thickness, a beam by its section. */
function widthOf({ kind, table }: Item): Json | undefined {
  if (kind === "wall") return table.thickness;
  return kind === "beam" && isTable(table.section) ? table.section.width : table.width;
}

function nameOf(item: Item): string {
  return typeof item.table.name === "string" ? item.table.name : "";
}

/** Return what stands in a zone: its thickness, and the level of a pit, as they are written. */
function zoneText({ thickness, level }: Table): string {
  const known = Object.entries({ t: thickness, z: level }).filter(([, value]) => value !== undefined);
  return known.map(([name, value]) => `${name} = ${String(value)}`).join(", ");
}

function textsOf(item: Item): string[] {
  switch (item.kind) {
    case "zone":
      return [zoneText(item.table)].filter(Boolean);
    case "refinement":
      return [`h = ${String(item.table.size ?? "")}`];
    case "move":
      return [nameOf(item) || String(item.table.pattern ?? "")];
    case "soil zone":
    case "void":
      return [item.title];
    case "output point":
    case "gap":
      return [nameOf(item) || item.title];
    default:
      return [nameOf(item)];
  }
}

/** Return the texts of a load; null if another load at the same place shows them. */
function loadTexts(item: Item, here: readonly Item[], { selected, hovered, loadCase }: Highlights): string[] | null {
  const strong = here.filter((each) => !loadCase || each.table.case === loadCase);
  const marked = here.find(
    (each) => selected.some((path) => samePath(path, each.path)) || samePath(hovered, each.path),
  );
  if (item !== (marked ?? strong[0] ?? here[0])) return null;
  const named = marked && strong.length === 0 ? [marked] : strong;
  return marked || strong.length < 2 ? named.map(loadText) : [say("{count} loads", { count: strong.length })];
}

/** Return a load's name and size. */
function loadText(item: Item): string {
  const { table } = item;
  if (table.kind !== "point")
    return withMinus([nameOf(item), String(table.q ?? table.m ?? "")].filter(Boolean).join("  "));
  const moments = ["M_x", "M_y"].flatMap((key) =>
    table[key] === undefined ? [] : [`, ${key.replace("_", "")} ${String(table[key])}`],
  );
  return withMinus(`${String(table.P ?? "")}${moments.join("")}`);
}

/** Return the edges of the parts of an area that are not loaded. */
function holesOf({ table }: Item): Ring[] {
  return listAt(table, ["holes"]).flatMap((_, n) => {
    const hole = readGeometry(table, ["holes", n]);
    return hole ? [ringOf(hole)] : [];
  });
}

/** Draw lengths of a shape's edges, or of a line, beside them. */
export function drawDimensions(camera: Camera, ring: Ring, closed: boolean): SVGElement[] {
  // opposite sides of a rectangle are equal
  const count = !closed ? ring.length - 1 : isBox(ring) ? 2 : ring.length;
  if (count > 24) return [];
  const center = ring.reduce((sum, point) => sum + camera.toPixel(point)[0], 0) / Math.max(1, ring.length);
  return ring.slice(0, Math.max(count, 0)).flatMap((a, n) => {
    const b = ring[(n + 1) % ring.length] ?? a;
    const [p, q] = [camera.toPixel(a), camera.toPixel(b)];
    if (distanceBetween(p, q) < 34) return [];
    const isSteep = Math.abs(q[1] - p[1]) > Math.abs(q[0] - p[0]);
    const x = (p[0] + q[0]) / 2;
    const side = x > center ? -8 : 8;
    const align = !isSteep ? "dimension middle" : x > center ? "dimension end" : "dimension";
    const text = `${formatDecimals(distanceBetween(a, b), 3)} m`;
    return [drawText([x, (p[1] + q[1]) / 2], text, [isSteep ? side : 0, -8], align)];
  });
}

/** Whether a ring is a rectangle along x and y. */
function isBox(ring: Ring): boolean {
  const [a, b, c, d] = ring;
  if (ring.length !== 4 || !a || !b || !c || !d) return false;
  return a[1] === b[1] && b[0] === c[0] && c[1] === d[1] && d[0] === a[0];
}

/** Draw a square handle about a pixel. */
export function drawHandle([x, y]: Readonly<Point>, className = "handle"): SVGElement {
  return svg("rect", { class: className, x: x - HANDLE / 2, y: y - HANDLE / 2, width: HANDLE, height: HANDLE });
}
