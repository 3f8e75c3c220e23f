// Copies of items, and items transformed where they are: each one change.

import { say, together, verbatim } from "../../../viewer/shared/language";
import { axesIn } from "../axes";
import type { Change, Edit } from "../edits";
import type { Isometry } from "../isometry";
import { titleOfAll } from "../items";
import { freeName, namesIn, takenNames } from "../names";
import { type Json, listAt, type Path, pathKey, type Table, tableAt, valueAt } from "../paths";
import { formatLength, parseLength } from "../quantities";
import { attach, detach } from "./attachment";
import { outlineEdits } from "./new-items";
import { editsToTable, hasPlace, Impossible, transformTable } from "./transform";

/** A table of a list of the case file. */
export interface ListedTable {
  list: Path;
  table: Table;
}

/** A change that adds several items, and their paths. */
export interface Additions {
  change: Change;
  paths: Path[];
  /** What is worth to know of it before it is made. */
  note?: string;
}

/** Lists whose names are for people only, and may occur twice. */
const FREE_NAMES: ReadonlySet<string> = new Set(["loads", "joints"]);

/** Return the tables at some paths that can be copied: all but the slab. */
export function tablesAt(data: Table, paths: readonly Path[]): ListedTable[] {
  const listed = paths.filter((path) => typeof path.at(-1) === "number");
  const axes = axesIn(data);
  return listed.map((path) => ({
    list: path.slice(0, -1),
    table: structuredClone(detach(tableAt(data, path), axes)),
  }));
}

/** Return the change that adds a copy of tables under each isometry; loads on copied columns stand on the copies. */
export function addCopies(
  data: Table,
  tables: readonly ListedTable[],
  isometries: readonly Isometry[],
  text: string,
): Additions {
  const names = new Map<string, string[]>();
  const counts = new Map<string, number>();
  const edits: Edit[] = [];
  const paths: Path[] = [];
  for (const isometry of isometries) {
    const renamed = new Map<string, string>();
    const copies = tables.map(({ list, table }) => {
      const copy = transformNamed(table, isometry);
      return { list, table: rename(data, list, copy, names, renamed) };
    });
    for (const { list, table } of copies) {
      const key = pathKey(list);
      const at = counts.get(key) ?? listAt(data, list).length;
      counts.set(key, at + 1);
      edits.push({ op: "add", path: list, value: attach(withReferences(table, renamed), list[0], axesIn(data)) });
      paths.push([...list, at]);
    }
  }
  return { change: { edits, text }, paths };
}

function transformNamed(table: Table, isometry: Isometry): Table {
  try {
    return transformTable(table, isometry);
  } catch (error) {
    if (error instanceof Impossible) throw new Impossible(together([nameOf(table), error.message], ": "));
    throw error;
  }
}

function nameOf(table: Table): string {
  const words = [table.kind, table.name].filter((word) => typeof word === "string" && word !== "");
  return words.length > 0 ? together(words.map(String)) : "an item";
}

/** Return a copy with a name that is free in its list; `renamed` remembers it for references. */
function rename(
  data: Table,
  list: Path,
  table: Table,
  names: Map<string, string[]>,
  renamed: Map<string, string>,
): Table {
  if (typeof table.name !== "string" || !table.name || FREE_NAMES.has(String(list[0]))) return table;
  const key = pathKey(list);
  const taken = names.get(key) ?? takenNames(data, list);
  const name = freeName(taken, table.name);
  names.set(key, [...taken, name]);
  renamed.set(`${String(list[0])} ${table.name}`, name);
  return { ...table, name };
}

function withReferences(table: Table, renamed: ReadonlyMap<string, string>): Table {
  const result = { ...table };
  for (const [key, list] of [
    ["column", "columns"],
    ["wall", "walls"],
    ["support", "supports"],
  ] as const) {
    const name = renamed.get(`${list} ${String(table[key])}`);
    if (table[key] !== undefined && name !== undefined) result[key] = name;
  }
  if (Array.isArray(table.between))
    result.between = table.between.map((name): Json => renamed.get(`plates ${String(name)}`) ?? name);
  return result;
}

/** Return the change that transforms items where they are; throws Impossible with the item's title. */
export function transformItems(data: Table, paths: readonly Path[], isometry: Isometry, verb: string): Change {
  const edits = paths.flatMap((path) => {
    try {
      return path[0] === "plate" && path.length < 3
        ? slabEdits(data, isometry)
        : editsToTable(path, tableAt(data, path), transformHung(data, path, isometry));
    } catch (error) {
      if (error instanceof Impossible) throw new Impossible(together([titleOfAll(data, [path]), error.message], ": "));
      throw error;
    }
  });
  if (edits.length === 0) throw new Impossible("the selection would not change");
  return { edits, text: say(`${verb} {items}`, { items: titleOfAll(data, paths) }) };
}

/** Return a table under an isometry, detached from its axes, and attached to those where it then is. */
function transformHung(data: Table, path: Path, isometry: Isometry): Table {
  const axes = axesIn(data);
  return attach(transformTable(detach(tableAt(data, path), axes), isometry), path[0], axes);
}

/** Return the edits that transform the slab's outline; one given by its sides becomes an outline of its own. */
function slabEdits(data: Table, isometry: Isometry): Edit[] {
  const isTranslation = isometry.a === 1 && isometry.d === 1;
  if (!isTranslation && Object.keys(tableAt(data, ["plate", "edges"])).length > 0)
    throw new Impossible("supports on its left, right, bottom and top edges cannot be rotated");
  const outline = valueAt(data, ["plate", "outline"]);
  const before = outline === undefined ? sidesAsRectangle(data) : tableAt(data, ["plate", "outline"]);
  const after = transformTable(before, isometry);
  return outline === undefined ? outlineEdits(data, after) : editsToTable(["plate", "outline"], before, after);
}

function sidesAsRectangle(data: Table): Table {
  const range = (key: string): Json[] => {
    const length = parseLength(valueAt(data, ["plate", key]));
    if (length === null) throw new Impossible("its side lengths are not valid");
    return [formatLength(-length / 2), formatLength(length / 2)];
  };
  return { kind: "rectangle", x: range("length_x"), y: range("length_y") };
}

/** Return why copies of tables at other places make no sense, empty if they do. */
export function whyNotCopied(tables: readonly ListedTable[]): string {
  for (const [key, hosts] of [
    ["column", "columns"],
    ["wall", "walls"],
    ["core", "cores"],
  ] as const) {
    const chosen = new Set(namesIn(tables.filter(({ list }) => list[0] === hosts).map(({ table }) => table)));
    const lonely = tables.find(({ table }) => typeof table[key] === "string" && table[key] && !chosen.has(table[key]));
    if (lonely)
      return say("a load is attached to {key} {name}, which is not selected", {
        key,
        name: verbatim(String(lonely.table[key])),
      });
  }
  return tables.some(({ table }) => hasPlace(table)) ? "" : "nothing in the selection has a position on the plan";
}
