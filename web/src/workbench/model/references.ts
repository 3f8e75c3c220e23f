// Names that other parts of the file call: renamed and removed together with those who call them.

import type { Change, Edit } from "./edits";
import { titleAt } from "./items";
import { namesIn } from "./names";
import { isTable, type Json, listAt, type Path, type Table } from "./paths";

/** Which key of which list calls the names of a list. */
const CALLERS: readonly { names: string; list: string; key: string }[] = [
  { names: "columns", list: "loads", key: "column" },
  { names: "supports", list: "loads", key: "support" },
  { names: "cases", list: "loads", key: "case" },
];

/** The names that a key may call, null if it calls none. */
export function namesFor(data: Table, path: Path): string[] | null {
  const [list, , key] = path;
  const found = CALLERS.find((each) => each.list === list && each.key === key);
  if (!found || path.length !== 3) return null;
  return namesIn(listAt(data, [found.names]));
}

/** Whether a path is a name that others may call, which is changed when it is complete only. */
export function isCalled(path: Path): boolean {
  return path.length === 3 && path[2] === "name" && CALLERS.some((each) => each.names === path[0]);
}

/** The edits that let all who call a name call the new one. */
export function renames(data: Table, path: Path, to: string): Edit[] {
  if (!isCalled(path) || !to) return [];
  const table = listAt(data, [path[0] as string])[path[1] as number];
  const from = isTable(table) ? table.name : undefined;
  const names = namesIn(listAt(data, [path[0] as string]));
  // of two with the same name none can be told apart
  if (
    typeof from !== "string" ||
    !from ||
    from === to ||
    names.filter((name) => name === from).length > 1 ||
    names.includes(to)
  )
    return [];
  const edits = CALLERS.filter((each) => each.names === path[0]).flatMap((caller) =>
    callersOf(data, caller, from).map((n): Edit => ({ op: "set", path: [caller.list, n, caller.key], value: to })),
  );
  if (path[0] === "cases") {
    listAt(data, ["combinations"]).forEach((each, n) => {
      const factors = isTable(each) && isTable(each.factors) ? each.factors : {};
      if (!(from in factors)) return;
      const renamed = Object.fromEntries(
        Object.entries(factors).map(([name, factor]) => [name === from ? to : name, factor]),
      );
      edits.push({ op: "set", path: ["combinations", n, "factors"], value: renamed });
    });
  }
  return edits;
}

function callersOf(data: Table, caller: { list: string; key: string }, name: string): number[] {
  return listAt(data, [caller.list]).flatMap((each: Json, n) =>
    isTable(each) && each[caller.key] === name ? [n] : [],
  );
}

/** The change that removes a thing and the loads that stand on it. */
export function removal(data: Table, path: Path): Change {
  const title = titleAt(data, path);
  const list = path[0];
  const table = typeof path[1] === "number" && path.length === 2 ? listAt(data, [list as string])[path[1]] : undefined;
  const name = isTable(table) && typeof table.name === "string" ? table.name : "";
  const alone = namesIn(listAt(data, [String(list)])).filter((each) => each === name).length === 1;
  const loads =
    name && alone && (list === "columns" || list === "supports")
      ? CALLERS.filter((each) => each.names === list).flatMap((caller) => callersOf(data, caller, name))
      : [];
  // from the last on, so that the positions of the others stay
  const edits: Edit[] = [...loads].sort((a, b) => b - a).map((n) => ({ op: "remove", path: ["loads", n] }));
  edits.push({ op: "remove", path });
  const also = loads.length === 0 ? "" : loads.length === 1 ? " and its load" : ` and its ${loads.length} loads`;
  return { edits, text: `remove ${title}${also}` };
}
