// Arrows and texts where a plan is crowded: some are drawn, none over another one, and those that are marked stay.
import { expect, it } from "vitest";
import { Camera } from "../../../src/viewer/plan/camera";
import type { PlanSymbol } from "../../../src/viewer/plan/symbols";
import { thinLoads } from "../../../src/viewer/plan/thinning";

const camera = Object.assign(new Camera(), { scale: 5, width: 500, height: 500 });
const loads = Array.from(
  { length: 400 },
  (_, n): PlanSymbol => ({
    kind: "load",
    shape: "point",
    points: [[(n % 20) * 2, Math.floor(n / 20) * 2]],
    texts: ["1 kN"],
  }),
);

it("loads 10 px apart have arrows at least 26 px apart, one within reach of each, and all where there is space", () => {
  const drawn = thinLoads(loads, camera);
  const arrows = drawn.filter(({ crowded }) => !crowded).map(({ points }) => camera.toPixel(points[0]!));
  expect(arrows.length).toBeGreaterThan(15);
  for (const [n, [x, y]] of arrows.entries())
    for (const [u, v] of arrows.slice(n + 1)) expect(Math.max(Math.abs(u - x), Math.abs(v - y))).toBeGreaterThan(26);
  for (const { points } of drawn) {
    const [x, y] = camera.toPixel(points[0]!);
    expect(arrows.some(([u, v]) => Math.max(Math.abs(u - x), Math.abs(v - y)) < 2 * 26)).toBe(true);
  }
  const near = Object.assign(new Camera(), { scale: 40, width: 500, height: 500 });
  expect(thinLoads(loads, near)).toEqual(loads);
});

it("a load that is marked keeps its arrow beside others", () => {
  expect(thinLoads(loads, camera, (n) => n === 1)[1]).toBe(loads[1]);
});
