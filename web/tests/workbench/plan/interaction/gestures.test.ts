// @vitest-environment happy-dom
// The changes that dragging and drawing make.
import { describe, expect, it } from "vitest";
import { addPoint, addShape, outlineEdits } from "../../../../src/workbench/model/changes/new-items";
import { itemsOf } from "../../../../src/workbench/model/items";
import { freeName } from "../../../../src/workbench/model/names";
import type { Table } from "../../../../src/workbench/model/paths";
import { DrawGesture, MoveGesture, ReshapeGesture } from "../../../../src/workbench/plan/interaction/gestures";
import { handlesOf } from "../../../../src/workbench/plan/interaction/handles";
import { toolOf } from "../../../../src/workbench/plan/tools";
import { DATA, free } from "../../slab";

describe("dragging", () => {
  const items = itemsOf(DATA, null);
  const column = items.find((item) => item.kind === "column")!;

  it("is one edit that moves the item and says so", () => {
    const moving = new MoveGesture(column, [4.1, 1.05]);
    moving.moveTo(free([4.5, 1.2]));
    const preview = moving.moveTo(free([5, 1.25]));
    expect(preview.geometry).toMatchObject({ x: 5, y: 1.25 });
    expect(moving.change()).toEqual({
      edits: [{ op: "move", path: ["columns", 0], by: [1, 0.25] }],
      text: "move column A1",
    });
  });

  it("is no edit where nothing has moved", () => {
    const moving = new MoveGesture(column, [4, 1]);
    moving.moveTo(free([4, 1]));
    expect(moving.change()).toBeNull();
  });

  it("writes a circle's radius as a length", () => {
    const opening = items.find((item) => item.kind === "opening")!;
    const reshaping = new ReshapeGesture(opening, handlesOf(opening.geometry)[0]!);
    reshaping.moveTo(free([1.5, 1]));
    expect(reshaping.change()).toEqual({
      edits: [{ op: "length", path: ["plate", "openings", 0, "radius"], value: 0.5 }],
      text: "reshape opening 1",
    });
  });

  it("lets loads on a column stay with it", () => {
    const load = items.find((item) => item.kind === "load")!;
    expect(load).toMatchObject({ movable: false, geometry: { x: 4, y: 1 } });
    expect(items.filter((item) => item.kind === "load")).toHaveLength(1);
  });
});

describe("drawing", () => {
  const draw = (tool: Parameters<typeof toolOf>[0], ...clicks: [number, number][]) => {
    const drawing = new DrawGesture(toolOf(tool));
    for (const at of clicks) {
      if (drawing.down(at, 0.05)) break;
      drawing.up(at, 0.05);
    }
    return drawing.finish(DATA, "");
  };

  it("makes a rectangle of a drag", () => {
    const drawing = new DrawGesture(toolOf("opening"));
    drawing.down([4, 1.5], 0.05);
    expect(drawing.up([3, 0.5], 0.05)).toBe(true);
    expect(drawing.finish(DATA, "")?.change.edits).toEqual([
      {
        op: "add",
        path: ["plate", "openings"],
        value: { kind: "rectangle", x: ["3 m", "4 m"], y: ["0.5 m", "1.5 m"] },
      },
    ]);
  });

  it("makes a polygon of clicks that end at the first corner", () => {
    const made = draw("zone", [0, 0], [2, 0], [2, 2], [0.01, 0.01]);
    expect(made?.path).toEqual(["plate", "zones", 0]);
    expect(made?.change.edits[0]).toMatchObject({
      value: {
        thickness: "450 mm",
        shape: {
          kind: "polygon",
          points: [
            ["0 m", "0 m"],
            ["2 m", "0 m"],
            ["2 m", "2 m"],
          ],
        },
      },
    });
  });

  it("makes nothing of a rectangle without an area", () => {
    const drawing = new DrawGesture(toolOf("opening"));
    drawing.down([4, 1.5], 0.05);
    drawing.up([5, 1.5], 0.05);
    expect(drawing.finish(DATA, "")).toBeNull();
  });

  it("puts a point load on the column that is clicked, and gives columns new names", () => {
    expect(addPoint("point load", DATA, [4.1, 1.1], "live").change.edits[0]).toMatchObject({
      value: { kind: "point", column: "A1", case: "live" },
    });
    expect(addPoint("point load", DATA, [1, 1], "").change.edits[0]).toMatchObject({
      value: { x: "1 m", y: "1 m" },
    });
    expect(addPoint("column", DATA, [1, 3], "").change.edits[0]).toMatchObject({
      value: { name: "C1", width_x: "400 mm" },
    });
    expect(freeName(["C1", "C2"], "C1")).toBe("C3");
    expect(freeName(["wall"], "wall")).toBe("wall 2");
  });

  it("gives a load the size of the last one of its kind in the same case", () => {
    const loads = [
      { kind: "point", P: "-120 kN", case: "wind", x: "0 m", y: "0 m" },
      { kind: "line", q: "40 kN/m", case: "wind" },
    ];
    const sizeIn = (loadCase: string) =>
      addPoint("point load", { ...DATA, loads }, [1, 1], loadCase).change.edits[0] as { value: Table };
    expect([sizeIn("wind").value.P, sizeIn("live").value.P]).toEqual(["-120 kN", "100 kN"]);
  });

  it("replaces the sides by the outline that is drawn, and keeps the rest of the slab", () => {
    const data: Table = { plate: { length_x: "6 m", length_y: "4 m", thickness: "1 ft", E: "30 GPa", nu: 0.2 } };
    const made = addShape("slab", data, { kind: "rectangle", from: [0, 0], to: [3, 2] }, "");
    expect(made.change.edits.map((edit) => ("path" in edit ? [edit.op, edit.path.join(".")] : []))).toEqual([
      ["remove", "plate.length_x"],
      ["remove", "plate.length_y"],
      ["set", "plate.outline"],
    ]);
    expect(outlineEdits({}, { kind: "circle" }).length).toBe(4);
  });
});

describe("drawing a circle", () => {
  it("is dragged from its center to its edge", () => {
    const drawing = new DrawGesture(toolOf("opening"));
    drawing.down([1, 1], 0.01);
    drawing.round = true;
    expect(drawing.preview(free([4, 5])).geometry).toMatchObject({ type: "circle", center: [1, 1], radius: 5 });
    expect(drawing.up([4, 5], 0.01)).toBe(true);
    expect(drawing.finish(DATA, "")?.change.edits[0]).toMatchObject({
      path: ["plate", "openings"],
      value: { kind: "circle", centre: ["1 m", "1 m"], radius: "5 m" },
    });
  });
});
