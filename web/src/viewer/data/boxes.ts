// Boxes around points and elements, in plan [m].
import type { Mesh } from "./scene";

export type Box = [x0: number, y0: number, x1: number, y1: number];

export const EVERYTHING: Readonly<Box> = [-Infinity, -Infinity, Infinity, Infinity];
const EMPTY: Readonly<Box> = [Infinity, Infinity, -Infinity, -Infinity];

/** Return the box around points; an inverted, infinite one if there are none. */
export function boxAround(points: Iterable<readonly [number, number]>): Box {
  const box: Box = [...EMPTY];
  for (const [x, y] of points) extend(box, x, y, x, y);
  return box;
}

/** Return the box around each element (x0, y0, x1, y1), enlarged by a share of its size, and the box around all. */
export function elementBoxes(mesh: Mesh, margin = 0): { boxes: Float64Array; total: Box } {
  const { nodes, elements, elementCount } = mesh;
  const boxes = new Float64Array(4 * elementCount);
  const total: Box = [...EMPTY];
  const box: Box = [...EMPTY];
  for (let e = 0; e < elementCount; e++) {
    for (let k = 0; k < 4; k++) box[k] = EMPTY[k]!;
    for (let k = 9 * e; k < 9 * e + 9; k++) {
      const [x, y] = [nodes[2 * elements[k]!]!, nodes[2 * elements[k]! + 1]!];
      extend(box, x, y, x, y);
    }
    const [dx, dy] = [margin * (box[2] - box[0]), margin * (box[3] - box[1])];
    boxes.set([box[0] - dx, box[1] - dy, box[2] + dx, box[3] + dy], 4 * e);
    extend(total, boxes[4 * e]!, boxes[4 * e + 1]!, boxes[4 * e + 2]!, boxes[4 * e + 3]!);
  }
  return { boxes, total };
}

/** Return whether a line between two places passes through a box. */
export function crosses(
  [ax, ay]: readonly [number, number],
  [bx, by]: readonly [number, number],
  box: Readonly<Box>,
): boolean {
  const [dx, dy] = [bx - ax, by - ay];
  let [from, to] = [0, 1]; // of the line what is within the sides so far
  for (const [step, room] of [
    [-dx, ax - box[0]],
    [dx, box[2] - ax],
    [-dy, ay - box[1]],
    [dy, box[3] - ay],
  ] as const) {
    if (step === 0 && room < 0) return false;
    if (step < 0) from = Math.max(from, room / step);
    if (step > 0) to = Math.min(to, room / step);
  }
  return from <= to;
}

/** Extend a box to contain another one. */
export function extend(box: Box, x0: number, y0: number, x1: number, y1: number): void {
  if (x0 < box[0]) box[0] = x0;
  if (y0 < box[1]) box[1] = y0;
  if (x1 > box[2]) box[2] = x1;
  if (y1 > box[3]) box[3] = y1;
}
