// Doors of walls in the plan of the editor.
import { describe, expect, it } from "vitest";
import { piecesOf } from "../../../src/workbench/model/doors";
import { itemsOf } from "../../../src/workbench/model/items";
import type { Table } from "../../../src/workbench/model/paths";

const WALL: Table = {
  name: "W",
  points: [
    ["0 m", "0 m"],
    ["4 m", "0 m"],
    ["4 m", "3 m"],
  ],
  openings: [
    { start: "5 m", end: "6 m", height: "2.1 m" },
    { start: "1 m", end: "2 m", height: "2.1 m" },
  ],
};
const PIECES = [
  [
    [0, 0],
    [1, 0],
  ],
  [
    [2, 0],
    [4, 0],
    [4, 1],
  ],
  [
    [4, 2],
    [4, 3],
  ],
];

describe("doors of a wall", () => {
  it("leave its pieces, whatever their order, to the wall and to the loads on it", () => {
    const data: Table = { walls: [WALL], loads: [{ kind: "line", q: "20 kN/m", wall: "W" }] };
    expect(itemsOf(data, null).map(({ pieces }) => pieces)).toEqual([PIECES, PIECES]);
  });

  it("are openings of walls without a height", () => {
    expect(itemsOf({ walls: [{ ...WALL, height: "3 m" }] }, null).map(({ pieces }) => pieces)).toEqual([undefined]);
    expect(itemsOf({ walls: [{ ...WALL, openings: [{}] }] }, null)[0]?.pieces).toBeUndefined();
  });

  it("part closed walls, too", () => {
    const square = { type: "polygon", at: [], points: [[0, 0], [2, 0], [2, 2], [0, 2]], bulges: [] } as const; // biome-ignore format: one line
    const openings = [{ start: "6.5 m", end: "7.5 m", height: "2 m" }];
    expect(piecesOf({ openings }, square as never)?.map((piece) => [piece[0], piece.at(-1)])).toEqual([
      [
        [0, 0],
        [0, 1.5],
      ],
      [
        [0, 0.5],
        [0, 0],
      ],
    ]);
  });
});

describe("loads of a core", () => {
  it("are drawn along its walls as the server knows them, and go with these", () => {
    const points = [
      [0, 0],
      [4, 0],
    ];
    const data: Table = { cores: [{ name: "K", walls: ["W"] }], loads: [{ kind: "core", core: "K", P: "1 MN" }] };
    const [load] = itemsOf(data, { loads: [{ path: "loads[1]", points, pieces: PIECES }] });
    expect(load).toMatchObject({ kind: "load", movable: false, pieces: PIECES, geometry: { points } });
    expect(itemsOf(data, null)).toEqual([]);
  });
});
