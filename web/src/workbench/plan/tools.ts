// The tools of the drawing, and what each takes from the pointer.
import type { NewKind } from "../model/changes/new-items";

export type ToolName = "select" | NewKind;

/** What a tool takes from the pointer: one place, a line through places, two ends, or a closed shape. */
export type Draws = "nothing" | "point" | "line" | "segment" | "shape";

const SHAPE = "Drag a rectangle (Ctrl: a circle), or click corner after corner and close with Enter.";
const LINE = "Drag a straight line, or click place after place and end with Enter.";
const SELECT =
  "Click to select (Shift: several), drag to move; drag on empty ground to select what lies there. Space or right button moves the view, the wheel zooms.";

const ROWS: readonly [ToolName, string, string, Draws, string][] = [
  ["select", "Select", "V", "nothing", SELECT],
  ["slab", "Slab", "B", "shape", `Draw the slab's outline again. ${SHAPE}`],
  ["opening", "Opening", "O", "shape", `Cut an opening. ${SHAPE}`],
  ["zone", "Thickness", "T", "shape", `Draw a zone of another thickness. ${SHAPE}`],
  ["column", "Column", "C", "point", "Click where columns stand. Escape ends."],
  ["point load", "Point load", "P", "point", "Click a place or a column. Escape ends."],
  ["line load", "Line load", "L", "line", LINE],
  ["area load", "Area load", "A", "shape", SHAPE],
  ["support", "Support", "S", "point", "Click where the slab is supported at a point. Escape ends."],
  ["wall", "Line support", "W", "line", LINE],
  ["borehole", "Borehole", "H", "point", "Click where layers are known. Escape ends."],
  ["soil zone", "Soil zone", "G", "shape", `Draw a part of the plan with other ground. ${SHAPE}`],
  ["void", "Void", "U", "shape", `Draw where the ground lies deeper. ${SHAPE}`],
  ["plate", "Further plate", "E", "shape", `Draw another plate beside the slab. ${SHAPE}`],
  ["joint", "Joint", "J", "point", "Click the line that two plates share. Escape ends."],
  ["refinement", "Finer mesh", "F", "shape", `Draw where the mesh is finer. ${SHAPE}`],
  ["section line", "Section", "X", "segment", "Drag the line along which values are listed."],
];

export interface Tool {
  name: ToolName;
  label: string;
  key: string;
  draws: Draws;
  hint: string;
}

export const TOOLS: readonly Tool[] = ROWS.map(([name, label, key, draws, hint]) => ({
  name,
  label,
  key,
  draws,
  hint,
}));

/** Return the tool of a name. */
export function toolOf(name: ToolName): Tool {
  return TOOLS.find((tool) => tool.name === name)!;
}

/** Return the tool of a key, null if no tool has it. */
export function toolForKey(key: string): ToolName | null {
  return TOOLS.find((tool) => tool.key.toLowerCase() === key.toLowerCase())?.name ?? null;
}
