import { describe, expect, it } from "vitest";
import type { Plan } from "../../../src/viewer/data/scene";
import { itemAt, itemOf, itemsIn, middleOf } from "../../../src/workbench/result/plan-items";

const RING: [number, number][] = [
  [0, 0],
  [4, 0],
  [4, 2],
  [0, 2],
];
const PLAN = {
  columns: [{ path: "columns[1]", name: "A1", x: 1, y: 1, ring: [] }],
  supports: [
    {
      path: "supports[1]",
      name: "wall",
      kind: "line",
      points: [
        [0, 2],
        [4, 2],
      ],
      acts: "",
      elastic: false,
    },
  ],
  loads: [{ path: "loads[1]", name: "", kind: "uniform", everywhere: true, case: "", ring: RING, parts: [] }],
  boreholes: [],
  points: [],
  lines: [],
  strips: [{ path: "output.strips[1]", name: "axis", start: [0, 1], end: [4, 1], width: 1 }],
  openings: [],
  voids: [],
  zones: [{ path: "plate.zones[1]", ring: RING, thickness: 0.3 }],
  soil_zones: [],
} as unknown as Plan;

describe("items of the picture", () => {
  it("are found at a place: points and lines that are near, then areas", () => {
    expect(itemAt(PLAN, [1.1, 1], 0.2)?.path).toBe("columns[1]");
    expect(itemAt(PLAN, [2, 1.9], 0.2)?.path).toBe("supports[1]");
    expect(itemAt(PLAN, [3, 1.1], 0.2)?.path).toBe("output.strips[1]");
    expect(itemAt(PLAN, [3, 0.5], 0.2)?.path).toBe("plate.zones[1]");
    expect(itemAt(PLAN, [5, 0.5], 0.2)).toBeNull();
  });

  it("are found by list and by path, not a load on the entire slab", () => {
    expect(itemsIn(PLAN, "output.strips").map((each) => middleOf(each))).toEqual([[2, 1]]);
    expect(itemsIn(PLAN, "loads")).toEqual([]);
    expect(itemOf(PLAN, "plate.zones[1].shape")?.shape).toBe("area");
    expect(itemOf(PLAN, "loads[1]")).toBeNull();
  });
});
