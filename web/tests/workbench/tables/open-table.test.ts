import { describe, expect, it } from "vitest";
import type { FormContext } from "../../../src/workbench/form/context";
import { applyOptimistic } from "../../../src/workbench/model/changes/optimistic-edits";
import type { Change } from "../../../src/workbench/model/edits";
import type { Issue } from "../../../src/workbench/model/issues";
import { type Json, listAt, type Table } from "../../../src/workbench/model/paths";
import { duplicateRows, emptyCells } from "../../../src/workbench/tables/changes";
import { headText } from "../../../src/workbench/tables/columns";
import { OpenTable } from "../../../src/workbench/tables/open-table";
import { sheetAt, sheetsOf } from "../../../src/workbench/tables/sheets";
import { makeIssue } from "../form-page";
import { schema } from "../schema";

const DATA: Table = {
  columns: [
    { name: "A", x: "1 m", y: "2 m", width_x: "400 mm", width_y: "400 mm" },
    { name: "B", x: "3 m", y: "2 m", diameter: "50 cm" },
  ],
  cases: [{ name: "G" }, { name: "Q", action: "variable" }],
  loads: [
    { kind: "point", column: "A", P: "100 kN", case: "G" },
    { kind: "uniform", q: "5 kPa", case: "Q" },
    { kind: "point", column: "B", P: "0.2 MN", case: "G" },
  ],
  combinations: [{ name: "1", factors: { G: 1.35 } }],
};

const openTable = (id: string, data: Table = DATA, issues: Issue[] = [], all = false) => {
  const ctx: FormContext = {
    schema,
    memory: new Map(),
    data: () => data,
    issues: () => issues,
    change: () => undefined,
  };
  return new OpenTable(ctx, sheetsOf(schema).find((sheet) => sheet.id === id)!, all);
};
const columnOf = (table: OpenTable, key: string) => table.columns.findIndex((column) => column.path.join(".") === key);
const at = (row: number, column: number) => ({ top: row, bottom: row, left: column, right: column });
const apply = (change: Change | null, data: Table = DATA) => (change?.edits ?? []).reduce<Table>(applyOptimistic, data);
const type = (id: string, row: number, key: string, text: string, data: Table = DATA): Json[] => {
  const table = openTable(id, data);
  return listAt(apply(table.type({ row, column: columnOf(table, key) }, text), data), [table.sheet.list]);
};

describe("tables", () => {
  it("are one for each list, and for each kind in it", () => {
    const titles = sheetsOf(schema).map(({ title }) => title);
    expect(titles).toEqual(
      expect.arrayContaining(["Columns", "point loads", "Load cases", "pile supports", "Boreholes"]),
    );
    expect(openTable("loads point").positions).toEqual([0, 2]);
    expect(sheetAt(sheetsOf(schema), DATA, ["loads", 1, "q"])?.id).toBe("loads uniform");
    expect(sheetAt(sheetsOf(schema), DATA, ["plate"])).toBeNull();
  });
  it("have a column for each load case, and hide rare columns that no row uses", () => {
    expect(openTable("combinations").columns.map(headText)).toEqual(["name", "limit state", "G", "Q", "rule"]);
    const patch: Table = { loads: [{ kind: "patch", q: "1 kPa", x: ["0 m", "1 m"], y: ["0 m", "1 m"] }] };
    expect(columnOf(openTable("loads patch", patch), "slope.0")).toBe(-1);
    expect(columnOf(openTable("loads patch", patch, [], true), "slope.0")).toBeGreaterThan(0);
    expect(openTable("loads patch", patch).hasHidden).toBe(true);
  });
});

describe("what is typed into a cell", () => {
  it("takes the unit of the value before, else the one of the column, and none if the column has several", () => {
    expect(type("columns", 0, "width_x", "300")[0]).toMatchObject({ width_x: "300 mm" });
    expect(type("columns", 1, "width_x", "0,3")[1]).toMatchObject({ width_x: "0.3 mm" });
    expect(type("columns", 1, "width_x", "0,3 m")[1]).toMatchObject({ width_x: "0.3 m" });
    expect(type("loads point", 2, "P", "50")[3]).toEqual({ kind: "point", P: "50" });
    expect(type("loads point", 1, "P", "50")[2]).toMatchObject({ P: "50 MN" });
  });
  it("adds an item in the row below the last one, with its kind and a name if it needs one", () => {
    expect(type("loads point", 2, "column", "A")[3]).toEqual({ kind: "point", column: "A" });
    expect(type("columns", 2, "x", "5")[2]).toEqual({ name: "C1", x: "5 m" });
  });
  it("takes options in any case, and keeps what is none", () => {
    expect(type("cases", 0, "action", "Variable")[0]).toMatchObject({ action: "variable" });
    expect(type("cases", 0, "action", "live")[0]).toMatchObject({ action: "live" });
    expect(type("cases", 0, "psi_0", "0,6")[0]).toMatchObject({ psi_0: 0.6 });
  });
  it("renames with all who call the name, and is called as in the form", () => {
    const table = openTable("columns");
    const change = table.type({ row: 0, column: columnOf(table, "name") }, "A1");
    expect(change?.text).toBe("change name of column A");
    expect(table.type({ row: 0, column: columnOf(table, "width_x") }, "1 m")?.text).toBe("change width x of column A");
    expect(listAt(apply(change), ["loads"])[0]).toMatchObject({ column: "A1" });
  });
  it("fills lists of fixed length, points and factors, and removes them when they are empty", () => {
    expect(type("combinations", 0, "factors.Q", "1,5")[0]).toEqual({ name: "1", factors: { G: 1.35, Q: 1.5 } });
    expect(type("combinations", 0, "factors.G", "")[0]).toEqual({ name: "1" });
    const lines: Table = { loads: [{ kind: "line", q: "1 kN/m", points: [["0 m", "1 m"]] }] };
    expect(type("loads line", 0, "points.1.0", "4", lines)[0]).toMatchObject({
      points: [
        ["0 m", "1 m"],
        ["4 m", ""],
      ],
    });
    const half: Table = { loads: [{ kind: "patch", x: ["1 m", ""] }] };
    expect(type("loads patch", 0, "x.0", "", half)[0]).toEqual({ kind: "patch" });
  });
  it("changes nothing where it is what was there", () => {
    const table = openTable("columns");
    expect(table.type({ row: 0, column: columnOf(table, "x") }, "1 m")).toBeNull();
  });
});

describe("a paste", () => {
  it("is one change: it fills rows from the cell on, and adds those beyond the last", () => {
    const table = openTable("columns");
    const { change, left, block } = table.paste("5\t6\n7\t8\n9;5\t10 cm", at(1, columnOf(table, "x")));
    const columns = listAt(apply(change), ["columns"]);
    expect(columns[1]).toMatchObject({ name: "B", x: "5 m", y: "6 m" });
    expect(columns.slice(2)).toEqual([
      { name: "C1", x: "7 m", y: "8 m" },
      { name: "C2", x: "9;5", y: "10 cm" },
    ]);
    expect(left).toEqual([]);
    expect(block).toEqual({ top: 1, bottom: 3, left: 1, right: 2 });
  });
  it("with a head goes by its names and units, wherever the cell is; names are taken literally", () => {
    const table = openTable("columns");
    const text = "width x [cm]\tname\tremark\n25\tB\tx\n30\tA\tx";
    const { change, left } = table.paste(text, at(0, 3));
    const after = apply(change);
    expect(listAt(after, ["columns"])).toMatchObject([
      { name: "B", x: "1 m", width_x: "25 cm" },
      { name: "A", x: "3 m", width_x: "30 cm" },
    ]);
    expect(listAt(after, ["loads"])).toEqual(DATA.loads);
    expect(left).toEqual(["remark"]);
  });
  it("takes a value away where its cell is empty, so that none of before stays unseen", () => {
    const table = openTable("columns");
    const { change } = table.paste("\t3", at(0, columnOf(table, "x")));
    expect(listAt(apply(change), ["columns"])[0]).not.toHaveProperty("x");
  });
  it("of a single value fills the block", () => {
    const table = openTable("loads point");
    const column = columnOf(table, "case");
    const { change } = table.paste("Q\n", { top: 0, bottom: 1, left: column, right: column });
    expect(listAt(apply(change), ["loads"]).map((load) => (load as Table).case)).toEqual(["Q", "Q", "Q"]);
  });
  it("reports cells beyond the last column", () => {
    const table = openTable("columns");
    expect(table.paste("1\t2", at(0, columnOf(table, "at"))).left).toEqual(["cells beyond the last column"]);
  });
  it("of many rows is one edit of the list, and what was copied comes back", () => {
    const table = openTable("loads point", { ...DATA, loads: [] });
    const text = `column;P [kN];case\n${Array.from({ length: 50 }, (_, n) => `A;${n};G`).join("\n")}`;
    const { change } = table.paste(text, at(0, 0));
    expect(change?.edits).toHaveLength(1);
    const after = apply(change, { ...DATA, loads: [] });
    const full = openTable("loads point", after);
    expect(full.rows).toHaveLength(50);
    const again = table.paste(full.copyAll(), at(0, 0));
    expect(apply(again.change, { ...DATA, loads: [] })).toEqual(after);
  });
});

describe("rows", () => {
  it("keep what cannot be edited here, and tell how many points are not shown", () => {
    const points = Array.from({ length: 14 }, (_, n) => [`${n} m`, "0 m"]);
    const data: Table = {
      loads: [
        { kind: "line", q: "1 kN/m", points },
        { kind: "line", q: "1 kN/m", shape: { kind: "circle" } },
      ],
    };
    const table = openTable("loads line", data);
    const [last, shape] = [columnOf(table, "points.11.1"), columnOf(table, "shape")];
    expect(table.textAt({ row: 0, column: last })).toBe("0 m");
    expect(table.textAt({ row: 0, column: last + 1 })).toBe("14");
    expect(emptyCells(data, table.sheet, table.positions, [{ row: 1, column: table.columns[shape]! }])).toEqual({
      change: null,
      kept: 0,
    });
    expect(listAt(apply(table.type({ row: 0, column: last }, "7"), data), ["loads"])[0]).toMatchObject({
      points: points.with(11, ["11 m", "7 m"]),
    });
    expect(table.paste(table.copyAll(), at(2, 0)).left).toEqual(["points", "shape"]);
  });
  it("are emptied but for what is needed", () => {
    const table = openTable("columns");
    const cells = table.columns.map((column) => ({ row: 0, column }));
    const { change, kept } = emptyCells(DATA, table.sheet, table.positions, cells);
    expect(listAt(apply(change), ["columns"])[0]).toEqual({ name: "A", x: "1 m", y: "2 m" });
    expect(kept).toBe(3);
  });
  it("are duplicated with names that are free", () => {
    const change = duplicateRows(DATA, openTable("columns").sheet, [0, 1]);
    expect(listAt(apply(change), ["columns"]).slice(2)).toMatchObject([{ name: "A 2" }, { name: "B 2", x: "3 m" }]);
  });
});

describe("issues", () => {
  const issues = [makeIssue(["loads", 2, "P"]), makeIssue(["loads", 1, "q"]), makeIssue(["loads", 0])];
  it("belong to the cell of their path, and to its row", () => {
    const table = openTable("loads point", DATA, issues);
    expect(table.issuesAt({ row: 1, column: columnOf(table, "P") })).toHaveLength(1);
    expect(table.issuesAt({ row: 1, column: columnOf(table, "case") })).toEqual([]);
    expect([table.issuesOf(0).length, table.issuesOf(1).length, table.issueTotal]).toEqual([1, 1, 2]);
    expect(table.firstFaulty).toBe(0);
    expect(table.numberOf(1)).toBe(3);
  });
  it("of a list belong to all cells with its values", () => {
    const data: Table = { loads: [{ kind: "patch", x: "1 m" }] };
    const table = openTable("loads patch", data, [makeIssue(["loads", 0, "x"])]);
    expect(table.issuesAt({ row: 0, column: columnOf(table, "x.0") })).toHaveLength(1);
    expect(table.issuesAt({ row: 0, column: columnOf(table, "x.1") })).toHaveLength(1);
  });
});

describe("cells of keys that mean nothing in their row", () => {
  it("say so unless they have a value", () => {
    const cases = [{ name: "G" }, { name: "Q", action: "variable" }, { name: "A", action: "accidental", psi_0: 0.5 }];
    const table = openTable("cases", { cases }, [], true);
    const [psi, force] = [columnOf(table, "psi_0"), columnOf(table, "H_x")];
    expect([0, 1, 2, 3].map((row) => table.whyIdle({ row, column: psi }))).toEqual([
      "Only where action is variable.",
      "",
      "",
      "",
    ]);
    expect(table.whyIdle({ row: 0, column: force })).toBe("");
  });
});
