import { describe, expect, it } from "vitest";
import { Locator } from "../../../src/viewer/data/point-location";
import {
  axisLimits,
  findPeaks,
  pointsDownward,
  sampleField,
  sampleLine,
  sampleStrip,
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

describe("a strip", () => {
  const mesh = grid(4, 4, (x, y) => [4 * x, 4 * y]);
  const given = [
    { name: "A", fields: { settlement: (x: number, y: number) => x + 3 * (y - 2) ** 2 } },
    { name: "B", fields: { settlement: (x: number) => 9 - x } },
  ];
  const scene = sceneOf(mesh, given);
  const locator = new Locator(mesh);

  it("has the mean over its width of what is on the plate", () => {
    // the mean of 3 v^2 over a width b is b^2 / 4, by twenty trapezoids a little more
    const samples = sampleStrip(locator, [0.5, 2], [3.5, 2], 2, 30);
    const values = sampleField(scene, locator, 0, "settlement", samples);
    for (const [i, s] of samples.s.entries()) expect(values[i]).toBeCloseTo(0.5 + s + 1 * (1 + 2 / 20 ** 2), 4);
    // half of it beyond the plate, which does not count: v from -2 to 0 of 9 - x is 9 - x
    const beside = sampleStrip(locator, [0.5, 0], [3.5, 0], 2, 6);
    sampleField(scene, locator, 1, "settlement", beside).forEach((value, i) => {
      expect(value).toBeCloseTo(8.5 - beside.s[i]!, 4);
    });
    const off = sampleStrip(locator, [0, 9], [4, 9], 2, 4);
    expect(sampleField(scene, locator, 0, "settlement", off)).toEqual([null, null, null, null, null]);
  });

  it("has of an envelope the extreme of the means, not the mean of the extremes", () => {
    const samples = sampleStrip(locator, [1, 2], [3, 2], 4, 2);
    const [a, b] = [0, 1].map((choice) => sampleField(scene, locator, choice, "settlement", samples));
    const largest = sampleField(scene, locator, "largest", "settlement", samples);
    expect(largest).toEqual(a!.map((value, i) => Math.max(value!, b![i]!)));
  });
});
