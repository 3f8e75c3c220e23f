// What a drawing holds, as the server has read it, what is chosen of it, and how it lies below the plan.

import { type Box, boxAround } from "../../viewer/data/boxes";
import type { Point } from "./geometry";

/** A layer: its entities by kind, what its name says that it holds; lines, chords of curves and points as flat lists. */
export interface Layer {
  name: string;
  role: string | null;
  /** Whether the drawing does not show it. */
  hidden: boolean;
  kinds: Record<string, number>;
  lines: readonly number[][];
  curves: readonly number[][];
  points: readonly number[];
}

/** A drawing, whose places are meters if its unit is `scale` meters. */
export interface Survey {
  unit: string | null;
  scale: number;
  layers: readonly Layer[];
  /** What is not counted or not shown. */
  remarks: readonly string[];
}

/** What is to be made of a drawing. */
export interface DrawingChoice {
  /** What each layer that is read holds, by its name. */
  layers: Record<string, string>;
  unit: string;
  /** Whether the slab's middle becomes the origin; else the drawing's own stays. */
  centered: boolean;
  /** The widest gap between ends of lines that is closed, such as `1 mm`. */
  gap: string;
  /** Whether outlines that adjoin each other become one. */
  union: boolean;
}

/** What a layer can hold, as the command line calls it, and as people do. */
export const ROLES: readonly (readonly [string, string])[] = [
  ["", "not read"],
  ["outline", "outline"],
  ["openings", "openings"],
  ["zones", "zones"],
  ["columns", "columns"],
  ["walls", "walls"],
  ["beams", "beams"],
  ["point_loads", "point loads"],
  ["line_loads", "line loads"],
  ["area_loads", "area loads"],
];

/** Units of length in meters. */
const UNITS: Readonly<Record<string, number>> = {
  mm: 0.001,
  cm: 0.01,
  dm: 0.1,
  m: 1,
  km: 1000,
  in: 0.0254,
  ft: 0.3048,
  yd: 0.9144,
  mi: 1609.344,
  survey_foot: 1200 / 3937,
};

/** Return the units to choose from; that of the drawing is among them. */
export function unitsFor({ unit }: Survey): string[] {
  const usual = ["mm", "cm", "m", "in", "ft"];
  return unit === null || usual.includes(unit) ? usual : [unit, ...usual];
}

/** Return by how much the places of a drawing are larger in a unit than they were read. */
export function enlargement({ scale }: Survey, unit: string): number {
  return (UNITS[unit] ?? scale) / scale;
}

/** Return what a layer has, such as `4 LINE, 2 TEXT`. */
export function contentText({ kinds }: Layer): string {
  return Object.entries(kinds)
    .map(([kind, count]) => `${count} ${kind}`)
    .join(", ");
}

/** Return what keeps a case from being made, empty if nothing does. */
export function findProblem({ layers, unit }: DrawingChoice): string {
  if (unit === "") return "Choose the drawing's unit; the drawing does not specify one.";
  if (!Object.values(layers).includes("outline")) return "Choose the layer with the outline.";
  return "";
}

/** Return the points of a flat list. */
export function pointsOf(flat: readonly number[]): Point[] {
  return Array.from({ length: flat.length / 2 }, (_, n): Point => [flat[2 * n]!, flat[2 * n + 1]!]);
}

/** Return the box around what layers show, null if they show nothing. */
export function boundsOfLayers(layers: readonly Layer[]): Box | null {
  const box = boxAround(layers.flatMap(({ lines, curves, points }) => [...lines, ...curves, points].flatMap(pointsOf)));
  return box[0] > box[2] ? null : box;
}

/** A drawing below the plan: where its origin lies in the plan [m], and whether it is shown. */
export interface Underlay {
  name: string;
  survey: Survey;
  unit: string;
  offset: Point;
  shown: boolean;
}

/** Return the place by which the middle of a drawing comes to lie at the origin. */
export function centeringOffset(survey: Survey, unit: string): Point {
  const [x0, y0, x1, y1] = boundsOfLayers(survey.layers.filter((layer) => !layer.hidden)) ?? [0, 0, 0, 0];
  const factor = enlargement(survey, unit);
  return [(-(x0 + x1) / 2) * factor, (-(y0 + y1) / 2) * factor];
}
