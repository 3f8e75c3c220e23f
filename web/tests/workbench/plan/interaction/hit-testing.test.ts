// @vitest-environment happy-dom
// Which items lie under the pointer.
import { describe, expect, it } from "vitest";
import { itemsOf } from "../../../../src/workbench/model/items";
import type { Table } from "../../../../src/workbench/model/paths";
import { itemsAt } from "../../../../src/workbench/plan/interaction/hit-testing";
import { DATA } from "../../slab";

describe("what lies under the pointer", () => {
  it("is the column first, then the load on it, then the opening, then the slab", () => {
    const items = itemsOf(DATA, null);
    expect(itemsAt(items, [4, 1], 0.05).map((item) => item.kind)).toEqual(["column", "load", "slab"]);
    expect(itemsAt(items, [1, 1], 0.05).map((item) => item.kind)).toEqual(["opening", "slab"]);
    expect(itemsAt(items, [5, 3], 0.05)).toEqual([]);
  });

  it("takes what cannot be read here from the server's plan", () => {
    const odd: Table = {
      plate: { length_x: "1 furlong", length_y: "2 m" },
      columns: [{ name: "A", x: "1 rod", y: "0 m" }],
    };
    const plan: Table = {
      outline: [
        [-1, -1],
        [1, -1],
        [1, 1],
      ],
      columns: [{ path: "columns[1]", x: 5.03, y: 0 }],
    };
    expect(itemsOf(odd, plan).map((item) => item.geometry.type)).toEqual(["fixed", "point"]);
    expect(itemsOf(odd, null)).toEqual([]);
  });
});
