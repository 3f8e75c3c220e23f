// Decimal commas and units of what is typed.
import { expect, test } from "vitest";
import { parseInput, parseTyped, replaceDecimalComma, unitIn } from "../../../src/workbench/model/quantities";

const LENGTH = { is: "quantity", dimension: "length", examples: ["0.2 m"], options: [] } as const;
const NUMBER = { is: "number", options: ["auto"] } as const;

test.each([
  ["1,5 m", "1.5 m"],
  ["-0,25", "-0.25"],
  [",5 m", ".5 m"],
  ["1,5e3 Pa", "1.5e3 Pa"],
  ["0,250 m", "0.250 m"],
  ["1500,250 m", "1500.250 m"],
  ["1,5000", "1.5000"],
])("the comma in %s is a decimal one", (typed, expected) => {
  expect(replaceDecimalComma(typed)).toBe(expected);
});

test.each(["1,500", "1,500 m", "-12,345 kN", "999,000", "1,234,567", "1,234.5", "1.234,5", "1,", "a,5"])(
  "%s is not guessed",
  (typed) => {
    expect(replaceDecimalComma(typed)).toBe(typed);
  },
);

test("a bare number takes the unit that stood there, and none is guessed", () => {
  expect(unitIn("250 mm")).toBe("mm");
  expect(unitIn("20 MPa/m")).toBe("MPa/m");
  expect(unitIn("1e-5 1/K")).toBe("1/K");
  expect(unitIn("250mm")).toBe("mm");
  expect(unitIn("1e5")).toBe("");
  expect(unitIn("5 %")).toBe("%");
  expect(unitIn(0.2)).toBe("");
  expect(parseInput(LENGTH, "300", "mm")).toBe("300 mm");
  expect(parseInput(LENGTH, "0,3", "m")).toBe("0.3 m");
  expect(parseInput(LENGTH, "0.3 m", "mm")).toBe("0.3 m");
  expect(parseInput(LENGTH, "300")).toBe("300");
  expect(parseInput(LENGTH, "1,500", "mm")).toBe("1,500");
  expect(parseInput(LENGTH, " ", "mm")).toBeUndefined();
});

test("numbers are numbers, and words stay words", () => {
  expect(parseInput(NUMBER, "0,2")).toBe(0.2);
  expect(parseInput(NUMBER, "1,500")).toBe("1,500");
  expect(parseInput(NUMBER, "auto")).toBe("auto");
  expect(parseInput({ is: "text" }, "Raft 1,5")).toBe("Raft 1,5");
});

test("a length that is typed in the plan reads the comma as fields do", () => {
  expect(parseTyped("2,5")).toBe(2.5);
  expect(parseTyped("0,250 m")).toBe(0.25);
  expect(parseTyped("350 cm")).toBe(3.5);
  expect(parseTyped("1,500")).toBeNull();
});
