// Axes of the building with their names, or of columns that stand in line, and chains of dimensions between them.

import { distanceBetween } from "../../viewer/data/points";
import type { Point } from "../../viewer/data/scene";
import type { Camera } from "../../viewer/plan/camera";
import { drawPath, drawText } from "../../viewer/plan/symbols";
import { svg } from "../../viewer/shared/dom";
import type { Axis } from "../model/axes";
import { boundsOf, type Geometry, quarterPoints, rectangleCorners, ringOf } from "../model/geometry";
import { boundsOfItems, type Item, isPlate } from "../model/items";
import { type Path, samePath } from "../model/paths";
import { formatDecimals } from "../model/quantities";
import { drawHandle } from "./rendering";

export interface ColumnAxis {
  /** Its x or y [m]. */
  at: number;
  /** How many columns stand on it. */
  columns: number;
  /** The part of the names that its columns share and no others, empty if there is none. */
  name: string;
}

const SAME = 1e-3; // m: columns so near to one line stand on it
const CHAINS = [22, 42]; // px below and beside the slab: the chain, and the whole length
const TICK = 4;
const LEAST = 26; // px: a shorter length is not written
const BUBBLE = 9;
const OVER = 8; // px that axes reach beyond the slab
const NAME = /^([A-Za-z]+)[-/]?(\d+)$/;

/** Return the axes across x (0) or y (1) on which columns stand. */
export function axesOf(items: readonly Item[], across: 0 | 1): ColumnAxis[] {
  const columns = items.flatMap(({ kind, geometry, table }) =>
    kind === "column" && geometry.type === "point"
      ? [{ at: across === 0 ? geometry.x : geometry.y, name: NAME.exec(String(table.name ?? "")) }]
      : [],
  );
  columns.sort((a, b) => a.at - b.at);
  const lines: (typeof columns)[] = [];
  for (const column of columns) {
    const last = lines.at(-1);
    if (last && column.at - last[0]!.at <= SAME) last.push(column);
    else lines.push([column]);
  }
  const namesOf = (part: 1 | 2) => lines.map((line) => shared(line.map(({ name }) => name?.[part] ?? "")));
  // letters or numbers name the axes: those of which no two axes have the same
  const names = [namesOf(1), namesOf(2)].find((each) => new Set(each).size === lines.length && !each.includes(""));
  return lines.map((line, n) => ({ at: line[0]!.at, columns: line.length, name: names?.[n] ?? "" }));
}

/** Return what all texts are, empty if they differ. */
function shared(texts: readonly string[]): string {
  return texts.every((text) => text === texts[0]) ? (texts[0] ?? "") : "";
}

/** An axis of the building on the screen: its line, and where its bubble is. */
interface DrawnAxis {
  axis: Axis;
  line: Point[];
  bubble: Point;
  /** Where it can be dragged besides, while its family is selected. */
  grips: Point[];
}

/** Draw the axes of the building with their names, those that are selected with handles. */
export function drawBuildingAxes(
  camera: Camera,
  items: readonly Item[],
  building: readonly Axis[],
  selected: readonly Path[],
): SVGElement[] {
  return place(camera, items, building).flatMap((each) => drawOne(each, isSelected(each.axis, selected)));
}

/** Draw the dimensions between axes, the edges of the slab, and in all; axes of columns where the building has none. */
export function drawDimensionChains(camera: Camera, items: readonly Item[], building: readonly Axis[]): SVGElement[] {
  const bounds = boundsOfPlates(items);
  if (!bounds) return [];
  const [x0, y0, x1, y1] = bounds;
  const [left, bottom] = camera.toPixel([x0, y0]);
  const [right, top] = camera.toPixel([x1, y1]);
  const [xs, ys] =
    building.length > 0 ? [along(building, 0), along(building, 1)] : [axesOf(items, 0), axesOf(items, 1)];
  const lines =
    building.length > 0
      ? []
      : [...upright(camera, xs as ColumnAxis[], bottom, top), ...level(camera, ys as ColumnAxis[], left, right)];
  const chainX = chainOf(x0, x1, xs).map((places, n) =>
    drawChain(places, (x) => [camera.toPixel([x, 0])[0], bottom + CHAINS[n]!], false),
  );
  const chainY = chainOf(y0, y1, ys).map((places, n) =>
    drawChain(places, (y) => [left - CHAINS[n]!, camera.toPixel([0, y])[1]], true),
  );
  return [...lines, ...chainX.flat(), ...chainY.flat()];
}

/** Return the axis of the building whose bubble is under a pixel, or a handle if it is selected; null if none is. */
export function axisUnder(
  camera: Camera,
  items: readonly Item[],
  building: readonly Axis[],
  selected: readonly Path[],
  pixel: Readonly<Point>,
): Axis | null {
  const isNear = (at: Point) => distanceBetween(at, pixel) <= BUBBLE + 2;
  const drawn = place(camera, items, building);
  const isHeld = ({ axis, grips }: DrawnAxis) => isSelected(axis, selected) && grips.some(isNear);
  return (drawn.find(({ bubble }) => isNear(bubble)) ?? drawn.find(isHeld))?.axis ?? null;
}

function isSelected(axis: Axis, selected: readonly Path[]): boolean {
  return selected.some((path) => samePath(path, axis.path));
}

function boundsOfPlates(items: readonly Item[]) {
  return boundsOfItems(items.filter(isPlate));
}

/** Return the places of axes of the building that run along y (0) or x (1). */
function along(building: readonly Axis[], across: 0 | 1): { at: number }[] {
  const isAcross = ({ direction, ray }: Axis) => direction && !ray && Math.abs(direction[across]) < 1e-9;
  return building
    .filter(isAcross)
    .map((axis) => ({ at: axis.place[across] }))
    .sort((a, b) => a.at - b.at);
}

/** Return where axes of the building are on the screen: from beyond the slab on one side to beyond it on the other. */
function place(camera: Camera, items: readonly Item[], building: readonly Axis[]): DrawnAxis[] {
  const around = boundsOfPlates(items) ?? boundsOf(building.map((axis) => axis.place));
  if (!around) return [];
  const [x0, y0, x1, y1] = around;
  const corners: Point[] = rectangleCorners([x0, x1], [y0, y1]).map(([x, y]) => [x, y]);
  const over = OVER / camera.scale;
  return building.map((axis): DrawnAxis => {
    const { place: at, direction, radius, ray } = axis;
    const pixel = ([x, y]: readonly [number, number]) => camera.toPixel([x, y]);
    if (!direction) {
      const circle = { type: "circle", at: [], center: [...at], radius } as const satisfies Geometry;
      const ring = ringOf(circle);
      const turn = Math.PI / 8;
      const bubble = pixel([at[0] + radius * Math.cos(turn), at[1] + radius * Math.sin(turn)]);
      return { axis, line: [...ring, ring[0]!].map(pixel), bubble, grips: quarterPoints(circle).map(pixel) };
    }
    const leading = Math.abs(direction[1]) >= Math.abs(direction[0]) ? direction[1] : direction[0];
    const [u, v] = ray || leading > 0 ? direction : [-direction[0], -direction[1]];
    const ways = corners.map(([x, y]) => (x - at[0]) * u + (y - at[1]) * v);
    const rings = building.filter((each) => !each.direction && each.place[0] === at[0] && each.place[1] === at[1]);
    const far = ray && rings.length > 0 ? Math.max(...rings.map((each) => each.radius)) : Math.max(0, ...ways);
    const [start, end] = ray ? [0, far + 2 * over] : [Math.min(...ways) - over, Math.max(...ways) + 2 * over];
    const on = (way: number) => pixel([at[0] + way * u, at[1] + way * v]);
    return {
      axis,
      line: [on(start), on(end)],
      bubble: on(end + BUBBLE / camera.scale),
      grips: [on(ray ? end : start)],
    };
  });
}

function drawOne({ axis, line, bubble, grips }: DrawnAxis, isChosen: boolean): SVGElement[] {
  const marks = isChosen ? " selected" : "";
  const handles = (isChosen ? grips : []).map((grip) => drawHandle(grip));
  const circle = svg("circle", { class: `axis-name${marks}`, cx: bubble[0], cy: bubble[1], r: BUBBLE });
  circle.dataset.axis = axis.name;
  return [
    drawPath(line, false, `axis${marks}`),
    circle,
    drawText(bubble, axis.name, [0, 4], "axis-label middle"),
    ...handles,
  ];
}

function lineOf(from: Point, to: Point, name: string, at: Point): SVGElement[] {
  return [
    drawPath([from, to], false, "axis"),
    ...(name ? [svg("circle", { class: "axis-name", cx: at[0], cy: at[1], r: BUBBLE })] : []),
    drawText(at, name, [0, 4], "axis-label middle"),
  ];
}

/** Draw the axes across x on which several columns stand. */
function upright(camera: Camera, axes: readonly ColumnAxis[], bottom: number, top: number): SVGElement[] {
  return axes
    .filter(({ columns }) => columns > 1)
    .flatMap(({ at, name }) => {
      const [x] = camera.toPixel([at, 0]);
      return lineOf([x, bottom + TICK], [x, top - OVER], name, [x, top - OVER - BUBBLE]);
    });
}

/** Draw the axes across y on which several columns stand. */
function level(camera: Camera, axes: readonly ColumnAxis[], left: number, right: number): SVGElement[] {
  return axes
    .filter(({ columns }) => columns > 1)
    .flatMap(({ at, name }) => {
      const [, y] = camera.toPixel([0, at]);
      return lineOf([left - TICK, y], [right + OVER, y], name, [right + OVER + BUBBLE, y]);
    });
}

/** Return the places of the chain and of the whole length; of the latter alone where there is no axis between. */
function chainOf(from: number, to: number, axes: readonly { at: number }[]): number[][] {
  const between = axes.map(({ at }) => at).filter((at) => at - from > SAME && to - at > SAME);
  const whole = [from, to];
  return between.length > 0 ? [[from, ...between, to], whole] : [whole];
}

/** Draw a chain of dimensions; an upright one has its lengths turned. */
function drawChain(places: readonly number[], toPixel: (place: number) => Point, isUpright: boolean): SVGElement[] {
  const pixels = places.map(toPixel);
  const ticks = pixels.map(([x, y]) =>
    drawPath(
      [
        [x - TICK, y + TICK],
        [x + TICK, y - TICK],
      ],
      false,
      "chain",
    ),
  );
  const texts = places.slice(1).flatMap((place, n): SVGElement[] => {
    const [a, b] = [pixels[n]!, pixels[n + 1]!];
    if (Math.hypot(b[0] - a[0], b[1] - a[1]) < LEAST) return [];
    const [x, y] = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
    const text = drawText([x, y], formatDecimals(place - places[n]!, 3), [0, -4], "chain-length middle");
    if (isUpright) text.setAttribute("transform", `rotate(-90 ${x.toFixed(1)} ${y.toFixed(1)})`);
    return [text];
  });
  return [drawPath([pixels[0]!, pixels.at(-1)!], false, "chain"), ...ticks, ...texts];
}
