import { describe, expect, it } from "vitest";

import { itemsOf } from "../../../../src/workbench/model/items";
import { intersection, snapPlaces } from "../../../../src/workbench/plan/interaction/snap-places";
import { DATA } from "../../slab";

describe("places to snap to", () => {
  const items = itemsOf(DATA, null);
  const named = (at: [number, number], without: (string | number)[][] = []) =>
    snapPlaces(items, without)
      .filter((place) => place.at[0] === at[0] && place.at[1] === at[1])
      .map(({ name }) => name);
  it("are corners, middles, centers and columns, with their names", () => {
    expect(named([6, 2])[0]).toBe("corner");
    expect(named([3, 0])).toEqual(["middle"]);
    expect(named([1, 1])).toEqual(["center"]);
    expect([named([1.25, 1]), named([1, 0.75])]).toEqual([["quadrant"], ["quadrant"]]);
    expect(named([4, 1])).toEqual(["column A1", "point load 1"]);
    expect(
      named(
        [4, 1],
        [
          ["columns", 0],
          ["loads", 0],
        ],
      ),
    ).toEqual([]);
  });
  it("are intersections of edges that cross", () => {
    expect(
      intersection(
        [
          [0, 0],
          [4, 2],
        ],
        [
          [2, -1],
          [2, 5],
        ],
      ),
    ).toEqual([2, 1]);
    expect(
      intersection(
        [
          [0, 0],
          [4, 2],
        ],
        [
          [5, -1],
          [5, 5],
        ],
      ),
    ).toBeNull();
    expect(
      intersection(
        [
          [0, 0],
          [4, 2],
        ],
        [
          [0, 1],
          [4, 3],
        ],
      ),
    ).toBeNull();
  });
});
