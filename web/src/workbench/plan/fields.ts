// The fields that a dialog of the plan asks for, and what is read from them.

import { say, verbatim } from "../../viewer/shared/language";
import { Impossible } from "../model/changes/transform";
import { parseTyped, replaceDecimalComma } from "../model/quantities";

export interface ActionField {
  key: string;
  label: string;
  is: "length" | "lengths" | "force" | "pressure" | "angle" | "number" | "count" | "choice" | "case" | "flag";
  initial: string;
  options?: readonly string[];
  /** Whether only cases are offered that are not permanent. */
  imposed?: boolean;
  /** Whether it is asked for with the present values. */
  shown?: (values: Values) => boolean;
  /** Values of other fields that a choice fills in, null if it leaves them. */
  fills?: (value: string) => Values | null;
}

export type Values = Readonly<Record<string, string>>;

//: units of forces [N] and of pressures [Pa]
const NEWTONS: Record<string, number> = { N: 1, kN: 1e3, MN: 1e6, lbf: 4.4482216152605, kip: 4448.2216152605 };
const PASCALS: Record<string, number> = {
  Pa: 1,
  kPa: 1e3,
  MPa: 1e6,
  "N/mm2": 1e6,
  "kN/m2": 1e3,
  bar: 1e5,
  psi: 6894.757293168,
};

export function length(key: string, label: string, initial: string): ActionField {
  return { key, label, is: "length", initial };
}

export function angle(key: string, label: string, initial: string): ActionField {
  return { key, label, is: "angle", initial };
}

export function count(key: string, label: string, initial: string): ActionField {
  return { key, label, is: "count", initial };
}

export function force(key: string, label: string, initial: string): ActionField {
  return { key, label, is: "force", initial };
}

export function lengthOf(values: Values, key: string): number {
  const text = values[key] ?? "";
  const found = parseTyped(text);
  if (found === null) refuse('{key}: found "{text}", expected a length such as "1.5 m"', key, text);
  return found;
}

/** Throw that a field cannot have what is typed into it, by a message with holes for both. */
export function refuse(template: string, key: string, text: string): never {
  throw new Impossible(say(template, { key: verbatim(key), text: verbatim(text) }));
}

/** Return a length above 0 [m]. */
export function sizeOf(values: Values, key: string): number {
  const found = lengthOf(values, key);
  if (found <= 0) refuse('{key}: found "{text}", expected a length above 0', key, values[key]!);
  return found;
}

export function angleOf(values: Values, key: string): number {
  const text = values[key] ?? "";
  const found = Number(text.replace(/\s*(°|deg)\s*$/, "").replace(",", ".") || Number.NaN);
  if (!Number.isFinite(found)) refuse('{key}: found "{text}", expected an angle in degrees such as 30', key, text);
  return found;
}

export function countOf(values: Values, key: string): number {
  const text = (values[key] ?? "").trim();
  if (!/^[1-9]\d{0,3}$/.test(text)) refuse('{key}: found "{text}", expected a whole number from 1', key, text);
  return Number(text);
}

/** Return lengths that are listed, [6, 6, 5.4] of "2x6 5,4": a number and x repeat one; none of an empty text. */
export function lengthsOf(values: Values, key: string): number[] {
  const text = values[key] ?? "";
  const parts = text
    .replace(/(\d)\s+([a-z]+)\b/gi, "$1$2")
    .split(/[\s;]+/)
    .filter(Boolean);
  const found = parts.flatMap((part) => {
    const [, times = "1", one = part] = /^(\d{1,3})[x×*](.+)$/.exec(part) ?? [];
    return Array<number>(Number(times)).fill(parseTyped(one) ?? Number.NaN);
  });
  if (!found.every((each) => each > 0) || (found.length === 0 && text.trim() !== ""))
    refuse('{key}: found "{text}", expected distances such as 6 6 5.4, or 3x6', key, text);
  return found;
}

/** A number and its unit. */
export interface Force {
  value: number;
  unit: string;
}

/** Return a force; without a unit it is in kN. */
export function forceOf(values: Values, key: string): Force {
  const text = values[key] ?? "";
  const [, number = "", unit = ""] = /^([+-]?[\d.,eE+-]*\d)\s*([A-Za-z]*)$/.exec(text.trim()) ?? [];
  const value = Number(replaceDecimalComma(number) || Number.NaN);
  if (!Number.isFinite(value)) refuse('{key}: found "{text}", expected a force such as "60 kN"', key, text);
  return { value, unit: unit || "kN" };
}

/** Return a force in newtons. */
export function newtonsOf({ value, unit }: Force): number {
  const size = NEWTONS[unit];
  if (size === undefined)
    throw new Impossible(say("found a force in {unit}, expected N, kN, MN, lbf or kip", { unit }));
  return value * size;
}

/** Return a pressure in pascals; without a unit it is in MPa. */
export function pressureOf(values: Values, key: string): number {
  const text = values[key] ?? "";
  const [, number = "", unit = ""] = /^([\d.,]*\d)\s*([A-Za-z]*(?:\/mm2|\/m2)?)$/.exec(text.trim()) ?? [];
  const pressure = Number(replaceDecimalComma(number) || Number.NaN) * (PASCALS[unit || "MPa"] ?? Number.NaN);
  if (!(pressure > 0)) refuse('{key}: found "{text}", expected a pressure such as "0.8 MPa"', key, text);
  return pressure;
}
