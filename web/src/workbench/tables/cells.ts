// The cells of a table: as text, and from text.
import { summaryOf } from "../form/labels";
import { isTable, type Json, type Path, type Table, valueAt } from "../model/paths";
import { parseInput, unitIn } from "../model/quantities";
import type { Schema } from "../model/schema";
import type { Column } from "./columns";

/** Return what a cell shows: the value as the file has it. */
export function cellText(schema: Schema, column: Column, row: Table): string {
  const value = valueAt(row, column.path);
  if (value === undefined || value === null) return "";
  if (isTable(value)) return summaryOf(value, schema.partOf(column.node, value));
  if (!Array.isArray(value)) return String(value);
  return value.every((each) => typeof each !== "object") ? value.join(", ") : String(value.length);
}

/** Return the value of a text in a cell, undefined for none; a bare number takes the unit. */
export function parseCell({ node }: Column, typed: string, unit: string): Json | undefined {
  const text = typed.trim();
  switch (node.is) {
    case "choice":
      return node.options.find((option) => option.toLowerCase() === text.toLowerCase()) ?? (text || undefined);
    case "boolean":
      return /^(true|yes)$/i.test(text) ? true : /^(false|no)$/i.test(text) ? false : text || undefined;
    case "values": {
      const values = text.split(",").flatMap((each) => parseInput(node.each, each) ?? []);
      return values.length > 0 ? values : undefined;
    }
    default:
      return parseInput(node, text, unit);
  }
}

/** Return the unit that all values of the columns of a key have, empty if they have none or several. */
export function commonUnit(columns: readonly Column[], rows: readonly Table[]): string {
  const units = new Set(rows.flatMap((row) => columns.map(({ path }) => unitIn(valueAt(row, path)))));
  units.delete("");
  return units.size === 1 ? [...units][0]! : "";
}

/** Return an item with another value in a cell; without one the key goes, and with it lists that become empty. */
export function writeCell(row: Table, { path, blanks }: Column, value: Json | undefined): Table {
  const written = put(row, path, value, blanks);
  return isTable(written) ? written : {};
}

function put(old: Json | undefined, path: Path, value: Json | undefined, blanks: readonly Json[]): Json | undefined {
  const [step, ...rest] = path;
  if (step === undefined) return value;
  if (typeof step === "string") {
    const table: Table = isTable(old) ? { ...old } : {};
    const inner = put(table[step], rest, value, blanks);
    if (inner === undefined) delete table[step];
    else table[step] = inner;
    return Object.keys(table).length > 0 ? table : undefined;
  }
  const list = Array.isArray(old) ? [...old] : [];
  if (rest.length === 0) {
    const values = blanks.map((blank, n) => list[n] ?? blank);
    values[step] = value ?? "";
    return isBlank(values) ? undefined : values;
  }
  const empty = (): Json => (typeof rest[0] === "number" ? [...blanks] : {});
  while (list.length <= step) list.push(empty());
  list[step] = put(list[step], rest, value, blanks) ?? empty();
  while (isBlank(list.at(-1))) list.pop();
  return list.length > 0 ? list : undefined;
}

/** Whether a value of a list says nothing. */
function isBlank(value: Json | undefined): boolean {
  if (Array.isArray(value)) return value.every((each) => each === "");
  return isTable(value) && Object.keys(value).length === 0;
}
