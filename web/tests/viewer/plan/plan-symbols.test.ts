// The symbols of a solved plan.
import { expect, it } from "vitest";
import type { Load, Plan } from "../../../src/viewer/data/scene";
import { ALL_LAYERS, symbolsOf } from "../../../src/viewer/plan/plan-symbols";

const EMPTY: Plan = {
  outline: [],
  bounds: [0, 0, 1, 1],
  openings: [],
  zones: [],
  columns: [],
  supports: [],
  soil_zones: [],
  voids: [],
  boreholes: [],
  strips: [],
  lines: [],
  points: [],
  loads: [],
};

it("an arrow points upwards where the force or the settlement does, whatever the sign of a moment", () => {
  const isUpward = (...parts: Load["parts"]) => {
    const load: Load = { path: "", name: "", kind: "point", case: "", points: [[1, 2]], parts };
    const symbols = symbolsOf({ ...EMPTY, loads: [load] }, ALL_LAYERS, new Map());
    return symbols.find(({ kind }) => kind === "load")!.upward;
  };
  expect(isUpward(["P", 100, "kN"], ["M_x", -5, "kNm"])).toBe(false);
  expect(isUpward(["P", -100, "kN"], ["M_x", 5, "kNm"])).toBe(true);
  expect(isUpward(["P", 0, "kN"], ["M_x", -5, "kNm"])).toBe(false);
  expect(isUpward(["w_s", -10, "mm"])).toBe(true);
});
