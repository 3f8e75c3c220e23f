// Switching the kind of the ground, with what depends on it.
import { describe, expect, it } from "vitest";
import { switchGround } from "../../../../src/workbench/model/changes/ground";
import { applyOptimistic } from "../../../../src/workbench/model/changes/optimistic-edits";
import type { Table } from "../../../../src/workbench/model/paths";
import { schema } from "../../schema";

const LAYERS = [{ E: "20 MPa", nu: 0.3, thickness: "2 m", sublayers: 4 }];
const GROUND: Table = { kind: "layered", coupling: "consistent", layers: LAYERS };
const SHAPE: Table = { kind: "rectangle", x: ["0 m", "2 m"], y: ["0 m", "1 m"] };
const HOLES = [{ name: "B1", x: "0 m", y: "0 m", layers: LAYERS }];

function apply(data: Table, from: string, to: string, memory = new Map<string, Table>()): Table {
  return switchGround(data, schema.part(from), schema.part(to), memory).reduce(applyOptimistic, data);
}

describe("switching the ground", () => {
  it("takes sublayers, zones, and the ends of a margin away that a continuum cannot have", () => {
    const beyond = { kind: "margin", width: "3 m", edge: "fixed", sides: ["left"] };
    const data = { ground: GROUND, soil_zones: [{ shape: SHAPE, ground: GROUND }], beyond };
    const found = apply(data, "Layered", "Continuum");
    expect(found.soil_zones).toBeUndefined();
    expect(found.beyond).toEqual({ kind: "margin", width: "3 m" });
    expect(found.ground).toEqual({
      kind: "continuum",
      layers: [{ E: "20 MPa", nu: 0.3, thickness: "2 m" }],
      half_space: { E: "60 MPa", nu: 0.3 },
    });
  });

  it("makes zones of the same kind as the rest", () => {
    const data = { ground: GROUND, soil_zones: [{ shape: SHAPE, ground: GROUND }] };
    const found = apply(data, "Layered", "Pasternak");
    expect(found.soil_zones).toEqual([{ shape: SHAPE, ground: { kind: "pasternak", k0: "20 MPa/m", k1: "10 MN/m" } }]);
  });

  it("brings boreholes back with ground that can have them", () => {
    const memory = new Map<string, Table>();
    const data = {
      ground: { kind: "vlasov", layers: LAYERS.map(({ sublayers: _, ...layer }) => layer) },
      boreholes: HOLES,
    };
    const without = apply(data, "Vlasov", "Continuum", memory);
    expect(without.boreholes).toBeUndefined();
    expect(apply(without, "Continuum", "ConstrainedModulus", memory).boreholes).toEqual(HOLES);
    expect(apply(data, "Vlasov", "ConstrainedModulus").boreholes).toEqual(HOLES);
  });
});
