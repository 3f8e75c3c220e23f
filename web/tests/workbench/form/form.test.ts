// @vitest-environment happy-dom
// The form: made from the schema, values kept as typed, kinds switched, faults at their fields.

import { beforeEach, describe, expect, it, vi } from "vitest";
import type { Change, Fault } from "../../../src/workbench/client/api";
import type { FormContext } from "../../../src/workbench/form/context";
import { faultsOfPart, faultWords } from "../../../src/workbench/form/errors";
import { formPanel } from "../../../src/workbench/form/form-panel";
import { labelOf, summaryOf } from "../../../src/workbench/form/labels";
import { partWidget } from "../../../src/workbench/form/section";
import { readGeometry, ringOf } from "../../../src/workbench/model/geometry";
import { foresee } from "../../../src/workbench/model/optimistic-edits";
import { type Path, pathKey, type Table, valueAt } from "../../../src/workbench/model/paths";
import { removal, renames } from "../../../src/workbench/model/references";
import { placed, switchKind } from "../../../src/workbench/model/variants";
import { schema } from "../schema";

class Page {
  readonly changes: Change[] = [];
  faults: Fault[] = [];
  readonly ctx: FormContext;
  update: () => void = () => undefined;

  constructor(public data: Table) {
    this.ctx = {
      schema,
      memory: new Map(),
      data: () => this.data,
      faults: () => this.faults,
      change: (change) => {
        this.changes.push(change);
        for (const edit of change.edits) this.data = foresee(this.data, edit);
        this.update();
      },
    };
  }

  show(path: Path) {
    const widget = partWidget(this.ctx, path, schema.nodeAt(path, this.data)!.node);
    document.body.replaceChildren(widget.element);
    this.update = () => widget.update();
    widget.update();
    return widget;
  }

  field(path: Path): HTMLElement {
    return document.querySelector<HTMLElement>(`[data-path='${pathKey(path)}']`)!;
  }

  input(path: Path): HTMLInputElement {
    return this.field(path).querySelector("input")!;
  }

  type(path: Path, text: string): void {
    const input = this.input(path);
    input.focus();
    input.value = text;
    input.dispatchEvent(new Event("input", { bubbles: true }));
  }
}

const fault = (
  path: Path,
  got = '"30"',
  expected = 'a pressure such as "30 MPa"',
  mend = "the unit is missing",
): Fault => ({ where: "", path, got, expected, mend });
const PLATE: Table = { plate: { length_x: "6 m", length_y: "4 m", thickness: "250 mm", E: "30 GPa", nu: 0.2 } };

beforeEach(() => void vi.useFakeTimers());

describe("the schema", () => {
  it("tells what each key is", () => {
    const plate = schema.part("Plate");
    const node = (name: string) => plate.fields.find((field) => field.name === name)?.node;
    expect(node("thickness")).toEqual({ is: "quantity", dimension: "length", example: "0.2 m" });
    expect(node("nu")).toEqual({ is: "number", words: [] });
    expect(node("outline")).toEqual({ is: "kinds", parts: ["Rectangle", "Polygon", "Circle"] });
    expect(node("zones")).toEqual({ is: "list", of: { is: "part", part: "Zone" }, least: 0 });
    expect(schema.part("Vlasov").fields.find((field) => field.name === "gamma")?.node).toEqual({
      is: "number",
      words: ["iterate"],
    });
    expect(schema.part("Beyond").fields.find((field) => field.name === "sides")?.node).toMatchObject({ is: "several" });
    expect(schema.part("Combination").fields.find((field) => field.name === "factors")?.node).toEqual({
      is: "factors",
    });
    expect(schema.part("LineLoad").fields.find((field) => field.name === "points")?.node).toMatchObject({
      is: "places",
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

describe("a field", () => {
  it("sends what was typed to the letter, wrong or not, once the keys rest", () => {
    const page = new Page(PLATE);
    page.show(["plate"]);
    page.type(["plate", "E"], "30");
    expect(page.changes).toEqual([]);
    vi.advanceTimersByTime(1000);
    expect(page.changes).toEqual([
      { edits: [{ op: "set", path: ["plate", "E"], value: "30" }], text: "change E of slab" },
    ]);
    page.type(["plate", "E"], "30000 MPa");
    vi.advanceTimersByTime(1000);
    expect(page.changes[1]).toMatchObject({ edits: [{ value: "30000 MPa" }] });
    expect(page.input(["plate", "E"]).value).toBe("30000 MPa");
  });

  it("joins what is typed on in it, until the keyboard has been elsewhere", () => {
    const page = new Page(PLATE);
    page.show(["plate"]);
    for (const text of ["2", "20", "200 mm"]) {
      page.type(["plate", "thickness"], text);
      vi.advanceTimersByTime(1000);
    }
    page.input(["plate", "thickness"]).blur();
    page.type(["plate", "thickness"], "300 mm");
    vi.advanceTimersByTime(1000);
    expect(page.changes.map((change) => change.merge ?? false)).toEqual([false, true, true, false]);
  });

  it("sends pure numbers as numbers, and text that is none as text", () => {
    const page = new Page(PLATE);
    page.show(["plate"]);
    page.type(["plate", "nu"], ".25");
    vi.advanceTimersByTime(1000);
    page.type(["plate", "nu"], "0,25");
    vi.advanceTimersByTime(1000);
    expect(page.changes.map((change) => (change.edits[0] as { value: unknown }).value)).toEqual([0.25, "0,25"]);
  });

  it("takes the key away when it is emptied, and shows the default instead", () => {
    const page = new Page({ plate: { ...(PLATE.plate as Table), shear_factor: 0.9 } });
    page.show(["plate"]);
    page.type(["plate", "shear_factor"], "");
    vi.advanceTimersByTime(1000);
    expect(page.changes[0]?.edits).toEqual([{ op: "remove", path: ["plate", "shear_factor"] }]);
    expect(page.input(["plate", "shear_factor"]).placeholder).toBe("0.833333");
  });

  it("leaves the text alone while it is typed, and follows the data when it is not", () => {
    const page = new Page(PLATE);
    page.show(["plate"]);
    page.type(["plate", "nu"], "0.");
    page.update();
    expect(page.input(["plate", "nu"]).value).toBe("0.");
    vi.advanceTimersByTime(1000);
    page.input(["plate", "nu"]).blur();
    page.data = foresee(page.data, { op: "set", path: ["plate", "nu"], value: 0.17 });
    page.update();
    expect(page.input(["plate", "nu"]).value).toBe("0.17");
  });

  it("fills the other values of a pair with their default when one is given", () => {
    const page = new Page({ loads: [{ kind: "uniform", q: "5 kPa" }] });
    page.show(["loads", 0]);
    page.type(["loads", 0, "slope"], "1 kPa/m");
    vi.advanceTimersByTime(1000);
    expect(valueAt(page.data, ["loads", 0, "slope"])).toEqual(["1 kPa/m", "0 MPa/m"]);
  });
});

describe("faults", () => {
  it("stand at their field in words, with what was found, expected and how to mend it", () => {
    const page = new Page(PLATE);
    page.faults = [fault(["plate", "E"])];
    page.show(["plate"]);
    const field = page.field(["plate", "E"]);
    expect(field.querySelector(".messages")?.textContent).toBe(
      'Got "30", expected a pressure such as "30 MPa" — the unit is missing.',
    );
    expect(faultWords(fault(["x"], '"g"', "a load case", 'did you mean "G"?'))).toBe(
      'Got "g", expected a load case — did you mean "G"?',
    );
    expect(page.input(["plate", "E"]).getAttribute("aria-invalid")).toBe("true");
    page.faults = [];
    page.update();
    expect(field.querySelector(".messages")?.textContent).toBe("");
    expect(page.input(["plate", "E"]).hasAttribute("aria-invalid")).toBe(false);
  });

  it("of one value of a pair stand at the pair; of unknown keys and of a table as a whole at the table", () => {
    const page = new Page({ loads: [{ kind: "patch", q: "1 kPa", x: ["1", "2 m"], y: ["0 m", "1 m"] }] });
    page.faults = [
      fault(["loads", 0, "x", 0]),
      fault(["loads", 0, "colour"], '"red"', "no such key", ""),
      fault(["loads", 0], "a load", "something else", ""),
    ];
    page.show(["loads", 0]);
    expect(page.field(["loads", 0, "x"]).classList.contains("faulty")).toBe(true);
    expect(document.querySelector("[data-part] > .messages")?.textContent).toContain("no such key");
    expect(faultsOfPart(page.faults, ["loads", 0], schema.part("PatchLoad"))).toHaveLength(2);
  });

  it("lead to their field in the form, through folded sections and items", () => {
    const page = new Page({
      ...PLATE,
      ground: { kind: "winkler", k: "20 MPa/m" },
      loads: [
        { kind: "uniform", q: "1 kPa" },
        { kind: "point", P: "5" },
      ],
    });
    page.faults = [fault(["loads", 1, "P"])];
    const form = formPanel(page.ctx, { read: () => [], write: () => undefined });
    document.body.replaceChildren(form.element);
    form.update();
    expect(page.field(["loads", 1, "P"])).toBeNull();
    expect(form.reveal(["loads", 1, "P"])).toBe(true);
    expect(document.activeElement).toBe(page.input(["loads", 1, "P"]));
    expect(document.querySelector('[data-section="loads"] .badge')?.textContent).toBe("1");
  });
});

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
      foresee,
      data,
    );
    expect(valueAt(result, path)).toEqual({ kind: "circle", centre: ["1 m", "0.5 m"], radius: "0.5 m" });
    const patch = switchKind(data, ["loads", 0], schema.part("AreaLoad"), schema.part("PatchLoad"), new Map()).reduce(
      foresee,
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
    ).reduce(foresee, data);
    expect(valueAt(result, ["supports", 0])).toMatchObject({ kind: "line", name: "A", acts: "in tension" });
    expect(valueAt(result, ["supports", 0, "stiffness"])).toBeUndefined();
    expect(valueAt(result, ["supports", 0, "points"])).toHaveLength(2);
  });

  it("changes a circle into a polygon of four quarters that is the same circle", () => {
    const data: Table = { plate: { outline: { kind: "circle", centre: ["1 m", "0 m"], radius: "2 m" } } };
    const polygon = placed(data, ["plate", "outline"], schema.part("Polygon"));
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

describe("lists", () => {
  it("show flat tables as a grid, one row each", () => {
    const page = new Page({
      columns: [
        { name: "A", x: "0 m", y: "0 m" },
        { name: "B", x: "1 m", y: "0 m" },
      ],
    });
    const form = formPanel(page.ctx, { read: () => ["columns"], write: () => undefined });
    document.body.replaceChildren(form.element);
    page.update = () => form.update();
    form.update();
    expect(document.querySelectorAll('[data-section="columns"] tbody tr')).toHaveLength(2);
    document.querySelector<HTMLButtonElement>('[data-section="columns"] tbody [aria-label="remove item 1"]')?.click();
    expect(document.querySelectorAll('[data-section="columns"] tbody tr')).toHaveLength(1);
    expect(page.input(["columns", 0, "name"]).value).toBe("B");
  });

  it("say what is in an item without unfolding it", () => {
    expect(summaryOf({ kind: "point", P: "500 kN", column: "A1", case: "dead" }, schema.part("PointLoad"))).toBe(
      "point  ·  P 500 kN  ·  on A1  ·  (dead)",
    );
  });
});

describe("names that others call", () => {
  const data: Table = {
    columns: [{ name: "A1", x: "0 m", y: "0 m" }],
    cases: [{ name: "dead" }],
    loads: [
      { kind: "point", column: "A1", case: "dead" },
      { kind: "uniform", case: "dead" },
      { kind: "point", column: "A1" },
    ],
    combinations: [{ name: "ULS", factors: { dead: 1.35, live: 1.5 } }],
  };

  it("are changed with those who call them, in one edit", () => {
    expect(renames(data, ["columns", 0, "name"], "B2")).toEqual([
      { op: "set", path: ["loads", 0, "column"], value: "B2" },
      { op: "set", path: ["loads", 2, "column"], value: "B2" },
    ]);
    expect(renames(data, ["cases", 0, "name"], "permanent")).toContainEqual({
      op: "set",
      path: ["combinations", 0, "factors"],
      value: { permanent: 1.35, live: 1.5 },
    });
  });

  it("are not joined with a name that is taken", () => {
    expect(renames({ ...data, columns: [{ name: "A1" }, { name: "A" }] }, ["columns", 0, "name"], "A")).toEqual([]);
  });

  it("are sent when they are complete, not while they are typed", () => {
    const page = new Page(data);
    page.show(["columns", 0]);
    page.type(["columns", 0, "name"], "A");
    vi.advanceTimersByTime(5000);
    expect(page.changes).toEqual([]);
    page.input(["columns", 0, "name"]).value = "A2";
    page.input(["columns", 0, "name"]).dispatchEvent(new Event("change"));
    expect(page.changes).toHaveLength(1);
    expect(valueAt(page.data, ["loads", 2, "column"])).toBe("A2");
  });

  it("go with their loads when the column is removed", () => {
    const change = removal(data, ["columns", 0]);
    expect(change.text).toBe("remove column A1 and its 2 loads");
    expect(change.edits.reduce(foresee, data).loads).toEqual([{ kind: "uniform", case: "dead" }]);
  });
});
