// Numbers on a field say what the field is there, and are as far apart as the zoom asks for.
import { expect, it } from "vitest";
import type { Box } from "../../../src/viewer/data/boxes";
import { makeScale } from "../../../src/viewer/data/color-scale";
import { contourNumbers, rasterNumbers } from "../../../src/viewer/data/field-numbers";
import { distanceBetween } from "../../../src/viewer/data/points";
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
  expect(near).toHaveLength(21 * 11);
  expect(far).toHaveLength(11 * 6);
  const distances = near.flatMap((a, i) => near.slice(i + 1).map((b) => distanceBetween(a.at, b.at)));
  expect(Math.min(...distances)).toBeGreaterThanOrEqual(0.5);
  expect(rasterNumbers(MESH, PLANE, [4.8, 4.8, 6.3, 6.3], 80)).toHaveLength(4);
});
