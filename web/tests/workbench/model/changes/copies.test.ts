import { describe, expect, it } from "vitest";

import { addCopies, tablesAt, transformItems, whyNotCopied } from "../../../../src/workbench/model/changes/copies";
import { applyOptimistic } from "../../../../src/workbench/model/changes/optimistic-edits";
import { removeItems } from "../../../../src/workbench/model/changes/references";
import { rotation, translation } from "../../../../src/workbench/model/isometry";
import { countItems, itemsOf } from "../../../../src/workbench/model/items";
import type { Table } from "../../../../src/workbench/model/paths";
import { platesAt } from "../../../../src/workbench/model/plates";
import { itemsInBand } from "../../../../src/workbench/plan/interaction/rubber-band";
import { DATA } from "../../slab";

const apply = (edits: Parameters<typeof applyOptimistic>[1][]) => edits.reduce<Table>(applyOptimistic, DATA);

describe("copies", () => {
  const both = tablesAt(DATA, [
    ["columns", 0],
    ["loads", 0],
  ]);
  it("have free names, and their loads stand on the copied columns", () => {
    const { change, paths } = addCopies(DATA, both, [translation([1, 0]), translation([2, 0])], "array");
    const data = apply(change.edits);
    expect((data.columns as Table[]).map(({ name, x }) => [name, x])).toEqual([
      ["A1", "4 m"],
      ["A2", "5 m"],
      ["A3", "6 m"],
    ]);
    expect((data.loads as Table[]).map(({ column }) => column)).toEqual(["A1", undefined, "A2", "A3"]);
    expect(paths).toEqual([
      ["columns", 1],
      ["loads", 2],
      ["columns", 2],
      ["loads", 3],
    ]);
  });
  it("of a load alone would stand on the same column", () => {
    expect(whyNotCopied(both)).toBe("");
    expect(whyNotCopied(tablesAt(DATA, [["loads", 0]]))).toContain("column A1, which is not selected");
    expect(whyNotCopied(tablesAt(DATA, [["loads", 1]]))).toContain("no");
  });
});

describe("several items", () => {
  it("are turned in one change that names the one which cannot be", () => {
    const paths = [
      ["plate", "openings", 0],
      ["columns", 0],
    ];
    const { edits } = transformItems(DATA, paths, rotation(90, [0, 0]), "rotate");
    expect(apply(edits)).toMatchObject({
      plate: { openings: [{ centre: ["-1 m", "1 m"] }] },
      columns: [{ x: "-1 m", y: "4 m" }],
    });
    const data = { ...DATA, columns: [{ name: "A1", x: "4 m", y: "far" }] };
    expect(() => transformItems(data, paths, rotation(30, [0, 0]), "rotate")).toThrow(
      'column A1: ["4 m","far"] is not a point',
    );
  });
  it("are removed with the loads on them, each once, the last first", () => {
    const { edits, text } = removeItems(DATA, [
      ["columns", 0],
      ["loads", 0],
      ["plate", "openings", 0],
    ]);
    expect(apply(edits)).toMatchObject({ plate: { openings: [] }, columns: [], loads: [{ kind: "uniform" }] });
    expect(edits).toHaveLength(3);
    expect(text).toBe("remove 1 column, 1 load, 1 opening");
    expect(
      removeItems(DATA, [
        ["loads", 0],
        ["loads", 1],
      ]).edits.map((edit) => "path" in edit && edit.path[1]),
    ).toEqual([1, 0]);
  });
});

describe("a further plate", () => {
  const outline = { kind: "rectangle", x: ["6 m", "9 m"], y: ["-1 m", "1 m"] };
  const data = {
    ...DATA,
    plate: { ...(DATA.plate as Table), name: "A" },
    plates: [{ name: "B", outline }],
    joints: [{ kind: "hinge", between: ["A", "B"] }],
  };
  it("is joined along the line that it shares with the slab", () => {
    const joint = itemsOf(data, null).find(({ kind }) => kind === "joint");
    expect(joint?.geometry).toMatchObject({
      points: [
        [6, 0],
        [6, 1],
      ],
      closed: false,
    });
    expect(platesAt(data, [6.1, 0.5], 0.2)).toEqual(["A", "B"]);
    expect(platesAt(data, [6.1, 1.5], 0.2)).toBeNull();
  });
  it("is removed with its joint", () => {
    const { edits, text } = removeItems(data, [["plates", 0]]);
    expect(edits.reduce<Table>(applyOptimistic, data)).toMatchObject({ plates: [], joints: [] });
    expect(text).toBe("remove plate B and its joint");
  });
});

describe("a rubber band", () => {
  const items = itemsOf(DATA, null);
  const titles = (from: [number, number], to: [number, number]) =>
    countItems(itemsInBand(items, from, to).map((item) => ({ kind: item.kind, title: item.title })));
  it("selects what it encloses from left to right, what it touches from right to left", () => {
    expect(titles([0.7, 0.7], [4.3, 1.3])).toBe("1 opening, 1 column, 1 load");
    expect(titles([0.7, 0.7], [1.1, 1.3])).toBe("");
    expect(titles([1.1, 1.3], [0.7, 0.7])).toBe("opening 1");
    // inside a surface it touches nothing
    expect(titles([1.1, 1.1], [0.9, 0.9])).toBe("");
    // across an edge without a corner inside
    expect(titles([3.9, 2], [3.85, 0])).toBe("column A1");
  });
});
