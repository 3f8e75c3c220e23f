// The changes that a table makes: each one step of undo.
import { counted, say } from "../../viewer/shared/language";
import { joinEdits } from "../model/changes/batches";
import { renameReferences } from "../model/changes/references";
import { editsToTable } from "../model/changes/transform";
import type { Change, Edit } from "../model/edits";
import { titleAt } from "../model/items";
import { freeName, namesIn, takenNames } from "../model/names";
import { type Json, type Path, type Table, tableAt, valueAt } from "../model/paths";
import { writeCell } from "./cells";
import { type Column, isEditable, nameOf } from "./columns";
import type { Sheet } from "./sheets";

/** A value for a cell; rows beyond the last one are new items. */
export interface Write {
  readonly row: number;
  readonly column: Column;
  readonly value: Json | undefined;
}

/** Return the change that writes cells, null if all of them have their values already. */
export function writeCells(
  data: Table,
  sheet: Sheet,
  positions: readonly number[],
  writes: readonly Write[],
): Change | null {
  const rows = new Map<number, Table>();
  for (const { row, column, value } of writes) {
    const isNew = row >= positions.length;
    if (isNew && value === undefined) continue;
    const before = rows.get(row) ?? (isNew ? {} : tableAt(data, [sheet.list, positions[row]!]));
    rows.set(row, writeCell(before, column, value));
  }
  const made = [...rows].filter(([row]) => row >= positions.length).sort(([a], [b]) => a - b);
  const edits = [
    ...[...rows].flatMap(([row, table]): Edit[] => {
      const path: Path = [sheet.list, positions[row] ?? -1];
      return row < positions.length ? editsToTable(path, tableAt(data, path), table) : [];
    }),
    ...withNames(
      data,
      sheet,
      made.map(([, table]) => table),
    ).map((value): Edit => ({ op: "add", path: [sheet.list], value })),
  ];
  if (edits.length === 0) return null;
  return joinEdits(data, {
    edits: [...edits, ...renames(data, edits)],
    text: describe(data, sheet, positions, writes, made.length),
  });
}

/** Return new items with their kind, and with the names that they need and were not given. */
function withNames(data: Table, { list, part }: Sheet, tables: readonly Table[]): Table[] {
  const kind: Table = part.kind ? { kind: part.kind } : {};
  const isNamed = part.fields.some((field) => field.name === "name" && field.needed);
  const taken = [...takenNames(data, [list]), ...namesIn([...tables])];
  return tables.map((table) => {
    if (!isNamed || table.name !== undefined) return { ...kind, ...table };
    const name = freeName(taken, list === "columns" ? "C1" : `${list.replace(/s$/, "")} 1`);
    taken.push(name);
    return { ...kind, name, ...table };
  });
}

/** Return what lets others call an item by its new name; a block of names that is pasted says itself who calls whom. */
function renames(data: Table, edits: readonly Edit[]): Edit[] {
  const named = edits.filter((edit) => edit.op === "set" && edit.path.at(-1) === "name");
  const [only] = named;
  if (named.length !== 1 || only?.op !== "set" || typeof only.value !== "string") return [];
  return renameReferences(data, only.path, only.value);
}

/** Return what a change is called in the list of edits. */
function describe(
  data: Table,
  { list, title }: Sheet,
  positions: readonly number[],
  writes: readonly Write[],
  added: number,
): string {
  const [only] = writes;
  const position = positions[only?.row ?? -1];
  if (writes.length === 1 && only && position !== undefined)
    return say("change {field} of {item}", { field: nameOf(only.column), item: titleAt(data, [list, position]) });
  const count = new Set(writes.map(({ row }) => row)).size;
  const rows = (n: number) => counted(n, "a row", "{count} rows");
  return added === count
    ? say("add {rows} to {items}", { rows: rows(count), items: title.toLowerCase() })
    : say("change {rows} of {items}", { rows: rows(count), items: title.toLowerCase() });
}

/** Return the change that empties cells, and how many are needed and stay. */
export function emptyCells(
  data: Table,
  sheet: Sheet,
  positions: readonly number[],
  cells: readonly { row: number; column: Column }[],
): { change: Change | null; kept: number } {
  const filled = cells.filter(
    ({ row, column }) =>
      isEditable(column) && valueAt(data, [sheet.list, positions[row] ?? -1, ...column.path]) !== undefined,
  );
  const optional = filled.filter(({ column }) => !column.needed);
  const writes = optional.map(({ row, column }): Write => ({ row, column, value: undefined }));
  return { change: writeCells(data, sheet, positions, writes), kept: filled.length - optional.length };
}

/** Return the change that adds copies of items at the end of their list, with names that are free. */
export function duplicateRows(data: Table, { list, title }: Sheet, positions: readonly number[]): Change {
  const taken = takenNames(data, [list]);
  const edits = positions.map((n): Edit => {
    const value = structuredClone(tableAt(data, [list, n]));
    if (typeof value.name === "string" && value.name) {
      value.name = freeName(taken, value.name);
      taken.push(value.name);
    }
    return { op: "add", path: [list], value };
  });
  const values = { rows: counted(positions.length, "a row", "{count} rows"), items: title.toLowerCase() };
  return joinEdits(data, { edits, text: say("duplicate {rows} of {items}", values) });
}
