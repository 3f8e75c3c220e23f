import { describe, expect, it } from "vitest";
import { letters } from "../../../../src/workbench/model/axes";
import { applyOptimistic } from "../../../../src/workbench/model/changes/optimistic-edits";
import { itemsOf } from "../../../../src/workbench/model/items";
import { isTable, listAt, type Table, valueAt } from "../../../../src/workbench/model/paths";
import { lengthsOf } from "../../../../src/workbench/plan/fields";
import { BUILDING_AXES } from "../../../../src/workbench/plan/generators/building-axes";
import { casesToChoose, type Generator } from "../../../../src/workbench/plan/generators/generator";
import { generatorForKey } from "../../../../src/workbench/plan/generators/generators";

const FLOOR: Table = {
  plate: { length_x: "24 m", length_y: "12 m" },
  cases: [{ name: "floor" }, { name: "storage", action: "variable" }],
  loads: [{ kind: "self weight", case: "floor" }],
};

/** Return the data after a generator with its initial values but for some, the change, and what it selects. */
function make(key: string, own: Record<string, string>, data: Table = FLOOR) {
  const generator = generatorForKey(key) as Generator;
  const initial = Object.fromEntries(generator.fields.map((field) => [field.key, field.initial]));
  const made = generator.generate(data, { ...initial, ...own });
  const after = made.change.edits.reduce<Table>((state, edit) => applyOptimistic(state, edit), data);
  return { ...made, after };
}

const tables = (data: Table, list: string) => listAt(data, [list]).filter(isTable);

describe("racks", () => {
  it("are a pattern that stands once for each row", () => {
    const { after, paths, note } = make("k", { rows: "2", case: "storage", x: "-8", y: "-3,5", P: "62,5" });
    expect(tables(after, "patterns")).toEqual([
      {
        kind: "rack",
        name: "rack",
        P: "62.5 kN",
        frames: 6,
        bay: "2.7 m",
        rows: ["0 m", "1.1 m"],
        width_x: "150 mm",
        width_y: "150 mm",
      },
    ]);
    // the next row stands behind the frame and the aisle
    expect(tables(after, "moves").map(({ points }) => points)).toEqual([[["-8 m", "-3.5 m"]], [["-8 m", "1.1 m"]]]);
    expect(paths).toEqual([
      ["moves", 0],
      ["moves", 1],
    ]);
    expect(note).toBe("24 legs.");
    expect(tables(after, "cases")).toEqual(FLOOR.cases);
  });
  it("stand back to back, as loads of their own, in any direction", () => {
    const { after, change } = make("K", {
      racks: "back to back",
      bays: "1",
      angle: "90",
      as: "point loads",
      P: "10 kip",
      width_x: "100 mm",
      width_y: "200 mm",
    });
    const legs = tables(after, "loads").slice(1);
    expect(legs.map(({ x, y }) => [x, y])).toEqual([
      ["0 m", "0 m"],
      ["-1.1 m", "0 m"],
      ["-1.4 m", "0 m"],
      ["-2.5 m", "0 m"],
      ["0 m", "2.7 m"],
      ["-1.1 m", "2.7 m"],
      ["-1.4 m", "2.7 m"],
      ["-2.5 m", "2.7 m"],
    ]);
    expect(new Set(legs.map(({ P }) => P))).toEqual(new Set(["10 kip"]));
    expect(change.text).toBe("add 8 legs of racks");
    // the side of 100 mm lies along the rack, which runs along y
    expect(legs[0]).toMatchObject({ width_x: "200 mm", width_y: "100 mm" });
    const askew = make("K", { angle: "210", as: "point loads", width_x: "100 mm", width_y: "200 mm" }).after;
    // half a turn leaves a rectangle as it is
    expect(tables(askew, "loads")[1]).toMatchObject({ width_x: "100 mm", width_y: "200 mm", angle: 30 });
  });
  it("are in a load case of their own where none is chosen; loads that had none before get one, too", () => {
    const bare = { ...FLOOR, cases: [], loads: [{ kind: "self weight" }] };
    const { after } = make("k", { case: "new load case" }, bare);
    expect(tables(after, "cases").map(({ name }) => name)).toEqual(["permanent", "racks"]);
    expect([valueAt(after, ["loads", 0, "case"]), valueAt(after, ["moves", 0, "case"])]).toEqual([
      "permanent",
      "racks",
    ]);
  });
  it("are refused with words where a number means nothing", () => {
    for (const [key, value] of Object.entries({
      P: "much",
      bay: "-1 m",
      depth: "",
      angle: "x",
      rows: "999",
      bays: "200",
    }))
      expect(() => make("k", { [key]: value }), key).toThrow(/found|too many/);
    expect(() => make("k", { bays: "0" })).toThrow(/^bays: found "0"/);
  });
});

describe("imposed loads", () => {
  it("are offered no permanent case, and get a variable one where there is none", () => {
    expect(casesToChoose(FLOOR)).toEqual(["floor", "storage", "new load case"]);
    expect(casesToChoose(FLOOR, true)).toEqual(["storage", "new load case"]);
    for (const key of ["q", "k"]) {
      const { after } = make(key, { case: "floor" });
      const { name, action } = tables(after, "cases")[2]!;
      expect(valueAt(after, ["moves", 0, "case"])).toBe(name);
      expect(action).toBe("variable");
    }
  });
});

describe("a vehicle", () => {
  it("has its axles' loads on its wheels, times the dynamic factor, and moves along its path", () => {
    const { after, note } = make("q", { front: "60", factor: "1,4", rear: "10 kN", x: "-8", x2: "8", case: "storage" });
    const wheels = listAt(after, ["patterns", 0, "wheels"]).filter(isTable);
    expect(wheels.map(({ P, x, y }) => [P, x, y])).toEqual([
      ["42 kN", undefined, "-0.5 m"],
      ["42 kN", undefined, "0.5 m"],
      ["7 kN", "-1.6 m", "-0.5 m"],
      ["7 kN", "-1.6 m", "0.5 m"],
    ]);
    expect(valueAt(after, ["moves", 0])).toEqual({
      name: "path 1",
      pattern: "vehicle",
      case: "storage",
      points: [
        ["-8 m", "0 m"],
        ["8 m", "0 m"],
      ],
      step: "1 m",
    });
    expect(note).toMatch(/^17 positions/);
  });
  it("of one axle has two wheels; without a load or a path it is refused", () => {
    expect(listAt(make("q", { rear: "0" }).after, ["patterns", 0, "wheels"])).toHaveLength(2);
    for (const own of [{ front: "0", rear: "0 kN" }, { x2: "-5" }, { step: "1 mm" }, { factor: "-1" }, { track: "0" }])
      expect(() => make("q", own), JSON.stringify(own)).toThrow(/found|expected/);
  });
});

describe("columns on a grid", () => {
  it("are named by their axes, each with its load; those beside the slab and in openings are left out", () => {
    const data = {
      ...FLOOR,
      plate: { ...(FLOOR.plate as Table), openings: [{ kind: "rectangle", x: ["-1 m", "1 m"], y: ["-4 m", "-2 m"] }] },
    };
    const { after, note, paths } = make(
      "d",
      { x: "-12", spacing_x: "2x12 6", y: "-3", spacing_y: "6", case: "floor" },
      data,
    );
    const columns = tables(after, "columns");
    expect(columns.map(({ name, x, y }) => [name, x, y])).toEqual([
      ["A1", "-12 m", "-3 m"],
      ["C1", "12 m", "-3 m"],
      ["A2", "-12 m", "3 m"],
      ["B2", "0 m", "3 m"],
      ["C2", "12 m", "3 m"],
    ]);
    expect(
      tables(after, "loads")
        .slice(1)
        .map(({ column, P }) => [column, P]),
    ).toEqual(columns.map(({ name }) => [name, "500 kN"]));
    expect(note).toBe("5 columns. 3 outside the slab were skipped.");
    expect(itemsOf(after, null).filter(({ kind }) => kind === "column")).toHaveLength(5);
    expect(paths).toHaveLength(5);
  });
  it("have loads in two cases, also in one that is made for them", () => {
    const { after } = make("d", {
      spacing_x: "",
      spacing_y: "",
      P: "900",
      case: "floor",
      P_2: "350",
      case_2: "storage",
    });
    expect(tables(after, "loads").slice(1)).toEqual([
      { kind: "point", case: "floor", column: "A1", P: "900 kN" },
      { kind: "point", case: "storage", column: "A1", P: "350 kN" },
    ]);
    const own = { spacing_x: "", spacing_y: "", case: "new load case", P_2: "350", case_2: "new load case" };
    const made = make("d", own).after;
    expect(tables(made, "cases").map(({ name }) => name)).toEqual(["floor", "storage", "columns", "columns 2"]);
    expect(new Set(tables(made, "loads").map((load) => load.case))).toEqual(new Set(["floor", "columns", "columns 2"]));
  });
  it("have names of their own beside those that are there, and no load where it is 0", () => {
    const data = { ...FLOOR, columns: [{ name: "A1", x: "0 m", y: "0 m" }] };
    const { after } = make("d", { P: "0", spacing_x: "5" }, data);
    expect(tables(after, "columns").map(({ name }) => name)).toEqual(["A1", "A2", "B1", "A3", "B2"]);
    expect(tables(after, "loads")).toEqual(FLOOR.loads);
  });
  it("stand at distances that are listed as usual", () => {
    for (const text of ["6 6 5,4", "2x6 5.4", "2×6m 540 cm", "6 m;6 m;5.4 m", "2*6 m 5.4 m"])
      expect(lengthsOf({ d: text }, "d"), text).toEqual([6, 6, 5.4]);
    expect(lengthsOf({ d: " " }, "d")).toEqual([]);
    for (const text of ["6 -6", "six", "0x6", "6x"]) expect(() => lengthsOf({ d: text }, "d"), text).toThrow("found");
    expect([0, 25, 26, 27, 701, 702].map(letters)).toEqual(["A", "Z", "AA", "AB", "ZZ", "AAA"]);
  });
});

describe("axes", () => {
  const AXES = { kind: "x and y", spacing_x: "2x6 m", spacing_y: "2x4 m" };
  const axes = BUILDING_AXES;
  const add = (data: Table): Table => {
    const initial = Object.fromEntries(axes.fields.map((field) => [field.key, field.initial]));
    const made = axes.generate(data, { ...initial, ...AXES });
    return made.change.edits.reduce<Table>((state, edit) => applyOptimistic(state, edit), data);
  };

  it("go on after those that are there, until the names of all are free", () => {
    const thrice = add(add(add(FLOOR)));
    expect(tables(thrice, "axes").map(({ first }) => first)).toEqual(["A", "1", "D", "4", "G", "7"]);
    const other = { ...FLOOR, axes: [{ kind: "straight", first: "B", distances: "6 m" }] };
    expect(tables(add(other), "axes").map(({ first }) => first)).toEqual(["B", "D", "1"]);
  });
});
