import { describe, expect, it } from "vitest";
import {
  type Axis,
  axesIn,
  countOn,
  crossingOf,
  crossingsOf,
  nameOfCrossing,
  parseDistances,
} from "../../../src/workbench/model/axes";
import { attach, axisEdits, detach, formatDistances } from "../../../src/workbench/model/changes/attachment";
import { addPoint } from "../../../src/workbench/model/changes/new-items";
import { applyOptimistic } from "../../../src/workbench/model/changes/optimistic-edits";
import { itemsOf } from "../../../src/workbench/model/items";
import { takenNames } from "../../../src/workbench/model/names";
import { listAt, type Table } from "../../../src/workbench/model/paths";
import { moveChange } from "../../../src/workbench/plan/interaction/gestures";

const GRID: Table[] = [
  { kind: "straight", first: "A", distances: "2 x 6 m, 4500 mm" },
  { kind: "straight", first: "1", distances: "5 m", angle: 90 },
];
const DATA: Table = {
  axes: GRID,
  columns: [{ name: "C1", at: "B/2", width_x: "400 mm", width_y: "400 mm" }],
  loads: [
    { kind: "point", column: "C1", P: "1 kN" },
    { kind: "line", q: "1 kN/m", at: ["A/1", "D/1"] },
  ],
};

const columnOf = (data: Table) => itemsOf(data, null).find(({ kind }) => kind === "column")!;
const axisOf = (data: Table, name: string): Axis => axesIn(data).find((axis) => axis.name === name)!;

describe("axes", () => {
  it("are counted on by letters and numbers", () => {
    expect(countOn("Y", 3)).toEqual(["Y", "Z", "AA"]);
    expect(countOn("9", 2)).toEqual(["9", "10"]);
  });
  it("have distances as people write them", () => {
    expect(parseDistances("2 x 6 m, 4500 mm")).toEqual([6, 6, 4.5]);
    expect(parseDistances("2 x 6")).toBeNull();
    expect(formatDistances([6, 6, 4.5])).toBe("2 x 6 m, 4.5 m");
  });
  it("cross where geometry says, rays and rings once, straight axes and rings not at one place", () => {
    const axes = axesIn({
      axes: [
        { kind: "ray", first: "1", centre: ["1 m", "1 m"], angles: [210] },
        { kind: "ring", first: "A", centre: ["1 m", "1 m"], distances: "2 m, 3 m" },
        { kind: "straight", first: "X", distances: "1 m", angle: 90 },
      ],
    });
    expect(crossingOf("B/1", axes)![0]).toBeCloseTo(1 - 5 * Math.cos(Math.PI / 6), 9);
    expect(crossingOf("B/1", axes)![1]).toBeCloseTo(-1.5, 9);
    expect(crossingOf("A/X", axes)).toBeNull();
    expect(crossingOf("1/nothing", axes)).toBeNull();
  });
  it("name the places where they cross", () => {
    expect(nameOfCrossing([6, 5], axesIn(DATA))).toBe("B/2");
    expect(nameOfCrossing([6, 4], axesIn(DATA))).toBe("");
    expect(crossingsOf(axesIn(DATA))).toHaveLength(8);
  });
});

describe("what is attached to axes", () => {
  it("is drawn where they cross, with what is on it", () => {
    const items = itemsOf(DATA, null);
    expect(items.map(({ geometry }) => geometry)).toMatchObject([
      { type: "point", x: 6, y: 5 },
      { type: "point", x: 6, y: 5 },
      {
        type: "line",
        points: [
          [0, 0],
          [16.5, 0],
        ],
      },
    ]);
  });
  it("follows an axis that is moved, while the others stay", () => {
    const edits = axisEdits(DATA, axisOf(DATA, "B"), 0.5)!;
    expect(edits).toEqual([{ op: "set", path: ["axes", 0, "distances"], value: "6.5 m, 5.5 m, 4.5 m" }]);
    expect(columnOf(edits.reduce(applyOptimistic, DATA)).geometry).toMatchObject({ x: 6.5, y: 5 });
  });
  it("stays if the first axis moves, which takes the origin along", () => {
    const after = axisEdits(DATA, axisOf(DATA, "1"), -1)!.reduce(applyOptimistic, DATA);
    expect(listAt(after, ["axes"])[1]).toMatchObject({ distances: "6 m", origin: ["0 m", "-1 m"] });
    expect(columnOf(after).geometry).toMatchObject({ x: 6, y: 5 });
  });
  it("cannot be moved through a neighbor", () => expect(axisEdits(DATA, axisOf(DATA, "B"), 6)).toBeNull());
  it("is detached where it is moved off, and attached to axes that it comes to", () => {
    const move = (x: number, y: number) =>
      moveChange([columnOf(DATA)], [x, y], axesIn(DATA)).edits.reduce(applyOptimistic, DATA);
    expect(listAt(move(1, 0), ["columns"])[0]).toEqual({
      name: "C1",
      x: "7 m",
      y: "5 m",
      width_x: "400 mm",
      width_y: "400 mm",
    });
    expect(listAt(move(6, -5), ["columns"])[0]).toMatchObject({ at: "C/1" });
  });
  it("is of lists and kinds that may", () => {
    const axes = axesIn(DATA);
    expect(attach({ kind: "point", x: "0 m", y: "5 m" }, "supports", axes)).toEqual({ kind: "point", at: "A/2" });
    expect(
      attach(
        {
          name: "W",
          points: [
            ["0 m", "0 m"],
            ["0 m", "5 m"],
          ],
        },
        "walls",
        axes,
      ),
    ).toEqual({
      name: "W",
      at: ["A/1", "A/2"],
    });
    const borehole = { name: "BH1", x: "0 m", y: "5 m" };
    expect(attach(borehole, "boreholes", axes)).toBe(borehole);
    expect(detach({ kind: "line", at: ["A/1", "A/2"] }, axes)).toEqual({
      kind: "line",
      points: [
        ["0 m", "0 m"],
        ["0 m", "5 m"],
      ],
    });
  });
  it("is called by its axes, and boreholes are not called as columns are", () => {
    expect(addPoint("column", DATA, [12, 0], "").change.edits[0]).toMatchObject({ value: { name: "C2", at: "C/1" } });
    expect(addPoint("column", DATA, [0, 5], "").change.edits[0]).toMatchObject({ value: { name: "A2", at: "A/2" } });
    expect(addPoint("borehole", DATA, [0, 5], "").change.edits[0]).toMatchObject({ value: { name: "BH1" } });
    const named: Table = { ...DATA, columns: [{ name: "BH1" }], boreholes: [{ name: "A2" }] };
    expect(addPoint("borehole", named, [0, 5], "").change.edits[0]).toMatchObject({ value: { name: "BH2" } });
    expect(addPoint("column", named, [0, 5], "").change.edits[0]).toMatchObject({ value: { name: "C1" } });
    expect(takenNames(named, ["walls"])).toEqual([]);
  });
});
