// The fields that several selected items have in common, edited all at once.

import { h, setRead } from "../../viewer/shared/dom";
import { say } from "../../viewer/shared/language";
import type { FormContext, Widget } from "../form/context";
import { nodeWidget } from "../form/section";
import { applyOptimistic } from "../model/changes/optimistic-edits";
import type { Change, Edit } from "../model/edits";
import { titleOfAll } from "../model/items";
import { type Json, type Path, pathKey, sameValue, startsWith, type Table, tableAt, valueAt } from "../model/paths";
import type { Field, Part, Schema } from "../model/schema";

const DIFFERENT = "different values";
const SINGLE: readonly Field["node"]["is"][] = ["quantity", "number", "integer", "choice", "boolean", "text"];

/** Return the fields for what all items at some paths have in common; names are each one's own. */
export function commonProperties(ctx: FormContext, paths: readonly Path[]): Widget {
  const first = paths[0]!;
  const fields = commonFields(ctx.schema, ctx.data(), paths);
  const shared: FormContext = {
    schema: ctx.schema,
    memory: ctx.memory,
    data: () => withCommonValues(ctx.data(), paths),
    issues: () => ctx.issues().filter((issue) => startsWith(issue.path, first)),
    change: (change) => ctx.change(repeatChange(ctx.data(), change, paths)),
  };
  const widgets = fields.map((field) => nodeWidget(shared, [...first, field.name], field));
  const body = h("div", { class: "fields" }, ...widgets.map((widget) => widget.element));
  const none = h("p", { class: "quiet" }, "They have no fields in common.");
  const element = h("div", { class: "part" }, widgets.length > 0 ? body : none);
  const update = () => {
    for (const widget of widgets) widget.update();
    for (const field of fields) markDifferent(element, ctx.data(), paths, field.name);
  };
  return { element, update, reveal: (path) => widgets.some((widget) => widget.reveal(path)) };
}

/** Return the fields of single values that all items have, with the same meaning. */
export function commonFields(schema: Schema, data: Table, paths: readonly Path[]): Field[] {
  const [first, ...others] = paths.map((path) => partAt(schema, data, path));
  if (!first || others.some((part) => part === null)) return [];
  const hasSame = (part: Part | null, field: Field) =>
    part?.fields.some(({ name, node }) => name === field.name && JSON.stringify(node) === JSON.stringify(field.node));
  return first.fields.filter(
    (field) =>
      field.name !== "name" && SINGLE.includes(field.node.is) && others.every((part) => hasSame(part, field) === true),
  );
}

function partAt(schema: Schema, data: Table, path: Path): Part | null {
  const found = schema.nodeAt(path, data);
  return found && schema.partOf(found.node, tableAt(data, path));
}

function differs(data: Table, paths: readonly Path[], key: string): boolean {
  const [first, ...others] = paths.map((path) => valueAt(data, [...path, key]));
  return others.some((value) => !sameValue(value, first));
}

/** Return data whose first item has only the values that all items share. */
function withCommonValues(data: Table, paths: readonly Path[]): Table {
  const first = paths[0]!;
  const common = Object.entries(tableAt(data, first)).filter(([key]) => !differs(data, paths, key));
  const value: Json = Object.fromEntries(common);
  return applyOptimistic(data, { op: "set", path: first, value });
}

/** Return a change of the first item made on all of them, one step of undo. */
export function repeatChange(data: Table, change: Change, paths: readonly Path[]): Change {
  const first = paths[0]!;
  const edits = change.edits.flatMap((edit): Edit[] => {
    if (edit.op === "text" || !startsWith(edit.path, first)) return [edit];
    return paths.map((path): Edit => ({ ...edit, path: [...path, ...edit.path.slice(first.length)] }));
  });
  const key = change.edits.flatMap((edit) => ("path" in edit ? edit.path.slice(first.length) : []))[0];
  return {
    ...change,
    edits,
    text: say("change {field} of {item}", {
      field: String(key ?? "").replaceAll("_", " "),
      item: titleOfAll(data, paths),
    }),
  };
}

/** Say in an empty field that its values differ. */
function markDifferent(element: HTMLElement, data: Table, paths: readonly Path[], key: string): void {
  const row = element.querySelector(`[data-path='${pathKey([...paths[0]!, key])}']`);
  const isDifferent = differs(data, paths, key);
  row?.classList.toggle("different", isDifferent);
  for (const input of row?.querySelectorAll("input") ?? []) {
    if (isDifferent) setRead(input, "placeholder", DIFFERENT);
  }
}
