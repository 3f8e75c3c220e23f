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

it("a pit has its level beside its thickness, another zone its thickness alone", () => {
  const ring = [[0, 0] as [number, number], [1, 0] as [number, number], [1, 1] as [number, number]];
  const lengths = { unit: "m", per_meter: 1, small: "mm", small_per_meter: 1000 };
  const zones = [
    { path: "plate.zones[1]", ring, thickness: 0.4, level: -1.2, wall: 0.3 },
    { path: "plate.zones[2]", ring, thickness: 0.5 },
  ];
  const symbols = symbolsOf({ ...EMPTY, lengths, zones }, ALL_LAYERS, new Map());
  const texts = symbols.filter(({ kind }) => kind === "zone").flatMap((symbol) => symbol.texts);
  expect(texts).toEqual(["t = 400 mm, z = −1.2 m", "t = 500 mm"]);
});
