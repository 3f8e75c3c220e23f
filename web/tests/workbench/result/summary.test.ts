// @vitest-environment happy-dom
import { describe, expect, it } from "vitest";
import type { DesignCheck, Summary } from "../../../src/workbench/client/api";
import { betweenText, showSummary } from "../../../src/workbench/result/summary";

const check = (about: Partial<DesignCheck>): DesignCheck => ({
  name: "one-way shear",
  status: "no failure found",
  verdict: "no failure found",
  words: "v_Ed",
  utilization: 0.97,
  between: [0.93, 1.01],
  ...about,
});

describe("a check in the summary", () => {
  it("says between which values its utilization is", () => {
    expect(betweenText(check({}))).toBe("0.93 to 1.01");
    expect(betweenText(check({ between: [0.969, 0.971] }))).toBe("±<0.01");
    expect(betweenText(check({ between: [0.97, 0.97] }))).toBe("");
    expect(betweenText(check({ between: null }))).toBe("");
    expect(betweenText(check({ between: [0.5, null] }))).toBe("0.50 to ∞");
  });

  it("says that its verdict hangs on the error", () => {
    const shown = (verdict: string) => {
      const element = document.createElement("div");
      const design = { status: "no failure found" as const, headline: "head", checks: [check({ verdict })] };
      showSummary(element, null, { design, combinations: [] } satisfies Summary);
      return element;
    };
    const hanging = shown("no failure found, but within the error");
    expect(hanging.querySelector("p.verdict.doubtful")?.textContent).toBe("head");
    expect(hanging.querySelector("tr strong")?.textContent).toContain("but within the error");
    expect(shown("no failure found").querySelector("strong, p.verdict")).toBeNull();
  });
});
