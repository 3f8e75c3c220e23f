// Numbers on a field say what the field is there, and are as far apart as the zoom asks for.
import { expect, it } from "vitest";
import type { Box } from "../../../src/viewer/data/boxes";
import { makeScale } from "../../../src/viewer/data/color-scale";
import { clearOfEdges, contourNumbers, rasterNumbers } from "../../../src/viewer/data/field-numbers";
import { distanceBetween } from "../../../src/viewer/data/points";
import type { Point, Ring } from "../../../src/viewer/data/scene";
import { grid, nodal } from "../synthetic";

const MESH = grid(40, 20, (x, y) => [20 * x, 10 * y]);
const PLANE = nodal(MESH, (x, y) => 3 * x + y);
const ALL: Box = [0, 0, 20, 10];

it("numbers on contours are levels, and stand where the field has them", () => {
  const numbers = contourNumbers(MESH, PLANE, makeScale(0, 70, false), ALL, 40);
  expect(numbers.length).toBeGreaterThan(10);
  for (const { at, text } of numbers) expect(3 * at[0] + at[1]).toBeCloseTo(Number(text), 4);
  expect(new Set(numbers.map(({ text }) => Number(text) % 5))).toEqual(new Set([0]));
});

it("a contour has its number less often when it is seen from afar", () => {
  const count = (scale: number) => contourNumbers(MESH, PLANE, makeScale(0, 70, false), ALL, scale).length;
  expect(count(200)).toBeGreaterThan(2 * count(40));
});

it("numbers on the raster are values at nodes, at least half a step of the raster apart, and fewer from afar", () => {
  const near = rasterNumbers(MESH, PLANE, ALL, 80);
  const far = rasterNumbers(MESH, PLANE, ALL, 40);
  for (const { at, text } of near) expect(3 * at[0] + at[1]).toBeCloseTo(Number(text), 1);
  // 1600 by 800 pixels and half of that, a number to at least 78 pixels
  expect(near).toHaveLength(20 * 10);
  expect(far).toHaveLength(10 * 5);
  const distances = near.flatMap((a, i) => near.slice(i + 1).map((b) => distanceBetween(a.at, b.at)));
  expect(Math.min(...distances)).toBeGreaterThanOrEqual(0.5);
  expect(rasterNumbers(MESH, PLANE, [4.8, 4.8, 6.3, 6.3], 80)).toHaveLength(4);
});

it("no number straddles an edge of the slab, of another one or of an opening, near or from afar", () => {
  const rectangle = (x0: number, y0: number, x1: number, y1: number): Ring => [
    [x0, y0],
    [x1, y0],
    [x1, y1],
    [x0, y1],
  ];
  const opening = { path: "", ring: rectangle(8, 3, 11.5, 6.5) };
  const plan = { outline: rectangle(0, 0, 20, 10), openings: [opening] };
  for (const scale of [12, 25, 40, 60, 90]) {
    const isClear = clearOfEdges(plan, scale);
    const numbers = [
      ...contourNumbers(MESH, PLANE, makeScale(0, 70, false), ALL, scale, isClear),
      ...rasterNumbers(MESH, PLANE, ALL, scale, isClear),
    ];
    expect(numbers.length).toBeGreaterThan(3);
    for (const { at, text } of numbers) {
      // in pixels: letters of 5.5 by 11 around the place
      const [dx, dy] = [(5.5 * text.length) / 2 / scale, 5.5 / scale];
      const box = rectangle(at[0] - dx, at[1] - dy, at[0] + dx, at[1] + dy);
      const isWithin = ([x, y]: Point) => x > 0 && x < 20 && y > 0 && y < 10;
      const isInOpening = ([x, y]: Point) => x > 8 && x < 11.5 && y > 3 && y < 6.5;
      expect(box.every(isWithin)).toBe(true);
      expect(new Set(box.map(isInOpening)).size).toBe(1);
    }
  }
});
