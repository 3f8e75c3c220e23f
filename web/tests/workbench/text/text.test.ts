// The text: cut into tokens.
import { describe, expect, it } from "vitest";
import { tokenize } from "../../../src/workbench/text/highlighting";

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

describe("the pieces of a text", () => {
  it("are the entire text, also of a broken one", () => {
    for (const text of [TEXT, 'a = "open\nb = [1, {', "= ] }} '''\nx", '"""a\nb""" # c'])
      expect(
        tokenize(text)
          .map((token) => token.text)
          .join(""),
      ).toBe(text);
  });
});
