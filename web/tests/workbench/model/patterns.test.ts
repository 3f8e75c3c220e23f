import { describe, expect, it } from "vitest";

import type { Geometry } from "../../../src/workbench/model/geometry";
import { patternFeet } from "../../../src/workbench/model/patterns";

describe("a pattern in plan", () => {
  const size = { width_x: "0.2 m", width_y: "0.4 m" };
  const rack = { kind: "rack", name: "rack", frames: 2, bay: "3 m", rows: ["0 m", "1 m"], ...size };
  const data = { patterns: [rack] };
  const at: Geometry = { type: "line", at: [], points: [[5, 1]], bulges: [] };
  const centers = (move: { pattern: string; turn?: number }, geometry: Geometry) =>
    patternFeet(data, move, geometry).map((ring) =>
      [0, 1].map((n) => Number((ring.reduce((sum, point) => sum + point[n]!, 0) / ring.length).toFixed(9))),
    );
  it("has its rows to the left of its direction", () => {
    expect(centers({ pattern: "rack" }, at)).toEqual([
      [5, 1],
      [5, 2],
      [8, 1],
      [8, 2],
    ]);
    expect(centers({ pattern: "rack", turn: 90 }, at)).toEqual([
      [5, 1],
      [4, 1],
      [5, 4],
      [4, 4],
    ]);
  });
  it("has the direction of its path", () => {
    const path: Geometry = {
      ...at,
      points: [
        [5, 1],
        [5, -4],
      ],
    };
    expect(centers({ pattern: "rack" }, path)).toEqual([
      [5, 1],
      [6, 1],
      [5, -2],
      [6, -2],
    ]);
    expect(centers({ pattern: "none" }, path)).toEqual([]);
  });
});
