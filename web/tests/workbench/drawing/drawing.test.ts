// @vitest-environment happy-dom
// Drawings: what is chosen of their layers, and their lines below the plan.
import { describe, expect, it } from "vitest";
import { Camera } from "../../../src/viewer/plan/camera";
import { askAboutDrawing } from "../../../src/workbench/drawing/drawing-dialog";
import { isDrawing } from "../../../src/workbench/drawing/open-drawing";
import { fillAsNew } from "../../../src/workbench/model/changes/new-items";
import { applyOptimistic } from "../../../src/workbench/model/changes/optimistic-edits";
import type { Table } from "../../../src/workbench/model/paths";
import {
  boundsOfLayers,
  centeringOffset,
  contentText,
  type DrawingChoice,
  enlargement,
  findProblem,
  type Layer,
  type Survey,
  type Underlay,
  unitsFor,
} from "../../../src/workbench/model/survey";
import { UnderlayLines } from "../../../src/workbench/plan/underlay/underlay-lines";

const layer = (name: string, more: Partial<Layer> = {}): Layer => ({
  name,
  role: null,
  hidden: false,
  kinds: { LINE: 1 },
  lines: [],
  curves: [],
  points: [],
  ...more,
});
const SLAB = layer("SLAB", { lines: [[0, 0, 6, 0, 6, 4, 0, 4, 0, 0]] });
const AXIS = layer("AXIS", { lines: [[1, -1, 5, 5]], points: [9, 2] });
const HIDDEN = layer("OLD", { hidden: true, lines: [[-50, 0, -40, 0]] });
const SURVEY: Survey = { unit: "mm", scale: 0.001, layers: [SLAB, AXIS, HIDDEN], remarks: [] };
const UNDERLAY: Underlay = { name: "plan.dxf", survey: SURVEY, unit: "mm", offset: [0, 0], shown: true };

describe("a drawing", () => {
  it("is a file that ends so, in any letters", () => {
    expect(["a.dxf", "/b/C.DXF", "a.dxf.toml", "dxf"].map(isDrawing)).toEqual([true, true, false, false]);
  });

  it("offers its own unit, and is enlarged by another", () => {
    expect(unitsFor(SURVEY)).toEqual(["mm", "cm", "m", "in", "ft"]);
    expect(unitsFor({ ...SURVEY, unit: "yd" })[0]).toBe("yd");
    expect(enlargement(SURVEY, "mm")).toBe(1);
    expect(enlargement(SURVEY, "cm")).toBeCloseTo(10, 12);
    expect(enlargement({ ...SURVEY, unit: "m", scale: 1 }, "ft")).toBe(0.3048);
  });

  it("says what its layers have, and where they are", () => {
    expect(contentText(layer("A", { kinds: { LINE: 12, TEXT: 2 } }))).toBe("12 LINE, 2 TEXT");
    expect(boundsOfLayers([SLAB, AXIS])).toEqual([0, -1, 9, 5]);
    expect(boundsOfLayers([layer("A")])).toBeNull();
  });

  it("needs a unit and an outline", () => {
    const choice: DrawingChoice = {
      layers: { SLAB: "outline" },
      unit: "mm",
      centered: false,
      gap: "1 mm",
      union: false,
    };
    expect(findProblem(choice)).toBe("");
    expect(findProblem({ ...choice, layers: { SLAB: "columns" } })).toBe("Choose the layer with the outline.");
    expect(findProblem({ ...choice, unit: "" })).toContain("unit");
  });
});

it("becomes a case with concrete, ground and self-weight, but for those that are there", () => {
  const data = { plate: { E: "33 GPa", thickness: "400 mm" } };
  const made = fillAsNew(data).edits.reduce<Table>(applyOptimistic, data);
  expect(made).toMatchObject({ plate: { E: "33 GPa", nu: 0.2 }, ground: { kind: "vlasov" } });
  expect(made.loads).toEqual([{ kind: "self weight", unit_weight: "25 kN/m^3" }]);
});

describe("the dialog", () => {
  const choose = (label: string, value: string) => {
    const select = document.querySelector<HTMLSelectElement>(`[aria-label="content of layer ${label}"]`)!;
    select.value = value;
    select.dispatchEvent(new Event("change", { bubbles: true }));
  };
  const message = () => document.querySelector(".drawing-form .messages")!.textContent;

  it("asks for what is missing, stays open where the server refuses, and closes when a case was made", async () => {
    const made: DrawingChoice[] = [];
    const answers = ["No outline.", ""];
    const survey = { ...SURVEY, unit: null };
    const closed = askAboutDrawing("plan.dxf", survey, {
      makeCase: async (choice) => {
        made.push(choice);
        return answers.shift()!;
      },
      showBelow: () => undefined,
    });
    expect(message()).toContain("Choose the drawing's unit");
    const unit = document.querySelector<HTMLSelectElement>(".drawing-settings select")!;
    unit.value = "cm";
    choose("SLAB", "outline");
    choose("AXIS", "line_loads");
    expect(message()).toBe("");
    expect(document.querySelector('.drawing-preview [data-layer="AXIS"]')!.getAttribute("data-role")).toBe(
      "line_loads",
    );
    const submit = () => document.querySelector("form")!.dispatchEvent(new Event("submit", { cancelable: true }));
    submit();
    await new Promise((resolve) => setTimeout(resolve));
    expect(message()).toBe("No outline.");
    submit();
    await closed;
    expect(document.querySelector("dialog")).toBeNull();
    const choice = {
      layers: { SLAB: "outline", AXIS: "line_loads" },
      unit: "cm",
      centered: false,
      gap: "1 mm",
      union: false,
    };
    expect(made).toEqual([choice, choice]);
  });
});

describe("an underlay", () => {
  it("has ends and intersections of its lines near a place, of layers that are shown", () => {
    const lines = new UnderlayLines(UNDERLAY);
    expect(lines.placesNear([6.1, -0.1], 0.2).map(({ at, name }) => [name, ...at])).toEqual([
      ["end", 6, 0],
      ["end", 6, 0],
    ]);
    // from (1, -1) to (5, 5): it crosses y = 0 at x = 1 + 4/6
    const [crossing] = lines.placesNear([1.7, 0], 0.1);
    expect(crossing!.name).toBe("intersection");
    expect(crossing!.at[0]).toBeCloseTo(1 + 4 / 6, 12);
    expect(crossing!.at[1]).toBeCloseTo(0, 12);
    expect(lines.placesNear([-40, 0], 1)).toEqual([]);
    expect(lines.placesNear([3, 2.2], 0.1)).toEqual([]);
  });

  it("has the ends of curves, but nothing on their chords", () => {
    const door = layer("DOOR", { lines: [[0, 0, 1, 0]], curves: [[1, 0, 0.7, 0.7, 0, 1]] });
    const axis = layer("AXIS", { lines: [[0.5, -1, 0.5, 3]] });
    const lines = new UnderlayLines({ ...UNDERLAY, survey: { ...SURVEY, layers: [door, axis] } });
    expect(lines.placesNear([0, 1], 0.1)).toEqual([{ at: [0, 1], name: "end" }]);
    expect(lines.placesNear([0.7, 0.7], 0.1)).toEqual([]);
    expect(lines.placesNear([0.5, 0.79], 0.1)).toEqual([]); // where the axis crosses a chord
    expect(lines.placesNear([0.5, 0], 0.1)).toEqual([{ at: [0.5, 0], name: "intersection" }]);
    expect(lines.draw(new Camera()).getAttribute("d")!.split("M")).toHaveLength(4);
  });

  it("lies where its offset says, in its unit", () => {
    const moved: Underlay = { ...UNDERLAY, unit: "cm", offset: [100, -20] };
    const lines = new UnderlayLines(moved);
    expect(lines.bounds).toEqual([100, -30, 160, 30]);
    expect(lines.placesNear([160, 20], 0.1)[0]!.at).toEqual([160, 20]);
    const offset = centeringOffset(SURVEY, "cm");
    expect(new UnderlayLines({ ...moved, offset }).bounds).toEqual([-45, -30, 15, 30]);
  });

  it("draws one path that the camera moves", () => {
    const camera = Object.assign(new Camera(), { width: 200, height: 100, scale: 10 });
    const lines = new UnderlayLines({ ...UNDERLAY, offset: [5_000_000, 0] });
    const path = lines.draw(camera);
    expect(path.getAttribute("d")!.startsWith("M0.00000 0.00000L6.00000 0.00000")).toBe(true);
    expect(path.getAttribute("transform")).toBe("matrix(10 0 0 -10 50000100 50)");
    expect(lines.draw(camera)).toBe(path);
  });
});
