import { describe, expect, it } from "vitest";

import { itemsOf } from "../../../src/workbench/model/items";
import { axesOf } from "../../../src/workbench/plan/axes";

/** Return the items of columns at places. */
function columns(places: Record<string, [number, number]>) {
  const list = Object.entries(places).map(([name, [x, y]]) => ({ name, x: `${x} m`, y: `${y} m` }));
  return itemsOf({ columns: list }, null);
}

describe("axes of columns", () => {
  const grid = columns({ A1: [0, 0], B1: [6, 0.0004], A2: [0, 5], B2: [6, 5], C2: [11.4, 5] });

  it("are named by what their columns' names share", () => {
    expect(axesOf(grid, 0)).toEqual([
      { at: 0, columns: 2, name: "A" },
      { at: 6, columns: 2, name: "B" },
      { at: 11.4, columns: 1, name: "C" },
    ]);
    expect(axesOf(grid, 1)).toEqual([
      { at: 0, columns: 2, name: "1" },
      { at: 5, columns: 3, name: "2" },
    ]);
  });
  it("have no names where columns are only counted, or are named in other ways", () => {
    for (const names of [
      ["C1", "C2", "C3"],
      ["left", "middle", "right"],
    ] as const) {
      const row = columns({ [names[0]]: [0, 0], [names[1]]: [3, 0], [names[2]]: [3, 4] });
      expect(axesOf(row, 1).map(({ name }) => name)).toEqual(["", ""]);
    }
  });
  it("are none without columns", () => expect(axesOf([], 0)).toEqual([]));
});
