// Axes that are dragged, and where what is attached to them then is.
import { describe, expect, it } from "vitest";
import { axesIn } from "../../../../src/workbench/model/axes";
import { applyOptimistic } from "../../../../src/workbench/model/changes/optimistic-edits";
import type { Point } from "../../../../src/workbench/model/geometry";
import { itemsOf } from "../../../../src/workbench/model/items";
import type { Table } from "../../../../src/workbench/model/paths";
import { AxisGesture } from "../../../../src/workbench/plan/interaction/axis-gesture";

const GRID: Table = {
  axes: [
    { kind: "straight", first: "A", distances: "2 x 6 m" },
    { kind: "straight", first: "1", distances: "5 m", angle: 90 },
  ],
  columns: [{ name: "C1", at: "B/2", width_x: "400 mm", width_y: "400 mm" }],
};
const POLAR: Table = {
  axes: [
    { kind: "ray", first: "1", centre: ["1 m", "1 m"], angles: [0, 90, 350] },
    { kind: "ring", first: "A", centre: ["1 m", "1 m"], distances: "2 m, 3 m" },
  ],
  columns: [{ name: "C1", at: "A/2", diameter: "400 mm" }],
};

function grip(data: Table, name: string, start: Point): AxisGesture {
  return new AxisGesture(data, axesIn(data).find((axis) => axis.name === name)!, start);
}

/** Return the place of the column after what a gesture makes. */
function columnAfter(data: Table, gesture: AxisGesture) {
  const [column] = itemsOf(gesture.edits.reduce(applyOptimistic, data), null).filter(({ kind }) => kind === "column");
  const { x, y } = column!.geometry as { x: number; y: number };
  return [Number(x.toFixed(9)), Number(y.toFixed(9))];
}

describe("an axis that is dragged", () => {
  it("moves by round distances from its neighbor, or where Alt is held by millimeters", () => {
    const gesture = grip(GRID, "B", [6.03, 8]);
    expect(gesture.moveTo([6.56, 8.4], 0.1, false)).toBe(true);
    expect(gesture.text).toBe("A – B: 6.5 m");
    expect(gesture.change()).toEqual({
      edits: [{ op: "set", path: ["axes", 0, "distances"], value: "6.5 m, 5.5 m" }],
      text: "move axis B",
    });
    expect(columnAfter(GRID, gesture)).toEqual([6.5, 5]);
    gesture.moveTo([6.0424, 8.4], 0.1, true);
    expect(gesture.text).toBe("A – B: 6.012 m");
  });

  it("stays before its neighbors, and where it was is no change", () => {
    const gesture = grip(GRID, "B", [6, 8]);
    expect(gesture.moveTo([13, 8], 0.1, false)).toBe(false);
    expect(gesture.moveTo([6.04, 8], 0.1, false)).toBe(true);
    expect(gesture.change()).toBeNull();
  });

  it("takes its origin along if it is the first, whose distance is that to the next", () => {
    const gesture = grip(GRID, "1", [-1, 0]);
    gesture.moveTo([-1, -0.5], 0.1, false);
    expect(gesture.text).toBe("1 – 2: 5.5 m");
    expect(gesture.edits).toContainEqual({ op: "set", path: ["axes", 1, "origin"], value: ["0 m", "-0.5 m"] });
    expect(columnAfter(GRID, gesture)).toEqual([6, 5]);
  });

  it("turns by whole degrees if it is a ray, also over the direction of x", () => {
    const gesture = grip(POLAR, "2", [1, 9]);
    gesture.moveTo([1 - 8 * Math.sin(Math.PI / 6), 1 + 8 * Math.cos(Math.PI / 6)], 0.1, false);
    expect(gesture.text).toBe("2: 120°");
    expect(gesture.change()?.text).toBe("turn axis 2");
    expect(columnAfter(POLAR, gesture)).toEqual([0, Number((1 + Math.sqrt(3)).toFixed(9))]);
    const last = grip(POLAR, "3", [2, 1 - Math.tan(Math.PI / 18)]);
    last.moveTo([2, 1 + Math.tan(Math.PI / 18)], 0.1, false);
    expect(last.edits).toEqual([{ op: "set", path: ["axes", 0, "angles"], value: [0, 90, 10] }]);
  });

  it("gets another radius if it is a ring, from wherever it is held", () => {
    const gesture = grip(POLAR, "A", [1, -1]);
    gesture.moveTo([1.5, -2.03], 0.1, false);
    expect(gesture.text).toBe("A: R = 3.1 m");
    expect(gesture.edits).toEqual([{ op: "set", path: ["axes", 1, "distances"], value: "3.1 m, 1.9 m" }]);
    expect(columnAfter(POLAR, gesture)).toEqual([1, 4.1]);
    expect(gesture.moveTo([1, -4.5], 0.1, false)).toBe(false);
  });

  it("takes what is typed: a distance, a radius or an angle", () => {
    const typed = (data: Table, name: string, text: string) => {
      const gesture = grip(data, name, [0, 0]);
      return gesture.type(text) ? gesture.text : gesture.refusal(text);
    };
    expect(typed(GRID, "C", "7,25")).toBe("B – C: 7.25 m");
    expect(typed(GRID, "A", "450 cm")).toBe("A – B: 4.5 m");
    expect(typed(POLAR, "B", "6")).toBe("B: R = 6 m");
    expect(typed(POLAR, "2", "-30")).toBe("2: -30°");
    expect(typed(POLAR, "2", "45 m")).toBe('Found "45 m", expected an angle such as 30.');
    expect(typed(GRID, "B", "13")).toBe('Found "13", expected a length such as 3.5 that ends before the next axis.');
  });
});
