// How keys, symbols and values are written for people.

import { say, translate } from "../../viewer/shared/language";
import { symbolElement } from "../../viewer/shared/symbols";
import { isTable, type Json, type Table } from "../model/paths";
import type { Field, Part } from "../model/schema";

const LONGEST_LABEL = 30;

/** Return the label of a field: its key, or what its letter means. */
export function labelOf(field: Field): string {
  const { name, hint } = field;
  if (name === "x" || name === "y") return name;
  const short = name.length <= 2 || name === field.symbol || /^[A-Za-z]{1,2}_/.test(name);
  if (!short) return name.replaceAll("_", " ");
  const phrase = (hint.split(/[,;:]/)[0] ?? "")
    .replace(/^its /, "")
    .replace(/ there$/, "")
    .trim();
  return phrase && phrase.length <= LONGEST_LABEL ? phrase : "";
}

/** Return the title of a kind or a section. */
export function heading(name: string): string {
  const words = name.replaceAll("_", " ");
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** A value of the file as short text. */
export function shortValue(value: Json | undefined): string {
  if (value === undefined || value === null) return "";
  if (Array.isArray(value))
    return value.length <= 3 ? value.map(shortValue).join(", ") : say("{count} values", { count: value.length });
  if (isTable(value)) return "";
  if (typeof value === "number") return String(Number(value.toPrecision(6)));
  return String(value);
}

/** A default as the placeholder of a field: without needless digits. */
export function defaultText(value: Json | undefined): string {
  if (value === undefined || value === "") return "";
  return shortValue(value)
    .replace(/(\d)\.0(?= |$)/, "$1")
    .replace(/^1e-05/, "1e-5");
}

/** What a table holds, in one line: name, kind, and the values that matter most. */
export function summaryOf(table: Table, part: Part | null): string {
  const pieces: string[] = [];
  if (typeof table.name === "string" && table.name) pieces.push(table.name);
  if (typeof table.kind === "string") pieces.push(table.kind);
  for (const field of part?.fields ?? []) {
    if (pieces.length >= 5 || ["name", "kind", "case", "column", "wall", "core"].includes(field.name)) continue;
    const value = table[field.name];
    const simple = ["quantity", "number", "integer", "choice", "tuple"].includes(field.node.is);
    if (value !== undefined && simple)
      pieces.push(`${field.symbol && field.name.length > 2 ? "" : `${field.name} `}${shortValue(value)}`.trim());
  }
  if (isTable(table.shape)) pieces.push(String(table.shape.kind ?? ""));
  const factors = isTable(table.factors) ? Object.entries(table.factors) : [];
  pieces.push(factors.map(([name, factor]) => `${shortValue(factor)} ${name}`).join(" + "));
  for (const host of [table.column, table.wall, table.core])
    if (typeof host === "string" && host) pieces.push(["on", host].join(" "));
  if (typeof table.case === "string" && table.case) pieces.push(`(${table.case})`);
  return pieces.filter(Boolean).join("  ·  ");
}

/** Return the label and the symbol of a field. */
export function labelParts(field: Field): (Node | string)[] {
  const words = labelOf(field);
  const symbol =
    field.symbol && field.symbol !== words && !field.symbol.includes(",") ? symbolElement(field.symbol) : null;
  const shown = words || (symbol ? "" : field.name);
  return [shown, ...(shown && symbol ? [" "] : []), ...(symbol ? [symbol] : [])];
}

/** What the label does not say yet. */
export function furtherHint(field: Field): string {
  return labelOf(field).toLowerCase() === field.hint.toLowerCase() ? field.range : hintOf(field);
}

/** What a key means and what it may be. */
export function hintOf(field: Field): string {
  return field.range ? `${translate(field.hint)} (${translate(field.range)})` : field.hint;
}
