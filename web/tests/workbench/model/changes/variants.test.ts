// @vitest-environment happy-dom
// Switching the kind of a table.
import { beforeEach, describe, expect, it, vi } from "vitest";
import { applyOptimistic } from "../../../../src/workbench/model/changes/optimistic-edits";
import { defaultPlacement, switchKind } from "../../../../src/workbench/model/changes/variants";
import { readGeometry, ringOf } from "../../../../src/workbench/model/geometry";
import { type Path, type Table, valueAt } from "../../../../src/workbench/model/paths";
import { Page, PLATE } from "../../form-page";
import { schema } from "../../schema";

beforeEach(() => void vi.useFakeTimers());

describe("switching the kind", () => {
  const layers = [{ E: "20 MPa", nu: 0.3, thickness: "2 m" }];

  it("keeps what both kinds share, and fills in what the other needs", () => {
    const data: Table = { ground: { kind: "vlasov", layers, gamma: 1.5, mode: "profile" } };
    const edits = switchKind(data, ["ground"], schema.part("Vlasov"), schema.part("Layered"), new Map());
    expect(edits).toEqual([
      { op: "set", path: ["ground", "kind"], value: "layered" },
      { op: "remove", path: ["ground", "mode"] },
      { op: "set", path: ["ground", "coupling"], value: "consistent" },
    ]);
  });

  it("gives a continuum layers and a half-space below, and another kind its layers", () => {
    const halfSpace = { E: "60 MPa", nu: 0.3 };
    const ground = (from: Table, kind: string, to: string) =>
      switchKind({ ground: from }, ["ground"], schema.part(kind), schema.part(to), new Map()).reduce(applyOptimistic, {
        ground: from,
      } as Table).ground;
    const springs = { kind: "winkler", k: "20 MPa/m" };
    const filled = [{ E: "20 MPa", nu: 0.3, thickness: "4 m" }];
    expect(ground(springs, "Winkler", "Continuum")).toEqual({
      kind: "continuum",
      layers: filled,
      half_space: halfSpace,
    });
    expect(ground({ kind: "continuum", layers, half_space: halfSpace }, "Continuum", "ConstrainedModulus")).toEqual({
      kind: "constrained modulus",
      layers,
    });
  });

  it("gives back what the first switch took away", () => {
    const page = new Page({ ground: { kind: "vlasov", layers, gamma: 1.5 } });
    page.show(["ground"]);
    const choose = (name: string) => {
      const select = document.querySelector<HTMLSelectElement>(".kind select")!;
      select.value = name;
      select.dispatchEvent(new Event("change", { bubbles: true }));
    };
    choose("Winkler");
    expect(page.data.ground).toEqual({ kind: "winkler", k: "20 MPa/m" });
    expect(page.field(["ground", "k"])).not.toBeNull();
    choose("Vlasov");
    expect(page.data.ground).toEqual({ kind: "vlasov", layers, gamma: 1.5 });
  });

  it("makes one shape of another where it lies", () => {
    const data: Table = {
      ...PLATE,
      loads: [{ kind: "area", q: "5 kPa", shape: { kind: "rectangle", x: ["0 m", "2 m"], y: ["0 m", "1 m"] } }],
    };
    const path: Path = ["loads", 0, "shape"];
    const result = switchKind(data, path, schema.part("Rectangle"), schema.part("Circle"), new Map()).reduce(
      applyOptimistic,
      data,
    );
    expect(valueAt(result, path)).toEqual({ kind: "circle", centre: ["1 m", "0.5 m"], radius: "0.5 m" });
    const patch = switchKind(data, ["loads", 0], schema.part("AreaLoad"), schema.part("PatchLoad"), new Map()).reduce(
      applyOptimistic,
      data,
    );
    expect(valueAt(patch, ["loads", 0])).toEqual({ kind: "patch", q: "5 kPa", x: ["0 m", "2 m"], y: ["0 m", "1 m"] });
  });

  it("does not take a value over that means something else under the same name", () => {
    const data: Table = {
      ...PLATE,
      supports: [{ kind: "point", name: "A", x: "0 m", y: "0 m", stiffness: "200 MN/m", acts: "in tension" }],
    };
    const result = switchKind(
      data,
      ["supports", 0],
      schema.part("PointSupport"),
      schema.part("LineSupport"),
      new Map(),
    ).reduce(applyOptimistic, data);
    expect(valueAt(result, ["supports", 0])).toMatchObject({ kind: "line", name: "A", acts: "in tension" });
    expect(valueAt(result, ["supports", 0, "stiffness"])).toBeUndefined();
    expect(valueAt(result, ["supports", 0, "points"])).toHaveLength(2);
  });

  it("changes a circle into a polygon of four quarters that is the same circle", () => {
    const data: Table = { plate: { outline: { kind: "circle", centre: ["1 m", "0 m"], radius: "2 m" } } };
    const polygon = defaultPlacement(data, ["plate", "outline"], schema.part("Polygon"));
    expect(polygon.points).toEqual([
      ["3 m", "0 m"],
      ["1 m", "2 m"],
      ["-1 m", "0 m"],
      ["1 m", "-2 m"],
    ]);
    const ring = ringOf(readGeometry({ o: polygon }, ["o"])!);
    for (const [x, y] of ring) expect(Math.hypot(x - 1, y)).toBeCloseTo(2, 12);
  });

  it("changes the slab into a polygon on command only, with the corners it had", () => {
    const page = new Page(PLATE);
    page.show(["plate"]);
    const select = document.querySelector<HTMLSelectElement>(".plate-shape select")!;
    select.value = "Polygon";
    select.dispatchEvent(new Event("change", { bubbles: true }));
    expect(page.data.plate).toEqual({
      thickness: "250 mm",
      E: "30 GPa",
      nu: 0.2,
      outline: {
        kind: "polygon",
        points: [
          ["-3 m", "-2 m"],
          ["3 m", "-2 m"],
          ["3 m", "2 m"],
          ["-3 m", "2 m"],
        ],
      },
    });
    select.value = "sides";
    select.dispatchEvent(new Event("change", { bubbles: true }));
    expect(page.data.plate).toMatchObject({ length_x: "6 m", length_y: "4 m" });
  });
});
