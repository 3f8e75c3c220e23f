import { describe, expect, it } from "vitest";
import { type RowBox, rangeInView } from "../../../src/workbench/controls/virtual-rows";

const [HEIGHT, VIEW, COUNT] = [24, 310, 500];

/** A table scrolled so far [px]. */
function boxAt(scrollTop: number): RowBox {
  const scroller = { scrollTop, clientHeight: VIEW } as HTMLElement;
  return { scroller, head: {} as HTMLElement, height: HEIGHT, margin: 12 };
}

describe("the rows in the page", () => {
  const tops = Array.from({ length: COUNT * HEIGHT - VIEW }, (_, top) => top);

  it("cover what is in view wherever the table is scrolled to", () => {
    for (const top of tops) {
      const [first, last] = rangeInView(boxAt(top), COUNT);
      expect(first * HEIGHT).toBeLessThanOrEqual(top);
      expect(last * HEIGHT).toBeGreaterThanOrEqual(top + VIEW);
    }
  });

  it("stay while the table is scrolled by less than a few rows", () => {
    const ranges = new Set(tops.map((top) => String(rangeInView(boxAt(top), COUNT))));
    expect(ranges.size).toBeLessThanOrEqual(COUNT / 6 + 1);
    expect(rangeInView(boxAt(0), COUNT)).toEqual(rangeInView(boxAt(HEIGHT), COUNT));
  });
});
