// Names that other parts of the file refer to: renamed and removed together with the references.

import { titleAt } from "../items";
import { namesIn } from "../names";
import { isTable, type Json, listAt, type Path, type Table } from "../paths";
import type { Change, Edit } from "./edits";

/** Which key of which list calls the names of a list. */
const REFERENCES: readonly { names: string; list: string; key: string }[] = [
  { names: "columns", list: "loads", key: "column" },
  { names: "supports", list: "loads", key: "support" },
  { names: "cases", list: "loads", key: "case" },
  { names: "cases", list: "moves", key: "case" },
  { names: "patterns", list: "moves", key: "pattern" },
];

/** The names that a key may call, null if it calls none. */
export function referencedNames(data: Table, path: Path): string[] | null {
  const [list, , key] = path;
  const found = REFERENCES.find((each) => each.list === list && each.key === key);
  if (!found || path.length !== 3) return null;
  return namesIn(listAt(data, [found.names]));
}

/** Whether a path is a name that others may call, which is changed when it is complete only. */
export function isReferenced(path: Path): boolean {
  return path.length === 3 && path[2] === "name" && REFERENCES.some((each) => each.names === path[0]);
}

/** The edits that let all who call a name call the new one. */
export function renameReferences(data: Table, path: Path, to: string): Edit[] {
  if (!isReferenced(path) || !to) return [];
  const table = listAt(data, [path[0] as string])[path[1] as number];
  const from = isTable(table) ? table.name : undefined;
  const names = namesIn(listAt(data, [path[0] as string]));
  // two with the same name cannot be distinguished
  if (typeof from !== "string" || names.filter((name) => name === from).length !== 1 || names.includes(to)) return [];
  const edits = REFERENCES.filter((each) => each.names === path[0]).flatMap((caller) =>
    referencesTo(data, caller, from).map((n): Edit => ({ op: "set", path: [caller.list, n, caller.key], value: to })),
  );
  if (path[0] === "cases") {
    listAt(data, ["combinations"]).forEach((each, n) => {
      const factors = isTable(each) && isTable(each.factors) ? each.factors : {};
      if (!(from in factors)) return;
      const renamed = Object.entries(factors).map(([name, factor]) => [name === from ? to : name, factor]);
      edits.push({ op: "set", path: ["combinations", n, "factors"], value: Object.fromEntries(renamed) });
    });
  }
  return edits;
}

function referencesTo(data: Table, caller: { list: string; key: string }, name: string): number[] {
  return listAt(data, [caller.list]).flatMap((each: Json, n) =>
    isTable(each) && each[caller.key] === name ? [n] : [],
  );
}

/** Return the change that removes an item and the loads on it. */
export function removeItem(data: Table, path: Path): Change {
  const title = titleAt(data, path);
  const list = path[0];
  const table = typeof path[1] === "number" && path.length === 2 ? listAt(data, [list as string])[path[1]] : undefined;
  const name = isTable(table) && typeof table.name === "string" ? table.name : "";
  const alone = namesIn(listAt(data, [String(list)])).filter((each) => each === name).length === 1;
  const loads =
    name && alone && (list === "columns" || list === "supports")
      ? REFERENCES.filter((each) => each.names === list).flatMap((caller) => referencesTo(data, caller, name))
      : [];
  // from the last on, so that the positions of the others stay
  const edits: Edit[] = [...loads].sort((a, b) => b - a).map((n) => ({ op: "remove", path: ["loads", n] }));
  edits.push({ op: "remove", path });
  const also = loads.length === 0 ? "" : loads.length === 1 ? " and its load" : ` and its ${loads.length} loads`;
  return { edits, text: `remove ${title}${also}` };
}
