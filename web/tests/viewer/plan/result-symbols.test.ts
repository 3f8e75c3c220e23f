// What a result writes on its plan: reactions of one combination, bars of the layer that a field is of.
import { expect, it } from "vitest";
import type { BarSet } from "../../../src/viewer/data/scene";
import { ALL_LAYERS } from "../../../src/viewer/plan/plan-symbols";
import { annotationSymbols, annotationsOf, layerOf } from "../../../src/viewer/plan/result-symbols";
import { grid, sceneOf } from "../synthetic";

const BARS: BarSet[] = [
  { layer: "bottom_x", zone: "", rings: [], at: [1, 1], text: "ø12 / 150" },
  {
    layer: "bottom_x",
    zone: "Z",
    rings: [
      [
        [0, 0],
        [1, 0],
        [0, 1],
      ],
    ],
    at: [0.2, 0.2],
    text: "ø16 / 150",
  },
  { layer: "top_y", zone: "", rings: [], at: [1, 1], text: "#4 @ 6 in" },
];
const { head } = sceneOf(grid(1, 1), [{ name: "dead" }], { bars: BARS });
head.combinations[0]!.reactions = [{ at: [2, 3], text: "↑ 520 kN, M_x = 3 kNm" }];

it("a field is of the layer that its name ends with", () => {
  expect(["required_bottom_x", "top_y", "utilization_top_y", "moment_x", "settlement"].map(layerOf)).toEqual([
    "bottom_x",
    "top_y",
    "top_y",
    "",
    "",
  ]);
});

it("reactions are those of a combination, none of several; bars are those of the layer", () => {
  expect(annotationsOf(head, 0, "settlement")).toEqual({ reactions: head.combinations[0]!.reactions, bars: [] });
  expect(annotationsOf(head, null, "missing_top_y")).toEqual({ reactions: [], bars: [BARS[2]] });
});

it("words are drawn where they belong, borders around zones, and nothing of a layer that is off", () => {
  const written = annotationsOf(head, 0, "required_bottom_x");
  const symbols = annotationSymbols(written, ALL_LAYERS);
  expect(symbols.map(({ kind, shape, texts }) => [kind, shape, ...texts])).toEqual([
    ["bars", "point", "ø12 / 150"],
    ["bars", "area", "ø16 / 150"],
    ["reaction", "point", "↑ 520 kN, Mx = 3 kNm"],
  ]);
  expect(annotationSymbols(written, { ...ALL_LAYERS, bars: false, reactions: false })).toEqual([]);
});
