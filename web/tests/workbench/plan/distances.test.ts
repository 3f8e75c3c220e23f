import { expect, it } from "vitest";

import { itemsOf } from "../../../src/workbench/model/items";
import { neighborLines } from "../../../src/workbench/plan/distances";

it("goes from a column to the nearest edges and columns along x and y", () => {
  const items = itemsOf(
    {
      plate: {
        length_x: "10 m",
        length_y: "6 m",
        openings: [{ kind: "rectangle", x: ["2 m", "3 m"], y: ["-1 m", "1 m"] }],
      },
      columns: [
        { name: "A1", x: "0 m", y: "0.5 m" },
        { name: "B1", x: "-2 m", y: "0.5 m" },
        { name: "A2", x: "0 m", y: "-2 m" },
        { name: "C9", x: "-1 m", y: "0.7 m" },
      ],
      boreholes: [{ x: "0 m", y: "1 m" }],
    },
    null,
  );
  const column = items.find(({ kind }) => kind === "column")!;
  // left: the column in line, not the one beside the line; right: the opening; below: a column; above: the edge
  expect(neighborLines(column, items).map(([, to]) => to)).toEqual([
    [-2, 0.5],
    [2, 0.5],
    [0, -2],
    [0, 3],
  ]);
  const slab = items.find(({ kind }) => kind === "slab")!;
  expect(neighborLines(slab, items)).toEqual([]);
});
