// Many edits of one list as a single one, which the server makes at once.

import type { Change, Edit } from "../edits";
import { listAt, type Path, pathKey, type Table } from "../paths";
import { applyOptimistic } from "./optimistic-edits";

const FEW = 3; // edits of a list that are left as they are

/**
 * Return a change whose many edits of a list are few: additions and changes of values are one edit, and so are removals
 * of items that follow one another, whose comments go with them.
 */
export function joinEdits(data: Table, change: Change): Change {
  const lists = new Map<string, Edit[]>();
  for (const edit of change.edits) {
    const key = pathKey(listOf(edit));
    lists.set(key, [...(lists.get(key) ?? []), edit]);
  }
  const edits = [...lists.values()].flatMap((group): Edit[] => {
    if (group.length <= FEW) return group;
    if (group.every(isRemoval)) return joinRemovals(data, group);
    if (!group.every(canJoin)) return group;
    const path = listOf(group[0]!);
    return [{ op: "set", path, value: listAt(group.reduce(applyOptimistic, data), path) }];
  });
  return edits.length < change.edits.length ? { ...change, edits } : change;
}

/** Return the path of the list that an edit is about; that of the edit itself if it is about none. */
function listOf(edit: Edit): Path {
  if (edit.op === "text" || edit.op === "add") return edit.op === "add" ? edit.path : [];
  const position = edit.path.findIndex((step) => typeof step === "number");
  return position < 0 ? edit.path : edit.path.slice(0, position);
}

/** Whether an edit leaves the other items of its list where they are, and the server does not round it. */
function canJoin(edit: Edit): boolean {
  if (edit.op === "add") return edit.at === undefined;
  const isInside = "path" in edit && edit.path.length > listOf(edit).length + 1;
  return (edit.op === "set" || edit.op === "remove") && isInside;
}

/** Whether an edit takes an item out of a list. */
function isRemoval(edit: Edit): boolean {
  return edit.op === "remove" && edit.path.length === listOf(edit).length + 1;
}

/** Return removals of one list, from the last item on, as one edit for each run of items. */
function joinRemovals(data: Table, group: readonly Edit[]): Edit[] {
  const list = listOf(group[0]!);
  const removed = new Set(group.map((edit) => ("path" in edit ? edit.path.at(-1) : -1)));
  let left = listAt(data, list);
  const edits: Edit[] = [];
  for (let last = left.length - 1; last >= 0; last -= 1) {
    if (!removed.has(last)) continue;
    let first = last;
    while (removed.has(first - 1)) first -= 1;
    left = left.toSpliced(first, last - first + 1);
    edits.push(left.length > 0 ? { op: "set", path: list, value: left } : { op: "remove", path: list });
    last = first;
  }
  return edits;
}
