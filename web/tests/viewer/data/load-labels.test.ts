// What loads are called: what acts at a place in a combination, or a single load with its case.
import { describe, expect, it } from "vitest";
import { labelEverywhere, labelLoads } from "../../../src/viewer/data/load-labels";
import type { Load } from "../../../src/viewer/data/scene";

const point = (of: string, P: number, M_x = 0, x = 1): Load => ({
  path: "",
  name: "",
  kind: "point",
  case: of,
  points: [[x, 2]],
  parts: [
    ["P", P, "kN"],
    ["M_x", M_x, "kNm"],
    ["M_y", 0, "kNm"],
  ],
});
const line: Load = {
  path: "",
  name: "",
  kind: "line",
  case: "Q",
  points: [
    [0, 0],
    [1, 0],
  ],
  parts: [
    ["q", 20, "kN/m"],
    ["q_end", 10, "kN/m"],
  ],
};
const area: Load = {
  path: "",
  name: "",
  kind: "area",
  case: "Q",
  ring: [
    [0, 0],
    [1, 0],
    [0, 1],
  ],
  parts: [["q", 12, "kPa"]],
  varies: true,
};
const words = (loads: Load[], factors: [string, number][] | null) =>
  labelLoads(loads, factors && new Map(factors)).map((each) => each.text);

describe("loads in a combination", () => {
  it("are called by what acts at their place, factors included", () => {
    const loads = [point("G", 200), point("Q", 100, 20), point("Q", 50, 0, 3), line, area];
    expect(
      words(loads, [
        ["G", 1.35],
        ["Q", 1.5],
      ]),
    ).toEqual(["P = 420 kN, M_x = 30 kNm", "", "P = 75 kN", "q = 30 to 15 kN/m", "q = 18 kPa and varying"]);
    expect(words(loads, [["G", 1]])).toEqual(["P = 200 kN"]);
    expect(
      words(loads, [
        ["G", 1],
        ["Q", 0],
      ]),
    ).toEqual(["P = 200 kN"]);
  });

  it("say zero where what acts at a place cancels out", () => {
    expect(
      words(
        [point("G", 200), point("Q", -100)],
        [
          ["G", 1],
          ["Q", 2],
        ],
      ),
    ).toEqual(["P = 0 kN", ""]);
  });
});

describe("loads where no one combination is shown", () => {
  it("say their case and that its factor is 1", () => {
    expect(words([point("G", 200), line], null)).toEqual(["P = 200 kN (1.0 G)", "q = 20 to 10 kN/m (1.0 Q)"]);
  });

  it("act together where there are no cases", () => {
    expect(words([point("", 200), point("", -50)], null)).toEqual(["P = 150 kN", ""]);
  });
});

describe("what acts on the entire slab", () => {
  const everywhere = (kind: string, of: string, value: number, unit: string, symbol = "q"): Load => ({
    path: "",
    name: "",
    kind,
    everywhere: true,
    case: of,
    parts: [[symbol, value, unit]],
  });

  it("is the sum of loads of a kind, factors included; loads with a place are left out", () => {
    const loads = [
      everywhere("self weight", "G", 25, "kN/m^3", "gamma_c"),
      everywhere("uniform", "G", 1.5, "kPa"),
      everywhere("uniform", "Q", 2, "kPa"),
      point("G", 200),
    ];
    const factors = new Map([
      ["G", 1.35],
      ["Q", 1.5],
    ]);
    expect(labelEverywhere(loads, factors)).toBe("gamma_c = 33.75 kN/m^3, q = 5.025 kPa");
    expect(labelEverywhere(loads, new Map([["Q", 1.5]]))).toBe("q = 3 kPa");
    expect(labelEverywhere([point("G", 200)], factors)).toBe("");
  });
});
