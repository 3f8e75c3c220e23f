import { describe, expect, it } from "vitest";

import { readTables, writeTables } from "../../../src/workbench/model/toml";

describe("tables as text", () => {
  it("are read as they were written", () => {
    const tables = [
      { list: ["loads"], table: { kind: "point", name: 'a "b" \\ \n\t', P: "1 kN", on: true, nu: -0.25, n: [1, 2] } },
      { list: ["plate", "openings"], table: { kind: "polygon", points: [["0 m", "1 m"]], "odd key": { x: {} } } },
    ];
    expect(readTables(writeTables(tables))).toEqual(tables);
  });
  it("are read as others write them", () => {
    const text = `# a borehole
[[boreholes]]
name = 'B1'  # west
x = "1 m"
ground.kind = "layered"
numbers = [
  1_000, 2.5e-3,  # two
]
note = """
two
lines"""
[[boreholes.layers]]
E = "20 MPa"
[[boreholes.layers]]
E = "30 \\u00b5"
[boreholes.inner]
a = false
`;
    expect(readTables(text)).toEqual([
      {
        list: ["boreholes"],
        table: {
          name: "B1",
          x: "1 m",
          ground: { kind: "layered" },
          numbers: [1000, 0.0025],
          note: "two\nlines",
          layers: [{ E: "20 MPa" }, { E: "30 µ" }],
          inner: { a: false },
        },
      },
    ]);
  });
  it("are none in any other text", () => {
    for (const text of [
      "hello",
      "x = 1",
      "[plate]\nx = 1",
      "[[a]]\nx = ",
      "[[a]]\nx = 1\nx = 2",
      '[[a]]\n"__proto__" = 1',
      "[[a]]\nwhen = 2024-02-29",
      "[[a]]\nx = [inf]",
    ])
      expect(readTables(text), text).toBeNull();
    expect(readTables("")).toEqual([]);
  });
});
