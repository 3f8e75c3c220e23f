// Labels cover nothing; some are kept.
import { expect, it } from "vitest";
import type { Box } from "../../../src/viewer/data/boxes";
import { type LabelWish, placeLabels, TakenBoxes } from "../../../src/viewer/data/label-placement";
import type { Point } from "../../../src/viewer/data/scene";
import { randoms } from "../synthetic";

const LIMITS: Box = [0, 0, 800, 500];

/** 700 labels on a small picture, the first two of which are kept; the places of every label are beside one spot. */
function crowd(seed: number): LabelWish[] {
  const random = randoms(seed);
  return Array.from({ length: 700 }, (_, n) => {
    const [x, y] = [random() * 800, random() * 500];
    const size: Point = [20 + 60 * random(), 15];
    return {
      size,
      places: [
        [x, y],
        [x - size[0] - 8, y],
        [x, y - 15],
      ] as Point[],
      kept: n < 2,
    };
  });
}

it.each([1, 2, 3, 4, 5])("no two labels cover each other or what is taken, and all are in the picture (%i)", (seed) => {
  const wishes = crowd(seed);
  const taken = new TakenBoxes();
  const column: Box = [300, 200, 360, 260];
  taken.add(column);
  const boxes = placeLabels(wishes, LIMITS, taken).flatMap((place, n): Box[] => {
    const [width, height] = wishes[n]!.size;
    return place ? [[place[0], place[1], place[0] + width, place[1] + height]] : [];
  });
  const all = [...boxes, column];
  const covering = all.flatMap((a, i) =>
    all.slice(i + 1).filter((b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]),
  );
  expect(covering).toEqual([]);
  expect(boxes.every(([x0, y0, x1, y1]) => x0 >= 0 && y0 >= 0 && x1 <= 800 && y1 <= 500)).toBe(true);
  expect(boxes.length).toBeGreaterThan(60);
});

it("labels that are kept have a place though all of theirs are taken or outside; others have none", () => {
  const taken = new TakenBoxes();
  taken.add([0, 0, 200, 200]);
  const wish = (kept: boolean): LabelWish => ({ size: [50, 15], places: [[-30, 20]], kept });
  const [first, second, third] = placeLabels([wish(true), wish(true), wish(false)], LIMITS, taken);
  expect(third).toBeNull();
  expect(first).not.toBeNull();
  expect(second).not.toBeNull();
  expect(first).not.toEqual(second);
});
