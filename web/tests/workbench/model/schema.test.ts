// @vitest-environment happy-dom
// The schema of the case file, as a form reads it.
import { describe, expect, it } from "vitest";
import { labelOf } from "../../../src/workbench/form/labels";
import type { Table } from "../../../src/workbench/model/paths";
import { schema } from "../schema";

describe("the schema", () => {
  it("says what each key is", () => {
    const plate = schema.part("Plate");
    const node = (name: string) => plate.fields.find((field) => field.name === name)?.node;
    expect(node("thickness")).toEqual({
      is: "quantity",
      dimension: "length",
      examples: ["0.4 m", "15 in"],
      options: [],
    });
    expect(node("nu")).toEqual({ is: "number", options: [] });
    expect(node("outline")).toEqual({ is: "kinds", parts: ["Rectangle", "Polygon", "Circle"] });
    expect(node("zones")).toEqual({ is: "list", of: { is: "part", part: "Zone" }, least: 0 });
    expect(schema.part("Vlasov").fields.find((field) => field.name === "gamma")?.node).toEqual({
      is: "number",
      options: ["iterate"],
    });
    const accuracy = schema.part("Mesh").fields.find((field) => field.name === "accuracy");
    expect(accuracy?.node).toMatchObject({ is: "quantity", options: ["draft", "normal", "strict"] });
    expect(accuracy?.range).toBe("0.01 to 50 %");
    expect(schema.part("Beyond").fields.find((field) => field.name === "sides")?.node).toMatchObject({ is: "choices" });
    expect(schema.part("Combination").fields.find((field) => field.name === "factors")?.node).toEqual({
      is: "factors",
    });
    expect(schema.part("LineLoad").fields.find((field) => field.name === "points")?.node).toMatchObject({
      is: "points",
    });
  });

  it("finds the node of a path through kinds and lists", () => {
    const data: Table = {
      loads: [{ kind: "patch" }, { kind: "point" }],
      ground: { kind: "layered", layers: [{ k0: "1", k1: "2" }] },
    };
    expect(schema.nodeAt(["loads", 1, "P"], data)?.field?.symbol).toBe("P");
    expect(schema.nodeAt(["loads", 0, "P"], data)).toBeNull();
    expect(schema.nodeAt(["ground", "layers", 0, "k1"], data)?.field?.name).toBe("k1");
    expect(schema.nodeAt(["loads", 0, "x", 1], data)?.node.is).toBe("quantity");
  });

  it("gives every key of the file an element and a name that is not empty", () => {
    const seen = new Set<string>();
    const visit = (name: string) => {
      if (seen.has(name)) return;
      seen.add(name);
      for (const field of schema.part(name).fields) {
        expect(`${labelOf(field)}${field.symbol}${field.name}`).not.toBe("");
        const walk = (node: typeof field.node): void => {
          if (node.is === "part") visit(node.part);
          else if (node.is === "kinds") node.parts.forEach(visit);
          else if (node.is === "list") walk(node.of);
        };
        walk(field.node);
      }
    };
    visit("");
    expect(seen.size).toBeGreaterThan(35);
  });

  it("say about which axis the moments of a load turn", () => {
    const fields = schema.part("PointLoad").fields;
    const named = ["M_x", "M_y"].map((name) => fields.find((field) => field.name === name)!);
    expect(named.map(labelOf)).toEqual(["moment about the y axis", "moment about the x axis"]);
    expect(named[0]!.hint).toContain("presses the side of larger x down");
  });
});
