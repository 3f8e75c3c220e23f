// Axes of columns that stand in line, and chains of dimensions between them and the slab's edges.
import type { Camera } from "../../viewer/plan/camera";
import { drawPath, drawText } from "../../viewer/plan/symbols";
import { svg } from "../../viewer/shared/dom";
import type { Point } from "../model/geometry";
import { boundsOfItems, type Item } from "../model/items";
import { formatDecimals } from "../model/quantities";

export interface Axis {
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
const NAME = /^([A-Za-z]+)[-/]?(\d+)$/;

/** Return the axes across x (0) or y (1) on which columns stand. */
export function axesOf(items: readonly Item[], across: 0 | 1): Axis[] {
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

/** Draw the axes with their names, and the dimensions between them, the edges of the slab, and in all. */
export function drawAxes(camera: Camera, items: readonly Item[]): SVGElement[] {
  const bounds = boundsOfItems(items.filter(({ kind }) => kind === "slab" || kind === "plate"));
  if (!bounds) return [];
  const [x0, y0, x1, y1] = bounds;
  const [left, bottom] = camera.toPixel([x0, y0]);
  const [right, top] = camera.toPixel([x1, y1]);
  const [xs, ys] = [axesOf(items, 0), axesOf(items, 1)];
  const axes = (all: readonly Axis[]) => all.filter(({ columns }) => columns > 1);
  const line = (from: Point, to: Point, name: string, at: Point) => [
    drawPath([from, to], false, "axis"),
    ...(name ? [svg("circle", { class: "axis-name", cx: at[0], cy: at[1], r: BUBBLE })] : []),
    drawText(at, name, [0, 4], "axis-label middle"),
  ];
  const vertical = axes(xs).flatMap(({ at, name }) => {
    const [x] = camera.toPixel([at, 0]);
    return line([x, bottom + TICK], [x, top - 8], name, [x, top - 8 - BUBBLE]);
  });
  const horizontal = axes(ys).flatMap(({ at, name }) => {
    const [, y] = camera.toPixel([0, at]);
    return line([left - TICK, y], [right + 8, y], name, [right + 8 + BUBBLE, y]);
  });
  const chainX = chainOf(x0, x1, xs).map((places, n) =>
    drawChain(places, (x) => [camera.toPixel([x, 0])[0], bottom + CHAINS[n]!], false),
  );
  const chainY = chainOf(y0, y1, ys).map((places, n) =>
    drawChain(places, (y) => [left - CHAINS[n]!, camera.toPixel([0, y])[1]], true),
  );
  return [...vertical, ...horizontal, ...chainX.flat(), ...chainY.flat()];
}

/** Return the places of the chain and of the whole length; of the latter alone where there is no axis between. */
function chainOf(from: number, to: number, axes: readonly Axis[]): number[][] {
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
