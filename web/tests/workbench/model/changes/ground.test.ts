// Switching the kind of the ground, with what depends on it.
import { describe, expect, it } from "vitest";
import { type GroundSwitch, switchGround } from "../../../../src/workbench/model/changes/ground";
import { applyOptimistic } from "../../../../src/workbench/model/changes/optimistic-edits";
import { type Json, listAt, type Table, tableAt } from "../../../../src/workbench/model/paths";
import { schema } from "../../schema";

const KINDS = ["Winkler", "Pasternak", "Vlasov", "Layered", "Continuum", "ConstrainedModulus"];
const LAYER: Table = { E: "20 MPa", nu: 0.3, thickness: "2 m" };
const LAYERS = [{ ...LAYER, sublayers: 4 }];
const GROUND: Table = { kind: "layered", coupling: "consistent", layers: LAYERS };
const SHAPE: Table = { kind: "rectangle", x: ["0 m", "2 m"], y: ["0 m", "1 m"] };
const HOLES = [{ name: "B1", x: "0 m", y: "0 m", layers: [LAYER] }];
const MARGIN: Table = { kind: "margin", width: "3 m", edge: "fixed", sides: ["left"] };
const PILES: Table[] = [
  { kind: "point", name: "S1", x: "0 m", y: "0 m" },
  { kind: "pile", name: "P1", x: "1 m", y: "0 m", length: "1.5 m", diameter: "0.3 m" },
];
const LOADS: Table[] = [
  { kind: "patch", on: "ground", q: "20 kPa", x: ["-5 m", "-4 m"], y: ["0 m", "1 m"] },
  { kind: "uniform", q: "5 kPa" },
  { kind: "settlement", support: "S1", w: "2 mm" },
  { kind: "settlement", support: "P1", w: "3 mm" },
];

/** A file as it is edited: switches of its ground, with the memory that they share. */
class File {
  private readonly memory = new Map<string, Table>();

  constructor(
    public data: Table,
    private kind: string,
  ) {}

  switch(to: string): GroundSwitch {
    if (to === this.kind) return { edits: [], notice: "" };
    const made = switchGround(this.data, schema.part(this.kind), schema.part(to), this.memory);
    this.data = made.edits.reduce(applyOptimistic, this.data);
    this.kind = to;
    return made;
  }

  /** Make a switch and undo it. */
  try(to: string): void {
    const [before, kind] = [this.data, this.kind];
    this.switch(to);
    this.data = before;
    this.kind = kind;
  }
}

const layered = (): File =>
  new File({ ground: GROUND, soil_zones: [{ shape: SHAPE, ground: GROUND }], beyond: MARGIN, loads: LOADS }, "Layered");
const onPiles = (): File =>
  new File(
    { ground: { kind: "constrained modulus", layers: [LAYER] }, boreholes: HOLES, supports: PILES, loads: LOADS },
    "ConstrainedModulus",
  );

describe("switching the ground", () => {
  it("takes sublayers, zones, and the ends of a margin away that a continuum cannot have", () => {
    const file = layered();
    const { notice } = file.switch("Continuum");
    expect(file.data.soil_zones).toBeUndefined();
    expect(file.data.beyond).toEqual({ kind: "margin", width: "3 m" });
    expect(file.data.ground).toEqual({ kind: "continuum", layers: [LAYER] });
    expect(notice).toBe("Set aside: 1 soil zone; restored when the ground supports them again.");
  });

  it.each(KINDS.flatMap((first) => KINDS.map((second) => [first, second] as const)))(
    "brings everything back after %s and %s",
    (first, second) => {
      for (const [make, own] of [
        [layered, "Layered"],
        [onPiles, "ConstrainedModulus"],
      ] as const) {
        const file = make();
        const before = file.data;
        for (const to of [first, second, own]) file.switch(to);
        expect(file.data).toEqual(before);
      }
    },
  );

  it("puts piles away with their settlements, boreholes, and loads that press on springs", () => {
    const file = onPiles();
    expect(file.switch("Winkler").notice).toBe(
      "Set aside: 1 borehole, 1 pile, 1 load on the ground, 1 settlement; restored when the ground supports them again.",
    );
    expect(file.data.supports).toEqual([PILES[0]]);
    expect(file.data.loads).toEqual([LOADS[1], LOADS[2]]);
    expect(file.data.boreholes).toBeUndefined();
    expect(file.switch("Vlasov").notice).toBe("Restored: 1 borehole, 1 load on the ground.");
    expect(file.data.loads).toEqual([LOADS[0], LOADS[1], LOADS[2]]);
  });

  it("puts piles away that would end below the layers, without the half-space that they end in", () => {
    const piles = [{ ...PILES[1]!, length: "4 m" }];
    const ground: Table = { kind: "continuum", layers: [LAYER], half_space: { E: "60 MPa", nu: 0.3 } };
    const file = new File({ ground, supports: piles, loads: [LOADS[1]!] }, "Continuum");
    file.switch("ConstrainedModulus");
    expect(file.data.supports).toBeUndefined();
    file.switch("Continuum");
    expect(file.data).toEqual({ ground, supports: piles, loads: [LOADS[1]] });
  });

  it("does not bring back twice what undo has brought back, nor what was removed since", () => {
    const file = onPiles();
    file.try("Winkler");
    file.data = { ...file.data, loads: [LOADS[1]!] };
    file.switch("Continuum");
    file.switch("Winkler");
    file.switch("ConstrainedModulus");
    expect(file.data.loads).toEqual([LOADS[1]]);
    expect(listAt(file.data, ["supports"])).toEqual(PILES);
  });

  it("brings back again what was brought back and undone", () => {
    const file = onPiles();
    file.switch("Winkler");
    file.try("Continuum");
    file.switch("ConstrainedModulus");
    expect(file.data.loads).toEqual(LOADS);
  });

  it("makes zones of the same kind as the rest, each by what it was, and puts odd ones away", () => {
    const file = layered();
    file.switch("Pasternak");
    const pasternak = { kind: "pasternak", k0: "20 MPa/m", k1: "10 MN/m" };
    expect(file.data.soil_zones).toEqual([{ shape: SHAPE, ground: pasternak }]);
    const other = { shape: { ...SHAPE, y: ["1 m", "2 m"] }, ground: pasternak };
    file.data = { ...file.data, soil_zones: [other, ...listAt(file.data, ["soil_zones"])] };
    file.switch("Layered");
    expect(file.data.soil_zones).toEqual([{ shape: SHAPE, ground: GROUND }]);
    file.switch("Pasternak");
    expect(listAt(file.data, ["soil_zones"])).toHaveLength(2);
  });

  it("carries no rules over that the layers refuse", () => {
    const soft: Table = { ...LAYER, E: "5 MPa" };
    const file = new File({ ground: { kind: "vlasov", layers: [LAYER], mode: "sinh", gamma: 1.5 } }, "Vlasov");
    file.switch("Layered");
    expect(file.data.ground).toEqual({ kind: "layered", coupling: "consistent", layers: [LAYER] });
    file.data = { ground: { ...tableAt(file.data, ["ground"]), layers: [LAYER, soft] } };
    file.switch("Vlasov");
    expect(file.data.ground).toEqual({ kind: "vlasov", layers: [LAYER, soft], gamma: 1.5 });
  });

  it("knows layers given by k0 and k1 again, which no other kind takes", () => {
    const stiffnesses: Json = [{ k0: "20 MPa/m", k1: "10 MN/m" }];
    const file = new File({ ground: { kind: "layered", coupling: "interface", layers: stiffnesses } }, "Layered");
    file.switch("Vlasov");
    expect(listAt(file.data, ["ground", "layers"])).toEqual([{ ...LAYER, thickness: "4 m" }]);
    file.switch("Layered");
    expect(file.data.ground).toEqual({ kind: "layered", coupling: "interface", layers: stiffnesses });
  });

  it("gives k by one of two ways only, and by k under several plates", () => {
    const ground: Table = { kind: "winkler", selvadurai: { E: "20 MPa", depth: "5 m" } };
    const file = new File({ ground }, "Winkler");
    file.switch("Pasternak");
    file.switch("Winkler");
    expect(file.data.ground).toEqual(ground);
    file.switch("Pasternak");
    file.data = { ...file.data, plates: [{ name: "B" }] };
    file.switch("Winkler");
    expect(file.data.ground).toEqual({ kind: "winkler", k: "20 MPa/m" });
  });

  it("leaves the only loads of a slab, and elastic joints out where glued plates settle alike", () => {
    const joint = { kind: "elastic", between: ["A", "B"], stiffness: "5 MN/m2" };
    const file = new File(
      {
        ground: { kind: "winkler", k: "20 MPa/m" },
        contact: { tensionless: false },
        joints: [joint],
        loads: [LOADS[0]!],
      },
      "Winkler",
    );
    expect(file.switch("Pasternak").notice).toBe(
      "Set aside: 1 elastic joint; restored when the ground supports them again.",
    );
    expect(file.data.joints).toBeUndefined();
    file.switch("Winkler");
    expect(file.data.joints).toEqual([joint]);
    expect(file.data.loads).toEqual([LOADS[0]]);
  });
});
