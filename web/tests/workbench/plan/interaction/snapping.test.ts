// @vitest-environment happy-dom
// Snapping of the pointer.
import { describe, expect, it } from "vitest";
import { roundStepOf } from "../../../../src/viewer/data/numbers";
import { roundTo, snap } from "../../../../src/workbench/plan/interaction/snapping";

describe("snapping", () => {
  const points = [
    [2, 2],
    [5, 0.503],
  ] as const;

  it("takes an existing corner that is near before all else", () => {
    expect(snap({ at: [2.03, 1.96], points, step: 0.1, reach: 0.1 }).at).toEqual([2, 2]);
  });

  it("takes round lengths where nothing is near", () => {
    expect(snap({ at: [3.333, 1.449], points: [], step: 0.1, reach: 0.01 }).at).toEqual([3.3, 1.4]);
  });

  it("goes in line with an existing place, each axis for itself", () => {
    const snapped = snap({ at: [3.14, 0.5034], points, step: 0.02, reach: 0.05 });
    expect(snapped.at[1]).toBe(0.503);
    expect(snapped.fromY).toEqual([5, 0.503]);
    expect(snapped.fromX).toBeNull();
  });

  it("makes steps of 1, 2 and 5, and numbers without noise", () => {
    expect([0.003, 0.01, 0.011, 0.3, 7].map((least) => roundStepOf([1, 2, 5], least))).toEqual([
      0.005, 0.01, 0.02, 0.5, 10,
    ]);
    expect([roundTo(0.1 + 0.2, 0.1), roundTo(-0.001, 0.05), roundTo(1234.5678, 0.002)]).toEqual([0.3, 0, 1234.568]);
  });
});
