// What an edit does to the data, foreseen here so that form and drawing need not wait for the server.

import type { Change, Edit } from "../edits";
import { isTable, type Json, type Path, sameValue, type Table, valueAt } from "../paths";
import { formatLike } from "../quantities";
import { moveTable } from "./translation";

/** The data after an edit; an edit that does not fit changes nothing, the server will say so. */
export function applyOptimistic(data: Table, edit: Edit): Table {
  switch (edit.op) {
    case "text":
      return data;
    case "set":
      return replaceAt(data, edit.path, () => edit.value);
    case "length":
      return replaceAt(data, edit.path, (old) => formatLike(old, edit.value));
    case "move":
      return replaceAt(data, edit.path, (old) => (old === undefined ? undefined : moveTable(old, edit.by)));
    case "remove":
      return replaceAt(data, edit.path, () => undefined);
    case "rename": {
      const [above, value] = [edit.path.slice(0, -1), valueAt(data, edit.path)];
      if (value === undefined) return data;
      const without = replaceAt(data, edit.path, () => undefined);
      return replaceAt(without, [...above, edit.value], () => value);
    }
    case "reorder": {
      const [above, from] = [edit.path.slice(0, -1), edit.path.at(-1)];
      return replaceAt(data, above, (list) => {
        if (!Array.isArray(list) || typeof from !== "number" || from >= list.length) return list;
        const others = list.toSpliced(from, 1);
        return others.toSpliced(edit.value, 0, list[from]!);
      });
    }
    case "add": {
      const list = valueAt(data, edit.path);
      const items = Array.isArray(list) ? [...list] : [];
      items.splice(edit.at ?? items.length, 0, edit.value);
      return replaceAt(data, edit.path, () => items);
    }
  }
}

/** A copy of the data with another value at a path; `undefined` takes the key or the item away. */
function replaceAt(data: Table, path: Path, make: (old: Json | undefined) => Json | undefined): Table {
  const result = replaceWithin(data, path, make);
  return isTable(result) ? result : data;
}

function replaceWithin(
  value: Json | undefined,
  path: Path,
  make: (old: Json | undefined) => Json | undefined,
): Json | undefined {
  const [step, ...rest] = path;
  if (step === undefined) return make(value);
  if (typeof step === "number") {
    if (!Array.isArray(value) || step >= value.length) return value;
    const inner = replaceWithin(value[step], rest, make);
    return inner === undefined
      ? value.filter((_, n) => n !== step)
      : value.map((each, n) => (n === step ? inner : each));
  }
  if (value !== undefined && !isTable(value)) return value;
  const table: Table = { ...value };
  const inner = replaceWithin(table[step], rest, make);
  if (inner === undefined) {
    if (value === undefined) return undefined;
    delete table[step];
  } else table[step] = inner;
  return table;
}

/** Whether what a change is about has the same value in two states of the data. */
export function isUntouched(change: Change, before: Table, after: Table): boolean {
  return change.edits.every((edit) => {
    if (edit.op === "text") return false;
    const whole = edit.op === "add" || edit.op === "reorder";
    const path = whole ? edit.path.slice(0, edit.op === "add" ? undefined : -1) : edit.path.slice(0, 2);
    return sameValue(valueAt(before, path), valueAt(after, path));
  });
}
