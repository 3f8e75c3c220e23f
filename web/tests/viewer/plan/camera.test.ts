import { describe, expect, it } from "vitest";
import { Camera } from "../../../src/viewer/plan/camera";

describe("the camera", () => {
  it("keeps the place under the pointer while it zooms", () => {
    const camera = new Camera();
    Object.assign(camera, { width: 400, height: 300 });
    camera.fit([0, 0, 6, 4]);
    const before = camera.toPlan([100, 80]);
    camera.zoom(1.7, [100, 80]);
    const after = camera.toPlan([100, 80]);
    expect(after[0]).toBeCloseTo(before[0], 12);
    expect(after[1]).toBeCloseTo(before[1], 12);
    expect(camera.toPixel(after)[0]).toBeCloseTo(100, 9);
  });
});
