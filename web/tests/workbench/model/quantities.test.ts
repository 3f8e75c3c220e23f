// Lengths as texts: read, moved, written back in the unit that stood there.
import { describe, expect, it } from "vitest";
import { applyOptimistic } from "../../../src/workbench/model/changes/optimistic-edits";
import {
  formatDecimals,
  formatLength,
  formatLike,
  parseLength,
  parsePoint,
} from "../../../src/workbench/model/quantities";

describe("lengths", () => {
  it("reads units as the program does, without noise", () => {
    expect(["700 mm", "0.7m", " 70 cm ", "1 ft", "-2.5 m", "1e3 mm"].map(parseLength)).toEqual([
      0.7, 0.7, 0.7, 0.3048, -2.5, 1,
    ]);
  });

  it("knows what is no length", () => {
    expect(["3", "3 kN", "", "m", "1 m 2", 3, null].map((each) => parseLength(each))).toEqual([
      null,
      null,
      null,
      null,
      null,
      null,
      null,
    ]);
    expect(parsePoint(["1 m", "x"])).toBeNull();
  });

  it("writes in the unit that stood there", () => {
    expect(formatLike("200 mm", 0.25)).toBe("250 mm");
    expect(formatLike(["1 m", "50 cm"], [2, 0.75])).toEqual(["2 m", "75 cm"]);
    expect(
      formatLike(
        [["1 m", "2 m"]],
        [
          [1, 2],
          [3, 4.0005],
        ],
      ),
    ).toEqual([
      ["1 m", "2 m"],
      ["3 m", "4.0005 m"],
    ]);
    expect(formatLike(undefined, 0.1 + 0.2)).toBe("0.3 m");
  });

  it("writes no zeros and no minus at nothing", () => {
    expect([formatDecimals(2.5, 3), formatDecimals(100, 0), formatDecimals(-1e-9, 3), formatLength(-0.00001)]).toEqual([
      "2.5",
      "100",
      "0",
      "0 m",
    ]);
  });
});

describe("foreseen edits", () => {
  const data = {
    plate: { openings: [{ kind: "rectangle", x: ["0 m", "100 cm"], y: ["0 m", "1 m"] }] },
    columns: [{ name: "A", x: "500 mm", y: "1 m" }],
  };

  it("moves all places of an item in their units", () => {
    const moved = applyOptimistic(
      applyOptimistic(data, { op: "move", path: ["plate", "openings", 0], by: [0.5, -1] }),
      {
        op: "move",
        path: ["columns", 0],
        by: [0.5, -1],
      },
    );
    expect(moved).toEqual({
      plate: { openings: [{ kind: "rectangle", x: ["0.5 m", "150 cm"], y: ["-1 m", "0 m"] }] },
      columns: [{ name: "A", x: "1000 mm", y: "0 m" }],
    });
  });

  it("makes lists and tables that are missing, and takes away what is there only", () => {
    expect(applyOptimistic({}, { op: "add", path: ["output", "lines"], value: { name: "l" } })).toEqual({
      output: { lines: [{ name: "l" }] },
    });
    expect(applyOptimistic({}, { op: "set", path: ["mesh", "size"], value: "1 m" })).toEqual({ mesh: { size: "1 m" } });
    expect(applyOptimistic({ a: 1 }, { op: "remove", path: ["mesh", "size"] })).toEqual({ a: 1 });
    expect(applyOptimistic({ loads: [1, 2, 3] }, { op: "remove", path: ["loads", 1] })).toEqual({ loads: [1, 3] });
  });

  it("leaves the data before it as they were", () => {
    const before = JSON.stringify(data);
    applyOptimistic(data, { op: "length", path: ["columns", 0, "x"], value: 3 });
    expect(JSON.stringify(data)).toBe(before);
  });
});
