import { describe, expect, it } from "vitest";
import {
  choiceName,
  combinationsOf,
  deriveMoment,
  designMoments,
  envelopesOf,
  extremesOf,
  fieldsOf,
  fieldValueAt,
  groupFields,
  isInContact,
  lineForceOf,
  nodalValues,
  parseChoice,
  principalDirection,
  principalMoments,
} from "../../../src/viewer/data/fields";
import { Locator } from "../../../src/viewer/data/point-location";
import { scaleFor } from "../../../src/viewer/data/shown-field";
import { FIELDS, grid, nodal, randoms, sceneOf } from "../synthetic";

describe("principal moments", () => {
  it("are those of Mohr's circle", () => {
    // middle 20, radius sqrt(30^2 + 40^2) = 50
    expect(principalMoments(50, -10, 40)).toEqual([70, -30]);
    expect(principalMoments(8, 8, 0)).toEqual([8, 8]);
    expect(principalDirection(50, -10, 40)).toBeCloseTo((Math.atan2(80, 60) * 90) / Math.PI, 12);
    expect(principalDirection(0, 10, 0)).toBeCloseTo(90, 12);
  });
});

describe("design moments", () => {
  it("are Wood's in every state", () => {
    // no twist: the moments themselves, none where the other face is in tension
    expect(designMoments(5, -3, 0)).toEqual([5, 0]);
    // pure twist asks for its size everywhere
    expect(["bottom_x", "bottom_y", "top_x", "top_y"].map((name) => deriveMoment(name, 0, 0, 7))).toEqual([
      7, 7, -7, -7,
    ]);
    // both positive: each grows by the twist
    expect(designMoments(50, 30, -20)).toEqual([70, 50]);
    // -10 + 4 < 0: nothing along x, 8 + 4^2 / 10 along y
    expect(designMoments(-10, 8, 4)).toEqual([0, 9.6]);
    // top: of (10, -8, 4): 10 + 4^2 / 8 along x, nothing along y
    expect(deriveMoment("top_x", -10, 8, 4)).toBe(-12);
    expect(deriveMoment("top_y", -10, 8, 4)).toBe(0);
    // hogging both ways asks nothing at the bottom
    expect(designMoments(-50, -30, 20)).toEqual([0, 0]);
    // -10 + 4 < 0 and -3 + 4^2 / 10 < 0: a twist too small to bend the bottom in any direction
    expect(designMoments(-10, -3, 4)).toEqual([0, 0]);
  });

  it("cover the bending moment in every direction", () => {
    const random = randoms(3);
    for (let i = 0; i < 500; i++) {
      const [mx, my, mxy] = [200 * random() - 100, 200 * random() - 100, 200 * random() - 100];
      const [x, y] = designMoments(mx, my, mxy);
      for (let k = 0; k < 90; k++) {
        const [c, s] = [Math.cos((k * Math.PI) / 90), Math.sin((k * Math.PI) / 90)];
        expect(x * c * c + y * s * s).toBeGreaterThanOrEqual(mx * c * c + my * s * s + 2 * mxy * s * c - 1e-9);
      }
    }
  });
});

describe("fields of a scene", () => {
  const mesh = grid(4, 2, (x, y) => [8 * x, 4 * y]);
  const scene = sceneOf(mesh, [
    {
      name: "A",
      fields: {
        settlement: (x) => x,
        moment_x: (x, y) => x * y - 4,
        moment_y: (x) => 3 - x,
        moment_xy: () => 2,
        contact: (x) => x - 6,
      },
    },
    { name: "B", fields: { settlement: (x) => 8 - x, moment_x: () => 1, contact: () => -1 } },
    { name: "C", state: "characteristic", fields: { settlement: () => 20 } },
    { name: "D", certified: false, fields: { settlement: () => 100 } },
    { name: "E", refused: "no equilibrium" },
    { name: "F", state: "characteristic", fields: { settlement: () => -20 } },
  ]);
  const locator = new Locator(scene.mesh);

  it("are offered without contact, with what is derived", () => {
    expect(fieldsOf(scene).map((each) => each.name)).toEqual([
      "settlement",
      "pressure",
      "moment_x",
      "moment_y",
      "moment_xy",
      "m_1",
      "m_2",
      "bottom_x",
      "bottom_y",
      "top_x",
      "top_y",
    ]);
    expect(fieldsOf(scene).find((each) => each.name === "top_x")!.unit).toBe("kNm/m");
    const groups = new Map(groupFields(fieldsOf(scene)));
    expect([...groups.keys()]).toEqual(["Deformation", "Contact", "Moments and shear", "Derived moments"]);
    expect(groups.get("Derived moments")!.every((each) => each.derived)).toBe(true);
  });

  it("have envelopes over certified combinations only, of a limit state or all", () => {
    expect(combinationsOf(scene, "largest")).toEqual([0, 1, 2, 5]);
    expect(combinationsOf(scene, "smallest:ultimate")).toEqual([0, 1]);
    expect(envelopesOf(scene)).toEqual([
      "largest:ultimate",
      "smallest:ultimate",
      "largest:characteristic",
      "smallest:characteristic",
      "largest",
      "smallest",
    ]);
    expect([...nodalValues(scene, "largest:ultimate", "settlement")]).toEqual([
      ...nodal(mesh, (x) => Math.max(x, 8 - x)),
    ]);
    expect([...nodalValues(scene, "smallest", "settlement")]).toEqual(Array<number>(mesh.nodeCount).fill(-20));
    expect(envelopesOf(sceneOf(mesh, [{ name: "one", fields: {} }]))).toEqual([]);
    expect(
      envelopesOf(
        sceneOf(mesh, [
          { name: "one", fields: {} },
          { name: "two", fields: {} },
        ]),
      ),
    ).toEqual(["largest", "smallest"]);
  });

  it("say which combination governs at a place", () => {
    expect(fieldValueAt(scene, locator, "largest:ultimate", "settlement", locator.locate(1, 1)!)).toEqual({
      value: expect.closeTo(7, 5) as number,
      from: 1,
    });
    expect(fieldValueAt(scene, locator, "largest:ultimate", "settlement", locator.locate(7, 1)!)).toEqual({
      value: expect.closeTo(7, 5) as number,
      from: 0,
    });
    expect(fieldValueAt(scene, locator, "smallest:ultimate", "settlement", locator.locate(7, 1)!).from).toBe(1);
    expect(fieldValueAt(scene, locator, 3, "settlement", locator.locate(7, 1)!)).toEqual({
      value: expect.closeTo(100, 4) as number,
      from: 3,
    });
  });

  it("are derived from the moments at the place, and enveloped after that", () => {
    const [x, y] = [2.3, 3.1];
    const spot = locator.locate(x, y)!;
    const mine = deriveMoment("bottom_x", x * y - 4, 3 - x, 2);
    expect(fieldValueAt(scene, locator, 0, "bottom_x", spot).value).toBeCloseTo(mine, 4);
    expect(fieldValueAt(scene, locator, "largest:ultimate", "bottom_x", spot).value).toBeCloseTo(Math.max(mine, 1), 4);
    const largest = nodalValues(scene, "largest:ultimate", "m_2");
    nodal(mesh, (x, y) => Math.max(principalMoments(x * y - 4, 3 - x, 2)[1], 0)).forEach((value, i) => {
      expect(largest[i]).toBeCloseTo(value, 4);
    });
  });

  it("know contact, in an envelope only where every combination has it", () => {
    expect(isInContact(scene, locator, 0, locator.locate(5, 2)!)).toBe(true);
    expect(isInContact(scene, locator, 0, locator.locate(7, 2)!)).toBe(false);
    expect(isInContact(scene, locator, 1, locator.locate(7, 2)!)).toBe(true);
    expect(isInContact(scene, locator, "largest:ultimate", locator.locate(7, 2)!)).toBe(false);
    expect([...nodalValues(scene, "smallest:ultimate", "contact")]).toEqual([
      ...nodal(mesh, (x) => Math.max(x - 6, -1)),
    ]);
  });

  it("have ends with places; those of the scene come first", () => {
    expect(extremesOf(scene, 0, "settlement").max[0]).toBe(8);
    expect(extremesOf(scene, 0, "settlement").max[1]).toBe(8);
    const given = sceneOf(mesh, [{ name: "A", fields: { pressure: (x) => x } }]);
    given.head.combinations[0]!.extremes = { pressure: { min: [0, 0, 0], max: [8.5, 8, 4] } };
    expect(extremesOf(given, 0, "pressure")).toEqual({ min: [0, 0, 0], max: [8.5, 8, 4] });
  });

  it("know the largest line force along the edge where the ground has one", () => {
    const given = sceneOf(mesh, [
      { name: "A", fields: { pressure: (x) => x } },
      { name: "B", fields: { pressure: (x) => x } },
    ]);
    expect(lineForceOf(given, 0)).toBeNull();
    given.head.combinations[0]!.extremes = { line_force: { min: [0, 0, 0], max: [12, 8, 4] } };
    given.head.combinations[1]!.extremes = { line_force: { min: [0, 0, 0], max: [15, 8, 0] } };
    expect(lineForceOf(given, 0)).toEqual([12, 8, 4]);
    expect(lineForceOf(given, "largest:ultimate")).toEqual([15, 8, 0]);
  });

  it("are kept, and named", () => {
    expect(nodalValues(scene, 0, "m_1")).toBe(nodalValues(scene, 0, "m_1"));
    expect(choiceName(scene, 2)).toBe("3 C");
    expect(choiceName(scene, "smallest:ultimate")).toBe("min of all ultimate combinations");
    expect([parseChoice("3"), parseChoice("largest:ultimate")]).toEqual([3, "largest:ultimate"]);
    expect(() => nodalValues(scene, 4, "settlement")).toThrow(RangeError);
  });
});

describe("a difference of results", () => {
  const given = [
    { name: "dead", fields: { settlement: (x: number) => 3 * x } },
    { name: "all", fields: {} },
    { name: "wind" },
  ];
  const fields = [...FIELDS.filter(({ name }) => name !== "contact"), { ...FIELDS[0]!, name: "m_1" }];
  const difference = (of: "combination" | "reference", minus: (string | null)[]) => {
    const scene = sceneOf(grid(2, 2), given, { fields, difference: of });
    scene.head.combinations.forEach((each, i) => {
      each.minus = minus[i] ?? null;
      if (each.values) each.values.m_1 = each.values.settlement!;
    });
    return scene;
  };

  it("has the fields that it is given, none derived of other differences, and no envelopes", () => {
    const scene = difference("combination", ["all", "all"]);
    expect(fieldsOf(scene).map(({ name }) => name)).toEqual(fields.map(({ name }) => name));
    expect(nodalValues(scene, 0, "m_1")).toEqual(nodalValues(scene, 0, "settlement"));
    expect(envelopesOf(scene)).toEqual([]);
  });

  it("says what minus what it is", () => {
    expect(choiceName(difference("combination", ["all"]), 0)).toBe("1 dead minus 2 all");
    const scene = difference("reference", ["dead", "other"]);
    expect([0, 1, 2].map((choice) => choiceName(scene, choice))).toEqual([
      "1 dead minus the reference",
      "2 all minus other of the reference",
      "3 wind",
    ]);
  });

  it("has zero in the middle of its scale", () => {
    const scene = difference("combination", ["all"]);
    const { levels, colors, diverging } = scaleFor(scene, 0, fieldsOf(scene)[0]!, "auto");
    expect(levels).toEqual(levels.map((level) => 0 - level).reverse());
    expect([levels[0], levels.at(-1)]).toEqual([-3, 3]);
    expect(diverging).toBe(true);
    expect(colors.length).toBe(levels.length - 1);
  });
});
