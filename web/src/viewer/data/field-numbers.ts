// Numbers on a field: the levels of its contours beside these, and its values on a raster that follows the zoom.
import { type Box, boxAround, crosses } from "./boxes";
import type { ColorScale } from "./color-scale";
import { formatShort, formatTicks } from "./numbers";
import type { Mesh, Plan, Point, Ring } from "./scene";
import { TRIANGLES } from "./shape-functions";

/** A number and where it belongs [m]. */
export interface FieldNumber {
  at: Point;
  text: string;
}

const RASTER = 78; // px: least distance of values on the raster
const CONTOUR = 190; // px: least distance of the numbers of one contour
const [LETTER, HALF_HEIGHT] = [6.2, 8]; // px: of a number

/** Whether a number that says so may stand at a place [m]. */
export type IsClear = (at: Point, text: string) => boolean;

/** Return what keeps numbers off the edges of slabs and openings at a scale [pixels per meter]. */
export function clearOfEdges(plan: Pick<Plan, "outline" | "openings" | "plates">, scale: number): IsClear {
  const plates = plan.plates ?? [];
  const openings = [...plan.openings, ...plates.flatMap((each) => each.openings)];
  const rings: readonly Ring[] = [plan.outline, ...plates.map(({ ring }) => ring), ...openings.map(({ ring }) => ring)];
  const edges = rings.flatMap((ring) => ring.map((end, i) => [ring.at(i - 1)!, end] as const));
  return ([x, y], text) => {
    const [dx, dy] = [(LETTER * text.length + 6) / 2 / scale, HALF_HEIGHT / scale];
    const box: Box = [x - dx, y - dy, x + dx, y + dy];
    return !edges.some(([start, end]) => crosses(start, end, box));
  };
}

/**
 * Return the values at the nodes nearest to the middles of cells that divide the plan evenly; none far from one, or
 * where it is not clear.
 */
export function rasterNumbers(
  mesh: Mesh,
  values: Float32Array,
  box: Readonly<Box>,
  scale: number,
  isClear: IsClear = () => true,
): FieldNumber[] {
  const nodes = Array.from({ length: mesh.nodeCount }, (_, node) => placeOf(mesh, node));
  const [x0, y0, x1, y1] = boxAround(nodes);
  const stepOf = (length: number) => length / Math.max(1, Math.floor((length * scale) / RASTER));
  const steps: Point = [stepOf(x1 - x0), stepOf(y1 - y0)];
  const textOf = (node: number) => formatShort(values[node]!, 3);
  const nearest = nearestByCell(
    nodes,
    0.49 * Math.min(...steps),
    box,
    steps,
    [x0 + steps[0] / 2, y0 + steps[1] / 2],
    (node) => isClear(nodes[node]!, textOf(node)),
  );
  return [...nearest.values()].map((node) => ({ at: nodes[node]!, text: textOf(node) }));
}

/** Return the levels of contours, each so often along these as there is space at a scale [pixels per meter]. */
export function contourNumbers(
  mesh: Mesh,
  values: Float32Array,
  { levels, origin, step }: ColorScale,
  box: Readonly<Box>,
  scale: number,
  isClear: IsClear = () => true,
): FieldNumber[] {
  const texts = formatTicks(levels.map((_, i) => Number((origin + i * step).toPrecision(12))));
  const crossings: Point[][] = levels.map(() => []);
  forEachSide(mesh, (a, b) => {
    const [low, high] = values[a]! < values[b]! ? [a, b] : [b, a];
    const from = Math.floor((values[low]! - origin) / step) + 1;
    const to = Math.floor((values[high]! - origin) / step);
    for (let level = Math.max(from, 1); level <= to && level < levels.length - 1; level++) {
      const share = (origin + level * step - values[low]!) / (values[high]! - values[low]!);
      const [p, q] = [placeOf(mesh, low), placeOf(mesh, high)];
      crossings[level]!.push([p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])]);
    }
  });
  const apart = CONTOUR / scale;
  return crossings.flatMap((points, level) => {
    // levels begin beside each other, so that their numbers do not lie on one line of cells
    const shift = (((level * 0.382) % 1) - 0.5) * apart;
    const isFree = (i: number) => isClear(points[i]!, texts[level]!);
    const chosen = nearestByCell(points, apart, box, [apart, apart], [shift, shift], isFree);
    return [...chosen.values()].map((i) => ({ at: points[i]!, text: texts[level]! }));
  });
}

/** Return by cells of a raster the place nearest to its middle, within a distance, of those in a box that are free. */
function nearestByCell(
  places: readonly Point[],
  within: number,
  [x0, y0, x1, y1]: Readonly<Box>,
  steps: Point,
  origin: Point,
  isFree: (index: number) => boolean,
): Map<string, number> {
  const chosen = new Map<string, { index: number; distance: number }>();
  for (const [index, [x, y]] of places.entries()) {
    if (!(x >= x0 && x <= x1 && y >= y0 && y <= y1)) continue;
    const [u, v] = [(x - origin[0]) / steps[0], (y - origin[1]) / steps[1]];
    const [i, j] = [Math.round(u), Math.round(v)];
    const distance = Math.hypot((u - i) * steps[0], (v - j) * steps[1]);
    const key = `${i} ${j}`;
    const isNearer = distance <= within && !((chosen.get(key)?.distance ?? Infinity) <= distance);
    if (isNearer && isFree(index)) chosen.set(key, { index, distance });
  }
  return new Map([...chosen].map(([key, { index }]) => [key, index]));
}

/** Call back for the outer sides of the triangles of all elements: of each element half of its sides. */
function forEachSide({ elements, elementCount }: Mesh, act: (a: number, b: number) => void): void {
  for (let e = 0; e < elementCount; e++)
    for (let k = 0; k < TRIANGLES.length; k += 3)
      act(elements[9 * e + TRIANGLES[k]!]!, elements[9 * e + TRIANGLES[k + 1]!]!);
}

function placeOf({ nodes }: Mesh, node: number): Point {
  return [nodes[2 * node]!, nodes[2 * node + 1]!];
}
