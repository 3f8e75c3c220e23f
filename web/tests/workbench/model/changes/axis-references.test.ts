// @vitest-environment happy-dom
// References to axes, which follow what is done to the axes: in one change, thus one step of undo.
import { beforeEach, describe, expect, it, vi } from "vitest";
import { followAxes } from "../../../../src/workbench/model/changes/axis-references";
import { applyOptimistic } from "../../../../src/workbench/model/changes/optimistic-edits";
import { removeItem, removeItems } from "../../../../src/workbench/model/changes/references";
import type { Edit } from "../../../../src/workbench/model/edits";
import { itemsOf } from "../../../../src/workbench/model/items";
import { type Json, type Path, type Table, tableAt, valueAt } from "../../../../src/workbench/model/paths";
import { Page } from "../../form-page";

beforeEach(() => void vi.useFakeTimers());

const DATA: Table = {
  axes: [
    { kind: "straight", first: "A", distances: "2 x 6 m, 4500 mm" },
    { kind: "straight", first: "1", distances: "5 m", angle: 90 },
  ],
  columns: [
    { name: "C1", at: "B / 2", width_x: "400 mm", width_y: "400 mm" },
    { name: "C2", at: "1/D", width_x: "400 mm", width_y: "400 mm" },
    { name: "C3", x: "0 m", y: "0 m", width_x: "400 mm", width_y: "400 mm" },
  ],
  walls: [{ name: "W1", at: ["A/1", "B/1"], thickness: "250 mm" }],
  beams: [{ name: "B", at: ["A/2", "D/2"], width: "300 mm", depth: "600 mm" }],
  supports: [{ kind: "point", at: "C/1" }],
  loads: [
    { kind: "point", column: "C1", P: "1 kN" },
    { kind: "line", q: "1 kN/m", at: ["B/1", "B/2"] },
  ],
};

const POLAR: Table = {
  axes: [
    { kind: "ray", first: "1", angles: [0, 90, 180] },
    { kind: "ring", first: "A", distances: "2 m, 3 m" },
  ],
  columns: ["A/1", "A/2", "B/3"].map((at, n) => ({ name: `C${n}`, at, diameter: "400 mm" })),
};

const set = (path: Path, value: Json): Edit => ({ op: "set", path, value });
const done = (data: Table, ...edits: Edit[]) =>
  followAxes(data, { edits, text: "" }).edits.reduce(applyOptimistic, data);
const atOf = (data: Table, list: string, n = 0) => tableAt(data, [list, n]).at;
const placesOf = (data: Table) => itemsOf(data, null).map(({ geometry }) => ({ ...geometry, at: null }));

describe("references to axes", () => {
  it("get the new names of axes that count on from another first one, wherever they are", () => {
    const renamed = done(DATA, set(["axes", 0, "first"], "B"));
    expect([0, 1].map((n) => atOf(renamed, "columns", n))).toEqual(["C/2", "1/E"]);
    expect(atOf(renamed, "walls")).toEqual(["B/1", "C/1"]);
    expect(atOf(renamed, "beams")).toEqual(["B/2", "E/2"]);
    expect(atOf(renamed, "supports")).toBe("D/1");
    expect(atOf(renamed, "loads", 1)).toEqual(["C/1", "C/2"]);
    expect(placesOf(renamed)).toEqual(placesOf(DATA));
  });

  it("get names that are given instead of counting, and back", () => {
    const named = done(DATA, set(["axes", 0, "names"], ["W", "X", "Y", "Z"]));
    expect(atOf(named, "columns")).toBe("X/2");
    expect(atOf(done(named, { op: "remove", path: ["axes", 0, "names"] }), "columns")).toBe("B/2");
  });

  it("go where two axes get one name, so that swapped names move nothing", () => {
    const taken = done(DATA, set(["axes", 1, "first"], "B"));
    expect([0, 1].map((n) => atOf(taken, "columns", n))).toEqual([undefined, undefined]);
    const swapped = done(DATA, set(["axes", 0, "first"], "1"), set(["axes", 1, "first"], "A"));
    for (const data of [taken, swapped]) expect(placesOf(data)).toEqual(placesOf(DATA));
  });

  it("stay where names cannot be read, or are those of several axes", () => {
    const same = (data: Table, edit: Edit) =>
      expect(followAxes(data, { edits: [edit], text: "" }).edits).toEqual([edit]);
    same(DATA, set(["axes", 1, "first"], "X/"));
    same(DATA, set(["axes", 0, "distances"], "6 metres"));
    same(POLAR, set(["axes", 0, "angles"], [0, "x", 180]));
    same(applyOptimistic(DATA, set(["axes", 1, "first"], "A")), set(["axes", 1, "first"], "1"));
    same(DATA, set(["axes", 0, "distances"], "3 x 6 m"));
    same(DATA, set(["columns", 0, "at"], "B/1"));
  });

  it("become places where their axes are removed with their family, in one change", () => {
    const change = followAxes(DATA, removeItem(DATA, ["axes", 1]));
    const removed = change.edits.reduce(applyOptimistic, DATA);
    expect(valueAt(removed, ["axes"])).toHaveLength(1);
    expect(tableAt(removed, ["columns", 0])).toMatchObject({ x: "6 m", y: "5 m" });
    expect(tableAt(removed, ["columns", 0]).at).toBeUndefined();
    expect(placesOf(removed)).toEqual(placesOf(DATA));
    const none = followAxes(
      DATA,
      removeItems(DATA, [
        ["axes", 0],
        ["axes", 1],
      ]),
    ).edits.reduce(applyOptimistic, DATA);
    expect(placesOf(none)).toEqual(placesOf(DATA));
  });

  it("become places if one of several axes goes, and what is attached to the others stays", () => {
    const shorter = done(DATA, set(["axes", 0, "distances"], "2 x 6 m"));
    expect(tableAt(shorter, ["columns", 1])).toMatchObject({ x: "16.5 m", y: "0 m" });
    expect(atOf(shorter, "columns")).toBe("B / 2");
    // axis B goes: what was on C is attached to the one that is now called B
    const without = done(DATA, set(["axes", 0, "distances"], "12 m, 4.5 m"));
    expect(tableAt(without, ["columns", 0])).toMatchObject({ x: "6 m", y: "5 m" });
    expect(atOf(without, "columns", 1)).toBe("1/C");
    expect(atOf(without, "supports")).toBe("B/1");
    expect(placesOf(without)).toEqual(placesOf(DATA));
  });

  it("follow rays of which one goes or comes, and rings", () => {
    const fewer = done(POLAR, set(["axes", 0, "angles"], [0, 180]));
    expect(tableAt(fewer, ["columns", 1])).toMatchObject({ x: "0 m", y: "2 m" });
    expect(atOf(fewer, "columns", 2)).toBe("B/2");
    const more = done(POLAR, set(["axes", 0, "angles"], [0, 45, 90, 180]));
    expect([0, 1, 2].map((n) => atOf(more, "columns", n))).toEqual(["A/1", "A/3", "B/4"]);
    expect(placesOf(more)).toEqual(placesOf(POLAR));
    const inner = done(POLAR, set(["axes", 1, "distances"], "5 m"));
    expect(placesOf(inner)).toEqual(placesOf(POLAR));
  });

  it("stay with what moves", () => {
    expect(atOf(done(POLAR, set(["axes", 0, "angles"], [0, 80, 180])), "columns", 1)).toBe("A/2");
    expect(atOf(done(POLAR, set(["axes", 1, "distances"], "2 m, 2.5 m")), "columns", 2)).toBe("B/3");
  });

  it("follow names that are typed into a form, when these are complete", () => {
    const page = new Page(DATA);
    page.show(["axes", 0]);
    page.type(["axes", 0, "first"], "P");
    vi.advanceTimersByTime(2000);
    expect(page.changes).toHaveLength(0);
    page.input(["axes", 0, "first"]).dispatchEvent(new Event("change"));
    expect(page.changes).toHaveLength(1);
    expect(atOf(followAxes(DATA, page.changes[0]!).edits.reduce(applyOptimistic, DATA), "columns")).toBe("Q/2");
  });
});
