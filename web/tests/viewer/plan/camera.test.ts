import { describe, expect, it } from "vitest";
import { Camera, isNear } from "../../../src/viewer/plan/camera";

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

  it("shows all of a box between what is taken at its sides", () => {
    const camera = Object.assign(new Camera(), { width: 500, height: 400 });
    camera.fit([0, 0, 4, 6], 20, 46, 24, 18);
    expect(camera.toPixel([0, 6])[1]).toBeCloseTo(38, 9);
    expect(camera.toPixel([0, 0])[1]).toBeCloseTo(400 - 44, 9);
    const [left, right] = [camera.toPixel([0, 0])[0] - 46, 500 - camera.toPixel([4, 0])[0]];
    expect(left).toBeCloseTo(right, 9);
  });

  it("tells how a drawing of before has to be moved", () => {
    const drawn = Object.assign(new Camera(), { width: 400, height: 300, x: 1, y: 2, scale: 40 });
    const camera = drawn.copy();
    expect(camera.isAt(drawn)).toBe(true);
    camera.zoom(1.5, [70, 210]);
    camera.pan(33, -12);
    expect(camera.isAt(drawn)).toBe(false);
    const { dx, dy, zoom } = camera.since(drawn);
    const [u, v] = drawn.toPixel([-2.5, 3.25]);
    // about the middle of the view, as style sheets stretch
    const [moved, there] = [[200 + zoom * (u - 200) + dx, 150 + zoom * (v - 150) + dy], camera.toPixel([-2.5, 3.25])];
    expect(moved[0]).toBeCloseTo(there[0], 9);
    expect(moved[1]).toBeCloseTo(there[1], 9);
  });

  it("draws again what has moved or grown too far", () => {
    const camera = Object.assign(new Camera(), { width: 400, height: 300 });
    expect(isNear({ dx: 100, dy: -100, zoom: 1.5 }, camera, 0.4)).toBe(true);
    expect(isNear({ dx: 170, dy: 0, zoom: 1 }, camera, 0.4)).toBe(false);
    expect(isNear({ dx: 0, dy: -130, zoom: 1 }, camera, 0.4)).toBe(false);
    expect(isNear({ dx: 0, dy: 0, zoom: 2 }, camera, 0.4)).toBe(false);
  });
});
