// Changes of load cases: each one step, after which nothing calls what is gone.
import { expect, test } from "vitest";
import {
  addCombination,
  CASE_TYPES,
  type CaseSums,
  caseOf,
  hasSelfWeight,
  lacksVariable,
  meaningOf,
  moveCase,
  notesOn,
  removeCase,
  retypeCase,
  setExpression,
  setFactor,
  setSelfWeight,
  typeOf,
} from "../../../src/workbench/model/changes/load-cases";
import { applyOptimistic } from "../../../src/workbench/model/changes/optimistic-edits";
import { renameReferences } from "../../../src/workbench/model/changes/references";
import type { Change } from "../../../src/workbench/model/edits";
import type { Table } from "../../../src/workbench/model/paths";
import { schema } from "../schema";

const DATA: Table = {
  cases: [
    { name: "G" },
    { name: "Q", action: "variable", category: "B" },
    { name: "W", action: "variable", psi_0: 0.6 },
  ],
  loads: [
    { kind: "self weight", unit_weight: "25 kN/m^3", case: "G" },
    { kind: "point", P: "1 kN", case: "Q" },
  ],
  moves: [{ pattern: "truck", case: "Q" }],
  combinations: [
    { name: "1", factors: { G: 1.35, Q: 1.5 } },
    { name: "2", factors: { Q: 1 } },
  ],
  reactions: { cases: [{ table: "LL", case: "Q" }] },
};
const after = (change: Change, data = DATA) => change.edits.reduce(applyOptimistic, data);

test("a new name is that of loads, moves, factors and imported reactions, too", () => {
  const edits = renameReferences(DATA, ["cases", 1, "name"], "live");
  const text = JSON.stringify(after({ edits, text: "" }));
  expect(text.match(/"live"/g)).toHaveLength(5);
  expect(text).toContain('"name":"Q"'); // of the case itself, which the field sets
});

test("all types are those of the schema, and a case has the type that it was given", () => {
  const [actions, categories] = ["action", "category"].map((key) => {
    const node = schema.part("LoadCase").fields.find(({ name }) => name === key)!.node;
    return node.is === "choice" ? [...node.options] : [];
  });
  expect(CASE_TYPES.map(({ id }) => id).sort()).toEqual([...actions!, ...categories!].sort());
  for (const { id } of CASE_TYPES) expect(typeOf(caseOf(id))).toBe(id);
});

test("another type takes the psi of the type before away", () => {
  expect(after(retypeCase(DATA, 2, "wind")).cases).toEqual([
    ...(DATA.cases as Table[]).slice(0, 2),
    { name: "W", action: "variable", category: "wind" },
  ]);
  expect((after(retypeCase(DATA, 1, "accidental")).cases as Table[])[1]).toEqual({ name: "Q", action: "accidental" });
});

test("what a type means follows the code of the combinations", () => {
  const psi = { permanent: [1.35, 1], variable: [1.5, 0], psi: { B: [0.7, 0.5, 0.3], variable: [0.6, 0.4, 0.2] } };
  expect(meaningOf("permanent", {}, psi)).toContain("1.35 where unfavorable, 1 ");
  expect(meaningOf("variable", {}, psi)).toContain("factor 1.5; ψ0 0.6, ψ1 0.4, ψ2 0.2");
  expect(meaningOf("permanent", {})).toContain("factor – where"); // before the server has told them
  expect(meaningOf("permanent", { combine: { permanent: [1.2, 0.9] } })).toContain("factor 1.2 where unfavorable, 0.9");
  expect(meaningOf("B", { combine: { variable: [1.6, 0] } }, psi)).toContain("factor 1.6; ψ0 0.7, ψ1 0.5, ψ2 0.3");
  expect(meaningOf("variable", {}, psi, { psi_2: 0.8 })).toContain("ψ2 0.8");
  expect(meaningOf("wind", { combine: { expression: "ACI 318" } })).toContain("ASCE 7");
});

test("a case goes with its loads, or these to another one; combinations that name no other go, too", () => {
  const without = after(removeCase(DATA, 1, null));
  expect(JSON.stringify(without)).not.toContain('"Q"');
  expect(without.loads).toHaveLength(1);
  expect(without.combinations).toEqual([{ name: "1", factors: { G: 1.35 } }]);
  const kept = after(removeCase(DATA, 1, "G"));
  expect((kept.loads as Table[]).map((load) => load.case)).toEqual(["G", "G"]);
  expect((kept.moves as Table[])[0]!.case).toBe("G");
});

test("with the last case its combinations go, and loads may stay without one", () => {
  const one: Table = {
    cases: [{ name: "G" }],
    loads: [{ kind: "uniform", case: "G" }],
    combine: { sets: ["ultimate"] },
  };
  expect(after(removeCase(one, 0, ""), one)).toEqual({ loads: [{ kind: "uniform" }] });
});

test("a case moves by its position", () => {
  const names = (data: Table) => (data.cases as Table[]).map(({ name }) => name);
  expect(names(after(moveCase(DATA, 2, 0)!))).toEqual(["W", "G", "Q"]);
  expect(names(after(moveCase(DATA, 0, 1)!))).toEqual(["Q", "G", "W"]);
  expect([moveCase(DATA, 0, -1), moveCase(DATA, 2, 3), moveCase(DATA, 1, 1)]).toEqual([null, null, null]);
});

test("self-weight acts in one case", () => {
  const moved = after(setSelfWeight(DATA, "W", true));
  expect([hasSelfWeight(moved, "W"), hasSelfWeight(moved, "G")]).toEqual([true, false]);
  const gone = after(setSelfWeight(DATA, "G", false));
  expect(gone.loads).toEqual([(DATA.loads as Table[])[1]]);
  expect(hasSelfWeight(after(setSelfWeight(gone, "G", true), gone), "G")).toBe(true);
});

test("factors are set and taken away; a new combination has a name of its own and all cases", () => {
  expect((after(setFactor(DATA, 0, "W", 0.9)).combinations as Table[])[0]!.factors).toEqual({
    G: 1.35,
    Q: 1.5,
    W: 0.9,
  });
  expect((after(setFactor(DATA, 0, "G", 0)).combinations as Table[])[0]!.factors).toEqual({ Q: 1.5 });
  const added = after(addCombination(DATA, ["C1"], "frequent")).combinations as Table[];
  expect(added[2]).toEqual({ name: "C2", limit_state: "frequent", factors: { G: 1, Q: 1, W: 1 } });
});

test("how combinations are made is chosen; keys that ACI 318 has not go", () => {
  const made = after(setExpression(DATA, "6.10"));
  expect(made.combine).toEqual({ sets: ["ultimate", "characteristic", "quasi-permanent"], expression: "6.10" });
  const own: Table = { combine: { sets: ["ultimate"], xi: 0.9 } };
  expect(after(setExpression(own, "ACI 318"), own)).toEqual({ combine: { sets: ["ultimate"], expression: "ACI 318" } });
  expect(after(setExpression(own, ""), own)).toEqual({});
});

test("what acts nowhere is told: cases without loads or combinations, loads with issues or remarks", () => {
  const sums = { cases: [{ name: "Q", F: 1, M_x: 0, M_y: 0, acts: false }] } as unknown as CaseSums;
  const issue = { location: "loads[2].x", path: ["loads", 1, "x"], found: "9 m", expected: "a place", hint: "" };
  const remark = { location: "loads[2]", path: ["loads", 1], words: "It is off the plate.", doubtful: false };
  const notes = (n: number) => notesOn(DATA, n, sums, [issue], [remark]);
  const words = (n: number) => notes(n).map((note) => note.words);
  expect(words(0)).toEqual([]);
  expect(words(1)).toEqual([
    "This case acts in no combination.",
    "loads[2].x: Found 9 m, expected a place.",
    "It is off the plate.",
  ]);
  expect(notes(1).map(({ kind }) => kind)).toEqual(["bad", "bad", "remark"]);
  expect(notes(2)).toEqual([{ words: expect.stringContaining("No loads yet"), own: true, kind: "invitation" }]);
  expect([lacksVariable(DATA), lacksVariable({ cases: [{ name: "G" }] }), lacksVariable({})]).toEqual([
    false,
    true,
    false,
  ]);
});

test("the types are the actions and the categories of the schema", () => {
  const fields = schema.part("LoadCase").fields;
  const options = (name: string) => {
    const node = fields.find((field) => field.name === name)?.node;
    return node?.is === "choice" ? node.options : [];
  };
  const all = [...options("action"), ...options("category")];
  expect(CASE_TYPES.map(({ id }) => id).toSorted()).toEqual(all.toSorted());
  for (const type of options("action")) expect(caseOf(type)).toEqual({ action: type });
  for (const type of options("category")) expect(caseOf(type)).toEqual({ action: "variable", category: type });
});
