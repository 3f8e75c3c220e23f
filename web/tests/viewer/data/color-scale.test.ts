import { describe, expect, it } from "vitest";
import { bandOf, type ColorScale, crossesZero, makeScale, roundLevels } from "../../../src/viewer/data/color-scale";
import { formatNumber, formatShort, formatTicks, multiplesWithin, roundStep } from "../../../src/viewer/data/numbers";
import { randoms } from "../synthetic";

/** The color that a value is drawn in. */
const colorOf = (scale: ColorScale, value: number) => {
  const band = bandOf(scale, value);
  return band < 0 ? scale.under : (scale.colors[band] ?? scale.over);
};

describe("round numbers", () => {
  it("are 1, 2, 2.5 or 5 times a power of ten", () => {
    expect([0.7, 1, 1.01, 2.2, 3, 6, 0.0011, 480].map(roundStep)).toEqual([1, 1, 2, 2.5, 5, 10, 0.002, 500]);
  });

  it("cover a range with few enough bands, without a band too many", () => {
    const random = randoms(1);
    for (let i = 0; i < 400; i++) {
      const low = (random() - 0.5) * 10 ** Math.floor(8 * random() - 4);
      const high = low + random() * 10 ** Math.floor(8 * random() - 4) + 1e-5 * Math.abs(low) + 1e-7;
      const levels = roundLevels(low, high, 14);
      const step = levels[1]! - levels[0]!;
      expect(levels.length - 1).toBeLessThanOrEqual(14);
      expect(levels.length - 1).toBeGreaterThan(4);
      expect(levels[0]!).toBeLessThanOrEqual(low + 1e-6 * step);
      expect(levels[1]!).toBeGreaterThan(low);
      expect(levels[levels.length - 1]!).toBeGreaterThanOrEqual(high - 1e-6 * step);
      expect(levels[levels.length - 2]!).toBeLessThan(high);
      expect(roundStep(step) / step).toBeCloseTo(1, 5);
    }
  });

  it("are written without the rounding of binary numbers", () => {
    expect(roundLevels(0, 1, 10)).toEqual([0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1]);
    expect(multiplesWithin(-0.31, 0.29, 0.1)).toEqual([-0.3, -0.2, -0.1, 0, 0.1, 0.2]);
    expect(formatTicks([-2.5, 0, 2.5])).toEqual(["−2.5", "0.0", "2.5"]);
    expect(formatTicks([0, 500, 1000])).toEqual(["0", "500", "1000"]);
    expect(formatTicks([-0.6, -0.3, -1.1e-17, 0.3, 0.6])).toEqual(["−0.6", "−0.3", "0.0", "0.3", "0.6"]);
    expect(formatTicks([0.1 + 0.2, 1e-17, 0.6])).toEqual(["0.3", "0.0", "0.6"]);
    expect(formatTicks([0, 1e-17, 2e-4])).toEqual(["0", "0", "0.000200"]);
  });
});

describe("a color scale", () => {
  it("parts at zero with two hues where the sign matters", () => {
    const scale = makeScale(-30, 100, true);
    expect(scale.diverging).toBe(true);
    expect(scale.levels).toContain(0);
    const [[below], [above]] = [[colorOf(scale, -5)], [colorOf(scale, 5)]];
    expect(below![2]).toBeGreaterThan(below![0]); // blue
    expect(above![0]).toBeGreaterThan(above![2]); // red
    // as far from zero, as dark
    const even = makeScale(-100, 100, true);
    const gray = ([red, green, blue]: number[]) => 0.3 * red! + 0.6 * green! + 0.1 * blue!;
    expect(Math.abs(gray(colorOf(even, -75)) - gray(colorOf(even, 75)))).toBeLessThan(40);
  });

  it("goes from dark to light where it does not", () => {
    for (const scale of [makeScale(0, 100, true), makeScale(-5, 100, false)]) {
      expect(scale.diverging).toBe(false);
      const light = scale.colors.map(([red, green, blue]) => 0.3 * red + 0.6 * green + 0.1 * blue);
      expect(light).toEqual([...light].sort((one, other) => one - other));
    }
  });

  it("puts each value into its band", () => {
    const scale = makeScale(0, 100, false);
    expect(scale.levels).toEqual([0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100]);
    expect([0, 9.99, 10, 55, 99.9, 100, 100.001, -0.001].map((value) => bandOf(scale, value))).toEqual([
      0, 0, 1, 5, 9, 9, 9, 0,
    ]);
    expect([-3, 104].map((value) => bandOf(scale, value))).toEqual([-1, 10]);
    expect(colorOf(scale, 104)).toEqual(scale.over);
    expect(colorOf(scale, -3)).toEqual(scale.under);
  });

  it("ends at its limits", () => {
    const scale = makeScale(0, 87, false, [0, 87]);
    expect(scale.levels[0]).toBe(0);
    expect(scale.levels[scale.levels.length - 1]).toBe(87);
    expect(bandOf(scale, 86.9)).toBe(scale.colors.length - 1);
    expect(bandOf(scale, 88)).toBe(scale.colors.length);
  });

  it("has bands even for a single value", () => {
    for (const value of [0, 5, -3e-9]) {
      const scale = makeScale(value, value, true);
      expect(scale.colors.length).toBeGreaterThan(0);
      expect(bandOf(scale, value)).toBeGreaterThanOrEqual(0);
      expect(bandOf(scale, value)).toBeLessThan(scale.colors.length);
    }
  });

  it("takes rounding for no sign", () => {
    expect(crossesZero(-1e-6, 10)).toBe(false);
    expect(crossesZero(-1, 10)).toBe(true);
    expect(crossesZero(-10, 0)).toBe(false);
  });
});

describe("numbers", () => {
  it("have four significant digits and a true minus", () => {
    expect([0, 123.456, -0.0123456, 98765.4, 1.5e7, 2e-6, NaN].map((value) => formatNumber(value))).toEqual([
      "0",
      "123.5",
      "−0.01235",
      "98765",
      "1.500e+7",
      "2.000e−6",
      "–",
    ]);
    expect([800, 0.5, 12.25, 100, 2000].map((value) => formatShort(value))).toEqual([
      "800",
      "0.5",
      "12.25",
      "100",
      "2000",
    ]);
  });
});
