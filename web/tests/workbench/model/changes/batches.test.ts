import { describe, expect, it } from "vitest";

import { joinEdits } from "../../../../src/workbench/model/changes/batches";
import { applyOptimistic } from "../../../../src/workbench/model/changes/optimistic-edits";
import type { Edit } from "../../../../src/workbench/model/edits";
import type { Table } from "../../../../src/workbench/model/paths";
import { DATA } from "../../slab";

describe("many edits of a list", () => {
  const add = (name: string): Edit => ({ op: "add", path: ["columns"], value: { name } });
  const many: Edit[] = [...["B", "C", "D"].map(add), { op: "set", path: ["columns", 0, "x"], value: "1 m" }];
  const opening: Edit = { op: "remove", path: ["plate", "openings", 0] };

  it("are one, with the same result; those of others stay", () => {
    const { edits } = joinEdits(DATA, { edits: [...many, opening], text: "" });
    expect(edits.map((edit) => edit.op)).toEqual(["set", "remove"]);
    const apply = (all: readonly Edit[]) => all.reduce<Table>(applyOptimistic, DATA);
    expect(apply(edits)).toEqual(apply([...many, opening]));
  });
  it("stay if they are few, or move and remove items", () => {
    for (const edits of [many.slice(0, 3), [...many, { op: "remove", path: ["columns", 0] } as const]]) {
      const change = { edits, text: "" };
      expect(joinEdits(DATA, change)).toBe(change);
    }
  });
  it("that remove items are one for each run of them", () => {
    const data: Table = { loads: "abcdefgh".split("").map((name) => ({ name })) };
    const remove = (positions: number[]) => positions.map((n): Edit => ({ op: "remove", path: ["loads", n] }));
    const apply = (all: readonly Edit[]) => all.reduce<Table>(applyOptimistic, data);
    const some = remove([6, 5, 4, 1]);
    const { edits } = joinEdits(data, { edits: some, text: "" });
    expect(edits.map((edit) => edit.op)).toEqual(["set", "set"]);
    expect(apply(edits)).toEqual(apply(some));
    const all = joinEdits(data, { edits: remove([7, 6, 5, 4, 3, 2, 1, 0]), text: "" });
    expect(all.edits).toEqual([{ op: "remove", path: ["loads"] }]);
  });
});
