// @vitest-environment happy-dom
// Names that other parts of the file refer to.
import { beforeEach, describe, expect, it, vi } from "vitest";
import { applyOptimistic } from "../../../../src/workbench/model/changes/optimistic-edits";
import { removeItem, renameReferences } from "../../../../src/workbench/model/changes/references";
import { type Path, type Table, valueAt } from "../../../../src/workbench/model/paths";
import { Page } from "../../form-page";

beforeEach(() => void vi.useFakeTimers());

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
    expect(renameReferences(data, ["columns", 0, "name"], "B2")).toEqual([
      { op: "set", path: ["loads", 0, "column"], value: "B2" },
      { op: "set", path: ["loads", 2, "column"], value: "B2" },
    ]);
    expect(renameReferences(data, ["cases", 0, "name"], "permanent")).toContainEqual({
      op: "set",
      path: ["combinations", 0, "factors"],
      value: { permanent: 1.35, live: 1.5 },
    });
  });

  it("are those of walls, which go with the loads on them", () => {
    const walled: Table = {
      walls: [{ name: "W1", thickness: "25 cm" }, { name: "W2" }],
      loads: [
        { kind: "line", q: "20 kN/m", wall: "W1" },
        { kind: "line moment", m: "1 kNm/m", wall: "W1" },
        { kind: "line", q: "20 kN/m", wall: "W2" },
      ],
    };
    const renamed = renameReferences(walled, ["walls", 0, "name"], "core");
    expect(renamed.map((edit) => ("path" in edit ? edit.path : []))).toEqual([
      ["loads", 0, "wall"],
      ["loads", 1, "wall"],
    ]);
    const { edits, text } = removeItem(walled, ["walls", 0]);
    expect(text).toBe("remove wall W1 and its 2 loads");
    expect(edits.map((edit) => ("path" in edit ? edit.path : []))).toEqual([
      ["loads", 1],
      ["loads", 0],
      ["walls", 0],
    ]);
  });

  it("are those of walls in cores, and of cores, which go with their loads", () => {
    const cored: Table = {
      walls: [{ name: "W1" }, { name: "W2" }],
      cores: [{ name: "K", walls: ["W1", "W2"] }],
      loads: [{ kind: "core", core: "K", P: "1 MN" }],
    };
    expect(renameReferences(cored, ["walls", 1, "name"], "stairs")).toEqual([
      { op: "set", path: ["cores", 0, "walls", 1], value: "stairs" },
    ]);
    expect(renameReferences(cored, ["cores", 0, "name"], "lift")).toEqual([
      { op: "set", path: ["loads", 0, "core"], value: "lift" },
    ]);
    const pathsOf = (path: Path) => removeItem(cored, path).edits.map((edit) => ("path" in edit ? edit.path : []));
    expect(pathsOf(["walls", 0])).toEqual([
      ["cores", 0, "walls", 0],
      ["walls", 0],
    ]);
    expect(pathsOf(["cores", 0])).toEqual([
      ["cores", 0],
      ["loads", 0],
    ]);
  });

  it("are changed in paths of vehicles, too", () => {
    const moved: Table = {
      cases: [{ name: "truck" }],
      patterns: [{ kind: "vehicle", name: "forklift", wheels: [{ P: "45 kN" }] }],
      moves: [{ pattern: "forklift", case: "truck", points: [["0 m", "0 m"]] }],
    };
    expect(renameReferences(moved, ["patterns", 0, "name"], "reach truck")).toEqual([
      { op: "set", path: ["moves", 0, "pattern"], value: "reach truck" },
    ]);
    expect(renameReferences(moved, ["cases", 0, "name"], "traffic")).toEqual([
      { op: "set", path: ["moves", 0, "case"], value: "traffic" },
    ]);
  });

  it("are not joined with a name that is taken", () => {
    expect(
      renameReferences({ ...data, columns: [{ name: "A1" }, { name: "A" }] }, ["columns", 0, "name"], "A"),
    ).toEqual([]);
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
    const change = removeItem(data, ["columns", 0]);
    expect(change.text).toBe("remove column A1 and its 2 loads");
    expect(change.edits.reduce(applyOptimistic, data).loads).toEqual([{ kind: "uniform", case: "dead" }]);
  });
});
