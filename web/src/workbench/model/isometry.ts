// Maps of the plan onto itself that keep lengths: translations, rotations, reflections.
import type { Point } from "./geometry";

/** x' = a x + b y + u, y' = c x + d y + v. */
export interface Isometry {
  readonly a: number;
  readonly b: number;
  readonly c: number;
  readonly d: number;
  readonly u: number;
  readonly v: number;
}

export function translation([u, v]: Point): Isometry {
  return { a: 1, b: 0, c: 0, d: 1, u, v };
}

/** Return the rotation about a point by an angle in degrees, counter-clockwise. */
export function rotation(degrees: number, about: Point): Isometry {
  const [cosine, sine] = unitVector(degrees);
  return fixing({ a: cosine, b: -sine, c: sine, d: cosine }, about);
}

/** Return the reflection about the line through two points. */
export function reflection(from: Point, to: Point): Isometry {
  const [x, y] = [to[0] - from[0], to[1] - from[1]];
  const square = x * x + y * y;
  const [cosine, sine] = [(x * x - y * y) / square, (2 * x * y) / square];
  return fixing({ a: cosine, b: sine, c: sine, d: -cosine }, from);
}

export function applyTo({ a, b, c, d, u, v }: Isometry, [x, y]: Point): Point {
  return [a * x + b * y + u, c * x + d * y + v];
}

/** Whether it maps lines along x and y to such lines. */
export function keepsAxes({ a, b }: Isometry): boolean {
  return a === 0 || b === 0;
}

export function isReflection({ a, b, c, d }: Isometry): boolean {
  return a * d - b * c < 0;
}

/** Return cosine and sine of an angle, exact for right angles. */
function unitVector(degrees: number): Point {
  const turned = ((degrees % 360) + 360) % 360;
  if (turned % 90 === 0)
    return [
      [1, 0],
      [0, 1],
      [-1, 0],
      [0, -1],
    ][turned / 90] as [number, number];
  const angle = (turned * Math.PI) / 180;
  return [Math.cos(angle), Math.sin(angle)];
}

/** Return the isometry of a matrix that leaves a point where it is. */
function fixing({ a, b, c, d }: Pick<Isometry, "a" | "b" | "c" | "d">, [x, y]: Point): Isometry {
  return { a, b, c, d, u: x - a * x - b * y, v: y - c * x - d * y };
}
