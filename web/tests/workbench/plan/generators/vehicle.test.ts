import { describe, expect, it } from "vitest";

import { isTable, listAt, type Table } from "../../../../src/workbench/model/paths";
import { pressureOf } from "../../../../src/workbench/plan/fields";
import { FORKLIFT } from "../../../../src/workbench/plan/generators/forklifts";
import { VEHICLE } from "../../../../src/workbench/plan/generators/vehicle";

const FLOOR: Table = {
  plate: { length_x: "24 m", length_y: "12 m" },
  cases: [{ name: "traffic", action: "variable" }],
};

/** Return the wheels and the note of a vehicle with its initial values but for some. */
function make(own: Record<string, string>) {
  const initial = Object.fromEntries(VEHICLE.fields.map((field) => [field.key, field.initial]));
  const { change, note } = VEHICLE.generate(FLOOR, { ...initial, case: "traffic", ...own });
  const pattern = change.edits.flatMap((edit) =>
    edit.op === "add" && edit.path[0] === "patterns" ? [edit.value] : [],
  );
  return { wheels: listAt({ patterns: pattern } as Table, ["patterns", 0, "wheels"]).filter(isTable), note };
}

describe("a vehicle on tires", () => {
  it("stands on squares on which its static wheel loads have the tires' pressure", () => {
    const { wheels } = make({
      front: "63",
      rear: "8 kN",
      factor: "1.4",
      contact: "tire pressure",
      pressure: "0,8 MPa",
    });
    // 31.5 kN / 0.8 MPa = 0.039375 m2, 4 kN / 0.8 MPa = 0.005 m2; the dynamic factor is in P alone
    expect(wheels.map(({ P, width_x, width_y }) => [P, width_x, width_y])).toEqual([
      ["44.1 kN", "198.4 mm", "198.4 mm"],
      ["44.1 kN", "198.4 mm", "198.4 mm"],
      ["5.6 kN", "70.7 mm", "70.7 mm"],
      ["5.6 kN", "70.7 mm", "70.7 mm"],
    ]);
  });
  it("takes pressures in usual units, and says what is wrong with others", () => {
    for (const [text, pressure] of [
      ["0.8", 8e5],
      ["0,8 N/mm2", 8e5],
      ["800 kPa", 8e5],
      ["8 bar", 8e5],
    ] as const)
      expect(pressureOf({ p: text }, "p"), text).toBeCloseTo(pressure, 6);
    for (const text of ["", "0", "-1 MPa", "8 at", "hard"])
      expect(() => pressureOf({ p: text }, "p"), text).toThrow(/^p: found/);
    expect(() => make({ front: "6 t", contact: "tire pressure" })).toThrow("expected N, kN");
  });
});

describe("a forklift of a class", () => {
  it("has two wheels, each with half the axle load, on squares of 200 mm", () => {
    const { wheels, note } = make({ class: "FL3", ...FORKLIFT.fills!("FL3") });
    expect(wheels).toEqual([
      { P: "31.5 kN", y: "-0.5 m", width_x: "200 mm", width_y: "200 mm" },
      { P: "31.5 kN", y: "0.5 m", width_x: "200 mm", width_y: "200 mm" },
    ]);
    expect(note).toContain("verify it");
    expect(FORKLIFT.fills!("custom")).toBeNull();
    expect(make({}).note).not.toContain("EN 1991");
  });
  it("fills in fields that there are", () => {
    const keys = VEHICLE.fields.map(({ key }) => key);
    for (const name of FORKLIFT.options!.slice(1))
      expect(keys).toEqual(expect.arrayContaining(Object.keys(FORKLIFT.fills!(name)!)));
  });
  it("is refused with words where a number means nothing, beginning with the field", () => {
    for (const [key, value] of Object.entries({ front: "-1 kN", track: "0", base: "-1", width_x: "0 m", factor: "x" }))
      expect(() => make({ [key]: value }), key).toThrow(new RegExp(`^${key}: found "${value}", expected`));
  });
});
