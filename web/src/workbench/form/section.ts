// A table of the case file: its fields, and the tables and lists in it.

import { button, fill, h, newId } from "../../viewer/shared/dom";
import { say } from "../../viewer/shared/language";
import { defaultPlacement } from "../model/changes/variants";
import { defaultsFor, hasDefaults } from "../model/defaults";
import { issuesOfPart } from "../model/issues";
import { type Path, pathKey, startsWith, tableAt, valueAt } from "../model/paths";
import { type Field, type Node, type Part, whyIdle } from "../model/schema";
import type { FormContext, Widget } from "./context";
import { showIssues } from "./errors";
import { valueField } from "./inputs/value-field";
import { kindChoice } from "./kind-choice";
import { heading, labelOf } from "./labels";
import { hasLayers, layersPicture } from "./layers-picture";
import { listWidget } from "./lists/list";
import { OUTLINE, plateOutline, plateShape, SHAPE_KEYS, SHAPES } from "./plate-shape";

/** Anything that a node can be: a value, a part, one of several kinds, a list. */
export function nodeWidget(ctx: FormContext, path: Path, field: Field, bare = false): Widget {
  const { node } = field;
  if (node.is === "part" || node.is === "kinds") return subPart(ctx, path, field, node, bare);
  if (node.is !== "list") return valueField(ctx, path, field);
  const makeItem = (item: Path) => partWidget(ctx, item, node.of);
  return listWidget(ctx, path, node.of, heading(labelOf(field) || field.name), field.hint, makeItem, bare);
}

/** The fields of a part, one below the other; its kind, where it has several, on top. */
export function partWidget(ctx: FormContext, path: Path, node: Node, without: readonly string[] = []): Widget {
  const body = h("div", { class: "fields" });
  const messages = h("div", { class: "messages", id: newId("issue") });
  const kinds = node.is === "kinds" ? kindChoice(ctx, path, node.parts) : null;
  const element = h("div", { class: "part", "data-part": pathKey(path) }, kinds?.element, messages, body);
  let part: Part | null | undefined;
  let widgets: Widget[] = [];
  const update = () => {
    const now = ctx.schema.partOf(node, tableAt(ctx.data(), path));
    if (now !== part) {
      part = now;
      widgets = fieldWidgets(ctx, path, part, without);
      fill(body, ...widgets.map((widget) => widget.element));
    }
    kinds?.update();
    for (const widget of widgets) widget.update();
    const issues = issuesOfPart(ctx.issues(), path, part);
    showIssues(messages, kinds ? issues.filter((issue) => issue.path[path.length] !== "kind") : issues, ctx.change);
  };
  const reveal = (target: Path) => {
    if (!startsWith(target, path)) return false;
    if (kinds?.reveal(target) || widgets.some((widget) => widget.reveal(target))) return true;
    element.scrollIntoView({ block: "nearest" });
    element.querySelector<HTMLElement>("input, select, button")?.focus();
    return true;
  };
  return { element, update, reveal };
}

/** Return the widgets of a part's fields: single values first, since what is long stands below. */
function fieldWidgets(ctx: FormContext, path: Path, part: Part | null, without: readonly string[]): Widget[] {
  const isPlate = part?.name === "Plate";
  const hidden: readonly string[] = isPlate ? [...without, ...SHAPE_KEYS] : without;
  const fields = part?.fields.filter((field) => field.node.is !== "tag" && !hidden.includes(field.name)) ?? [];
  const make = (field: Field) => whereItMatters(ctx, path, part, field);
  const short = fields.filter((field) => !isLong(field)).map(make);
  const long = fields.filter(isLong).map(make);
  if (hasLayers(part)) return [...short, layersPicture(ctx, path), ...long];
  if (!isPlate) return [...short, ...long];
  const outline = partWidget(ctx, OUTLINE, { is: "kinds", parts: SHAPES });
  return [plateShape(ctx), ...short, plateOutline(ctx, outline), ...long];
}

/** A field that is hidden where it means nothing, unless the file has it. */
function whereItMatters(ctx: FormContext, path: Path, part: Part | null, field: Field): Widget {
  const widget = nodeWidget(ctx, [...path, field.name], field);
  if (!part || Object.keys(field.onlyIf).length === 0) return widget;
  const update = () => {
    const table = tableAt(ctx.data(), path);
    widget.element.hidden = !(field.name in table) && whyIdle(part, field, table) !== "";
    widget.update();
  };
  return { ...widget, update };
}

/** Whether a field takes a part of the form for itself. */
function isLong(field: Field): boolean {
  return ["list", "part", "kinds", "points"].includes(field.node.is);
}

/** Whether a part does nothing unless it is there: one with values that are needed, or that people start from. */
export function doesNothingUnlessThere(part: Part): boolean {
  return part.fields.some((each) => each.needed) || hasDefaults(part.name);
}

/** A part inside another one, which can be added and removed if it is optional; `bare` without its title. */
function subPart(ctx: FormContext, path: Path, field: Field, node: Node, bare: boolean): Widget {
  const inner = partWidget(ctx, path, node);
  const first = node.is === "kinds" ? node.parts[0] : node.is === "part" ? node.part : undefined;
  const part = first === undefined ? null : ctx.schema.part(first);
  const optional = !field.needed && (node.is === "kinds" || (part !== null && doesNothingUnlessThere(part)));
  const name = labelOf(field) || field.name;
  const insert = () => {
    if (!part) return;
    const kind = part.kind ? { kind: part.kind } : {};
    const value = { ...kind, ...defaultsFor(part.name, ctx.data()), ...defaultPlacement(ctx.data(), path, part) };
    ctx.change({ edits: [{ op: "set", path, value }], text: say("add {item}", { item: name }) });
    inner.element.querySelector<HTMLElement>("input, select, button:not([hidden])")?.focus();
  };
  const remove = () => {
    ctx.change({ edits: [{ op: "remove", path }], text: say("remove {item}", { item: name }) });
    addButton.focus();
  };
  const addButton = button(say("Add {item}", { item: name }), "", insert, "small");
  const removeButton = button("Remove", "", remove, "small quiet");
  const hint = h("span", { class: "hint" }, field.hint);
  const title = bare ? hint : h("h4", { title: field.hint }, heading(name), hint);
  const buttons = optional ? [removeButton, addButton] : [];
  const head = bare && !optional ? null : h("div", { class: "sub-head" }, title, ...buttons);
  const element = h("div", { class: "sub-part" }, head, inner.element);
  const update = () => {
    const isShown = !optional || valueAt(ctx.data(), path) !== undefined;
    inner.element.hidden = removeButton.hidden = !isShown;
    addButton.hidden = isShown;
    inner.update();
  };
  return { element, update, reveal: inner.reveal };
}
