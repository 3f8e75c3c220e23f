// The tools of the drawing, and what each takes from the pointer.
import { together } from "../../viewer/shared/language";
import type { NewKind } from "../model/changes/new-items";

export type ToolName = "select" | NewKind;

/** What a tool takes from the pointer: one place, a line through places, two ends, or a closed shape. */
export type Draws = "nothing" | "point" | "line" | "segment" | "shape";

const SHAPE = "Drag a rectangle (Ctrl: a circle), or click the corners one by one and press Enter to close.";
const LINE = "Drag a straight line, or click points one by one and press Enter to finish.";
const LINE_OR_RING = "Drag a straight line (Ctrl: a ring), or click points one by one and press Enter to finish.";
const SELECT =
  "Click to select (Shift: several), drag to move; drag on empty space to select an area. Pan with Space or the right button, zoom with the wheel.";

const ROWS: readonly [ToolName, string, string, Draws, ...string[]][] = [
  ["select", "Select", "V", "nothing", SELECT],
  ["slab", "Slab", "B", "shape", "Redraw the slab's outline.", SHAPE],
  ["opening", "Opening", "O", "shape", "Cut an opening.", SHAPE],
  ["zone", "Thickness", "T", "shape", "Draw a zone with a different thickness.", SHAPE],
  ["column", "Column", "C", "point", "Click to place columns. Press Escape to finish."],
  ["wall", "Wall", "W", "line", "Draw the axis of a wall.", LINE_OR_RING],
  ["edge wall", "Wall on edge", "", "point", "Click an edge of the slab. Press Escape to finish."],
  ["beam", "Beam", "", "line", "Draw the axis of a beam or rib.", LINE_OR_RING],
  ["point load", "Point load", "P", "point", "Click a point or a column. Press Escape to finish."],
  ["line load", "Line load", "L", "line", LINE_OR_RING],
  ["area load", "Area load", "A", "shape", SHAPE],
  ["support", "Support", "S", "point", "Click to place point supports. Press Escape to finish."],
  ["line support", "Line support", "", "line", LINE],
  ["borehole", "Borehole", "H", "point", "Click to place boreholes. Press Escape to finish."],
  ["soil zone", "Soil zone", "G", "shape", "Draw an area with different ground.", SHAPE],
  ["void", "Void", "U", "shape", "Draw an area where there is a gap below the slab.", SHAPE],
  ["plate", "Further plate", "E", "shape", "Draw another plate next to the slab.", SHAPE],
  ["joint", "Joint", "J", "point", "Click the line shared by two plates. Press Escape to finish."],
  ["refinement", "Finer mesh", "F", "shape", "Draw an area with a finer mesh.", SHAPE],
  ["strip", "Strip", "", "segment", "Drag the axis of a strip, across which moments are summed."],
  ["section line", "Section", "X", "segment", "Drag a line to list values along it."],
];

export interface Tool {
  name: ToolName;
  label: string;
  /** The key that chooses it, empty if none does. */
  key: string;
  draws: Draws;
  hint: string;
}

export const TOOLS: readonly Tool[] = ROWS.map(([name, label, key, draws, ...hints]) => ({
  name,
  label,
  key,
  draws,
  get hint() {
    return together(hints);
  },
}));

/** Return the tool of a name. */
export function toolOf(name: ToolName): Tool {
  return TOOLS.find((tool) => tool.name === name)!;
}

/** Return the tool of a key, null if no tool has it. */
export function toolForKey(key: string): ToolName | null {
  return TOOLS.find((tool) => tool.key.toLowerCase() === key.toLowerCase())?.name ?? null;
}
