// Colour scales: bands with round limits, colour maps that the colour-blind can read.

export type Rgb = [number, number, number]; // 0 .. 255

export interface Scale {
  levels: number[]; // limits of the bands, ascending, one more than there are bands
  origin: number; // band i goes from origin + i step to origin + (i + 1) step, cut to the levels
  step: number;
  colours: Rgb[]; // of the bands
  diverging: boolean; // two hues that part at zero
  over: Rgb; // colour of values above the last level
  under: Rgb; // and below the first
  min: number; // of the values shown
  max: number;
}

/** Viridis (van der Walt and Smith 2015), at even distances. */
const VIRIDIS = [
  "440154",
  "48186a",
  "472d7b",
  "424086",
  "3b528b",
  "33638d",
  "2c728e",
  "26828e",
  "21918c",
  "1fa088",
  "28ae80",
  "3fbc73",
  "5ec962",
  "84d44b",
  "addc30",
  "d8e219",
  "fde725",
].map(rgb);
/** Blue, white, red: ColorBrewer's RdBu (Brewer 2003) turned round, so that uplift is blue. */
const BLUE_RED = [
  "053061",
  "2166ac",
  "4393c3",
  "92c5de",
  "d1e5f0",
  "f7f7f7",
  "fddbc7",
  "f4a582",
  "d6604d",
  "b2182b",
  "67001f",
].map(rgb);
const OVER: Rgb = [179, 0, 0];
const UNDER: Rgb = [120, 120, 120];
/** Part of a band by which a value must lie beyond the scale to be shown so: what was packed is rounded. */
export const BEYOND = 2e-3;
const STEPS = [1, 2, 2.5, 5, 10];

/** Return the smallest round step (1, 2, 2.5 or 5 times a power of ten) that is at least `least`. */
export function roundStep(least: number): number {
  if (!(least > 0) || !Number.isFinite(least)) return 1;
  const power = 10 ** Math.floor(Math.log10(least));
  // what is a round step but for rounding is one
  return (STEPS.find((step) => step * power >= least * (1 - 1e-9)) ?? 10) * power;
}

/** Return round numbers at one distance, at most `most` intervals, from at or below low to at or above high. */
export function roundLevels(low: number, high: number, most: number): number[] {
  if (!(high - low > 1e-9 * Math.max(Math.abs(low), Math.abs(high)))) {
    const half = Math.abs(low) * 0.5 || 0.5;
    [low, high] = [low - half, low + half];
  }
  for (let least = (high - low) / most; ; least *= 1.01) {
    const step = roundStep(least);
    const [first, last] = [Math.floor(low / step + 1e-9), Math.ceil(high / step - 1e-9)];
    if (last - first <= most) return Array.from({ length: last - first + 1 }, (_, i) => tidy((first + i) * step, step));
  }
}

/** Return round numbers within low .. high, about `count` of them. */
export function roundTicks(low: number, high: number, count: number): number[] {
  const step = roundStep((high - low) / Math.max(count, 1));
  const ticks: number[] = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) ticks.push(tidy(i * step, step));
  return ticks;
}

/** Return a multiple of a step without the rounding of the product. */
function tidy(value: number, step: number): number {
  const digits = Math.max(0, Math.min(15, 2 - Math.floor(Math.log10(step))));
  return Number(value.toFixed(digits)) + 0;
}

/**
 * Return the colour scale of values from min to max.
 *
 * `signed` fields that cross zero get two hues that part there. `range` is where the scale shall begin and end; values
 * beyond it have colours of their own.
 */
export function scaleOf(
  min: number,
  max: number,
  signed: boolean,
  range?: readonly [number, number],
  most = 14,
): Scale {
  const [low, high] = range ?? [min, max];
  const diverging = signed && crossesZero(low, high);
  const levels = roundLevels(low, high, most);
  const [origin, step] = [levels[0]!, (levels[levels.length - 1]! - levels[0]!) / (levels.length - 1)];
  if (range) {
    // a given scale ends where it was told to, not at the next round number
    levels[0] = Math.max(levels[0]!, low);
    levels[levels.length - 1] = Math.min(levels[levels.length - 1]!, high);
  }
  const [first, last] = [levels[0]!, levels[levels.length - 1]!];
  const reach = Math.max(Math.abs(first), Math.abs(last));
  const colours = levels.slice(1).map((upper, i): Rgb => {
    const middle = (levels[i]! + upper) / 2;
    return diverging ? along(BLUE_RED, (middle / reach + 1) / 2) : along(VIRIDIS, (middle - first) / (last - first));
  });
  return { levels, origin, step, colours, diverging, over: OVER, under: UNDER, min, max };
}

/** Whether a range goes below zero and above it by more than rounding. */
export function crossesZero(low: number, high: number): boolean {
  const small = 1e-4 * Math.max(Math.abs(low), Math.abs(high));
  return low < -small && high > small;
}

/** Return the band of a value: -1 below the scale, the number of bands above it. */
export function bandOf(scale: Scale, value: number): number {
  const { levels, origin, step } = scale;
  const count = levels.length - 1;
  // what is beyond the scale by rounding only belongs to its last band
  const small = BEYOND * step;
  if (value < levels[0]! - small) return -1;
  if (value > levels[count]! + small) return count;
  return Math.min(Math.max(Math.floor((value - origin) / step), 0), count - 1);
}

/** Return the colour of a value. */
export function colourOf(scale: Scale, value: number): Rgb {
  const band = bandOf(scale, value);
  if (band < 0) return scale.under;
  return scale.colours[band] ?? scale.over;
}

/** Write a value with about `digits` significant ones, without a needless exponent; "-" is the true minus sign. */
export function number(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text = size >= 1e6 || size < 1e-4 ? value.toExponential(digits - 1) : plain(value, digits);
  return text.replace(/-/g, "\u2212");
}

/** Write a measure without needless zeros: 0.5, 800, 12.25. */
export function neat(value: number, digits = 4): string {
  return number(Number(value.toPrecision(digits)) === 0 ? 0 : value, digits)
    .replace(/(\.\d*?)0+$/, "$1")
    .replace(/\.$/, "");
}

/** Write the limits of a scale: all with the decimals that the finest of them needs. */
export function tickTexts(ticks: readonly number[]): string[] {
  const size = Math.max(...ticks.map(Math.abs), 1e-300);
  // what is left of zero by rounding is zero
  const tidied = ticks.map((tick) => (Math.abs(tick) < 1e-9 * size ? 0 : tick));
  if (size >= 1e6 || size < 1e-3) return tidied.map((tick) => number(tick, 3));
  const decimals = Math.max(...tidied.map((tick) => decimalsOf(tick, 1e-9 * size)));
  return tidied.map((tick) => tick.toFixed(decimals).replace(/-/g, "\u2212"));
}

/** The decimals with which a value is written with an error of at most `error`. */
function decimalsOf(value: number, error: number): number {
  let decimals = 0;
  while (decimals < 12 && Math.abs(Number(value.toFixed(decimals)) - value) > error) decimals++;
  return decimals;
}

export function css([red, green, blue]: Rgb, alpha = 1): string {
  return alpha === 1 ? `rgb(${red} ${green} ${blue})` : `rgb(${red} ${green} ${blue} / ${alpha})`;
}

function plain(value: number, digits: number): string {
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(Math.abs(value))));
  return value.toFixed(Math.min(decimals, 12));
}

function along(map: readonly Rgb[], part: number): Rgb {
  const place = Math.min(Math.max(part, 0), 1) * (map.length - 1);
  const i = Math.min(Math.floor(place), map.length - 2);
  const rest = place - i;
  return map[i]!.map((value, k) => Math.round(value + rest * (map[i + 1]![k]! - value))) as Rgb;
}

function rgb(hex: string): Rgb {
  return [0, 2, 4].map((at) => parseInt(hex.slice(at, at + 2), 16)) as Rgb;
}
