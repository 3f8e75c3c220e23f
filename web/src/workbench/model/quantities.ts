// Quantities as the case file writes them: lengths, "200 mm", to meters and back, and what is typed as a value.
// What is a good quantity is for the server to say.

import { trimZeros } from "../../viewer/data/numbers";
import type { Json } from "./paths";
import type { Node } from "./schema";

const METERS: Record<string, number> = {
  m: 1,
  mm: 1e-3,
  cm: 1e-2,
  dm: 0.1,
  km: 1e3,
  ft: 0.3048,
  foot: 0.3048,
  feet: 0.3048,
  in: 0.0254,
  inch: 0.0254,
  yd: 0.9144,
  yard: 0.9144,
};
const LENGTH = /^\s*([+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?)\s*([A-Za-z]+)\s*$/;
const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;
/** How a number or a quantity begins. */
export const NUMBER_START = /^[+-]?[.,]?\d/;
const COMMA = /^([+-]?\d*),(\d+)((?:[eE][+-]?\d+)?)(?![\d.,])/;
const QUANTITY = /^[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?(?:\s+(\S.*)|([^\d\s.,eE].*))$/;

/** Return a length in meters, null if the text is none that the drawing knows. */
export function parseLength(value: Json | undefined): number | null {
  const match = typeof value === "string" ? LENGTH.exec(value) : null;
  const size = match ? METERS[match[2] ?? ""] : undefined;
  if (!match || size === undefined) return null;
  // through the decimal exponent, so that "700 mm" is 0.7 and not 0.7000000000000001
  return size < 1 && size.toString().startsWith("0.0") && Math.log10(size) % 1 === 0
    ? Number(`${Number(match[1])}e${Math.round(Math.log10(size))}`) || Number(match[1]) * size
    : Number(match[1]) * size;
}

/** Return a point [x, y] in meters, null if it is none. */
export function parsePoint(value: Json | undefined): [number, number] | null {
  if (!Array.isArray(value) || value.length !== 2) return null;
  const [x, y] = [parseLength(value[0]), parseLength(value[1])];
  return x === null || y === null ? null : [x, y];
}

/** A list of places, null if any of them is none. */
export function parsePoints(value: Json | undefined): [number, number][] | null {
  if (!Array.isArray(value)) return null;
  const all = value.map(parsePoint);
  return all.every((each) => each !== null) ? (all as [number, number][]) : null;
}

/** The unit of a length's text, "m" where there is none that is known. */
function unitOf(value: Json | undefined): string {
  const unit = typeof value === "string" ? LENGTH.exec(value)?.[2] : undefined;
  return unit !== undefined && unit in METERS ? unit : "m";
}

/** A number without noise and without zeros at its end. */
export function formatDecimals(value: number, digits: number): string {
  const text = trimZeros(value.toFixed(digits));
  return text === "-0" ? "0" : text;
}

/** A length as text in a unit, to a tenth of a millimetre. */
export function formatLength(value: number, unit = "m"): string {
  const size = METERS[unit] ?? 1;
  const digits = Math.max(0, Math.round(4 + Math.log10(size)));
  return `${formatDecimals(value / size, digits)} ${unit}`;
}

/** A length, or nested lists of them, as texts in the units that were there. */
export function formatLike(old: Json | undefined, value: number | readonly unknown[]): Json {
  if (typeof value === "number") return formatLength(value, unitOf(old));
  const before = Array.isArray(old) ? old : [];
  return value.map((each, n) => formatLike(before[n] ?? before.at(-1), each as number | readonly unknown[]));
}

/** A length in the unit of an older text, to a nanometer; the older text itself if it is the same length. */
export function formatExact(value: number, old: Json | undefined): string {
  const before = parseLength(old);
  if (before !== null && Math.abs(before - value) < 5e-10) return String(old);
  const unit = unitOf(old);
  const size = METERS[unit] ?? 1;
  return `${formatDecimals(value / size, Math.max(0, Math.round(9 + Math.log10(size))))} ${unit}`;
}

/** Return a typed length in meters, null if it is none: a comma may be the decimal point, and m may be left out. */
export function parseTyped(text: string): number | null {
  const point = replaceDecimalComma(text.trim());
  return parseLength(point) ?? parseLength(`${point} m`);
}

/**
 * Return a typed text with a decimal point in place of a decimal comma.
 *
 * "1,500" may be one and a half or fifteen hundred: what could be a separator of thousands stays as it is, and is
 * refused as no number. "0,250" and "1500,250" can only be decimals.
 */
export function replaceDecimalComma(text: string): string {
  return text.replace(COMMA, (whole, before: string, after: string, exponent: string) => {
    const mayBeThousands = after.length === 3 && /^[+-]?[1-9]\d{0,2}$/.test(before);
    return mayBeThousands ? whole : `${before}.${after}${exponent}`;
  });
}

/** Return the unit of a quantity's text, empty where there is none. */
export function unitIn(value: Json | undefined): string {
  const match = typeof value === "string" ? QUANTITY.exec(value.trim()) : null;
  return match?.[1] ?? match?.[2] ?? "";
}

/**
 * Return the value of a typed text, undefined for none.
 *
 * What is no number stays text, which the server reports. A bare number takes `unit`, that of the value that stood in
 * the field; without one it stays bare, and the server asks for a unit, since a guess could be a thousand times off.
 */
export function parseInput(node: Node, typed: string, unit = ""): Json | undefined {
  const text = typed.trim();
  if (text === "") return undefined;
  if (node.is === "quantity") {
    const value = replaceDecimalComma(text);
    return unit !== "" && NUMBER.test(value) ? `${value} ${unit}` : value;
  }
  if (node.is !== "number" && node.is !== "integer") return text;
  if (node.options.includes(text)) return text;
  const value = replaceDecimalComma(text);
  return NUMBER.test(value) ? Number(value) : text;
}
