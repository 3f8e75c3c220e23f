// Tables of the case file as TOML text for the clipboard, and back.
import { parse, stringify, TomlError } from "smol-toml";
import { isTable, type Json, type Path, type Table } from "./paths";

/** A table with the keys of the list that it belongs to. */
interface Listed {
  list: Path;
  table: Table;
}

/** Return tables as TOML text, each below the header of its list. */
export function writeTables(tables: readonly Listed[]): string {
  const nest = ({ list, table }: Listed) => list.reduceRight<Json>((value, key) => ({ [key]: value }), [table]);
  return tables.map((listed) => stringify(nest(listed))).join("\n");
}

/** Return the lists of tables in a TOML text; null if it is none, or has anything but such tables. */
export function readTables(text: string): Listed[] | null {
  try {
    const data: unknown = parse(text.replace(/^\uFEFF/, ""), { unsafeKeyBehaviour: "throw" });
    return isJson(data) && isTable(data) ? listsIn(data, []) : null;
  } catch (error) {
    if (error instanceof TomlError) return null;
    throw error;
  }
}

/** Return the tables of all lists within a table; null if it has anything else. */
function listsIn(table: Table, path: Path): Listed[] | null {
  const lists = Object.entries(table).map(([key, value]) => {
    const list = [...path, key];
    if (isTable(value)) return listsIn(value, list);
    return Array.isArray(value) && value.every(isTable) ? value.map((one) => ({ list, table: one })) : null;
  });
  return lists.includes(null) ? null : lists.flatMap((some) => some ?? []);
}

/** Whether a case can hold a value: there are no dates in it, and no infinite numbers. */
function isJson(value: unknown): value is Json {
  if (typeof value === "number") return Number.isFinite(value);
  if (typeof value !== "object" || value === null) return true;
  return !(value instanceof Date) && Object.values(value).every(isJson);
}
