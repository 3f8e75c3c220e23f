// Names that other parts of the file refer to: renamed and removed together with the references.

import { counted, say } from "../../../viewer/shared/language";
import type { Change, Edit } from "../edits";
import { titleOfAll } from "../items";
import { namesIn } from "../names";
import { isTable, type Json, listAt, type Path, samePath, type Table } from "../paths";

/** Which key of which list calls the names of a list. */
const REFERENCES: readonly { names: string; list: string; key: string }[] = [
  { names: "columns", list: "loads", key: "column" },
  { names: "walls", list: "loads", key: "wall" },
  { names: "cores", list: "loads", key: "core" },
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
  if (path[0] === "walls") {
    const renamed = (place: Path): Edit => ({ op: "set", path: place, value: to });
    edits.push(...placesInCores(data, from).map(renamed));
  }
  if (path[0] === "cases") {
    listAt(data, ["reactions", "cases"]).forEach((each, n) => {
      if (isTable(each) && each.case === from)
        edits.push({ op: "set", path: ["reactions", "cases", n, "case"], value: to });
    });
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

/** Return where cores name a wall. */
function placesInCores(data: Table, wall: string): Path[] {
  return listAt(data, ["cores"]).flatMap((core, n) =>
    listAt(isTable(core) ? core : {}, ["walls"]).flatMap((name, k): Path[] =>
      name === wall ? [["cores", n, "walls", k]] : [],
    ),
  );
}

/** Return the change that removes items and the loads on them. */
export function removeItems(data: Table, paths: readonly Path[]): Change {
  const loads = loadsUpon(data, paths).filter((n) => !paths.some((path) => samePath(path, ["loads", n])));
  const joints = jointsUpon(data, paths).filter((n) => !paths.some((path) => samePath(path, ["joints", n])));
  const places = [...loads.map((n): Path => ["loads", n]), ...joints.map((n): Path => ["joints", n])];
  const walls = listAt(data, ["walls"]).filter((_, n) => paths.some((path) => samePath(path, ["walls", n])));
  const removed: Path[] = [...paths, ...places, ...namesIn(walls).flatMap((name) => placesInCores(data, name))];
  // from the last on, so that the positions of the others stay
  const edits = removed.toSorted(byPositionBackwards).map((path): Edit => ({ op: "remove", path }));
  const their = paths.length === 1 ? "its" : "their";
  let items = titleOfAll(data, paths);
  const add = (count: number, one: string, many: string) => {
    if (count > 0) items = counted(count, one, many, { items, their });
  };
  add(loads.length, "{items} and {their} load", "{items} and {their} {count} loads");
  add(joints.length, "{items} and {their} joint", "{items} and {their} joints");
  return { edits, text: say("remove {item}", { item: items }) };
}

/** Return the change that removes an item and the loads on it. */
export function removeItem(data: Table, path: Path): Change {
  return removeItems(data, [path]);
}

/** Return the positions of the loads on items, unless others of the same name remain. */
function loadsUpon(data: Table, paths: readonly Path[]): number[] {
  const callers = REFERENCES.filter(({ names, list }) => list === "loads" && names !== "cases");
  return callers.flatMap((caller) => {
    const all = listAt(data, [caller.names]);
    const isRemoved = (n: number) => paths.some((path) => samePath(path, [caller.names, n]));
    const remaining = new Set(namesIn(all.filter((_, n) => !isRemoved(n))));
    const names = new Set(namesIn(all.filter((_, n) => isRemoved(n))));
    return [...names].filter((name) => !remaining.has(name)).flatMap((name) => referencesTo(data, caller, name));
  });
}

/** Return the positions of the joints of plates that are removed. */
function jointsUpon(data: Table, paths: readonly Path[]): number[] {
  const isRemoved = (n: number) => paths.some((path) => samePath(path, ["plates", n]));
  const names = new Set<Json>(namesIn(listAt(data, ["plates"]).filter((_, n) => isRemoved(n))));
  return listAt(data, ["joints"]).flatMap((joint, n) =>
    isTable(joint) && listAt(joint, ["between"]).some((name) => names.has(name)) ? [n] : [],
  );
}

/** Order paths by their lists, the larger positions first. */
function byPositionBackwards(a: Path, b: Path): number {
  for (let n = 0; n < Math.min(a.length, b.length); n += 1) {
    const [one, other] = [a[n]!, b[n]!];
    if (one === other) continue;
    if (typeof one === "number" && typeof other === "number") return other - one;
    return String(one) < String(other) ? -1 : 1;
  }
  return b.length - a.length;
}
