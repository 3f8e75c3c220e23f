// The box of the tour never covers what it points at, and stays in the window.
import { expect, test } from "vitest";
import { placeBeside } from "../../../src/workbench/help/placement";

const SIZE = [320, 180] as const;
const WINDOW = [1280, 650] as const;

test.each([
  ["on the left", { left: 10, top: 100, right: 100, bottom: 130 }],
  ["on the right", { left: 1180, top: 5, right: 1270, bottom: 35 }],
  ["at the right foot", { left: 1100, top: 600, right: 1270, bottom: 640 }],
  ["across the top", { left: 0, top: 0, right: 1280, bottom: 44 }],
  ["at the right, as high as the window", { left: 1000, top: 0, right: 1280, bottom: 650 }],
])("a control %s", (_, control) => {
  const [left, top] = placeBeside(control, SIZE, WINDOW);
  expect(left >= 0 && left + SIZE[0] <= WINDOW[0] && top >= 0 && top + SIZE[1] <= WINDOW[1]).toBe(true);
  const isApart =
    left >= control.right || left + SIZE[0] <= control.left || top >= control.bottom || top + SIZE[1] <= control.top;
  expect(isApart).toBe(true);
});

test("without a control, or beside one that fills the window, it stands in the middle", () => {
  expect(placeBeside(null, SIZE, WINDOW)).toEqual([480, 235]);
  expect(placeBeside({ left: 0, top: 0, right: 1280, bottom: 650 }, SIZE, WINDOW)).toEqual([480, 235]);
});
