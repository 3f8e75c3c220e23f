// The tools of the drawing: what each one draws and what its drawing becomes in the case file.

import type { Change, Edit } from "../client/api";
import { namesIn } from "../client/store";
import { starter } from "../model/defaults";
import { inside, type Point, type Ring } from "../model/geometry";
import { footOf } from "../model/items";
import { isTable, type Json, listAt, type Path, type Table, tableAt } from "../model/paths";
import { metres, written } from "../model/quantities";

export type ToolName =
  | "select"
  | "slab"
  | "opening"
  | "zone"
  | "column"
  | "point load"
  | "line load"
  | "area load"
  | "support"
  | "wall"
  | "borehole"
  | "soil zone"
  | "void"
  | "section line";

/** What a tool takes from the pointer: one place, a line through places, two ends, or a closed shape. */
export type Draws = "nothing" | "point" | "line" | "segment" | "shape";

export interface Tool {
  name: ToolName;
  label: string;
  key: string;
  draws: Draws;
  hint: string;
}

const SHAPE = "Drag a rectangle, or click corner after corner and close with Enter.";
const LINE = "Drag a straight line, or click place after place and end with Enter.";

export const TOOLS: readonly Tool[] = [
  {
    name: "select",
    label: "Select",
    key: "V",
    draws: "nothing",
    hint: "Click to select, drag to move; drag the empty plan to shift it, turn the wheel to zoom.",
  },
  { name: "slab", label: "Slab", key: "B", draws: "shape", hint: `Draw the slab's outline anew. ${SHAPE}` },
  { name: "opening", label: "Opening", key: "O", draws: "shape", hint: `Cut an opening. ${SHAPE}` },
  { name: "zone", label: "Thickness", key: "T", draws: "shape", hint: `Draw a zone of another thickness. ${SHAPE}` },
  { name: "column", label: "Column", key: "C", draws: "point", hint: "Click where columns stand. Escape ends." },
  {
    name: "point load",
    label: "Point load",
    key: "P",
    draws: "point",
    hint: "Click a place or a column. Escape ends.",
  },
  { name: "line load", label: "Line load", key: "L", draws: "line", hint: LINE },
  { name: "area load", label: "Area load", key: "A", draws: "shape", hint: SHAPE },
  {
    name: "support",
    label: "Support",
    key: "S",
    draws: "point",
    hint: "Click where the slab is supported at a point. Escape ends.",
  },
  { name: "wall", label: "Line support", key: "W", draws: "line", hint: LINE },
  { name: "borehole", label: "Borehole", key: "H", draws: "point", hint: "Click where layers are known. Escape ends." },
  {
    name: "soil zone",
    label: "Soil zone",
    key: "G",
    draws: "shape",
    hint: `Draw a part of the plan with other ground. ${SHAPE}`,
  },
  { name: "void", label: "Void", key: "U", draws: "shape", hint: `Draw where the ground lies deeper. ${SHAPE}` },
  {
    name: "section line",
    label: "Section",
    key: "X",
    draws: "segment",
    hint: "Drag the line along which values are listed.",
  },
];

export type Shape = { kind: "rectangle"; from: Point; to: Point } | { kind: "polygon"; points: Ring };

/** The tool of a name. */
export function toolOf(name: ToolName): Tool {
  return TOOLS.find((each) => each.name === name) ?? (TOOLS[0] as Tool);
}

const text = (point: Point): Json[] => [written(point[0]), written(point[1])];

/** A drawn shape as a table of the case file. */
function shapeTable(shape: Shape): Table {
  if (shape.kind === "polygon") return { kind: "polygon", points: shape.points.map(text) };
  const [x, y] = [0, 1].map((n) =>
    [shape.from[n] ?? 0, shape.to[n] ?? 0].sort((a, b) => a - b).map((each) => written(each)),
  );
  return { kind: "rectangle", x: x ?? [], y: y ?? [] };
}

/** What was drawn: the edit, and the path of the new thing. */
export interface Made {
  change: Change;
  path: Path;
}

function adding(data: Table, list: Path, value: Table, what: string): Made {
  return {
    change: { edits: [{ op: "add", path: list, value }], text: `add ${what}` },
    path: [...list, listAt(data, list).length],
  };
}

/** The edit that a drawn shape makes. */
export function madeOfShape(tool: ToolName, data: Table, shape: Shape, loadCase: string): Made {
  const drawn = shapeTable(shape);
  switch (tool) {
    case "opening":
      return adding(data, ["plate", "openings"], drawn, "opening");
    case "zone":
      return adding(data, ["plate", "zones"], { ...starter("Zone", data), shape: drawn }, "zone");
    case "soil zone":
      return adding(data, ["soil_zones"], { shape: drawn, ground: starterGround(data) }, "soil zone");
    case "void":
      return adding(
        data,
        ["contact", "voids"],
        {
          ...starter("Void", data),
          ...(drawn.kind === "rectangle" ? { x: drawn.x as Json, y: drawn.y as Json } : { shape: drawn }),
        },
        "void",
      );
    case "area load": {
      const patch = drawn.kind === "rectangle";
      const value = patch
        ? { ...starter("PatchLoad", data), ...inCase(loadCase), x: drawn.x as Json, y: drawn.y as Json }
        : { ...starter("AreaLoad", data), ...inCase(loadCase), shape: drawn };
      return adding(data, ["loads"], value, "area load");
    }
    default:
      return { change: { edits: outlineEdits(data, drawn), text: "draw the slab" }, path: ["plate", "outline"] };
  }
}

/** The edits that give the slab another outline, and what a slab needs beside it if nothing is there. */
export function outlineEdits(data: Table, outline: Table): Edit[] {
  const plate = tableAt(data, ["plate"]);
  const edits: Edit[] = ["length_x", "length_y"]
    .filter((key) => key in plate)
    .map((key) => ({ op: "remove", path: ["plate", key] }));
  for (const [key, value] of Object.entries(starter("Plate", data))) {
    if (!(key in plate) && !key.startsWith("length")) edits.push({ op: "set", path: ["plate", key], value });
  }
  return [...edits, { op: "set", path: ["plate", "outline"], value: outline }];
}

/** The edit that a drawn line makes. */
export function madeOfLine(tool: ToolName, data: Table, points: Ring, loadCase: string): Made {
  const value = { points: points.map(text) };
  if (tool === "wall") return adding(data, ["supports"], { ...starter("LineSupport", data), ...value }, "line support");
  if (tool === "section line") {
    const name = freeName(namesIn(listAt(data, ["output", "lines"])), "line 1");
    const start: Point = points[0] ?? [0, 0];
    const end: Point = points.at(-1) ?? start;
    return adding(data, ["output", "lines"], { name, start: text(start), end: text(end) }, `section ${name}`);
  }
  return adding(data, ["loads"], { ...starter("LineLoad", data), ...inCase(loadCase), ...value }, "line load");
}

/** The edit that a click makes. */
export function madeAtPoint(tool: ToolName, data: Table, at: Point, loadCase: string): Made {
  const value = { x: written(at[0]), y: written(at[1]) };
  if (tool === "support")
    return adding(data, ["supports"], { ...starter("PointSupport", data), ...value }, "point support");
  if (tool === "borehole") {
    const name = freeName(namesIn(listAt(data, ["boreholes"])), "B1");
    const layers = listAt(data, ["boreholes", 0, "layers"]);
    const known = layers.length > 0 ? layers : listAt(data, ["ground", "layers"]);
    const made = { name, ...value, layers: known.length > 0 ? known : (starter("Borehole", data).layers ?? []) };
    return adding(data, ["boreholes"], made, `borehole ${name}`);
  }
  if (tool === "column") {
    const like = listAt(data, ["columns"]).findLast(isTable);
    const name = freeName(namesIn(listAt(data, ["columns"])), "C1");
    const size =
      like && (like.diameter ?? like.width_x) !== undefined
        ? Object.fromEntries(Object.entries(like).filter(([key]) => ["diameter", "width_x", "width_y"].includes(key)))
        : { width_x: "400 mm", width_y: "400 mm" };
    return adding(data, ["columns"], { name, ...value, ...size }, `column ${name}`);
  }
  const column = columnAt(data, at);
  const where: Table = column === null ? value : { column };
  return adding(data, ["loads"], { ...starter("PointLoad", data), ...inCase(loadCase), ...where }, "point load");
}

/** The name of the column that stands at a place, null if none does. */
function columnAt(data: Table, at: Point): string | null {
  for (const column of listAt(data, ["columns"])) {
    if (!isTable(column) || typeof column.name !== "string" || !column.name) continue;
    const [x, y] = [metres(column.x), metres(column.y)];
    if (x === null || y === null) continue;
    const foot = footOf(column, { type: "point", at: [], x, y });
    if (Math.hypot(x - at[0], y - at[1]) < 1e-9 || (foot && inside(foot, at))) return column.name;
  }
  return null;
}

function inCase(loadCase: string): Table {
  return loadCase ? { case: loadCase } : {};
}

/** The ground of a new zone: a copy of the ground, which has to be of the same kind with as many layers. */
function starterGround(data: Table): Table {
  const ground = tableAt(data, ["ground"]);
  return Object.keys(ground).length > 0 ? structuredClone(ground) : starter("Winkler", data);
}

/** A name like `first` that is not taken: its number grows. */
export function freeName(taken: readonly string[], first: string): string {
  const match = /^(.*?)(\d+)$/.exec(first);
  const [stem, from] = match ? [match[1] ?? "", Number(match[2])] : [`${first} `, 2];
  if (!taken.includes(first)) return first;
  let number = from;
  while (taken.includes(`${stem}${number}`)) number += 1;
  return `${stem}${number}`;
}

/** The edit that makes a copy of a thing, a step beside it. */
export function duplicateOf(data: Table, path: Path, title: string, by: Point): Made | null {
  const list = path.slice(0, -1);
  const position = path.at(-1);
  const table = tableAt(data, path);
  if (typeof position !== "number" || Object.keys(table).length === 0) return null;
  const value = structuredClone(table);
  const taken = namesIn(listAt(data, list));
  if (typeof value.name === "string" && value.name) value.name = freeName(taken, value.name);
  const at = listAt(data, list).length;
  const edits: Edit[] = [{ op: "add", path: list, value }];
  if (by[0] !== 0 || by[1] !== 0) edits.push({ op: "move", path: [...list, at], by });
  return { change: { edits, text: `duplicate ${title}` }, path: [...list, at] };
}
