// The text: where in it a path stands.
import { describe, expect, it } from "vitest";
import raft from "../../../../examples/l_raft.toml?raw";
import { tokens } from "../../../src/workbench/text/highlighting";
import { lineOf, linesOf } from "../../../src/workbench/text/toml-positions";

const TEXT = `title = "a # no comment"   # a comment
[plate]
E = "30 GPa"
edges = {left = "free", right = "hinged"}
[plate.outline]
points = [["0 m", "0 m"],
  ["6 m", "0 m"], # second
  ["6 m", "4 m"]]
[[loads]]
kind = "uniform"
[[loads]]
kind = "point"
P = "5"
[[boreholes]]
layers = [
  {E = "18 MPa"},
  {E = "45 MPa", nu = 0.3},
]
[[boreholes]]
[[boreholes.layers]]
E = "1"
`;

describe("lines of paths", () => {
  const lines = linesOf(TEXT);
  it.each([
    [["title"], 1],
    [["plate", "E"], 3],
    [["plate", "edges", "right"], 4],
    [["plate", "outline", "points", 1], 7],
    [["plate", "outline", "points", 2, 0], 8],
    [["loads", 0, "kind"], 10],
    [["loads", 1, "P"], 13],
    [["loads", 1], 11],
    [["boreholes", 0, "layers", 1, "nu"], 17],
    [["boreholes", 1, "layers", 0, "E"], 21],
  ] as const)("%j stands on line %i", (path, line) => {
    expect(lineOf(lines, path)).toBe(line);
  });

  it("of what is not there are those of what is nearest above it", () => {
    expect(lineOf(lines, ["plate", "nu"])).toBe(2);
    expect(lineOf(lines, ["mesh"])).toBeNull();
  });

  it("are found in the shipped example as far down as the last load", () => {
    const rows = raft.split("\n");
    const last = rows.filter((row) => row === "[[loads]]").length - 1;
    const line = lineOf(linesOf(raft), ["loads", last, "q"]);
    expect(rows[(line ?? 0) - 1]).toContain("-16 kPa");
    expect(rows[(lineOf(linesOf(raft), ["combinations", 4, "factors", "flood"]) ?? 0) - 1]).toContain("flood = 1.1");
  });
});

describe("the pieces of a text", () => {
  it("are the whole text, also of a broken one", () => {
    for (const text of [TEXT, 'a = "open\nb = [1, {', "= ] }} '''\nx", '"""a\nb""" # c'])
      expect(
        tokens(text)
          .map((token) => token.text)
          .join(""),
      ).toBe(text);
  });

  it("of broken texts are read to their end", () => {
    for (const text of ["a = [1, 2", "[a", "[[", "x = {y = ", "= = =", "]", "{", "a.b.c", "a = }\nb = 1"])
      expect(linesOf(text)).toBeInstanceOf(Map);
    expect(lineOf(linesOf("a = }\nb = 1"), ["b"])).toBe(2);
  });
});
