// What the parts of a form share.

import { say } from "../../viewer/shared/language";
import { namesAxes } from "../model/changes/axis-references";
import { isReferenced, renameReferences } from "../model/changes/references";
import type { Memory } from "../model/changes/variants";
import type { Change, Edit } from "../model/edits";
import type { Issue } from "../model/issues";
import { titleAt } from "../model/items";
import { type Json, type Path, sameValue, type Table, valueAt } from "../model/paths";
import type { Schema } from "../model/schema";

export interface FormContext {
  readonly schema: Schema;
  readonly memory: Memory;
  data(): Table;
  issues(): readonly Issue[];
  change(change: Change): void;
  /** Tell the user something in a line. */
  notify?(text: string): void;
}

/** A part of a form: `update` shows the present data and issues, `reveal` opens and focuses the field of a path. */
export interface Widget {
  readonly element: HTMLElement;
  update(): void;
  reveal(path: Path): boolean;
}

/** Set one value, or take it away if it is undefined; `typing` joins it with what was typed into the same field before. */
export function setValue(ctx: FormContext, path: Path, value: Json | undefined, typing = false): void {
  const old = valueAt(ctx.data(), path);
  if (sameValue(value, old)) return;
  const own: Edit = value === undefined ? { op: "remove", path } : { op: "set", path, value };
  const others = typeof value === "string" ? renameReferences(ctx.data(), path, value) : [];
  const change: Change = { edits: [own, ...others], text: describeChange(ctx.data(), path) };
  ctx.change(typing ? { ...change, merge: true } : change);
}

/** Whether a field is sent only when its input is complete. */
export function isSentWhenComplete(path: Path): boolean {
  return isReferenced(path) || namesAxes(path);
}

/** What a change of a field is called in the list of edits: `change thickness of slab`. */
function describeChange(data: Table, path: Path): string {
  const key = path.findLast((step) => typeof step === "string") ?? "";
  const above = path.slice(0, path.lastIndexOf(key));
  if (above.length === 0) return say("change {field}", { field: String(key) });
  const field = String(key).replaceAll("_", " ");
  return say("change {field} of {item}", { field, item: titleAt(data, above) });
}
