// @vitest-environment happy-dom
// What is said of a field: found by its path, with the kinds of the tables above it.
import { expect, test } from "vitest";
import { DRAWN, drawnKeys, drawPart } from "../../../src/workbench/help/drawings";
import { anchorOf, factsOf, findField, meaningOf } from "../../../src/workbench/help/facts";

import { schema } from "../schema";

const data = {
  loads: [
    { kind: "uniform", q: "5 kPa" },
    { kind: "point", P: "1 kN" },
  ],
  soil_zones: [{ ground: { kind: "constrained modulus", layers: [{ E: "2 MPa" }] } }],
};

test("a field is found in its part, also below a list, and by one of its values", () => {
  const found = findField(schema, data, ["loads", 1, "P"]);
  expect([found?.part?.name, found?.field.symbol]).toEqual(["PointLoad", "P"]);
  expect(findField(schema, data, ["mesh", "counts", 1])?.field.name).toBe("counts");
  expect(findField(schema, data, ["loads", 0, "P"])).toBeNull();
  expect(findField(schema, data, [])).toBeNull();
});

test("unit, range and default of a field are those of the schema", () => {
  const thickness = findField(schema, data, ["plate", "thickness"])!;
  expect(Object.fromEntries(factsOf(thickness, {})).default).toBe("none (required)");
  expect(Object.fromEntries(factsOf(thickness, {})).unit).toBe("length, such as 0.4 m");
  const gap = findField(schema, data, ["contact", "gap"])!;
  expect(Object.fromEntries(factsOf(gap, {})).default).toBe("0 m");
  expect(meaningOf(gap)).toBe("Initial gap everywhere under the plate.");
});

test("an anchor names the keys and the kinds above a field", () => {
  expect(anchorOf(data, ["plate", "thickness"])).toBe("key-plate-thickness");
  expect(anchorOf(data, ["loads", 1, "P"])).toBe("key-loads-P-point");
  expect(anchorOf(data, ["soil_zones", 0, "ground", "layers", 0, "E"])).toBe(
    "key-soil_zones-ground-layers-E-constrained-modulus",
  );
});

test("a drawing is shown for the keys that it explains, with one part highlighted, and all of them exist", () => {
  expect(drawPart("Plate", "name")).toBeNull();
  const drawing = drawPart("Plate", "thickness");
  expect(drawing?.querySelectorAll(".lit").length).toBe(1);
  expect(drawing?.querySelector(".lit text")?.textContent).toBe("t");
});

test("each drawing explains keys of its part, and each key that it names is one of some part with this drawing", () => {
  const known = new Set(DRAWN.flatMap((name) => schema.part(name).fields.map((field) => field.name)));
  for (const name of DRAWN) {
    const own = schema.part(name).fields.map((field) => field.name);
    const keys = drawnKeys(name);
    expect(own.some((key) => keys.includes(key))).toBe(true);
    expect(keys.filter((key) => !known.has(key))).toEqual([]);
  }
});
