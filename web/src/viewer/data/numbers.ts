// Round numbers, and numbers as texts.

/** Return the smallest round step (1, 2, 2.5 or 5 times a power of ten) that is at least `least`. */
export function roundStep(least: number): number {
  return roundStepOf([1, 2, 2.5, 5], least);
}

/** Return the smallest of some factors times a power of ten that is at least `least`. */
export function roundStepOf(factors: readonly number[], least: number): number {
  if (!(least > 0) || !Number.isFinite(least)) return 1;
  const power = 10 ** Math.floor(Math.log10(least));
  // a round step but for rounding is one
  const factor = factors.find((each) => each * power >= least * (1 - 1e-9)) ?? 10;
  return Number((factor * power).toPrecision(12));
}

/** Return the multiples of a step within low .. high. */
export function multiplesWithin(low: number, high: number, step: number): number[] {
  const [first, last] = [Math.ceil(low / step - 1e-9), Math.floor(high / step + 1e-9)];
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => roundMultiple(first + i, step));
}

/** Return a multiple of a step without the rounding error of the product. */
export function roundMultiple(times: number, step: number): number {
  const digits = Math.max(0, Math.min(15, 2 - Math.floor(Math.log10(step))));
  return Number((times * step).toFixed(digits)) + 0;
}

/** Replace hyphens with the true minus sign. */
export function withMinus(text: string): string {
  return text.replaceAll("-", "\u2212");
}

/** Format a value with about `digits` significant ones, without a needless exponent. */
export function formatNumber(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) return withMinus(value.toExponential(digits - 1));
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  return withMinus(value.toFixed(Math.min(decimals, 12)));
}

/** Format a number without needless zeros: 0.5, 800, 12.25. */
export function formatShort(value: number, digits = 4): string {
  return trimZeros(formatNumber(Number(value.toPrecision(digits)) === 0 ? 0 : value, digits));
}

/** Remove the zeros at the end of a number with decimals. */
export function trimZeros(text: string): string {
  return text.replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "");
}

/** Format ticks: all with the decimals that the finest of them needs. */
export function formatTicks(ticks: readonly number[]): string[] {
  const size = Math.max(...ticks.map(Math.abs), 1e-300);
  // what rounding leaves of zero is zero
  const values = ticks.map((tick) => (Math.abs(tick) < 1e-9 * size ? 0 : tick));
  if (size >= 1e6 || size < 1e-3) return values.map((value) => formatNumber(value, 3));
  const decimals = Math.max(...values.map((value) => decimalsOf(value, 1e-9 * size)));
  return values.map((value) => withMinus(value.toFixed(decimals)));
}

/** Return the decimals with which a value is written with an error of at most `error`. */
function decimalsOf(value: number, error: number): number {
  let decimals = 0;
  while (decimals < 12 && Math.abs(Number(value.toFixed(decimals)) - value) > error) decimals++;
  return decimals;
}
