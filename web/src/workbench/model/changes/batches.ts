// Many edits of one list as a single one, which the server makes at once.
import { listAt, type Path, pathKey, type Table } from "../paths";
import type { Change, Edit } from "./edits";
import { applyOptimistic } from "./optimistic-edits";

const FEW = 3; // edits of a list that are left as they are

/** Return a change whose additions to a list and changes of values in it are one edit, if they are many. */
export function joinEdits(data: Table, change: Change): Change {
  const lists = new Map<string, Edit[]>();
  for (const edit of change.edits) {
    const key = pathKey(listOf(edit));
    lists.set(key, [...(lists.get(key) ?? []), edit]);
  }
  const edits = [...lists.values()].flatMap((group): Edit[] => {
    if (group.length <= FEW || !group.every(canJoin)) return group;
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
