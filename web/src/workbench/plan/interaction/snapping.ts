// Snapping of the pointer: to corners that exist, in line with them, on round lengths.

import { roundMultiple } from "../../../viewer/data/numbers";
import { distanceBetween } from "../../../viewer/data/points";
import type { Point } from "../../model/geometry";

export interface SnapInput {
  /** Where the pointer is [m]. */
  at: Point;
  /** Corners, centers and ends that exist [m]. */
  points: readonly Point[];
  /** Spacing of round lengths [m]. */
  step: number;
  /** How near is near enough [m]. */
  reach: number;
}

export interface Snapped {
  at: Point;
  /** The existing places that x and y come from, for guide lines. */
  fromX: Point | null;
  fromY: Point | null;
  /** Whether it is an existing place itself. */
  onPoint: boolean;
  /** What the existing place is, such as `corner`. */
  name?: string;
}

/** The place that is meant: an existing one, else x and y each in line with one, else a round length. */
export function snap({ at, points, step, reach }: SnapInput): Snapped {
  let onPoint: Point | null = null;
  let [least, leastX, leastY] = [reach, reach * 0.75, reach * 0.75];
  let [fromX, fromY]: [Point | null, Point | null] = [null, null];
  for (const point of points) {
    const [dx, dy] = [Math.abs(point[0] - at[0]), Math.abs(point[1] - at[1])];
    const distance = distanceBetween(point, at);
    if (distance < least || (!onPoint && distance === least)) [onPoint, least] = [point, distance];
    if (dx < leastX || (dx === leastX && isNearer(point, fromX, at))) [fromX, leastX] = [point, dx];
    if (dy < leastY || (dy === leastY && isNearer(point, fromY, at))) [fromY, leastY] = [point, dy];
  }
  if (onPoint) return { at: onPoint, fromX: null, fromY: null, onPoint: true };
  const x = roundTo(at[0], step);
  const y = roundTo(at[1], step);
  // a round length that is nearer than what exists comes first
  if (fromX && Math.abs(x - at[0]) < leastX && step >= reach / 2) fromX = null;
  if (fromY && Math.abs(y - at[1]) < leastY && step >= reach / 2) fromY = null;
  return { at: [fromX ? fromX[0] : x, fromY ? fromY[1] : y], fromX, fromY, onPoint: false };
}

function isNearer(a: Point, b: Point | null, at: Point): boolean {
  return !b || distanceBetween(a, at) < distanceBetween(b, at);
}

/** A length rounded to a step, without noise in its digits. */
export function roundTo(value: number, step: number): number {
  return roundMultiple(Math.round(value / step), step);
}
