import { describe, expect, it } from "vitest";
import type { Summary } from "../../../src/workbench/client/api";
import { changeOf, compareFigures } from "../../../src/workbench/result/reference";

const summary = (value: string, utilization: number): Summary => ({
  design: {
    status: "attention",
    headline: "",
    checks: [{ name: "punching", status: "attention", words: "", utilization, between: null, verdict: "attention" }],
  },
  combinations: [
    {
      name: "heavy",
      refused: null,
      certificate: null,
      sections: [
        {
          title: "Settlement",
          rows: [
            { label: "largest", symbol: "w", value, unit: "mm", note: "" },
            { label: "largest", symbol: "m_x", value: "3", unit: "mm", note: "" },
            { label: "kind", symbol: "", value: "winkler", unit: "", note: "" },
          ],
          notes: [],
        },
      ],
    },
  ],
});

describe("a reference", () => {
  it("stands beside the result with differences in percent of it", () => {
    const found = compareFigures(summary("8.0000", 0.5), summary("10.000", 0.4), "heavy");
    expect(found.map(({ label, before, now }) => [label, before, now])).toEqual([
      ["largest", "8.0000", "10.000"],
      ["largest", "3", "3"],
      ["utilization, punching", "0.50", "0.40"],
    ]);
    expect(found.map(({ change }) => change?.toFixed(6))).toEqual(["25.000000", "0.000000", "-20.000000"]);
    expect(compareFigures(summary("1", 0.5), summary("1", 0.5), "other")).toHaveLength(1);
  });

  it("has no difference to zero or to words; of a negative figure the size counts", () => {
    expect(changeOf("0", "2")).toBeNull();
    expect(changeOf("0", "0")).toBe(0);
    expect(changeOf("holds", "2")).toBeNull();
    expect(changeOf("-4", "-5")).toBe(-25);
  });
});
