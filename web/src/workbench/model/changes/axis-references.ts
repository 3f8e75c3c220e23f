// References to axes, such as B/3, that follow changes of the axes: renamed with them, and replaced by places where
// their axes are gone.
import { type Axis, attachedPlaces, axesIn, BETWEEN, isAttached } from "../axes";
import type { Change, Edit } from "../edits";
import { isTable, type Json, listAt, type Path, sameValue, type Table, tableAt } from "../paths";
import { detach, LISTS } from "./attachment";
import { joinEdits } from "./batches";
import { applyOptimistic } from "./optimistic-edits";
import { editsToTable } from "./transform";

/** Keys of axes that are sent when they are complete only: others refer to what they name. */
const NAMING = ["first", "names", "distances", "angles"];
const SAME = 1e-6; // m: places so near are one

/** Names of axes before, and what they are called after; null if they are gone. */
type Renames = Map<string, string | null>;

/** Whether a path is one that names axes, or says how many there are. */
export function namesAxes(path: Path): boolean {
  return path.length === 3 && path[0] === "axes" && NAMING.includes(String(path[2]));
}

/** Return a change with the edits that let what is attached to axes follow their names, and stay where axes are removed. */
export function followAxes(data: Table, change: Change): Change {
  let now = data;
  const edits = change.edits.flatMap((edit): Edit[] => {
    const before = now;
    now = applyOptimistic(now, edit);
    if (listAt(before, ["axes"]) === listAt(now, ["axes"])) return [edit];
    const others = referenceEdits(now, axesIn(before), renamesOf(before, now, edit));
    now = others.reduce(applyOptimistic, now);
    return [edit, ...others];
  });
  return edits.length > change.edits.length ? joinEdits(data, { ...change, edits }) : change;
}

/** Return what an edit makes of the names of axes, without those that stay. */
function renamesOf(before: Table, after: Table, edit: Edit): Renames {
  const [old, now] = [axesIn(before), axesIn(after)];
  const partners = partnersOf(listAt(before, ["axes"]), listAt(after, ["axes"]), "path" in edit ? edit.path : []);
  const renames: Renames = new Map();
  for (const [n, partner] of partners.entries()) {
    const [those, these] = [old.filter(isOf(n)), partner === null ? [] : now.filter(isOf(partner))];
    if (partner !== null && !isComplete(tableAt(after, ["axes", partner]), these)) continue; // the server says what is wrong with it
    for (const axis of those) {
      const name = partner === null ? null : nameAfter(axis, those, these);
      if (name !== axis.name) renames.set(axis.name, name);
    }
  }
  const count = (axes: readonly Axis[], name: string) => axes.filter((axis) => axis.name === name).length;
  // names of several axes do not say which one is meant: what is attached to one of them stays where it is
  const shared = old.filter(({ name }) => count(now, renames.get(name) ?? name) > 1);
  for (const { name } of shared) renames.set(name, null);
  return new Map([...renames].filter(([from]) => count(old, from) === 1));
}

function isOf(family: number): (axis: Axis) => boolean {
  return ({ path }) => path[1] === family;
}

/** Return the positions that families of axes have after an edit, null of those that it removes. */
function partnersOf(before: readonly Json[], after: readonly Json[], path: Path): (number | null)[] {
  if (before.length === after.length && path.length > 1) return before.map((_, n) => n);
  const same = before.map((family) => after.findIndex((each) => sameValue(each, family)));
  const left = after.map((_, n) => n).filter((n) => !same.includes(n));
  const isChanged = before.length === after.length;
  return same.map((n) => (n >= 0 ? n : isChanged ? (left.shift() ?? null) : null));
}

/** Whether all axes of a family could be read, each with a name that references can hold. */
function isComplete(family: Table, axes: readonly Axis[]): boolean {
  const isRead = family.kind !== "ray" || listAt(family, ["angles"]).every((angle) => typeof angle === "number");
  return axes.length > 0 && isRead && axes.every(({ name }) => name.trim() === name && !name.includes(BETWEEN));
}

/**
 * Return the name that an axis of a family has after it, null if it is gone.
 *
 * Of so many axes as before each stays what it is; of more or fewer those that lie where they did, else those that are
 * called as they were.
 */
function nameAfter(axis: Axis, before: readonly Axis[], after: readonly Axis[]): string | null {
  const named = (axes: readonly Axis[]) => axes.filter(({ name }) => name !== "").length;
  if (before.length === after.length && named(before) <= named(after)) return after[axis.position]!.name || null;
  const [few, many] = before.length < after.length ? [before, after] : [after, before];
  if (few.length < many.length && few.every((one) => many.some((other) => isSamePlace(one, other))))
    return after.find((other) => isSamePlace(axis, other))?.name || null;
  return after.some(({ name }) => name === axis.name) ? axis.name : null;
}

/** Whether two axes of a family lie at the same place. */
function isSamePlace(one: Axis, other: Axis): boolean {
  const [[x, y], [u, v]] = [one.place, other.place];
  const [[a, b], [c, d]] = [one.direction ?? [0, 0], other.direction ?? [0, 0]];
  return [x - u, y - v, a - c, b - d, one.radius - other.radius].every((by) => Math.abs(by) <= SAME);
}

/** Return the edits of what is attached to axes whose names change or that are gone, given the axes before. */
function referenceEdits(data: Table, before: readonly Axis[], renames: Renames): Edit[] {
  if (renames.size === 0) return [];
  return LISTS.flatMap((list) =>
    listAt(data, [list]).flatMap((table, n): Edit[] => {
      if (!isTable(table) || !isAttached(table)) return [];
      const texts = (Array.isArray(table.at) ? table.at : [table.at ?? ""]).map(String);
      const names = texts.flatMap((text) => text.split(BETWEEN).map((name) => name.trim()));
      if (!names.some((name) => renames.has(name))) return [];
      if (names.some((name) => renames.get(name) === null))
        return attachedPlaces(table, before) ? editsToTable([list, n], table, detach(table, before)) : [];
      const renamed = texts.map((text) => renameIn(text, renames));
      return [{ op: "set", path: [list, n, "at"], value: Array.isArray(table.at) ? renamed : renamed[0]! }];
    }),
  );
}

/** Return a crossing of axes with their new names. */
function renameIn(text: string, renames: Renames): string {
  const names = text.split(BETWEEN).map((name) => name.trim());
  return names.map((name) => renames.get(name) ?? name).join(BETWEEN);
}
