import { describe, expect, it } from "vitest";
import type { ResultTable, TableHead } from "../../../src/workbench/client/api";
import { formatPath, parsePath } from "../../../src/workbench/model/paths";
import { arrangeRows, targetOf, toTabSeparated } from "../../../src/workbench/result/table-rows";

const head = (text: string, more: Partial<TableHead> = {}): TableHead => ({
  text,
  unit: "",
  number: false,
  symbol: "",
  place: null,
  combination: null,
  field: null,
  ...more,
});
const at: Partial<TableHead> = { place: [2, 3], combination: 0 };
const TABLE: ResultTable = {
  name: "columns",
  title: "Columns",
  heads: [
    head("combination", at),
    head("column", at),
    head("x", { unit: "m", number: true, ...at }),
    head("y", { unit: "m", number: true, ...at }),
    head("load", { unit: "kN", number: true, ...at, field: "pressure" }),
  ],
  rows: [
    ["ULS 10", "A1", "-2.5", "1", ["90.0", "±1 %", "number"]],
    ["ULS 9", "B1", "", "", "1.2e+03"],
    ["ULS 9", "B2", "0", "0", ""],
    ["ULS 10", "B3", "1", "1", "-inf\t"],
  ],
  fields: null,
  item: { list: "columns", column: 1 },
  notes: [],
};

describe("rows", () => {
  it("are sorted by number, with empty cells last both ways, and by words with their numbers", () => {
    expect(arrangeRows(TABLE, "", { column: 4, descending: false }).slice(-1)).toEqual([2]);
    expect(arrangeRows(TABLE, "", { column: 4, descending: true }).slice(-1)).toEqual([2]);
    const sorted = arrangeRows({ ...TABLE, rows: TABLE.rows.slice(0, 3) }, "", { column: 4, descending: true });
    expect(sorted).toEqual([1, 0, 2]);
    expect(arrangeRows(TABLE, "", { column: 0, descending: false })).toEqual([1, 2, 0, 3]);
  });

  it("are filtered by all words", () => {
    expect(arrangeRows(TABLE, "uls b", null)).toEqual([1, 2, 3]);
    expect(arrangeRows(TABLE, " B1 9", null)).toEqual([1]);
    expect(arrangeRows(TABLE, "none", null)).toEqual([]);
  });

  it("are copied with their heads, without tabs in cells", () => {
    expect(toTabSeparated(TABLE, [0, 3])).toBe(
      "combination\tcolumn\tx [m]\ty [m]\tload [kN]\nULS 10\tA1\t-2.5\t1\t90.0\nULS 10\tB3\t1\t1\t-inf ",
    );
  });

  it("lead to a place, a combination, a field and an item", () => {
    const item = { list: "columns", name: "A1" };
    expect(targetOf(TABLE, 0, 4)).toEqual({ place: [-2.5, 1], combination: "ULS 10", field: "pressure", item });
    expect(targetOf(TABLE, 1, 0)).toMatchObject({ place: null, combination: "ULS 9", field: null });
    expect(targetOf({ ...TABLE, fields: ["gap", null, null, null] }, 0, 0).field).toBe("gap");
  });
});

describe("paths", () => {
  it("are read as they are written", () => {
    for (const path of [
      ["columns", 0],
      ["output", "strips", 11],
      ["plate", "zones", 1, "shape"],
    ])
      expect(parsePath(formatPath(path))).toEqual(path);
  });
});
