import { describe, expect, it } from "vitest";
import { columnsOf } from "../../../src/workbench/tables/columns";
import { joinCells, readBlock, splitCells, splitHead } from "../../../src/workbench/tables/pasted-text";
import { sheetsOf } from "../../../src/workbench/tables/sheets";
import { schema } from "../schema";

const columnsFor = (id: string) => columnsOf(schema, {}, sheetsOf(schema).find((sheet) => sheet.id === id)!, []);
const keysOf = (text: string, id: string, n = 0) =>
  readBlock(splitCells(text), columnsFor(id), n).columns.map((column) => column?.path.join(".") ?? null);

describe("pasted text", () => {
  it("has its cells between tabs, else between semicolons; commas are decimal ones", () => {
    expect(splitCells("1,5\t2; 3\r\n4\t5\r\n")).toEqual([
      ["1,5", "2; 3"],
      ["4", "5"],
    ]);
    expect(splitCells("a;1,5\nb;;\n\n")).toEqual([
      ["a", "1,5"],
      ["b", "", ""],
    ]);
    expect(splitCells("200")).toEqual([["200"]]);
    expect(splitCells("")).toEqual([]);
  });
  it("keeps empty rows between others, since the rows below would move up", () => {
    expect(splitCells("1\n\n3\n")).toEqual([["1"], [""], ["3"]]);
  });
  it("may quote cells with tabs, line ends and quotes", () => {
    expect(splitCells('"a\nb"\t"say ""so"""\n1\t"2"')).toEqual([
      ["a\nb", 'say "so"'],
      ["1", "2"],
    ]);
    expect(splitCells('5" pipe\t1')).toEqual([['5" pipe', "1"]]);
  });
  it("is written with tabs, and no cell holds one", () => {
    expect(
      joinCells([
        ["a\tb", "1 kN"],
        ["", "2"],
      ]),
    ).toBe("a b\t1 kN\n\t2");
  });
});

describe("a head", () => {
  it.each([
    ["P [kN]", "P", "kN"],
    ["P (kN)", "P", "kN"],
    ["q in kN/m", "q", "kN/m"],
    ["q / kN/m^2", "q", "kN/m^2"],
    ["P/kN", "P", "kN"],
    ["width x", "width x", ""],
  ])("%s has a name and a unit", (text, name, unit) => {
    expect(splitHead(text)).toEqual({ name, unit });
  });
  it("names columns by key, symbol or label, in any order; what it does not know is told", () => {
    expect(keysOf("Y\tX\tName\tc_x\twidth y\n1\t2\tA\t3\t4", "columns")).toEqual([
      "y",
      "x",
      "name",
      "width_x",
      "width_y",
    ]);
    const block = readBlock(splitCells("column;x;remark\nA1;2;best"), columnsFor("columns"), 3);
    expect(block.columns.map((column) => column?.path[0] ?? null)).toEqual(["name", "x", null]);
    expect(block.unknown).toEqual(["remark"]);
  });
  it("of loads calls the column that a load stands on, and moments by their letters", () => {
    const block = readBlock(splitCells("column\tP\tMx\tforce P\n1\t2\t3\t4"), columnsFor("loads point"), 0);
    expect(block.columns.map((column) => column?.path[0] ?? null)).toEqual(["column", "P", "M_x", null]);
    // the same column a second time
    expect(block.unknown).toEqual(["force P"]);
  });
  it("names the ends of lines and rectangles, the layers of boreholes", () => {
    expect(keysOf("x1\ty1\tx2\ty2\tq\n1\t2\t3\t4\t5", "loads line")).toEqual([
      "points.0.0",
      "points.0.1",
      "points.1.0",
      "points.1.1",
      "q",
    ]);
    expect(keysOf("x from;x to;y from;y to\n1;2;3;4", "loads patch")).toEqual(["x.0", "x.1", "y.0", "y.1"]);
    expect(keysOf("x\ty\tlayer 1 E\tthickness 1\n1\t2\t3\t4", "boreholes")).toEqual([
      "x",
      "y",
      "layers.0.E",
      "layers.0.thickness",
    ]);
  });
  it("may have its units in a line below", () => {
    const block = readBlock(splitCells("name\tx\twidth x\n\tm\t[mm]\nA\t1\t2"), columnsFor("columns"), 0);
    expect(block.units).toEqual(["", "m", "mm"]);
    expect(block.rows).toEqual([["A", "1", "2"]]);
  });
  it("may name load cases that begin with a number, but is no line of numbers", () => {
    const data = { cases: [{ name: "1 snow" }, { name: "2" }, { name: "3" }] };
    const sheet = sheetsOf(schema).find(({ list }) => list === "combinations")!;
    const columns = columnsOf(schema, data, sheet, []);
    expect(readBlock(splitCells("name\t1 snow\nA\t1.5"), columns, 0).rows).toHaveLength(1);
    expect(readBlock(splitCells("2\t3\n1\t1"), columns, 3).rows).toHaveLength(2);
  });
  it("is none where there are numbers, one line only, or words that name nothing", () => {
    expect(keysOf("A\t1\t2", "columns")).toEqual(["name", "x", "y"]);
    expect(keysOf("name\tx", "columns")).toEqual(["name", "x"]);
    expect(readBlock(splitCells("A1\tx\nA2\ty"), columnsFor("columns"), 0).rows).toHaveLength(2);
    expect(keysOf("1\t2\t3\t4", "columns", 3)).toEqual(["width_x", "width_y", "diameter", "angle"]);
  });
});
