// @vitest-environment happy-dom
// The form: made from the schema, values kept as typed, issues at their fields.
import { beforeEach, describe, expect, it, vi } from "vitest";
import { formPanel } from "../../../src/workbench/form/form-panel";
import { summaryOf } from "../../../src/workbench/form/labels";
import { applyOptimistic } from "../../../src/workbench/model/changes/optimistic-edits";
import { defaultsFor } from "../../../src/workbench/model/defaults";
import { issueSentence, issuesOfPart } from "../../../src/workbench/model/issues";
import { type Table, valueAt } from "../../../src/workbench/model/paths";
import { makeIssue, Page, PLATE } from "../form-page";
import { schema } from "../schema";

beforeEach(() => void vi.useFakeTimers());

describe("a floor with vehicles and racks", () => {
  const floor: Table = {
    ...PLATE,
    cases: [{ name: "truck" }],
    patterns: [
      { kind: "vehicle", name: "forklift", wheels: [{ P: "45 kN", y: "0.5 m" }, { P: "45 kN" }] },
      { kind: "rack", name: "pallets", P: "60 kN", rows: ["0 m", "1.1 m"] },
    ],
    moves: [
      {
        pattern: "forklift",
        case: "truck",
        points: [
          ["0 m", "0 m"],
          ["2 m", "0 m"],
        ],
        step: "0.5 m",
      },
    ],
    floor: { kind: "TR34", f_ck: "32 MPa" },
  };

  it("is shown, each pattern with the keys of its kind", () => {
    const page = new Page(floor);
    page.show(["patterns", 0]);
    expect(page.input(["patterns", 0, "name"]).value).toBe("forklift");
    page.show(["patterns", 1]);
    expect(page.input(["patterns", 1, "P"]).value).toBe("60 kN");
    page.show(["moves", 0]);
    expect(page.input(["moves", 0, "step"]).value).toBe("0.5 m");
    page.show(["floor"]);
    expect(page.input(["floor", "f_ck"]).value).toBe("32 MPa");
  });

  it("is kept when something else is changed", () => {
    const page = new Page(floor);
    page.show(["moves", 0]);
    page.type(["moves", 0, "step"], "1 m");
    vi.advanceTimersByTime(1000);
    expect(page.data).toEqual({ ...floor, moves: [{ ...(floor.moves as Table[])[0], step: "1 m" }] });
  });
});

describe("psi of a load case", () => {
  const psi = ["cases", 0, "psi_0"];

  it("are asked for of variable cases alone", () => {
    const page = new Page({ ...PLATE, cases: [{ name: "G" }] });
    page.show(["cases", 0]);
    expect(page.field(psi).hidden).toBe(true);
    expect(page.field(["cases", 0, "H_x"]).hidden).toBe(false);
    page.ctx.change({ edits: [{ op: "set", path: ["cases", 0, "action"], value: "variable" }], text: "" });
    expect(page.field(psi).hidden).toBe(false);
    page.ctx.change({ edits: [{ op: "set", path: ["cases", 0, "action"], value: "seismic" }], text: "" });
    expect(page.field(psi).hidden).toBe(true);
  });

  it("stay where the file has them", () => {
    const page = new Page({ ...PLATE, cases: [{ name: "G", psi_0: 0.6 }] });
    page.show(["cases", 0]);
    expect(page.field(psi).hidden).toBe(false);
    expect(page.field(["cases", 0, "psi_1"]).hidden).toBe(true);
  });
});

describe("a building above", () => {
  const columns = ["A", "B"].map((name, n) => ({ name, x: `${n} m`, y: "0 m", width_x: "0.4 m", width_y: "0.4 m" }));

  it("starts as a frame through all columns, of the slab's concrete", () => {
    expect(defaultsFor("Building", { ...PLATE, columns })).toEqual({
      storeys: ["4 m", "3 m"],
      E: valueAt(PLATE, ["plate", "E"]),
      beams: [{ through: ["A", "B"], section: { kind: "rectangle", width: "300 mm", height: "600 mm" } }],
    });
  });

  it("is shown as a matrix, which is kept when something else is changed", () => {
    const matrix = [
      [1, -1],
      [-1, 1],
    ];
    const building = { nodes: ["A", "B"], matrix, unit: "kN" };
    const page = new Page({ ...PLATE, columns, building });
    page.show(["building"]);
    page.type(["building", "stiffness"], "0.5");
    vi.advanceTimersByTime(1000);
    expect(page.data.building).toEqual({ ...building, stiffness: 0.5 });
  });

  it("is shown with its beams", () => {
    const building = defaultsFor("Building", { ...PLATE, columns });
    const page = new Page({ ...PLATE, columns, building });
    page.show(["building"]);
    expect(page.input(["building", "E"]).value).toBe(building.E);
    page.show(["building", "beams", 0]);
    expect(page.input(["building", "beams", 0, "section", "width"]).value).toBe("300 mm");
  });
});

describe("a field", () => {
  it("sends what was typed to the letter, wrong or not, once the keys rest", () => {
    const page = new Page(PLATE);
    page.show(["plate"]);
    page.type(["plate", "E"], "31 Pam");
    expect(page.changes).toEqual([]);
    vi.advanceTimersByTime(1000);
    expect(page.changes).toEqual([
      { edits: [{ op: "set", path: ["plate", "E"], value: "31 Pam" }], text: "change E of slab" },
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
    page.type(["plate", "nu"], "0,3");
    vi.advanceTimersByTime(1000);
    page.type(["plate", "nu"], "1,500");
    vi.advanceTimersByTime(1000);
    expect(page.changes.map((change) => (change.edits[0] as { value: unknown }).value)).toEqual([0.25, 0.3, "1,500"]);
  });

  it("gives a bare number the unit that stood there", () => {
    const page = new Page(PLATE);
    page.show(["plate"]);
    page.type(["plate", "E"], "31,5");
    vi.advanceTimersByTime(1000);
    expect(page.changes[0]?.edits).toEqual([{ op: "set", path: ["plate", "E"], value: "31.5 GPa" }]);
  });

  it("takes the key away when it is emptied, and shows the default instead", () => {
    const page = new Page({ plate: { ...(PLATE.plate as Table), shear_factor: 0.9 } });
    page.show(["plate"]);
    page.type(["plate", "shear_factor"], "");
    vi.advanceTimersByTime(1000);
    expect(page.changes[0]?.edits).toEqual([{ op: "remove", path: ["plate", "shear_factor"] }]);
    expect(page.input(["plate", "shear_factor"]).placeholder).toBe("default 0.833333");
  });

  it("leaves the text alone while it is typed, and follows the data when it is not", () => {
    const page = new Page(PLATE);
    page.show(["plate"]);
    page.type(["plate", "nu"], "0.");
    page.update();
    expect(page.input(["plate", "nu"]).value).toBe("0.");
    vi.advanceTimersByTime(1000);
    page.input(["plate", "nu"]).blur();
    page.data = applyOptimistic(page.data, { op: "set", path: ["plate", "nu"], value: 0.17 });
    page.update();
    expect(page.input(["plate", "nu"]).value).toBe("0.17");
  });

  it("fills the other values of a pair with their default when one is given", () => {
    const page = new Page({ loads: [{ kind: "uniform", q: "5 kPa" }] });
    page.show(["loads", 0]);
    page.type(["loads", 0, "slope"], "1 kPa/m");
    vi.advanceTimersByTime(1000);
    expect(valueAt(page.data, ["loads", 0, "slope"])).toEqual(["1 kPa/m", "0 Pa/m"]);
  });
});

describe("issues", () => {
  it("stand at their field in words, with what was found, expected and how to fix it", () => {
    const page = new Page(PLATE);
    page.issues = [makeIssue(["plate", "E"])];
    page.show(["plate"]);
    const field = page.field(["plate", "E"]);
    expect(field.querySelector(".messages")?.textContent).toBe(
      'Found "30", expected a pressure such as "30 MPa" — the unit is missing.',
    );
    expect(issueSentence(makeIssue(["x"], '"g"', "a load case", 'did you mean "G"?'))).toBe(
      'Found "g", expected a load case — did you mean "G"?',
    );
    expect(page.input(["plate", "E"]).getAttribute("aria-invalid")).toBe("true");
    page.issues = [];
    page.update();
    expect(field.querySelector(".messages")?.textContent).toBe("");
    expect(page.input(["plate", "E"]).hasAttribute("aria-invalid")).toBe(false);
  });

  it("of one value of a pair stand at the pair; of unknown keys and of a table itself at the table", () => {
    const page = new Page({ loads: [{ kind: "patch", q: "1 kPa", x: ["1", "2 m"], y: ["0 m", "1 m"] }] });
    page.issues = [
      makeIssue(["loads", 0, "x", 0]),
      makeIssue(["loads", 0, "colour"], '"red"', "no such key", ""),
      makeIssue(["loads", 0], "a load", "something else", ""),
    ];
    page.show(["loads", 0]);
    expect(page.field(["loads", 0, "x"]).classList.contains("faulty")).toBe(true);
    expect(document.querySelector("[data-part] > .messages")?.textContent).toContain("no such key");
    expect(issuesOfPart(page.issues, ["loads", 0], schema.part("PatchLoad"))).toHaveLength(2);
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
    page.issues = [makeIssue(["loads", 1, "P"])];
    const form = formPanel(page.ctx, { read: () => [], write: () => undefined });
    document.body.replaceChildren(form.element);
    form.update();
    expect(page.field(["loads", 1, "P"])).toBeNull();
    expect(form.reveal(["loads", 1, "P"])).toBe(true);
    expect(document.activeElement).toBe(page.input(["loads", 1, "P"]));
    expect(document.querySelector('[data-section="loads"] .badge')?.textContent).toBe("1");
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
