import { describe, expect, it } from "vitest";

import { alongAxis, typedPlace, typeKey } from "../../../../src/workbench/plan/interaction/typed-input";

describe("what is typed while drawing", () => {
  it("is a place, with a point or a comma as decimal sign", () => {
    for (const text of ["2.5;-3", "2,5;-3", "2.5, -3", "250 cm; -3 m"])
      expect(typedPlace(text, null, null), text).toEqual([2.5, -3]);
  });
  it("is a length from the last place towards the pointer", () => {
    expect(typedPlace("3.5", [1, 1], [1, 5])).toEqual([1, 4.5]);
    expect(typedPlace("3,5", [1, 1], [-9, 1])).toEqual([-2.5, 1]);
    expect(typedPlace("10 m", [0, 0], [3, 4])).toEqual([6, 8]);
  });
  it("is nothing without a direction, or as any other text", () => {
    expect(typedPlace("3.5", null, [1, 5])).toBeNull();
    expect(typedPlace("3.5", [1, 1], [1, 1])).toBeNull();
    for (const text of ["", "-2", "0", "1;2;3", "2 kN", ";"]) expect(typedPlace(text, [0, 0], [1, 0]), text).toBeNull();
  });
  it("goes along an axis where the pointer is nearly in line, else towards it", () => {
    expect(alongAxis([1, 2], [6, 2.4])).toEqual([6, 2]);
    expect(alongAxis([1, 2], [0.9, -3])).toEqual([1, -3]);
    expect(alongAxis([1, 2], [4, 6])).toEqual([4, 6]);
    expect(alongAxis([1, 2], [1, 2])).toEqual([1, 2]);
  });
  it("starts with a number, so that letters choose tools", () => {
    expect(typeKey("", "c")).toBeNull();
    expect(["2", " ", "c", "m", ";", "-", "1"].reduce((text, key) => typeKey(text, key) ?? "", "")).toBe("2 cm;-1");
    expect([typeKey("12", "Backspace"), typeKey("", "Backspace"), typeKey("1", "Enter")]).toEqual(["1", null, null]);
  });
});
