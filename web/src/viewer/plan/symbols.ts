// Symbols of what has a place in plan: the same in the editor and over a result.

import { boxAround } from "../data/boxes";
import { formatShort } from "../data/numbers";
import { distanceBetween, offset, pointBetween } from "../data/points";
import type { Lengths, Point } from "../data/scene";
import { svg } from "../shared/dom";
import type { Camera } from "./camera";
import "./symbols.css";

export type Kind =
  | "slab"
  | "axis"
  | "plate"
  | "joint"
  | "move"
  | "refinement"
  | "opening"
  | "zone"
  | "column"
  | "wall"
  | "beam"
  | "beam of the building"
  | "support"
  | "load"
  | "borehole"
  | "soil zone"
  | "void"
  | "gap"
  | "output point"
  | "section line"
  | "bars"
  | "reaction"
  | "strip";

type Ring = readonly Readonly<Point>[];

/** Something with a place in plan. */
export interface PlanSymbol {
  kind: Kind;
  shape: "point" | "line" | "area";
  points: Ring; // [m]
  pieces?: readonly Ring[] | undefined; // what there is of a line, if not all along the points
  texts: readonly string[]; // beside it, one below the other
  foot?: Ring | null | undefined; // a column's cross-section, a load's footprint
  holes?: readonly Ring[]; // parts of an area that are not loaded
  hidden?: boolean; // a point load that another one at the same place stands for
  crowded?: boolean; // a point load without space for its arrow
  upward?: boolean; // a point load that lifts
  elastic?: boolean; // a support
  width?: number; // of a strip, a wall, a beam [m]
}

const ARROW = 26; // px: length of a point load's arrow

/** Draw a symbol. */
export function drawSymbol(camera: Camera, symbol: PlanSymbol): SVGElement[] {
  const toPixels = (points: Ring) => points.map((point) => camera.toPixel(point));
  const pixels = toPixels(symbol.points);
  const at = pixels[0];
  if (!at) return [];
  const text = symbol.texts[0] ?? "";
  switch (symbol.kind) {
    case "slab":
      return [drawArea(pixels)];
    case "axis":
      return drawAxis(pixels, text);
    case "plate":
      return [drawArea(pixels), drawText(leftTop(pixels), text, [6, 15])];
    case "beam of the building":
      return [drawPath(pixels, false)];
    case "joint":
      return [drawPath(pixels, false), drawText(middleOf(pixels), text, [6, -6])];
    case "move":
      return drawMove(symbol, pixels, toPixels, text);
    case "opening":
      return [drawArea(pixels), ...drawDiagonals(pixels)];
    case "zone":
      return [drawArea(pixels), drawText(middleTop(pixels), text, [0, 13], "middle")];
    case "refinement":
    case "soil zone":
    case "void":
      return [drawArea(pixels), drawText(leftTop(pixels), text, [5, 13])];
    case "wall":
    case "beam":
      return drawBand(symbol, toPixels, camera.scale);
    case "column":
      return drawColumn(at, toPixels(symbol.foot ?? []), text);
    case "support":
      if (symbol.shape === "point") return drawPointSupport(at, symbol.elastic === true, text);
      return drawLineSupport(pixels, symbol.elastic === true, text);
    case "load":
      return drawLoad(symbol, pixels, toPixels);
    case "borehole":
      return drawBorehole(at, text);
    case "strip":
      return drawStrip(pixels, ((symbol.width ?? 0) / 2) * camera.scale, text);
    case "section line":
      return [drawPath(pixels, false), ...drawEnds(pixels), drawText(at, text, [6, -6])];
    case "bars":
    case "reaction":
      return drawWritten(symbol, pixels, text);
    case "output point":
    case "gap":
      return [...drawCross(at, 5), drawText(at, text, [7, -5])];
  }
}

/** Draw the border of a zone of bars, or words: of bars about their place, of a reaction beside it. */
function drawWritten({ kind, shape }: PlanSymbol, pixels: Ring, text: string): SVGElement[] {
  if (shape === "area") return [drawArea(pixels), drawText(middleTop(pixels), text, [0, 13], "middle")];
  return [kind === "reaction" ? drawText(pixels[0]!, text, [11, 3]) : drawText(pixels[0]!, text, [0, 4], "middle")];
}

/** Draw an axis of the building, with its name in a bubble at the last of the pixels. */
function drawAxis(pixels: Ring, text: string): SVGElement[] {
  const [cx, cy] = pixels.at(-1)!;
  const name = drawText([cx, cy], text, [0, 4], "middle");
  return [drawPath(pixels.slice(0, -1), false), svg("circle", { cx, cy, r: 9 }), name];
}

/** Draw a line through pixels. */
export function drawPath(pixels: Ring, closed: boolean, className = ""): SVGElement {
  const d = pixels.map(([x, y], i) => `${i ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`).join("");
  return svg("path", { d: closed ? `${d}Z` : d, class: className || null });
}

/** Draw a text with a halo, so that it can be read above lines; `align` "middle" or "end" of the place. */
export function drawText(
  [x, y]: Readonly<Point>,
  text: string,
  [dx, dy]: Readonly<Point> = [0, 0],
  align = "",
): SVGElement {
  return svg("text", { x: (x + dx).toFixed(1), y: (y + dy).toFixed(1), class: `label ${align}`.trim() }, text);
}

/** Draw a surface; lines have no such class, since a closed one would be filled, too. */
function drawArea(pixels: Ring): SVGElement {
  return drawPath(pixels, true, "area");
}

function leftTop(pixels: Ring): Point {
  const [x0, y0] = boxAround(pixels);
  return [x0, y0];
}

function middleTop(pixels: Ring): Point {
  const [x0, y0, x1] = boxAround(pixels);
  return [(x0 + x1) / 2, y0];
}

/** Return the middle of a line's places. */
function middleOf(pixels: Ring): Point {
  const middle = (pixels.length - 1) / 2;
  return pointBetween(pixels[Math.floor(middle)]!, pixels[Math.ceil(middle)]!);
}

/** Return the direction from one place to another, and the distance. */
function directionOf(a: Readonly<Point>, b: Readonly<Point>): [x: number, y: number, length: number] {
  const length = distanceBetween(a, b);
  return [(b[0] - a[0]) / (length || 1), (b[1] - a[1]) / (length || 1), length];
}

function drawDiagonals(pixels: Ring): SVGElement[] {
  if (pixels.length !== 4) return [];
  return [0, 1].map((i) => drawPath([pixels[i]!, pixels[i + 2]!], false, "fine"));
}

function drawColumn(at: Readonly<Point>, foot: Ring, name: string): SVGElement[] {
  const size = Math.max(0, ...foot.map(([x, y]) => Math.max(Math.abs(x - at[0]), Math.abs(y - at[1]))));
  const least = offset(at, [-3.5, -3.5], [3.5, -3.5], [3.5, 3.5], [-3.5, 3.5]);
  return [drawArea(size < 3.5 ? least : foot), drawText(at, name, [Math.max(size, 4) + 4, Math.max(size, 4) + 9])];
}

/** Draw the pieces of a wall or a beam as wide as they are, at least as can be seen; `scale` in px/m. */
function drawBand(symbol: PlanSymbol, toPixels: (points: Ring) => Point[], scale: number): SVGElement[] {
  const half = Math.max((symbol.width ?? 0) * scale, 3) / 2;
  const bands = piecesIn(symbol).map((piece) => drawArea(bandAround(toPixels(piece), half)));
  return [...bands, drawText(middleOf(toPixels(symbol.points)), symbol.texts[0] ?? "", [6, -8])];
}

/** Return what there is of a line. */
function piecesIn({ pieces, points }: PlanSymbol): readonly Ring[] {
  return pieces ?? [points];
}

/** Return the outline of a band around a line, its corners mitered; of a closed line its last corner is open. */
function bandAround(line: Ring, half: number): Point[] {
  const sides = [1, -1].map((side) =>
    line.map((at, i): Point => {
      const [before, after] = [line[i - 1] ?? at, line[i + 1] ?? at];
      const [[ux, uy], [vx, vy]] = [directionOf(before, at), directionOf(at, after)];
      const [nx, ny] = [-(uy + vy), ux + vx]; // along the miter
      const reach = (side * half) / Math.max((nx * nx + ny * ny) / (i > 0 && i < line.length - 1 ? 2 : 1), 0.1);
      return [at[0] + nx * reach, at[1] + ny * reach];
    }),
  );
  return [...sides[0]!, ...sides[1]!.toReversed()];
}

function drawPointSupport(at: Readonly<Point>, elastic: boolean, name: string): SVGElement[] {
  const spring = [-7, -3.5, 0, 3.5, 7].map((dx, i): Point => [dx, i % 2 ? 19 : 15]);
  const base = elastic ? offset(at, ...spring) : offset(at, [-9, 15], [9, 15]);
  const triangle = offset(at, [0, 0], [-7, 12], [7, 12]);
  return [drawArea(triangle), drawPath(base, false, "fine"), drawText(at, name, [11, 16])];
}

function drawLineSupport(pixels: Ring, elastic: boolean, name: string): SVGElement[] {
  const line = drawPath(pixels, false, elastic ? "elastic" : "");
  return [line, ...drawTeeth(pixels), drawText(middleOf(pixels), name, [6, 14])];
}

/** Draw short strokes along a line support. */
function drawTeeth(pixels: Ring): SVGElement[] {
  return placesAlong(pixels, 9).map(({ at, along: [dx, dy] }) =>
    drawPath(offset(at, [0, 0], [-dy * 5 - dx * 5, dx * 5 - dy * 5]), false, "fine"),
  );
}

/** Return places along a line, so many pixels apart, with the direction there. */
function placesAlong(pixels: Ring, spacing: number): { at: Point; along: Point }[] {
  return pixels.slice(1).flatMap((b, i) => {
    const a = pixels[i]!;
    const [dx, dy, length] = directionOf(a, b);
    if (length === 0) return [];
    const count = Math.min(400, Math.max(1, Math.round(length / spacing)));
    return Array.from({ length: count + 1 }, (_, k) => ({
      at: pointBetween(a, b, k / count),
      along: [dx, dy] as Point,
    }));
  });
}

function drawLoad(symbol: PlanSymbol, pixels: Ring, toPixels: (points: Ring) => Point[]): SVGElement[] {
  const { texts } = symbol;
  const drawTexts = (at: Readonly<Point>, dx: number, dy: number, up: boolean) =>
    texts.map((text, i) => drawText(at, text, [dx, dy + 12 * (up ? i - texts.length + 1 : i)]));
  if (symbol.shape === "point") {
    const foot = symbol.foot ? [drawArea(toPixels(symbol.foot))] : [];
    if (symbol.crowded) return [...foot, drawPath(offset(pixels[0]!, [-1.5, 0], [1.5, 0]), false, "dot")];
    return symbol.hidden ? foot : [...foot, ...drawPointLoad(pixels[0]!, symbol.upward === true, texts)];
  }
  if (symbol.shape === "area") {
    const holes = (symbol.holes ?? []).map((hole) => drawPath(toPixels(hole), true, "hole"));
    return [drawArea(pixels), ...holes, ...drawTexts(leftTop(pixels), 5, 13, false)];
  }
  const lines = piecesIn(symbol).map(toPixels);
  return [...lines.flatMap(drawLineLoad), ...drawTexts(pixels[0]!, 4, -15, true)];
}

/** Draw a line with arrows that point to it. */
function drawLineLoad(pixels: Ring): SVGElement[] {
  const arrows = placesAlong(pixels, 16).flatMap(({ at }) => [
    drawPath(offset(at, [0, 0], [0, -11]), false, "fine"),
    drawPath(offset(at, [-2.5, -4.5], [0, 0], [2.5, -4.5]), false, "fine"),
  ]);
  const tails = pixels.flatMap((at) => offset(at, [0, -11]));
  return [drawPath(pixels, false, "wall"), drawPath(tails, false, "fine"), ...arrows];
}

/** Draw where a pattern stands, or the path that it moves along, with an arrow at its end. */
function drawMove(symbol: PlanSymbol, pixels: Ring, toPixels: (points: Ring) => Point[], text: string): SVGElement[] {
  const feet = (symbol.holes ?? []).map((foot) => drawPath(toPixels(foot), true, "area"));
  const [from, to] = [pixels.at(-2), pixels.at(-1)!];
  const name = drawText(pixels[0]!, text, [7, -6]);
  if (!from) return [...feet, ...drawCross(to, 5), name];
  const [dx, dy] = directionOf(from, to);
  const wing = (side: number): Point => [to[0] - dx * 9 - dy * 4 * side, to[1] - dy * 9 + dx * 4 * side];
  return [drawPath(pixels, false), drawPath([to, wing(1), wing(-1)], true, "head"), ...feet, name];
}

/** Draw one arrow for all loads at a place, their values beside it. */
function drawPointLoad([x, y]: Readonly<Point>, upward: boolean, texts: readonly string[]): SVGElement[] {
  const near: Point = [x - 3, y - 3];
  const far: Point = [x - 3 - ARROW * 0.62, y - 3 - ARROW];
  const [head, tail] = upward ? [far, near] : [near, far];
  const [dx, dy] = directionOf(tail, head);
  const wing = (side: number): Point => [head[0] - dx * 8 - dy * 3.5 * side, head[1] - dy * 8 + dx * 3.5 * side];
  return [
    drawPath([tail, head], false),
    drawPath([head, wing(1), wing(-1)], true, "head"),
    ...texts.map((text, i) => drawText(far, text, [0, -4 - 12 * (texts.length - 1 - i)], "middle")),
  ];
}

/** Draw a circle with two of its quarters filled. */
function drawBorehole([x, y]: Readonly<Point>, name: string): SVGElement[] {
  const quarters = `M${x} ${y}L${x} ${y - 7}A7 7 0 0 1 ${x + 7} ${y}ZM${x} ${y}L${x} ${y + 7}A7 7 0 0 1 ${x - 7} ${y}Z`;
  return [
    svg("circle", { cx: x, cy: y, r: 7 }),
    svg("path", { d: quarters, class: "filled" }),
    drawText([x, y], name, [10, -4]),
  ];
}

function drawStrip(pixels: Ring, half: number, name: string): SVGElement[] {
  const sides = drawStripSides(pixels, half);
  return sides.length ? [...sides, drawPath(pixels, false), drawText(pixels[0]!, name, [6, -6])] : [];
}

/** Draw the outline of a strip about a line [px]; nothing about a point. */
export function drawStripSides(pixels: Ring, half: number): SVGElement[] {
  const [a, b = a] = pixels as [Point, Point?];
  const [dx, dy, length] = directionOf(a, b);
  if (length === 0) return [];
  const [nx, ny] = [-dy * half, dx * half];
  return [drawArea([...offset(a, [nx, ny]), ...offset(b, [nx, ny], [-nx, -ny]), ...offset(a, [-nx, -ny])])];
}

/** Draw bars across the ends of a section line. */
export function drawEnds([a, b]: Ring): SVGElement[] {
  if (!a || !b) return [];
  const [dx, dy] = directionOf(a, b);
  return [a, b].map((at) => drawPath(offset(at, [dy * 6, -dx * 6], [-dy * 6, dx * 6]), false));
}

/** Draw an upright cross. */
export function drawCross(at: Readonly<Point>, size: number): SVGElement[] {
  const lines = [offset(at, [-size, 0], [size, 0]), offset(at, [0, -size], [0, size])];
  return lines.map((line) => drawPath(line, false));
}

/** Format a thickness [m] as beside a zone. */
export function thicknessText(thickness: number, { small, small_per_meter }: Lengths): string {
  return `t = ${formatShort(thickness * small_per_meter)} ${small}`;
}

/** Format the thickness of a zone [m], and the level of a pit [m], as they stand in it. */
export function zoneText({ thickness, level }: { thickness: number; level?: number }, lengths: Lengths): string {
  const text = thicknessText(thickness, lengths);
  return level === undefined ? text : `${text}, z = ${formatShort(level * lengths.per_meter)} ${lengths.unit}`;
}
