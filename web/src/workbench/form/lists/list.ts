// A list of tables: as rows of a grid where its tables are flat, else as items that fold.

import { namesIn } from "../../client/store";
import { starter } from "../../model/defaults";
import { titleAt } from "../../model/items";
import { isTable, type Json, listAt, type Path, pathKey, startsWith, type Table, tableAt } from "../../model/paths";
import { removal } from "../../model/references";
import type { Node, Part } from "../../model/schema";
import { placed } from "../../model/variants";
import { freeName } from "../../plan/tools";
import { fill, h, icon } from "../../shell/elements";
import type { FormContext, Widget } from "../context";
import { faultsAt, faultsOfList, faultWords } from "../errors";
import { summaryOf } from "../labels";
import { kindChoice, optionWords, partWidget } from "../section";
import { gridRows } from "./table-rows";

const WIDEST = 7; // columns of a grid
const FLAT = new Set(["quantity", "number", "whole", "choice", "flag", "text", "tuple", "factors"]);

/** What shows the items of a list. */
export interface Rows {
  readonly element: HTMLElement;
  update(): void;
  reveal(target: Path): boolean;
}

/** A list with what adds, copies and removes its items; `bare` without its title. */
export function listWidget(ctx: FormContext, path: Path, of: Node, title: string, about: string, bare = false): Widget {
  const names = of.is === "kinds" ? of.parts : of.is === "part" ? [of.part] : [];
  const parts = names.map((name) => ctx.schema.part(name));
  const tagged = parts.some((part) => part.kind);
  const messages = h("div", { class: "messages" });
  const count = h("span", { class: "count" });
  const rows = h("div", {});
  const kind = tagged && parts.length > 1 ? h("select", { "aria-label": `kind of the new item of ${title}` }) : null;
  if (kind) fill(kind, ...parts.map((part) => h("option", { value: part.name }, optionWords(part))));
  // layers are all given by the same keys: one choice for the whole list
  const given = !tagged && parts.length > 1 ? listKind(ctx, path, names) : null;
  const add = h(
    "button",
    { type: "button", class: "small", onclick: () => insert() },
    `Add${kind ? "" : ` ${oneOf(title)}`}`,
  );
  const element = h(
    "div",
    { class: "list", "data-part": pathKey(path) },
    h(
      "div",
      { class: "sub-head" },
      bare
        ? h("span", { class: "hint" }, about)
        : h("h4", { title: about }, title, " ", count, h("span", { class: "hint" }, about)),
    ),
    given?.element,
    messages,
    rows,
    h("div", { class: "list-foot" }, kind, add),
  );
  let shown: Rows | null = null;
  let part: Part | null = null;

  const insert = () => {
    const chosen = kind ? parts.find((each) => each.name === kind.value) : (part ?? parts[0]);
    if (chosen)
      ctx.change({
        edits: [{ op: "add", path, value: newItem(ctx.data(), path, chosen) }],
        text: `add ${oneOf(title).toLowerCase()}`,
      });
  };
  const update = () => {
    const items = listAt(ctx.data(), path);
    const now = tagged ? null : ctx.schema.partOf(of, isTable(items[0]) ? items[0] : {});
    if (!shown || now !== part) {
      part = now;
      shown = part && isFlat(part) ? gridRows(ctx, path, part) : foldedRows(ctx, path, of);
      fill(rows, shown.element);
    }
    count.textContent = items.length > 0 ? String(items.length) : "";
    given?.update();
    shown.update();
    const words = faultsOfList(ctx.faults(), path).map(faultWords);
    fill(messages, ...words.map((each) => h("p", {}, each)));
  };
  const reveal = (target: Path) => {
    if (!startsWith(target, path)) return false;
    if (!shown?.reveal(target)) add.focus();
    return true;
  };
  return { element, update, reveal };
}

/** One item's name, from the list's: `Columns` to `column`. */
function oneOf(title: string): string {
  const lower = title.charAt(0).toLowerCase() + title.slice(1);
  return lower.endsWith("s") ? lower.slice(0, -1) : lower;
}

function isFlat(part: Part): boolean {
  return part.fields.length <= WIDEST && part.fields.every((field) => FLAT.has(field.node.is));
}

/** What a new item starts with. */
function newItem(data: Table, path: Path, part: Part): Table {
  const value: Table = {
    ...(part.kind ? { kind: part.kind } : {}),
    ...starter(part.name, data),
    ...placed(data, [...path, 0], part),
  };
  const named = part.fields.find((field) => field.name === "name");
  if (named?.needed || part.name.endsWith("Support") || part.name === "Borehole") {
    const stem =
      part.name === "Column" ? "C1" : part.name === "Borehole" ? "B1" : `${String(path.at(-1)).replace(/s$/, "")} 1`;
    return { name: freeName(namesIn(listAt(data, path)), stem), ...value };
  }
  return value;
}

/** The choice of the keys by which all items of a list are given. */
function listKind(ctx: FormContext, path: Path, names: readonly string[]): Widget {
  const first = kindChoice(ctx, [...path, 0], names);
  const select = first.element.querySelector("select");
  select?.addEventListener(
    "change",
    (event) => {
      event.stopImmediatePropagation();
      const to = ctx.schema.part(select.value);
      const key = pathKey([...path, to.name]);
      const old = listAt(ctx.data(), path);
      const from = ctx.schema.chosen(names, isTable(old[0]) ? old[0] : {});
      if (from) ctx.memory.set(pathKey([...path, from.name]), { items: old });
      const known = ctx.memory.get(key)?.items;
      const value: Json =
        Array.isArray(known) && known.length === old.length ? known : old.map(() => starter(to.name, ctx.data()));
      ctx.change({ edits: [{ op: "set", path, value }], text: `give layers by ${optionWords(to)}` });
    },
    { capture: true },
  );
  return first;
}

/** Items that fold, each with its summary, a copy and a remove button. */
function foldedRows(ctx: FormContext, path: Path, of: Node): Rows {
  const element = h("div", { class: "items" });
  const items: { element: HTMLDetailsElement; update(): void; reveal(target: Path): boolean }[] = [];
  const update = () => {
    const count = listAt(ctx.data(), path).length;
    while (items.length > count) items.pop()?.element.remove();
    while (items.length < count) {
      const item = foldedItem(ctx, [...path, items.length], of);
      items.push(item);
      element.append(item.element);
    }
    for (const item of items) item.update();
  };
  const reveal = (target: Path) => {
    const n = target[path.length];
    const item = typeof n === "number" ? items[n] : undefined;
    return item?.reveal(target) ?? false;
  };
  return { element, update, reveal };
}

function foldedItem(
  ctx: FormContext,
  path: Path,
  of: Node,
): { element: HTMLDetailsElement; update(): void; reveal(target: Path): boolean } {
  const title = h("span", { class: "item-title" });
  const marks = h("span", { class: "badge" });
  const summary = h("summary", {}, title, marks, ...itemButtons(ctx, path));
  const element = h("details", { class: "item", "data-item": pathKey(path) }, summary);
  let body: Widget | null = null;
  const open = () => {
    if (!element.open || body) return;
    body = partWidget(ctx, path, of);
    element.append(body.element);
    body.update();
  };
  element.addEventListener("toggle", open);
  const update = () => {
    const table = tableAt(ctx.data(), path);
    title.textContent = summaryOf(table, ctx.schema.partOf(of, table)) || titleAt(ctx.data(), path);
    const faults = faultsAt(ctx.faults(), path).length;
    marks.textContent = faults > 0 ? String(faults) : "";
    marks.title = faults > 0 ? `${faults} faults` : "";
    body?.update();
  };
  const reveal = (target: Path) => {
    element.open = true;
    open();
    return body?.reveal(target) ?? false;
  };
  return { element, update, reveal };
}

/** The buttons that copy and remove an item. */
export function itemButtons(ctx: FormContext, path: Path): HTMLElement[] {
  const act = (run: () => void) => (event: MouseEvent) => {
    event.preventDefault();
    event.stopPropagation();
    run();
  };
  const position = Number(path.at(-1));
  const copy = act(() => {
    const list = path.slice(0, -1);
    const value = structuredClone(tableAt(ctx.data(), path));
    if (typeof value.name === "string" && value.name)
      value.name = freeName(namesIn(listAt(ctx.data(), list)), value.name);
    ctx.change({
      edits: [{ op: "add", path: list, value, at: position + 1 }],
      text: `duplicate ${titleAt(ctx.data(), path)}`,
    });
  });
  const remove = act(() => ctx.change(removal(ctx.data(), path)));
  return [
    h(
      "button",
      {
        type: "button",
        class: "icon",
        title: "duplicate",
        "aria-label": `duplicate item ${position + 1}`,
        onclick: copy,
      },
      icon("copy"),
    ),
    h(
      "button",
      { type: "button", class: "icon", title: "remove", "aria-label": `remove item ${position + 1}`, onclick: remove },
      icon("remove"),
    ),
  ];
}
