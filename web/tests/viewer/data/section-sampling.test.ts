import { describe, expect, it } from "vitest";
import { Locator } from "../../../src/viewer/data/point-location";
import {
  axisLimits,
  findPeaks,
  pointsDownward,
  sampleField,
  sampleLine,
} from "../../../src/viewer/data/section-sampling";
import { beside, grid, sceneOf } from "../synthetic";

describe("a section", () => {
  it("has the values of the field along it", () => {
    const scene = sceneOf(
      grid(5, 5, (x, y) => [10 * x, 10 * y]),
      [{ name: "A", fields: { settlement: (x, y) => x * x + y } }],
    );
    const locator = new Locator(scene.mesh);
    const samples = sampleLine(locator, [1, 1], [7, 9]);
    expect(samples.s[0]).toBe(0);
    expect(samples.s[samples.s.length - 1]).toBeCloseTo(10, 12);
    const values = sampleField(scene, locator, 0, "settlement", samples);
    samples.s.forEach((s, i) => {
      if (i) expect(s).toBeGreaterThan(samples.s[i - 1]!);
      const [x, y] = [1 + 0.6 * s, 1 + 0.8 * s];
      expect(values[i]).toBeCloseTo(x * x + y, 3);
    });
  });

  it("has gaps where there is no plate, which begin and end at its edges", () => {
    const scene = sceneOf(
      grid(
        7,
        7,
        (x, y) => [7 * x, 7 * y],
        (i) => i !== 3,
      ),
      [{ name: "A", fields: { settlement: () => 1 } }],
    );
    const samples = sampleLine(new Locator(scene.mesh), [-1, 3.5], [8, 3.5], 50);
    const borders: number[] = [];
    samples.spots.forEach((spot, i) => {
      if (i && (spot === null) !== (samples.spots[i - 1] === null))
        borders.push((samples.s[i]! + samples.s[i - 1]!) / 2 - 1);
    });
    expect(borders).toHaveLength(4);
    for (const [i, x] of [0, 3, 4, 7].entries()) expect(borders[i]).toBeCloseTo(x, 3);
  });

  it("jumps where two sections of the plate meet", () => {
    const mesh = beside(
      grid(3, 3),
      grid(3, 3, (x, y) => [1 + x, y]),
    );
    const scene = sceneOf(mesh, [{ name: "A", fields: {} }]);
    const locator = new Locator(scene.mesh);
    const jump = Float32Array.from({ length: mesh.nodeCount }, (_, i) => (i < mesh.nodeCount / 2 ? 1 : 5));
    const samples = sampleLine(locator, [0, 0.43], [2, 0.43], 33);
    const values = samples.spots.map((spot) => locator.interpolate(jump, spot!));
    const at = values.findIndex((value) => value > 3);
    expect(values[at - 1]).toBeCloseTo(1, 5);
    expect(values[at]).toBeCloseTo(5, 5);
    expect(samples.s[at]! - samples.s[at - 1]!).toBeLessThan(1e-5);
    expect(samples.s[at]).toBeCloseTo(1, 3);
  });

  it("finds its smallest and largest value, if it meets the plate at all", () => {
    expect(findPeaks([0, 1, 2, 3], [null, 4, -2, 7])).toEqual({ min: [2, -2], max: [3, 7] });
    expect(findPeaks([0, 1], [null, null])).toBeNull();
  });

  it("is drawn from zero, downwards where the plate settles or its face is in tension", () => {
    expect(axisLimits(2, 10)).toEqual([0, 10.8]);
    expect(axisLimits(-10, -1)).toEqual([-10.8, 0]);
    const [low, high] = axisLimits(9, 10);
    expect([low > 8, high > 10]).toEqual([true, true]);
    const [from, to] = axisLimits(0, 0);
    expect(to).toBeGreaterThan(from);
    expect(["settlement", "moment_xy", "m_1", "bottom_x", "pressure", "shear_x"].map(pointsDownward)).toEqual([
      true,
      true,
      true,
      true,
      false,
      false,
    ]);
  });
});
