// The changes that add what was drawn to the case file.
import { say, verbatim } from "../../../viewer/shared/language";
import { axesIn, nameOfCrossing } from "../axes";
import { defaultsFor } from "../defaults";
import type { Addition, Change, Edit } from "../edits";
import { isInside, type Point, type Ring, readGeometry } from "../geometry";
import { footprintOf, titleAt } from "../items";
import { freeName, namesIn, takenNames } from "../names";
import { isTable, type Json, listAt, type Path, type Table, tableAt } from "../paths";
import { edgeAt, platesAt } from "../plates";
import { formatLength } from "../quantities";
import { attach } from "./attachment";

/** What is added; slabs replace the one that is there. */
export type NewKind =
  | "slab"
  | "opening"
  | "zone"
  | "column"
  | "point load"
  | "line load"
  | "area load"
  | "support"
  | "wall"
  | "beam"
  | "line support"
  | "borehole"
  | "soil zone"
  | "void"
  | "section line"
  | "strip"
  | "edge wall"
  | "plate"
  | "joint"
  | "refinement";

export type DrawnShape =
  | { kind: "rectangle"; from: Point; to: Point }
  | { kind: "polygon"; points: Ring }
  | { kind: "circle"; center: Point; radius: number };

const toText = (point: Point): Json[] => [formatLength(point[0]), formatLength(point[1])];

/** Return a drawn shape as a table of the case file. */
function shapeTable(shape: DrawnShape): Table {
  if (shape.kind === "polygon") return { kind: "polygon", points: shape.points.map(toText) };
  if (shape.kind === "circle")
    return { kind: "circle", centre: toText(shape.center), radius: formatLength(shape.radius) };
  const { from, to } = shape;
  const range = (n: 0 | 1) => [Math.min(from[n], to[n]), Math.max(from[n], to[n])].map((each) => formatLength(each));
  return { kind: "rectangle", x: range(0), y: range(1) };
}

function addItem(data: Table, list: Path, table: Table, what: string): Addition {
  const value = attach(table, list[0], axesIn(data));
  const change = { edits: [{ op: "add" as const, path: list, value }], text: say("add {item}", { item: what }) };
  return { change, path: [...list, listAt(data, list).length] };
}

/** Kinds of lines that can be rings. */
export const RINGS: ReadonlySet<string> = new Set(["wall", "beam", "line load"]);

/** Return the change that adds a drawn shape, the edge of which is the axis of what is a line. */
export function addShape(kind: NewKind, data: Table, drawn: DrawnShape, loadCase: string): Addition {
  const shape = shapeTable(drawn);
  const { kind: _, ...sides } = shape;
  const place: Table = drawn.kind === "rectangle" ? sides : { shape };
  if (RINGS.has(kind)) return addAlong(kind, data, { shape }, loadCase);
  switch (kind) {
    case "opening":
      return addItem(data, ["plate", "openings"], shape, kind);
    case "zone":
      return addItem(data, ["plate", "zones"], { ...defaultsFor("Zone", data), shape }, kind);
    case "soil zone":
      return addItem(data, ["soil_zones"], { shape, ground: copyGround(data) }, kind);
    case "plate":
      return addPlate(data, shape);
    case "refinement":
      return addItem(data, ["mesh", "refine"], { shape, size: "100 mm" }, "refined mesh");
    case "void":
      return addItem(data, ["contact", "voids"], { ...defaultsFor("Void", data), ...place }, kind);
    case "area load": {
      const load = drawn.kind === "rectangle" ? "PatchLoad" : "AreaLoad";
      return addItem(data, ["loads"], { ...likeLast(data, load, inCase(data, loadCase)), ...place }, kind);
    }
    default:
      return { change: { edits: outlineEdits(data, shape), text: "draw the slab" }, path: ["plate", "outline"] };
  }
}

/** Return the change that adds a further plate with the thickness and the concrete of the first. */
function addPlate(data: Table, outline: Table): Addition {
  const main = { ...defaultsFor("Plate", data), ...tableAt(data, ["plate"]) };
  const own = ["thickness", "E", "nu", "shear_factor", "thermal_expansion"].filter((key) => key in main);
  const mainName = typeof main.name === "string" ? main.name : "";
  const name = freeName([mainName, ...namesIn(listAt(data, ["plates"]))], "plate 2");
  const values = Object.fromEntries(own.map((key) => [key, main[key]!]));
  const { change, path } = addItem(data, ["plates"], { name, outline, ...values }, name);
  // joints and loads call plates by their names
  const edits: Edit[] = mainName ? [] : [{ op: "set", path: ["plate", "name"], value: "plate 1" }];
  return { change: { ...change, edits: [...edits, ...change.edits] }, path };
}

/** Return the change that joins the two plates whose shared line is at a place, null if there is none. */
export function addJoint(data: Table, at: Point, reach: number): Addition | null {
  const between = platesAt(data, at, reach);
  return (
    between &&
    addItem(
      data,
      ["joints"],
      { kind: "hinge", between },
      say("joint of {plates}", {
        plates: say("{one} and {other}", { one: verbatim(between[0]), other: verbatim(between[1]) }),
      }),
    )
  );
}

/** Return the edits that give the slab another outline, and what else a slab needs if it is missing. */
export function outlineEdits(data: Table, outline: Table): Edit[] {
  const plate = tableAt(data, ["plate"]);
  const sides = ["length_x", "length_y"].filter((key) => key in plate);
  const missing = Object.entries(defaultsFor("Plate", data)).filter(
    ([key]) => !(key in plate) && !key.startsWith("length"),
  );
  return [
    ...sides.map((key): Edit => ({ op: "remove", path: ["plate", key] })),
    ...missing.map(([key, value]): Edit => ({ op: "set", path: ["plate", key], value })),
    { op: "set", path: ["plate", "outline"], value: outline },
  ];
}

/** Return the change that gives a case made of a drawing what a new one has: concrete, ground and self-weight. */
export function fillAsNew(data: Table): Change {
  const { E, nu } = defaultsFor("Plate", data) as Record<string, Json>;
  const missing = Object.entries({ E: E!, nu: nu! }).filter(([key]) => !(key in tableAt(data, ["plate"])));
  const edits = missing.map(([key, value]): Edit => ({ op: "set", path: ["plate", key], value }));
  if (!isTable(data.ground)) edits.push({ op: "set", path: ["ground"], value: defaultsFor("Vlasov", data) });
  edits.push({ op: "add", path: ["loads"], value: defaultsFor("SelfWeight", data) });
  return { edits, text: "concrete, ground and self-weight as in a new case" };
}

/** Return the change that adds a drawn line. */
export function addLine(kind: NewKind, data: Table, line: Ring, loadCase: string): Addition {
  const points = line.map(toText);
  const ends = { start: points[0] ?? [], end: points.at(-1) ?? [] };
  if (kind === "line support")
    return addItem(data, ["supports"], { ...defaultsFor("LineSupport", data), points }, "line support");
  if (kind === "section line") {
    const name = freeName(namesIn(listAt(data, ["output", "lines"])), "line 1");
    return addItem(data, ["output", "lines"], { name, ...ends }, say("section {name}", { name: verbatim(name) }));
  }
  if (kind === "strip") {
    const name = freeName(namesIn(listAt(data, ["output", "strips"])), "strip 1");
    return addItem(
      data,
      ["output", "strips"],
      { name, ...ends, width: stripWidth(data) },
      say("strip {name}", { name: verbatim(name) }),
    );
  }
  return addAlong(kind, data, { points }, loadCase);
}

/** Return the change that adds a wall, a beam or a line load along points, the edge of a shape or of a plate. */
function addAlong(kind: NewKind, data: Table, line: Table, loadCase: string): Addition {
  if (kind === "wall" || kind === "edge wall") {
    const name = freeName(namesIn(listAt(data, ["walls"])), "W1");
    return addItem(
      data,
      ["walls"],
      { name, thickness: wallThickness(data), ...line },
      say("wall {name}", { name: verbatim(name) }),
    );
  }
  if (kind === "beam") {
    const name = freeName(namesIn(listAt(data, ["beams"])), "B1");
    return addItem(
      data,
      ["beams"],
      { name, ...line, section: beamSection(data) },
      say("beam {name}", { name: verbatim(name) }),
    );
  }
  const load = { ...likeLast(data, "LineLoad", inCase(data, loadCase)), ...line };
  return addItem(data, ["loads"], load, "line load");
}

/** Return the change that adds a wall along the edge of a plate at a place, null if there is none. */
export function addEdgeWall(data: Table, at: Point, reach: number): Addition | null {
  const edge = edgeAt(data, at, reach);
  return edge && addAlong("edge wall", data, edge, "");
}

/** Return the change that adds something at a point. */
export function addPoint(kind: NewKind, data: Table, at: Point, loadCase: string): Addition {
  const place = { x: formatLength(at[0]), y: formatLength(at[1]) };
  if (kind === "support")
    return addItem(data, ["supports"], { ...defaultsFor("PointSupport", data), ...place }, "point support");
  if (kind === "borehole") {
    const name = freeName(takenNames(data, ["boreholes"]), "BH1");
    const layers = listAt(data, ["boreholes", 0, "layers"]);
    const value = { ...defaultsFor("Borehole", data), ...(layers.length > 0 ? { layers } : {}) };
    return addItem(data, ["boreholes"], { name, ...place, ...value }, say("borehole {name}", { name: verbatim(name) }));
  }
  if (kind === "column") {
    // called by the axes that it stands on
    const crossing = nameOfCrossing(at, axesIn(data)).replace("/", "");
    const taken = takenNames(data, ["columns"]);
    const name = crossing && !taken.includes(crossing) ? crossing : freeName(taken, "C1");
    return addItem(
      data,
      ["columns"],
      { name, ...place, ...columnSize(data) },
      say("column {name}", { name: verbatim(name) }),
    );
  }
  const column = columnAt(data, at);
  const load = likeLast(data, "PointLoad", inCase(data, loadCase));
  const value = { ...load, ...(column === null ? place : { column }) };
  return addItem(data, ["loads"], value, "point load");
}

/** Return a new load with the size of the last one of its kind in the same case, else a usual one. */
function likeLast(data: Table, definition: string, own: Table): Table {
  const usual = defaultsFor(definition, data);
  const isLike = (load: Json) => isTable(load) && load.kind === usual.kind && load.case === own.case;
  const last = listAt(data, ["loads"]).filter(isTable).findLast(isLike) ?? {};
  const size = Object.fromEntries(Object.entries(last).filter(([key]) => ["P", "q"].includes(key)));
  return { ...usual, ...size, ...own };
}

/** Return the cross-section of the last column, else a usual one. */
function columnSize(data: Table): Table {
  const last = listAt(data, ["columns"]).findLast(isTable) ?? {};
  const size = Object.entries(last).filter(([key]) => ["diameter", "width_x", "width_y", "angle"].includes(key));
  return size.length > 0 ? Object.fromEntries(size) : { width_x: "400 mm", width_y: "400 mm" };
}

/** Return the thickness of the last wall, else a usual one. */
function wallThickness(data: Table): Json {
  return listAt(data, ["walls"]).findLast(isTable)?.thickness ?? "250 mm";
}

/** Return the width of the last strip, else a usual one. */
function stripWidth(data: Table): Json {
  return listAt(data, ["output", "strips"]).findLast(isTable)?.width ?? "1 m";
}

/** Return the section of the last beam, else a usual one. */
function beamSection(data: Table): Json {
  const last = listAt(data, ["beams"]).findLast(isTable)?.section;
  return last ?? { kind: "rectangle", width: "400 mm", height: "800 mm" };
}

/** Return the name of the column that stands at a place, null if none does. */
function columnAt(data: Table, at: Point): string | null {
  for (const [n, column] of listAt(data, ["columns"]).entries()) {
    if (!isTable(column) || typeof column.name !== "string" || !column.name) continue;
    const geometry = readGeometry(data, ["columns", n]);
    if (geometry?.type !== "point") continue;
    const foot = footprintOf(column, geometry);
    if (Math.hypot(geometry.x - at[0], geometry.y - at[1]) < 1e-9 || (foot && isInside(foot, at))) return column.name;
  }
  return null;
}

/** Return the case of a new load: the chosen one, else the first there is. */
function inCase(data: Table, chosen: string): Table {
  const name = chosen || namesIn(listAt(data, ["cases"]))[0];
  return name ? { case: name } : {};
}

/** Return the change that adds a load case of an action; beside the first one loads without a case go to `owner`, a permanent case that is added if it is another one. */
export function addLoadCase(data: Table, name: string, action: Table, owner = name): Change {
  const own: Table = { name, ...action };
  const added = owner === name ? [own] : [{ name: owner, action: "permanent" }, own];
  const edits: Edit[] = added.map((value) => ({ op: "add", path: ["cases"], value }));
  edits.push(...uncased(data).map((path): Edit => ({ op: "set", path: [...path, "case"], value: owner })));
  return { edits, text: say("add load case {name}", { name: verbatim(name) }) };
}

/** Return how many loads and moves the first case has to settle, as they have none; 0 where there are cases. */
export const countUncased = (data: Table) => uncased(data).length;

function uncased(data: Table): Path[] {
  if (listAt(data, ["cases"]).length > 0) return [];
  return ["loads", "moves"].flatMap((list) =>
    listAt(data, [list]).flatMap((item, n): Path[] => (isTable(item) && item.case === undefined ? [[list, n]] : [])),
  );
}

/** Return a copy of the ground for a soil zone, which has to be of the same kind with as many layers. */
function copyGround(data: Table): Table {
  const ground = tableAt(data, ["ground"]);
  return Object.keys(ground).length > 0 ? structuredClone(ground) : defaultsFor("Winkler", data);
}

/** Return the change that copies an item of a list, moved by a step; null if there is none at the path. */
export function duplicateItem(data: Table, path: Path, by: Point = [0, 0], at?: number): Addition | null {
  const list = path.slice(0, -1);
  const value = structuredClone(tableAt(data, path));
  if (typeof path.at(-1) !== "number" || Object.keys(value).length === 0) return null;
  if (typeof value.name === "string" && value.name) value.name = freeName(takenNames(data, list), value.name);
  const copy = [...list, at ?? listAt(data, list).length];
  const edits: Edit[] = [{ op: "add", path: list, value, ...(at === undefined ? {} : { at }) }];
  if (by[0] !== 0 || by[1] !== 0) edits.push({ op: "move", path: copy, by });
  return { change: { edits, text: say("duplicate {items}", { items: titleAt(data, path) }) }, path: copy };
}
