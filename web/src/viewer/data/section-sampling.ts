// Values of a field along a straight line through the plate.
import { type Choice, combinationsOf, fieldValueAt, isLargest } from "./fields";
import type { LocalPoint, Locator } from "./point-location";
import { distanceBetween, pointBetween } from "./points";
import type { Point, Scene } from "./scene";

/** Where a line was sampled: distances from its start [m], and where in the mesh, null off the plate. */
export interface Samples {
  start: Point;
  end: Point;
  s: number[];
  spots: (LocalPoint | null)[];
  /** Of a strip what lies across it at each distance, from one of its sides to the other. */
  across?: (LocalPoint | null)[][];
}

const BISECTIONS = 22;

/**
 * Return samples along a line: evenly, and on both sides of every border between elements that it crosses.
 *
 * So kinks, jumps where the thickness changes, and edges of openings are where they are.
 */
export function sampleLine(locator: Locator, start: Point, end: Point, count = 400): Samples {
  const length = distanceBetween(start, end);
  const at = (part: number) => locator.locate(...pointBetween(start, end, part));
  const parts: number[] = [];
  const spots: (LocalPoint | null)[] = [];
  const keep = (part: number, spot: LocalPoint | null) => {
    parts.push(part);
    spots.push(spot);
  };
  // walk from a to b, which lie in different elements, by halving until the border between them is found
  const border = (a: number, inA: LocalPoint | null, b: number, inB: LocalPoint | null, left: number): void => {
    if (inA?.element === inB?.element) return;
    if (left === 0) {
      keep(a, inA);
      keep(b, inB);
      return;
    }
    const middle = (a + b) / 2;
    const inMiddle = at(middle);
    border(a, inA, middle, inMiddle, left - 1);
    border(middle, inMiddle, b, inB, left - 1);
  };
  let before = at(0);
  keep(0, before);
  for (let i = 1; i <= count; i++) {
    const spot = at(i / count);
    border((i - 1) / count, before, i / count, spot, BISECTIONS);
    keep(i / count, spot);
    before = spot;
  }
  // a border that falls on an even sample is met twice
  const once = parts.map((part, i) => i === 0 || part > parts[i - 1]!);
  const s = parts.filter((_, i) => once[i]).map((part) => part * length);
  return { start, end, s, spots: spots.filter((_, i) => once[i]) };
}

const ACROSS = 20; // parts of a strip's width

/** Return samples of a strip about a line: evenly along it, and from side to side. */
export function sampleStrip(locator: Locator, start: Point, end: Point, width: number, count = 200): Samples {
  const length = distanceBetween(start, end);
  const [nx, ny] = [(start[1] - end[1]) / length, (end[0] - start[0]) / length];
  const parts = Array.from({ length: count + 1 }, (_, i) => i / count);
  const across = parts.map((part) => {
    const [x, y] = pointBetween(start, end, part);
    return Array.from({ length: ACROSS + 1 }, (_, k) => {
      const off = width * (k / ACROSS - 0.5);
      return locator.locate(x + off * nx, y + off * ny);
    });
  });
  return { start, end, s: parts.map((part) => part * length), spots: across.map((row) => row[ACROSS / 2]!), across };
}

/** Return the mean of a field across a strip, of what is on the plate; null if nothing is. */
function meanAcross(
  scene: Scene,
  locator: Locator,
  choice: Choice,
  field: string,
  row: readonly (LocalPoint | null)[],
): number | null {
  const weights = row.map((spot, k): number => (spot ? (k === 0 || k === row.length - 1 ? 0.5 : 1) : 0));
  const total = weights.reduce((sum, weight) => sum + weight, 0);
  if (total === 0) return null;
  // of an envelope the extreme of the combinations' means
  const means = combinationsOf(scene, choice).map((from) => {
    const valueAt = (spot: LocalPoint | null) => (spot ? fieldValueAt(scene, locator, from, field, spot).value : 0);
    return row.reduce((sum, spot, k) => sum + weights[k]! * valueAt(spot), 0) / total;
  });
  return isLargest(choice) ? Math.max(...means) : Math.min(...means);
}

/** Return a field along a line, or its mean across a strip; null off the plate. */
export function sampleField(
  scene: Scene,
  locator: Locator,
  choice: Choice,
  field: string,
  samples: Samples,
): (number | null)[] {
  if (samples.across) return samples.across.map((row) => meanAcross(scene, locator, choice, field, row));
  return samples.spots.map((spot) => (spot ? fieldValueAt(scene, locator, choice, field, spot).value : null));
}

/** The smallest and largest value along a line, with their distances from its start; null if it misses the plate. */
export function findPeaks(
  s: readonly number[],
  y: readonly (number | null)[],
): { min: [number, number]; max: [number, number] } | null {
  let min: [number, number] | null = null;
  let max: [number, number] | null = null;
  y.forEach((value, i) => {
    if (value === null) return;
    if (!min || value < min[1]) min = [s[i]!, value];
    if (!max || value > max[1]) max = [s[i]!, value];
  });
  return min && max ? { min, max } : null;
}

/** Return the ends of the axis of values: with zero unless all values are far from it. */
export function axisLimits(low: number | null, high: number | null): [number, number] {
  let [from, to] = [low ?? 0, high ?? 0];
  if (from > 0 && from < 0.7 * to) from = 0;
  if (to < 0 && to > 0.7 * from) to = 0;
  if (from === to) return [from - (0.1 * Math.abs(from) || 1), to + (0.1 * Math.abs(to) || 1)];
  const rim = 0.08 * (to - from);
  return [from === 0 ? 0 : from - rim, to === 0 ? 0 : to + rim];
}

/** Settlements and moments are drawn downwards, as the plate settles and where its face is in tension. */
export function pointsDownward(field: string): boolean {
  return field === "settlement" || field.startsWith("moment") || /^(m_|bottom|top)/.test(field);
}
