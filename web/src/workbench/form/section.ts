// A table of the case file: its fields, and the choice of its kind.

import { starter } from "../model/defaults";
import { titleAt } from "../model/items";
import { type Path, pathKey, startsWith, tableAt, valueAt } from "../model/paths";
import type { Field, Node, Part } from "../model/schema";
import { placed, switchKind } from "../model/variants";
import { fill, h, newId } from "../shell/elements";
import type { FormContext, Widget } from "./context";
import { faultsOfPart, faultWords } from "./errors";
import { valueField } from "./inputs/value-field";
import { heading, labelOf } from "./labels";
import { listWidget } from "./lists/list";
import { plateOutline, plateShape, SHAPE_KEYS } from "./plate-shape";

/** Anything that a node can be: a value, a part, one of several kinds, a list. */
export function nodeWidget(ctx: FormContext, path: Path, field: Field): Widget {
  const { node } = field;
  if (node.is === "list") return listWidget(ctx, path, node.of, heading(labelOf(field) || field.name), field.hint);
  if (node.is === "part" || node.is === "kinds") return subPart(ctx, path, field, node);
  return valueField(ctx, path, field);
}

/** The fields of a part, one below the other; its kind, where it has several, on top. */
export function partWidget(ctx: FormContext, path: Path, node: Node, without: readonly string[] = []): Widget {
  const body = h("div", { class: "fields" });
  const messages = h("div", { class: "messages", id: newId("fault") });
  const kinds = node.is === "kinds" ? kindChoice(ctx, path, node.parts) : null;
  const element = h("div", { class: "part", "data-part": pathKey(path) }, kinds?.element, messages, body);
  let part: Part | null = null;
  let widgets: Widget[] = [];
  let built = false;

  const build = () => {
    built = true;
    const hidden: readonly string[] = part?.name === "Plate" ? [...without, ...SHAPE_KEYS] : without;
    const fields = part?.fields.filter((field) => field.node.is !== "tag" && !hidden.includes(field.name)) ?? [];
    // single values first: what is long stands below
    fields.sort((a, b) => Number(isLong(a)) - Number(isLong(b)));
    widgets = fields.map((field) => nodeWidget(ctx, [...path, field.name], field));
    if (part?.name === "Plate") {
      widgets.unshift(plateShape(ctx));
      widgets.splice(1 + fields.filter((field) => !isLong(field)).length, 0, plateOutline(ctx));
    }
    fill(body, ...widgets.map((widget) => widget.element));
  };
  const update = () => {
    const now = ctx.schema.partOf(node, tableAt(ctx.data(), path));
    if (!built || now !== part) {
      part = now;
      build();
    }
    kinds?.update();
    for (const widget of widgets) widget.update();
    const words = faultsOfPart(ctx.faults(), path, part)
      .filter((fault) => fault.path[path.length] !== "kind" || !kinds)
      .map(faultWords);
    if (messages.textContent !== words.join("")) fill(messages, ...words.map((each) => h("p", {}, each)));
  };
  const reveal = (target: Path) => {
    if (!startsWith(target, path)) return false;
    if (kinds?.reveal(target)) return true;
    if (widgets.some((widget) => widget.reveal(target))) return true;
    element.scrollIntoView({ block: "nearest" });
    element.querySelector<HTMLElement>("input, select, button")?.focus();
    return true;
  };
  return { element, update, reveal };
}

/** The choice between the kinds of a part. */
export function kindChoice(ctx: FormContext, path: Path, names: readonly string[]): Widget {
  const parts = names.map((name) => ctx.schema.part(name));
  const tagged = parts.some((part) => part.kind);
  const select = h("select", { id: newId("input") });
  const messages = h("div", { class: "messages", id: newId("fault") });
  const hint = h("span", { class: "hint" });
  select.setAttribute("aria-describedby", messages.id);
  const label = h("label", { class: "label needed", for: select.id }, tagged ? "kind" : "given by");
  const element = h(
    "div",
    { class: "field kind", "data-path": pathKey([...path, "kind"]) },
    label,
    select,
    hint,
    messages,
  );
  select.addEventListener("change", () => {
    const to = parts.find((part) => part.name === select.value);
    const from = ctx.schema.chosen(names, tableAt(ctx.data(), path));
    if (!to || to === from) return;
    const edits = switchKind(ctx.data(), path, from, to, ctx.memory);
    if (edits.length > 0) ctx.change({ edits, text: `change ${titleAt(ctx.data(), path)} to ${optionWords(to)}` });
  });
  const update = () => {
    const table = tableAt(ctx.data(), path);
    const chosen = ctx.schema.chosen(names, table);
    const odd = chosen ? [] : [h("option", { value: "" }, typeof table.kind === "string" ? table.kind : "choose …")];
    fill(select, ...odd, ...parts.map((part) => h("option", { value: part.name }, optionWords(part))));
    select.value = chosen?.name ?? "";
    hint.textContent = chosen ? aboutKind(chosen) : "";
    const faults = ctx.faults().filter((fault) => startsWith(fault.path, [...path, "kind"]));
    element.classList.toggle("faulty", faults.length > 0);
    fill(messages, ...faults.map((fault) => h("p", {}, faultWords(fault))));
  };
  const reveal = (target: Path) => {
    if (!startsWith(target, [...path, "kind"])) return false;
    element.scrollIntoView({ block: "nearest" });
    select.focus();
    return true;
  };
  return { element, update, reveal };
}

/** Whether a field takes a part of the form for itself. */
function isLong(field: Field): boolean {
  return ["list", "part", "kinds", "places"].includes(field.node.is);
}

/** What a kind is called in a choice. */
export function optionWords(part: Part): string {
  if (part.kind) return part.kind;
  return part.fields
    .filter((field) => field.needed)
    .map((field) => field.name)
    .join(", ");
}

function aboutKind(part: Part): string {
  return part.fields.find((field) => field.node.is === "tag")?.hint ?? part.about;
}

/** A part inside another one: there or not, if it may be left out and needs keys of its own; `bare` without its title. */
export function subPart(ctx: FormContext, path: Path, field: Field, node: Node, bare = false): Widget {
  const inner = partWidget(ctx, path, node);
  const first = node.is === "kinds" ? node.parts[0] : node.is === "part" ? node.part : undefined;
  const whole = first === undefined ? null : ctx.schema.part(first);
  const optional = !field.needed && (node.is === "kinds" || whole?.fields.some((each) => each.needed) === true);
  const add = h("button", { type: "button", class: "small" }, `Add ${labelOf(field) || field.name}`);
  const drop = h("button", { type: "button", class: "small quiet" }, "Remove");
  const title = h(
    "h4",
    { title: field.hint },
    heading(labelOf(field) || field.name),
    h("span", { class: "hint" }, field.hint),
  );
  const head =
    bare && !optional
      ? null
      : h(
          "div",
          { class: "sub-head" },
          bare ? h("span", { class: "hint" }, field.hint) : title,
          optional ? drop : null,
          optional ? add : null,
        );
  const element = h("div", { class: "sub-part" }, head, inner.element);
  const words = labelOf(field) || field.name;
  add.addEventListener("click", () => {
    if (!whole) return;
    const value = {
      ...(whole.kind ? { kind: whole.kind } : {}),
      ...starter(whole.name, ctx.data()),
      ...placed(ctx.data(), path, whole),
    };
    ctx.change({ edits: [{ op: "set", path, value }], text: `add ${words}` });
  });
  drop.addEventListener("click", () => ctx.change({ edits: [{ op: "remove", path }], text: `remove ${words}` }));
  const update = () => {
    const there = !optional || valueAt(ctx.data(), path) !== undefined;
    inner.element.hidden = !there;
    drop.hidden = !there;
    add.hidden = there;
    inner.update();
  };
  return { element, update, reveal: inner.reveal };
}
