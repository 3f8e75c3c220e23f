// Points of a plan or a screen, and distances between them.
import type { Point } from "./scene";

/** Return the points that lie so far from another one. */
export function offset([x, y]: Readonly<Point>, ...steps: readonly Readonly<Point>[]): Point[] {
  return steps.map(([dx, dy]) => [x + dx, y + dy]);
}

/** Return the distance between two points. */
export function distanceBetween(a: Readonly<Point>, b: Readonly<Point>): number {
  return Math.hypot(b[0] - a[0], b[1] - a[1]);
}

/** Return how far a point is beside a line through two others, and where along it: 0 at the first, 1 at the second. */
export function placeBeside(a: Readonly<Point>, b: Readonly<Point>, at: Readonly<Point>): [off: number, along: number] {
  const [dx, dy, length] = [b[0] - a[0], b[1] - a[1], distanceBetween(a, b) || 1];
  const [x, y] = [at[0] - a[0], at[1] - a[1]];
  return [Math.abs(dx * y - dy * x) / length, (dx * x + dy * y) / length ** 2];
}

/** Return the point at a share of the way from one to another. */
export function pointBetween(a: Readonly<Point>, b: Readonly<Point>, share = 0.5): Point {
  return [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])];
}
