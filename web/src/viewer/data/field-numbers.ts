// Numbers on a field: the levels of its contours beside these, and its values on a raster that follows the zoom.
import type { Box } from "./boxes";
import type { ColorScale } from "./color-scale";
import { formatShort, formatTicks, roundStepOf } from "./numbers";
import type { Mesh, Point } from "./scene";
import { TRIANGLES } from "./shape-functions";

/** A number and where it belongs [m]. */
export interface FieldNumber {
  at: Point;
  text: string;
}

const RASTER = 78; // px: least distance of values on the raster
const CONTOUR = 190; // px: least distance of the numbers of one contour

/** Return the values at the nodes nearest to the crossings of a raster, whose step is round [m]; none far from one. */
export function rasterNumbers(mesh: Mesh, values: Float32Array, box: Readonly<Box>, scale: number): FieldNumber[] {
  const step = roundStepOf([1, 2, 5], RASTER / scale);
  const nearest = nearestByCell(mesh.nodeCount, step / 2, (node) => placeOf(mesh, node), box, step);
  return [...nearest.values()].map((node) => ({ at: placeOf(mesh, node), text: formatShort(values[node]!, 3) }));
}

/** Return the levels of contours, each so often along these as there is space at a scale [pixels per meter]. */
export function contourNumbers(
  mesh: Mesh,
  values: Float32Array,
  { levels, origin, step }: ColorScale,
  box: Readonly<Box>,
  scale: number,
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
    const chosen = nearestByCell(points.length, apart, (i) => points[i]!, box, apart, shift);
    return [...chosen.values()].map((i) => ({ at: points[i]!, text: texts[level]! }));
  });
}

/** Return by cells of a raster the place nearest to its middle, within a distance, of those in a box. */
function nearestByCell(
  count: number,
  within: number,
  placeAt: (index: number) => Point,
  [x0, y0, x1, y1]: Readonly<Box>,
  step: number,
  shift = 0,
): Map<string, number> {
  const chosen = new Map<string, { index: number; distance: number }>();
  for (let index = 0; index < count; index++) {
    const [x, y] = placeAt(index);
    if (!(x >= x0 && x <= x1 && y >= y0 && y <= y1)) continue;
    const [i, j] = [Math.round((x - shift) / step), Math.round((y - shift) / step)];
    const distance = Math.hypot(x - shift - i * step, y - shift - j * step);
    if (distance > within) continue;
    const key = `${i} ${j}`;
    const before = chosen.get(key);
    if (!before || distance < before.distance) chosen.set(key, { index, distance });
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
