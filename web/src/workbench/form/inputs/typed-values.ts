// What is typed into a field as a value of the case file.
import type { Json } from "../../model/paths";
import type { Node } from "../../model/schema";

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;
const COMMA = /^([+-]?\d*),(\d+)((?:[eE][+-]?\d+)?)(?![\d.,])/;
const QUANTITY = /^[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?(?:\s+(\S.*)|([^\d\s.,eE].*))$/;

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
  if (node.is === "number" && node.options.includes(text)) return text;
  const value = replaceDecimalComma(text);
  return NUMBER.test(value) ? Number(value) : text;
}
