// Color scales: bands with round limits, color maps that color-blind readers can tell apart.

import { type Rgb, rgbOf } from "../shared/palette";
import { roundMultiple, roundStep } from "./numbers";

export interface ColorScale {
  levels: number[]; // limits of the bands, ascending, one more than there are bands
  origin: number; // band i goes from origin + i step to origin + (i + 1) step, cut to the levels
  step: number;
  colors: Rgb[]; // of the bands
  diverging: boolean; // two hues that part at zero
  over: Rgb; // color of values above the last level
  under: Rgb; // and below the first
  min: number; // of the values shown
  max: number;
}

const colorMap = (text: string): Rgb[] => text.split(" ").map((hex) => rgbOf(`#${hex}`));
/** Viridis (van der Walt and Smith 2015), at even distances. */
const VIRIDIS = colorMap(
  "440154 48186a 472d7b 424086 3b528b 33638d 2c728e 26828e 21918c 1fa088 28ae80 3fbc73 5ec962 84d44b addc30 d8e219 fde725",
);
/** Blue, white, red: ColorBrewer's RdBu (Brewer 2003) reversed, so that uplift is blue. */
const BLUE_RED = colorMap("053061 2166ac 4393c3 92c5de d1e5f0 f7f7f7 fddbc7 f4a582 d6604d b2182b 67001f");
const OVER: Rgb = [179, 0, 0];
const UNDER: Rgb = [120, 120, 120];
/** Part of a band by which a value must lie beyond the scale to be shown so, because packed values are rounded. */
export const BEYOND = 2e-3;

/** Return round numbers at one distance, at most `most` intervals, from at or below low to at or above high. */
export function roundLevels(low: number, high: number, most: number): number[] {
  if (!(high - low > 1e-9 * Math.max(Math.abs(low), Math.abs(high)))) {
    const half = Math.abs(low) * 0.5 || 0.5;
    [low, high] = [low - half, low + half];
  }
  for (let least = (high - low) / most; ; least *= 1.01) {
    const step = roundStep(least);
    const [first, last] = [Math.floor(low / step + 1e-9), Math.ceil(high / step - 1e-9)];
    if (last - first <= most) return Array.from({ length: last - first + 1 }, (_, i) => roundMultiple(first + i, step));
  }
}

/**
 * Return the color scale of values from min to max.
 *
 * `signed` fields that cross zero get two hues that part there. `range` is where the scale begins and ends if that is
 * given; values beyond it have colors of their own.
 */
export function makeScale(
  min: number,
  max: number,
  signed: boolean,
  range?: readonly [number, number],
  most = 14,
): ColorScale {
  const [low, high] = range ?? [min, max];
  const diverging = signed && crossesZero(low, high);
  const levels = roundLevels(low, high, most);
  const [origin, step] = [levels[0]!, (levels.at(-1)! - levels[0]!) / (levels.length - 1)];
  if (range) {
    // a given scale ends at its limits, not at the next round number
    levels[0] = Math.max(levels[0]!, low);
    levels[levels.length - 1] = Math.min(levels.at(-1)!, high);
  }
  const [first, last] = [levels[0]!, levels.at(-1)!];
  const reach = Math.max(Math.abs(first), Math.abs(last));
  const colors = levels.slice(1).map((upper, i): Rgb => {
    const middle = (levels[i]! + upper) / 2;
    return diverging ? blend(BLUE_RED, (middle / reach + 1) / 2) : blend(VIRIDIS, (middle - first) / (last - first));
  });
  return { levels, origin, step, colors, diverging, over: OVER, under: UNDER, min, max };
}

/** Whether a range goes below zero and above it by more than rounding. */
export function crossesZero(low: number, high: number): boolean {
  const small = 1e-4 * Math.max(Math.abs(low), Math.abs(high));
  return low < -small && high > small;
}

/** Return the band of a value: -1 below the scale, the number of bands above it. */
export function bandOf(scale: ColorScale, value: number): number {
  const { levels, origin, step } = scale;
  const count = levels.length - 1;
  // what is beyond the scale by rounding only belongs to its last band
  const small = BEYOND * step;
  if (value < levels[0]! - small) return -1;
  if (value > levels[count]! + small) return count;
  return Math.min(Math.max(Math.floor((value - origin) / step), 0), count - 1);
}

/** Return the color at a place 0 .. 1 of a map. */
function blend(map: readonly Rgb[], part: number): Rgb {
  const place = Math.min(Math.max(part, 0), 1) * (map.length - 1);
  const i = Math.min(Math.floor(place), map.length - 2);
  return map[i]!.map((value, k) => Math.round(value + (place - i) * (map[i + 1]![k]! - value))) as Rgb;
}
